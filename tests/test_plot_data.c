/* SPDX-License-Identifier: GPL-3.0-or-later */
/* What figures read from a results folder is data: strange texts come back as they were, and no script loads,
 * calls or evaluates anything that stands in a folder. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include "out/doc.h"
#include "shell.h"
#include <math.h>
#include <stdio.h>
#include <unistd.h>

static char folder[64];

static int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/windfirm-plot-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char command[128];
    snprintf(command, sizeof command, "rm -r %s", folder);
    return system(command);
}

static bool has_gnuplot(void) { return system("command -v gnuplot >/dev/null 2>&1") == 0; }

/* Paths are left out of what pages print, so that a text names none here. */
static void strange_texts_and_numbers_come_back(void **state)
{
    (void)state;
    static const char *const texts[] = { "plain",
                                         "a \"quoted\" name, with a comma",
                                         "back\\slash \\n \\054",
                                         "`touch windfirm-was-here` @start $X",
                                         "'; system('touch windfirm-was-here'); '",
                                         "# {/Bold enhanced} %g %s ~a",
                                         "\xe6\x9f\xb3 \xe2\x80\x93 \xc2\xb0",
                                         "",
                                         "1e-5 NaN",
                                         "'Lombardy' poplar",
                                         "''" };
    static const double numbers[] = { 0, -1.5e-7, 1e-5, 1e300, 123456789, 0.1, -3 };
    enum { TEXTS = sizeof texts / sizeof *texts, NUMBERS = sizeof numbers / sizeof *numbers };
    struct wf_err e = { 0 };
    struct wf_plot_data p;
    char command[1024];
    if (!has_gnuplot()) skip();
    assert_int_equal(wf_folder_make(folder, &e), WF_OK);
    assert_int_equal(wf_plot_data_begin(&p, folder, "run", &e), WF_OK);
    for (size_t i = 0; i < TEXTS; i++) wf_plot_data_text(&p, "TEXT", i + 1, texts[i]);
    for (size_t i = 0; i < NUMBERS; i++) wf_plot_data_number(&p, "NUMBER", i + 1, numbers[i]);
    wf_plot_data_number(&p, "NONE", 0, NAN);
    char many[3501];
    memset(many, '\'', sizeof many - 1);
    many[sizeof many - 1] = '\0';
    wf_plot_data_text(&p, "MANY", 0, many);
    wf_plot_data_words(&p, "WORDS", 0, "1 2 3 ");
    wf_plot_data_text(&p, "XML", 0, "]]> &#x41; \xef\xbf\xbe");
    wf_plot_data_text(&p, "LINES", 0, "two\nlines");
    assert_int_equal(wf_plot_data_end(&p, &e), WF_OK);
    snprintf(command, sizeof command,
             "cat >%s/t.gp <<'END'\nDIR = ARG1; HERE = 'reports/plots/'; LANGUAGE = 'en'; FACTS = 'run'; set "
             "encoding "
             "utf8\nload HERE.'facts.gp'\n"
             "do for [i=1:%d] { print '<'.text_of('TEXT', i).'>' }\n"
             "do for [i=1:%d] { print sprintf('%%.17g', number('NUMBER', i)) }\n"
             "print number('NONE', 0), ' ', number('NOWHERE', 3), '<'.text_of('LINES', 0).'>', L('TIME'), "
             "L('no such')\n"
             "print strlen(text_of('MANY', 0)), text_of('MANY', 0)[160:160], words(text_of('WORDS', 0)), "
             "text_of('XML', 0)\n"
             "END\ngnuplot -c %s/t.gp %s",
             folder, (int)TEXTS, (int)NUMBERS, folder, folder);
    if (shell(command)) fail_msg("%s", output);
    const char *at = output;
    for (size_t i = 0; i < TEXTS; i++) {
        char want[256];
        int n = snprintf(want, sizeof want, "<%s>\n", texts[i]);
        if (strncmp(at, want, (size_t)n)) fail_msg("want %s but: %s", want, at);
        at += n;
    }
    for (size_t i = 0; i < NUMBERS; i++) {
        char *end;
        double x = strtod(at, &end);
        if (fabs(x - numbers[i]) > 1e-14 * fabs(numbers[i])) fail_msg("want %g but: %s", numbers[i], at);
        at = end + 1;
    }
    assert_string_equal(at, "NaN   NaN <two lines> time [s] no such\n160 \xe2\x80\xa6 3 "
                            "]]\xe2\x81\xa0> &\xe2\x81\xa0#x41; \xef\xbf\xbd\n");
    assert_int_not_equal(access("windfirm-was-here", F_OK), 0);
}

static void only_numbers_are_taken_for_numbers(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    struct wf_plot_data p;
    assert_int_equal(wf_folder_make(folder, &e), WF_OK);
    assert_int_equal(wf_plot_data_begin(&p, folder, "run", &e), WF_OK);
    assert_int_equal(wf_plot_data_parse(&p, "GOOD", 1, "1.5e3", &e), WF_OK);
    assert_int_equal(wf_plot_data_parse(&p, "GOOD", 2, "NaN", &e), WF_OK);
    static const char *const bad[] = { "", "1.5 m", "`date`", "1;2", "system('x')" };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        e = (struct wf_err){ 0 };
        assert_int_equal(wf_plot_data_parse(&p, "BAD", 1, bad[i], &e), WF_EINPUT);
    }
    wf_file_abandon(&p.f);
}

/* A script may load its own neighbours and nothing else; text is never made into commands. */
static void scripts_load_nothing_of_a_folder(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "ls reports/plots/*.gp | wc -l | awk '{ print ($1 > 20) }'", CODE_OK, { "1" } },
        { "sed 's/\"[^\"]*\"//g' reports/plots/*.gp | grep -nE '\\b(load|call)\\b' | grep -vE "
          "\"^[0-9]+:(#.*|[ ]*load "
          "HERE\\.'[a-z_]+\\.gp'|[ ]*call SEVERAL\\.word\\(SEVERAL_LIST, SEVERAL_AT\\)\\.'\\.gp' SEVERAL_IN "
          "word\\(SEVERAL_LIST, SEVERAL_AT \\+ 1\\) SEVERAL_LANGUAGE word\\(SEVERAL_LIST, SEVERAL_AT \\+ "
          "2\\))$\" || echo none",
          CODE_OK,
          { "none" } },
        { "sed \"s/#.*//; s/'[^']*'//g\" reports/plots/*.gp | sed 's/\"[^\"]*\"//g' | grep -nE "
          "'\\b(eval|evaluate|system|value|exec|import)\\b|`|@' || echo none",
          CODE_OK,
          { "none" } },
        { "grep -nE \"[\\\"'][<|]\" reports/plots/*.gp || echo none", CODE_OK, { "none" } }, /* pipes */
    };
    CHECK(rows);
    for (size_t i = 1; i < sizeof rows / sizeof *rows; i++) {
        shell(rows[i].command);
        if (strcmp(output, "none\n")) fail_msg("%s", output);
    }
}

/* Every label in both languages, and every label a script asks for. */
static void every_label_in_both_languages(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "awk -F'\\t' '!/^#/ && (NF != 3 || $1 == \"\" || $2 == \"\" || $3 == \"\" || /\"/) { print "
          "FILENAME \": \" $0; bad = 1 } "
          "!/^#/ && seen[$1]++ { print \"twice: \" $1; bad = 1 } END { exit bad }' reports/plots/words.tsv",
          CODE_OK,
          { NULL } },
        { "for k in $(grep -ohE \"L\\('[A-Z_0-9]+'\\)\" reports/plots/*.gp | sed \"s/L('//; s/')//\" | sort "
          "-u); do "
          "awk -F'\\t' -v k=$k '$1 == k { f = 1 } END { exit !f }' "
          "reports/plots/words.tsv || { echo \"no label $k\"; exit 1; }; done",
          CODE_OK,
          { NULL } },
    };
    CHECK(rows);
}

int main(void)
{
#define T(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        T(strange_texts_and_numbers_come_back),
        T(only_numbers_are_taken_for_numbers),
        cmocka_unit_test(scripts_load_nothing_of_a_folder),
        cmocka_unit_test(every_label_in_both_languages),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
