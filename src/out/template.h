/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_TEMPLATE_H
#define WF_OUT_TEMPLATE_H
/* A folder of templates of a user's: copies of the stylesheets, report.css and strings.xml of reports/, to be
 * changed, and pictures. They make pages as the shipped ones do, with the same limits (out/xml.h: they read
 * files of their folder alone, and write none), but a page can hold no program: what they add of that kind is
 * taken out. A results folder is never one. */
#include "base/err.h"
#include "base/file.h"
#include <libxml/tree.h>

/* Is it a folder of templates: every stylesheet, report.css, strings.xml, as regular files of UTF-8 without a
 * DOCTYPE, well formed; no results in it or above it? Errors: WF_EINPUT with file, line and reason. */
enum wf_status wf_template_check(const char *folder, struct wf_err *e);
/* Write the shipped ones into a new folder. Errors: WF_EINPUT where it exists; WF_EOUTPUT. */
enum wf_status wf_template_copy(const char *folder, struct wf_err *e);
/* The path of a template; folder NULL: the shipped one. Errors: WF_EINPUT. */
enum wf_status wf_template_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                                struct wf_err *e);
/* Take out of a page that templates made what could run or fetch anything: scripts other than `script` (its
 * text and "sha256-..."; NULL: none), handlers, frames, forms, addresses other than those of links. Pictures,
 * by their names in the folder, are put into the page (out/picture.h). Errors: WF_EINPUT for a picture that
 * cannot be read and for a style that would end its element; WF_ENOMEM. */
enum wf_status wf_template_clean(const char *folder, xmlDoc *page, const char *script,
                                 const char *script_name, struct wf_err *e);
#endif
