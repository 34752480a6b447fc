/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_SPEC_H
#define WF_WIND_GUST_SPEC_H
/* A gust model and the specification of a wind that it makes. The models are rows (wind/gust.h). */
#include "base/arena.h"
#include "base/err.h"
#include "wind/record.h"
#include "wind/spectrum.h"
#include <stdbool.h>
#include <stdint.h>

enum { WF_GUST_PARS = 8, WF_GUST_POINTS_MAX = 20000 };

struct wf_gust_par {
    const char *name, *unit;
    double fallback, low, high; /* default and allowed range, in `unit` */
    const char *help;
    bool whole; /* only whole numbers are allowed */
};

struct wf_gust_spec;
struct wf_gust;
struct wf_gust_model {
    const char *name, *title, *source, *validity;
    const char *corrected;         /* how it differs from the published form, and why; NULL: as published */
    unsigned components;           /* largest number of components: 1 or 3 */
    const char *spectrum;          /* row of wf_spectra; NULL: not based on a spectrum */
    const struct wf_gust_par *par; /* ends at name == NULL */
    enum wf_status (*open)(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
    enum wf_status (*fill)(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e);
    void (*close)(struct wf_gust *g); /* NULL: all memory is in the arena */
    bool own_intensity;               /* the intensity of the specification has no effect */
    bool fixed;                       /* nothing is drawn: the seed has no effect */
};
struct wf_gust_spec {
    const struct wf_gust_model *model;
    double speed;     /* mean wind [m/s]                                          */
    double height;    /* of a single point above the ground [m]                   */
    double intensity; /* standard deviation of the along-wind part / speed [-]    */
    double step;      /* [s]                                                      */
    size_t steps;
    size_t points;       /* 1 and place NULL: one point at `height`                  */
    const double *place; /* 3 a point: along the wind, across, above ground [m]      */
    const double *mean;  /* mean wind at each point [m/s]; NULL: `speed` everywhere  */
    unsigned components; /* 1 or 3                                                   */
    uint64_t seed;
    size_t block;                   /* steps a block; 0: chosen                                 */
    double value[WF_GUST_PARS];     /* in the order of model->par                    */
    const struct wf_record *record; /* model `record`                                */
};

struct wf_gust {
    struct wf_gust_spec spec;
    size_t block, blocks; /* steps in a block (the last may be shorter), number of blocks */
    double joint; /* expected discontinuity between blocks / standard deviation [-] (spectral models) */
    void *work;   /* state of the model */
};

/* Default specification: 10 m/s at 10 m, intensity 0.2, step 0.1 s, 10 min, one point, one component, seed 1,
 * and the model's default parameters. */
void wf_gust_spec_default(const struct wf_gust_model *m, struct wf_gust_spec *s);
/* Set a parameter of the model by name. Errors: WF_EUSAGE with the known parameters or the allowed range. */
enum wf_status wf_gust_set(struct wf_gust_spec *s, const char *name, double value, struct wf_err *e);
/* Value of a parameter of the model; NAN if it has no parameter of that name. */
double wf_gust_get(const struct wf_gust_spec *s, const char *name);

/* Parameters of the target spectrum at a point. */
struct wf_spectrum_par wf_gust_spectrum_par(const struct wf_gust_spec *s, size_t point);
/* Coordinate of a point [m]: axis 0 along the wind, 1 across, 2 above ground; and its mean wind [m/s]. */
double wf_gust_place(const struct wf_gust_spec *s, size_t point, int axis);
double wf_gust_mean(const struct wf_gust_spec *s, size_t point);

/* Set parameters of the model from a text "name=number,name=number"; NULL: none. Errors: those of
 * wf_gust_set; WF_EUSAGE for a text of another form; WF_ENOMEM. */
enum wf_status wf_gust_set_words(struct wf_gust_spec *s, const char *words, struct wf_arena *a,
                                 struct wf_err *e);
/* Whether a model makes a wind of the specified mean: a record has its own unless it is rescaled. Given:
 * `words` as in wf_gust_set_words; with mistakes in them, true. */
bool wf_gust_takes_speed(const struct wf_gust_model *m, const char *words);
/* Intensity and all parameters with their values as a text "name=number;..."; NULL without memory. */
char *wf_gust_words(const struct wf_gust_spec *s, struct wf_arena *a);
#endif
