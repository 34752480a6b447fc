/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/job.h"
#include "out/folder.h"
#include <string.h>

const char *const wf_job_pictures[WF_JOB_PICTURES] = { "photo", "logo" };

enum wf_status wf_job_read(const struct wf_job *job, struct wf_arena *a,
                           struct wf_bytes picture[WF_JOB_PICTURES], struct wf_err *e)
{
    const char *const file[WF_JOB_PICTURES] = { job->photo, job->logo };
    for (size_t i = 0; i < WF_JOB_PICTURES; i++) {
        picture[i] = (struct wf_bytes){ 0 };
        if (file[i] && wf_picture_take(file[i], a, &picture[i], e)) return e->code;
    }
    return WF_OK;
}

enum wf_status wf_job_write(const struct wf_bytes picture[WF_JOB_PICTURES], const char *folder,
                            struct wf_err *e)
{
    for (size_t i = 0; i < WF_JOB_PICTURES; i++) {
        struct wf_file f = { 0 };
        char name[32];
        snprintf(name, sizeof name, "plots/%s.jpg", wf_job_pictures[i]);
        if (!picture[i].size) continue;
        enum wf_status s = wf_folder_make(folder, e);
        if (!s) s = wf_folder_begin(&f, folder, name, e);
        if (!s && fwrite(picture[i].data, 1, picture[i].size, f.stream) != picture[i].size)
            s = wf_fail(e, WF_EOUTPUT, "%s/%s: cannot be written", folder, name);
        if (!s) s = wf_file_commit(&f, e);
        wf_file_abandon(&f);
        if (s) return s;
    }
    return WF_OK;
}

json_t *wf_part_job(struct wf_doc *d, const struct wf_job *job)
{
    const struct {
        const char *key, *text;
    } row[] = { { "client", job->client },
                { "site", job->site },
                { "tree_number", job->tree_number },
                { "assessor", job->assessor },
                { "organisation", job->organisation },
                { "disclaimer", job->disclaimer },
                { "photo", job->photo ? "plots/photo.jpg" : NULL },
                { "logo", job->logo ? "plots/logo.jpg" : NULL } };
    json_t *o = NULL;
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        if (!row[i].text) continue;
        if (!o) o = wf_doc_object(d);
        wf_doc_text(d, o, row[i].key, row[i].text);
    }
    return o;
}
