/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_STUDY_RAIN_RUN_H
#define WF_STUDY_RAIN_RUN_H
/* Rain on a branch with leaves, step by step: drops fall, hit, rest, run, merge, hang and fall, and the
 * branch answers. Budgets of water and energy are kept from the first step. */
#include "load/rain.h"
#include "study/rain_scene.h"

enum { WF_RAIN_KEYS = 8 };

struct wf_rain_spec {
    struct wf_scene_spec scene;
    struct wf_water_law water;
    size_t grid;                  /* cells of a leaf, along and across                             */
    bool printed;                 /* impacts and loads as printed; `water` has its own mark        */
    struct wf_rain rain;          /* its area is set by the run                                    */
    size_t drops;                 /* in the air at the peak; 0: by intensity                       */
    double fall;                  /* start of the drops above the scene [m]                        */
    const double *wind;           /* horizontal wind at the branch per step, 2 each [m/s]; NULL: calm */
    double loss;                  /* epsilon: energy lost on impact, as printed (2) [-]            */
    double splash;                /* share of a drop that splashes off [-]                         */
    double lever;                 /* phi_t: cap of the lever d/L, as printed [-]                   */
    double duration, step, frame; /* [s]; frame: between rows of the series                     */
    enum wf_prism_method method;
    double damping; /* ratio at the lowest frequency [-]                             */
    bool staged;    /* drops on the first leaf by a plan, in place of rain           */
    bool shaken;    /* drops on a leaf feel its acceleration: an upper bound of what falls off */
};

/* A state of the scene that is kept. */
struct wf_rain_key {
    const char *event; /* "hit", "ran", "merged", "hung", "fell", "rebound", "end" */
    double time;
    size_t leaf;                 /* the one that it happened on */
    double *place;               /* 3 per place of the scene   */
    struct wf_leaf_water *water; /* of that leaf, without its grid: wet is NULL */
    float *wetness;              /* map x map of that leaf: gamma */
    float *height;               /* map x map: depth of water [m] */
    size_t air;                  /* drops in the air: 6 numbers each, place and velocity */
    double *drop;
};
enum { WF_RAIN_MAP = 56, WF_RAIN_AIR_SHOWN = 400 };

/* A row of the series. */
struct wf_rain_row {
    double time;
    size_t air, state[WF_DROP_STATES];
    double held, film, fell, ground, wetted; /* [kg]; wetted: share of the first leaf */
    double tip[3], branch_tip[3]; /* displacement of the first leaf's tip and of the branch's [m] */
    double twist;                 /* of the first leaf about its vein [rad] */
    double petiole_force, petiole_moment,
        branch_moment; /* by water: at the root of the first leaf, of the branch [N, N m] */
    double energy;     /* kinetic and of springs [J] */
};
struct wf_rain_event {
    double time, mass;
    size_t leaf;
    const char *what; /* "hit", "wood" or of wf_water_events */
};
/* Water [kg]: rain = air + ground + splash + wood + held + film; drips are told in `ground` when they land.
 */
struct wf_water_budget {
    double rain, air, ground, splash, wood, held, film, off; /* off: what is left over, over rain [-] */
};
struct wf_energy_budget {
    double start, end;                                /* kinetic and of springs [J] */
    double weight, load, wind, push, damping, solver; /* load: of the water */
    double drops; /* kinetic energy that drops arrived with, relative to what they hit [J] */
    double off;   /* what is left over, over the largest part [-] */
};
struct wf_rain_result {
    const struct wf_rain_spec *spec;
    struct wf_rain_scene scene;
    struct wf_leaf_water *leaf;
    size_t steps, rows, keys, events, events_all;
    struct wf_rain_row *row;
    struct wf_rain_event *event;
    struct wf_rain_key key[WF_RAIN_KEYS];
    struct wf_water_budget water;
    struct wf_energy_budget energy;
    size_t hits, wood_hits, missed, tests, ways; /* tests: bodies tried; ways: of drops */
    size_t uncounted;                            /* drops beyond those that are followed: `ground` */
    double frequency, damping;                   /* lowest, at rest [Hz]; c [1/s] */
    double euler_limit;                          /* largest stable explicit step [s] */
    double fallen_at, struck_at; /* times of the last drop that fell off, and of the last hit; NAN, 0: none */
    double ring_frequency, ring_decrement; /* of the first leaf's tip after both; NAN: too few swings */
    size_t iterations, factors;            /* of the implicit steps */
    double seconds;                        /* processor time of the steps [s] */
};

/* Defaults; printed: those of the paper. */
void wf_rain_spec_default(struct wf_rain_spec *s, bool printed);
/* Run. What of it is not physics is said by study/rain_departures.h. Errors: WF_EUSAGE for a
 * value out of range; those of the scene, the rain and the prisms; WF_EINTERRUPTED after nothing was made. */
enum wf_status wf_rain_run(const struct wf_rain_spec *s, struct wf_arena *a, struct wf_diag *d,
                           struct wf_rain_result *out, struct wf_err *e);
/* Frequency [Hz] and logarithmic decrement of a motion that rings down: n places, `step` apart. NAN where it
 * has fewer than four swings. */
void wf_ring_of(const double *x, size_t n, double step, double *frequency, double *decrement);
#endif
