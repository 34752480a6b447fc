/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/series_plan.h"
#include "base/num.h"
#include "base/text.h"
#include "base/yaml.h"
#include "data/species.h"
#include "solve/solve.h"
#include "wind/gust.h"
#include "wind/shelter_laws.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

#define AT(member) .offset = offsetof(struct wf_series_plan_run, member)
#define WORD(k, text, ...)                                                                                   \
    {                                                                                                        \
        .key = #k, .kind = WF_YAML_TEXT, AT(k), .doc = text, __VA_ARGS__                                     \
    }
#define QUANTITY(k, member, dim, u, l, h, text, ...)                                                         \
    {                                                                                                        \
        .key = k, .kind = WF_YAML_QUANTITY, .dimension = dim, .unit = u, .low = l, .high = h, AT(member),    \
        .doc = text, __VA_ARGS__                                                                             \
    }

static const char *const no_yes[] = { "no", "yes", NULL };
static const struct wf_yaml_row run_rows[] = {
    WORD(name, "Name of the run in tables and panels.", .required = true, .example = "10 m/s"),
    WORD(species, "Species table, a file or a shipped name.", .required = true, .example = "moso_bamboo"),
    WORD(model, "Tree model, a file or a shipped name.", .required = true, .example = "moso_culm"),
    WORD(preset, "Published method whose formula and constants are used.", .initial = "corrected",
         .example = "tang2012"),
    WORD(solver, "Name of the solver.", .absent = "the preset's, else beam", .example = "beam"),
    WORD(gust, "Gust model; steady: a wind that does not change.", .initial = "steady", .example = "cosine"),
    WORD(set, "Other parameters of the gust model, name=number,... as 'windfirm wind list' names them.",
         .absent = "the gust model's", .example = "length=65,share-up=0.5"),
    WORD(file, "Anemometer CSV of the gust model record.", .absent = "none", .example = "sonic.csv"),
    { .key = "columns",
      .kind = WF_YAML_TEXT,
      AT(record.columns),
      .doc = "Its columns: time, one or two horizontal components and the vertical one, with units in their "
             "names or "
             "in the logger's head; '-' in place of the time: there is none.",
      .initial = WF_RECORD_COLUMNS,
      .example = "t_s,u_ms,v_ms,w_ms" },
    QUANTITY("rate", record.rate, WF_DIM_FREQUENCY, "Hz", 1e-3, 1e4, "Rows a second, where there is no time.",
             .absent = "not known", .example = "20 Hz"),
    { .key = "missing",
      .kind = WF_YAML_TEXT,
      AT(record.missing),
      .doc = "Numbers of the file that mean 'no reading', separated by commas; none: every number is a wind.",
      .absent = "negative speeds, and impossible numbers that are repeated",
      .example = "99.9,-99.9" },
    { .key = "dates",
      .kind = WF_YAML_TEXT,
      AT(record.dates),
      .doc = "day-first or month-first, for dates such as 05/01/2024.",
      .absent = "seen from a number above 12",
      .example = "day-first" },
    { .key = "components",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 3,
      .absent = "3 where the gust model has them",
      AT(components),
      .doc = "Of the gust: 1 along the wind only, 3 along, across and up.",
      .example = "3" },
    WORD(shelter, "Law of the wind inside the crown; none: the free wind acts on every part.",
         .initial = "none", .example = "feng1999"),
    { .key = "profile",
      .kind = WF_YAML_TEXT,
      AT(profile.name),
      .doc = "Name of the wind profile.",
      .absent = "power; measured with a file",
      .example = "uniform" },
    { .key = "profile_file",
      .kind = WF_YAML_TEXT,
      AT(profile.file),
      .doc = "Measured profile, a CSV with columns height_m and speed_ms.",
      .absent = "none",
      .example = "mast.csv" },
    WF_PROFILE_KEYS(struct wf_series_plan_run, profile),
    QUANTITY("wind", wind, WF_DIM_SPEED, "m/s", 0, 100, "Mean wind at the reference height.",
             .required = true, .example = "10 m/s"),
    QUANTITY("intensity", intensity, WF_DIM_NONE, NULL, 0, 1, "Turbulence intensity of the gust model.",
             .absent = "the gust model's", .example = "0.2"),
    QUANTITY("period", period, WF_DIM_TIME, "s", 0.1, 3600, "Period of the gust model.",
             .absent = "the gust model's", .example = "20 s"),
    QUANTITY("duration", duration, WF_DIM_TIME, "s", 1e-3, 86400, "Time that is run; 0 frames: one.",
             .absent = "one frame", .example = "60 s"),
    QUANTITY("step", step, WF_DIM_TIME, "s", 1e-4, 3600, "Between frames.", .initial = "0.1 s",
             .example = "0.1 s"),
    QUANTITY("youngs_modulus", youngs, WF_DIM_PRESSURE, "Pa", 1e5, 1e12,
             "In place of the species' on every level.", .absent = "the species'", .example = "10 GPa"),
    QUANTITY("restoring", restoring, WF_DIM_NONE, NULL, 0, 100, "k of the deflect scheme, below 1.",
             .initial = "0", .example = "0.3"),
    QUANTITY("damping", damping, WF_DIM_NONE, NULL, 0, 1e9, "c of the deflect scheme [N s2].", .initial = "0",
             .example = "0.1"),
    QUANTITY("transmission", transmission, WF_DIM_NONE, NULL, 0, 1,
             "Share of the wind's energy that a fully covered cell lets through.", .initial = "0.2",
             .example = "0.2"),
    QUANTITY("reference_height", profile.reference_height, WF_DIM_LENGTH, "m", 0.01, 1000,
             "Height at which the wind has this speed.", .initial = "10 m", .example = "10 m"),
    WORD(leaf_motion,
         "How leaves turn; affects the picture only, not the loads: eq13 (Tang et al. 2012), noise (Zhao & "
         "Zhang 2013).",
         .absent = "the preset's, else eq13", .example = "noise"),
    QUANTITY("leaf_amplitude", leaf_amplitude, WF_DIM_ANGLE, "deg", 0, 180,
             "Largest turn by one of the three noises, M_x = M_y = M_z.", .absent = "30 deg",
             .example = "30 deg"),
    QUANTITY("leaf_follow", leaf_follow, WF_DIM_NONE, NULL, -10, 10,
             "lambda: share of theta_x added to theta_z.", .initial = "0.5", .example = "0.5"),
    QUANTITY("leaf_period", leaf_period, WF_DIM_TIME, "s", 1e-3, 3600, "Period of the noise's first octave.",
             .initial = "1 s", .example = "1 s"),
    { .key = "explain",
      .kind = WF_YAML_CHOICE,
      .choices = no_yes,
      .initial = "no",
      AT(explain),
      .doc = "Every method against beam theory on this tree in the mean wind, branch by branch.",
      .example = "yes" },
    { .key = "keys",
      .kind = WF_YAML_INTEGER,
      .low = 1,
      .high = 64,
      .initial = "1",
      AT(keys),
      .doc = "Key frames, evenly spaced from the first frame.",
      .example = "8" },
    { .key = "seed",
      .kind = WF_YAML_INTEGER,
      .low = 0,
      .high = 1e9,
      .initial = "1",
      AT(seed),
      .doc = "Of the random numbers.",
      .example = "1" },
    { .key = NULL },
};

static bool given(const char *word, const char *none) { return word && *word && strcmp(word, none) != 0; }

static bool unused_if(bool unused, char *why, size_t size, const char *with, const char *name)
{
    if (unused) (void)snprintf(why, size, "with %s '%s'", with, name);
    return unused;
}

/* Values of the gust model; NULL: a steady wind. */
static bool gust_unused(const struct wf_series_plan_run *r, const struct wf_gust_model *m, size_t member,
                        char *why, size_t size)
{
    const size_t record = offsetof(struct wf_series_plan_run, record);
    bool of_record = member == offsetof(struct wf_series_plan_run, file) ||
                     (member >= record && member < record + sizeof r->record);
    bool period = false, unused = false;
    for (const struct wf_gust_par *p = m ? m->par : NULL; p && p->name; p++)
        period |= strcmp(p->name, "period") == 0;
    if (member == offsetof(struct wf_series_plan_run, wind))
        unused = m && !wf_gust_takes_speed(m, r->set) && !given(r->explain, "no");
    else if (of_record)
        unused = !m || strcmp(m->name, "record") != 0;
    else if (member == offsetof(struct wf_series_plan_run, intensity))
        unused = !m || m->own_intensity;
    else if (member == offsetof(struct wf_series_plan_run, period))
        unused = !m || !period;
    else
        unused = !m;
    return unused_if(unused, why, size, "the gust model", m ? m->name : "steady");
}

/* Values of leaves that turn by noise. */
static bool leaves_unused(const struct wf_series_plan_run *r, char *why, size_t size)
{
    const struct wf_preset *p = wf_preset_named(r->preset ? r->preset : "corrected");
    const char *motion = given(r->leaf_motion, "") ? r->leaf_motion : p && p->leaves ? p->leaves : "eq13";
    return unused_if(wf_leaf_motion_named(motion) && strcmp(motion, "noise") != 0, why, size,
                     "the motion of leaves", motion);
}

/* Values of the scheme that goes from frame to frame. */
static bool scheme_unused(const struct wf_series_plan_run *r, char *why, size_t size)
{
    const struct wf_preset *p = wf_preset_named(r->preset ? r->preset : "corrected");
    const char *name = given(r->solver, "") ? r->solver : p && p->solver ? p->solver : wf_solvers[0]->name;
    return unused_if(wf_solver_named(name) && strncmp(name, "deflect", 7) != 0, why, size, "the solver",
                     name);
}

bool wf_series_plan_unused(const struct wf_series_plan_run *r, size_t member, char *why, size_t size)
{
    const struct wf_gust_model *m = wf_gust_named(r->gust ? r->gust : "steady");
    if (given(r->gust, "steady") && !m) return false; /* the name is wrong */
    switch (member) {
    case offsetof(struct wf_series_plan_run, wind):
    case offsetof(struct wf_series_plan_run, intensity):
    case offsetof(struct wf_series_plan_run, period):
    case offsetof(struct wf_series_plan_run, set):
    case offsetof(struct wf_series_plan_run, file):
    case offsetof(struct wf_series_plan_run, record.columns):
    case offsetof(struct wf_series_plan_run, record.rate):
    case offsetof(struct wf_series_plan_run, record.missing):
    case offsetof(struct wf_series_plan_run, record.dates):
    case offsetof(struct wf_series_plan_run, components):
        return gust_unused(r, m, member, why, size);
    case offsetof(struct wf_series_plan_run, seed):
        return leaves_unused(r, why, size) &&
               unused_if(!m || m->fixed, why, size, "the gust model", m ? m->name : "steady");
    case offsetof(struct wf_series_plan_run, restoring):
    case offsetof(struct wf_series_plan_run, damping):
        return scheme_unused(r, why, size);
    case offsetof(struct wf_series_plan_run, transmission):
        return unused_if(!given(r->shelter, "none"), why, size, "shelter", "none");
    case offsetof(struct wf_series_plan_run, leaf_amplitude):
    case offsetof(struct wf_series_plan_run, leaf_follow):
    case offsetof(struct wf_series_plan_run, leaf_period):
        return leaves_unused(r, why, size);
    default:
        return member >= offsetof(struct wf_series_plan_run, profile) &&
               wf_profile_unused(&r->profile, member - offsetof(struct wf_series_plan_run, profile), why,
                                 size);
    }
}

static const char *preset_word(size_t i) { return wf_presets[i].name; }
static const char *solver_word(size_t i) { return wf_solvers[i] ? wf_solvers[i]->name : NULL; }
static const char *gust_word(size_t i) { return i ? wf_gust_models[i - 1].name : "steady"; }
static const char *shelter_word(size_t i) { return i ? wf_shelter_laws[i - 1].name : "none"; }
static const char *profile_word(size_t i) { return wf_profiles[i].name; }
static const char *leaf_word(size_t i) { return wf_leaf_motions[i].name; }

/* Report a word that is none of a list of rows. */
static void check_word(struct wf_yaml *y, const char *key, const char *said, const char *(*word)(size_t i))
{
    const char *known[40];
    size_t n = 0;
    for (; said && n < WF_COUNT(known) && (known[n] = word(n)); n++)
        if (strcmp(known[n], said) == 0) return;
    if (said)
        wf_yaml_error(y, key, "'%.60s' is not known%s", said,
                      wf_did_you_mean_or(said, known, n, "there are: ").text);
}

/* Report values of a run that have no effect. The wind is required, also where a record has its own. */
static void run_finish(struct wf_yaml *y, void *run)
{
    const struct wf_series_plan_run *r = run;
    char why[200];
    check_word(y, "preset", r->preset, preset_word);
    check_word(y, "solver", r->solver, solver_word);
    check_word(y, "gust", r->gust, gust_word);
    check_word(y, "shelter", r->shelter, shelter_word);
    check_word(y, "profile", r->profile.name, profile_word);
    check_word(y, "leaf_motion", r->leaf_motion, leaf_word);
    for (const struct wf_yaml_row *row = run_rows; row->key; row++)
        if (!row->required && wf_yaml_has(y, row->key) &&
            wf_series_plan_unused(run, row->offset, why, sizeof why))
            wf_yaml_error(y, row->key, "has no effect %s", why);
}

static const struct wf_yaml_table run_table = { .title = "a run",
                                                .row = run_rows,
                                                .size = sizeof(struct wf_series_plan_run),
                                                .finish = run_finish,
                                                .doc = "" };

static const struct wf_yaml_row plan_rows[] = {
    { .key = "runs_of",
      .kind = WF_YAML_NAME,
      .required = true,
      .offset = offsetof(struct wf_series_plan, key),
      .doc = "Key of the runs, as its file's name.",
      .example = "tang2012" },
    { .key = "title",
      .kind = WF_YAML_TEXT,
      .required = true,
      .offset = offsetof(struct wf_series_plan, title),
      .doc = "Title of the page.",
      .example = "Moso bamboo in wind" },
    { .key = "note",
      .kind = WF_YAML_TEXT,
      .offset = offsetof(struct wf_series_plan, note),
      .doc = "Note at the head of the page.",
      .example = "As printed and corrected." },
    { .key = "source",
      .kind = WF_YAML_TEXT,
      .offset = offsetof(struct wf_series_plan, source),
      .doc = "Source of the runs.",
      .example = "Tang et al. 2012" },
    { .key = "runs",
      .kind = WF_YAML_LIST,
      .required = true,
      .low = 1,
      .high = 64,
      .table = &run_table,
      .offset = offsetof(struct wf_series_plan, run),
      .count = offsetof(struct wf_series_plan, runs),
      .doc = "The runs, in the order of the page.",
      .example = "" },
    { .key = NULL },
};
static const struct wf_yaml_table plan_table = {
    .title = "Runs in time", .row = plan_rows, .size = sizeof(struct wf_series_plan), .doc = ""
};

enum wf_status wf_series_plan_read(const char *path, struct wf_arena *a, struct wf_series_plan *out,
                                   struct wf_diag *d, struct wf_err *e)
{
    *out = (struct wf_series_plan){ 0 };
    enum wf_status status = wf_yaml_read(path, &plan_table, out, a, d, e);
    if (!status && !(out->file = wf_arena_text(a, path))) return wf_fail(e, WF_ENOMEM, "no memory");
    return status;
}

char *wf_series_plan_schema(struct wf_arena *a, struct wf_err *e)
{
    return wf_yaml_schema(&plan_table, a, e);
}

enum wf_status wf_series_plan_spec(const struct wf_series_plan_run *r, const struct wf_species *sp,
                                   const struct wf_model *m, struct wf_arena *a, struct wf_series_spec *s,
                                   struct wf_err *e)
{
    struct wf_species *own = WF_TAKE(a, 1, struct wf_species);
    if (!own) return wf_fail(e, WF_ENOMEM, "no memory");
    *own = *sp;
    wf_series_default(s);
    s->name = r->name, s->species = own, s->model = m;
    s->preset = wf_preset_named(r->preset ? r->preset : "corrected");
    if (!s->preset) return wf_fail(e, WF_EUSAGE, "run '%s': unknown preset '%s'", r->name, r->preset);
    s->profile = r->profile;
    if (r->profile.name && !wf_profile_named(r->profile.name))
        return wf_fail(e, WF_EUSAGE, "run '%s': unknown wind profile '%s'", r->name, r->profile.name);
    if (wf_preset_apply(s->preset, a, own, &s->scenario, &s->solver, e)) return e->code;
    if (given(r->solver, "") && !(s->solver = wf_solver_named(r->solver)))
        return wf_fail(e, WF_EUSAGE, "run '%s': unknown solver '%s'", r->name, r->solver);
    if (given(r->gust, "steady")) s->gust = r->gust;
    if (s->gust && !wf_gust_named(s->gust))
        return wf_fail(e, WF_EUSAGE, "run '%s': unknown gust model '%s'", r->name, s->gust);
    if (given(r->shelter, "none") && !(s->shelter = wf_shelter_law_named(r->shelter)))
        return wf_fail(e, WF_EUSAGE, "run '%s': unknown shelter law '%s'", r->name, r->shelter);
    s->gust_set = r->set, s->gust_file = r->file;
    s->record = r->record;
    if (!s->record.columns) s->record.columns = WF_RECORD_COLUMNS;
    if (r->components == 2) return wf_fail(e, WF_EUSAGE, "run '%s': components: 1 or 3, not 2", r->name);
    s->components = (unsigned)r->components;
    s->speed = r->wind, s->intensity = r->intensity, s->period = r->period, s->youngs = r->youngs;
    s->seed = r->seed;
    if (!isnan(r->step)) s->step = r->step;
    if (!isnan(r->restoring)) s->restoring = r->restoring;
    if (!isnan(r->damping)) s->damping = r->damping;
    if (!isnan(r->transmission)) s->transmission = r->transmission;
    const char *leaf = given(r->leaf_motion, "") ? r->leaf_motion : s->preset->leaves;
    if (leaf && !(s->leaf_motion = wf_leaf_motion_named(leaf)))
        return wf_fail(e, WF_EUSAGE, "run '%s': unknown motion of leaves '%s'", r->name, leaf);
    if (!isnan(r->leaf_amplitude)) wf_leaf_amplitude(r->leaf_amplitude, &s->flutter);
    if (!isnan(r->leaf_follow)) s->flutter.follow = r->leaf_follow;
    if (r->leaf_period > 0) s->leaf_period = r->leaf_period;
    double frames = isnan(r->duration) ? 1 : floor(r->duration / s->step + 1e-9);
    if (!(frames <= 1e6))
        return wf_fail(e, WF_EUSAGE, "run '%s': %.0f frames are too many (1e6)", r->name, frames);
    s->frames = (size_t)fmax(frames, 1);
    s->keys = r->keys ? r->keys : 1;
    return WF_OK;
}
