/* SPDX-License-Identifier: GPL-3.0-or-later */
/* From a tree model to the tree: grow/grow.h, with a solid and with a hollow species. */
#include "data/model.h"
#include "fuzz.h"
#include "grow/grow.h"

static void grow(const struct wf_model *m, const char *species)
{
    struct wf_arena a = { .limit = 1 << 24 }; /* a model may name a million segments: small is enough here */
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    struct wf_tree t;
    if (fuzz_done(wf_grow(m, fuzz_species(species), &a, &t, &d, &e), &e)) must_be_tree(&t);
    wf_arena_free(&a);
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_model *m;
    enum wf_status s = wf_model_open(f->path, &f->arena, &m, &f->diag, &f->err);
    if (s) return s;
    grow(m, "weeping_willow");
    grow(m, "moso_bamboo");
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
