#ifndef WF_WIND_GUST_ROWS_H
#define WF_WIND_GUST_ROWS_H
/* The functions behind the rows of wf_gust_models; for gust.c only. */
#include "wind/gust.h"

enum wf_status wf_gust_spectral_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_gust_spectral_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                     struct wf_err *e);
void wf_gust_spectral_close(struct wf_gust *g);

enum wf_status wf_gust_direct_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_gust_cosine_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e);
enum wf_status wf_gust_sine_perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                        struct wf_err *e);
enum wf_status wf_gust_zhao_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                 struct wf_err *e);
enum wf_status wf_gust_perlin_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e);
enum wf_status wf_gust_eog_fill(struct wf_gust *g, size_t first, size_t steps, double *out, struct wf_err *e);
enum wf_status wf_gust_record_open(struct wf_gust *g, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_gust_record_fill(struct wf_gust *g, size_t first, size_t steps, double *out,
                                   struct wf_err *e);

/* Speed change of the extreme operating gust over its mean, at time t after its start [m/s]. */
double wf_gust_eog(double amplitude, double duration, double t);
/* Its amplitude for a specification [m/s]. */
double wf_gust_eog_amplitude(const struct wf_gust_spec *s);
/* Octaves of the perlin rows as set in the specification, stationary. */
struct wf_octaves;
void wf_gust_octaves(const struct wf_gust_spec *s, struct wf_octaves *o);
/* Distance along the wind and mean wind of a point. */
double wf_gust_place(const struct wf_gust_spec *s, size_t point, int axis);
double wf_gust_mean(const struct wf_gust_spec *s, size_t point);
#endif
