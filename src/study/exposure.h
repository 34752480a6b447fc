#ifndef WF_STUDY_EXPOSURE_H
#define WF_STUDY_EXPOSURE_H
/* What the ground around a tree does to the wind it meets: from a height model to a factor a direction. */
#include "base/arena.h"
#include "base/err.h"
#include "wind/terrain.h"

struct wf_site {
    const char *file; /* ESRI ASCII grid                             */
    double x, y;      /* of the tree, in the map's coordinates [m]   */
    double steepest;  /* slope of the map [-]                        */
    double edge;      /* distance of the tree from the map's edge [m] */
    struct wf_terrain ground;
};

/* Read the map and find the tree on it. Given: file, x, y of *site. Errors: those of wf_terrain_read,
 * WF_EUSAGE for a place outside the map or without data. */
enum wf_status wf_site_read(struct wf_site *site, struct wf_arena *a, struct wf_err *e);
/* Wind at the tree over that over level ground, at a height above the ground [m], roughness length [m], for a
 * wind that comes from `from` clockwise from the map's north [rad]: wf_terrain_speedup, bilinear between its
 * points. WF_EINPUT where the method gives less than a tenth of the wind or more than five times, which it
 * cannot know. */
enum wf_status wf_site_speed_up(const struct wf_site *site, double from, double height, double roughness,
                                double *factor, struct wf_err *e);
#endif
