#include "base/num.h"
#include "base/text.h"
#include "base/yaml.h"
#include "cmd/wind_speed.h"
#include <math.h>
#include <stdarg.h>
#include <string.h>

void wf_args_mistake(struct wf_reading *r, const char *name, const char *fmt, ...)
{
    va_list list;
    char text[2048];
    va_start(list, fmt);
    vsnprintf(text, sizeof text, fmt, list);
    va_end(list);
    if (r->yaml)
        wf_yaml_error(r->yaml, r->key, "%s", text);
    else
        fprintf(stderr, "windfirm %s: %s%s%s\n", r->command, name, *name ? ": " : "", text);
    r->mistakes++;
}

static bool named(const struct wf_option *o, const char *word, size_t length)
{
    return (strlen(o->name) == length && strncmp(o->name, word, length) == 0) ||
           (o->letter && strlen(o->letter) == length && strncmp(o->letter, word, length) == 0);
}

static void unknown(struct wf_reading *r, const char *word, size_t length)
{
    const char *known[WF_OPTIONS_MAX + 1] = { 0 };
    char typed[64];
    size_t n = 0;
    snprintf(typed, sizeof typed, "%.*s", (int)length, word);
    for (; n < r->options; n++) known[n] = r->out->option[n].name;
    known[n++] = "--help";
    const char *near = wf_nearest(typed, known, n);
    wf_args_mistake(r, "", "unknown option '%s'%s%s%s", typed, near ? "; did you mean '" : "",
                    near ? near : "", near ? "'?" : "; 'windfirm COMMAND --help' lists them");
}

/* The argument at argv[i], an option; returned: how many arguments it took. */
static int option(struct wf_reading *r, int argc, char **argv, int i)
{
    const char *word = argv[i], *equals = strchr(word, '=');
    size_t length = equals ? (size_t)(equals - word) : strlen(word), k = 0;
    while (k < r->options && !named(&r->out->option[k], word, length)) k++;
    if (k == r->options) {
        unknown(r, word, length);
        return 1;
    }
    const struct wf_option *o = &r->out->option[k];
    const char *value = equals ? equals + 1 : i + 1 < argc ? argv[i + 1] : NULL;
    if (r->out->given[k] && o->kind != WF_OPTION_TEXTS) wf_args_mistake(r, o->name, "given twice");
    r->out->given[k] = true;
    if (o->kind == WF_OPTION_FLAG) {
        if (equals) wf_args_mistake(r, o->name, "takes no value");
        return 1;
    }
    /* "--wind -o out": the value was forgotten; "--azimuth -90" and "-o -" are values */
    bool forgotten = value && !equals && strncmp(value, "--", 2) == 0;
    for (size_t j = 0; value && !equals && j < r->options; j++)
        forgotten = forgotten || (r->out->option[j].letter && strcmp(value, r->out->option[j].letter) == 0);
    if (!value || forgotten || !*value) {
        wf_args_mistake(r, o->name, "needs a value: %s %s", o->name, o->value);
        return value && !forgotten && !equals ? 2 : 1;
    }
    wf_args_value(r, k, value);
    return equals ? 1 : 2;
}

static void operands_check(struct wf_reading *r, size_t low, size_t high)
{
    if (r->out->n < low)
        wf_args_mistake(r, "", "%zu argument%s needed, %zu given", low, low == 1 ? " is" : "s are",
                        r->out->n);
    if (r->out->n > high)
        wf_args_mistake(r, "", "at most %zu argument%s taken; '%s' is too many", high,
                        high == 1 ? " is" : "s are", r->out->operand[high]);
}

void wf_args_complete(struct wf_reading *r)
{
    const struct wf_args *out = r->out;
    if (r->complete) return;
    r->complete = true;
    for (size_t k = 0; k < r->options; k++)
        if (!out->given[k] && out->option[k].initial) wf_args_value(r, k, out->option[k].initial);
    wf_args_winds(r);
}

int wf_args_read(int argc, char **argv, const struct wf_option *rows, const char *about, size_t low,
                 size_t high, struct wf_arena *a, struct wf_args *out)
{
    struct wf_reading r = { .out = out, .arena = a, .command = argv[0] };
    struct wf_err e = { 0 };
    bool end_of_options = false;
    *out = (struct wf_args){ .option = rows };
    for (; rows && rows[r.options].name; r.options++) out->number[r.options] = NAN;
    for (int i = 1; i < argc; i++) {
        if (strcmp(argv[i], "--") == 0) break;
        if (strcmp(argv[i], "--help") == 0 || strcmp(argv[i], "-h") == 0) {
            wf_usage_print(stdout, argv[0], rows, about);
            return 0;
        }
    }
    if (!(out->operand = WF_TAKE(a, (size_t)argc, const char *)))
        return wf_complain(&(struct wf_err){ WF_ENOMEM, "no room for the command line" });
    if (wf_units_open(&r.units, &e)) return wf_complain(&e);
    for (int i = 1; i < argc;) {
        if (!end_of_options && strcmp(argv[i], "--") == 0) {
            end_of_options = true;
            i++;
        } else if (!end_of_options && argv[i][0] == '-' && argv[i][1]) {
            i += option(&r, argc, argv, i);
        } else {
            out->operand[out->n++] = argv[i++];
        }
    }
    wf_args_study(&r);
    operands_check(&r, low, high);
    wf_args_complete(&r);
    wf_units_close(r.units);
    if (!r.mistakes) {
        if (out->winds_said && !wf_args_given(out, "--quiet")) fprintf(stderr, "%s\n", out->winds_said);
        return -1;
    }
    fprintf(stderr, "'windfirm %s --help' shows how it is used\n", argv[0]);
    return 2;
}

static size_t row_named(const struct wf_args *g, const char *name)
{
    size_t k = 0;
    while (strcmp(g->option[k].name, name) != 0) k++;
    return k;
}

const char *wf_args_text(const struct wf_args *g, const char *name) { return g->text[row_named(g, name)]; }
double wf_args_number(const struct wf_args *g, const char *name) { return g->number[row_named(g, name)]; }
bool wf_args_given(const struct wf_args *g, const char *name) { return g->given[row_named(g, name)]; }
