/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_PEAK_H
#define WF_STUDY_PEAK_H
/* From the mean wind to the peak load of a tree: methods as rows. A method gives the factor G of the mean
 * wind load: drag and lift are computed at the mean wind speed on the deformed shape, with the crown
 * streamlined by the mean wind, and multiplied by G; weight is not. */
#include "load/drag.h"
#include "load/scene.h"
#include "wind/gust_factor.h"
#include <stdbool.h>

#ifdef __cplusplus
extern "C" {
#endif

/* How a tree sways along the wind about its state in a mean wind. */
struct wf_sway {
    double speed; /* named wind speed [m/s] */
    double
        frequency; /* of the modes with the largest share of the overturning by inertia along the wind [Hz] */
    double participation; /* that share [-] */
    double mass;          /* modal mass where the stem's tip moves by 1 [kg] */
    double air;           /* aerodynamic damping, not limited, of critical [-] */
};

enum { WF_PEAK_SWAYS = 24, WF_PEAK_OTHERS = 2 };
/* The peak load of one tree in the wind from one direction; by wf_sway_set_up (study/sway.h). */
struct wf_peak {
    const struct wf_peak_method *method;
    const struct wf_gust_rule *rule; /* NULL: the method has none */
    struct wf_gust_case tree;        /* terrain, size, exponent */
    double profile;                  /* mean wind at the rule's reference height over the named wind [-] */
    double gust;                     /* gust over mean wind at 0.6 of the tree's height, at most 10 m [-] */
    double least;                    /* of the factor: of a tree in a stand whose spacing is unknown [-] */
    double damping;                  /* structural, of critical [-] */
    bool damping_known;
    bool branches; /* branches have a factor of their own */
    const struct wf_streamline_law
        *law; /* of the crown, where the load of gusts follows it; NULL: the square */
    struct wf_law_values law_par;
    struct wf_peak_request request;
    /* For a load from the momentum of a stand: the tree and its loads in the wind. */
    struct wf_tree body;
    struct wf_loads loads;
    struct wf_wind wind;
    double exposure; /* wind at the tree over the named wind [-] */
    double top;      /* wind at the canopy top over that at the tree at the reference height [-] */
    size_t sways;    /* 0: unknown, the frequency of most resonance is taken */
    struct wf_sway sway[WF_PEAK_SWAYS];
    double air_rises;               /* slope of air by speed in still air [s/m] */
    double slope[2][WF_PEAK_SWAYS]; /* of frequency and air by speed, upwards; that of air in still air is
                                       above */
    struct wf_sway_search *more;    /* finds those at higher speeds when they are asked for (study/sway.h) */
    struct wf_track *about;         /* the states in mean winds about which sways are found, as long as `more`
                                       (solve/track.h); NULL: none */
    bool partial;                   /* those at higher speeds are not known */
    size_t others; /* sways at the highest specified speed of other choices of modes (study/sway.c) */
    struct wf_sway other[WF_PEAK_OTHERS];
    const double *still; /* 3n: displacements of the rows' ends in the first sway, that in still air; NULL:
                            not kept */
};

/* What a peak load was computed from; NAN: the method does not use it. */
struct wf_peak_parts {
    double factor; /* G, peak over mean wind load [-] */
    double frequency, participation, mass;
    double damping; /* total, limited; of critical [-] */
    double air;     /* aerodynamic share, not limited [-] */
    struct wf_gust_parts gust;
};

struct wf_peak_method {
    const char *name, *title, *source, *validity;
    bool sways;   /* needs sways of the tree */
    bool by_gust; /* the wind is that of the gust instead of the mean */
    void (*parts)(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out);
    /* Mean load over that of the wind profile on the tree; NULL: 1. */
    double (*mean)(const struct wf_peak *p, double speed);
};
extern const struct wf_peak_method wf_peak_methods[]; /* ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_peak_method *wf_peak_method_named(const char *name);

/* Read a table of the method 'table': columns speed_ms, ascending, and factor. Errors: WF_EINPUT with every
 * mistake in `d`. */
enum wf_status wf_peak_table_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                  struct wf_peak_table *out, struct wf_err *e);

/* p NULL: the load of the mean wind. */
/* The factor and what it was computed from, at a named wind speed [m/s]; of WF_PART_MEAN 1. */
void wf_peak_parts_at(const struct wf_peak *p, double speed, enum wf_part part, struct wf_peak_parts *out);
/* Factor on the load of the wind profile: that of the mean load times, but for WF_PART_MEAN, G. */
double wf_peak_factor(const struct wf_peak *p, double speed, enum wf_part part);
/* G of the load on the tree: peak over mean [-]. */
double wf_peak_gusts(const struct wf_peak *p, double speed);
/* Least and largest frequency of the sway [Hz] and G [-] by what is taken for the sway: one number each where
 * modes do not crowd. p as above. */
void wf_peak_doubt(const struct wf_peak *p, double speed, double frequency[2], double factor[2]);
/* Ratio of the wind that the loads are computed in to the named wind at the tree: 1, or that of the gust. */
double wf_peak_wind(const struct wf_peak *p, enum wf_part part);
/* Total damping from the structural one and that of the air, within limits of ours; `known`: the structural
 * one is not assumed [-]. */
double wf_peak_damping(double structural, bool known, double air);
/* Have branches a state of their own? */
static inline bool wf_peak_branches(const struct wf_peak *p) { return p && p->branches; }
/* Does the load of a state differ from that in the mean wind? */
bool wf_peak_differs(const struct wf_peak *p);
/* The sways, ascending in speed, are complete. */
void wf_peak_sways_take(struct wf_peak *p);

#ifdef __cplusplus
}
#endif
#endif
