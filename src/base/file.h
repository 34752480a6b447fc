/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_FILE_H
#define WF_BASE_FILE_H
/* Reading and writing files. A result is written under a temporary name in the same folder and renamed when
 * it is complete, so that no reader sees a partly written file and a run that fails leaves an earlier result
 * unchanged. Also: SHA-256 fingerprints of input files. */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>
#include <stdio.h>

enum { WF_PATH_MAX = 4096 };

struct wf_file {
    FILE *stream;                /* write here; NULL when not open               */
    char path[WF_PATH_MAX];      /* the name asked for                           */
    char temporary[WF_PATH_MAX]; /* name until the commit; empty for a device or pipe */
};

/* Start writing `path`, whose folder must exist. A device or pipe (/dev/stdout) is written directly.
 * Returned: WF_OK and f->stream to write to. Errors: WF_EOUTPUT, with the path and the reason. */
enum wf_status wf_file_begin(struct wf_file *f, const char *path, struct wf_err *e);
/* Finish a file: flush, check that all bytes were accepted, close, rename. Errors: WF_EOUTPUT; the temporary
 * file is then removed. WF_EINTERNAL when the file is not open. */
enum wf_status wf_file_commit(struct wf_file *f, struct wf_err *e);
/* Give up a file: close and remove the temporary one. Does nothing after a commit or an earlier call. */
void wf_file_abandon(struct wf_file *f);
/* Why writing to a stream failed, after ferror(f) or a failed call: an errno, for which the stream's
 * descriptor is tried once more, because a stream does not keep the reason. The output is lost already; the
 * trial may add one line end to it. Returned: 0 when the trial succeeds. */
int wf_stream_reason(FILE *f);

/* Create a folder and every missing folder above it; a folder that exists is not an error. Errors:
 * WF_EOUTPUT. */
enum wf_status wf_mkdirs(const char *path, struct wf_err *e);

struct wf_bytes {
    char *data; /* size bytes and a terminating NUL */
    size_t size;
};

enum { WF_READ_MAX = 256 * 1024 * 1024 }; /* largest file that is read whole [bytes] */

/* Read a whole file into the arena. A pipe can be read only once: its bytes are kept in the arena, and
 * further calls with the same arena get them again. Returned: the file's bytes. Errors: WF_EINPUT for a
 * folder and for a file that is missing, unreadable or larger than WF_READ_MAX; WF_ENOMEM. */
enum wf_status wf_file_read(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e);
/* The same for text: a byte order mark is removed, UTF-16 is converted to UTF-8; bytes that are not UTF-8
 * text (also NUL) are WF_EINPUT with line and column. */
enum wf_status wf_file_read_text(const char *path, struct wf_arena *a, struct wf_bytes *out,
                                 struct wf_err *e);
/* The same for a table of measurements: text that is not UTF-8 is also read as Windows-1252, with a warning
 * `not-utf8` in `d`. */
enum wf_status wf_file_read_table(const char *path, struct wf_arena *a, struct wf_bytes *out,
                                  struct wf_diag *d, struct wf_err *e);

/* Files that are shipped, SHARE/ROOM/NAME.yaml: species tables in "species", tree models in "models", runs of
 * papers in "models/papers". */

/* Whether there is something of that name other than a folder. */
bool wf_file_is_there(const char *path);
/* The names of a room in alphabetical order, without ".yaml". Returned: how many; *names in the arena.
 * Errors: none: a folder that cannot be read, or no memory, gives 0. */
size_t wf_shipped_names(const char *share, const char *room, struct wf_arena *a, const char ***names);
/* The shipped file of that name. Errors: WF_EINPUT with the nearest name, or all of them; WF_ENOMEM. */
enum wf_status wf_shipped_path(const char *share, const char *room, const char *name, struct wf_arena *a,
                               const char **path, struct wf_err *e);

/* Fingerprints. Results name the SHA-256 digest of each input file, so that they can be traced to the exact
 * bytes they were computed from. Source: FIPS PUB 180-4 (NIST, 2015). */

enum { WF_SHA256_TEXT = 65 }; /* 64 hexadecimal digits and a NUL */

/* Digest of size bytes. Returned in `text`: lower-case hexadecimal. */
void wf_sha256(const void *bytes, size_t size, char text[static WF_SHA256_TEXT]);

/* Digest of a file, read in pieces; of a pipe, of the bytes that were read into the arena. Errors: WF_EINPUT,
 * with the path, when it cannot be read. */
enum wf_status wf_sha256_file(const char *path, struct wf_arena *a, char text[static WF_SHA256_TEXT],
                              struct wf_err *e);
/* Digest of what an open file holds from its present place to its end. Given: descriptor; descriptor of a
 * file that what is read is copied to, -1 for none. Returned: digest, and bytes read in *size; or -1 and
 * errno. */
int wf_sha256_read(int fd, int copy, char text[static WF_SHA256_TEXT], size_t *size);
#endif
