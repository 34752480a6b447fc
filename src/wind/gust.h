/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_H
#define WF_WIND_GUST_H
/* Wind that changes with time, at many points, in blocks of time. Models are rows, each with source, range
 * and parameters. Velocities are in wind axes: along the mean wind, across it to the left, up.
 * A value is a function of (seed, point, time) alone: any block may be made at any time, by any thread that
 * has a wf_gust of its own, and comes out the same to the byte. */
#include "wind/gust_spec.h"

extern const struct wf_gust_model wf_gust_models[]; /* ends at name == NULL */
const struct wf_gust_model *wf_gust_named(const char *name);

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

struct wf_octaves; /* wind/noise.h */
/* Octaves of the perlin rows as set in the specification, stationary. */
void wf_gust_octaves(const struct wf_gust_spec *s, struct wf_octaves *o);

/* Its amplitude for a specification [m/s]. */
double wf_gust_eog_amplitude(const struct wf_gust_spec *s);

/* Columns of an anemometer file as wf_record_request_default has them, in words. */
#define WF_RECORD_COLUMNS "t_s,u_ms,v_ms,w_ms"
/* Read the anemometer file of the model `record` and hang it into the specification. Given: the file, its
 * columns "time,u[,v[,w]]". Errors: WF_EUSAGE without a file or with other columns, those of wf_record_read.
 */
enum wf_status wf_gust_record_words(struct wf_gust_spec *s, const char *file, const char *columns,
                                    struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
#endif
