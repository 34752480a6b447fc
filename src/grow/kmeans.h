/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_KMEANS_H
#define WF_GROW_KMEANS_H
/* Nodes of a branch from points on its surface, by k-means: Yang & Wu 2011, section 3.1. */
#include "base/arena.h"
#include "base/err.h"
#include <stddef.h>
#include <stdint.h>

struct wf_cloud {
    size_t n;
    double *at; /* 3 each [m] */
};
struct wf_clusters {
    size_t n;
    double *centre; /* 3 each, in the order along the branch [m] */
    int32_t *of;    /* per point: its cluster in that order      */
    size_t *count;  /* per cluster: its points                   */
    double spread;  /* mean distance of points from their centre [m] */
    size_t rounds;
    size_t moving; /* points that changed in the last round; 0: the clusters are settled */
};

/* Read a file of lines "x y z" (blanks, tabs or commas between, # begins a comment). Errors: WF_EINPUT with
 * every wrong line in `d`. */
enum wf_status wf_cloud_read(const char *path, struct wf_arena *a, struct wf_cloud *out, struct wf_diag *d,
                             struct wf_err *e);
/* n clusters of the points: centres started by k-means++ (Arthur & Vassilvitskii 2007) from `seed`, moved by
 * Lloyd's rounds until no point changes. Order: from the end of the longest direction nearest to `base` on to
 * the nearest centre not yet taken. Errors: WF_EINPUT for fewer points than clusters, or a cluster that stays
 * empty (points on top of one another); WF_ENOMEM. */
enum wf_status wf_kmeans(const struct wf_cloud *p, size_t n, uint64_t seed, const double base[3],
                         struct wf_arena *a, struct wf_clusters *out, struct wf_err *e);
#endif
