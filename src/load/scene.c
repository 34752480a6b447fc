/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/scene.h"
#include "base/num.h"
#include "wind/category.h"
#include "wind/design.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char usual[] = "power", measured[] = "measured", rough[] = "terrain"; /* rows of wf_profiles */

static double scenario_air_density(const struct wf_scenario *s);

void wf_scenario_default(struct wf_scenario *s)
{
    *s = (struct wf_scenario){
        .profile = usual,
        .reference_height = 10.0,
        .speed_up = 1.0,
        .roughness = 0.03, /* open grassland (Davenport class 3); the log profile only */
        .displacement = 0.0,
        .exponent = 0.16,
        .azimuth = 0.0,
        .temperature = 288.15,
        .altitude = 0.0,
        .air_density = NAN,
        .gravity = 9.81,
        .category = wf_category_open(),
        .named = { wf_category_open(), 0.0 },
        .carried = 1.0,
        .corridor_towards = NAN,
        .winter = 1.0,
        .peak = { .method = "en1991", .damping = NAN },
    };
}

/* A field of the scenario and its allowed range. */
struct limit {
    const char *name, *unit;
    double value, low, high;
};

enum wf_status wf_scenario_check(const struct wf_scenario *s, struct wf_err *e)
{
    const struct limit limits[] = {
        { "reference height", "m", s->reference_height, 0.01, 1000.0 },
        { "speed-up", "", s->speed_up, 0.1, 5.0 },
        { "wind at the site over the wind named", "", s->carried, 0.05, 5.0 },
        { "roughness length", "m", s->roughness, 1e-6, 10.0 },
        { "displacement height", "m", s->displacement, 0.0, 100.0 },
        { "canopy height", "m", s->canopy_height, 0.0, 100.0 },
        { "attenuation", "", s->attenuation, 0.0, 10.0 },
        { "power-law exponent", "", s->exponent, 0.0, 1.0 },
        { "azimuth", "rad", s->azimuth, -4.0 * WF_PI, 4.0 * WF_PI },
        { "temperature", "K", s->temperature, 200.0, 340.0 },
        { "altitude", "m", s->altitude, -500.0, 11000.0 },
        { "air density", "kg/m3", isnan(s->air_density) ? 1.0 : s->air_density, 1e-6, 2000.0 },
        { "gravity", "m/s2", s->gravity, 0.0, 100.0 },
        { "distance of the corridor", "m", s->corridor, 0.0, 1000.0 },
        { "limit of the tip's turn", "rad", s->tip_angle, 0.0, WF_PI },
        { "distance between nodes", "m", s->node_spacing, 0.0, 10.0 },
    };
    if (!s->profile || !wf_profile_named(s->profile))
        return wf_fail(e, WF_EUSAGE, "unknown wind profile '%s'", s->profile ? s->profile : "");
    if (s->shelter && !wf_shelter_law_named(s->shelter))
        return wf_fail(e, WF_EUSAGE, "unknown shelter law '%s'", s->shelter);
    for (size_t i = 0; i < WF_COUNT(limits); i++)
        if (!(limits[i].value >= limits[i].low && limits[i].value <= limits[i].high))
            return wf_fail(e, WF_EUSAGE, "%s %.6g %s is outside %.6g..%.6g", limits[i].name, limits[i].value,
                           limits[i].unit, limits[i].low, limits[i].high);
    struct wf_wind wind;
    wf_scenario_wind(s, &wind);
    if (wf_wind_form(&wind) == WF_PROFILE_FLOOR && !(s->least > 0.0))
        return wf_fail(e, WF_EUSAGE, "the profile 'code' belongs to the wind of a design code");
    if (wind.sample == wf_canopy_sample && !(s->canopy_height > 0.0 || s->displacement > 0.0))
        return wf_fail(e, WF_EUSAGE, "the canopy profile needs the canopy height or the displacement height");
    if (s->measured && wind.sample == wf_measured_sample && wf_measured_blow(s->measured, &wind, e))
        return e->code;
    return wf_wind_check(&wind, e);
}

/* Defaults of the canopy profile from the canopy height; where that is missing it follows from the
 * displacement height. */
static void complete_canopy(struct wf_scenario *s, const struct wf_profile_words *w)
{
    double height = s->canopy_height > 0.0 ? s->canopy_height : s->displacement / 0.7;
    if (isnan(w->displacement)) s->displacement = 0.7 * height;
    if (isnan(w->roughness) && height > 0.0) s->roughness = 0.1 * height;
}

#define NUMBER(k)                                                                                            \
    {                                                                                                        \
#k, offsetof(struct wf_profile_words, k), offsetof(struct wf_scenario, k)                            \
    }
const struct wf_profile_number wf_profile_numbers[] = {
    NUMBER(exponent),      NUMBER(roughness),   NUMBER(displacement),
    NUMBER(canopy_height), NUMBER(attenuation), { 0 },
};

static double number_said(const struct wf_profile_words *w, size_t member)
{
    return *(const double *)(const void *)((const char *)w + member);
}

/* Name of the profile that is meant. */
static const char *profile_meant(const struct wf_profile_words *w)
{
    const struct wf_design *design = wf_design_named(w->design.code);
    if (w->name || w->file) return w->name ? w->name : measured;
    return design ? design->profile : w->design.terrain || w->site ? rough : usual;
}

/* Whether a list of words with blanks between holds a word. */
static bool lists(const char *list, const char *word)
{
    size_t n = strlen(word);
    for (const char *at = list; (at = strstr(at, word)); at += n)
        if ((at == list || at[-1] == ' ') && (at[n] == '\0' || at[n] == ' ')) return true;
    return false;
}

bool wf_profile_unused(const struct wf_profile_words *w, size_t member, char *why, size_t size)
{
    const struct wf_profile *p = wf_profile_named(profile_meant(w));
    const struct wf_profile_number *n = wf_profile_numbers;
    while (n->key && n->said != member) n++;
    if (!p || !n->key || isnan(number_said(w, member)) || lists(p->takes, n->key)) return false;
    if (w->ground && strcmp(n->key, "roughness") == 0) return false;
    (void)snprintf(why, size, "with the profile '%s', which takes %s", p->name,
                   *p->takes ? p->takes : "the reference height only");
    return true;
}

struct wf_wind_place wf_profile_place(const struct wf_profile_words *w)
{
    const double ten = 10.0;
    const struct wf_site_kind *kind = wf_site_kind_named(w->site);
    const char *terrain = w->design.terrain ? w->design.terrain : kind ? kind->category : NULL;
    const struct wf_category *own = terrain ? wf_category_named(terrain) : NULL;
    if (w->design.code || (own && !(w->at && strcmp(w->at, "site") == 0)))
        return (struct wf_wind_place){ wf_category_open(), ten };
    return (struct wf_wind_place){ own ? own : wf_category_open(),
                                   isnan(w->reference_height) ? ten : w->reference_height };
}

/* The wind of a design code at the site's reference height over that of open country. */
static enum wf_status set_design(struct wf_scenario *s, const struct wf_design_words *w, struct wf_err *e)
{
    struct wf_design_wind found;
    if (wf_design_find(w, &found, e)) return e ? e->code : WF_EUSAGE;
    s->design = found.code;
    s->category = found.category, s->category_said = w->terrain;
    s->gust_factor = found.basic * found.code->squall(wf_design_terrain_named(found.code, "II")) / found.open;
    s->squall = found.gust / found.mean;
    s->least = found.least;
    if (found.least > 0.0) s->exponent = found.exponent;
    struct wf_scenario at = *s;
    struct wf_wind wind;
    at.profile = found.code->profile, at.reference_height = 10.0;
    wf_scenario_wind(&at, &wind);
    wind.speed = found.mean / found.open;
    double x[3] = { 0.0, 0.0, s->reference_height }, u[3], du[9];
    wind.sample(&wind, x, u, du);
    s->carried = hypot(u[0], u[1]);
    return WF_OK;
}

static enum wf_status set_terrain(struct wf_scenario *s, const char *terrain, bool here, struct wf_err *e)
{
    s->category = wf_category_named(terrain);
    if (!s->category)
        return wf_fail(e, WF_EUSAGE, "unknown terrain category '%.20s'; there are 0, I, II, III and IV",
                       terrain);
    s->category_said = true;
    const struct wf_wind_place from = s->named;
    if (!here)
        s->carried = wf_category_factor(s->category, s->reference_height) /
                     wf_category_factor(from.terrain, from.height);
    return WF_OK;
}

/* The site's terrain, and the wind there. The reference height is set. */
static enum wf_status set_site(struct wf_scenario *s, const struct wf_profile_words *w, struct wf_err *e)
{
    struct wf_design_words design = w->design;
    const struct wf_site_kind *kind = wf_site_kind_named(w->site);
    bool here = w->at && strcmp(w->at, "site") == 0;
    if (w->site && !kind) return wf_fail(e, WF_EUSAGE, "unknown site '%.40s'", w->site);
    if (kind) s->site_kind = kind->name;
    if (kind && !design.terrain) design.terrain = kind->category;
    if (w->gust_factor > 0.0) s->gust_factor = w->gust_factor;
    if (w->at && !here && strcmp(w->at, "open") != 0)
        return wf_fail(e, WF_EUSAGE, "the winds are measured '%.40s'; open or site", w->at);
    if (w->at && (design.code || !design.terrain))
        return wf_fail(e, WF_EUSAGE, "where the wind was measured has no effect %s",
                       design.code ? "with a design wind" : "without a terrain or site");
    if (w->design.code || w->design.terrain || w->site) s->named = wf_profile_place(w);
    if (design.code) return set_design(s, &design, e);
    return design.terrain ? set_terrain(s, design.terrain, here, e) : WF_OK;
}

static enum wf_status set_profile_numbers(struct wf_scenario *s, const struct wf_profile_words *w,
                                          struct wf_err *e)
{
    char why[160];
    if (!isnan(w->reference_height)) s->reference_height = w->reference_height;
    for (const struct wf_profile_number *n = wf_profile_numbers; n->key; n++) {
        double said = number_said(w, n->said);
        if (wf_profile_unused(w, n->said, why, sizeof why))
            return wf_fail(e, WF_EUSAGE, "%s has no effect %s", n->key, why);
        if (!isnan(said)) *(double *)(void *)((char *)s + n->value) = said;
    }
    if (strcmp(s->profile, "canopy") == 0) complete_canopy(s, w);
    return WF_OK;
}

enum wf_status wf_scenario_words(struct wf_scenario *s, const struct wf_profile_words *w, struct wf_err *e)
{
    s->profile = profile_meant(w);
    enum wf_status status = set_profile_numbers(s, w, e);
    if (!status) status = set_site(s, w, e);
    if (!status && isnan(w->roughness) && strcmp(s->profile, rough) == 0)
        s->roughness = s->category->roughness;
    bool asked = strcmp(s->profile, measured) == 0;
    if (asked && !w->file)
        return wf_fail(e, WF_EUSAGE, "the profile '%s' needs a file of heights and speeds (profile file)",
                       measured);
    if (!asked && w->file)
        return wf_fail(e, WF_EUSAGE, "%s: a profile file is for the profile '%s', not '%s'", w->file,
                       measured, s->profile);
    return status;
}

enum wf_status wf_scenario_profile(struct wf_scenario *s, const struct wf_profile_words *w,
                                   struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status status = wf_scenario_words(s, w, e);
    if (status || !w->file) return status;
    struct wf_measured_profile *p = WF_TAKE(a, 1, struct wf_measured_profile);
    if (!p) return wf_fail(e, WF_ENOMEM, "not enough memory for a profile");
    s->measured = p, s->profile_file = w->file;
    return wf_measured_read(w->file, a, d, p, e);
}

enum wf_status wf_scenario_site(struct wf_scenario *s, struct wf_site *site, double north, struct wf_arena *a,
                                struct wf_err *e)
{
    enum wf_status status = wf_site_read(site, a, e);
    s->site = site;
    return status ? status : wf_scenario_turn(s, s->azimuth, north, e);
}

enum wf_status wf_scenario_turn(struct wf_scenario *s, double azimuth, double north, struct wf_err *e)
{
    s->azimuth = azimuth;
    if (!s->site) return WF_OK;
    return wf_site_speed_up(s->site, wf_wind_from(azimuth, north), s->reference_height, s->roughness,
                            &s->speed_up, e);
}

void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out)
{
    const struct wf_profile *p = wf_profile_named(s->profile);
    bool terrain = p->form == WF_PROFILE_TERRAIN;
    *out = (struct wf_wind){
        .sample = p->sample,
        .direction = { cos(s->azimuth), sin(s->azimuth), 0.0 },
        .reference_height = s->reference_height,
        .roughness = terrain ? s->category->roughness : s->roughness,
        .least = terrain ? s->category->least : s->least,
        .displacement = s->displacement,
        .exponent = s->exponent,
        .canopy_height = s->canopy_height,
        .attenuation = s->attenuation,
        .field = s->measured,
    };
}

double wf_scenario_speed(const struct wf_scenario *s, double named)
{
    return named * (s->speed_up * s->carried);
}

struct wf_wind_place wf_scenario_place(const struct wf_scenario *s)
{
    return (struct wf_wind_place){ s->named.terrain,
                                   s->named.height > 0.0 ? s->named.height : s->reference_height };
}

double wf_scenario_gust(const struct wf_scenario *s, double named)
{
    const struct wf_wind_place at = wf_scenario_place(s);
    return named * (s->gust_factor > 0.0 ? s->gust_factor : wf_category_gust(at.terrain, at.height));
}

double wf_scenario_squall(const struct wf_scenario *s, double height)
{
    const double ten = 10.0;
    const struct wf_wind_place at = wf_scenario_place(s);
    bool level = wf_profile_named(s->profile)->form == WF_PROFILE_UNIFORM;
    double here = s->squall > 0.0 ? s->squall
                                  : wf_scenario_gust(s, 1.0) / wf_category_gust(at.terrain, at.height) *
                                        wf_category_gust(s->category, ten);
    return level ? here : here * wf_category_gust(s->category, height) / wf_category_gust(s->category, ten);
}

enum wf_status wf_scenario_still(const struct wf_species *sp, double gravity, struct wf_loads *loads,
                                 struct wf_err *e)
{
    wf_loads_default(loads);
    loads->gravity = gravity;
    return wf_loads_laws(loads, sp, e);
}

enum wf_status wf_scenario_loads(const struct wf_scenario *s, const struct wf_species *sp,
                                 struct wf_wind *wind, struct wf_loads *loads, struct wf_err *e)
{
    enum wf_status status = wf_scenario_still(sp, s->gravity, loads, e);
    wf_scenario_wind(s, wind);
    loads->wind = wind;
    loads->air_density = scenario_air_density(s);
    loads->air_viscosity = wf_air_viscosity(s->temperature, loads->air_density);
    return status;
}

/* Air density [kg m-3]: as given, else from temperature and altitude. */
static double scenario_air_density(const struct wf_scenario *s)
{
    return isnan(s->air_density) ? wf_air_density(s->temperature, s->altitude) : s->air_density;
}
