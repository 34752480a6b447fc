/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_FOLDER_H
#define WF_TESTS_FOLDER_H
/* A folder of its own for a test, and questions about what is in it. */
#include <ftw.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

struct folder {
    char path[64], file[192]; /* `file` is the last path asked for */
};

static inline bool folder_make(struct folder *f)
{
    strcpy(f->path, "/tmp/windfirm-test-XXXXXX");
    return mkdtemp(f->path) != NULL;
}

static inline int folder_remove_one(const char *path, const struct stat *s, int kind, struct FTW *at)
{
    (void)s, (void)kind, (void)at;
    return remove(path);
}

static inline void folder_remove(const struct folder *f)
{
    nftw(f->path, folder_remove_one, 16, FTW_DEPTH | FTW_PHYS);
}

static inline const char *folder_file(struct folder *f, const char *name)
{
    snprintf(f->file, sizeof f->file, "%s/%s", f->path, name);
    return f->file;
}

static inline bool folder_has(struct folder *f, const char *name)
{
    return !access(folder_file(f, name), F_OK);
}

/* The whole file as text, to be freed; NULL when it cannot be read. */
static inline char *folder_read(struct folder *f, const char *name)
{
    FILE *in = fopen(folder_file(f, name), "rb");
    if (!in) return NULL;
    size_t used = 0, room = 1 << 22;
    char *text = malloc(room + 1);
    if (text) used = fread(text, 1, room, in), text[used] = '\0';
    fclose(in);
    return text;
}

static inline size_t lines_of(const char *text)
{
    size_t n = 0;
    for (; *text; text++) n += *text == '\n';
    return n;
}

/* Is there any file left under a temporary name? They begin with a dot. */
static bool folder_dotted;
static inline int folder_look(const char *path, const struct stat *s, int kind, struct FTW *at)
{
    (void)s, (void)kind;
    if (path[at->base] == '.') folder_dotted = true;
    return 0;
}
static inline bool folder_has_leftovers(const struct folder *f)
{
    folder_dotted = false;
    nftw(f->path, folder_look, 16, FTW_PHYS);
    return folder_dotted;
}
#endif
