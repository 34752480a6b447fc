/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Fuzz target of the readers of tables and models (libFuzzer). Build and run:
 *   clang -std=c17 -D_GNU_SOURCE -g -O1 -fsanitize=fuzzer,address,undefined -Isrc tests/fuzz_yaml.c \
 *       src/base/ *.c src/data/ *.c src/grow/stem.c -lyaml -ludunits2 -lm \
 *       -Wl,--wrap=wf_units_open,--wrap=wf_units_close -o fuzz_yaml
 *   ./fuzz_yaml -max_len=4096 -max_total_time=60 CORPUS     (a folder with copies of species/ and models/)
 * Whatever is accepted must be safe to use: a model and a species that pass are grown into a tree, and the
 * tree must pass its own check. The first byte chooses the reader. */
#include "base/csv.h"
#include "data/model.h"
#include "data/species.h"
#include "grow/stem.h"
#include "load/drag.h"
#include "load/load.h"
#include <math.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/mman.h>
#include <unistd.h>

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

/* Reading the units database takes most of a run's time: the linker puts these in its place, so it is read
 * once. */
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

static void must(bool ok, const char *what)
{
    if (ok) return;
    fprintf(stderr, "broken promise: %s\n", what);
    abort();
}

static struct wf_value known(double v)
{
    return (struct wf_value){ .value = v, .low = v, .high = v, .given = true };
}

static void grow(const struct wf_model *m, const struct wf_species *sp, struct wf_arena *a)
{
    struct wf_tree t;
    struct wf_err e = { 0 };
    struct wf_diag d = { .arena = a };
    if (wf_grow_stem(m, sp, a, &t, &e)) return;
    must(!wf_tree_check(&t, &d, &e), d.first ? d.first->text : e.text);
}

static void model(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_model m;
    struct wf_level level = { .youngs_modulus = known(1e10),
                              .shear_modulus = known(6e8),
                              .density = known(800),
                              .radius = known(0.1),
                              .knot_factor = known(1),
                              .drag_coefficient = { .value = NAN } };
    struct wf_species sp = { .key = "s",
                             .levels = 1,
                             .level = &level,
                             .crown.drag_coefficient = known(0.5),
                             .crown.leaf_mass_per_area = known(0.2),
                             .crown.frontal_share = known(0.3) };
    if (wf_model_read(path, a, &m, d, e)) return;
    must(m.key && m.name, "an accepted model has key and name");
    if (m.segments <= 1000) grow(&m, &sp, a);
}

static void species(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_species sp;
    const struct wf_model m = { .key = "m",
                                .name = "m",
                                .height = 10,
                                .radius = NAN,
                                .taper = WF_TAPER_LINEAR,
                                .tip_ratio = 0.3,
                                .segments = 5,
                                .crown_base = 4,
                                .crown_top = 10 };
    if (wf_species_read(path, &wf_laws, a, &sp, d, e)) return;
    must(sp.levels > 0, "an accepted species has levels");
    for (size_t i = 0; i < sp.levels; i++) {
        const struct wf_value *v = &sp.level[i].density;
        must(v->low <= v->value && v->value <= v->high, "low <= value <= high");
        must(v->standing == WF_ASSUMED || wf_species_source(&sp, v->source), "a source exists");
    }
    grow(&m, &sp, a);
}

static void table(const char *path, struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_csv c;
    double v;
    if (wf_csv_open(&c, path, a, d, e)) return;
    (void)wf_csv_need(&c, "id");
    while (wf_csv_next(&c))
        for (size_t i = 0; i < c.columns; i++)
            if (wf_csv_number(&c, i, -1e3, 1e3, &v)) must(v >= -1e3 && v <= 1e3, "a cell lies in its range");
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    if (!size) return 0;
    char path[64];
    int fd = memfd_create("fuzz", 0);
    must(fd >= 0 && write(fd, data + 1, size - 1) == (ssize_t)(size - 1), "a scratch file");
    snprintf(path, sizeof path, "/proc/self/fd/%d", fd);
    struct wf_arena a = { .limit = (size_t)1 << 26 };
    struct wf_diag d = { .arena = &a };
    struct wf_err e = { 0 };
    (data[0] % 3 == 0 ? species : data[0] % 3 == 1 ? model : table)(path, &a, &d, &e);
    must(e.code != WF_EINTERNAL, "no internal fault");
    must(e.code == WF_OK ? d.errors == 0 || data[0] % 3 == 2 : e.text[0] != '\0', "an error has words");
    wf_arena_free(&a);
    close(fd);
    return 0;
}
