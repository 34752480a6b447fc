/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_PICTURE_H
#define WF_OUT_PICTURE_H
/* Photographs and logos of a page. They are decoded and encoded anew, so that nothing else of their files
 * (camera, owner, place, time) is in the results. */
#include "base/arena.h"
#include "base/err.h"
#include "base/file.h"

enum {
    WF_PICTURE_BYTES = 20 * 1000 * 1000,  /* largest file [bytes]              */
    WF_PICTURE_PIXELS = 40 * 1000 * 1000, /* largest picture [pixels]          */
    WF_PICTURE_SIDE = 1600                /* longest side that is kept [pixels] */
};

/* Read a PNG or JPEG file, turn it as its camera says, put it on white where it is transparent, and make it
 * smaller where it is larger than a page needs. Returned: *out, a JPEG file in the arena. Errors: WF_EINPUT
 * for a file that is missing, too large, no picture of these kinds, or damaged; WF_EMISSING where the program
 * was built without libjpeg or libpng; WF_ENOMEM. */
enum wf_status wf_picture_take(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e);
/* "data:image/jpeg;base64,..." of such a file; NULL: no memory. */
const char *wf_picture_address(const struct wf_bytes *jpeg, struct wf_arena *a);
#endif
