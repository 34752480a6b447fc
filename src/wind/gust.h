#ifndef WF_WIND_GUST_H
#define WF_WIND_GUST_H
/* Wind that changes with time, at many points, in blocks of time. Models are rows, each with source, range
 * and parameters. Velocities are in wind axes: along the mean wind, across it to the left, up.
 * A value is a function of (seed, point, time) alone: any block may be made at any time, by any thread that
 * has a wf_gust of its own, and comes out the same to the byte. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include "wind/record.h"
#include "wind/spectrum.h"
#include <stdint.h>

enum { WF_GUST_PARS = 8, WF_GUST_POINTS_MAX = 20000 };

struct wf_gust_par {
    const char *name, *unit;
    double fallback, low, high; /* default and allowed range, in `unit` */
    const char *help;
};

struct wf_gust_spec;
struct wf_gust;
struct wf_gust_model {
    const char *name, *title, *source, *validity;
    const char *corrected;         /* what differs from the printed form and why; NULL: as printed */
    unsigned components;           /* most it can give: 1 or 3 */
    const char *spectrum;          /* row of wf_spectra; NULL: not made from a spectrum */
    const struct wf_gust_par *par; /* ends at name == NULL */
    enum wf_status (*open)(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
    enum wf_status (*fill)(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e);
    void (*close)(struct wf_gust *g); /* NULL: nothing but the arena */
};
extern const struct wf_gust_model wf_gust_models[]; /* ends at name == NULL */
const struct wf_gust_model *wf_gust_named(const char *name);

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
    double joint;         /* expected mismatch where blocks meet / standard deviation [-] (spectral models) */
    void *work;           /* the model's own */
};

/* 10 m/s at 10 m, intensity 0.2, 0.1 s, 10 min, one point, one component, seed 1, the model's defaults. */
void wf_gust_spec_default(const struct wf_gust_model *m, struct wf_gust_spec *s);
/* Set a model's parameter by name. WF_EUSAGE names the parameters there are and the allowed range. */
enum wf_status wf_gust_set(struct wf_gust_spec *s, const char *name, double value, struct wf_err *e);
double wf_gust_get(const struct wf_gust_spec *s, const char *name); /* NAN: the model has no such parameter */

/* Everything wrong with a specification, as findings; warnings for use outside a model's range.
 * Returned: WF_EUSAGE when there is any error. */
enum wf_status wf_gust_check(const struct wf_gust_spec *s, struct wf_diag *d, struct wf_err *e);

/* Check and make ready. Memory from the arena; wf_gust_close gives back what is not in the arena. */
enum wf_status wf_gust_open(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                            struct wf_gust *g, struct wf_err *e);
/* Make block `index`. Returned: out[(c * points + p) * block + i] = velocity component c at point p, step
 * index * block + i [m/s]; room for components * points * block numbers. Entries past the last step are 0. */
enum wf_status wf_gust_block(struct wf_gust *g, size_t index, double *out, struct wf_err *e);
void wf_gust_close(struct wf_gust *g);

/* One component's whole series at one point into out[steps]; `block` is room for one block. */
enum wf_status wf_gust_series(struct wf_gust *g, size_t point, unsigned component, double *block, double *out,
                              struct wf_err *e);

/* Target spectrum [m2/s] of a component at a point; NAN where the model is not made from a spectrum. */
double wf_gust_target(const struct wf_gust_spec *s, size_t point, enum wf_component c, double f);
/* Variance of a component at a point [m2/s2] that a series of this step can hold (up to half the sampling
 * frequency); for models without a spectrum the variance of the model; NAN: not known in advance. */
double wf_gust_variance(const struct wf_gust_spec *s, size_t point, enum wf_component c);
/* Parameters of the target spectrum at a point. */
struct wf_spectrum_par wf_gust_spectrum_par(const struct wf_gust_spec *s, size_t point);
#endif
