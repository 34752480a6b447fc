/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_CAVITY_H
#define WF_DATA_CAVITY_H
/* Cavities in the stem of a tree, as they are measured. */
#include "base/arena.h"
#include "base/err.h"
#include "base/yaml.h"

enum { WF_CAVITIES_MAX = 32, WF_RAYS_MIN = 6, WF_RAYS_MAX = 3600 };

struct wf_cavity {
    double from, to; /* heights above the ground between which it is [m] */
    bool to_assumed; /* twice `at`, or the stem's end where that is lower */
    double at;       /* height at which it was measured [m] */
    double wall; /* sound wall where it is concentric: radius of the wood less that of the cavity [m]; NAN: by
                    rays */
    const char *centre;     /* as written; NULL: on the stem's axis */
    double offset, towards; /* of its centre from the axis [m], direction [rad] */
    double opening, facing; /* of the wall, seen from its centre; direction of its middle [rad]; opening 0:
                               closed; facing NAN: as towards */
    const char *rays_file;  /* NULL: none */
    size_t rays;
    double *angle, *outer, *sound; /* directions [rad]; outline over bark, inner end of the sound wood [m] */
    const char *file;              /* where it is said, for messages; line 0: an option */
    size_t line, column;
};

extern const struct wf_yaml_table wf_cavity_table; /* struct wf_cavity */

/* Rays are a CSV with the columns angle_deg, outer_m and sound_m, a ray a row: direction anticlockwise from
 * +x; distance of the stem's surface, bark included; distance at which sound wood begins, 0: sound to the
 * axis, as far as outer: no wall. Angles ascend within a turn, no gap is above 60 degrees. */

/* Cavities of a command line, separated by commas: AT:WALL ("1.3m:80mm"), AT:FILE with rays, or a YAML file
 * with a list 'cavities' as in a model. Returned: *n cavities with their rays. Errors as above. */
enum wf_status wf_cavities_asked(const char *text, struct wf_arena *a, struct wf_cavity **out, size_t *n,
                                 struct wf_diag *d, struct wf_err *e);

/* Read the rays of a list that a file has given, with paths from that file's folder, and refuse cavities that
 * overlap. Errors as above. */
enum wf_status wf_cavities_settle(const char *file, struct wf_cavity *list, size_t n, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_err *e);
#endif
