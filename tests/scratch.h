/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_TESTS_SCRATCH_H
#define WF_TESTS_SCRATCH_H
/* Scratch files and findings for tests: text in, "line:column: message" lines out. */
#include "base/err.h"
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

struct scratch {
    char folder[64], path[96];
};

/* A folder of its own with one file of `size` bytes in it. */
static inline void scratch_write(struct scratch *s, const void *bytes, size_t size)
{
    snprintf(s->folder, sizeof s->folder, "/tmp/windfirm-test-XXXXXX");
    assert_non_null(mkdtemp(s->folder));
    snprintf(s->path, sizeof s->path, "%s/file", s->folder);
    FILE *f = fopen(s->path, "wb");
    assert_non_null(f);
    assert_int_equal(fwrite(bytes, 1, size, f), size);
    assert_int_equal(fclose(f), 0);
}

static inline void scratch_remove(struct scratch *s)
{
    unlink(s->path);
    assert_int_equal(rmdir(s->folder), 0);
}

/* All findings as lines "3:5: text". */
static inline void findings_print(const struct wf_diag *d, char *buf, size_t size)
{
    size_t n = 0;
    *buf = '\0';
    for (const struct wf_finding *f = d->first; f && n < size; f = f->next)
        n += (size_t)snprintf(buf + n, size - n, "%s%zu:%zu: %s", n ? "\n" : "", f->line, f->column, f->text);
}
#endif
