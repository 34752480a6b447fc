/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Species tables: data/species.h. */
#include "data/model.h"
#include "data/species.h"
#include "fuzz.h"
#include "grow/grow.h"
#include "load/load.h"
#include <math.h>

static void check_property(const struct wf_species *sp, const struct wf_property *p)
{
    const struct wf_value *v = p->value;
    if (!v->given) return;
    must(isfinite(v->value) && isfinite(v->low) && isfinite(v->high), "a value is finite");
    must(v->low <= v->value && v->value <= v->high, "low <= value <= high");
    must(v->standing == WF_ASSUMED || wf_species_source(sp, v->source), "a source exists");
}

static void check_law(const struct wf_species *sp, const struct wf_law_use *use)
{
    const struct wf_law *law = wf_law_named(use->from, use->law);
    struct wf_property p;
    must(!use->law || law, "a law has a row");
    for (size_t i = 0; wf_law_property(law, use, i, &p); i++) check_property(sp, &p);
    for (size_t i = 0; i < WF_LAW_KEYS; i++)
        must_be_finite(use->list[i].v, use->list[i].n, "lists are finite");
}

static enum wf_status reading(struct fuzz *f)
{
    struct wf_species sp;
    struct wf_property p;
    struct wf_tree t;
    struct wf_err e = { 0 };
    struct wf_diag d = { .arena = &f->arena };
    enum wf_status s = wf_species_read(f->path, &wf_laws, &f->arena, &sp, &f->diag, &f->err);
    if (s) return s;
    must(sp.levels > 0 && sp.key && sp.name, "a species has key, name and levels");
    for (size_t k = 0; k < sp.levels; k++) {
        for (size_t i = 0; wf_level_property(&sp.level[k], i, &p); i++) check_property(&sp, &p);
        for (size_t i = 0; i < sp.level[k].wall.n; i++)
            must(sp.level[k].wall.v[i] > 0 && sp.level[k].wall.v[i] <= 1, "a wall is a share of the radius");
    }
    for (size_t i = 0; wf_crown_property(&sp, i, &p); i++) check_property(&sp, &p);
    check_law(&sp, &sp.streamlining);
    check_law(&sp, &sp.axis_drag);
    if (fuzz_done(wf_grow(fuzz_culm(), &sp, &f->arena, &t, &d, &e), &e)) must_be_tree(&t);
    return WF_OK;
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size) { return fuzz_read(data, size, reading); }
