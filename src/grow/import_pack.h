/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_PACK_H
#define WF_GROW_IMPORT_PACK_H
/* What a reader of tree files found, as bytes: for a reader that runs in a process of its own because its
 * file may damage that process. Both ends are the same program on the same machine, so numbers are as in
 * memory. The receiver trusts nothing: it checks magic, version, sizes, counts and every value. */
#include "grow/import_file.h"

enum { WF_PACK_MAX = 512 * 1024 * 1024 }; /* more bytes than the largest table has */

/* Write a table as its reader left it, the reader's status and message, and the unreadable rows, which are
 * the errors of `d` (the reader ran with the option `strict`). WF_EINTERNAL when `to` does not take it. */
enum wf_status wf_import_pack(const struct wf_qsm *q, const struct wf_diag *d, const struct wf_err *e,
                              FILE *to);

/* The same back. Given: bytes; the path that the reader was given; options; *q with its names. Returned: as
 * of wf_import_reader. Errors: those of the reader; WF_EINPUT for bytes that no reader writes. */
enum wf_status wf_import_unpack(const void *bytes, size_t size, const char *path,
                                const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                struct wf_diag *d, struct wf_err *e);
#endif
