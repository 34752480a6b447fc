/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Templates of a user's: they change words, style and stylesheets, and nothing else. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

/* A report, and a folder of templates in which SED changes FILE. */
#define CHANGED(FILE, SED)                                                                                   \
    "$W analyze oak --model culm --wind 10 --samples 0 --no-pdf -q -o $T/out >/dev/null 2>&1; "              \
    "cp $T/out/report.html $T/before.html; $W init template t -o $T/t >/dev/null; sed -i '" SED              \
    "' $T/t/" FILE "; "
#define DRAW "$W report $T/out --no-pdf -q --template $T/t; "
#define KEPT "cmp $T/before.html $T/out/report.html && echo kept"
/* in the head of the report, where a stylesheet's own words can stand */
#define IN_HEAD(X) "s|<body lang=|" X "<body lang=|"

static void what_is_changed_is_on_the_page(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { CHANGED("strings.xml", "s|<en>Summary in words</en>|<en>In short</en>|") DRAW
          "grep -c 'In short' $T/out/report.html; grep -c 'Summary in words' $T/before.html "
          "$T/out/report.html",
          CODE_OK,
          { "1\n", "before.html:1", "report.html:0" } },
        { CHANGED("report.css", "1a h1 { color: #123456 }") DRAW "grep -c '#123456' $T/out/report.html",
          CODE_OK,
          { "1\n" } },
        { CHANGED("report.css",
                  "1a /* */") "sed -i 's|<xsl:call-template name=\"title-block\"/>|<img alt=\"\" "
                              "src=\"mark.png\"/>&|' $T/t/report.xsl; "
                              "cp tests/data/job/logo.png $T/t/mark.png; " DRAW
                              "grep -c '<img alt=\"\" src=\"data:image/jpeg;base64,' $T/out/report.html",
          CODE_OK,
          { "1\n" } },
        { CHANGED("report.css", "1a /* */") DRAW
          "grep -o 'Content-Security-Policy\" content=\"[^\"]*' $T/out/report.html; "
          "$W init template t -o $T/t",
          CODE_INPUT,
          { "default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src 'sha256-",
            "is there already" } },
    };
    CHECK(rows);
}

/* One line with file and line, and the page that was there stays. */
static void a_broken_template_is_placed(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { CHANGED("report.xsl", "20s|^|<xsl:if>|") DRAW KEPT, CODE_OK, { "/t/report.xsl:", "kept" } },
        { CHANGED("words.xsl",
                  "30s|^|<xsl:nothing/>|") "$W report $T/out --no-pdf -q --template $T/t 2>&1 | wc -l; " DRAW
              KEPT,
          CODE_OK,
          { "1\n", "/t/words.xsl:3", "kept" } },
        { CHANGED("report.xsl", IN_HEAD("<xsl:call-template name=\"none\"/>")) DRAW KEPT,
          CODE_OK,
          { "/t/report.xsl:", "none", "kept" } },
        { CHANGED("report.xsl", IN_HEAD("<xsl:value-of select=\"][\"/>")) DRAW KEPT,
          CODE_OK,
          { "/t/report.xsl:", "kept" } },
        { CHANGED("strings.xml", "/id=\"h.summary\"/d") DRAW KEPT,
          CODE_OK,
          { "strings.xml", "h.summary", "kept" } },
        { CHANGED("page.xsl", "1d") "rm $T/t/page.xsl; " DRAW KEPT,
          CODE_OK,
          { "/t/page.xsl: No such file", "init template", "kept" } },
        { "$W report $T --template $T/none", CODE_INPUT, { "--template: ", "/none: No such file" } },
        { "$W analyze oak --model culm --wind 10 -o $T/new --template $T/none; ls $T",
          CODE_OK,
          { "/none: No such file" } },
    };
    CHECK(rows);
}

/* Nothing outside the folder is read or written, nothing is fetched or run. */
static void stylesheets_are_held(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { CHANGED("report.xsl", IN_HEAD("<xsl:copy-of select=\"document(&quot;/etc/passwd&quot;)\"/>"))
              DRAW KEPT "; grep -c root: $T/out/report.html",
          CODE_RUN,
          { "/t/report.xsl", "kept", "0\n" } },
        { CHANGED("report.xsl",
                  IN_HEAD("<xsl:value-of select=\"document(&quot;../out/results.json&quot;)\"/>")) DRAW KEPT,
          CODE_OK,
          { "kept" } },
        { CHANGED("report.xsl",
                  IN_HEAD("<xsl:value-of select=\"document(&quot;http://127.0.0.1:9/x&quot;)\"/>")) DRAW KEPT,
          CODE_OK,
          { "kept" } },
        { CHANGED("report.xsl", "s|href=\"page.xsl\"|href=\"../../../../../etc/page.xsl\"|") DRAW KEPT,
          CODE_OK,
          { "/t/report.xsl", "kept" } },
        { CHANGED("report.xsl", IN_HEAD("<exsl:document xmlns:exsl=\"http://exslt.org/common\" "
                                        "href=\"made.txt\">x</exsl:document>")) DRAW
          "ls $T/t/made.txt made.txt",
          CODE_INPUT,
          { "t/made.txt': No such file", "'made.txt': No such file" } },
        { CHANGED("report.xsl", "s|version=\"1.0\"|version=\"1.0\" xmlns:exsl=\"http://exslt.org/common\" "
                                "extension-element-prefixes=\"exsl\"|; " IN_HEAD(
                                    "<exsl:document href=\"made.txt\" method=\"text\">x</exsl:document>"))
              DRAW KEPT "; ls $T/t/made.txt made.txt $T/out/made.txt",
          CODE_INPUT,
          { "kept", "No such file" } },
        { CHANGED("report.xsl",
                  "s|version=\"1.0\"|version=\"1.0\" xmlns:php=\"http://php.net/xsl\" "
                  "xmlns:s=\"http://icl.com/saxon\"|; " IN_HEAD(
                      "<xsl:value-of select=\"php:function(&quot;system&quot;, &quot;id&quot;)\"/>"))
              DRAW KEPT,
          CODE_OK,
          { "/t/report.xsl", "kept" } },
        { CHANGED("words.xsl",
                  "1a <!DOCTYPE x [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"\\&a;\\&a;\\&a;\\&a;\\&a;\">]>")
              DRAW KEPT,
          CODE_OK,
          { "/t/words.xsl:2: a template has no DOCTYPE", "kept" } },
        { CHANGED("strings.xml", "1a <!DOCTYPE x SYSTEM \"file:///etc/passwd\">") DRAW KEPT,
          CODE_OK,
          { "/t/strings.xml:2: a template has no DOCTYPE", "kept" } },
        { CHANGED("report.css", "1d") "ln -sf /etc/passwd $T/t/report.css; " DRAW KEPT,
          CODE_OK,
          { "must be a file, and no link", "kept" } },
        { CHANGED("report.xsl",
                  IN_HEAD("<xsl:call-template name=\"on\"/>") "; s|^</xsl:stylesheet>|<xsl:template "
                                                              "name=\"on\"><xsl:call-template "
                                                              "name=\"on\"/></xsl:template>&|") DRAW KEPT,
          CODE_OK,
          { "/t/report.xsl", "kept" } },
        { CHANGED(
              "report.xsl",
              IN_HEAD(
                  "<xsl:for-each select=\"//node()\"><xsl:for-each select=\"//node()\"><xsl:for-each "
                  "select=\"//node()\">x</xsl:for-each></xsl:for-each></xsl:for-each>")) "timeout 100 " DRAW
              KEPT,
          CODE_OK,
          { "/t/report.xsl", "kept" } },
        { CHANGED("report.css",
                  "1d") "cp -r $T/t $T/out/t; $W report $T/out --no-pdf -q --template $T/out/t; " KEPT,
          CODE_OK,
          { "is a results folder, or within one", "kept" } },
    };
    CHECK(rows);
}

#define NOT_THERE "grep -c -i -e evil $T/out/report.html"
static void pages_hold_no_programs(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { CHANGED("report.xsl", IN_HEAD("<script>evil</script><SCRIPT>evil</SCRIPT><iframe "
                                        "src=\"evil\"/><base href=\"https://evil\"/><link href=\"evil\"/>"))
              DRAW NOT_THERE,
          CODE_RUN,
          { "0\n" } },
        { CHANGED(
              "report.xsl",
              IN_HEAD(
                  "<meta http-equiv=\"refresh\" content=\"0;url=evil\"/><xsl:comment>evil</xsl:comment><a "
                  "href=\"javascript:evil\">a</a><p onclick=\"evil\" ONLOAD=\"evil\">p</p>")) DRAW NOT_THERE,
          CODE_RUN,
          { "0\n" } },
        { CHANGED(
              "report.xsl",
              IN_HEAD("<xsl:text disable-output-escaping=\"yes\">\\&lt;script>evil\\&lt;/script></xsl:text>"))
              DRAW
          "grep -c '<script>evil' $T/out/report.html; grep -c '&lt;script&gt;evil' $T/out/report.html",
          CODE_OK,
          { "0\n1\n" } },
        { CHANGED("report.css", "1a </style><script>evil</script>") DRAW KEPT,
          CODE_OK,
          { "report.css", "not allowed in a style", "kept" } },
        { CHANGED("page.xsl", "s|about:legacy-compat|x\\&gt;\\&lt;script\\&gt;evil\\&lt;/script\\&gt;|")
              DRAW NOT_THERE,
          CODE_RUN,
          { "0\n" } },
        { CHANGED("report.xsl", IN_HEAD("<img src=\"../out/plots/x.png\"/>")) DRAW KEPT,
          CODE_OK,
          { "must be a file of that folder", "kept" } },
        { CHANGED("report.xsl", IN_HEAD("<img src=\"strings.xml\"/>")) DRAW KEPT,
          CODE_OK,
          { "/t/strings.xml", "kept" } },
        { CHANGED("report.xsl", "s|<meta http-equiv=\"Content-Security-Policy\"|<meta name=\"none\"|") DRAW
          "grep -c \"http-equiv=.Content-Security-Policy. content=.default-src 'none'\" $T/out/report.html",
          CODE_OK,
          { "1\n" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(what_is_changed_is_on_the_page),
        cmocka_unit_test(a_broken_template_is_placed),
        cmocka_unit_test(stylesheets_are_held),
        cmocka_unit_test(pages_hold_no_programs),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
