#ifndef WF_STUDY_SERIES_WIND_H
#define WF_STUDY_SERIES_WIND_H
/* The changing wind of a series; for series.c. */
#include "study/series.h"

/* Fill s->wind, and s->across and s->up where the wind turns, from the gust model. */
enum wf_status wf_series_wind(struct wf_series *s, struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
/* Speed and direction of frame k in place of those of the mean wind. */
void wf_series_blow(const struct wf_series *s, size_t k, struct wf_wind *wind);
#endif
