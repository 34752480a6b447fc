#include "study/preset.h"
#include "study/preset_departures.h"
#include <math.h>
#include <string.h>

const struct wf_preset wf_presets[] = {
    { .name = "corrected",
      .title = "physics and SI units throughout",
      .source = "the sources of the species table and of the solver",
      .drag = NAN,
      .lift = NAN,
      .air_density = NAN },
    { .name = "tang2012",
      .title = "chain of solid cantilevers that hand down force alone",
      .source =
          "Tang L., Zou J., Lin D., Chen C. 2012. Visual simulating virtual tree movement in wind. Trans. "
          "Chin. Soc. Agric. Mach. 43(1):165-168",
      .solver = "chain-as-printed",
      .gust = "cosine",
      .drag = NAN, /* named mu_d, mu_l; no values printed */
      .lift = NAN,
      .air_density = NAN,
      .solid = true,
      .rigid = true,
      .departures = wf_departures_tang,
      .in_time = wf_departures_tang_in_time },
    { .name = "feng1999",
      .title = "inextensible rods in three angles a segment",
      .source =
          "Feng J., Yan T., Chen Y., Wu E. 1999. Research on whole tree's movement and tree's inner wind "
          "field. J. Software",
      .solver = "rod-as-printed",
      .drag = NAN,
      .lift = NAN,
      .air_density = NAN,
      .rigid = true,
      .departures = wf_departures_feng },
    { .name = "zhao2013",
      .title = "rods turned by their own wind force, R cubed",
      .source = "Zhao P., Zhang Z. 2013. Research on fast dynamic simulation of IFS trees swaying. Computer "
                "Engineering and Applications 49(14):160-163",
      .solver = "deflect-as-printed",
      .gust = "sine-perlin-as-printed",
      .leaves = "noise",
      .drag = WF_ZHAO_DRAG,
      .lift = WF_ZHAO_LIFT,
      .air_density = WF_ZHAO_AIR,
      .solid = true,
      .rigid = true,
      .departures = wf_departures_zhao,
      .in_time = wf_departures_zhao_in_time },
    { .name = NULL },
};

const struct wf_preset *wf_preset_named(const char *name)
{
    for (const struct wf_preset *p = wf_presets; p->name; p++)
        if (!strcmp(p->name, name)) return p;
    return NULL;
}

static struct wf_value printed(double value, const char *source)
{
    return (struct wf_value){ value, value, value, WF_PRINTED, source, true, NULL };
}

enum wf_status wf_preset_apply(const struct wf_preset *p, struct wf_arena *a, struct wf_species *sp,
                               struct wf_scenario *sc, const struct wf_solver **solver, struct wf_err *e)
{
    if (!p->departures) return WF_OK;
    struct wf_level *level = WF_TAKE(a, sp->levels, struct wf_level);
    struct wf_yaml_pair *source = WF_TAKE(a, sp->sources + 1, struct wf_yaml_pair);
    if (!level || !source) return wf_fail(e, WF_ENOMEM, "no room for the species");
    memcpy(level, sp->level, sp->levels * sizeof *level);
    if (sp->sources) memcpy(source, sp->source, sp->sources * sizeof *source);
    if (!wf_species_source(sp, p->name)) source[sp->sources++] = (struct wf_yaml_pair){ p->name, p->source };
    sp->level = level;
    sp->source = source;
    sp->preset = p->name;
    for (size_t i = 0; i < sp->levels; i++) {
        if (p->solid) level[i].wall = (struct wf_along){ 0 };
        if (!isnan(p->drag)) level[i].drag_coefficient = printed(p->drag, p->name);
        if (!isnan(p->lift)) level[i].lift_coefficient = printed(p->lift, p->name);
    }
    if (!isnan(p->drag) && sp->crown_drag.given) sp->crown_drag = printed(p->drag, p->name);
    if (p->rigid) sp->streamlining = (struct wf_law_use){ .law = "none" };
    if (!isnan(p->air_density)) sc->air_density = p->air_density;
    if (p->solver) *solver = wf_solver_named(p->solver);
    return *solver ? WF_OK : wf_fail(e, WF_EINTERNAL, "preset '%s' names no solver", p->name);
}

void wf_preset_warn(const struct wf_preset *p, const struct wf_analysis *an, struct wf_diag *d)
{
    if (p->departures) p->departures(an, d);
}
