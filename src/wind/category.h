/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_CATEGORY_H
#define WF_WIND_CATEGORY_H
/* Terrain categories: mean wind, turbulence and its length over flat ground of one roughness.
 * Source: EN 1991-1-4:2005 + A1:2010, 4.3 to 4.5, table 4.1, and B.1; orography factor and turbulence factor
 * k_I are 1. Validity: strong wind (neutral air), flat ground of this roughness for some kilometres upwind,
 * up to 200 m. Below z_min the values of z_min hold. */

#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_category {
    const char *name;        /* "II" */
    double roughness, least; /* z0, z_min [m] */
    const char *text;        /* what the ground looks like */
};
extern const struct wf_category wf_categories[]; /* 0, I, II, III, IV; ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_category *wf_category_named(const char *name);
/* The one over which reference winds are given: II, open country. */
const struct wf_category *wf_category_open(void);

/* Roughness factor c_r at a height above ground [m]: mean wind over the basic wind, which is the 10-min mean
 * at 10 m over category II [-] (4.3.2). */
double wf_category_factor(const struct wf_category *c, double z);
/* Turbulence intensity I_v [-] (4.4). */
double wf_category_turbulence(const struct wf_category *c, double z);
/* Length scale of turbulence L [m] (B.1). */
double wf_category_length(const struct wf_category *c, double z);
/* Speed of the gust over the 10-min mean: sqrt(1 + 7 I_v), the wind of the peak velocity pressure (4.5) [-].
 */
double wf_category_gust(const struct wf_category *c, double z);

/* Sites as a person names them. */
struct wf_site_kind {
    const char *name;     /* "suburb" */
    const char *category; /* terrain that the wind comes over */
    const char *text;
    bool stand; /* the tree is in a stand or at its edge */
    bool edge;  /* at its upwind edge */
};
extern const struct wf_site_kind wf_site_kinds[]; /* ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_site_kind *wf_site_kind_named(const char *name);

#ifdef __cplusplus
}
#endif
#endif
