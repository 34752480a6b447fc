/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_JOB_H
#define WF_OUT_JOB_H
/* For whom a report is, of which tree, by whom: what stands on the head of its page. */
#include "out/doc.h"
#include "out/picture.h"

struct wf_job {
    const char *title, *client, *site, *tree_number, *assessor, *organisation,
        *disclaimer;          /* NULL: not given */
    const char *photo, *logo; /* files; NULL: none */
};
enum { WF_JOB_PICTURES = 2 };
/* Names of the pictures in results.json and of their files, FOLDER/plots/NAME.jpg. */
extern const char *const wf_job_pictures[WF_JOB_PICTURES];

/* Read the pictures. Returned: picture[], of size 0 where none is given. Errors: those of wf_picture_take. */
enum wf_status wf_job_read(const struct wf_job *job, struct wf_arena *a,
                           struct wf_bytes picture[WF_JOB_PICTURES], struct wf_err *e);
/* Write them into a results folder that has been made. Errors: WF_EOUTPUT. */
enum wf_status wf_job_write(const struct wf_bytes picture[WF_JOB_PICTURES], const char *folder,
                            struct wf_err *e);
/* The object "job" of results.json: what is given; pictures by the names of their files. NULL: nothing is. */
json_t *wf_part_job(struct wf_doc *d, const struct wf_job *job);
#endif
