/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Sentences by parts, and their translations: the parts give back what printf prints; the catalogue has every
 * warning and every note; no English sentence is left in Chinese pages. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "base/err.h"
#include "base/said.h"
#include "out/tongue.h"
#include "shell.h"
#include <string.h>

static bool take(struct wf_arena *a, struct wf_said *out, const char *fmt, ...)
{
    va_list args;
    va_start(args, fmt);
    bool whole = wf_said_take(a, fmt, args, out);
    va_end(args);
    return whole;
}

/* Every kind of conversion that the program uses. */
static void parts_are_what_printf_prints(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_said s;
    assert_true(take(&a, &s, "%s: %zu of %d, 50 %%, %.3g|%*.*f|%-8s|%+d|%02X|%lld", "Oak", (size_t)7, -3,
                     12.3456, 9, 2, 3.14159, "ab", 5, 10, 123456789012LL));
    assert_string_equal(s.message, "{1}: {2} of {3}, 50 %, {4}|{5}|{6}|{7}|{8}|{9}");
    assert_int_equal(s.n, 9);
    static const char *const want[] = { "Oak", "7", "-3", "12.3", "3.14", "ab", "+5", "0A", "123456789012" };
    for (size_t k = 0; k < 9; k++) assert_string_equal(s.arg[k], want[k]);
    assert_int_equal(s.width[4], 9);
    assert_int_equal(s.width[5], -8);
    assert_string_equal(wf_said_put(&a, "{2} {1} {10} {x} {", s.arg, s.n), "7 Oak {10} {x} {");
    assert_true(take(&a, &s, "nothing"));
    assert_int_equal(s.n, 0);
    assert_false(take(&a, &s, "%d%d%d%d%d%d%d%d%d%d%d%d%d%d%d%d%d", 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12, 13,
                      14, 15, 16, 17));
    wf_arena_free(&a);
}

/* A finding keeps its parts, also when it is passed on. */
static void findings_keep_their_parts(void **state)
{
    (void)state;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a }, other = { .arena = &a };
    wf_diag_warn(&d, "code", "%s: %.1f m", "Oak", 2.25);
    wf_diag_pass(&other, d.first);
    wf_diag_pass(&other, d.first);
    assert_int_equal(other.warnings, 1);
    assert_string_equal(other.first->text, "Oak: 2.2 m");
    assert_string_equal(other.first->said->message, "{1}: {2} m");
    assert_string_equal(other.first->said->arg[1], "2.2");
    wf_arena_free(&a);
}

static void sentences(void **state)
{
    (void)state;
    setenv("WINDFIRM_SHARE", ".", 1);
    struct wf_arena a = { 0 };
    struct wf_err e = { 0 };
    struct wf_tongue *zh = NULL, *en = NULL;
    struct wf_said s;
    assert_int_equal(wf_tongue_open("zh", &zh, &e), WF_OK);
    assert_int_equal(wf_tongue_open("en", &en, &e), WF_OK);
    wf_tongue_name(zh, "Oak", "欧洲栎");
    assert_true(take(&a, &s, "%s: these values are assumptions, not measurements: %s", "Oak",
                     "stem: shear_modulus, density; crown: frontal_share"));
    assert_string_equal(
        wf_tongue_say(zh, &s, &a),
        "欧洲栎：以下取值为假设而非实测：主干：剪切模量、密度（生材）；树冠：迎风面积与叶面积之比");
    assert_string_equal(wf_tongue_say(en, &s, &a),
                        "Oak: these values are assumptions, not measurements: stem: shear "
                        "modulus, density; crown: frontal area per leaf area");
    assert_true(take(&a, &s, "a sentence that nobody has translated: %s", "x"));
    assert_null(wf_tongue_say(zh, &s, &a));
    assert_string_equal(wf_tongue_text(zh, "range assumed, a quarter"), "范围为假设，四分之一");
    assert_string_equal(wf_tongue_text(zh, "not there"), "not there");
    wf_tongue_close(zh), wf_tongue_close(en), wf_tongue_close(NULL);
    wf_arena_free(&a);
}

static void catalogue(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "python3 tests/tongue.py formats", CODE_OK, { " 0 missing" } },
        { "python3 tests/tongue.py notes", CODE_OK, { " 0 missing" } },
        { "python3 tests/tongue.py terminal", CODE_OK, { " 0 missing" } },
    };
    CHECK(rows);
}

/* The terminal, in the language of --lang; in English as before. */
static void terminal(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W assess models/cards/oak.yaml --lang zh --no-report -o $T/out",
          CODE_OK,
          { "临界风速", "个样本的 90 % 介于", "以下取值为假设而非实测：主干：剪切模量",
            "未评估：大枝、分叉与枝干结合处" } },
        { "$W assess models/cards/oak.yaml",
          CODE_OK,
          { "critical wind: ", "these values are assumptions, not measurements: stem: shear_modulus" } },
    };
    CHECK(rows);
}

/* Mistakes of a command line, a card and a table, verdicts of scenarios, and texts that were put together.
 * What is typed stays as it is typed. */
static void mistakes(void **state)
{
    (void)state;
#define CARD "--species oak --height 20 --girth 2.5 --crown-width 14 --crown-base 4"
    static const struct row rows[] = {
        { "printf 'card: x\nspecies: oak\nheigt: 20 m\ngirth: 2.5\ncrown_width: 14 m\ncrown_base: 4 "
          "lb\nwind: "
          "20\n' >$T/bad.yaml; printf 'a,b\n1,2\n' >$T/h.csv; while read -r x; do $W assess $x --lang zh; "
          "done "
          "2>&1 >/dev/null <<E | grep -v '警告' >$T/said\n"
          "--species 松树\n--species oak --height 200 --girth 2,5\n--species Zzz --height abc --girth "
          "2kg\n" CARD " --soil minera --wind\n" CARD " --lean 80 --bogus\n" CARD
          " --wind 20 --scenarios thin=200%\n" CARD " --wind 20 --scenarios foo=1\n" CARD
          " --leaf-off yes --wind 20\n" CARD " --wind 20 --season leaf_off --leaf-off-share 0\n" CARD
          " --wind 20 --cavity 1.3m:900mm\n" CARD
          " --wind 20 --guy 3m\n$T/h.csv --wind 20 -o $T/o\n--from none --height 20 --wind 20\n$T/bad.yaml\n"
          "--species moso_bamboo --height 10 --girth 0.3 --crown-width 2 --crown-base 3 --wind 20\nE\n"
          "sed -i \"s#$T/##\" $T/said; grep -v -e 'species list' -e minera $T/said | python3 tests/tongue.py "
          "said; grep -c . "
          "$T/said; cat $T/said",
          CODE_OK,
          { " 0 missing\n47\n", "未知键“heigt”；是否指“height”？",
            "“4 lb”：“lb”不是长度的单位；可用：m, cm, mm",
            "“minera”不属于 mineral, gleyed, peaty, peat, unknown；是否指“mineral”？",
            "方案“thin=200%”：thin: 200% 超出 0..0.9" } },
        /* a sentence without a translation is not half translated */
        { "$W analyze oak --model culmx --wind 10 --lang zh",
          CODE_INPUT,
          { "error: culmx: there is no such file, and no shipped tree model of that name; did you mean "
            "'culm'?\n" } },
        { "$W assess models/cards/oak.yaml --lang zh --samples 0 --scenarios "
          "reduce=3m,thin=15%,season=leaf_off,soil=peat 2>/dev/null >$T/said; python3 tests/tongue.py said "
          "<$T/said; "
          "sed -n '/处理或变化/,/^ *soil/p' $T/said | sed 's/.* //' | grep -c -e 损毁 -e 不确定 -e 不足; "
          "grep -c "
          "'其他 9 个种或类群合计 267 株' $T/said",
          CODE_OK,
          { " 0 missing\n5\n1\n" } },
        { "$W assess " CARD
          " --lang zh --samples 0 --wind 20 --snow 20cm --winter-wind 0.4 --soil mineral 2>&1 | python3 "
          "tests/tongue.py said",
          CODE_OK,
          { " 0 missing\n" } },
    };
    CHECK(rows);
}

/* The tables of the other commands: heads, names of species and sentences; and the check finds English where
 * it is. */
static void tables_of_the_terminal(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for c in 'analyze scots_pine --model scots_pine --soil mineral --wind 10,20 --directions 8 "
          "--samples "
          "0' 'compare oak moso_bamboo --model culm --wind 10,25 --samples 32' 'explain oak --model culm "
          "--wind 8' 'series oak --model culm --wind 8 --duration 2 --step 0.5 --keys 2 --gust cosine "
          "--no-vtk' 'modes oak --model culm --wind 0,10' 'fragility oak --model culm --samples 20'; do "
          "$W $c --lang zh --no-report -o $T/out 2>/dev/null; done >$T/said; for c in 'fit "
          "models/field/sample_pull.yaml --no-rival' 'terrain --size 3 --relief 20' 'rain --staged "
          "--duration 2' 'wind kaimal --duration 30 --points 2' 'wind extremes --annual "
          "docs/examples/annual.csv' 'wind rose --file docs/examples/rose.csv'; do $W $c --lang zh "
          "--no-pdf -o $T/out 2>/dev/null; done >>$T/said; python3 tests/tongue.py said <$T/said; grep -c -e "
          "梢端位移 -e 重现期 -e '欧洲赤松 (' -e 相邻相关 -e 限距 -e 水量 -e 顺风标准差 -e 对数正态 -e "
          "梢端平均 $T/said",
          CODE_OK,
          { " 0 missing\n1" } },
        { "$W modes oak --model culm --wind 10 --no-report -o $T/out 2>/dev/null | python3 tests/tongue.py "
          "said",
          CODE_RUN,
          { "missing: Modes about the state" } },
    };
    CHECK(rows);
}

/* Pages of every kind in Chinese; and the check finds English where it is. */
/* Usage texts: what commands and options are for. Names of commands and lists of words to be typed are no
 * sentences. */
static void usage(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for c in $($W --help=words | awk -F'\t' '$2 == \"command\" { print $1 }') 'tree info' 'tree draw' "
          "'wind extremes'; do $W $c "
          "--help --lang zh || echo no help of $c; done >$T/said; grep -v '^  windfirm' $T/said | sed "
          "'s/[a-z0-9-]*, *//g; "
          "s/windfirm [a-z]* [a-z]*//' | python3 tests/tongue.py said",
          CODE_OK,
          { "looked at, 0 missing" } },
        { "$W --help --lang zh; $W species list --lang zh | head -n 2; $W species show oak --lang zh; $W "
          "import docs/examples/scan.csv "
          "--lang zh; $W assess --help --lang=zh | grep -e --lang",
          CODE_OK,
          { "命令：\n  analyze       风对", "欧洲白蜡树", "树冠阻力系数", "分段 CSV，60 个圆柱" } },
        { "$W assess --help --lang=zh | grep -e --lang",
          CODE_OK,
          { "  --lang NAME               报告的语言: en, zh [en]\n" } },
    };
    CHECK(rows);
}

static void pages(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "for c in 'assess models/cards/oak.yaml' 'analyze moso_bamboo --model moso_culm --wind 10,25 "
          "--directions 8' "
          "'analyze scots_pine --model scots_pine --soil mineral --wind 10,20' 'compare beech "
          "willow_feng1999 --model "
          "oak_20m --wind 15 --samples 0' 'fit models/field/sample_pull.yaml --no-rival' 'explain oak "
          "--model culm --wind "
          "8' 'wind kaimal --duration 30 --points 2' 'terrain --size 4 --relief 20' 'rain --staged "
          "--duration 1.6' 'modes "
          "oak --model culm --wind 10' 'fragility oak --model culm --samples 40' 'wind extremes --annual "
          "docs/examples/annual.csv' 'shelter --model scots_pine --species scots_pine --slabs 3 --cells 8' "
          "'wind rose "
          "--file docs/examples/rose.csv' 'series oak --model culm --wind 8 --duration 2 --step 0.5 --keys 2 "
          "--gust cosine --no-vtk'; "
          "do n=$((n + 1)); $W $c --lang zh -q --no-pdf -o $T/$n 2>$T/said || cat $T/said; done; ls "
          "$T/*/*.html | wc -l; "
          "python3 tests/tongue.py pages $T/*/*.html",
          CODE_OK,
          { "15\n", " 0 missing" } },
        { "$W explain oak --model culm --wind 8 --lang en -q --no-pdf -o $T/out; python3 tests/tongue.py "
          "pages "
          "$T/out/*.html",
          CODE_RUN,
          { "missing: " } },
    };
    CHECK(rows);
}

/* Names of runs, methods and parameters have words, in figures too, and no title is cut; drawn again in
 * English they are English. */
static void names_in_figures(void **state)
{
    (void)state;
    if (shell("command -v gnuplot")) skip();
    static const struct row rows[] = {
        { "$W papers tang2012 --no-vtk --no-pdf -q --lang zh -o $T/out >/dev/null 2>&1; cd $T/out; cat "
          "plots/frames_*.svg plots/series.svg plots/explain_1.svg >all; for t in '图 6：10 GPa，10 m/s' "
          "'照印，40 段' '阵风，枝与叶' '悬臂梁链（照印）'; do grep -c \"$t\" all; done; grep -c -e '…' -e "
          "'chain' -e 'gusts' all; grep -o '<th[^>]*>逐段挠度（照印）' series.html | head -1",
          CODE_OK,
          { "1\n1\n1\n1\n0\n<th class=\"r\">" } },
        { "$W papers tang2012 --no-vtk --no-pdf -q --lang zh -o $T/out >/dev/null 2>&1; $W report $T/out "
          "--no-pdf >/dev/null; grep -c 'SAID.NAME' $T/out/plots/run.csv; cat $T/out/plots/*.svg | grep -c "
          "-e 'Fig. 6: 10 GPa, 10 m/s' -e 'printed, 40 segments' -e 'chain, as printed' -e 'gusts, branches "
          "and leaves'",
          CODE_OK,
          { "0\n5\n" } },
        { "$W wind kaimal --duration 30 --points 2 --no-pdf -q --lang zh -o $T/out >/dev/null 2>&1; grep -o "
          "'顺风相干衰减 (<code>decay-along' $T/out/wind.html; grep -c 'Kaimal 谱' $T/out/plots/wind.svg",
          CODE_OK,
          { "顺风相干衰减 (<code>decay-along\n1\n" } },
    };
    CHECK(rows);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(names_in_figures),
        cmocka_unit_test(parts_are_what_printf_prints),
        cmocka_unit_test(findings_keep_their_parts),
        cmocka_unit_test(sentences),
        cmocka_unit_test(catalogue),
        cmocka_unit_test(terminal),
        cmocka_unit_test(mistakes),
        cmocka_unit_test(tables_of_the_terminal),
        cmocka_unit_test(usage),
        cmocka_unit_test(pages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
