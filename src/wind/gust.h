/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_GUST_H
#define WF_WIND_GUST_H
/* Wind that changes with time, at many points, computed in blocks of time. Models are rows, each with source,
 * range and parameters. Velocities are in wind axes: along the mean wind, across it to the left, up.
 * A value depends only on (seed, point, time): blocks can be computed in any order and in several threads,
 * each with its own wf_gust, with the same result to the last bit. */
#include "wind/gust_spec.h"

extern const struct wf_gust_model wf_gust_models[]; /* ends at name == NULL */
/* The model of that name; NULL: none. */
const struct wf_gust_model *wf_gust_named(const char *name);

/* Check a specification and prepare the model. Given: specification, arena for the model's memory. Returned:
 * *g, to be closed by wf_gust_close. Warnings in `d` for use outside a model's range. Errors: WF_EUSAGE with
 * all mistakes of the specification in `d`; WF_ENOMEM. */
enum wf_status wf_gust_open(const struct wf_gust_spec *s, struct wf_arena *a, struct wf_diag *d,
                            struct wf_gust *g, struct wf_err *e);
/* Compute block `index`. Returned: out[(c * points + p) * block + i] = velocity component c at point p and
 * step index * block + i [m/s]; `out` has components * points * block numbers. Entries after the last step
 * are 0. Errors: WF_EUSAGE for an index that does not exist. */
enum wf_status wf_gust_block(struct wf_gust *g, size_t index, double *out, struct wf_err *e);
/* Free the memory of a model that is not in the arena. */
void wf_gust_close(struct wf_gust *g);

/* The whole series of one component at one point. Given: `block`, scratch for one block. Returned: out[steps]
 * [m/s]. */
enum wf_status wf_gust_history(struct wf_gust *g, size_t point, unsigned component, double *block,
                               double *out, struct wf_err *e);

/* Target spectrum of a component at a point and frequency f [Hz] -> [m2/s]; NAN if the model is not based on
 * a spectrum. */
double wf_gust_target(const struct wf_gust_spec *s, size_t point, enum wf_component c, double f);
/* Variance of a component at a point [m2/s2]: of the target spectrum up to half the sampling frequency; for
 * models without a spectrum that of the model; NAN: not known in advance. */
double wf_gust_variance(const struct wf_gust_spec *s, size_t point, enum wf_component c);

struct wf_octaves; /* wind/noise.h */
/* The octaves of the gradient-noise models as the specification sets them, with random shifts. */
void wf_gust_octaves(const struct wf_gust_spec *s, struct wf_octaves *o);

/* Amplitude of the extreme operating gust for a specification [m/s]. Source: IEC 61400-1:
 * min(1.35 (Ve1 - U), 3.3 sigma / (1 + 0.1 D / Lambda)), Lambda = 0.7 z up to 60 m, then 42 m. */
double wf_gust_eog_amplitude(const struct wf_gust_spec *s);

/* The columns of wf_record_request_default as a text. */
#define WF_RECORD_COLUMNS "t_s,u_ms,v_ms,w_ms"
/* How an anemometer file is read, as users say it. */
struct wf_record_words {
    const char *columns; /* "time,u[,v[,w]]"; the time "-" or empty: there is none, rows have a rate */
    const char *missing; /* see wf_record_request; NULL: not said                                    */
    const char *dates;   /* "day-first", "month-first"; NULL: not said                               */
    double rate;         /* of rows without a time [1/s]; NAN: not said                              */
};
/* Read an anemometer file for the model `record` and set s->record. Errors: WF_EUSAGE without a file or for
 * words of another form; those of wf_record_read. */
enum wf_status wf_gust_record_words(struct wf_gust_spec *s, const char *file,
                                    const struct wf_record_words *how, struct wf_arena *a, struct wf_diag *d,
                                    struct wf_err *e);
#endif
