/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Names, numbers and folders as an attacker would choose them: nothing is run, nothing is lost. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>

#include <cmocka.h>

#include "out/printer.h"
#include "out/reader.h"
#include "out/report.h"
#include "shell.h"
#include <unistd.h>

static bool tools(void)
{
    return system("command -v gnuplot >/dev/null && command -v weasyprint >/dev/null") == 0;
}

/* $PRINTER, for the front of PATH: a WeasyPrint that notes the names it is given and writes a PDF without
 * content, below the true reports/pdf.py. WeasyPrint needs a second for a page, so the true one prints a few
 * pages of each kind only. */
static char printer[] = "/tmp/windfirm-test-XXXXXX";

static int make_printer(void **state)
{
    (void)state;
    char command[1024];
    if (!mkdtemp(printer) || setenv("PRINTER", printer, 1)) return -1;
    snprintf(
        command, sizeof command, "%s",
        "true=$(command -v python3); cd $PRINTER && echo \"#!$PRINTER/python3\" >weasyprint && cat >python3 "
        "<<END && chmod +x * && cat >weasyprint.py <<'END'\n"
        "#!/bin/sh\n"
        "echo \"\\$*\" >>$PRINTER/printed\n"
        "shift\n"
        "PYTHONDONTWRITEBYTECODE=1 PYTHONPATH=$PRINTER exec $true \"\\$@\"\n"
        "END\n"
        "import logging, os\n"
        "LOGGER = logging.getLogger()\n"
        "class HTML:\n"
        "    def __init__(self, string, encoding, url_fetcher): pass\n"
        "    pages = [None]\n"
        "    def render(self): return self\n"
        "    def write_pdf(self, name):\n"
        "        with open(os.environ['PRINTER'] + '/printed', 'a') as f: f.write(ascii(name) + '\\n')\n"
        "        with open(name, 'w') as f: f.write('%PDF-1\\n%%EOF\\n')\n"
        "END\n");
    return system(command);
}

/* Did the printer get names of this program only? */
static void check_printed(void)
{
    int code = system("grep -q '^-E' $PRINTER/printed && grep -q pdf[.] $PRINTER/printed && ! grep -vxE "
                      "-e '-E [^ ]*/reports/pdf.py' -e \"'[.][a-z]+.pdf[.0-9]+'\" $PRINTER/printed");
    if (code) fail_msg("the printer of pages was not started, or with other arguments");
}

static int remove_printer(void **state)
{
    (void)state;
    return system("rm -r \"$PRINTER\"");
}

/* A document of each kind, small. */
static const struct {
    const char *folder, *command;
} kinds[] = {
    { "report", "compare oak moso_bamboo $M --wind 10,20 --directions 8 --no-report" },
    { "calibration", "fit $S --no-profile --no-rival --no-report" },
    { "series", "series oak $M --wind 8 --duration 1 --step 0.5 --gust cosine --no-vtk --explain --keys 2 "
                "--no-report" },
    { "explain", "explain oak $M --wind 8 --no-report" },
    { "wind", "wind kaimal --duration 60 --points 3 --components 3 --no-plots" },
    { "rose", "wind rose --file $T/r.csv --no-plots" },
    { "shelter", "shelter --model scots_pine --species scots_pine --slabs 4 --cells 16 --no-plots" },
    { "terrain", "terrain --size 4 --relief 20 --no-plots" },
    { "modes", "modes oak $M --wind 0 --no-report" },
};
enum { KINDS = sizeof kinds / sizeof *kinds };
#define ROSE                                                                                                 \
    "{ echo direction_deg,frequency,weibull_scale_ms,weibull_shape; for d in 0 45 90 135 180 225 270 315; "  \
    "do echo $d,1,6,2; done; } >$T/r.csv\n"

static void make_folders(void)
{
    char command[4096];
    int n = snprintf(command, sizeof command, ROSE);
    for (size_t i = 0; i < KINDS; i++)
        n += snprintf(command + n, sizeof command - (size_t)n, "$W %s -q -o $T/%s || exit 9\n",
                      kinds[i].command, kinds[i].folder);
    if (shell(command)) fail_msg("%s", output);
}

/* What a leaf is changed to. */
static json_t *other_value(size_t k)
{
    switch (k) {
    case 0:
        return json_string("`touch pwned`'; system('touch pwned') # |touch pwned <touch pwned @pwned");
    case 1:
        return json_real(-1e99);
    case 2:
        return json_integer((json_int_t)1 << 62);
    case 3:
        return json_pack("[[{s:s}]]", "value", "pwned");
    default:
        return json_null();
    }
}
enum { VALUES = 5 };

struct fuzz {
    char folder[256], file[300];
    json_t *document, *seen; /* keys that were changed: a key means the same at every place of a document */
    size_t tried, refused;
};

/* Write the document as it is now and ask for its page. The programs that draw are not there: their turn is
 * the next test. */
static void try(struct fuzz *z)
{
    struct wf_arena arena = { 0 };
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { 0 };
    if (json_dump_file(z->document, z->file, 0)) fail_msg("%s: not written", z->file);
    enum wf_status s = wf_report_make(z->folder, &(struct wf_page_style){ .language = "en" }, &(struct wf_printer){ 0 }, &d, &e);
    if (s != WF_EMISSING && s != WF_EINPUT && s != WF_EOUTPUT) fail_msg("%s: %s", z->file, e.text);
    z->tried++;
    z->refused += s == WF_EINPUT;
    wf_arena_free(&arena);
}

static void change(struct fuzz *z, json_t *at, const char *key);

/* Was the key met before in this document? */
static bool met(struct fuzz *z, const char *key, bool item)
{
    char name[120];
    snprintf(name, sizeof name, "%s%s", key, item ? "[0]" : "");
    if (json_object_get(z->seen, name)) return true;
    json_object_set_new(z->seen, name, json_true());
    return false;
}

/* Every other value in the place of a member, or of the first item of a list, which is put back; then what is
 * inside it. */
static void change_part(struct fuzz *z, json_t *holder, const char *key, json_t *v)
{
    bool item = json_is_array(holder);
    size_t values = met(z, key, item) ? 0 : VALUES;
    json_incref(v);
    for (size_t k = 0; k < values; k++) {
        if (item)
            json_array_set_new(holder, 0, other_value(k));
        else
            json_object_set_new(holder, key, other_value(k));
        try(z);
    }
    if (item)
        json_array_set(holder, 0, v);
    else
        json_object_set(holder, key, v);
    change(z, v, key);
    json_decref(v);
}

/* The first item of each list stands for the others. */
static void change(struct fuzz *z, json_t *at, const char *key)
{
    if (json_is_array(at) && json_array_size(at)) change_part(z, at, key, json_array_get(at, 0));
    if (!json_is_object(at)) return;
    const char *keys[100];
    size_t n = 0;
    for (void *i = json_object_iter(at); i && n < 100; i = json_object_iter_next(at, i))
        keys[n++] = json_object_iter_key(i);
    for (size_t i = 0; i < n; i++) change_part(z, at, keys[i], json_object_get(at, keys[i]));
}

static void every_leaf_of_every_document(void **state)
{
    (void)state;
    make_folders();
    const char *given = getenv("PATH");
    char *path = strdup(given ? given : "");
    for (size_t i = 0; i < KINDS; i++) {
        struct fuzz z = { .tried = 0 };
        snprintf(z.folder, sizeof z.folder, "%s/%s", scratch, kinds[i].folder);
        snprintf(z.file, sizeof z.file, "%s/results.json", z.folder);
        z.document = json_load_file(z.file, 0, NULL);
        assert_non_null(z.document);
        setenv("PATH", "/nowhere", 1);
        z.seen = json_object();
        change(&z, z.document, "");
        setenv("PATH", path, 1);
        json_decref(z.document), json_decref(z.seen);
        print_message("%s: %zu documents, %zu refused\n", kinds[i].folder, z.tried, z.refused);
        assert_true(z.tried > 50);
        assert_true(z.refused > z.tried / 3);
        assert_int_not_equal(access("pwned", F_OK), 0);
    }
    free(path);
}

/* The words of every document in the place of a command of gnuplot, a shell or a page, and all programs
 * there. */
static void replace_words(json_t *at)
{
    static const char *const kept[] = {
        "name", "script", "unit", "key", "status", "outcome", "file", "kind"
    };
    json_t *v;
    const char *key;
    size_t i;
    json_array_foreach(at, i, v) replace_words(v);
    json_object_foreach(at, key, v)
    {
        bool keep = !json_is_string(v);
        for (size_t k = 0; k < sizeof kept / sizeof *kept; k++) keep = keep || !strcmp(key, kept[k]);
        /* names of species, but not of schemas and figures */
        if (!strcmp(key, "name") && json_object_get(at, "latin")) keep = !json_is_string(v);
        if (keep)
            replace_words(v);
        else
            json_string_set(v, "'`touch pwned`]]><script>&#x41;{1}\xef\xbf\xbe\x1b|<@%s");
    }
}

static void words_are_never_run(void **state)
{
    (void)state;
    if (!tools()) skip();
    make_folders();
    char *path = strdup(getenv("PATH")), before[4096];
    snprintf(before, sizeof before, "%s:%s", printer, path);
    setenv("PATH", before, 1);
    for (size_t i = 0; i < KINDS; i++) {
        char folder[256], file[300];
        struct wf_arena arena = { 0 };
        struct wf_diag d = { .arena = &arena };
        struct wf_err e = { 0 };
        snprintf(folder, sizeof folder, "%s/%s", scratch, kinds[i].folder);
        snprintf(file, sizeof file, "%s/results.json", folder);
        json_t *document = json_load_file(file, 0, NULL);
        replace_words(document);
        assert_int_equal(json_dump_file(document, file, 0), 0);
        json_decref(document);
        struct wf_printer pdf = { 0 };
        enum wf_status s = wf_report_make(folder, &(struct wf_page_style){ .language = "zh" }, &pdf, &d, &e);
        wf_printer_close(&pdf);
        /* a word that stands for a sentence may be unknown */
        if (s && !(s == WF_EOUTPUT && strstr(e.text, "no string"))) fail_msg("%s: %s", file, e.text);
        wf_arena_free(&arena);
        assert_int_not_equal(access("pwned", F_OK), 0);
    }
    setenv("PATH", path, 1);
    free(path);
    check_printed();
    if (!shell("find $T . -maxdepth 3 -name 'pwned*' | grep .")) fail_msg("%s", output);
}

/* Files of a folder that are no tables, or would be run by those who load them. */
static void tables_are_data(void **state)
{
    (void)state;
    static const struct {
        const char *file, *text, *said;
    } rows[] = {
        { "tables/summary.csv", "tree,`touch pwned`\n1,2\n", "csv:1: the line is not a head of plain names" },
        { "tables/summary.csv", "a,b\n1,2\n1,2,3\n", "csv:3: the line has another number of cells" },
        { "tables/summary.csv", "a,b\n1,\x1b\n", "csv:2: the line holds a control character" },
        { "tables/summary.csv", "a,b\n1,\xff\n", "csv:2: the line is not UTF-8" },
        { "tables/summary.csv", "a,b\n1,\"x\n\n", "a quote is not closed" },
        { "tables/more.csv", "a b\n", "more.csv:1: the line is not a head" },
        { "plots/run.csv", "key,index,value\nLEVELS,0\n", "run.csv:2: the line has another number" },
        { "plots/tree.dat", "1 2\nsystem('touch pwned')\n", "tree.dat:2: the line is not a row of numbers" },
    };
    char folder[256], path[400];
    make_folders();
    snprintf(folder, sizeof folder, "%s/report", scratch);
    char keep[1000];
    snprintf(keep, sizeof keep, "cp -r %s %s/kept", folder, scratch);
    assert_int_equal(system(keep), 0);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        struct wf_err e = { 0 };
        char command[1000];
        assert_int_equal(wf_tables_check(folder, &e), WF_OK);
        snprintf(command, sizeof command, "mkdir -p %s/plots", folder);
        assert_int_equal(system(command), 0);
        snprintf(path, sizeof path, "%s/%s", folder, rows[i].file);
        FILE *f = fopen(path, "w");
        assert_non_null(f);
        fputs(rows[i].text, f);
        fclose(f);
        assert_int_equal(wf_tables_check(folder, &e), WF_EINPUT);
        if (!strstr(e.text, rows[i].said)) fail_msg("%s", e.text);
        snprintf(command, sizeof command, "rm -r %s; cp -r %s/kept %s", folder, scratch, folder);
        assert_int_equal(system(command), 0);
    }
}

/* Names of folders, files, species, models, runs, titles; every command draws all it draws for plain ones. */
static void nasty_names(void **state)
{
    (void)state;
    static const char *const names[] = {
        "'Lombardy' poplar",
        "''",
        "<touch pwned",
        "|touch pwned",
        "$(touch pwned)",
        "`touch pwned`",
        "-x",
        "http:x",
        "a\\\"b",
        "]]>&#x41;",
        "@pwned %s {1} ^_~",
        "\\x1b[31m\\uFFFE\\u202e",
        "A very long name indeed, with far more than eighty characters in it, of a poplar that nobody knows",
    };
    if (!tools()) skip();
    for (size_t i = 0; i < sizeof names / sizeof *names; i++) {
        char command[4096];
        snprintf(
            command, sizeof command,
            "cat >$T/name <<'END'\n%s\nEND\n"
            "root=$PWD; export WINDFIRM_SHARE=$root; case $W in /*) ;; *) W=$root/$W; esac\n"
            "cd $T; n=$(cat name); mkdir -p work; cd work\n"
            "awk -v n=\"$(sed 's/\\\\/\\\\\\\\/g' ../name)\" '/^name:/ { print \"name: \\\"\" n \"\\\"\"; "
            "next } "
            "{ print }' $root/species/oak.yaml >\"./$n s.yaml\"\n"
            "awk -v n=\"$(sed 's/\\\\/\\\\\\\\/g' ../name)\" '/^name:/ { print \"name: \\\"\" n \"\\\"\"; "
            "next } "
            "{ print }' $root/models/culm.yaml >\"./$n m.yaml\"\n"
            "%s\n$W analyze \"./$n s.yaml\" --model \"./$n m.yaml\" --wind 10 -q --no-report \"--output=$n\" "
            "|| "
            "echo FAILED\n"
            "PATH=$PRINTER:$PATH; $W report \"./$n\" --lang zh -q || echo FAILED\n"
            "ls \"./$n\"/plots/*.svg \"./$n\"/report.pdf | wc -l\n"
            "find .. $root -maxdepth 2 -name 'pwned*'; true",
            names[i], i % 11 ? "PATH=$PRINTER:$PATH" : "");
        int code = shell(command);
        if (code || strcmp(output, "6\n")) fail_msg("%s: code %d: %s", names[i], code, output);
    }
    check_printed();
}

/* Every wrong value is named, with its place. */
static void wrong_values_are_named(void **state)
{
    (void)state;
    static const char text[] = "{\"schema\": {\"name\": \"windfirm-results\"}, \"trees\": [{\"segments\": "
                               "\"`x`43\", \"height\": {\"value\": 1.5e200}, \"unknown\": "
                               "true}], \"title\": 5, \"seed\": -1}";
    char path[256];
    struct wf_arena arena = { 0 };
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { 0 };
    json_t *out;
    if (shell("true")) fail_msg("%s", output);
    snprintf(path, sizeof path, "%s/results.json", scratch);
    FILE *f = fopen(path, "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    assert_int_equal(wf_document_read(path, &out, &d, &e), WF_EINPUT);
    assert_null(out);
    assert_int_equal(d.errors, 4);
    assert_string_equal(d.first->text, "trees[0].segments: \"`x`43\" is not a count");
    assert_string_equal(d.first->next->text, "trees[0].height.value: 1.5e200 is not a number up to 1e100");
    wf_arena_free(&arena);
}

/* A wrong value in a folder is an error with its file, also where warnings are not printed. */
static void wrong_values_are_errors(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W analyze oak $RUN -q >/dev/null; sed -i '0,/\"segments\": [0-9]*/s//\"segments\": \"`x`43\"/' "
          "$T/out/results.json; $W report $T/out -q",
          CODE_INPUT,
          { ".scratch/out/results.json: error: trees[0].model.segments: \"`x`43\" is not a count",
            "results.json: 1 value is not of the form that windfirm writes" } },
    };
    CHECK(rows);
}

/* What acts on a terminal is shown. */
static void nothing_acts_on_a_terminal(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "$W \"$(printf 'x\\033[31m')\"", CODE_INPUT, { "unknown command 'x\\x1b[31m'" } },
        { "$W analyze \"$(printf '\\033]0;x\\007\\377')\" $M --wind 10",
          CODE_INPUT,
          { "\\x1b]0;x\\x07\\xff" } },
        { "sed 's/^name:.*/name: \"a\\\\e[31mb\\\\u202ec\"/' species/oak.yaml >$T/s.yaml; $W analyze "
          "$T/s.yaml $RUN",
          CODE_OK,
          { "a\\x1b[31mb\\u202ec" } },
        { "$W analyze oak $M --wind \"$(printf '\\033[2J')\"", CODE_INPUT, { "\\x1b[2J" } },
        { "$W report \"$(printf '/no\\033where')\"", CODE_INPUT, { "/no\\x1bwhere" } },
        /* a line end in a name makes no line, whatever other control characters are in it */
        { "$W analyze \"$(printf 'a\\nwindfirm: safe')\" $M --wind 10",
          CODE_INPUT,
          { "a\\x0awindfirm: safe" } },
        { "$W oak\"$(printf '\\nb\\001\\002')\"", CODE_INPUT, { "oak\\x0ab\\x01\\x02'" } },
        { "d=\"$(printf '%s/a\\nb' \"$T\")\"; $W analyze oak $M --wind 10 --no-report -o \"$d\"; echo mine "
          ">\"$d/report.html\"; $W analyze oak $M --wind 10 -q -o \"$d\"",
          CODE_RUN,
          { "Results and tables: ", "/a\\x0ab\n", "a\\x0ab/report.html: no run of windfirm made it" } },
        { "$W schema model", CODE_OK, { "\n\nKeys:\n" } },
    };
    CHECK(rows);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        shell(rows[i].command);
        assert_null(strpbrk(output, "\x1b\x07\x7f"));
    }
}

/* A pipe with a name is not waited for without end when no program has its other end open; one that comes
 * late or is slow is waited for. */
static void pipes_end(void **state)
{
    (void)state;
    static const struct row rows[] = {
        { "mkfifo $T/in $T/out.csv; timeout 60 $W tree info $T/in & timeout 60 $W import $D/plain.csv -q -o "
          "$T/out.csv; "
          "echo $?; wait $!; echo $?",
          CODE_OK,
          { "/in: is a pipe that no program writes to (waited 10 s)",
            "/out.csv: is a pipe that no program reads (waited 10 s)", "1\n", "2\n" } },
        { "mkfifo $T/m.yaml; { sleep 1; exec >$T/m.yaml; sleep 1; head -n 5 models/culm.yaml; sleep 1; tail "
          "-n +6 models/culm.yaml; } & $W analyze oak --model $T/m.yaml --wind 10 -q --no-report -o $T/a && "
          "$W "
          "analyze oak --model models/culm.yaml --wind 10 -q --no-report -o $T/b && cmp "
          "$T/a/tables/sweep.csv "
          "$T/b/tables/sweep.csv && echo same",
          CODE_OK,
          { "same\n" } },
        { "mkfifo $T/in; { sleep 1; : >$T/in; } & $W tree info $T/in",
          CODE_INPUT,
          { "in: the file is empty" } },
        { "true | { sleep 1; $W tree info /dev/stdin; }", CODE_INPUT, { "the file is empty" } },
        { "mkfifo $T/out.csv; { sleep 1; cat $T/out.csv | head -n 1; } & $W import $D/plain.csv -q -o "
          "$T/out.csv; wait",
          CODE_OK,
          { "," } },
    };
    CHECK(rows);
}

/* The other commands: a nasty name for the run, the study or the test, and for the folder; all figures and a
 * page. */
static void nasty_names_of_other_commands(void **state)
{
    (void)state;
    static const struct {
        const char *page, *command;
    } rows[] = {
        { "calibration",
          "sed \"s|^name:.*|name: '$N'|; s|sample_pine.yaml|$PWD/models/field/sample_pine.yaml|; "
          "s|data/sample|$PWD/models/field/data/sample|\" models/field/sample_pull.yaml >\"$T/$F.yaml\"; "
          "$W fit \"$T/$F.yaml\" --no-profile --no-rival" },
        { "series",
          "sed \"s|^name:.*|name: '$N'|\" species/oak.yaml >\"$T/$F.yaml\"; $W series \"$T/$F.yaml\" $M "
          "--wind 8 --duration 1 --step 0.5 --gust cosine --no-vtk --keys 2" },
        { "explain",
          "sed \"s|^name:.*|name: '$N'|\" species/oak.yaml >\"$T/$F.yaml\"; $W explain \"$T/$F.yaml\" $M "
          "--wind 8" },
        { "modes",
          "sed \"s|^name:.*|name: '$N'|\" species/oak.yaml >\"$T/$F.yaml\"; $W modes \"$T/$F.yaml\" $M "
          "--wind 0,8" },
        { "shelter",
          "sed \"s|^name:.*|name: '$N'|\" species/scots_pine.yaml >\"$T/$F.yaml\"; $W shelter --model "
          "scots_pine --species \"$T/$F.yaml\" --slabs 4 --cells 16" },
        { "rose", "{ echo direction_deg,frequency,weibull_scale_ms,weibull_shape; for d in 0 45 90 135 180 "
                  "225 270 315; do echo "
                  "$d,1,6,2; done; } >\"$T/$F.csv\"; $W wind rose --file \"$T/$F.csv\"" },
        { "wind", "$W wind cosine --duration 60" },
    };
    if (!tools()) skip();
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++) {
        char command[4096];
        snprintf(
            command, sizeof command,
            "N='Pyramid \"`touch pwned`]]>&#x41; <b> %%s {1} and many more words, so that it is long'; F='a "
            "$(touch pwned)"
            " \"b; c`x'; %s -q -o \"$T/<touch pwned|\" || echo FAILED; f=\"$T/<touch pwned|/%s\"; head -c 4 "
            "\"$f.pdf\"; tail -c 6 \"$f.pdf\"; grep -q 'class=\"missing\"' \"$f.html\" && echo missing; grep "
            "-c "
            "'<figure' \"$f.html\" | grep -v '^0$' >/dev/null || echo no figure; ls -d pwned* $T/pwned* "
            "2>/dev/null; true",
            rows[i].command, rows[i].page);
        int code = shell(command);
        if (code || strcmp(output, "%PDF%%EOF\n")) fail_msg("%s: code %d: %s", rows[i].page, code, output);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_leaf_of_every_document),
        cmocka_unit_test(words_are_never_run),
        cmocka_unit_test(tables_are_data),
        cmocka_unit_test(wrong_values_are_named),
        cmocka_unit_test(wrong_values_are_errors),
        cmocka_unit_test(nasty_names),
        cmocka_unit_test(nasty_names_of_other_commands),
        cmocka_unit_test(nothing_acts_on_a_terminal),
        cmocka_unit_test(pipes_end),
    };
    return cmocka_run_group_tests(tests, make_printer, remove_printer);
}
