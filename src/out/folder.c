/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/folder.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const char *const wf_folder_rooms[WF_ROOMS] = { "tables", "plots", "vtk" };
enum { DEPTH = 4, LISTED_MAX = 100000 };

/* ---- Names and files of a folder ---- */

enum wf_status wf_folder_path(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e)
{
    int n = snprintf(path, WF_PATH_MAX, "%s/%s", folder, name);
    if (n >= 0 && n < WF_PATH_MAX) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
}

enum wf_status wf_folder_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    enum wf_status s = wf_folder_path(folder, name, path, e);
    return s ? s : wf_file_begin(f, path, e);
}

enum wf_status wf_folder_make(const char *folder, struct wf_err *e)
{
    static const char *const sub[] = { "tables", "plots" };
    enum wf_status s = WF_OK;
    for (int i = 0; i < 2 && !s; i++) {
        char path[WF_PATH_MAX];
        s = wf_folder_path(folder, sub[i], path, e);
        if (!s) s = wf_mkdirs(path, e);
    }
    return s;
}

static bool ends_in(const char *name, const char *ending)
{
    size_t n = strlen(name), k = strlen(ending);
    return n > k && !strcmp(name + n - k, ending);
}

/* Is it a name of a file that a run can have made: in one of the rooms or a page; no empty, hidden or upward
 * parts, no control characters? */
bool wf_folder_names(const char *name)
{
    size_t depth = 0;
    if (!name || strlen(name) >= WF_NAME_MAX) return false;
    for (const char *c = name; *c; c++)
        if ((unsigned char)*c < 0x20 || *c == 0x7f) return false;
    bool placed = !strchr(name, '/') && (ends_in(name, ".html") || ends_in(name, ".pdf") || ends_in(name, ".docx"));
    for (int i = 0; i < WF_ROOMS; i++)
        placed |= !strncmp(name, wf_folder_rooms[i], strlen(wf_folder_rooms[i])) &&
                  name[strlen(wf_folder_rooms[i])] == '/';
    if (!placed) return false;
    for (const char *part = name; part; depth++) {
        if (*part == '.' || *part == '/' || *part == '\0') return false;
        part = strchr(part, '/');
        if (part) part++;
    }
    return depth <= DEPTH;
}

/* The folder that holds `name`, opened without following a link; *last: the name in it. make: folders that
 * are missing are made. Returned: a descriptor, -1 and errno. */
int wf_folder_room(int dir, const char *name, bool make, const char **last)
{
    char part[WF_NAME_MAX];
    int at = dup(dir);
    for (const char *slash; at >= 0 && (slash = strchr(name, '/')); name = slash + 1) {
        snprintf(part, sizeof part, "%.*s", (int)(slash - name), name);
        if (make) (void)mkdirat(at, part, 0777);
        int next = openat(at, part, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC), reason = errno;
        (void)close(at);
        at = next;
        errno = reason;
    }
    *last = name;
    return at;
}

/* A regular file below the folder, opened for reading without following a link. Returned: a descriptor, its
 * size in *size; -1 and errno, EINVAL for what is not a regular file. */
int wf_folder_open(int dir, const char *name, size_t *size)
{
    const char *last;
    struct stat s;
    int room = wf_folder_room(dir, name, false, &last);
    if (room < 0) return -1;
    int fd = openat(room, last, O_RDONLY | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC), reason = errno;
    (void)close(room);
    errno = reason;
    if (fd < 0) return -1;
    if (fstat(fd, &s) || !S_ISREG(s.st_mode)) {
        (void)close(fd);
        errno = EINVAL;
        return -1;
    }
    *size = (size_t)s.st_size;
    return fd;
}

/* What stands at a name, links not followed: 0 nothing, else the type bits of its mode. */
mode_t wf_folder_kind(int dir, const char *name)
{
    const char *last;
    struct stat s;
    int room = wf_folder_room(dir, name, false, &last);
    if (room < 0) return errno == ENOENT ? 0 : S_IFLNK;
    bool there = !fstatat(room, last, &s, AT_SYMLINK_NOFOLLOW);
    (void)close(room);
    return there ? s.st_mode & S_IFMT : 0;
}

void wf_folder_unlink(int dir, const char *name)
{
    const char *last;
    int room = wf_folder_room(dir, name, false, &last);
    if (room >= 0) (void)unlinkat(room, last, 0), (void)close(room);
}

/* Remove a folder and all that is in it; links are removed, not followed. */
void wf_folder_remove(int dir, const char *name, int depth)
{
    int fd = openat(dir, name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    if (!list && fd >= 0) (void)close(fd);
    if (!list) return;
    for (const struct dirent *x; (x = readdir(list));) {
        if (!strcmp(x->d_name, ".") || !strcmp(x->d_name, "..")) continue;
        if (unlinkat(fd, x->d_name, 0) && depth < DEPTH) wf_folder_remove(fd, x->d_name, depth + 1);
    }
    closedir(list);
    (void)unlinkat(dir, name, AT_REMOVEDIR);
}

/* ---- Lists of files, as in results.json ---- */

const char *wf_folder_entry(const json_t *x) { return json_string_value(json_object_get(x, "name")); }

const json_t *wf_folder_listed(const json_t *list, const char *name)
{
    for (size_t i = 0; i < json_array_size(list); i++) {
        const char *found = wf_folder_entry(json_array_get(list, i));
        if (found && !strcmp(found, name)) return json_array_get(list, i);
    }
    return NULL;
}

/* Is the file below the folder the one of the list? It is copied to `copy` on the way, unless that is -1.
 * Returned: NULL when it is, else what is wrong. */
const char *wf_folder_mismatch(int dir, const json_t *x, int copy)
{
    char sha256[WF_SHA256_TEXT];
    const char *wanted = json_string_value(json_object_get(x, "sha256"));
    size_t size, read;
    int fd = wf_folder_open(dir, wf_folder_entry(x), &size);
    if (fd < 0) return errno == ENOENT ? "is missing" : "is not a plain file that can be read";
    bool same = (json_int_t)size == json_integer_value(json_object_get(x, "size"));
    bool failed = same && wf_sha256_read(fd, copy, sha256, &read);
    (void)close(fd);
    if (failed) return "cannot be read or copied";
    return same && read == size && wanted && !strcmp(wanted, sha256) ? NULL : "is not of this run";
}

/* Text of a document in a folder, and what it holds. Returned: the text, to be freed, or NULL and errno;
 * *root NULL when it is not JSON. */
char *wf_folder_document(int dir, json_t **root)
{
    size_t size, used = 0;
    *root = NULL;
    int fd = wf_folder_open(dir, WF_DOCUMENT, &size);
    if (fd < 0) return NULL;
    char *text = size > WF_READ_MAX ? NULL : malloc(size + 1);
    if (!text) errno = size > WF_READ_MAX ? EFBIG : ENOMEM;
    while (text && used < size) {
        ssize_t got = read(fd, text + used, size - used);
        if (got < 0 && errno == EINTR) continue;
        if (got <= 0) break;
        used += (size_t)got;
    }
    (void)close(fd);
    if (!text) return NULL;
    text[used] = '\0';
    *root = json_loadb(text, used, JSON_REJECT_DUPLICATES, NULL);
    return text;
}

/* Has every entry a name of its own that stays below the folder? Without memory: no. */
static bool names_files(const json_t *list)
{
    json_t *seen = json_object();
    bool good = seen;
    for (size_t i = 0; good && i < json_array_size(list); i++) {
        const char *name = wf_folder_entry(json_array_get(list, i));
        good = wf_folder_names(name) && !json_object_get(seen, name) &&
               !json_object_set_new(seen, name, json_true());
    }
    json_decref(seen);
    return good;
}

/* The files a document lists; NULL: it has no list. A name that leads out of the folder, or stands twice,
 * makes it no list. */
json_t *wf_folder_list(const json_t *root)
{
    json_t *list = json_object_get(root, "run_files");
    if (!json_is_array(list) || json_array_size(list) > LISTED_MAX) return NULL;
    return names_files(list) ? list : NULL;
}

void wf_folder_cell(FILE *f, double x, int digits)
{
    if (isfinite(x))
        fprintf(f, ",%.*g", digits, x + 0.0); /* no -0 */
    else
        putc(',', f);
}
