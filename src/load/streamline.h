#ifndef WF_LOAD_STREAMLINE_H
#define WF_LOAD_STREAMLINE_H
/* Streamlining: the share of a crown's still-air drag area left at a wind speed. Rows with source and range. */
#include <stddef.h>

struct wf_streamline_par {
    double exponent;        /* Vogel exponent V (vogel): area share ~ (U/reference)^V above reference */
    double reference_speed; /* [m/s] */
    size_t n;               /* table */
    const double *speed, *share;
};
struct wf_streamline_law {
    const char *name, *source, *validity;
    double speed_low, speed_high; /* range of the law's own evidence [m/s] */
    /* share of still-air drag area at `speed`, and its derivative [s/m] */
    double (*share)(const struct wf_streamline_par *p, double speed, double *derivative);
};
extern const struct wf_streamline_law wf_streamline_laws[]; /* none, vogel, table; ends at name == NULL */
const struct wf_streamline_law *wf_streamline_named(const char *name);
#endif
