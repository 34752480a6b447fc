#include "cmd/cmd.h"
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

const char *wf_share(void)
{
    const char *named = getenv("WINDFIRM_SHARE");
    return named && *named ? named : WF_SHARE;
}

const char *wf_shipped(const char *room, const char *name, struct wf_arena *a)
{
    if (strpbrk(name, "/.") || access(name, F_OK) == 0) return name;
    const char *shipped = wf_arena_print(a, "%s/%s/%s.yaml", wf_share(), room, name);
    return shipped && access(shipped, F_OK) == 0 ? shipped : name;
}

const char *wf_beside(const char *file, const char *name, struct wf_arena *a)
{
    const char *slash = strrchr(file, '/');
    if (!slash || name[0] == '/') return name;
    const char *path = wf_arena_print(a, "%.*s/%s", (int)(slash - file), file, name);
    return path && access(path, F_OK) == 0 ? path : name;
}

void wf_progress(const char *fmt, ...)
{
    if (!isatty(STDERR_FILENO)) return;
    fputs("\r\033[K", stderr);
    if (fmt) {
        va_list list;
        va_start(list, fmt);
        vfprintf(stderr, fmt, list);
        va_end(list);
    }
    fflush(stderr);
}
