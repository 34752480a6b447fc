/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/scene.h"
#include "base/num.h"
#include "wind/category.h"
#include "wind/shelter.h"
#include "wind/shelter_laws.h"
#include "wind/terrain.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char usual[] = "power", measured[] = "measured"; /* rows of wf_profiles */

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
    return w->name ? w->name : w->file ? measured : usual;
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
    double from = wf_wind_from(s->azimuth, north);
    enum wf_status status = wf_site_read(site, a, e);
    if (!status) status = wf_site_speed_up(site, from, s->reference_height, s->roughness, &s->speed_up, e);
    s->site = site;
    return status;
}

void wf_scenario_wind(const struct wf_scenario *s, struct wf_wind *out)
{
    *out = (struct wf_wind){
        .sample = wf_profile_named(s->profile)->sample,
        .direction = { cos(s->azimuth), sin(s->azimuth), 0.0 },
        .reference_height = s->reference_height,
        .roughness = s->roughness,
        .displacement = s->displacement,
        .exponent = s->exponent,
        .canopy_height = s->canopy_height,
        .attenuation = s->attenuation,
        .field = s->measured,
    };
}

double wf_scenario_speed(const struct wf_scenario *s, double named) { return named * s->speed_up; }

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
