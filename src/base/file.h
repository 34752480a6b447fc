/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_FILE_H
#define WF_BASE_FILE_H
/* Files in and out. A result appears under its name only when it is complete: it is written under a
 * temporary name in the same folder and renamed, so a reader never meets half a file and a failed run
 * leaves the earlier result as it was. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { WF_PATH_MAX = 4096 };

struct wf_file {
    FILE *stream;                /* write here; NULL when not open               */
    char path[WF_PATH_MAX];      /* the name asked for                           */
    char temporary[WF_PATH_MAX]; /* where the bytes go until the commit; empty for a device or pipe */
};

/* Start writing `path`. Its folder must exist. A device or pipe (/dev/stdout) is written directly.
 * Errors: WF_EOUTPUT naming the path and the reason. */
enum wf_status wf_file_begin(struct wf_file *f, const char *path, struct wf_err *e);
/* Flush, check that every byte was accepted, close, rename. On failure the temporary file is removed. */
enum wf_status wf_file_commit(struct wf_file *f, struct wf_err *e);
/* Close and remove the temporary file. Safe on a file that was never begun or is already done. */
void wf_file_abandon(struct wf_file *f);

/* Make a folder and every missing folder above it; an existing folder is fine. WF_EOUTPUT otherwise. */
enum wf_status wf_mkdirs(const char *path, struct wf_err *e);

struct wf_bytes {
    char *data; /* size bytes and a terminating NUL */
    size_t size;
};

enum { WF_READ_MAX = 256 * 1024 * 1024 }; /* largest file that is read whole [bytes] */

/* Read a whole file into the arena. Errors: WF_EINPUT for a folder, a missing, unreadable or too large file.
 */
enum wf_status wf_file_read(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e);
/* The same for text: a byte order mark is dropped; bytes that are not UTF-8 text (also NUL and UTF-16) are
 * refused with their line and column. */
enum wf_status wf_file_read_text(const char *path, struct wf_arena *a, struct wf_bytes *out,
                                 struct wf_err *e);

/* Fingerprint of an input file, so that a result can be traced to the bytes it was made from.
 * Source: FIPS PUB 180-4 (NIST, 2015), SHA-256. */

enum { WF_SHA256_TEXT = 65 }; /* 64 hexadecimal digits and a NUL */

/* Given: size bytes. Returned in `text`: the digest in lower-case hexadecimal. */
void wf_sha256(const void *bytes, size_t size, char text[static WF_SHA256_TEXT]);

/* The same for a file, read in pieces. Errors: WF_EINPUT naming the path when it cannot be read. */
enum wf_status wf_sha256_file(const char *path, char text[static WF_SHA256_TEXT], struct wf_err *e);
#endif
