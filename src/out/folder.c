/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/folder.h"
#include <stdio.h>

enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    int n = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (n < 0 || (size_t)n >= sizeof path)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    return wf_file_begin(f, path, e);
}

enum wf_status wf_folder_make(const char *folder, struct wf_err *e)
{
    static const char *const sub[] = { "tables", "plots" };
    for (int i = 0; i < 2; i++) {
        char path[WF_PATH_MAX];
        int n = snprintf(path, sizeof path, "%s/%s", folder, sub[i]);
        if (n < 0 || (size_t)n >= sizeof path)
            return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
        enum wf_status s = wf_mkdirs(path, e);
        if (s) return s;
    }
    return WF_OK;
}
