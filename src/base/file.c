/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/file.h"
#include "base/text.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <linux/magic.h>
#include <poll.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <sys/vfs.h>
#include <unistd.h>

/* A pipe that no other program has open at its other end is waited for as long as this [ms]. */
enum { PIPE_PATIENCE = 10000, PIPE_LOOK = 100 };

/* Writing. */

/* Open a new file in the folder of f->path, under a name that no other file has. Returned: descriptor, -1 on
 * failure (errno). */
static int open_beside(struct wf_file *f)
{
    const char *slash = strrchr(f->path, '/');
    int folder = slash ? (int)(slash - f->path) + 1 : 0;
    for (int attempt = 0; attempt < 1000; attempt++) {
        int n = snprintf(f->temporary, sizeof f->temporary, "%.*s.%.180s.%ld.%d", folder, f->path,
                         f->path + folder, (long)getpid(), attempt);
        if (n < 0 || (size_t)n >= sizeof f->temporary) {
            errno = ENAMETOOLONG;
            return -1;
        }
        int fd = open(f->temporary, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        if (fd >= 0 || errno != EEXIST) return fd;
    }
    return -1;
}

/* Open something that is no file: a device, or a pipe as soon as a program reads it. Returned: descriptor, -1
 * on failure (errno; ENXIO: nothing reads the pipe). */
static int open_other(const char *path)
{
    int fd = -1;
    for (int waited = 0; waited < PIPE_PATIENCE; waited += PIPE_LOOK) {
        fd = open(path, O_WRONLY | O_CLOEXEC | O_NONBLOCK);
        if (fd >= 0 || errno != ENXIO) break;
        (void)poll(NULL, 0, PIPE_LOOK);
        errno = ENXIO;
    }
    if (fd >= 0) (void)fcntl(fd, F_SETFL, O_WRONLY);
    return fd;
}

enum wf_status wf_file_begin(struct wf_file *f, const char *path, struct wf_err *e)
{
    f->stream = NULL;
    f->temporary[0] = '\0';
    if (strlen(path) >= sizeof f->path)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", path);
    memcpy(f->path, path, strlen(path) + 1);
    struct stat s;
    bool exists = !stat(path, &s);
    if (exists && S_ISDIR(s.st_mode))
        return wf_fail(e, WF_EOUTPUT, "%s: is a folder; a file is to be written there", path);
    bool direct = exists && !S_ISREG(s.st_mode);
    int fd = direct ? open_other(path) : open_beside(f);
    if (fd >= 0 && (f->stream = fdopen(fd, "wb"))) return WF_OK;
    int reason = errno;
    if (fd >= 0) {
        (void)close(fd);
        if (!direct) (void)unlink(f->temporary);
    }
    f->temporary[0] = '\0';
    if (direct && reason == ENXIO)
        return wf_fail(e, WF_EOUTPUT, "%s: is a pipe that no program reads (waited %d s)", path,
                       PIPE_PATIENCE / 1000);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", path, strerror(reason));
}

void wf_file_abandon(struct wf_file *f)
{
    if (f->stream) (void)fclose(f->stream);
    f->stream = NULL;
    if (f->temporary[0]) (void)unlink(f->temporary);
    f->temporary[0] = '\0';
}

int wf_stream_reason(FILE *f)
{
    errno = 0;
    (void)!write(fileno(f), "\n", 1);
    return errno;
}

enum wf_status wf_file_commit(struct wf_file *f, struct wf_err *e)
{
    if (!f->stream) return wf_fail(e, WF_EINTERNAL, "commit of a file that is not open");
    bool bad = ferror(f->stream) || fflush(f->stream);
    int reason = bad ? wf_stream_reason(f->stream) : 0;
    errno = 0;
    bad = fclose(f->stream) || bad;
    f->stream = NULL;
    if (!bad && f->temporary[0]) bad = rename(f->temporary, f->path) != 0;
    if (!bad) return f->temporary[0] = '\0', WF_OK;
    if (!reason) reason = errno;
    wf_file_abandon(f);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", f->path,
                   reason ? strerror(reason) : "write error");
}

static enum wf_status make_folder(const char *path, struct wf_err *e)
{
    struct stat s;
    if (!mkdir(path, 0777)) return WF_OK;
    int reason = errno;
    if (!stat(path, &s)) {
        if (S_ISDIR(s.st_mode)) return WF_OK;
        return wf_fail(e, WF_EOUTPUT, "%s: is a file, a folder is needed", path);
    }
    return wf_fail(e, WF_EOUTPUT, "%s: the folder cannot be made: %s", path, strerror(reason));
}

enum wf_status wf_mkdirs(const char *path, struct wf_err *e)
{
    char part[WF_PATH_MAX];
    size_t n = strlen(path);
    if (!n) return wf_fail(e, WF_EOUTPUT, "a folder's name is empty");
    if (n >= sizeof part) return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", path);
    for (size_t i = 0; i < n; i++) {
        part[i] = path[i];
        if (i == 0 || path[i] != '/') continue;
        part[i] = '\0';
        if (make_folder(part, e)) return WF_EOUTPUT;
        part[i] = '/';
    }
    part[n] = '\0';
    return make_folder(part, e);
}

/* Reading. */

/* As read(2), of a descriptor that does not wait. A pipe without a writer looks as if it had ended: its first
 * piece is waited for `patience` [ms], which is 0 afterwards. A writer is waited for as long as it takes.
 * Returned: -1 and ENXIO when no program writes to the pipe. */
static ssize_t read_piece(int fd, char *to, size_t room, int *patience)
{
    for (;;) {
        struct pollfd state = { .fd = fd, .events = POLLIN };
        ssize_t got = read(fd, to, room);
        if (got < 0 && errno == EAGAIN) {
            *patience = 0;
            (void)poll(&state, 1, -1);
        } else if (got == 0 && *patience > 0) {
            *patience -= PIPE_LOOK;
            if (poll(&state, 1, PIPE_LOOK) > 0 && !(state.revents & POLLIN)) return 0; /* one came and went */
            if (*patience <= 0) return errno = ENXIO, -1;
        } else if (got >= 0 || errno != EINTR) {
            *patience = 0;
            return got;
        }
    }
}

/* Read fd to its end. `guess` is the size the system reports; it may be wrong (for pipes it is 0). */
static enum wf_status read_all(int fd, const char *path, size_t guess, int patience, struct wf_arena *a,
                               struct wf_bytes *out, struct wf_err *e)
{
    size_t room = guess + 1;
    out->size = 0;
    out->data = wf_arena_take(a, room + 1, 1);
    while (out->data) {
        ssize_t got = read_piece(fd, out->data + out->size, room - out->size, &patience);
        if (got < 0 && errno == ENXIO)
            return wf_fail(e, WF_EINPUT, "%s: is a pipe that no program writes to (waited %d s)", path,
                           PIPE_PATIENCE / 1000);
        if (got < 0) return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(errno));
        if (got == 0) return WF_OK;
        out->size += (size_t)got;
        if (out->size > WF_READ_MAX) return wf_fail(e, WF_EINPUT, "%s: is larger than 256 MB", path);
        if (out->size < room) continue;
        room = 2 * room + 65536;
        char *wider = wf_arena_take(a, room + 1, 1);
        if (wider) memcpy(wider, out->data, out->size);
        out->data = wider;
    }
    return wf_fail(e, WF_ENOMEM, "%s: no memory for its %zu bytes", path, room);
}

/* How long the first writer of something that is read is waited for [ms]. A pipe without a name (`<(...)`)
 * had one, and has ended when it has none. */
static int patience_for(int fd, const struct stat *s)
{
    struct statfs f;
    return S_ISFIFO(s->st_mode) && !fstatfs(fd, &f) && f.f_type != PIPEFS_MAGIC ? PIPE_PATIENCE : 0;
}

/* A pipe that was read into an arena. */
struct wf_piped {
    struct wf_piped *older;
    const char *path;
    struct wf_bytes bytes;
};

static const struct wf_piped *piped_named(const struct wf_arena *a, const char *path)
{
    const struct wf_piped *p = a->piped;
    while (p && strcmp(p->path, path) != 0) p = p->older;
    return p;
}

/* A copy, because readers write to what they read. */
static enum wf_status copy_bytes(const struct wf_bytes *b, const char *path, struct wf_arena *a,
                                 struct wf_bytes *out, struct wf_err *e)
{
    *out = (struct wf_bytes){ wf_arena_take(a, b->size + 1, 1), b->size };
    if (!out->data) return wf_fail(e, WF_ENOMEM, "%s: no memory for its %zu bytes", path, b->size);
    memcpy(out->data, b->data, b->size);
    return WF_OK;
}

static enum wf_status keep_piped(const char *path, const struct wf_bytes *b, struct wf_arena *a,
                                 struct wf_err *e)
{
    struct wf_piped *p = WF_TAKE(a, 1, struct wf_piped);
    const char *name = wf_arena_text(a, path);
    if (!p || !name) return wf_fail(e, WF_ENOMEM, "%s: no memory to keep it", path);
    *p = (struct wf_piped){ .older = a->piped, .path = name };
    if (copy_bytes(b, path, a, &p->bytes, e)) return e ? e->code : WF_ENOMEM;
    a->piped = p;
    return WF_OK;
}

enum wf_status wf_file_read(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    const struct wf_piped *piped = piped_named(a, path);
    if (piped) return copy_bytes(&piped->bytes, path, a, out, e);
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK);
    if (fd < 0) {
        const char *why = errno == ENOENT ? "there is no such file" : strerror(errno);
        return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, why);
    }
    struct stat s;
    enum wf_status code;
    if (fstat(fd, &s))
        code = wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(errno));
    else if (S_ISDIR(s.st_mode))
        code = wf_fail(e, WF_EINPUT, "%s: is a folder, a file was expected", path);
    else if (s.st_size > WF_READ_MAX)
        code = wf_fail(e, WF_EINPUT, "%s: is larger than 256 MB", path);
    else
        code = read_all(fd, path, s.st_size > 0 ? (size_t)s.st_size : 0, patience_for(fd, &s), a, out, e);
    if (!code && !S_ISREG(s.st_mode)) code = keep_piped(path, out, a, e);
    (void)close(fd);
    return code;
}

static enum wf_status keep_converted(char *to, size_t size, struct wf_bytes *out)
{
    to[size] = '\0';
    *out = (struct wf_bytes){ to, size };
    return WF_OK;
}

static enum wf_status text_from_utf16(const char *path, enum wf_utf16 order, struct wf_arena *a,
                                      struct wf_bytes *out, struct wf_err *e)
{
    char *to = wf_arena_take(a, out->size / 2 * 3 + 1, 1);
    if (!to) return wf_fail(e, WF_ENOMEM, "%s: no memory for its text", path);
    size_t n = wf_utf16_to_utf8(out->data, out->size, order, to);
    if (n != (size_t)-1) return keep_converted(to, n, out);
    return wf_fail(e, WF_EINPUT, "%s:1:1: the file is broken UTF-16 text; save it as UTF-8", path);
}

static enum wf_status read_text(const char *path, struct wf_arena *a, struct wf_bytes *out,
                                struct wf_diag *table, struct wf_err *e)
{
    enum wf_status code = wf_file_read(path, a, out, e);
    if (code) return code;
    const unsigned char *b = (const unsigned char *)out->data;
    enum wf_utf16 order = wf_utf16_order(out->data, out->size);
    if (order != WF_UTF16_NOT) return text_from_utf16(path, order, a, out, e);
    if (out->size >= 3 && b[0] == 0xEF && b[1] == 0xBB && b[2] == 0xBF) {
        out->data += 3;
        out->size -= 3;
    }
    struct wf_utf8_fault fault;
    if (wf_utf8_valid(out->data, out->size, &fault)) return WF_OK;
    char *to = table ? wf_arena_take(a, 3 * out->size + 1, 1) : NULL;
    size_t n = to ? wf_cp1252_to_utf8(out->data, out->size, to) : (size_t)-1;
    if (n == (size_t)-1)
        return wf_fail(e, WF_EINPUT, "%s:%zu:%zu: byte 0x%02X is not UTF-8 text; save the file as UTF-8",
                       path, fault.line, fault.column, fault.byte);
    wf_diag_warn(table, "not-utf8",
                 "%s:%zu:%zu: byte 0x%02X is not UTF-8; the file is read as Windows-1252 (Latin-1)", path,
                 fault.line, fault.column, fault.byte);
    return keep_converted(to, n, out);
}

enum wf_status wf_file_read_text(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    return read_text(path, a, out, NULL, e);
}

enum wf_status wf_file_read_table(const char *path, struct wf_arena *a, struct wf_bytes *out,
                                  struct wf_diag *d, struct wf_err *e)
{
    return read_text(path, a, out, d, e);
}

/* Files that are shipped. */

bool wf_file_is_there(const char *path)
{
    struct stat s;
    return !stat(path, &s) && !S_ISDIR(s.st_mode);
}

static int by_name(const void *a, const void *b)
{
    return strcmp(*(const char *const *)a, *(const char *const *)b);
}

size_t wf_shipped_names(const char *share, const char *room, struct wf_arena *a, const char ***names)
{
    enum { NAMES_MAX = 512 };
    static const char ending[] = ".yaml";
    const char *folder = wf_arena_print(a, "%s/%s", share, room);
    DIR *d = folder ? opendir(folder) : NULL;
    size_t n = 0;
    *names = d ? WF_TAKE(a, NAMES_MAX, const char *) : NULL;
    for (const struct dirent *f; *names && n < NAMES_MAX && (f = readdir(d));) {
        size_t size = strlen(f->d_name), stem = size - (sizeof ending - 1);
        if (size < sizeof ending || f->d_name[0] == '.' || strcmp(f->d_name + stem, ending) != 0) continue;
        if (((*names)[n] = wf_arena_print(a, "%.*s", (int)stem, f->d_name))) n++;
    }
    if (d) (void)closedir(d);
    if (n) qsort((void *)*names, n, sizeof **names, by_name);
    return n;
}

enum wf_status wf_shipped_path(const char *share, const char *room, const char *name, struct wf_arena *a,
                               const char **path, struct wf_err *e)
{
    const char **known, *what = strcmp(room, "species") == 0  ? "species table"
                                : strcmp(room, "models") == 0 ? "tree model"
                                                              : "paper";
    *path = wf_arena_print(a, "%s/%s/%s.yaml", share, room, name);
    if (!*path) return wf_fail(e, WF_ENOMEM, "%s: no memory", name);
    if (!strchr(name, '/') && wf_file_is_there(*path)) return WF_OK;
    size_t n = wf_shipped_names(share, room, a, &known);
    return wf_fail(e, WF_EINPUT, "%s: there is no such file, and no shipped %s of that name%s", name, what,
                   wf_did_you_mean_or(name, known, n, "there are: ").text);
}

/* Fingerprints. */

struct sha256 {
    uint32_t h[8];
    uint64_t length; /* bytes taken so far */
    unsigned char block[64];
};

/* FIPS 180-4, 4.2.2: fractional parts of the cube roots of the first 64 primes. */
static const uint32_t sha256_constant[64] = {
    0x428a2f98, 0x71374491, 0xb5c0fbcf, 0xe9b5dba5, 0x3956c25b, 0x59f111f1, 0x923f82a4, 0xab1c5ed5,
    0xd807aa98, 0x12835b01, 0x243185be, 0x550c7dc3, 0x72be5d74, 0x80deb1fe, 0x9bdc06a7, 0xc19bf174,
    0xe49b69c1, 0xefbe4786, 0x0fc19dc6, 0x240ca1cc, 0x2de92c6f, 0x4a7484aa, 0x5cb0a9dc, 0x76f988da,
    0x983e5152, 0xa831c66d, 0xb00327c8, 0xbf597fc7, 0xc6e00bf3, 0xd5a79147, 0x06ca6351, 0x14292967,
    0x27b70a85, 0x2e1b2138, 0x4d2c6dfc, 0x53380d13, 0x650a7354, 0x766a0abb, 0x81c2c92e, 0x92722c85,
    0xa2bfe8a1, 0xa81a664b, 0xc24b8b70, 0xc76c51a3, 0xd192e819, 0xd6990624, 0xf40e3585, 0x106aa070,
    0x19a4c116, 0x1e376c08, 0x2748774c, 0x34b0bcb5, 0x391c0cb3, 0x4ed8aa4a, 0x5b9cca4f, 0x682e6ff3,
    0x748f82ee, 0x78a5636f, 0x84c87814, 0x8cc70208, 0x90befffa, 0xa4506ceb, 0xbef9a3f7, 0xc67178f2,
};

static uint32_t sha256_rotated(uint32_t x, unsigned n) { return x >> n | x << (32 - n); }

static uint32_t sha256_word(const unsigned char *p)
{
    return (uint32_t)p[0] << 24 | (uint32_t)p[1] << 16 | (uint32_t)p[2] << 8 | (uint32_t)p[3];
}

static void sha256_block(uint32_t h[8], const unsigned char *block)
{
    uint32_t w[64], v[8];
    for (size_t t = 0; t < 16; t++) w[t] = sha256_word(block + 4 * t);
    for (size_t t = 16; t < 64; t++) {
        uint32_t low = sha256_rotated(w[t - 15], 7) ^ sha256_rotated(w[t - 15], 18) ^ w[t - 15] >> 3;
        uint32_t high = sha256_rotated(w[t - 2], 17) ^ sha256_rotated(w[t - 2], 19) ^ w[t - 2] >> 10;
        w[t] = w[t - 16] + low + w[t - 7] + high;
    }
    memcpy(v, h, sizeof v);
    for (size_t t = 0; t < 64; t++) {
        uint32_t mix = sha256_rotated(v[4], 6) ^ sha256_rotated(v[4], 11) ^ sha256_rotated(v[4], 25);
        uint32_t chosen = (v[4] & v[5]) ^ (~v[4] & v[6]);
        uint32_t first = v[7] + mix + chosen + sha256_constant[t] + w[t];
        uint32_t spread = sha256_rotated(v[0], 2) ^ sha256_rotated(v[0], 13) ^ sha256_rotated(v[0], 22);
        uint32_t majority = (v[0] & v[1]) ^ (v[0] & v[2]) ^ (v[1] & v[2]);
        memmove(v + 1, v, 7 * sizeof v[0]);
        v[4] += first;
        v[0] = first + spread + majority;
    }
    for (size_t i = 0; i < 8; i++) h[i] += v[i];
}

static void sha256_begin(struct sha256 *s)
{
    /* FIPS 180-4, 5.3.3: fractional parts of the square roots of the first 8 primes. */
    static const uint32_t start[8] = { 0x6a09e667, 0xbb67ae85, 0x3c6ef372, 0xa54ff53a,
                                       0x510e527f, 0x9b05688c, 0x1f83d9ab, 0x5be0cd19 };
    memcpy(s->h, start, sizeof start);
    s->length = 0;
}

static void sha256_take(struct sha256 *s, const unsigned char *bytes, size_t size)
{
    while (size > 0) {
        size_t filled = s->length % 64, n = size < 64 - filled ? size : 64 - filled;
        memcpy(s->block + filled, bytes, n);
        s->length += n;
        bytes += n;
        size -= n;
        if (s->length % 64 == 0) sha256_block(s->h, s->block);
    }
}

static void sha256_finish(struct sha256 *s, char text[static WF_SHA256_TEXT])
{
    static const unsigned char padding[64] = { 0x80 };
    uint64_t bits = s->length * 8;
    unsigned char length[8];
    for (unsigned i = 0; i < 8; i++) length[i] = (unsigned char)(bits >> (56 - 8 * i));
    sha256_take(s, padding, 1 + (119 - s->length % 64) % 64);
    sha256_take(s, length, sizeof length);
    for (size_t i = 0; i < 8; i++) snprintf(text + 8 * i, 9, "%08x", (unsigned)s->h[i]);
}

void wf_sha256(const void *bytes, size_t size, char text[static WF_SHA256_TEXT])
{
    struct sha256 s;
    sha256_begin(&s);
    sha256_take(&s, bytes, size);
    sha256_finish(&s, text);
}

static int write_whole(int fd, const unsigned char *bytes, size_t size)
{
    while (size > 0) {
        ssize_t put = write(fd, bytes, size);
        if (put < 0 && errno == EINTR) continue;
        if (put < 0) return -1;
        bytes += put;
        size -= (size_t)put;
    }
    return 0;
}

int wf_sha256_read(int fd, int copy, char text[static WF_SHA256_TEXT], size_t *size)
{
    unsigned char piece[16384];
    struct sha256 s;
    sha256_begin(&s);
    for (*size = 0;;) {
        ssize_t got = read(fd, piece, sizeof piece);
        if (got < 0 && errno == EINTR) continue;
        if (got < 0) return -1;
        if (got == 0) break;
        sha256_take(&s, piece, (size_t)got);
        *size += (size_t)got;
        if (copy >= 0 && write_whole(copy, piece, (size_t)got)) return -1;
    }
    sha256_finish(&s, text);
    return 0;
}

enum wf_status wf_sha256_file(const char *path, struct wf_arena *a, char text[static WF_SHA256_TEXT],
                              struct wf_err *e)
{
    const struct wf_piped *piped = piped_named(a, path);
    if (piped) return wf_sha256(piped->bytes.data, piped->bytes.size, text), WF_OK;
    struct stat s;
    size_t size;
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK), failed = fd < 0 || fstat(fd, &s);
    if (!failed && S_ISFIFO(s.st_mode)) errno = ESPIPE, failed = 1; /* its bytes are gone */
    if (!failed) failed = wf_sha256_read(fd, -1, text, &size);
    int reason = errno;
    if (fd >= 0) (void)close(fd);
    return failed ? wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(reason)) : WF_OK;
}
