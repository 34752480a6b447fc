#ifndef WF_LOAD_STREAMLINE_H
#define WF_LOAD_STREAMLINE_H
/* Streamlining: the share of a crown's still-air drag area left at a wind speed. Rows with source and range.
 */
#include <stddef.h>

struct wf_streamline_par {
    double exponent;             /* Vogel exponent V (vogel): area share ~ (U/reference)^V above reference */
    double reference_speed;      /* [m/s] */
    size_t n;                    /* table */
    const double *speed, *share; /* speeds strictly rising [m/s], shares [-] */
};

/* The corner of the Vogel law at the reference speed is rounded within this distance in ln(U/reference), so
 * that the force has a continuous derivative. The largest departure from the sharp law, at the reference
 * speed itself, is a factor exp(V/4 * 0.05): 0.9 % less drag for V = -0.7. Outside the band: exact. */
#define WF_VOGEL_ROUNDING 0.05

struct wf_streamline_law {
    const char *name, *source, *validity;
    double speed_low, speed_high; /* range of the law's own evidence [m/s] */
    /* Given: parameters, speed >= 0 [m/s]. Returned: share of still-air drag area [-], continuous with its
     * derivative *derivative [s/m]. */
    double (*share)(const struct wf_streamline_par *p, double speed, double *derivative);
};
extern const struct wf_streamline_law wf_streamline_laws[]; /* none, vogel, table; ends at name == NULL */
/* The row of that name; NULL when there is none. */
const struct wf_streamline_law *wf_streamline_named(const char *name);
#endif
