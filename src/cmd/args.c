/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Reads a command line into an options struct: options and operands as typed, study files. */
#include "cmd/args.h"
#include "base/file.h"
#include "base/text.h"
#include "base/yaml.h"
#include "cmd/commands.h"
#include "cmd/usage.h"
#include "cmd/wind_speed.h"
#include <string.h>
#include <unistd.h>

/* ---- Options and operands as typed ---- */

static bool is_named(const struct wf_option *o, const char *word, size_t length)
{
    return (strlen(o->name) == length && strncmp(o->name, word, length) == 0) ||
           (o->letter && strlen(o->letter) == length && strncmp(o->letter, word, length) == 0);
}

static void unknown_option(struct wf_reading *r, const char *word, size_t length)
{
    const char *known[WF_OPTIONS_MAX + 1] = { 0 };
    char typed[64];
    size_t n = 0;
    snprintf(typed, sizeof typed, "%.*s", (int)length, word);
    for (; n < r->options; n++) known[n] = r->args->option[n].name;
    known[n++] = "--help";
    struct wf_hint hint = wf_did_you_mean(typed, known, n);
    wf_option_mistake(r, NULL, "", "unknown option '%s'%s", typed,
                      *hint.text ? hint.text : "; 'windfirm COMMAND --help' lists them");
}

/* Is the argument behind a flag a value, and no operand? */
static bool is_yes_or_no(const char *word)
{
    return word && wf_text_among("yes no true false on off ja nein oui non 是 否 1 0", word) &&
           !wf_file_is_there(word);
}

/* The argument at argv[i], an option; returned: how many arguments it took. */
static int read_option(struct wf_reading *r, int argc, char **argv, int i)
{
    const char *word = argv[i], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word), k = 0;
    while (k < r->options && !is_named(&r->args->option[k], word, length)) k++;
    if (k == r->options) {
        unknown_option(r, word, length);
        return 1;
    }
    const struct wf_option *o = &r->args->option[k];
    const char *value = equals ? equals + 1 : i + 1 < argc ? argv[i + 1] : NULL;
    if (r->args->given[k] && o->kind != WF_OPTION_TEXTS) wf_option_mistake(r, NULL, o->name, "given twice");
    r->args->given[k] = true;
    if (o->kind == WF_OPTION_FLAG) {
        bool answered = !equals && is_yes_or_no(value);
        if (equals) wf_option_mistake(r, NULL, o->name, "takes no value");
        if (answered)
            wf_option_mistake(r, NULL, o->name,
                              "takes no value: write %s alone, or leave it out; not '%.20s'", o->name, value);
        wf_option_take(r, k, "yes");
        return answered ? 2 : 1;
    }
    /* "--wind -o out": the value was forgotten; "--azimuth -90" and "-o -" are values */
    bool forgotten = value && !equals && strncmp(value, "--", 2) == 0;
    for (size_t j = 0; value && !equals && j < r->options; j++)
        forgotten = forgotten || (r->args->option[j].letter && strcmp(value, r->args->option[j].letter) == 0);
    if (!value || forgotten || !*value) {
        wf_option_mistake(r, NULL, o->name, "needs a value: %s %s", o->name, o->value);
        return value && !forgotten && !equals ? 2 : 1;
    }
    wf_option_take(r, k, value);
    return equals ? 1 : 2;
}

static void check_operands(struct wf_reading *r, size_t low, size_t high)
{
    if (r->args->n < low)
        wf_option_mistake(r, NULL, "", "%zu argument%s needed, %zu given", low, low == 1 ? " is" : "s are",
                          r->args->n);
    if (r->args->n > high)
        wf_option_mistake(r, NULL, "", "at most %zu argument%s taken; '%s' is too many", high,
                          high == 1 ? " is" : "s are", r->args->operand[high]);
}

/* Refuse options that have no effect beside the others: whoever gives one believes that it has. */
static void refuse_unused(struct wf_reading *r)
{
    char why[WF_WHY];
    for (size_t k = 0; k < r->options; k++) {
        const struct wf_option *o = &r->args->option[k];
        if (r->args->given[k] && o->unused && o->unused(r->args, o, why))
            wf_option_mistake(r, r->key[k], o->name, "has no effect %s", why);
    }
}

static void refuse_wrong(struct wf_reading *r)
{
    char why[WF_WHY];
    for (size_t k = 0; k < r->options; k++) {
        const struct wf_option *o = &r->args->option[k];
        if (o->wrong && !r->failed[k] && o->wrong(r->args, o, why))
            wf_option_mistake(r, r->key[k], o->name, "%s", why);
    }
}

/* Defaults of what was not given, then the winds, which depend on other options. Called by the study file's
 * reader while mistakes about keys still know their line, else at the end; a second call does nothing. */
static void complete(struct wf_reading *r)
{
    const struct wf_args *out = r->args;
    if (r->complete) return;
    r->complete = true;
    for (size_t k = 0; k < r->options; k++)
        if (!out->given[k] && out->option[k].initial) wf_option_take(r, k, out->option[k].initial);
    wf_winds_read(r);
    refuse_wrong(r);
    if (!r->mistakes) refuse_unused(r);
}

/* ---- Study files ----
 * The options of a command as keys of a YAML file, so that an analysis can be saved, shared and repeated. One
 * file serves several commands: each takes the keys that are options of its own and lists the others. */

enum { KEYS_MAX = 400 };

/* Commands that take a study file. */
static const struct taker {
    const char *command;
    const struct wf_option *option;
    const char *subject; /* key that stands for its operands; NULL: none */
    bool files;          /* operands may name files beside the study file */
} takers[] = {
    { "analyze", wf_analyze_options, "species", true }, { "compare", wf_analyze_options, "species", true },
    { "explain", wf_explain_options, "species", true }, { "modes", wf_modes_options, "species", true },
    { "series", wf_series_options, "species", true },   { "shelter", wf_shelter_options, NULL, false },
    { "wind", wf_wind_options, "gust", false },         { 0 },
};

/* The keys a study file may have: those of all commands that take one; or a card, those of `assess` alone. */
struct study_keys {
    struct wf_reading *reading;
    const struct taker *taker;
    struct taker own[2]; /* of a command that is not in the list; ends at command == NULL */
    const char *file;
    size_t keys;
    struct wf_yaml_row row[KEYS_MAX + 1]; /* ends at key == NULL */
    const char *value[KEYS_MAX];
    bool used[KEYS_MAX];
};

static size_t find_key(const struct study_keys *b, const char *key)
{
    size_t k = 0;
    while (k < b->keys && strcmp(b->row[k].key, key) != 0) k++;
    return k;
}

/* Returned: is there room for it? */
static bool add_key(struct study_keys *b, struct wf_yaml_row row)
{
    size_t k = find_key(b, row.key);
    if (k < b->keys) return true;
    if (k == KEYS_MAX) return false;
    row.offset = offsetof(struct study_keys, value) + k * sizeof b->value[0];
    b->row[k] = row;
    b->keys++;
    return true;
}

/* "--root-stiffness" as a key: root_stiffness. Returned: text in the arena, NULL without memory. */
static const char *key_of(const struct wf_option *o, struct wf_arena *a)
{
    char *key = wf_arena_text(a, o->name + 2);
    for (char *p = key; p && *p; p++)
        if (*p == '-') *p = '_';
    return key;
}

/* What an option means, with range and default, and which commands have it; for the printed schema. */
static const char *doc_of(const struct wf_option *o, struct wf_arena *a)
{
    char what[WF_OPTION_DOC];
    wf_option_text(o, what);
    char *text = wf_arena_print(a, "%s -", what);
    for (const struct taker *c = takers; c->command; c++)
        for (const struct wf_option *p = c->option; text && p && p->name; p++)
            if (!strcmp(p->name, o->name)) text = wf_arena_print(a, "%s %s", text, c->command);
    return text;
}

static bool fill_keys(struct study_keys *b, struct wf_arena *a)
{
    static const struct wf_yaml_row first[] = {
        { .key = "study",
          .kind = WF_YAML_TEXT,
          .required = true,
          .doc = "name of the study",
          .example = "storm" },
        { .key = "note", .kind = WF_YAML_TEXT, .doc = "in words, for the reader" },
        { .key = "species",
          .kind = WF_YAML_JOINED,
          .doc =
              "species tables, files or names of shipped ones - analyze compare explain modes series shelter",
          .example = "moso_bamboo" },
        { .key = "gust",
          .kind = WF_YAML_JOINED,
          .doc = "gust model, a name from 'windfirm wind list' - series wind",
          .example = "kaimal" },
    };
    for (size_t i = 0; i < sizeof first / sizeof *first && b->taker != b->own; i++)
        (void)add_key(b, first[i]);
    for (const struct taker *c = b->taker == b->own ? b->own : takers; c->command; c++)
        for (const struct wf_option *o = c->option; o->name; o++) {
            const char *key = key_of(o, a), *doc = b->reading ? o->help : doc_of(o, a);
            if (!key || !doc) return false;
            if (strcmp(key, "study") != 0 &&
                !add_key(b, (struct wf_yaml_row){ .key = key, .kind = WF_YAML_JOINED, .doc = doc }))
                return false;
        }
    return true;
}

static void take_operands(struct study_keys *b, const char *list)
{
    struct wf_args *out = b->reading->args;
    char *rest = wf_arena_text(b->reading->arena, list);
    const char **operand = WF_TAKE(b->reading->arena, strlen(list) + 1, const char *);
    if (!rest || !operand) {
        wf_option_mistake(b->reading, b->taker->subject, "", "out of memory");
        return;
    }
    for (char *w; (w = wf_list_item(&rest));) {
        if (!*w) wf_option_mistake(b->reading, b->taker->subject, "", "an item of the list is empty");
        operand[out->n++] = b->taker->files ? wf_beside(b->file, w, b->reading->arena) : w;
    }
    out->operand = operand;
}

/* The value of row k from the study file. A typed value takes precedence. */
static void take_key(struct study_keys *b, size_t k)
{
    struct wf_reading *r = b->reading;
    const struct wf_option *o = &r->args->option[k];
    const char *key = o->kind == WF_OPTION_STUDY ? NULL : key_of(o, r->arena);
    size_t at = key ? find_key(b, key) : b->keys;
    if (at == b->keys || !b->value[at]) return;
    b->used[at] = true;
    if (r->args->given[k]) return;
    r->args->given[k] = true;
    r->key[k] = key;
    wf_option_take(r, k,
                   o->kind == WF_OPTION_PATH ? wf_beside(b->file, b->value[at], r->arena) : b->value[at]);
}

/* The YAML reader's `finish` hook: called when all keys are read, while mistakes still know their line. */
static void apply_keys(struct wf_yaml *y, void *keys)
{
    struct study_keys *b = keys;
    struct wf_reading *r = b->reading;
    const char *subject = b->taker->subject;
    r->yaml = y;
    size_t lang = find_key(b, "lang"); /* mistakes of the file are in it too */
    if (lang < b->keys && b->value[lang] && !strcmp(b->value[lang], "zh")) wf_show_language("zh");
    for (size_t k = 0; k < r->options; k++) take_key(b, k);
    size_t at = subject ? find_key(b, subject) : b->keys;
    if (at < b->keys && b->value[at]) {
        b->used[at] = true;
        if (!r->args->n) take_operands(b, b->value[at]);
    }
    complete(r);
    r->yaml = NULL;
}

/* Warn about keys that belong to other commands. */
static void warn_of_unused(const struct study_keys *b)
{
    const char *all = "";
    for (size_t k = 2; k < b->keys && all; k++)
        if (b->value[k] && !b->used[k])
            all = wf_arena_print(b->reading->arena, "%s%s%s", all, *all ? ", " : "", b->row[k].key);
    if (all && *all) wf_show(stderr, "%s: not used by '%s': %s\n", b->file, b->reading->command, all);
}

static struct study_keys *open_study_keys(struct wf_reading *r, struct wf_arena *a)
{
    struct study_keys *b = WF_TAKE(a, 1, struct study_keys);
    if (!b) return NULL;
    b->reading = r;
    b->taker = takers;
    while (r && b->taker->command && strcmp(b->taker->command, r->command) != 0) b->taker++;
    if (!b->taker->command) {
        b->own[0] = (struct taker){ .command = r->command, .option = r->args->option };
        b->taker = b->own;
    }
    return fill_keys(b, a) ? b : NULL;
}

static const struct wf_yaml_table study_table = {
    .title = "a study",
    .doc =
        "A study: the options of a command as keys, so that an analysis can be kept and run again. Every "
        "option of analyze, compare, explain, series, shelter and wind is a key, with '_' for '-'; a flag is "
        "yes or no; a list is written [10, 15, 25]. The command line takes precedence over the file. Files "
        "are "
        "looked for beside the study first.",
    .finish = apply_keys,
};

/* The study file: that of --study, or the only operand when that is one. NULL: none. */
static const char *study_named(struct wf_reading *r)
{
    struct wf_args *out = r->args;
    size_t k = 0;
    while (k < r->options && out->option[k].kind != WF_OPTION_STUDY) k++;
    if (k == r->options) return NULL;
    const char *first = strcmp(r->command, "assess") ? "study:" : "card:";
    if (!out->study && out->n == 1 && wf_begins_with_key(out->operand[0], first, r->arena)) {
        out->study = out->operand[0];
        out->given[k] = true;
        out->n = 0;
    }
    return out->study;
}

/* Take options and operands that were not typed from the study file, where there is one. */
static void read_study(struct wf_reading *r)
{
    struct wf_diag d = { .arena = r->arena };
    struct wf_err e = { 0 };
    struct wf_yaml_table table = study_table;
    const char *path = study_named(r);
    if (!path) return;
    struct study_keys *b = open_study_keys(r, r->arena);
    if (!b) {
        wf_option_mistake(r, NULL, "--study", "out of memory");
        r->no_memory = true;
        return;
    }
    b->file = path;
    table.row = b->row;
    size_t before = r->mistakes;
    enum wf_status s = wf_yaml_read(path, &table, b, r->arena, &d, &e);
    wf_print_findings(&d, false);
    r->no_memory = r->no_memory || s == WF_ENOMEM;
    if (s && !d.errors) wf_option_mistake(r, NULL, "--study", "%s", e.text);
    if (s && r->mistakes == before) r->mistakes += d.errors;
    if (!s && !r->args->quiet) warn_of_unused(b);
}

const struct wf_yaml_table *wf_args_study_table(struct wf_arena *a)
{
    struct wf_yaml_table *table = WF_TAKE(a, 1, struct wf_yaml_table);
    struct study_keys *b = table ? open_study_keys(NULL, a) : NULL;
    if (!b) return NULL;
    *table = study_table;
    table->row = b->row;
    return table;
}

/* What is printed from here on is in the units of the row --units and the language of --lang, where the
 * command has them. */
static void set_units(const struct wf_args *args)
{
    for (size_t k = 0; args->option[k].name; k++)
        if (!strcmp(args->option[k].name, "--units") && args->text[k] && strcmp(args->text[k], "metric") != 0)
            wf_show_in(args->text[k]);
        else if (!strcmp(args->option[k].name, "--lang") && args->text[k])
            wf_show_language(args->text[k]);
}

/* ---- Command lines ---- */

int wf_args_read(int argc, char **argv, const struct wf_option *rows, const char *about, size_t low,
                 size_t high, struct wf_arena *a, struct wf_args *out)
{
    struct wf_reading r = { .args = out, .arena = a, .command = argv[0] };
    struct wf_err e = { 0 };
    bool end_of_options = false;
    *out = (struct wf_args){ .option = rows };
    for (; rows && rows[r.options].name; r.options++)
        if (!strcmp(rows[r.options].name, "--lang"))
            wf_usage_language(argc, argv); /* mistakes are in it too */
    wf_option_clear(&r);
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--") == 0) break;
        const struct wf_usage_form *form = wf_usage_form(argv[i]);
        if (form) {
            if (argv[i][0] == '-' && !strchr(argv[i], '=')) wf_usage_language(argc, argv);
            form->print(stdout, argv[0], rows, about);
            return 0;
        }
    }
    if (!(out->operand = WF_TAKE(a, (size_t)argc, const char *)))
        return wf_complain(&(struct wf_err){ WF_ENOMEM, "not enough memory for the command line" });
    if (wf_units_open(&r.units, &e)) return wf_complain(&e);
    for (int i = 1; i < argc;) {
        if (!end_of_options && strcmp(argv[i], "--") == 0) {
            end_of_options = true;
            i++;
        } else if (!end_of_options && argv[i][0] == '-' && argv[i][1]) {
            i += read_option(&r, argc, argv, i);
        } else {
            out->operand[out->n++] = argv[i++];
        }
    }
    read_study(&r);
    check_operands(&r, low, high);
    complete(&r);
    wf_units_close(r.units);
    if ((out->text = WF_TAKE(a, r.options + 1, const char *)))
        memcpy(out->text, r.text, r.options * sizeof *r.text);
    r.no_memory = r.no_memory || !out->text;
    if (!out->text) wf_option_mistake(&r, NULL, "", "out of memory");
    if (!r.mistakes) {
        if (out->winds_said && !out->quiet) wf_show(stderr, "%s\n", out->winds_said);
        set_units(out);
        wf_progress_start(out->quiet);
        return -1;
    }
    if (r.no_memory) return wf_exit_code(WF_ENOMEM);
    wf_show(stderr, "'windfirm %s --help' shows how it is used\n", argv[0]);
    return 2;
}

bool wf_args_read_cells(const struct wf_args *line, const char *command, const size_t *option,
                        const char *const *cell, size_t n, struct wf_units *units, struct wf_arena *a,
                        struct wf_args *out, struct wf_sink *sink)
{
    struct wf_reading r = { .args = out, .arena = a, .command = command, .units = units, .sink = sink };
    *sink = (struct wf_sink){ 0 };
    *out = (struct wf_args){ .option = line->option, .quiet = true };
    while (line->option[r.options].name) r.options++;
    wf_option_clear(&r);
    for (size_t i = 0; i < n; i++) {
        if (!*cell[i]) continue;
        if (out->given[option[i]])
            wf_option_mistake(&r, NULL, line->option[option[i]].name, "has two columns");
        out->given[option[i]] = true;
        wf_option_take(&r, option[i], cell[i]);
    }
    for (size_t k = 0; k < r.options; k++)
        if (!out->given[k] && line->given[k] &&
            line->text[k]) { /* an operand that is the study has no text */
            out->given[k] = true;
            wf_option_take(&r, k, line->text[k]);
        }
    complete(&r);
    return !r.mistakes;
}
