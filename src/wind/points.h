#ifndef WF_WIND_POINTS_H
#define WF_WIND_POINTS_H
/* Places at which a wind is wanted, from CSV. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stddef.h>

struct wf_points {
    size_t n;
    double *place; /* 3 a point: along the mean wind, across it to the left, above ground [m] */
    double *mean;  /* mean wind there [m/s]; NULL: the file does not say                      */
};

/* Read columns x_m, y_m, z_m and, where there is one, mean_ms; at most `most` points. Every bad cell is a
 * finding.
 */
enum wf_status wf_points_read(const char *path, size_t most, struct wf_arena *a, struct wf_diag *d,
                              struct wf_points *out, struct wf_err *e);
#endif
