/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_fit.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/num.h"
#include "cmd/option.h"
#include "fit/calibration.h"
#include "grow/silhouette.h"
#include "out/folder.h"
#include "out/reader.h"
#include "study/verdict.h"
#include <math.h>
#include <string.h>

static const char *text_of(const json_t *o, const char *key)
{
    const char *text = json_string_value(json_object_get(o, key));
    return text ? text : "";
}

static double number_of(const json_t *o, const char *key)
{
    const json_t *v = json_object_get(o, key);
    return json_is_number(v) ? json_number_value(v) : (double)NAN;
}

/* ---- What was fitted ---- */

/* A parameter with its interval. The unit is that of the document. */
static void take_value(const json_t *p, double factor, struct wf_value *out)
{
    *out = (struct wf_value){ .value = factor * number_of(p, "value"),
                              .low = factor * number_of(p, "low"),
                              .high = factor * number_of(p, "high"),
                              .standing = WF_MEASURED,
                              .source = "fit",
                              .given = true };
    if (!(out->low <= out->value && out->high >= out->value)) out->low = out->high = out->value;
}

static enum wf_status take_values(const json_t *fit, const char *folder, struct wf_assess_fit *out,
                                  struct wf_err *e)
{
    const json_t *all = json_object_get(fit, "parameters");
    struct wf_units *units;
    enum wf_status s = wf_units_open(&units, e);
    for (size_t k = 0; !s && k < json_array_size(all); k++) {
        const json_t *p = json_array_get(all, k);
        const char *name = text_of(p, "name");
        bool youngs = !strcmp(name, "level0.youngs_modulus"), root = !strcmp(name, "root.stiffness");
        char unit[60];
        double factor = 0;
        if (!youngs && !root) continue;
        (void)snprintf(unit, sizeof unit, "1 %.50s", text_of(p, "unit"));
        s = wf_quantity_read(units, unit, youngs ? WF_DIM_PRESSURE : WF_DIM_ROTATIONAL_STIFFNESS, &factor, e);
        if (!s) take_value(p, factor, youngs ? &out->youngs : &out->root);
    }
    wf_units_close(units);
    if (s || out->youngs.given || out->root.given) return s;
    return wf_fail(e, WF_EINPUT, "%s: the fit has neither level0.youngs_modulus nor root.stiffness", folder);
}

/* The study, if its bytes are those that were fitted. */
static enum wf_status find_study(const json_t *o, const char *folder, struct wf_arena *a,
                                 struct wf_assess_fit *out, struct wf_err *e)
{
    const json_t *files = json_object_get(o, "files");
    char sum[WF_SHA256_TEXT];
    for (size_t k = 0; k < json_array_size(files); k++) {
        const json_t *f = json_array_get(files, k);
        if (strcmp(text_of(f, "role"), "study")) continue;
        out->study = wf_arena_text(a, text_of(f, "path"));
        if (!out->study) return wf_fail(e, WF_ENOMEM, "not enough memory for a fit");
        if (wf_sha256_file(out->study, a, sum, e)) return e->code;
        if (!strcmp(sum, text_of(f, "sha256"))) return WF_OK;
        return wf_fail(e, WF_EINPUT, "%s: %s has changed since it was fitted; fit it again", folder,
                       out->study);
    }
    return wf_fail(e, WF_EINPUT, "%s: names no study", folder);
}

/* ---- The record ---- */

static const struct wf_calibration_sensor *sensor_of(const struct wf_calibration *c, const char *test,
                                                     const char *sensor,
                                                     const struct wf_calibration_test **of)
{
    for (size_t i = 0; i < c->tests; i++)
        for (size_t k = 0; k < c->test[i].sensors; k++)
            if (!strcmp(c->test[i].name, test) && !strcmp(c->test[i].sensor[k].name, sensor))
                return *of = &c->test[i], &c->test[i].sensor[k];
    return NULL;
}

static struct wf_assess_record *record_of(struct wf_assess_fit *f, const struct wf_calibration *c,
                                          const char *test, const char *sensor)
{
    const struct wf_calibration_test *of;
    const struct wf_calibration_sensor *s = sensor_of(c, test, sensor, &of);
    for (size_t k = 0; k < f->records; k++)
        if (!strcmp(f->record[k].test, test) && !strcmp(f->record[k].sensor, sensor)) return &f->record[k];
    if (!s || !(of->pull.given || of->wind.given) || f->records == WF_ASSESS_RECORDS) return NULL;
    bool plate = s->kind == WF_SENSOR_TILT && s->height == 0;
    bool stretch = s->kind == WF_SENSOR_EXTENSION && s->gauge > 0;
    if (!plate && ((s->kind != WF_SENSOR_STRAIN && !stretch) || !of->pull.given)) return NULL;
    const struct wf_calibration_pull *p = &of->pull;
    double slope =
        isnan(p->anchor_distance) ? p->elevation : atan2(p->anchor_height - p->height, p->anchor_distance);
    struct wf_assess_record *r = &f->record[f->records++];
    *r = (struct wf_assess_record){ .test = of->name,
                                    .sensor = s->name,
                                    .height = s->height,
                                    .rope = p->height,
                                    .level = cos(isnan(slope) ? 0 : slope),
                                    .azimuth = p->azimuth,
                                    .quarter = NAN,
                                    .in_wind = !of->pull.given,
                                    .slope = plate ? (double)NAN : 0,
                                    .gauge = stretch ? s->gauge : 1,
                                    .offset = s->offset,
                                    .first = { NAN, NAN } };
    return r;
}

/* One reading after the other: the moment at 0.25 deg between two, the largest strain over its force. */
static void add_reading(struct wf_assess_record *r, double load, double shown, double *before)
{
    const double quarter = 0.25 * WF_PI / 180;
    if (isnan(r->first[0])) r->first[0] = r->offset ? shown : 0, r->first[1] = r->offset ? load : 0;
    double size = fabs(shown - r->first[0]), more = load - r->first[1];
    if (!r->in_wind) r->force = fmax(r->force, load);
    if (r->in_wind) {
        if (size > r->most) r->most = size, r->wind = load;
        return;
    }
    if (isnan(r->slope) && isnan(r->quarter) && size >= quarter && r->most < quarter && size > r->most)
        r->quarter =
            r->level * r->rope * (*before + (load - *before) * (quarter - r->most) / (size - r->most));
    if (!isnan(r->slope) && size > r->most && more > 0) r->slope = size / more;
    if (size > r->most) r->most = size, *before = load;
}

static enum wf_status read_record(const char *folder, const struct wf_calibration *c, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_assess_fit *out, struct wf_err *e)
{
    static const char *const names[] = { "test", "sensor", "unit", "load", "load_unit", "measured" };
    char *path = wf_arena_print(a, "%s/tables/readings.csv", folder);
    struct wf_csv csv;
    struct wf_units *units;
    size_t at[6];
    double before[WF_ASSESS_RECORDS] = { 0 };
    if (!path) return wf_fail(e, WF_ENOMEM, "not enough memory for a record");
    enum wf_status s = wf_csv_open(&csv, path, a, d, e);
    for (size_t k = 0; k < 6 && !s; k++)
        if ((at[k] = wf_csv_need(&csv, names[k])) == WF_CSV_NONE)
            s = wf_fail(e, WF_EINPUT, "%s is no record", path);
    if (s || (s = wf_units_open(&units, e))) return s;
    while (!s && wf_csv_next(&csv)) {
        struct wf_assess_record *r = record_of(out, c, wf_csv_text(&csv, at[0]), wf_csv_text(&csv, at[1]));
        double load, shown, factor, si;
        struct wf_err unsaid = { WF_OK, "" };
        char text[80];
        if (!r || wf_csv_value(&csv, at[3], &load) || wf_csv_value(&csv, at[5], &shown)) continue;
        struct wf_column unit = { "measured", wf_csv_text(&csv, at[2]),
                                  isnan(r->slope) ? WF_DIM_ANGLE
                                  : r->gauge != 1 ? WF_DIM_LENGTH
                                                  : WF_DIM_NONE };
        (void)snprintf(text, sizeof text, "1 %.40s", wf_csv_text(&csv, at[4]));
        if (wf_quantity_read(units, text, r->in_wind ? WF_DIM_SPEED : WF_DIM_FORCE, &factor, &unsaid))
            continue;
        if (wf_column_unit(units, &unit, &si, &unsaid)) continue;
        add_reading(r, factor * load, si * shown / r->gauge, &before[r - out->record]);
    }
    wf_units_close(units);
    return s;
}

/* ---- All ---- */

static enum wf_status read_study(const char *folder, struct wf_arena *a, struct wf_diag *d,
                                 struct wf_assess_fit *out, struct wf_err *e)
{
    struct wf_calibration c;
    enum wf_status s = wf_calibration_read(out->study, a, &c, d, e);
    if (s) return s;
    if (c.trees != 1 || !c.tree->model)
        return wf_fail(e, WF_EINPUT, "%s: a fit of one tree with a model is taken; this one has %zu",
                       out->study, c.trees);
    if (wf_calibration_path(&c, c.tree->model, a, &out->model, e)) return e->code;
    if (wf_calibration_path(&c, c.tree->species, a, &out->species, &(struct wf_err){ WF_OK, "" }))
        out->species = c.tree->species; /* a shipped one */
    return read_record(folder, &c, a, d, out, e);
}

enum wf_status wf_assess_fit_read(const char *folder, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_assess_fit *out, struct wf_err *e)
{
    json_t *o = NULL;
    char *path = wf_arena_print(a, "%s/%s", folder, WF_DOCUMENT);
    *out = (struct wf_assess_fit){ .study = NULL };
    if (!path) return wf_fail(e, WF_ENOMEM, "not enough memory for a fit");
    enum wf_status s = wf_document_read(path, &o, d, e);
    if (!s && strcmp(text_of(json_object_get(o, "schema"), "name"), "windfirm-fit"))
        s = wf_fail(e, WF_EINPUT, "%s: is no results folder of windfirm fit", folder);
    if (!s) s = take_values(json_object_get(o, "fit"), folder, out, e);
    if (!s) s = find_study(o, folder, a, out, e);
    json_decref(o);
    return s ? s : read_study(folder, a, d, out, e);
}

/* ---- The tree ---- */

enum wf_status wf_assess_fit_model(const struct wf_assess_fit *f, const struct wf_analyze_options *o,
                                   struct wf_arena *a, struct wf_model *out, struct wf_diag *d,
                                   struct wf_err *e)
{
    enum wf_status s = wf_model_read(f->model, a, out, d, e);
    if (!s) s = wf_tree_asked_onto(&o->tree, false, a, out, d, e);
    bool crown = out->leaf_area_on > 0 || wf_silhouette_area(&out->silhouette) > 0;
    if (s || crown || out->season == WF_LEAF_OFF) return s;
    return wf_fail(e, WF_EINPUT,
                   "%s: the model that was fitted has no crown, and wood alone catches too little wind: give "
                   "--crown-width with --crown-depth, or --frontal-area, or --season leaf_off",
                   f->model);
}

/* The largest moment that a rope put on the ground in a test, NULL: in any [N m]; 0: no rope pulled. */
static double carried_in(const struct wf_assess_fit *f, const char *test)
{
    double most = 0;
    for (size_t k = 0; k < f->records; k++) {
        const struct wf_assess_record *r = &f->record[k];
        if (!r->in_wind && (!test || !strcmp(r->test, test)))
            most = fmax(most, r->force * r->level * r->rope);
    }
    return most;
}

enum wf_status wf_assess_fit_onto(const struct wf_assess_fit *f, const struct wf_analyze_options *o,
                                  struct wf_arena *a, struct wf_analyze_request *q, struct wf_err *e)
{
    const struct wf_anchorage_asked *asked = &o->anchorage;
    struct wf_anchorage_request *roots = WF_TAKE(a, 1, struct wf_anchorage_request);
    if (!roots) return wf_fail(e, WF_ENOMEM, "not enough memory for the anchorage");
    bool said = !f->root.given || asked->method || asked->curve || asked->table ||
                !isnan(asked->pull_moment) || !isnan(asked->secant);
    if (f->root.given && !WF_GIVEN(o, root_stiffness))
        q->solve.root_stiffness[0] = q->solve.root_stiffness[1] = f->root.value;
    *roots = *q->scenario.anchorage;
    if (!said) roots->secant = f->root.value;
    roots->carried = carried_in(f, NULL);
    q->scenario.anchorage = roots;
    return WF_OK;
}

/* ---- In words ---- */

/* Moment on the section of the stem at a height in the strongest wind [N m]. */
static double moment_at(const struct wf_analysis *an, double height)
{
    const struct wf_tree *t = &an->tree;
    const struct wf_response *r = &an->at[an->n - 1].response;
    for (size_t i = 0; i < t->n && r->moment0; i++) {
        double share = (height - t->z0[i]) / (t->z1[i] - t->z0[i]);
        if (t->level[i] != 0 || !(share >= 0 && share <= 1)) continue;
        double m[2];
        for (size_t k = 0; k < 2; k++)
            m[k] = r->moment0[3 * i + k] + share * (r->moment1[3 * i + k] - r->moment0[3 * i + k]);
        return hypot(m[0], m[1]);
    }
    return NAN;
}

/* The code of what a record says. */
#define RECORD "record"

/* `carried`: the largest moment of the test on the ground [N m]. */
static void say_plate(struct wf_diag *d, const struct wf_assess_record *r, double carried,
                      const struct wf_analysis *an)
{
    double wind = an->at[an->n - 1].base_moment, largest = r->most * 180 / WF_PI;
    if (isnan(r->quarter))
        wf_diag_warn(d, RECORD,
                     "%s, %s: the plate turned by %.2f deg at most: no moment at 0.25 deg is known", r->test,
                     r->sensor, largest);
    else
        wf_diag_warn(
            d, RECORD,
            "%s, %s: 2.5 x %.4g kN m at 0.25 deg over %.4g kN m in the wind: safety against overturning "
            "%.2f",
            r->test, r->sensor, r->quarter / 1e3, wind / 1e3, 2.5 * r->quarter / wind);
    if (2.5 * r->quarter < carried)
        wf_diag_warn(d, RECORD,
                     "%s, %s: that rule is too low for this root, which carried %.4g kN m in the same test",
                     r->test, r->sensor, carried / 1e3);
    if (largest > 0.26)
        wf_diag_warn(d, RECORD,
                     "%s, %s: it turned by %.2f deg, beyond the 0.25 deg that tests without harm stay below",
                     r->test, r->sensor, largest);
}

/* A record in wind has no moment of its own to compare with. */
static void say_wind(struct wf_diag *d, const struct wf_assess_record *r, const struct wf_analysis *an)
{
    const struct wf_verdict v = wf_verdict_of(an->breaks);
    const struct wf_critical *c = v.loss ? &v.loss->critical : NULL;
    wf_diag_warn(d, RECORD, "%s, %s: the plate turned by up to %.2f deg, in a wind of %.3g m/s", r->test,
                 r->sensor, r->most * 180 / WF_PI, r->wind);
    if (c && c->outcome == WF_CRITICAL_FOUND && r->wind > c->speed)
        wf_diag_warn(
            d, RECORD,
            "%s, %s: it stood that wind, which is above the critical wind of %.3g m/s if both are named at "
            "one place: compare them before the verdict is used",
            r->test, r->sensor, c->speed);
}

static void say_strain(struct wf_diag *d, const struct wf_assess_record *r, const struct wf_analysis *an)
{
    const struct wf_level *l = &an->species->level[0];
    double limit = l->compressive_strength.value / l->youngs_modulus.value;
    double wind = moment_at(an, r->height), lever = r->level * (r->rope - r->height);
    if (!(l->compressive_strength.value > 0) || !(wind > 0) || !(r->slope > 0)) return;
    wf_diag_warn(
        d, RECORD,
        "%s, %s at %.3g m: to the limit strain %.2g the section bears %.4g kN m; in the wind %.4g kN m: "
        "safety against breakage %.2f",
        r->test, r->sensor, r->height, limit, limit / r->slope * lever / 1e3, wind / 1e3,
        limit / r->slope * lever / wind);
    if (r->most > 0.4 * limit)
        wf_diag_warn(d, RECORD,
                     "%s, %s: it was strained to %.0f %% of that limit; tests without harm stay below 40 %%",
                     r->test, r->sensor, 100 * r->most / limit);
}

/* What the rope put on the ground at most, beside the wind and the anchorage: needs neither a strength nor a
 * rule. */
static void say_force(struct wf_diag *d, const char *test, double carried, const struct wf_analysis *an)
{
    const struct wf_anchorage *roots = an->anchorage;
    double wind = an->at[an->n - 1].base_moment;
    if (!(carried > 0) || !(wind > 0)) return;
    wf_diag_warn(d, RECORD,
                 "%s: the largest force of these readings put %.4g kN m on the ground, %.2f times the %.4g "
                 "kN m in the wind: in soil as it was then the safety against overturning is at least that",
                 test, carried / 1e3, carried / wind, wind / 1e3);
    if (!roots || !roots->method) return;
    if (roots->by_method < roots->carried)
        wf_diag_warn(d, RECORD,
                     "%s: the anchorage is taken as the largest moment that was carried, %.4g kN m, because "
                     "the %.4g kN m found otherwise are less than the root has held",
                     test, roots->carried / 1e3, roots->by_method / 1e3);
    else
        wf_diag_warn(d, RECORD,
                     "%s: the anchorage of %.4g kN m is more than was tried: if the tree went over in this "
                     "test, no more than %.4g kN m hold it",
                     test, roots->by_method / 1e3, carried / 1e3);
}

enum wf_status wf_assess_fit_say(const struct wf_assess_fit *f, const struct wf_analysis *an,
                                 struct wf_arena *a, struct wf_assessment *out, struct wf_err *e)
{
    struct wf_diag *d = WF_TAKE(a, 1, struct wf_diag);
    if (!d) return wf_fail(e, WF_ENOMEM, "not enough memory for a record");
    d->arena = a;
    for (size_t k = 0; k < f->records; k++)
        if (f->record[k].in_wind)
            say_wind(d, &f->record[k], an);
        else if (isnan(f->record[k].slope))
            say_plate(d, &f->record[k], carried_in(f, f->record[k].test), an);
        else
            say_strain(d, &f->record[k], an);
    for (size_t k = 0; k < f->records; k++)
        if (!f->record[k].in_wind && (!k || strcmp(f->record[k].test, f->record[k - 1].test) != 0))
            say_force(d, f->record[k].test, carried_in(f, f->record[k].test), an);
    if (!f->records) wf_diag_warn(d, RECORD, "it has no tilt of the root plate, and no strain under a rope");
    if (f->root.given)
        wf_diag_warn(
            d, RECORD,
            "a stiffness at small tilt does not give the anchorage's strength beyond it: 2.5 times the "
            "moment at 0.25 deg is a rule of pulling tests");
    for (size_t k = 0; k < f->records && k < 1 && !f->record[k].in_wind; k++) {
        double away = remainder(f->record[k].azimuth - an->scenario.azimuth, 2 * WF_PI) * 180 / WF_PI;
        wf_diag_warn(d, RECORD, "pulled %.0f deg away from the direction of the wind that was assessed",
                     fabs(away));
    }
    out->record = d;
    return WF_OK;
}

void wf_assess_fit_print(FILE *to, const struct wf_assess_fit *f, const struct wf_assessment *x)
{
    wf_show(to, "\n  straight from the record of %s\n", f->study);
    for (const struct wf_finding *w = x->record->first; w; w = w->next) {
        struct wf_arena scratch = { 0 };
        const char *own = wf_show_words(w->said, &scratch);
        wf_show(to, "  %s\n", own ? own : w->text);
        wf_arena_free(&scratch);
    }
}
