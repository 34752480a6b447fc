/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A species table with fitted values in place of the old ones, ready for analyze. */
#include "base/file.h"
#include "load/drag.h"
#include "out/fit_results.h"
#include <math.h>
#include <string.h>

/* The fitted parameter of a quantity and level; NULL: none. factor: share of level 0 that a level's E is. */
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

struct unit {
    const char *name;
    double factor;
};
static const struct unit gpa = { " GPa", 1e-9 }, mpa = { " MPa", 1e-6 }, density = { " kg/m3", 1 },
                         mm = { " mm", 1e3 }, area = { " kg/m2", 1 }, plain = { "", 1 };

/* A value as it was, or as fitted. share: of what was fitted. */
static void value(FILE *f, const char *indent, const char *key, const struct wf_value *v,
                  const struct wf_estimate *q, double share, struct unit u, const char *study)
{
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
    fprintf(f, "%s%s: {value: %.9g%s, low: %.9g%s, high: %.9g%s, status: %s", indent, key, x * u.factor,
            u.name, fmin(low, x) * u.factor, u.name, fmax(high, x) * u.factor, u.name,
            q ? open ? "assumed" : "measured" : wf_standing_text(v->standing));
    if (q)
        fprintf(f, ", source: %s", study);
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

static void level(FILE *f, const struct wf_fit_results *of, const struct wf_species *sp, size_t k,
                  const char *study)
{
    const struct wf_level *l = &sp->level[k];
    int32_t n = (int32_t)k;
    double share = 1;
    bool own = false; /* E of this level by itself, not by a factor on all wood */
    for (size_t i = 0; i < of->fit.free; i++)
        own |= of->param[i].quantity == WF_FIT_YOUNGS && of->param[i].level == n;
    if (!own) share = l->youngs_modulus.value / sp->level[0].youngs_modulus.value;
    fprintf(f, "  - name: %s\n", l->name);
    value(f, "    ", "youngs_modulus", &l->youngs_modulus, fitted(of, WF_FIT_YOUNGS, n), share, gpa, study);
    value(f, "    ", "shear_modulus", &l->shear_modulus, fitted(of, WF_FIT_SHEAR, n), 1, gpa, study);
    value(f, "    ", "density", &l->density, fitted(of, WF_FIT_DENSITY, n), 1, density, study);
    value(f, "    ", "modulus_of_rupture", &l->modulus_of_rupture, NULL, 1, mpa, study);
    value(f, "    ", "radius", &l->radius, NULL, 1, mm, study);
    value(f, "    ", "damping_ratio", &l->damping_ratio, k ? NULL : fitted(of, WF_FIT_DAMPING, n), 1, plain,
          study);
    value(f, "    ", "knot_factor", &l->knot_factor, NULL, 1, plain, study);
    value(f, "    ", "drag_coefficient", &l->drag_coefficient, fitted(of, WF_FIT_AXIS_DRAG, n), 1, plain,
          study);
    value(f, "    ", "lift_coefficient", &l->lift_coefficient, NULL, 1, plain, study);
    along(f, "wall", &l->wall, &l->wall_note);
}

/* "speed: [4 m/s, 20 m/s]" */
static void list(FILE *f, const char *key, const struct wf_numbers *v, const char *unit)
{
    fprintf(f, "    %s: [", key);
    for (size_t i = 0; i < v->n; i++)
        fprintf(f, "%s%.9g%s%s", i ? ", " : "", v->v[i], *unit ? " " : "", unit);
    fputs("]\n", f);
}

static void parameter(FILE *f, const struct wf_fit_results *of, const struct wf_law_parameter *p,
                      const struct wf_law_use *u, size_t k, const char *study)
{
    const char *si = wf_dimension_row(p->dimension)->si, *unit = p->dimension == WF_DIM_NONE ? "" : si;
    char spaced[32];
    snprintf(spaced, sizeof spaced, "%s%s", *unit ? " " : "", unit);
    if (p->kind == WF_LAW_LIST)
        list(f, p->name, &u->list[k], unit);
    else if (p->kind == WF_LAW_NUMBER)
        fprintf(f, "    %s: %.9g%s\n", p->name, u->parameter[k].value, spaced);
    else
        value(f, "    ", p->name, &u->parameter[k],
              strcmp(p->name, WF_FIT_CROWN_LAW) ? NULL : fitted(of, WF_FIT_VOGEL, -1), 1,
              (struct unit){ spaced, 1 }, study);
}

/* A law and its parameters below a key. */
static void law_use(FILE *f, const struct wf_fit_results *of, const char *key, struct wf_law_table table,
                    const struct wf_law_use *s, const char *study)
{
    const struct wf_law *law = wf_law_named(table, s->law);
    bool lists = false;
    if (!s->law) return;
    fprintf(f, "%s:\n    law: %s\n", key, s->law);
    for (size_t k = 0, n = wf_law_count(law); k < n; k++) {
        parameter(f, of, &law->parameter[k], s, k, study);
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

static void write(FILE *f, const struct wf_fit_results *of, const char *key, const char *study,
                  const char *note)
{
    const struct wf_species *sp = of->x.tree[0].species;
    fprintf(f, "species: %s\nname: ", key), text(f, sp->name), fputc('\n', f);
    if (sp->name_zh) fprintf(f, "name_zh: %s\n", sp->name_zh);
    if (sp->latin) fputs("latin: ", f), text(f, sp->latin), fputc('\n', f);
    if (sp->preset) fprintf(f, "preset: %s\n", sp->preset);
    fputs("note: ", f), text(f, note), fputs("\nsources:\n", f);
    for (size_t i = 0; i < sp->sources; i++)
        fprintf(f, "  %s: ", sp->source[i].key), text(f, sp->source[i].text), fputc('\n', f);
    fprintf(f, "  %s: \"Calibration study %s, windfirm %s, %.10s;", study, of->study.key, WF_VERSION,
            of->date);
    for (size_t i = 0; i < of->files; i++) fprintf(f, " %s sha256 %s;", of->file[i].path, of->file[i].sha256);
    fputs("\"\nlevels:\n", f);
    for (size_t k = 0; k < sp->levels; k++) level(f, of, sp, k, study);
    law_use(f, of, "axis_drag", wf_laws.axis_drag, &sp->axis_drag, study);
    if (!sp->crown_drag.given) return;
    fputs("crown:\n", f);
    value(f, "  ", "drag_coefficient", &sp->crown_drag, fitted(of, WF_FIT_CROWN_DRAG, -1), 1, plain, study);
    value(f, "  ", "leaf_mass_per_area", &sp->leaf_mass_per_area, NULL, 1, area, study);
    value(f, "  ", "frontal_share", &sp->leaf_frontal_share, NULL, 1, plain, study);
    law_use(f, of, "  streamlining", wf_laws.streamlining, &sp->streamlining, study);
}

enum wf_status wf_fit_species_write(const struct wf_fit_results *of, const char *path, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_file f = { 0 };
    const char *slash = strrchr(path, '/');
    char *key = wf_arena_text(&a, slash ? slash + 1 : path),
         *study = wf_arena_print(&a, "fit_%s", of->study.key);
    char *note = beside(of, &a);
    enum wf_status s =
        key && study && note ? wf_file_begin(&f, path, e) : wf_fail(e, WF_ENOMEM, "%s: no room", path);
    if (!s) {
        if (strchr(key, '.')) *strchr(key, '.') = '\0';
        write(f.stream, of, key, study, note);
        s = wf_file_commit(&f, e);
    }
    wf_file_abandon(&f);
    wf_arena_free(&a);
    return s;
}
