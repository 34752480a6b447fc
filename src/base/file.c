#include "base/file.h"
#include "base/text.h"
#include <errno.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

/* Open a new file beside `path` under a name nobody else has. */
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
        return wf_fail(e, WF_EOUTPUT, "%s: is a folder, a file was to be written", path);
    bool direct = exists && !S_ISREG(s.st_mode);
    int fd = direct ? open(path, O_WRONLY | O_CLOEXEC) : open_beside(f);
    if (fd >= 0 && (f->stream = fdopen(fd, "wb"))) return WF_OK;
    int reason = errno;
    if (fd >= 0) {
        (void)close(fd);
        if (!direct) (void)unlink(f->temporary);
    }
    f->temporary[0] = '\0';
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", path, strerror(reason));
}

enum wf_status wf_file_commit(struct wf_file *f, struct wf_err *e)
{
    if (!f->stream) return wf_fail(e, WF_EINTERNAL, "commit of a file that is not open");
    errno = 0;
    bool bad = ferror(f->stream) || fflush(f->stream);
    bad = fclose(f->stream) || bad;
    f->stream = NULL;
    if (!bad && f->temporary[0]) bad = rename(f->temporary, f->path) != 0;
    if (!bad) return f->temporary[0] = '\0', WF_OK;
    int reason = errno;
    wf_file_abandon(f);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", f->path,
                   reason ? strerror(reason) : "write error");
}

void wf_file_abandon(struct wf_file *f)
{
    if (f->stream) (void)fclose(f->stream);
    f->stream = NULL;
    if (f->temporary[0]) (void)unlink(f->temporary);
    f->temporary[0] = '\0';
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

/* Read to the end of fd; the size told by the system is only a first guess (pipes tell nothing). */
static enum wf_status read_all(int fd, const char *path, size_t guess, struct wf_arena *a,
                               struct wf_bytes *out, struct wf_err *e)
{
    size_t room = guess + 1;
    out->size = 0;
    out->data = wf_arena_take(a, room + 1, 1);
    while (out->data) {
        ssize_t got = read(fd, out->data + out->size, room - out->size);
        if (got < 0 && errno == EINTR) continue;
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

enum wf_status wf_file_read(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    int fd = open(path, O_RDONLY | O_CLOEXEC);
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
        code = read_all(fd, path, s.st_size > 0 ? (size_t)s.st_size : 0, a, out, e);
    (void)close(fd);
    return code;
}

enum wf_status wf_file_read_text(const char *path, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    enum wf_status code = wf_file_read(path, a, out, e);
    if (code) return code;
    const unsigned char *b = (const unsigned char *)out->data;
    if (out->size >= 2 && ((b[0] == 0xFF && b[1] == 0xFE) || (b[0] == 0xFE && b[1] == 0xFF)))
        return wf_fail(e, WF_EINPUT, "%s:1:1: the file is UTF-16 text; save it as UTF-8", path);
    if (out->size >= 3 && b[0] == 0xEF && b[1] == 0xBB && b[2] == 0xBF) {
        out->data += 3;
        out->size -= 3;
    }
    struct wf_utf8_fault fault;
    if (wf_utf8_valid(out->data, out->size, &fault)) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s:%zu:%zu: byte 0x%02X is not UTF-8 text; save the file as UTF-8", path,
                   fault.line, fault.column, fault.byte);
}
