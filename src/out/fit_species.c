/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/fit_species.h"
#include "base/file.h"
#include "data/species.h"
#include "load/drag.h"
#include <math.h>
#include <string.h>

/* A table being written. */
struct sheet {
    FILE *f;
    const struct wf_fit_results *of;
    const char *study; /* key of the fit among the sources */
    struct wf_units *units;
};

/* What was fitted of a quantity and level; NULL: nothing. */
static const struct wf_estimate *fitted(const struct wf_fit_results *of, enum wf_fit_quantity q,
                                        int32_t level)
{
    for (size_t k = 0; k < of->fit.free; k++) {
        const struct wf_fit_param *p = &of->param[k];
        if (p->quantity == q && p->tree <= 0 && (p->level < 0 || p->level == level))
            return &of->fit.estimate[k];
    }
    return NULL;
}

static void text(FILE *f, const char *s)
{
    fputc('"', f);
    for (; *s; s++) {
        if (*s == '"' || *s == '\\') fputc('\\', f);
        fputc(*s == '\n' ? ' ' : *s, f);
    }
    fputc('"', f);
}

/* "low: 8 GPa, " */
static void number(const struct sheet *t, const char *key, double si, const struct wf_property *p)
{
    fprintf(t->f, "%s: %.9g%s%s, ", key, wf_quantity_in(t->units, si, p->dimension, p->unit),
            *p->unit ? " " : "", p->unit);
}

/* A value as it was, or as fitted. share: of what was fitted. */
static void value(const struct sheet *t, const char *indent, const struct wf_property *p,
                  const struct wf_estimate *q, double share)
{
    FILE *f = t->f;
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
    fprintf(f, "%s%s: {", indent, p->key);
    number(t, "value", x, p), number(t, "low", fmin(low, x), p), number(t, "high", fmax(high, x), p);
    fprintf(f, "status: %s", q ? open ? "assumed" : "measured" : wf_standing_text(v->standing));
    if (q)
        fprintf(f, ", source: %s", t->study);
    else if (v->source)
        fprintf(f, ", source: %s", v->source);
    if (q || v->note) {
        fprintf(f, ",\n%s  note: ", indent);
        text(f, !q                        ? v->note
                : q->at_low || q->at_high ? "the fit ended on a bound: no estimate, the range is not known"
                : open                    ? "the data do not determine it: the range is not known"
                                          : "fitted; low and high are the 95 % interval");
    }
    fputs("}\n", f);
}

static void along(FILE *f, const char *key, const struct wf_along *w, const struct wf_value *n)
{
    if (!w->n) return;
    fprintf(f, "    %s: {at: [", key);
    for (size_t i = 0; i < w->n; i++) fprintf(f, "%s%.9g", i ? ", " : "", w->s[i]);
    fputs("], share: [", f);
    for (size_t i = 0; i < w->n; i++) fprintf(f, "%s%.9g", i ? ", " : "", w->v[i]);
    fprintf(f, "], status: %s", wf_standing_text(n->standing));
    if (n->source) fprintf(f, ", source: %s", n->source);
    if (n->note) fputs(", note: ", f), text(f, n->note);
    fputs("}\n", f);
}

/* What was fitted of a level's value. What is fitted of the whole tree (damping) stands with the stem. */
static const struct wf_estimate *level_fitted(const struct wf_fit_results *of, const char *key, size_t level,
                                              enum wf_fit_quantity *q)
{
    *q = wf_fit_quantity_of("levelN.", key);
    if (*q == WF_FIT_QUANTITIES && level == 0) *q = wf_fit_quantity_of("", key);
    return fitted(of, *q, (int32_t)level);
}

static void level(const struct sheet *t, const struct wf_species *sp, size_t k)
{
    const struct wf_level *l = &sp->level[k];
    const struct wf_fit_results *of = t->of;
    double share = 1;
    bool own = false; /* E of this level by itself, not by a factor on all wood */
    for (size_t i = 0; i < of->fit.free; i++)
        own |= of->param[i].quantity == WF_FIT_YOUNGS && of->param[i].level == (int32_t)k;
    if (!own) share = l->youngs_modulus.value / sp->level[0].youngs_modulus.value;
    fprintf(t->f, "  - name: %s\n", l->name);
    struct wf_property p;
    for (size_t i = 0; wf_level_property(l, i, &p); i++) {
        enum wf_fit_quantity q;
        const struct wf_estimate *e = level_fitted(of, p.key, k, &q);
        value(t, "    ", &p, e, q == WF_FIT_YOUNGS ? share : 1);
    }
    along(t->f, "wall", &l->wall, &l->wall_note);
}

/* "speed: [4 m/s, 20 m/s]" */
static void list(FILE *f, const char *key, const struct wf_numbers *v, const char *unit)
{
    fprintf(f, "    %s: [", key);
    for (size_t i = 0; i < v->n; i++)
        fprintf(f, "%s%.9g%s%s", i ? ", " : "", v->v[i], *unit ? " " : "", unit);
    fputs("]\n", f);
}

/* table: of the law, for what is fitted. */
static void parameter(const struct sheet *t, const char *table, const struct wf_law_parameter *p,
                      const struct wf_law_use *u, size_t k)
{
    const char *unit = p->dimension == WF_DIM_NONE ? "" : wf_dimension_row(p->dimension)->si;
    const struct wf_property as = {
        .key = p->name, .dimension = p->dimension, .unit = unit, .value = &u->parameter[k]
    };
    if (p->kind == WF_LAW_LIST)
        list(t->f, p->name, &u->list[k], unit);
    else if (p->kind == WF_LAW_NUMBER)
        fprintf(t->f, "    %s: %.9g%s%s\n", p->name, u->parameter[k].value, *unit ? " " : "", unit);
    else
        value(t, "    ", &as, fitted(t->of, wf_fit_quantity_of(table, p->name), -1), 1);
}

/* A law and its parameters below a key. */
static void law_use(const struct sheet *t, const char *key, const char *table, struct wf_law_table laws,
                    const struct wf_law_use *s)
{
    const struct wf_law *law = wf_law_named(laws, s->law);
    FILE *f = t->f;
    bool lists = false;
    if (!s->law) return;
    fprintf(f, "%s:\n    law: %s\n", key, s->law);
    for (size_t k = 0, n = wf_law_count(law); k < n; k++) {
        parameter(t, table, &law->parameter[k], s, k);
        lists |= law->parameter[k].kind == WF_LAW_LIST;
    }
    if (lists) fprintf(f, "    status: %s\n", wf_standing_text(s->standing));
    if (s->source) fprintf(f, "    source: %s\n", s->source);
    if (!isnan(s->low)) fprintf(f, "    valid_from: %.9g m/s\n", s->low);
    if (!isnan(s->high)) fprintf(f, "    valid_to: %.9g m/s\n", s->high);
}

/* What was fitted and has no key in a species table. */
static char *beside(const struct wf_fit_results *of, struct wf_arena *a)
{
    char *out = wf_arena_print(a, "Fitted values stand in the levels and the crown.");
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

static void write(const struct sheet *t, const char *key, const char *note)
{
    const struct wf_fit_results *of = t->of;
    FILE *f = t->f;
    const struct wf_species *sp = of->x.tree[0].species;
    fprintf(f, "species: %s\nname: ", key), text(f, sp->name), fputc('\n', f);
    if (sp->name_zh) fprintf(f, "name_zh: %s\n", sp->name_zh);
    if (sp->latin) fputs("latin: ", f), text(f, sp->latin), fputc('\n', f);
    if (sp->preset) fprintf(f, "preset: %s\n", sp->preset);
    fputs("note: ", f), text(f, note), fputs("\nsources:\n", f);
    for (size_t i = 0; i < sp->sources; i++)
        fprintf(f, "  %s: ", sp->source[i].key), text(f, sp->source[i].text), fputc('\n', f);
    fprintf(f, "  %s: \"Calibration study %s, windfirm %s, %.10s;", t->study, of->study.key, WF_VERSION,
            of->date);
    for (size_t i = 0; i < of->files; i++) fprintf(f, " %s sha256 %s;", of->file[i].path, of->file[i].sha256);
    fputs("\"\nlevels:\n", f);
    for (size_t k = 0; k < sp->levels; k++) level(t, sp, k);
    law_use(t, "axis_drag", "axis_drag.", wf_laws.axis_drag, &sp->axis_drag);
    if (!sp->crown.drag_coefficient.given) return;
    fputs("crown:\n", f);
    struct wf_property p;
    for (size_t i = 0; wf_crown_property(sp, i, &p); i++)
        value(t, "  ", &p, fitted(of, wf_fit_quantity_of("crown.", p.key), -1), 1);
    law_use(t, "  streamlining", "crown.streamlining.", wf_laws.streamlining, &sp->streamlining);
}

enum wf_status wf_fit_species_write(const struct wf_fit_results *of, const char *path, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_file f = { 0 };
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(&a, slash ? slash + 1 : path),
         *study = wf_arena_print(&a, "fit_%s", of->study.key);
    char *note = beside(of, &a);
    struct sheet t = { .of = of, .study = study };
    enum wf_status s =
        key && study && note ? wf_units_open(&t.units, e) : wf_fail(e, WF_ENOMEM, "%s: no room", path);
    if (!s) s = wf_file_begin(&f, path, e);
    if (!s) {
        if (strchr(key, '.')) *strchr(key, '.') = '\0';
        t.f = f.stream;
        write(&t, key, note);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    wf_units_close(t.units);
    wf_arena_free(&a);
    return s;
}
