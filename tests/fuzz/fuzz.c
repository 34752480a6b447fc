/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "fuzz.h"
#include "base/units.h"
#include "data/model.h"
#include "data/species.h"
#include "load/load.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <unistd.h>

/* The linker puts these in the place of wf_units_open and wf_units_close (--wrap): UDUNITS reads its database
 * for 3 ms and never frees its prefixes, so one table is kept for all runs. */
enum wf_status __real_wf_units_open(struct wf_units **out, struct wf_err *e);
enum wf_status __wrap_wf_units_open(struct wf_units **out, struct wf_err *e);
void __wrap_wf_units_close(struct wf_units *u);

enum wf_status __wrap_wf_units_open(struct wf_units **out, struct wf_err *e)
{
    static struct wf_units *units;
    enum wf_status code = units ? WF_OK : __real_wf_units_open(&units, e);
    *out = units;
    return code;
}

void __wrap_wf_units_close(struct wf_units *u) { (void)u; }

/* UDUNITS 2.2 does not free the words of a unit that it cannot parse; asked for by the leak sanitizer. */
const char *__lsan_default_suppressions(void);
const char *__lsan_default_suppressions(void) { return "leak:utlex\n"; }

void must(bool ok, const char *promise)
{
    if (ok) return;
    fprintf(stderr, "broken promise: %s\n", promise);
    abort();
}

void must_be_finite(const double *v, size_t n, const char *what)
{
    for (size_t i = 0; v && i < n; i++) must(isfinite(v[i]), what);
}

bool fuzz_done(enum wf_status s, const struct wf_err *e)
{
    must(s != WF_EINTERNAL, "no internal fault");
    must(s == e->code, "the status is that of the error");
    must(!s || e->text[0], "an error has words");
    return !s;
}

/* A file in memory; always the same one, because a run needs no other. */
static const char *file_of(const uint8_t *data, size_t size)
{
    static char path[64];
    static int fd = -1;
    if (fd < 0) {
        fd = memfd_create("fuzz", 0);
        snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    }
    must(fd >= 0 && ftruncate(fd, 0) == 0, "a scratch file");
    must(!size || pwrite(fd, data, size, 0) == (ssize_t)size, "a scratch file takes the input");
    return path;
}

int fuzz_read(const uint8_t *data, size_t size, enum wf_status (*read)(struct fuzz *f))
{
    struct fuzz f = { .path = file_of(data, size), .data = data, .size = size, .arena.limit = FUZZ_ARENA };
    char line[4096];
    f.diag.arena = &f.arena;
    enum wf_status s = read(&f);
    if (fuzz_done(s, &f.err)) must(!f.diag.errors, "a file with mistakes is not accepted");
    for (const struct wf_finding *w = f.diag.first; w; w = w->next) {
        must(w->text && w->text[0], "a finding has words");
        must(wf_finding_print(w, line, sizeof line)[0], "a finding can be printed");
    }
    wf_arena_free(&f.arena);
    return 0;
}

void must_be_tree(const struct wf_tree *t)
{
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    const double *column[] = {
        t->x0,      t->y0,       t->z0,    t->x1,      t->y1,      t->z1,    t->r0,
        t->r1,      t->i0,       t->i1,    t->youngs,  t->shear,   t->sail0, t->sail1,
        t->density, t->strength, t->leaf0, t->burden0, t->burden1, t->leaf1, t->mass1
    };
    must(t->n > 0, "a tree has segments");
    for (size_t i = 0; i < t->n; i++)
        must(t->parent[i] >= -1 && t->parent[i] < (int32_t)i, "parents come before their children");
    for (size_t k = 0; k < sizeof column / sizeof *column; k++)
        must_be_finite(column[k], t->n, "numbers of a tree are finite");
    must(!wf_tree_check(t, &d, &e), d.first ? d.first->text : e.text);
    wf_arena_free(&a);
}

const struct wf_species *fuzz_species(const char *name)
{
    static struct wf_arena a;
    static struct kept {
        const char *name;
        struct wf_species species;
    } kept[4];
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    char path[256];
    size_t i = 0;
    while (kept[i].name && strcmp(kept[i].name, name) != 0) i++;
    if (kept[i].name) return &kept[i].species;
    snprintf(path, sizeof path, "species/%s.yaml", name);
    must(!wf_species_read(path, &wf_laws, &a, &kept[i].species, &d, &e), e.text);
    kept[i].name = name;
    return &kept[i].species;
}

const struct wf_model *fuzz_culm(void)
{
    static struct wf_arena a;
    static struct wf_model m;
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    if (!m.key) must(!wf_model_read("models/culm.yaml", &a, &m, &d, &e), e.text);
    return &m;
}
