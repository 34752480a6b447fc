/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/fitted_species.h"
#include "base/file.h"
#include "base/text.h"
#include "base/units.h"
#include "data/species.h"
#include "load/drag.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <yaml.h>

/* A table being written. A failure is kept, and seen once at the end. */
struct sheet {
    yaml_emitter_t emitter;
    bool failed;
    const struct wf_fit_results *of; /* NULL: a table as it is, without a fit */
    const char *source_key;          /* source key of the fitted values       */
    struct wf_units *units;
};

/* libyaml quotes and escapes what needs it. */

static void put(struct sheet *t, yaml_event_t *event, int made)
{
    if (made && t->failed)
        yaml_event_delete(event);
    else if (!made || !yaml_emitter_emit(&t->emitter, event))
        t->failed = true;
}

static void scalar(struct sheet *t, const char *text, yaml_scalar_style_t style)
{
    yaml_event_t event;
    /* libyaml takes unsigned char without const for historical reasons; it copies the text. */
    union {
        const char *given;
        yaml_char_t *wanted;
    } s = { .given = text };
    put(t, &event,
        yaml_scalar_event_initialize(&event, NULL, NULL, s.wanted, (int)strlen(text), 1, 1, style));
}

static void word(struct sheet *t, const char *text) { scalar(t, text, YAML_PLAIN_SCALAR_STYLE); }

/* Text of a user is quoted even where it need not be: "yes" and "1" stay texts for every reader. */
static void words(struct sheet *t, const char *key, const char *text)
{
    if (!text) return;
    word(t, key);
    scalar(t, text, YAML_DOUBLE_QUOTED_SCALAR_STYLE);
}

static void pair(struct sheet *t, const char *key, const char *value)
{
    if (!value) return;
    word(t, key);
    word(t, value);
}

static void map(struct sheet *t, const char *key, yaml_mapping_style_t style)
{
    yaml_event_t event;
    if (key) word(t, key);
    put(t, &event, yaml_mapping_start_event_initialize(&event, NULL, NULL, 1, style));
}

static void map_end(struct sheet *t)
{
    yaml_event_t event;
    put(t, &event, yaml_mapping_end_event_initialize(&event));
}

static void items(struct sheet *t, const char *key, yaml_sequence_style_t style)
{
    yaml_event_t event;
    word(t, key);
    put(t, &event, yaml_sequence_start_event_initialize(&event, NULL, NULL, 1, style));
}

static void items_end(struct sheet *t)
{
    yaml_event_t event;
    put(t, &event, yaml_sequence_end_event_initialize(&event));
}

static void number(struct sheet *t, double x, const char *unit)
{
    char said[80];
    snprintf(said, sizeof said, "%.9g%s%.40s", x, *unit ? " " : "", unit);
    word(t, said);
}

static void numbers(struct sheet *t, const char *key, const double *x, size_t n, const char *unit)
{
    items(t, key, YAML_FLOW_SEQUENCE_STYLE);
    for (size_t i = 0; i < n; i++) number(t, x[i], unit);
    items_end(t);
}

/* The estimate for a quantity and level; NULL: not fitted. */
static const struct wf_estimate *fitted(const struct wf_fit_results *of, enum wf_fit_quantity q,
                                        int32_t level)
{
    for (size_t k = 0; of && k < of->fit.free; k++) {
        const struct wf_fit_param *p = &of->param[k];
        if (p->quantity == q && p->tree <= 0 && (p->level < 0 || p->level == level))
            return &of->fit.estimate[k];
    }
    return NULL;
}

/* "low: 8 GPa" */
static void quantity(struct sheet *t, const char *key, double si, const struct wf_property *p)
{
    double x = wf_quantity_in(t->units, si, p->dimension, p->unit);
    t->failed = t->failed || isnan(x); /* no memory for the unit */
    word(t, key);
    number(t, x, p->unit);
}

/* A value unchanged, or from its estimate q (NULL: not fitted). share: of the level's value in it. */
static void value(struct sheet *t, const struct wf_property *p, const struct wf_estimate *q, double share)
{
    const struct wf_value *v = p->value;
    if (!v->given && !q) return;
    double low = v->low, high = v->high, x = v->value;
    bool open = false;
    if (q) {
        bool profile = q->profiled;
        x = q->value * share;
        low = (profile ? q->profile_low : q->low) * share,
        high = (profile ? q->profile_high : q->high) * share;
        open = isnan(low) || isnan(high);
        if (open) low = high = x;
    }
    map(t, p->key, YAML_FLOW_MAPPING_STYLE);
    quantity(t, "value", x, p);
    quantity(t, "low", fmin(low, x), p);
    quantity(t, "high", fmax(high, x), p);
    pair(t, "status", q ? open ? "assumed" : "measured" : wf_standing_text(v->standing));
    pair(t, "source", q ? t->source_key : v->source);
    words(t, "note",
          !q                        ? v->note
          : q->at_low || q->at_high ? "the fit ended on a bound: no estimate, the range is not known"
          : open                    ? "the data do not determine it: the range is not known"
                                    : "fitted; low and high are the 95 % interval");
    map_end(t);
}

static void along(struct sheet *t, const char *key, const struct wf_along *w, const struct wf_value *n)
{
    if (!w->n) return;
    map(t, key, YAML_FLOW_MAPPING_STYLE);
    numbers(t, "at", w->s, w->n, "");
    numbers(t, "share", w->v, w->n, "");
    pair(t, "status", wf_standing_text(n->standing));
    pair(t, "source", n->source);
    words(t, "note", n->note);
    map_end(t);
}

/* The estimate for a level's value. One for the whole tree (damping) is written with the stem. */
static const struct wf_estimate *level_fitted(const struct wf_fit_results *of, const char *key, size_t level,
                                              enum wf_fit_quantity *q)
{
    *q = wf_fit_quantity_of("levelN.", key);
    if (*q == WF_FIT_QUANTITIES && level == 0) *q = wf_fit_quantity_of("", key);
    return fitted(of, *q, (int32_t)level);
}

static void level(struct sheet *t, const struct wf_species *sp, size_t k)
{
    const struct wf_level *l = &sp->level[k];
    double share = 1;
    bool own = false; /* E of this level was fitted separately, not as a factor on all wood */
    for (size_t i = 0; t->of && i < t->of->fit.free; i++)
        own |= t->of->param[i].quantity == WF_FIT_YOUNGS && t->of->param[i].level == (int32_t)k;
    if (!own) share = l->youngs_modulus.value / sp->level[0].youngs_modulus.value;
    map(t, NULL, YAML_BLOCK_MAPPING_STYLE);
    words(t, "name", l->name);
    struct wf_property p;
    for (size_t i = 0; wf_level_property(l, i, &p); i++) {
        enum wf_fit_quantity q;
        const struct wf_estimate *e = level_fitted(t->of, p.key, k, &q);
        value(t, &p, e, q == WF_FIT_YOUNGS ? share : 1);
    }
    along(t, "wall", &l->wall, &l->wall_note);
    map_end(t);
}

/* table: where the law is in the species table; selects the estimate. */
static void parameter(struct sheet *t, const char *table, const struct wf_law_parameter *p,
                      const struct wf_law_use *u, size_t k)
{
    const char *unit = p->dimension == WF_DIM_NONE ? "" : wf_dimension_row(p->dimension)->si;
    const struct wf_property as = {
        .key = p->name, .dimension = p->dimension, .unit = unit, .value = &u->parameter[k]
    };
    if (p->kind == WF_LAW_LIST)
        numbers(t, p->name, u->list[k].v, u->list[k].n, unit);
    else if (p->kind == WF_LAW_NUMBER)
        word(t, p->name), number(t, u->parameter[k].value, unit);
    else
        value(t, &as, fitted(t->of, wf_fit_quantity_of(table, p->name), -1), 1);
}

/* A law and its parameters below a key. */
static void law_use(struct sheet *t, const char *key, const char *table, struct wf_law_table laws,
                    const struct wf_law_use *s)
{
    const struct wf_law *law = wf_law_named(laws, s->law);
    bool lists = false;
    if (!s->law) return;
    map(t, key, YAML_BLOCK_MAPPING_STYLE);
    pair(t, "law", s->law);
    for (size_t k = 0, n = wf_law_count(law); k < n; k++) {
        parameter(t, table, &law->parameter[k], s, k);
        lists |= law->parameter[k].kind == WF_LAW_LIST;
    }
    if (lists) pair(t, "status", wf_standing_text(s->standing));
    pair(t, "source", s->source);
    if (!isnan(s->low)) word(t, "valid_from"), number(t, s->low, "m/s");
    if (!isnan(s->high)) word(t, "valid_to"), number(t, s->high, "m/s");
    if (s->beyond != WF_BEYOND_HOLD) pair(t, "beyond", wf_beyond_words[s->beyond]);
    map_end(t);
}

/* The estimates that have no key in a species table. */
static char *beside(const struct wf_fit_results *of, struct wf_arena *a)
{
    char *out = wf_arena_print(a, "Fitted values are in the levels and the crown.");
    for (size_t k = 0; out && k < of->fit.free; k++) {
        enum wf_fit_quantity q = of->param[k].quantity;
        double u;
        const char *unit = wf_param_unit(&of->x, &of->param[k], &u);
        if (q == WF_FIT_ROOT || q == WF_FIT_RADIUS || q == WF_FIT_YOUNGS_TIP || of->param[k].tree > 0)
            out = wf_arena_print(a, "%s Fitted with them, not in this table: %s = %.6g %s.", out,
                                 of->param[k].name, of->fit.estimate[k].value * u, unit);
        if (q == WF_FIT_DAMPING)
            out = wf_arena_print(
                a, "%s The damping ratio is that of the whole tree in free sway, leaves and root included.",
                out);
    }
    return out;
}

/* What the fit was made from. A path may hold any bytes. */
static const char *citation(const struct wf_fit_results *of, struct wf_arena *a)
{
    char *out = wf_arena_print(a, "Calibration study %s, windfirm %s, %.10s;", of->calibration.key,
                               WF_VERSION, of->date);
    for (size_t i = 0; out && i < of->files; i++)
        out = wf_arena_print(a, "%s %s sha256 %s;", out, of->file[i].path, of->file[i].sha256);
    return out ? wf_text_for_xml(out, a) : NULL;
}

static void bark(struct sheet *t, const struct wf_bark_law *b)
{
    const struct wf_property share = {
        .key = "share", .dimension = WF_DIM_NONE, .unit = "", .value = &b->share
    };
    if (!b->given) return;
    map(t, "bark", YAML_BLOCK_MAPPING_STYLE);
    numbers(t, "double_mm", b->coefficient, b->terms, "");
    value(t, &share, NULL, 1);
    map_end(t);
}

static void whole(struct sheet *t, const struct wf_species *sp, const char *key, const char *note,
                  const char *cited)
{
    map(t, NULL, YAML_BLOCK_MAPPING_STYLE);
    pair(t, "species", key);
    words(t, "name", sp->name);
    words(t, "name_zh", sp->name_zh);
    words(t, "latin", sp->latin);
    pair(t, "preset", sp->preset);
    words(t, "note", note);
    map(t, "sources", YAML_BLOCK_MAPPING_STYLE);
    for (size_t i = 0; i < sp->sources; i++) words(t, sp->source[i].key, sp->source[i].text);
    words(t, t->source_key ? t->source_key : "", cited);
    map_end(t);
    bark(t, &sp->bark);
    items(t, "levels", YAML_BLOCK_SEQUENCE_STYLE);
    for (size_t k = 0; k < sp->levels; k++) level(t, sp, k);
    items_end(t);
    law_use(t, "axis_drag", "axis_drag.", wf_laws.axis_drag, &sp->axis_drag);
    if (sp->crown.drag_coefficient.given) {
        map(t, "crown", YAML_BLOCK_MAPPING_STYLE);
        struct wf_property p;
        for (size_t i = 0; wf_crown_property(sp, i, &p); i++)
            value(t, &p, fitted(t->of, wf_fit_quantity_of("crown.", p.key), -1), 1);
        law_use(t, "streamlining", "crown.streamlining.", wf_laws.streamlining, &sp->streamlining);
        map_end(t);
    }
    map_end(t);
}

/* The table as text, to be freed. Given: note and citation of the fit; without one of->... and cited are
 * NULL. Returned: NULL without memory, or where libyaml cannot write a text. */
static char *rendered(struct sheet *t, const struct wf_species *sp, const char *key, const char *note,
                      const char *cited)
{
    char *out = NULL;
    size_t size = 0;
    yaml_event_t event;
    FILE *f = open_memstream(&out, &size);
    if (!f) return NULL;
    t->failed = !yaml_emitter_initialize(&t->emitter);
    if (!t->failed) {
        yaml_emitter_set_output_file(&t->emitter, f);
        yaml_emitter_set_unicode(&t->emitter, 1);
        yaml_emitter_set_width(&t->emitter, 120);
        put(t, &event, yaml_stream_start_event_initialize(&event, YAML_UTF8_ENCODING));
        put(t, &event, yaml_document_start_event_initialize(&event, NULL, NULL, NULL, 1));
        whole(t, sp, key, note, cited);
        put(t, &event, yaml_document_end_event_initialize(&event, 1));
        put(t, &event, yaml_stream_end_event_initialize(&event));
        yaml_emitter_delete(&t->emitter);
    }
    t->failed = fclose(f) || t->failed;
    if (!t->failed) return out;
    free(out);
    return NULL;
}

/* Does the file, read as every species table is, say what was meant? It is written once more from what was
 * read, without the fit. */
static enum wf_status read_back(struct sheet *t, const char *path, const char *meant, struct wf_arena *a,
                                struct wf_err *e)
{
    struct wf_species sp;
    struct wf_err why = { 0 };
    struct wf_diag d = { .arena = a };
    struct sheet plain = { .units = t->units };
    enum wf_status s = wf_species_read(path, &wf_laws, a, &sp, &d, &why);
    if (s)
        return wf_fail(e, WF_EOUTPUT, "the table cannot be read back, so it was not written: %s",
                       d.first ? d.first->text : why.text);
    char *again = rendered(&plain, &sp, sp.key, sp.note, NULL);
    if (!again || strcmp(again, meant) != 0)
        s = wf_fail(e, WF_EOUTPUT, "the table reads back differently, so it was not written");
    free(again);
    return s;
}

/* A name of letters, digits, '_' and '-', as keys are. */
static char *key_of(char *name)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-";
    for (char *c = name; c && *c; c++)
        if (!strchr(allowed, *c) || (*c == '-' && c == name)) *c = '_';
    return name;
}

static enum wf_status write(struct sheet *t, const char *path, const char *key, struct wf_arena *a,
                            struct wf_err *e)
{
    struct wf_file f = { 0 };
    const char *note = beside(t->of, a), *cited = citation(t->of, a);
    char *text = note && cited ? rendered(t, t->of->x.tree[0].species, key, note, cited) : NULL;
    if (!text) return wf_fail(e, WF_ENOMEM, "%s: not enough memory", path);
    enum wf_status s = wf_file_begin(&f, path, e);
    if (!s && (fputs(text, f.stream) < 0 || fflush(f.stream)))
        s = wf_fail(e, WF_EOUTPUT, "%s: cannot be written", path);
    if (!s && f.temporary[0]) s = read_back(t, f.temporary, text, a, e); /* not from a device */
    if (!s) s = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    free(text);
    return s;
}

enum wf_status wf_fit_species_write(const struct wf_fit_results *of, const char *path, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(&a, slash ? slash + 1 : path);
    if (key && strchr(key, '.') > key) *strchr(key, '.') = '\0';
    key = key_of(key);
    struct sheet t = { .of = of, .source_key = key_of(wf_arena_print(&a, "fit_%s", of->calibration.key)) };
    enum wf_status s = key && t.source_key ? wf_units_open(&t.units, e)
                                           : wf_fail(e, WF_ENOMEM, "%s: not enough memory", path);
    if (!s) s = write(&t, path, key, &a, e);
    wf_units_close(t.units);
    wf_arena_free(&a);
    return s;
}
