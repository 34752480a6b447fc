/* Study files: the options of a command as keys of a YAML file, so that an analysis can be kept, sent and run
 * again. One file serves several commands: each takes the keys that are options of its own and says which it
 * left. */
#include "base/file.h"
#include "base/yaml.h"
#include "cmd/args.h"
#include "cmd/study_file.h"
#include <string.h>
#include <unistd.h>

enum { KEYS_MAX = 150 };

/* Commands that take a study file. */
static const struct taker {
    const char *command;
    const struct wf_option *option;
    const char *subject; /* key that stands for its operands; NULL: none */
} takers[] = {
    { "analyze", wf_study_options, "species" },
    { "compare", wf_study_options, "species" },
    { "explain", wf_explain_options, "species" },
    { "series", wf_series_options, "species" },
    { "shelter", wf_shelter_options, NULL },
    { "wind", wf_wind_options, "gust" },
    { 0 },
};

/* The keys a study file may have: those of all commands that take one. */
struct book {
    struct wf_reading *reading;
    const struct taker *taker;
    const char *file;
    size_t keys;
    struct wf_yaml_row row[KEYS_MAX + 1]; /* ends at key == NULL */
    const char *value[KEYS_MAX];
    bool used[KEYS_MAX];
};

static size_t find(const struct book *b, const char *key)
{
    size_t k = 0;
    while (k < b->keys && strcmp(b->row[k].key, key) != 0) k++;
    return k;
}

static void add(struct book *b, struct wf_yaml_row row)
{
    size_t k = find(b, row.key);
    if (k < b->keys || k == KEYS_MAX) return;
    row.offset = offsetof(struct book, value) + k * sizeof b->value[0];
    b->row[k] = row;
    b->keys++;
}

/* "--root-stiffness" as a key: root_stiffness. Returned: text in the arena, NULL without room. */
static const char *key_of(const struct wf_option *o, struct wf_arena *a)
{
    char *key = wf_arena_text(a, o->name + 2);
    for (char *p = key; p && *p; p++)
        if (*p == '-') *p = '_';
    return key;
}

/* What an option means, with range and default, and whose it is; for the printed schema. */
static const char *doc_of(const struct wf_option *o, struct wf_arena *a)
{
    char text[1024] = "";
    FILE *to = fmemopen(text, sizeof text, "w");
    if (!to) return NULL;
    wf_option_text(o, to);
    fputs(" -", to);
    for (const struct taker *c = takers; c->command; c++)
        for (const struct wf_option *p = c->option; p && p->name; p++)
            if (!strcmp(p->name, o->name)) fprintf(to, " %s", c->command);
    fclose(to);
    return wf_arena_text(a, text);
}

static bool fill(struct book *b, struct wf_arena *a)
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
          .doc = "species tables, files or names of shipped ones - analyze compare explain series shelter",
          .example = "moso_bamboo" },
        { .key = "gust",
          .kind = WF_YAML_JOINED,
          .doc = "gust model, a row of 'windfirm wind list' - series wind",
          .example = "kaimal" },
    };
    for (size_t i = 0; i < sizeof first / sizeof *first; i++) add(b, first[i]);
    for (const struct taker *c = takers; c->command; c++)
        for (const struct wf_option *o = c->option; o->name; o++) {
            const char *key = key_of(o, a), *doc = b->reading ? o->help : doc_of(o, a);
            if (!key || !doc) return false;
            if (strcmp(key, "study") != 0)
                add(b, (struct wf_yaml_row){ .key = key, .kind = WF_YAML_JOINED, .doc = doc });
        }
    return true;
}

static bool names_file(const struct wf_option *o)
{
    static const char *const value[] = { "FILE", "MODEL", "SPECIES" };
    for (size_t i = 0; i < sizeof value / sizeof *value; i++)
        if (o->kind == WF_OPTION_TEXT && !strcmp(o->value, value[i])) return true;
    return false;
}

static void flag(struct wf_reading *r, size_t k, const char *text)
{
    static const char *const word[] = { "yes", "true", "no", "false" };
    size_t i = 0;
    while (i < 4 && strcmp(text, word[i]) != 0) i++;
    if (i == 4) wf_args_mistake(r, "", "'%.60s' is neither yes nor no", text);
    r->out->given[k] = i < 2;
}

static void operands(struct book *b, const char *list)
{
    struct wf_args *out = b->reading->out;
    char *rest = NULL, *text = wf_arena_text(b->reading->arena, list);
    const char **operand = WF_TAKE(b->reading->arena, strlen(list) + 1, const char *);
    if (!text || !operand) {
        wf_args_mistake(b->reading, "", "out of memory");
        return;
    }
    for (char *w = strtok_r(text, ",", &rest); w; w = strtok_r(NULL, ",", &rest)) {
        w += strspn(w, " ");
        operand[out->n++] =
            b->taker->option == wf_wind_options ? w : wf_beside(b->file, w, b->reading->arena);
    }
    out->operand = operand;
}

/* Whether the command line gives an option; asked before the file's values are taken. */
static bool typed(const struct book *b, const char *name)
{
    for (size_t k = 0; k < b->reading->options; k++)
        if (!strcmp(b->reading->out->option[k].name, name)) return b->reading->out->given[k];
    return false;
}

/* Called by the reader behind the keys, where mistakes still know their line. */
static void apply(struct wf_yaml *y, void *book)
{
    struct book *b = book;
    struct wf_reading *r = b->reading;
    const char *subject = b->taker->subject;
    bool wind = typed(b, "--wind");
    r->yaml = y;
    for (size_t k = 0; k < r->options; k++) {
        const struct wf_option *o = &r->out->option[k];
        r->key = key_of(o, r->arena);
        size_t at = r->key ? find(b, r->key) : b->keys;
        if (at == b->keys || !b->value[at]) continue;
        b->used[at] = true;
        if (r->out->given[k]) continue;
        r->out->given[k] = true;
        if (o->kind == WF_OPTION_FLAG)
            flag(r, k, b->value[at]);
        else
            wf_args_value(r, k, names_file(o) ? wf_beside(b->file, b->value[at], r->arena) : b->value[at]);
    }
    size_t at = subject ? find(b, subject) : b->keys;
    if (at < b->keys && b->value[at]) {
        b->used[at] = true;
        r->key = subject;
        if (!r->out->n) operands(b, b->value[at]);
    }
    r->key = "wind";
    if ((at = find(b, r->key)) == b->keys || !b->value[at] || wind) r->yaml = NULL;
    wf_args_complete(r);
    r->yaml = NULL;
}

/* Keys that this command has no use for: they belong to others. */
static void tell_left(const struct book *b)
{
    const char *all = "";
    for (size_t k = 2; k < b->keys && all; k++)
        if (b->value[k] && !b->used[k])
            all = wf_arena_print(b->reading->arena, "%s%s%s", all, *all ? ", " : "", b->row[k].key);
    if (all && *all) fprintf(stderr, "%s: not used by '%s': %s\n", b->file, b->reading->command, all);
}

static struct book *open_book(struct wf_reading *r, struct wf_arena *a)
{
    struct book *b = WF_TAKE(a, 1, struct book);
    if (!b) return NULL;
    b->reading = r;
    if (!fill(b, a)) return NULL;
    b->taker = takers;
    while (r && b->taker->command && strcmp(b->taker->command, r->command) != 0) b->taker++;
    return b;
}

static const struct wf_yaml_table plain = {
    .title = "a study",
    .doc =
        "A study: the options of a command as keys, so that an analysis can be kept and run again. Every "
        "option of analyze, compare, explain, series, shelter and wind is a key, with '_' for '-'; a flag is "
        "yes or no; a list is written [10, 15, 25]. What is typed comes before what the file says. Files are "
        "looked for beside the study first.",
    .finish = apply,
};

/* Whether a file begins with the key of a study. */
static bool is_study(const char *path, struct wf_arena *a)
{
    struct wf_bytes text;
    struct wf_err e = { 0 };
    if (access(path, R_OK) || wf_file_read_text(path, a, &text, &e)) return false;
    for (const char *p = text.data; p && *p; p = strchr(p, '\n') ? strchr(p, '\n') + 1 : NULL)
        if (*p != '#' && *p != '\n' && *p != '\r') return strncmp(p, "study:", 6) == 0;
    return false;
}

static const char *study_of(struct wf_reading *r)
{
    size_t k = 0;
    while (k < r->options && strcmp(r->out->option[k].name, "--study") != 0) k++;
    if (k == r->options) return NULL;
    if (!r->out->text[k] && r->out->n == 1 && is_study(r->out->operand[0], r->arena)) {
        r->out->text[k] = r->out->operand[0];
        r->out->given[k] = true;
        r->out->n = 0;
    }
    return r->out->text[k];
}

void wf_args_study(struct wf_reading *r)
{
    struct wf_diag d = { .arena = r->arena };
    struct wf_err e = { 0 };
    struct wf_yaml_table table = plain;
    const char *path = study_of(r);
    if (!path) return;
    struct book *b = open_book(r, r->arena);
    if (!b) {
        wf_args_mistake(r, "--study", "out of memory");
        return;
    }
    b->file = path;
    table.row = b->row;
    size_t before = r->mistakes;
    enum wf_status s = wf_yaml_read(path, &table, b, r->arena, &d, &e);
    wf_print_findings(&d, false);
    if (s && !d.errors) wf_args_mistake(r, "--study", "%s", e.text);
    if (s && r->mistakes == before) r->mistakes += d.errors;
    bool quiet = false;
    for (size_t k = 0; k < r->options; k++)
        quiet = quiet || (r->out->given[k] && !strcmp(r->out->option[k].name, "--quiet"));
    if (!s && !quiet) tell_left(b);
}

char *wf_study_file_schema(struct wf_arena *a, struct wf_err *e)
{
    struct wf_yaml_table table = plain;
    struct book *b = open_book(NULL, a);
    if (!b) return (void)wf_fail(e, WF_ENOMEM, "no room for the keys of a study"), NULL;
    table.row = b->row;
    return wf_yaml_schema(&table, a, e);
}
