/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The picture of a report's page that answers: its data are text, its script is the one the page allows, and
 * in a browser its numbers are those of the tables. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

/* A species table whose name would run as a script, and its page. */
#define HOSTILE                                                                                              \
    "mkdir -p $T; awk '/^name:/ { print \"name: \\\"</script><script>document.title=\\x27x\\x27//\\\"\"; "   \
    "next } { "                                                                                              \
    "print }' species/oak.yaml >$T/oak.yaml; $W compare $T/oak.yaml beech --model culm --wind 5,10,30 "      \
    "--samples "                                                                                             \
    "0 --no-pdf -q -o $T/out 2>$T/said; "

static void data_are_text(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { HOSTILE
          "cat reports/picture.js reports/live.js | grep -c -e 'innerHTML' -e 'document.write' -e 'eval('; "
          "grep -o '<script[^>]*>' "
          "$T/out/report.html; grep -o '<option value=.0.>[^/]*/script[^/]*//</option>' $T/out/report.html",
          CODE_OK,
          { "0\n<script type=\"application/json\" id=\"live-data\">\n<script>\n",
            "<option value=\"0\">&lt;/script&gt;&lt;script&gt;document.title='x'//</option>" } },
        { HOSTILE "python3 - $T/out/report.html <<'END'\n"
                  "import base64, hashlib, re, sys\n"
                  "page = open(sys.argv[1], encoding='utf-8').read()\n"
                  "script = re.search(r'<script>(.*?)</script>', page, re.S).group(1)\n"
                  "name = base64.b64encode(hashlib.sha256(script.encode()).digest()).decode()\n"
                  "print(\"default-src 'none'; style-src 'unsafe-inline'; img-src data:; script-src "
                  "'sha256-\" + name + "
                  "\"'\" in page)\n"
                  "END\n",
          CODE_OK,
          { "True" } },
        { "cat reports/picture.js reports/frames.js | grep -c -e 'innerHTML' -e 'document.write' -e 'eval('; "
          "$W series oak --model "
          "culm --wind 8 "
          "--duration 2 --step 0.5 --gust cosine --keys 3 --no-vtk --no-pdf -q -o $T/out 2>$T/said; grep -o "
          "'<script[^>]*>' $T/out/series.html; grep -o \"script-src 'sha256-\" $T/out/series.html",
          CODE_OK,
          { "0\n<script type=\"application/json\" id=\"live-data\">\n<script>\n", "script-src 'sha256-" } },
        { "cat reports/rain.js | grep -c -e 'innerHTML' -e 'document.write' -e 'eval('; $W rain --staged "
          "--duration 2 --no-pdf -q -o "
          "$T/out 2>$T/said; grep -o '<script[^>]*>' $T/out/rain.html; grep -o \"script-src 'sha256-\" "
          "$T/out/rain.html",
          CODE_OK,
          { "0\n<script type=\"application/json\" id=\"live-data\">\n<script>\n", "script-src 'sha256-" } },
    };
    CHECK(rows);
}

#define HEADS                                                                                                \
    "http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; style-src 'unsafe-inline'; "       \
    "img-src data:"

/* Every kind of page says that it fetches nothing and runs nothing, and fits a telephone. */
static void every_page_is_closed(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W series oak --model culm --wind 8 --no-vtk --no-pdf -q -o $T/out >$T/said 2>&1; grep -c -e "
          "'<script' "
          "-e script-src -e 'id=\"live\"' $T/out/series.html",
          CODE_RUN,
          { "0\n" } },
        { "$W modes oak --model culm --wind 0,10 --no-pdf -q -o $T/out >/dev/null 2>&1; head -c 800 "
          "$T/out/modes.html; echo; grep -c '<script' "
          "$T/out/modes.html",
          CODE_RUN,
          { HEADS, "name=\"viewport\" content=\"width=device-width", "\n0\n" } },
        { "test -z \"$(for p in reports/*.xsl; do grep -q '<html lang' $p && grep -L 'call-template "
          "name=.policy.' "
          "$p; done)\" && echo all",
          CODE_OK,
          { "all\n" } },
    };
    CHECK(rows);
}

/* Nothing of it is printed. */
static void nothing_is_printed(void **state)
{
    (void)state;
    if (shell("command -v weasyprint && command -v pdftotext && command -v gnuplot")) skip();
    static const struct row rows[] = {
        { "$W analyze oak --model culm --wind 10 --samples 0 -q -o $T/out 2>$T/said; pdftotext "
          "$T/out/report.pdf - | grep -c "
          "-e slider -e 'arrow keys' -e 'winds that were computed'",
          CODE_RUN,
          { "0\n" } },
    };
    CHECK(rows);
}

static void in_a_browser(void **state)
{
    (void)state;
    if (shell("command -v chromium")) {
        print_message("no chromium (Debian package chromium): the page was not tried in a browser\n");
        skip();
    }
    static const struct row rows[] = {
        { "$W compare oak beech --model oak_20m --soil mineral --wind 15,25,35 --samples 0 --no-pdf -q -o "
          "$T/out "
          "2>$T/said; timeout 120 python3 tests/live.py $T/out chromium",
          CODE_OK,
          { "live: 42 numbers" } },
        { "$W analyze scots_pine --model scots_pine --soil mineral --wind 8,16 --directions 8 --samples 0 "
          "--no-pdf -q -o $T/out "
          "2>$T/said; timeout 120 python3 tests/live.py $T/out chromium",
          CODE_OK,
          { "live: 47 numbers" } },
        { HOSTILE "timeout 120 python3 tests/live.py $T/out chromium", CODE_OK, { "live: 42 numbers" } },
        { "$W series oak --model culm --wind 40 --duration 3 --step 0.5 --gust cosine --keys 3 --no-vtk "
          "--no-pdf -q "
          "-o $T/out 2>$T/said; timeout 120 python3 tests/live.py $T/out chromium",
          CODE_OK,
          { "live: 15 numbers" } },
        { "$W rain --staged --duration 2 --no-pdf -q -o $T/out 2>$T/said; timeout 120 python3 tests/live.py "
          "$T/out chromium",
          CODE_OK,
          { "live: 56 numbers" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(data_are_text),
        cmocka_unit_test(every_page_is_closed),
        cmocka_unit_test(nothing_is_printed),
        cmocka_unit_test(in_a_browser),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
