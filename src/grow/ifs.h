#ifndef WF_GROW_IFS_H
#define WF_GROW_IFS_H
/* Trees by an iterated function system (Zhao and Zhang 2013; Barnsley 1988, Fractals Everywhere): every map
 * of the system puts a smaller copy of the whole tree onto its axis, so the axes of level k are the images of
 * the stem under all products of k maps. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "grow/axes.h"

/* Given: a model of generator ifs, the radius of the stem's base, an arena for scratch. Returned: *out, the
 * axes level by level, all cut and tapered as the stem; *capped, how many were thinned to the radius of the
 * part they grow from. A copy stands on the place of its axis that is next on a grid of tenths of a segment.
 * Errors: WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_ifs_axes(const struct wf_model *m, double base_radius, struct wf_arena *a,
                           struct wf_axes *out, size_t *capped, struct wf_err *e);
#endif
