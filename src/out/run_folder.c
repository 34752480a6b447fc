/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/run_folder.h"
#include "out/folder.h"
#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <stdlib.h>
#include <string.h>
#include <sys/file.h>
#include <sys/stat.h>
#include <unistd.h>

static const char lock_name[] = ".windfirm.lock", stage_lead[] = ".windfirm-";
static const size_t file_max = (size_t)2 << 30; /* of a folder that is drawn again [bytes] */

/* ---- Taking a folder ---- */

/* How much of the path names folders that are there. */
static size_t there_already(const char *path)
{
    char part[WF_PATH_MAX];
    struct stat s;
    snprintf(part, sizeof part, "%s", path);
    for (size_t n = strlen(part); n > 0; n = strlen(part)) {
        if (!stat(part, &s)) return n;
        char *slash = strrchr(part, '/');
        *(slash ? slash : part) = '\0';
    }
    return path[0] == '/' ? 1 : 0;
}

/* Lock the folder. The lock file is removed at the end, so a file that is no longer the one of that name is
 * tried again. */
static enum wf_status lock(struct wf_run_folder *r, struct wf_err *e)
{
    for (int attempt = 0; attempt < 100; attempt++) {
        struct stat own, there;
        r->lock = openat(r->dir, lock_name, O_RDWR | O_CREAT | O_NOFOLLOW | O_NONBLOCK | O_CLOEXEC, 0666);
        if (r->lock < 0) return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", r->path, strerror(errno));
        if (flock(r->lock, LOCK_EX | LOCK_NB)) {
            int reason = errno;
            (void)close(r->lock);
            return reason == EWOULDBLOCK
                       ? wf_fail(e, WF_EOUTPUT, "%s: another run of windfirm writes there now", r->path)
                       : wf_fail(e, WF_EOUTPUT, "%s: cannot be locked: %s", r->path, strerror(reason));
        }
        if (!fstat(r->lock, &own) && S_ISREG(own.st_mode) &&
            !fstatat(r->dir, lock_name, &there, AT_SYMLINK_NOFOLLOW) && own.st_ino == there.st_ino)
            return WF_OK;
        (void)close(r->lock);
    }
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be locked", r->path);
}

static enum wf_status open_folder(struct wf_run_folder *r, const char *folder, struct wf_err *e)
{
    if (strlen(folder) >= sizeof r->path)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    snprintf(r->path, sizeof r->path, "%s", folder);
    snprintf(r->name, sizeof r->name, "%s%ld", stage_lead, (long)getpid());
    enum wf_status s = wf_folder_path(folder, r->name, r->stage, e);
    r->there = there_already(folder);
    if (!s && !r->again) s = wf_mkdirs(folder, e);
    if (s) return s;
    r->dir = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (r->dir < 0 && r->again)
        return wf_fail(e, WF_EINPUT, "%s/%s: cannot be read; is '%s' a results folder?", folder, WF_DOCUMENT,
                       folder);
    if (r->dir < 0) return wf_fail(e, WF_EOUTPUT, "%s: cannot be opened: %s", folder, strerror(errno));
    s = lock(r, e);
    if (s) (void)close(r->dir);
    r->held = !s;
    return s;
}

/* A run that died while its files were being moved: those that it moved and that are not of the present
 * results.json are removed, so that what stays is of one run or is noticed. */
static void remove_moved(const struct wf_run_folder *r, int stage, const json_t *present)
{
    json_t *root;
    free(wf_folder_document(stage, &root));
    const json_t *list = wf_folder_list(root);
    for (size_t i = 0; i < json_array_size(list); i++) {
        const json_t *x = json_array_get(list, i);
        if (wf_folder_kind(stage, wf_folder_entry(x)) || wf_folder_mismatch(r->dir, x, -1)) continue;
        const json_t *old = wf_folder_listed(present, wf_folder_entry(x));
        if (!old || wf_folder_mismatch(r->dir, old, -1)) wf_folder_unlink(r->dir, wf_folder_entry(x));
    }
    json_decref(root);
}

static bool is_stage(const char *name)
{
    size_t lead = sizeof stage_lead - 1,
           digits = strspn(name + (strncmp(name, stage_lead, lead) ? 0 : lead), "0123456789");
    return !strncmp(name, stage_lead, lead) && digits > 0 && digits < 12 && !name[lead + digits];
}

/* Stages of other runs: the lock is ours, so those runs are dead. */
static void remove_stages(const struct wf_run_folder *r)
{
    int fd = openat(r->dir, ".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    if (!list && fd >= 0) (void)close(fd);
    if (!list) return;
    for (const struct dirent *x; (x = readdir(list));) {
        if (!is_stage(x->d_name)) continue;
        int stage = openat(fd, x->d_name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (stage < 0) continue;
        remove_moved(r, stage, r->before);
        (void)close(stage);
        wf_folder_remove(fd, x->d_name, 0);
    }
    closedir(list);
}

/* The earlier results.json: its list of files. */
static enum wf_status read_before(struct wf_run_folder *r, struct wf_err *e)
{
    json_t *root;
    mode_t kind = wf_folder_kind(r->dir, WF_DOCUMENT);
    enum wf_status code = r->again ? WF_EINPUT : WF_EOUTPUT;
    if (!kind && r->again)
        return wf_fail(e, code, "%s/%s: cannot be read; is '%s' a results folder?", r->path, WF_DOCUMENT,
                       r->path);
    if (!kind) return WF_OK;
    if (kind != S_IFREG)
        return wf_fail(e, code, "%s/%s: is not a plain file (links are not followed there)", r->path,
                       WF_DOCUMENT);
    char *text = wf_folder_document(r->dir, &root);
    const char *schema = json_string_value(json_object_get(json_object_get(root, "schema"), "name"));
    bool ours = schema && !strncmp(schema, "windfirm-", 9), known = json_object_get(root, "run_files");
    r->before = json_incref(wf_folder_list(root));
    r->unlisted = ours && !known;
    json_decref(root);
    free(text);
    if (r->again && (!ours || !known || r->before))
        return WF_OK; /* the page maker says what is wrong with it */
    if (known && !r->before)
        return wf_fail(e, code, "%s/%s: run_files: names a file that is not below the folder, or one twice",
                       r->path, WF_DOCUMENT);
    if (ours) return WF_OK;
    return wf_fail(e, code, "%s/%s: is not of windfirm; move it, or give another folder", r->path,
                   WF_DOCUMENT);
}

/* A file that a new run would replace: one of an earlier run, or nothing, may stand there. */
static bool replaceable(const struct wf_run_folder *r, const char *name)
{
    mode_t kind = wf_folder_kind(r->dir, name);
    return !kind || (kind == S_IFREG && (r->unlisted || wf_folder_listed(r->before, name)));
}

static enum wf_status in_the_way(const struct wf_run_folder *r, const char *name, struct wf_err *e)
{
    return wf_fail(e, WF_EOUTPUT, "%s/%s: no run of windfirm made it; move it, or give another folder",
                   r->path, name);
}

/* Is there a file in a room of a folder that has no results? Nothing is known of it then. */
static bool occupied(int dir, const char *room)
{
    bool found = false;
    int fd = openat(dir, room, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *list = fd < 0 ? NULL : fdopendir(fd);
    if (!list && fd >= 0) (void)close(fd);
    for (const struct dirent *x; list && !found && (x = readdir(list));) found = x->d_name[0] != '.';
    if (list) closedir(list);
    return found;
}

static enum wf_status check_folder(const struct wf_run_folder *r, const char *page, struct wf_err *e)
{
    enum wf_status code = r->again ? WF_EINPUT : WF_EOUTPUT;
    for (int i = 0; i < WF_ROOMS; i++) {
        mode_t kind = wf_folder_kind(r->dir, wf_folder_rooms[i]);
        if (kind && kind != S_IFDIR)
            return wf_fail(e, code, "%s/%s: is not a folder (links are not followed there)", r->path,
                           wf_folder_rooms[i]);
        if (!r->again && !r->before && !r->unlisted && occupied(r->dir, wf_folder_rooms[i]))
            return in_the_way(r, wf_folder_rooms[i], e);
    }
    for (size_t i = 0; i < json_array_size(r->before); i++) {
        const char *name = wf_folder_entry(json_array_get(r->before, i));
        mode_t kind = wf_folder_kind(r->dir, name);
        if (kind && kind != S_IFREG)
            return wf_fail(e, code, "%s/%s: is not a plain file (links are not followed there)", r->path,
                           name);
    }
    for (int i = 0; i < 2 && page; i++) {
        char name[64];
        snprintf(name, sizeof name, "%.40s.%s", page, i ? "pdf" : "html");
        if (!replaceable(r, name)) return in_the_way(r, name, e);
    }
    return WF_OK;
}

static enum wf_status take(struct wf_run_folder *r, const char *folder, const char *page, struct wf_err *e)
{
    enum wf_status s = open_folder(r, folder, e);
    if (s) return s;
    s = read_before(r, e);
    if (!s) remove_stages(r);
    if (!s) s = check_folder(r, page, e);
    if (!s && mkdirat(r->dir, r->name, 0777))
        s = wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", r->path, strerror(errno));
    return s ? s : wf_folder_make(r->stage, e);
}

enum wf_status wf_run_begin(struct wf_run_folder *r, const char *folder, const char *page, struct wf_err *e)
{
    *r = (struct wf_run_folder){ 0 };
    enum wf_status s = take(r, folder, page, e);
    if (s) wf_run_abandon(r);
    return s;
}

void wf_run_plain(const struct wf_run_folder *r, char *text)
{
    size_t n = strlen(r->name);
    for (char *at = text; n && (at = strstr(at, r->name));) {
        if (at > text && at[-1] == '/' && at[n] != '\0') /* "/.windfirm-PID", before "/tables/..." or ":" */
            memmove(at - 1, at + n, strlen(at + n) + 1);
        else
            at += n;
    }
}

/* ---- results.json of the stage ---- */

/* Where what this file wrote begins in a document: "status" and "run_files" are its last keys. Returned: the
 * offset behind the member before, or of the closing brace; 0: not a document of this form. */
static size_t end_of_results(const char *text)
{
    static const char mark[] = ",\n \"status\": ";
    const char *at = strstr(text, mark);
    if (at) return (size_t)(at - text);
    for (size_t n = strlen(text); n > 1; n--)
        if (!strchr(" \t\r\n", text[n - 1]))
            return text[n - 1] != '}' ? 0 : text[n - 2] == '\n' ? n - 2 : n - 1;
    return 0;
}

/* Put status and, unless NULL, the list behind the results of a document. The text of the results stays as it
 * is. */
static enum wf_status put_document(const struct wf_run_folder *r, const char *text, const char *status,
                                   const json_t *list, struct wf_err *e)
{
    struct wf_file f = { 0 };
    size_t n = end_of_results(text);
    if (!n) return wf_fail(e, WF_EINTERNAL, "%s/%s: has no end", r->path, WF_DOCUMENT);
    enum wf_status s = wf_folder_begin(&f, r->stage, WF_DOCUMENT, e);
    if (s) return s;
    fwrite(text, 1, n, f.stream);
    fprintf(f.stream, ",\n \"status\": \"%s\"", status);
    if (list) {
        fputs(",\n \"run_files\": [", f.stream);
        for (size_t i = 0; i < json_array_size(list); i++) {
            fputs(i ? ",\n  " : "\n  ", f.stream);
            if (json_dumpf(json_array_get(list, i), f.stream, 0) && !ferror(f.stream))
                s = wf_fail(e, WF_ENOMEM, "%s: no memory for the list of files", r->path);
        }
        fputs("\n ]", f.stream);
    }
    fputs("\n}\n", f.stream);
    if (!s) s = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return s;
}

/* The stage's document. Returned: its text, to be freed, and the word of its status, "complete" where it has
 * none; NULL and the error. */
static char *staged_document(const struct wf_run_folder *r, char status[static 32], struct wf_err *e)
{
    json_t *root = NULL;
    int stage = openat(r->dir, r->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    char *text = stage < 0 ? NULL : wf_folder_document(stage, &root);
    if (!root) wf_fail(e, WF_EOUTPUT, "%s/%s: cannot be written: %s", r->path, WF_DOCUMENT, strerror(errno));
    const char *found = json_string_value(json_object_get(root, "status"));
    snprintf(status, 32, "%s", found ? found : "complete");
    if (stage >= 0) (void)close(stage);
    if (!root) free(text), text = NULL;
    json_decref(root);
    return text;
}

enum wf_status wf_run_mark(const struct wf_run_folder *r, const char *status, struct wf_err *e)
{
    char before[32];
    char *text = staged_document(r, before, e);
    if (!text) return WF_EOUTPUT;
    enum wf_status s = put_document(r, text, status, NULL, e);
    free(text);
    return s;
}

/* ---- Giving a folder its files ---- */

static enum wf_status no_list(const struct wf_run_folder *r, struct wf_err *e)
{
    return wf_fail(e, WF_ENOMEM, "%s: no memory for the list of files", r->path);
}

/* Append a file to a list: its name, size and digest. Its bytes reach the disk first. */
static enum wf_status note_file(const struct wf_run_folder *r, int dir, const char *name, json_t *list,
                                struct wf_err *e)
{
    char sha256[WF_SHA256_TEXT];
    size_t size;
    int fd = wf_folder_open(dir, name, &size);
    if (fd >= 0 && dir == r->dir && size > file_max) {
        (void)close(fd);
        return wf_fail(e, WF_EINPUT, "%s/%s: is larger than 2 GB", r->path, name);
    }
    bool failed = fd < 0 || wf_sha256_read(fd, -1, sha256, &size) || (fsync(fd) && errno != EINVAL);
    int reason = errno;
    if (fd >= 0) (void)close(fd);
    if (failed)
        return wf_fail(e, WF_EOUTPUT, "%s/%s: cannot be written: %s", r->path, name, strerror(reason));
    json_t *x = json_pack("{s:s, s:I, s:s}", "name", name, "size", (json_int_t)size, "sha256", sha256);
    return x && !json_array_append_new(list, x) ? WF_OK : no_list(r, e);
}

/* Every file below a folder of the stage, hidden ones (of a part that failed) left out. `lead`: its name and
 * '/'. */
static enum wf_status note_files(const struct wf_run_folder *r, int stage, const char *lead, json_t *list,
                                 struct wf_err *e)
{
    enum wf_status s = WF_OK;
    int fd = openat(stage, *lead ? lead : ".", O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    DIR *found = fd < 0 ? NULL : fdopendir(fd);
    if (!found && fd >= 0) (void)close(fd);
    for (const struct dirent *x; found && !s && (x = readdir(found));) {
        char name[WF_NAME_MAX];
        if (x->d_name[0] == '.' || snprintf(name, sizeof name, "%s%s", lead, x->d_name) >= WF_NAME_MAX)
            continue;
        if (wf_folder_names(name) && wf_folder_kind(stage, name) == S_IFREG)
            s = note_file(r, stage, name, list, e);
    }
    if (found) closedir(found);
    return s;
}

static int by_name(const void *a, const void *b)
{
    const json_t *const *x = a, *const *y = b;
    return strcmp(wf_folder_entry(*x), wf_folder_entry(*y));
}

/* The files of the stage and those that stay, by name. Returned: a new list, or NULL and the error. */
static json_t *list_files(const struct wf_run_folder *r, struct wf_err *e)
{
    static const char *const leads[] = { "", "tables/", "plots/", "vtk/" };
    json_t *all = json_array(), *sorted = json_array();
    int stage = openat(r->dir, r->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    enum wf_status s = all && sorted && stage >= 0 ? WF_OK : no_list(r, e);
    for (size_t i = 0; i < sizeof leads / sizeof *leads && !s; i++)
        s = note_files(r, stage, leads[i], all, e);
    for (size_t i = 0; i < json_array_size(r->kept) && !s; i++) {
        json_t *x = json_array_get(r->kept, i);
        if (!wf_folder_listed(all, wf_folder_entry(x)) && json_array_append(all, x)) s = no_list(r, e);
    }
    size_t n = json_array_size(all);
    json_t **one = s || !n ? NULL : malloc(n * sizeof *one);
    if (!s && n && !one) s = no_list(r, e);
    for (size_t i = 0; i < n && one; i++) one[i] = json_array_get(all, i);
    if (one) qsort(one, n, sizeof *one, by_name);
    for (size_t i = 0; i < n && one && !s; i++)
        if (json_array_append(sorted, one[i])) s = no_list(r, e);
    free(one);
    if (stage >= 0) (void)close(stage);
    json_decref(all);
    if (s) json_decref(sorted), sorted = NULL;
    return sorted;
}

/* Move a file of the stage to its place. A copy of one that stays as it is needs no move. */
static enum wf_status move_file(const struct wf_run_folder *r, int stage, const char *name,
                                const json_t *entry, struct wf_err *e)
{
    const char *last;
    if (wf_folder_kind(stage, name) != S_IFREG) return WF_OK;
    if (entry && json_equal(entry, wf_folder_listed(r->kept, name))) return WF_OK;
    int from = wf_folder_room(stage, name, false, &last), to = wf_folder_room(r->dir, name, true, &last);
    bool failed = from < 0 || to < 0 || renameat(from, last, to, last);
    int reason = errno;
    if (from >= 0) (void)close(from);
    if (to >= 0) (void)close(to);
    if (failed)
        return wf_fail(e, WF_EOUTPUT, "%s/%s: cannot be written: %s", r->path, name, strerror(reason));
    return WF_OK;
}

/* What was renamed or removed in the folder and its rooms reaches the disk. */
static void settle(const struct wf_run_folder *r)
{
    for (int i = 0; i < WF_ROOMS; i++) {
        int fd = openat(r->dir, wf_folder_rooms[i], O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        if (fd >= 0) (void)fsync(fd), (void)close(fd);
    }
    (void)fsync(r->dir);
}

static enum wf_status move_files(const struct wf_run_folder *r, const json_t *list, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    int stage = openat(r->dir, r->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    if (stage < 0) return wf_fail(e, WF_EOUTPUT, "%s: cannot be opened: %s", r->stage, strerror(errno));
    /* a results.json without a list could not show that the tables beside it are no longer its own */
    if (r->unlisted) wf_folder_unlink(r->dir, WF_DOCUMENT);
    for (size_t i = 0; i < json_array_size(list) && !s; i++)
        s = move_file(r, stage, wf_folder_entry(json_array_get(list, i)), json_array_get(list, i), e);
    for (size_t i = 0; i < json_array_size(r->before) && !s; i++) {
        const json_t *old = json_array_get(r->before, i);
        if (!wf_folder_listed(list, wf_folder_entry(old)) && !wf_folder_mismatch(r->dir, old, -1))
            wf_folder_unlink(r->dir, wf_folder_entry(old));
    }
    settle(r);
    if (!s) s = move_file(r, stage, WF_DOCUMENT, NULL, e);
    (void)close(stage);
    settle(r);
    return s;
}

enum wf_status wf_run_commit(struct wf_run_folder *r, struct wf_err *e)
{
    char status[32];
    char *text = staged_document(r, status, e);
    json_t *list = text ? list_files(r, e) : NULL;
    enum wf_status s = list ? WF_OK : WF_EOUTPUT;
    for (size_t i = 0; i < json_array_size(list) && !s; i++) {
        const char *name = wf_folder_entry(json_array_get(list, i));
        if (!replaceable(r, name)) s = in_the_way(r, name, e);
    }
    if (!s) s = put_document(r, text, status, list, e);
    if (!s) {
        json_t *own = json_array();
        int stage = openat(r->dir, r->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        s = stage < 0 ? no_list(r, e) : note_file(r, stage, WF_DOCUMENT, own, e); /* it reaches the disk */
        if (stage >= 0) (void)close(stage);
        json_decref(own);
    }
    if (!s) s = move_files(r, list, e);
    free(text);
    json_decref(list);
    wf_run_abandon(r);
    return s ? s : WF_OK;
}

void wf_run_abandon(struct wf_run_folder *r)
{
    if (r->held) {
        wf_folder_remove(r->dir, r->name, 0);
        (void)unlinkat(r->dir, lock_name, 0);
        (void)close(r->lock);
        (void)close(r->dir);
    }
    while (strlen(r->path) > r->there && !rmdir(r->path)) { /* only folders that are empty */
        char *slash = strrchr(r->path, '/');
        *(slash ? slash : r->path) = '\0';
    }
    json_decref(r->before);
    json_decref(r->kept);
    r->before = r->kept = NULL;
    r->held = false;
    r->path[0] = r->name[0] = '\0';
}

/* ---- Drawing again ---- */

static bool ends_in(const char *name, const char *ending)
{
    const char *dot = strrchr(name, '.');
    return dot && !strcmp(dot, ending);
}

/* Is a file drawn by the page maker, not read by it? */
static bool is_drawn(const char *name)
{
    static const char *const drawn[] = { ".html", ".pdf", ".docx", ".svg", ".png" };
    for (size_t i = 0; i < sizeof drawn / sizeof *drawn; i++)
        if (ends_in(name, drawn[i])) return true;
    return false;
}

static bool is_read(const char *name)
{
    return !is_drawn(name) && (!strncmp(name, "tables/", 7) || !strncmp(name, "plots/", 6));
}

/* A new file of the stage for a copy. Returned: a descriptor, -1 and errno. */
static int open_copy(const struct wf_run_folder *r, const char *name)
{
    const char *last;
    int stage = openat(r->dir, r->name, O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
    int room = stage < 0 ? -1 : wf_folder_room(stage, name, true, &last);
    int fd = room < 0 ? -1 : openat(room, last, O_WRONLY | O_CREAT | O_EXCL | O_CLOEXEC, 0666),
        reason = errno;
    if (stage >= 0) (void)close(stage);
    if (room >= 0) (void)close(room);
    errno = reason;
    return fd;
}

/* Names of what does not match, as many as fit. */
struct faults {
    size_t n;
    char text[600];
};

static void add_fault(struct faults *f, const char *name, const char *why)
{
    size_t used = strlen(f->text);
    if (f->n++ < 12)
        (void)snprintf(f->text + used, sizeof f->text - used, "%s%s %s", used ? "; " : "", name, why);
}

/* Check and copy the listed files. */
static enum wf_status copy_listed(struct wf_run_folder *r, struct wf_diag *d, struct wf_err *e)
{
    struct faults drawn = { 0 }, bad = { 0 };
    for (size_t i = 0; i < json_array_size(r->before); i++) {
        json_t *x = json_array_get(r->before, i);
        const char *name = wf_folder_entry(x);
        if (json_integer_value(json_object_get(x, "size")) > (json_int_t)file_max)
            return wf_fail(e, WF_EINPUT, "%s/%s: is larger than 2 GB", r->path, name);
        int copy = is_read(name) ? open_copy(r, name) : -1;
        if (is_read(name) && copy < 0)
            return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", r->path, strerror(errno));
        const char *why = wf_folder_mismatch(r->dir, x, copy);
        if (copy >= 0 && close(copy)) why = "cannot be copied";
        if (why)
            add_fault(is_read(name) ? &bad : &drawn, name, why);
        else if (json_array_append(r->kept, x))
            return no_list(r, e);
    }
    if (bad.n)
        return wf_fail(
            e, WF_EINPUT,
            "%s: files of different runs stand together, or were changed: %s%s; run the command of "
            "results.json again",
            r->path, bad.text, bad.n > 12 ? "; and more" : "");
    if (drawn.n)
        wf_diag_warn(d, "changed-pages", "%s: figures or pages of another run, or changed: %s%s", r->path,
                     drawn.text, drawn.n > 12 ? "; and more" : "");
    return WF_OK;
}

/* Results of a version without a list: all that the page maker can read is taken as it is. */
static enum wf_status copy_unlisted(struct wf_run_folder *r, struct wf_diag *d, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    json_t *found = json_array();
    if (!found) return no_list(r, e);
    if (!s) s = note_files(r, r->dir, "tables/", found, e);
    if (!s) s = note_files(r, r->dir, "plots/", found, e);
    r->before = found;
    if (!s) s = copy_listed(r, d, e);
    wf_diag_warn(
        d, "not-listed",
        "%s/%s: is of a version that listed no files: whether the tables are of the same run cannot be "
        "checked",
        r->path, WF_DOCUMENT);
    return s;
}

/* The results without status and list, in their own words where that is possible. Returned: text, to be
 * freed. */
static char *bare_document(const char *text, json_t *root)
{
    size_t n = end_of_results(text);
    (void)json_object_del(root, "status");
    (void)json_object_del(root, "run_files");
    char *cut = malloc(n + 4);
    if (cut) memcpy(cut, text, n), memcpy(cut + n, "\n}\n", 4 * sizeof *cut - 1), cut[n + 3] = '\0';
    json_t *same = cut ? json_loads(cut, JSON_REJECT_DUPLICATES, NULL) : NULL;
    bool equal = same && json_equal(same, root);
    json_decref(same);
    if (equal || !cut) return cut;
    free(cut);
    return json_dumps(root, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
}

/* Put the folder's document into the stage, without the list. */
static enum wf_status copy_document(struct wf_run_folder *r, struct wf_err *e)
{
    json_t *root;
    char *text = wf_folder_document(r->dir, &root), *bare = text ? strdup(text) : NULL,
         word[32] = "unverified";
    const char *status = json_string_value(json_object_get(root, "status"));
    if (status && (!strcmp(status, "complete") || !strcmp(status, "interrupted")))
        snprintf(word, sizeof word, "%s", status);
    if (!text)
        return wf_fail(e, WF_EINPUT, "%s/%s: cannot be read: %s", r->path, WF_DOCUMENT, strerror(errno));
    enum wf_status s = WF_OK;
    if (json_is_object(root)) {
        free(bare);
        bare = bare_document(text, root);
        s = bare ? put_document(r, bare, word, NULL, e) : no_list(r, e);
    } else { /* the page maker says what is wrong with it */
        struct wf_file f = { 0 };
        s = wf_folder_begin(&f, r->stage, WF_DOCUMENT, e);
        if (!s) fputs(text, f.stream), s = wf_file_commit(&f, e);
    }
    json_decref(root);
    free(text);
    free(bare);
    return s;
}

enum wf_status wf_run_reopen(struct wf_run_folder *r, const char *folder, bool no_pdf, struct wf_diag *d,
                             struct wf_err *e)
{
    *r = (struct wf_run_folder){ .again = true, .kept = json_array() };
    enum wf_status s = r->kept ? take(r, folder, NULL, e) : no_list(r, e);
    if (!s) s = r->before ? copy_listed(r, d, e) : r->unlisted ? copy_unlisted(r, d, e) : WF_OK;
    for (size_t i = json_array_size(r->kept); i-- > 0;) {
        const char *name = wf_folder_entry(json_array_get(r->kept, i));
        if (ends_in(name, ".docx") || (no_pdf && ends_in(name, ".pdf"))) (void)json_array_remove(r->kept, i);
    }
    if (!s) s = copy_document(r, e);
    if (s) wf_run_abandon(r);
    return s;
}
