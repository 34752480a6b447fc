#ifndef WF_CMD_WIND_STREAM_H
#define WF_CMD_WIND_STREAM_H
/* A gusty wind at many points written block by block: no more memory than a block takes. */
#include "wind/gust.h"

/* Make the wind and write it to `path`: a name that ends in .csv as text, columns as in tables/series.csv;
 * any other as a NumPy array (.npy, format 1.0) of 32-bit floats, steps x points x components. What came out
 * is printed beside what was asked for, unless quiet. */
enum wf_status wf_wind_stream(const struct wf_gust_spec *s, const char *path, bool quiet, struct wf_arena *a,
                              struct wf_diag *d, struct wf_err *e);
#endif
