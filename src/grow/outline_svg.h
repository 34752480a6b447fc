/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_OUTLINE_SVG_H
#define WF_GROW_OUTLINE_SVG_H
/* The outline of a crown that was drawn over a photograph, as a closed path of an SVG file. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"

/* Read an outline from the only path of an SVG file, or from the one with the id "crown". Curves are
 * flattened to 1e-4 of the drawing's size, or more coarsely where the points allowed do not suffice, to 2e-3
 * at most. The drawing is scaled alike in both directions, so that its lowest point lies at the height `base`
 * and its highest at `top` above the ground [m]. Returned: points of *s. Errors: WF_EINPUT for a file that is
 * no SVG or larger than 4 MiB, has a document type with declarations, no such path, one of several parts or
 * not closed, a transform other than translate, a mistake in the path's data (with its character), and for
 * base and top that are not heights; those of wf_silhouette_check. Nothing but the file is read. */
enum wf_status wf_outline_svg_read(const char *path, double base, double top, struct wf_silhouette *s,
                                   struct wf_arena *a, struct wf_err *e);
#endif
