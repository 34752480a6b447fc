#ifndef WF_GROW_LEVELS_H
#define WF_GROW_LEVELS_H
/* Trees of levels: a stem, the branches on it, those on them, each level by its own parameters (Tang and
 * others 2012: chains of frustum segments with an angle between neighbours, each branch at a relative
 * position of its parent with a start angle). */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/axes.h"

/* Given: a model of generator levels, the species' radii, an arena for scratch. Returned: *out, the axes
 * level by level; *capped, how many branches were thinned to the radius of their parent. Every random figure
 * of a branch has the address (seed, path of the branch), so it depends neither on the order of growing nor
 * on how many other branches there are. Errors: WF_ENOMEM; WF_EINPUT for more axes than WF_AXIS_ROWS_MAX. */
enum wf_status wf_levels_axes(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a,
                              struct wf_axes *out, size_t *capped, struct wf_err *e);

/* Radii by the pipe model on the levels that ask for it (Shinozaki, Yoda, Hozumi and Kira 1964, A
 * quantitative analysis of plant form: the pipe model theory): the rows of a tree grown from the axes.
 * Returned: *thick, how many branches came out thicker than the part they grow from. */
enum wf_status wf_levels_pipes(const struct wf_model *m, struct wf_tree *t, size_t *thick, struct wf_err *e);
#endif
