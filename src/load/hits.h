/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_LOAD_HITS_H
#define WF_LOAD_HITS_H
/* Where drops on their way first meet leaves and wood: a hierarchy of boxes over triangles and frustums
 * (Kay & Kajiya 1986; median split), refitted when the bodies move. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

struct wf_body {
    int32_t at[3]; /* places of a triangle's corners; of a frustum's ends, at[2] = -1 */
    int32_t part;  /* of the caller: which leaf or axis                               */
    double r0, r1; /* radii of a frustum [m]                                          */
};
struct wf_box {
    double low[3], high[3];
    int32_t first, count; /* a leaf's bodies; count 0: children are the next box and `first` */
};
struct wf_hits {
    size_t n, boxes;
    struct wf_body *body; /* in the order of the boxes */
    struct wf_box *box;   /* a box before its children */
};
struct wf_hit {
    double when;     /* share of the way */
    double place[3]; /* [m]              */
    int32_t body, part;
    double weight[3]; /* of a triangle: shares of the corners; of a frustum: weight[0] along its axis */
};

/* Build over n bodies at their places (3 numbers each). Errors: WF_EINPUT for no bodies, WF_ENOMEM. */
enum wf_status wf_hits_build(const struct wf_body *body, size_t n, const double *place, struct wf_arena *a,
                             struct wf_hits *out, struct wf_err *e);
/* Fit the boxes to moved places. */
void wf_hits_refit(struct wf_hits *h, const double *place);
/* The first body on the way from `from` to `to` of a drop: a triangle by its middle, a frustum by its
 * surface. tests: bodies tried are added, unless NULL. */
bool wf_hits_first(const struct wf_hits *h, const double *place, const double from[3], const double to[3],
                   double radius, struct wf_hit *out, size_t *tests);
/* The same by trying all: for tests and for the count that the boxes save. */
bool wf_hits_first_of_all(const struct wf_hits *h, const double *place, const double from[3],
                          const double to[3], double radius, struct wf_hit *out);
#endif
