/* What came out: totals at a wind speed, the critical wind speed, warnings. */
#include "out/parts.h"
#include "study/limits.h"
#include <math.h>

const char *wf_part_status(enum wf_status s)
{
    switch (s) {
    case WF_OK:
        return "ok";
    case WF_ENOCONV:
        return "not-converged";
    case WF_EUNSTABLE:
        return "unstable";
    default:
        return "failed";
    }
}

const char *wf_part_outcome(enum wf_critical_outcome o)
{
    static const char *const names[] = { [WF_CRITICAL_FOUND] = "found",
                                         [WF_CRITICAL_ABOVE] = "above",
                                         [WF_CRITICAL_SELF_WEIGHT] = "self-weight",
                                         [WF_CRITICAL_NO_STRENGTH] = "no-strength",
                                         [WF_CRITICAL_UNSOLVED] = "unsolved",
                                         [WF_CRITICAL_UNSEARCHED] = "unsearched" };
    return names[o];
}

double wf_part_height(const struct wf_tree *t, int32_t row, double s)
{
    if (row < 0 || (size_t)row >= t->n) return NAN;
    return t->z0[row] + s * (t->z1[row] - t->z0[row]);
}

/* A section of the tree: its segment's number as in segments.csv, and its place. */
static json_t *section(struct wf_doc *d, const struct wf_analysis *a, int32_t row, double s, double height)
{
    const struct wf_tree *t = &a->tree;
    if (row < 0 || (size_t)row >= t->n) return json_null();
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "segment", (size_t)row + 1);
    wf_doc_count(d, o, "level", t->level[row] > 0 ? (size_t)t->level[row] : 0);
    wf_doc_text(d, o, "part", wf_model_level_name(a->model, a->species, t->level[row]));
    wf_doc_quantity(d, o, "position", s, "1", "the segment as a whole is named");
    wf_doc_quantity(d, o, "height", height, "m", NULL);
    return o;
}

static json_t *worst_section(struct wf_doc *d, const struct wf_analysis *a, const struct wf_worst *w)
{
    if (!w) return json_null();
    return section(d, a, w->row, w->place, wf_part_height(&a->tree, w->row, w->place));
}

json_t *wf_part_wind(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at)
{
    static const char *const none = "no equilibrium was found at this wind speed";
    const struct wf_worst *worst = &at->worst[WF_BREAKAGE][WF_SCOPE_TREE];
    bool solved = at->status == WF_OK;
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "speed", at->speed, "m/s", NULL);
    wf_doc_text(d, o, "status", wf_part_status(at->status));
    wf_doc_text(d, o, "status_text", wf_status_text(at->status));
    wf_doc_quantity(d, o, "load_factor", at->response.load_factor, "1", none);
    const struct {
        const char *key;
        double value;
        const char *unit;
    } total[] = {
        { "drag", at->drag, "N" },
        { "lift", at->lift, "N" },
        { "weight", at->weight, "N" },
        { "tip_deflection", at->tip_deflection, "m" },
        { "tip_deflection_share", at->tip_deflection_share, "1" },
        { "tip_angle", at->tip_angle, "rad" },
        { "base_shear", at->base_shear, "N" },
        { "base_moment", at->base_moment, "N m" },
        { "largest_stress", at->breakage.largest_stress, "Pa" },
        { "imbalance", at->response.imbalance, "1" },
    };
    for (size_t i = 0; i < sizeof total / sizeof *total; i++)
        wf_doc_quantity(d, o, total[i].key, solved ? total[i].value : NAN, total[i].unit, none);
    const char *reason = !solved                ? none
                         : isnan(worst->safety) ? "no modulus of rupture is given"
                                                : "no section is stressed";
    wf_doc_quantity(d, o, "least_safety", solved ? worst->safety : NAN, "1", reason);
    wf_doc_put(d, o, "governing_section", worst_section(d, a, solved ? worst : NULL));
    wf_doc_flag(d, o, "small_deflection", at->response.small_deflection);
    wf_doc_flag(d, o, "within_limits", !wf_limits_small_passed(at));
    wf_doc_count(d, o, "iterations", at->response.iterations);
    wf_doc_count(d, o, "steps", at->response.steps);
    return o;
}

json_t *wf_part_critical(struct wf_doc *d, const struct wf_analysis *a, const struct wf_break *b)
{
    const struct wf_critical *c = &b->critical;
    const char *text = wf_critical_text(c->outcome);
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "outcome", wf_part_outcome(c->outcome));
    wf_doc_text(d, o, "outcome_text", text);
    wf_doc_quantity(d, o, "speed", c->speed, "m/s", text);
    wf_doc_quantity(d, o, "speed_low", c->speed_low, "m/s", text);
    wf_doc_quantity(d, o, "speed_high", c->speed_high, "m/s", text);
    wf_doc_quantity(d, o, "gradient", c->gradient, "s/m", text);
    bool found = c->outcome == WF_CRITICAL_FOUND;
    const struct wf_at_speed *at = &b->at;
    wf_doc_quantity(d, o, "tip_deflection", found ? at->tip_deflection : NAN, "m", text);
    wf_doc_quantity(d, o, "tip_deflection_share", found ? at->tip_deflection_share : NAN, "1", text);
    wf_doc_quantity(d, o, "tip_angle", found ? at->tip_angle : NAN, "rad", text);
    wf_doc_flag(d, o, "within_limits", !(found && wf_limits_small_passed(at)));
    wf_doc_count(d, o, "evaluations", c->evaluations);
    wf_doc_put(d, o, "governing_section", section(d, a, b->row, NAN, b->height));
    return o;
}

/* How near a part of the tree is to failing by a criterion at a wind speed. */
static json_t *utilisation(struct wf_doc *d, const struct wf_analysis *a, const struct wf_at_speed *at,
                           const struct wf_worst *w)
{
    bool solved = at->status == WF_OK;
    double safety = solved ? w->safety : NAN;
    const char *why = !solved         ? "no equilibrium was found at this wind speed"
                      : isnan(safety) ? "no resistance is known"
                                      : "nothing is loaded";
    json_t *o = wf_doc_object(d);
    wf_doc_quantity(d, o, "speed", at->speed, "m/s", NULL);
    wf_doc_quantity(d, o, "safety", safety, "1", why);
    wf_doc_quantity(d, o, "utilisation", 1 / safety, "1", why);
    wf_doc_put(d, o, "governing_section", worst_section(d, a, solved ? w : NULL));
    return o;
}

json_t *wf_part_criteria(struct wf_doc *d, const struct wf_analysis *a,
                         const struct wf_break (*breaks)[WF_SCOPES], const struct wf_at_speed *at)
{
    json_t *list = wf_doc_array(d);
    for (int c = 0; c < WF_CRITERIA; c++)
        for (int s = 0; s < WF_SCOPES; s++) {
            const struct wf_break *b = &breaks[c][s];
            const char *text = wf_critical_text(b->critical.outcome);
            json_t *o = wf_doc_add(d, list, wf_doc_object(d));
            wf_doc_text(d, o, "criterion", wf_criteria[c].name);
            wf_doc_text(d, o, "scope", wf_scope_name((enum wf_scope)s));
            wf_doc_text(d, o, "outcome", wf_part_outcome(b->critical.outcome));
            wf_doc_text(d, o, "outcome_text", text);
            wf_doc_quantity(d, o, "critical_speed", b->critical.speed, "m/s", text);
            wf_doc_put(d, o, "governing_section", section(d, a, b->row, NAN, b->height));
            json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
            for (size_t k = 0; k < a->n; k++)
                wf_doc_add(d, winds, utilisation(d, a, &at[k], &at[k].worst[c][s]));
        }
    return list;
}

json_t *wf_part_warnings(struct wf_doc *d, const struct wf_diag *diag)
{
    json_t *list = wf_doc_array(d);
    for (const struct wf_finding *f = diag ? diag->first : NULL; f; f = f->next) {
        if (f->severity != WF_WARNING) continue;
        json_t *o = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, o, "code", f->code);
        wf_doc_text(d, o, "text", f->text);
        wf_doc_text(d, o, "file", f->file);
    }
    return list;
}
