/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Validation cases and their trees: cases/read.h, cases/build.h. */
#include "cases/build.h"
#include "cases/read.h"
#include "fuzz.h"
#include <stdlib.h>

/* A case without files of its own is built as for its first solver. */
static void build(const struct wf_case *c)
{
    struct wf_arena a = { .limit = 1 << 24 };
    struct wf_setup *s = WF_TAKE(&a, 1, struct wf_setup);
    struct wf_err e = { 0 };
    must(c->name && c->solvers <= WF_CASE_SOLVERS_MAX && c->pieces <= WF_CASE_PIECES_MAX, "a case is whole");
    if (c->tree_file || c->fit_calibration || c->shape == WF_SHAPE_FLOW || c->shape == WF_SHAPE_NONE)
        s = NULL;
    if (s && fuzz_done(wf_setup_build(c, c->pieces ? c->piece[0] : 1, &a, s, &e), &e)) {
        must(s->tree.n > 0 && s->rows > 0, "a structure has rows");
        for (size_t i = 0; i < s->tree.n; i++)
            must(s->tree.parent[i] < (int32_t)i, "parents come before their children");
        must_be_finite(s->tree.x1, s->tree.n, "a structure is finite");
    }
    wf_arena_free(&a);
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_case *list;
    size_t n;
    enum wf_status s = wf_case_read(f->path, &f->arena, &f->diag, &list, &n, &f->err);
    if (s) return s;
    must(n > 0, "a file has cases");
    for (size_t i = 0; i < n; i++) build(&list[i]);
    return WF_OK;
}

static enum wf_status tree(struct fuzz *f)
{
    struct wf_tree t;
    enum wf_status s = wf_case_tree_read(f->path, &f->arena, &t, &f->err);
    if (s) return s;
    must(t.n > 0, "a tree has rows");
    for (size_t i = 0; i < t.n; i++)
        must(t.parent[i] >= -1 && t.parent[i] < (int32_t)i, "parents come before their children");
    must_be_finite(t.x1, t.n, "a tree is finite");
    must_be_finite(t.r0, t.n, "radii are finite");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    fuzz_read(data, size, reading);
    return fuzz_read(data, size, tree);
}
