/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Every page of every command exists in both languages, whole and with all its words. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "shell.h"

static const struct {
    const char *page, *command; /* -o is added */
} pages[] = {
    { "report", "compare oak moso_bamboo $M --wind 10,20 --directions 8" },
    { "calibration", "fit $S --no-profile --no-rival" },
    { "series", "series oak $M --wind 8 --duration 2 --step 0.5 --gust cosine --no-vtk --explain --keys 2" },
    { "explain", "explain oak $M --wind 8" },
    { "wind", "wind kaimal --duration 60 --points 3 --components 3" },
    { "rose", "wind rose --file $T/r.csv" },
    { "shelter", "shelter --model scots_pine --species scots_pine --slabs 4 --cells 16" },
    { "terrain", "terrain --size 4 --relief 20" },
    { "rain", "rain --staged --duration 2" },
    { "modes", "modes oak $M --wind 0,10" },
    { "fragility", "fragility oak $M --samples 20" },
};
/* A culm that splits long before it breaks: wherever a wind of breakage stands, so does the wind of
 * splitting. */
static void what_governs_is_said(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W compare moso_bamboo weeping_willow --model moso_culm --wind 10,25 --directions 8 --samples 0 "
          "--lang en "
          "--no-pdf -o $T/a -q; sed 's/<tr/\\n<tr/g; s/<[^>]*>/ /g' $T/a/report.html | tr -s ' ' | grep -A5 "
          "'Fails at' | tail -n 5",
          CODE_OK,
          { " Moso bamboo Bending (breakage) breaks ", " Splitting of the wall governs: splits ",
            " Ovalisation of the wall flattens ", " Overturning not assessed: " } },
        { "$W compare moso_bamboo weeping_willow --model moso_culm --wind 10,25 --directions 8 --samples 0 "
          "--lang zh "
          "--no-pdf -o $T/a -q; sed 's/<[^>]*>/ /g' $T/a/report.html | tr -s ' ' | grep -c '壁面劈裂 "
          "控制判据：劈裂'",
          CODE_OK,
          { "1" } },
        { "$W compare moso_bamboo weeping_willow --model moso_culm --wind 10,25 --directions 8 --samples 0 "
          "--no-report -o $T/a -q; for t in summary directions; do grep -cE 'found,splitting(,|$)' "
          "$T/a/tables/$t.csv; grep -cE "
          "'found,breakage(,|$)' $T/a/tables/$t.csv; done; $W compare moso_bamboo weeping_willow --model "
          "moso_culm --wind 10,25 "
          "--directions 8 --samples 0 --no-report -o $T/a | grep -E '(governs|splitting|breakage) *$|  "
          "splitting  ' | tr -s ' '",
          CODE_OK,
          { "2\n2\n16\n16\n", " splitting 0.74 1 ", " governs" } },
        /* a tree whose branches stand above its stem and break before it: each figure says whose it is */
        { "for l in en zh; do $W analyze oak --model broadleaf --wind 10,20 --samples 0 --no-pdf --lang $l "
          "-o $T/a -q; "
          "sed 's/<[^>]*>/ /g; s/&nbsp;/ /g' $T/a/report.html | tr -s '\\n ' ' ' | grep -oE 'the top of its "
          "stem moves|"
          "Height 11.5 m; of the model.s stem 10 m|Bending \\(breakage\\) [0-9.]+ 1.0 .{0,8}60 |树高 11.5 "
          "m；模型主干长 10 m' "
          "| sort -u; done",
          CODE_OK,
          { "Bending (breakage) 5.59 1.0 ", "Height 11.5 m; of", "the top of its stem moves\n",
            "树高 11.5 m；模型主干长 10 m\n" } },
        { "for l in en zh; do $W analyze moso_bamboo --model moso_culm --wind 10,25 --corridor 8m "
          "--tip-angle-limit 45 "
          "--samples 0 --no-pdf --lang $l -o $T/a -q; sed 's/<tr/\\n<tr/g; s/<[^>]*>/ /g' $T/a/report.html | "
          "tr -s ' ' | "
          "grep -E 'Corridor beside the tree, 8 m|树旁走廊，8 m|Turn of the tip, 45|梢端转角，45'; done",
          CODE_OK,
          { "Corridor beside the tree, 8 m a part reaches it; the tree is not lost", "9.7 14.8 14.0",
            "Turn of the tip, 45° the tip turns by it",
            "梢端转角，45° 梢端达到该转角；不计为树木损毁 5.1 7.77" } },
        { "$W analyze oak $M --wind 10 --corridor 0m --tip-angle-limit 200deg --samples 0 --no-report -o "
          "$T/a",
          CODE_INPUT,
          { "--corridor: 0m is outside 0.01..200 m", "--tip-angle-limit: 200deg is outside 0.1..179 deg" } },
        { "$W analyze oak $M --wind 10 --corridor-towards 90 --samples 0 --no-report -o $T/a",
          CODE_INPUT,
          { "--corridor-towards: has no effect without --corridor" } },
        { "$W analyze moso_bamboo --model moso_culm --wind 10 --node-spacing 15cm --samples 0 --no-pdf -o "
          "$T/a; "
          "grep -o 'Diaphragms [a-z0-9 ]*' $T/a/report.html; $W analyze moso_bamboo --model moso_culm --wind "
          "10 "
          "--samples 0 --no-pdf --lang zh -o $T/a -q; grep -o '未计竹隔' $T/a/report.html",
          CODE_OK,
          { "it breaks in bending first", "diaphragms, 0.15 m apart, are counted by judgement",
            "Diaphragms at nodes 15 cm apart are counted", "未计竹隔" } },
        { "$W analyze oak $M --wind 10 --node-spacing 20cm --samples 0 --no-report -o $T/a",
          CODE_INPUT,
          { "--node-spacing 0.2 m: diaphragms are of culms; the stem of Oak is solid" } },
        { "$W analyze moso_bamboo --model moso_culm --wind 10 --node-spacing 0cm --samples 0 --no-report -o "
          "$T/a",
          CODE_INPUT,
          { "--node-spacing: 0cm is outside 1..500 cm" } },
        { "for m in moso_branched broadleaf; do $W analyze oak --model $m --wind 10 --samples 0 --no-report "
          "-o $T/a "
          "2>&1 | grep -c 'twig-leaves.*2.1 m2 on each cm2'; done; true",
          CODE_OK,
          { "1\n0\n" } },
        /* a given wind in which the tree holds without snow, or fails without wind, is no bound of the other
           tree */
        { "for u in 54.5 0,54.5; do $W analyze oak --model oak_20m --wind $u --ice 30mm --samples 0 "
          "--no-report -o $T/a "
          "2>&1 | grep -c 'lost at 55.21 m/s -> 53.99 m/s'; done; $W analyze silver_maple --model broadleaf "
          "--wind 0,20 "
          "--snow 10cm --samples 0 --no-report -o $T/a 2>&1 | grep -c 'lost at 32.[0-9]* m/s -> '; $W analyze "
          "weeping_willow --model weeping_willow_tree --wind 5 --frontal-area 60 --samples 0 --no-report -o "
          "$T/a 2>&1 | "
          "grep -c few-leaves; true",
          CODE_OK,
          { "1\n1\n1\n0\n" } },
        { "for a in '30 m2' '100 m2'; do $W analyze weeping_willow --model weeping_willow_tree --wind 5 "
          "--leaf-area "
          "\"$a\" --samples 0 --no-report -o $T/a 2>&1 | grep -c 'few-leaves.*30 m2 of leaves in a crown "
          "over 67'; "
          "done; $W analyze weeping_willow --model culm --wind 4,5 --samples 0 -o $T/a >$T/said 2>&1; "
          "grep -c "
          "'beyond-elastic.*at 5 m/s.*reaches at 4.13 m/s' $T/said; grep -c 'stem’s wood yields there' "
          "$T/a/report.html; true",
          CODE_OK,
          { "1\n0\n1\n2\n" } },
        { "printf 'phi_deg,moment_kNm\\n0,0\\n1,40\\n2,%s\\n3,60\\n4,50\\n' 37 >$T/a.csv; sed 's/37/35/' "
          "$T/a.csv "
          ">$T/b.csv; for f in a b; do $W analyze oak $M --wind 10 --tipping-curve $T/$f.csv --samples 0 "
          "--no-report "
          "-o $T/a 2>&1 | grep -c 'falls from 40 to 35 kN m before its largest moment, 60 kN m'; done; true",
          CODE_OK,
          { "0\n1\n" } },
        { "sed '/^    modulus_of_rupture: {value: 59/,+1d' species/oak.yaml >$T/o.yaml; $W analyze $T/o.yaml "
          "$M --wind "
          "20 --samples 0 --no-report -o $T/a",
          CODE_OK,
          { "     elastic-limit ", "not assessed: breakage (the species has no modulus_of_rupture)" } },
        { "$W analyze oak $M --wind 10 --crown-form triangle --samples 0 --no-report -o $T/a",
          CODE_INPUT,
          { "--crown-form needs --crown-width and --crown-depth" } },
        { "$W analyze oak $M --wind 10 --leaf-off-share 0.3 --samples 0 --no-report -o $T/a",
          CODE_INPUT,
          { "--leaf-off-share: has no effect in leaf (season leaf_on)" } },
        { "$W analyze oak $M --season leaf_off --wind 10 --leaf-off-share 0.3 --samples 0 --no-report -q -o "
          "$T/a",
          CODE_OK,
          { "" } },
        { "$W analyze oak $M --wind 10 --corridor 3kg --samples 0 --no-report -o $T/a",
          CODE_INPUT,
          { "'3kg': 'kg' is not a unit of a length" } },
    };
    CHECK(rows);
}

/* The text of a page's first section, without the signs that keep units on a line. */
#define FRONT                                                                                                \
    "sed 's/<h2.*//; s/<tr/\\n<tr/g; s/<p/\\n<p/g; s/<figure/\\n<figure/g' $T/a/report.html | sed "          \
    "'/<svg/d; s/<[^>]*>/ /g; "                                                                              \
    "s/\\xe2\\x81\\xa0//g; s/\\xe2\\x80\\x8b//g' | tr -s ' ' | grep -E "

#define OAK "$W analyze oak --model oak_20m --wind 20 --no-pdf -o $T/a -q "
#define SCAN "$W analyze oak --tree docs/examples/scan.csv --wind 20 --directions 8 --no-pdf -o $T/a -q "

/* Of a tree whose roots nobody looked at, of a bare one, and of one in winds from all around the first page
 * says so. */
static void the_first_page_says_what_was_not_looked_at(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { OAK "--samples 20; " FRONT "'^ ?(Oak|Stem|Safety|How)|Limbs'",
          CODE_OK,
          { "its stem is far from breaking. The roots were not assessed: it may overturn in less wind.",
            "Safety against now limit governing place", "Stem is lost at 55.2 m/s mean",
            "to above 60 m/s mean (3-s gust 63 to above 91 m/s)", "Limbs, forks and unions" } },
        { OAK "--samples 20 --lang zh; " FRONT "'^ ?(欧洲栎|主干|把握)|大枝'",
          CODE_OK,
          { "主干离折断尚远。根系未评估：可能在更低的风速下连根倾倒。", "主干损毁风速 平均风速 55.2 m/s",
            " 至 91 以上 m/s", "大枝、分叉" } },
        { OAK "--samples 0 --soil mineral; " FRONT "'^ ?(Oak|Tree)'",
          CODE_OK,
          { "it overturns. \n", "Tree is lost at 20.0 m/s mean" } },
        { SCAN "--samples 20; " FRONT "'^ ?(In a|How|Direction)|without leaves'; "
               "grep -q 'Vogel power law' $T/a/report.html || echo no law",
          CODE_OK,
          { "Bare: neither leaves nor a crown’s area was given.", "above 60 m/s mean (3-s gust above 91 m/s)",
            "8 directions computed; from none is it lost up to 60 m/s", "Bare: neither leaves nor a crown",
            "no law\n" } },
        { SCAN "--samples 20 --lang zh; " FRONT "'^ ?(平均|把握|风向)'",
          CODE_OK,
          { "无叶：未给出叶片或树冠面积。", "平均风速 60 以上 m/s（3 s 阵风 91 以上 m/s）",
            "计算了 8 个来风方向；风速至 60 m/s 均不损毁" } },
        { SCAN "--samples 0 --leaf-area '60 m2'; " FRONT "'^ ?(Stem|Direction)'",
          CODE_OK,
          { "Stem is lost at 42.3 m/s mean", "wind from 90°: lost at 41.1 m/s mean (3-s gust 62.6 m/s)",
            "All else on this page is for wind from 270°." } },
    };
    CHECK(rows);
}

#define ROSE                                                                                                 \
    "{ echo direction_deg,frequency,weibull_scale_ms,weibull_shape; for d in 0 45 90 135 180 225 270 315; "  \
    "do echo $d,1,6,2; done; } >$T/r.csv\n"

static int tools(void)
{
    return system("command -v gnuplot >/dev/null && command -v weasyprint >/dev/null") == 0;
}

/* A page that is whole, in its language, with all its figures, and without a string that was not put in. */
#define LOOK                                                                                                 \
    "f=$T/%s/%s.html; grep -q '<html lang=\"%s\"' $f || echo language; grep -c '<figure' $f | grep -qv "     \
    "'^0$' || "                                                                                              \
    "echo no figure; grep -q 'class=\"missing\"' $f && echo missing figure; grep -oE '[{][0-9][}]' $f; "     \
    "grep -oE "                                                                                              \
    "'>(c|cap|h|in|f|ft|sr|ex|wd|rs|sh|tr|rn|md|t|sum|tb|p|w|m|fig|warn|role|sensor|finding)[.][a-z.]+<' "   \
    "$f; "                                                                                                   \
    "tail -c 10 $f | grep -q '</html>' || echo cut short; head -c 4 $T/%s/%s.pdf | grep -q %%PDF || echo "   \
    "no pdf; "

/* PDFs are left out and printed later, those of several folders by one call; a folder that is none does not
 * stop it. */
static void pdfs_are_made_later(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for n in 1 2; do $W analyze oak $M --wind 1$n --no-pdf -o $T/p$n -q; ls $T/p$n | grep -c report; "
          "done\n"
          "$W report $T/p1 $T/none $T/p2; code=$?\n"
          "for n in 1 2; do head -c 4 $T/p$n/report.pdf; grep -c '\"report.pdf\"' $T/p$n/results.json; done\n"
          "$W report $T/p1 --no-pdf -q --lang zh; ls $T/p1; grep '\"report.pdf\"' $T/p1/results.json; exit "
          "$code",
          CODE_INPUT,
          { "1\n1\n", "none/results.json: cannot be read", "%PDF1\n%PDF1\n",
            "plots\nreport.html\nresults.json\ntables\n" } },
        { "$W analyze oak $M --wind 10 --no-report --no-pdf",
          CODE_INPUT,
          { "--no-pdf: has no effect without a page" } },
    };
    if (!tools()) skip();
    CHECK(rows);
}

static void every_page_in_both_languages(void **state)
{
    (void)state;
    char command[4096];
    if (!tools()) skip();
    for (size_t i = 0; i < sizeof pages / sizeof *pages; i++) {
        const char *p = pages[i].page;
        int n = snprintf(command, sizeof command,
                         ROSE "$W %s -q -o $T/en >$T/said 2>&1 || cat $T/said; cp -r $T/en $T/zh; "
                              "$W report $T/zh --lang zh -q; ",
                         pages[i].command);
        for (int zh = 0; zh < 2; zh++) {
            const char *l = zh ? "zh" : "en";
            n += snprintf(command + n, sizeof command - (size_t)n, LOOK, l, p, l, l, p);
        }
        /* no heading, caption or head of a table is left in English */
        snprintf(command + n, sizeof command - (size_t)n,
                 "sed 's/<table class=\"block\">.*//' $T/zh/%s.html | grep -oE '<h2[^>]*>[ -~]*</h2>'; "
                 "grep -oE '<caption>[ -~]{20,}</caption>' $T/zh/%s.html; true",
                 p, p);
        if (shell(command) || *output) fail_msg("%s: %s", p, output);
    }
}

static void a_command_speaks_the_language_it_is_asked_for(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { ROSE "$W wind rose --file $T/r.csv --lang zh -q -o $T/out; grep -o '<html lang=\"zh\">' "
               "$T/out/rose.html; "
               "grep -o '全部风速' $T/out/plots/wind_rose.svg",
          CODE_OK,
          { "<html lang=\"zh\">", "全部风速" } },
        { "$W wind kaimal --lang de", CODE_INPUT, { "--lang" } },
        { "$W terrain -q --lang zh -o $T/out && find $T/out/plots -name terrain.svg -size -100000c", /* bytes
                                                                                                      */
          CODE_OK,
          { "terrain.svg" } },
        /* two species of one Chinese name are told apart */
        { "sed 's/^name:.*/name: River oak/' species/oak.yaml >$T/b.yaml; PATH=/none $W compare oak "
          "$T/b.yaml $M "
          "--wind 10 -q --lang zh -o $T/out 2>/dev/null; f=$T/out/report.html; grep -q '欧洲栎（Oak）' $f && "
          "grep "
          "-q '欧洲栎（River oak）' $f && ! grep -q '欧洲栎[^（]' $f && echo apart",
          CODE_OK,
          { "apart\n" } },
        { "mkdir -p $T/out; echo '{\"schema\": {\"name\": \"windfirm-wind\", \"version\": 2}}' "
          ">$T/out/results.json; "
          "$W report $T/out",
          CODE_INPUT,
          { "results of version 2; this program reads version 1" } },
        { "mkdir -p $T/out; echo '{\"schema\": {\"name\": \"windfirm-wind\", \"version\": 1}, \"figures\": "
          "[{\"name\": "
          "\"../x\", \"script\": \"wind\"}]}' >$T/out/results.json; $W report $T/out",
          CODE_INPUT,
          { "not a name of a figure" } },
    };
    if (!tools()) skip();
    CHECK(rows);
}

/* Every warning has words in both languages: those that name their code where they are made, and the repairs
 * of a scanned tree, which are rows. */
static void every_warning_has_words(void **state)
{
    (void)state;
    shell("{ cat src/*/*.c | tr -d '\\n' | grep -oE 'wf_diag_warn[(][^\"]*\"[a-z-]+\"' | sed "
          "'s/.*(.*\"\\(.*\\)\"/\\1/'; "
          "sed -n 's/.*\\[WF_[A-Z]*_[A-Z_]*\\] = { \"\\([a-z-]*\\)\",.*/\\1/p' src/grow/qsm.c; } | sort -u "
          ">$T/codes; "
          "wc -l <$T/codes | awk '$1 < 80 { print \"too few codes: \" $1 }'; "
          "while read -r c; do grep -q \"<s id=.warn[.]$c.>\" reports/strings.xml || echo \"$c\"; done "
          "<$T/codes");
    if (*output) fail_msg("no words for %s", output);
}

/* Strings that no stylesheet asks for are not kept, and every string is there in both languages. */
/* Printed Chinese pages have a bold face, which has the characters of the program's words; a few new ones may
 * wait for `make han-bold`. */
static void chinese_has_a_bold(void **state)
{
    (void)state;
    if (shell("command -v weasyprint && command -v pdffonts && command -v gnuplot")) skip();
    static const struct row rows[] = {
        { "$W wind extremes --annual docs/examples/annual.csv --lang zh -q -o $T/out 2>$T/said; pdffonts "
          "$T/out/extremes.pdf | grep -c "
          "'Han-bold.*yes yes yes'; pdftotext $T/out/extremes.pdf - | head -n 1",
          CODE_OK,
          { "1\n风速的超越概率\n" } },
        { "$(sed -n '1s/^#!//p' \"$(command -v weasyprint)\") - reports/strings.xml reports/messages.xml "
          "reports/plots/words.tsv <<'END'\n"
          "import sys\n"
          "from fontTools.ttLib import TTFont\n"
          "has = TTFont('reports/han_bold.ttf').getBestCmap()\n"
          "said = {c for name in sys.argv[1:] for c in open(name, encoding='utf-8').read() if ord(c) > "
          "0x2e7f}\n"
          "lacks = [c for c in sorted(said) if ord(c) not in has]\n"
          "print('enough' if len(lacks) <= len(said) // 50 else 'make han-bold: ' + ''.join(lacks))\n"
          "END\n",
          CODE_OK,
          { "enough" } },
    };
    CHECK(rows);
}

static void strings_are_whole(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "grep -nE '<(s|q|k) id' reports/strings.xml | grep -vE '<en>[^<]+</en><zh>[^<]+</zh>' || echo none",
          CODE_OK,
          { "none" } },
        { "grep -nE '<w id' reports/strings.xml | grep -vE '<zh>[^<]+</zh></w>$' || echo none",
          CODE_OK,
          { "none" } },
        { "grep -oE '<[swk] id=\"[^\"]+\"' reports/strings.xml | sort | uniq -d | grep . || echo none",
          CODE_OK,
          { "none" } },
        { "awk 'length($0) > 140 { print FILENAME \":\" FNR }' reports/*.xsl | grep . || echo none",
          CODE_OK,
          { "none" } },
    };
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        shell(rows[i].command);
        if (strcmp(output, "none\n")) fail_msg("%s", output);
    }
}

/* No page but the last is half empty, and no last page has less than a fifth: labels of figures are words
 * too. */
static void pages_are_filled(void **state)
{
    (void)state;
    if (shell("command -v weasyprint && command -v pdftotext && command -v gnuplot")) skip();
    static const struct row rows[] = {
        { "set -- 'assess models/cards/oak.yaml --client Town --assessor Person --photo "
          "tests/data/job/photo.jpg' 'analyze scots_pine --model scots_pine --soil mineral --wind 10,20 "
          "--samples 0' 'wind extremes --annual docs/examples/annual.csv' 'papers tang2012 --no-vtk' 'rain "
          "--staged --duration 2'; for c; do for l in en zh; do $W $c --lang $l -q -o $T/out >$T/said 2>&1; "
          "python3 tests/page_fill.py $T/out/*.pdf; rm -r $T/out; done; done | awk '$1 < 55 || $2 < 18 { "
          "print "
          "\"bad:\", $0 } END { print NR }'",
          CODE_OK,
          { "10\n" } },
        /* characters that are not drawn are not in the text of the page */
        { "$W analyze oak --model oak_20m --soil mineral --wind 10 --samples 0 -q -o $T/out >$T/said 2>&1; "
          "pdftotext "
          "$T/out/report.pdf $T/text; grep -c stress $T/text | awk '{ print ($1 > 5) }'; grep -c \"$(printf "
          "'\\342\\201\\240')\" $T/text; rm -r $T/out; true",
          CODE_OK,
          { "1\n0\n" } },
        /* the signature stays on a first page on which much is said */
        { "for l in en zh; do $W assess models/cards/oak.yaml -q -o $T/out --lang $l --snow 20cm "
          "--winter-wind 0.4 --ice 5mm "
          "--rain 20mm/h --lean 8deg --lean-towards 120deg --cavity 1.3m:80mm --client Town --assessor "
          "Person --samples 32 "
          ">$T/said 2>&1; pdftotext -f 1 -l 1 $T/out/report.pdf - | grep -c -e '^Signature' -e '^签字'; rm "
          "-r $T/out; done",
          CODE_OK,
          { "1\n1\n" } },
    };
    CHECK(rows);
    assert_null(strstr(output, "bad:"));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(pages_are_filled),
        cmocka_unit_test(pdfs_are_made_later),
        cmocka_unit_test(every_page_in_both_languages),
        cmocka_unit_test(a_command_speaks_the_language_it_is_asked_for),
        cmocka_unit_test(every_warning_has_words),
        cmocka_unit_test(chinese_has_a_bold),
        cmocka_unit_test(strings_are_whole),
        cmocka_unit_test(what_governs_is_said),
        cmocka_unit_test(the_first_page_says_what_was_not_looked_at),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
