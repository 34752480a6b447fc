/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_DESIGN_H
#define WF_WIND_DESIGN_H
/* Design winds of building codes and of arborists: from the basic wind of a code to the mean wind and the
 * gust at a site. Codes are rows, which own their terrains and constants. */
#include "base/err.h"
#include "wind/category.h"
#include "wind/wind.h"
#include <stddef.h>

#ifdef __cplusplus
extern "C" {
#endif

struct wf_design_terrain {
    const char *name;     /* the code's */
    const char *category; /* categories of EN 1991-1-4 with the same ground; the first stands for it */
    double value[9];      /* constants, as the code's functions take them */
};

struct wf_design {
    const char *name, *title, *source, *validity;
    const char *basic, *gust; /* in words: the basic wind with its averaging time; how the gust follows */
    const char *peak;         /* method of the peak load that belongs to it, a name of --peak */
    const char *profile;      /* row of wf_profiles: its mean wind by height */
    const struct wf_design_terrain *terrain; /* ends at name == NULL */
    double air;      /* density by which the code turns speed into pressure [kg m-3]; NAN: it is not known */
    double fallback; /* basic wind where none is given [m/s]; NAN: it is needed */
    double least;    /* least basic pressure of the code [Pa]; 0: none */
    /* Velocity pressure at a height [m] over that of the basic wind, each as the code averages it [-]. */
    double (*pressure)(const struct wf_design_terrain *t, double z);
    /* 10-min mean and gust at 10 m over the basic wind [-]. */
    double (*mean)(const struct wf_design_terrain *t);
    double (*squall)(const struct wf_design_terrain *t);
    /* Exponent and lowest height of the profile "code". NULL: another profile. */
    void (*shape)(const struct wf_design_terrain *t, double *exponent, double *least);
    /* Basic wind of a return period. NULL: the code's maps give it. */
    enum wf_status (*rare)(const struct wf_design_words *w, double *basic, struct wf_err *e);
};
extern const struct wf_design wf_designs[]; /* ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_design *wf_design_named(const char *name);
/* The code's terrain of that name, or with the ground of that category; NULL when there is none. */
const struct wf_design_terrain *wf_design_terrain_named(const struct wf_design *d, const char *name);

/* The design wind at a site: at 10 m above the ground; the arborists' wind is at the tree. */
struct wf_design_wind {
    const struct wf_design *code;
    const struct wf_design_terrain *terrain;
    const struct wf_category *category; /* the ground as EN 1991-1-4 names it */
    double basic;                       /* of the return period, averaged as the code does [m/s] */
    double open;                        /* 10-min mean over open country [m/s] */
    double mean, gust;                  /* 10-min mean and the code's gust at the site [m/s] */
    double exponent, least;             /* of the profile "code" [-], [m]; else 0 */
};
/* The design wind that the words name. Errors: WF_EUSAGE for a code, terrain, region, wind or return period
 * that is missing, unknown or outside its range. */
enum wf_status wf_design_find(const struct wf_design_words *w, struct wf_design_wind *out, struct wf_err *e);
/* Return period of a wind that is `ratio` times the design wind that the words name, by the code. Returned:
 * years; *end -1: it is shorter, the least of the code; 1: it is longer, 1e6 years. NAN: the code does not
 * say.
 */
double wf_design_years(const struct wf_design_words *w, double ratio, int *end);

#ifdef __cplusplus
}
#endif
#endif
