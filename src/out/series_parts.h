#ifndef WF_OUT_SERIES_PARTS_H
#define WF_OUT_SERIES_PARTS_H
/* Between the files that write runs in time. */
#include "base/file.h"
#include "out/plot_data.h"
#include "out/series.h"

/* Place along the wind [m]: with the height above ground the plane the panels show. */
double wf_series_along(const struct wf_series *s, const double x[3]);
/* A comma and the number, or nothing after the comma where it is not finite. */
void wf_series_number(FILE *f, double x);
enum wf_status wf_series_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e);

/* The largest group of single frames that differ in the modulus alone. Returned: its size, 0 below three, and
 * one of its runs in *first; as facts for the figure script SWEPT, the numbers of the runs. */
size_t wf_series_sweep(const struct wf_series_page *p, size_t *first);
void wf_series_sweep_facts(const struct wf_series_page *p, struct wf_plot_data *to);

/* tables/leaves.csv and leaf_angles.csv. */
enum wf_status wf_series_leaf_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e);
#endif
