/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "data/ifs.h"
#include "base/num.h"
#include "data/branching.h"
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

static const char *const ifs_words[] = { "monopodial", "sympodial", "false_dichotomous", NULL };

double wf_stretch(const double a[9])
{
    double m[9], v[9], s[3];
    memcpy(m, a, sizeof m);
    gsl_matrix_view mv = gsl_matrix_view_array(m, 3, 3), vv = gsl_matrix_view_array(v, 3, 3);
    gsl_vector_view sv = gsl_vector_view_array(s, 3);
    wf_quiet_begin();
    int failed = gsl_linalg_SV_decomp_jacobi(&mv.matrix, &vv.matrix, &sv.vector);
    wf_quiet_end();
    return failed ? INFINITY : s[0];
}

static double moran_sum(const struct wf_ifs *f, double dimension)
{
    double sum = 0;
    for (size_t i = 0; i < f->maps; i++)
        if (f->map[i].until + 1 >= f->levels) sum += pow(f->map[i].factor, dimension);
    return sum;
}

double wf_ifs_dimension(const struct wf_ifs *f)
{
    double low = 0, high = 1;
    if (moran_sum(f, 0) < 2) return 0;
    while (moran_sum(f, high) > 1) high *= 2; /* every factor is below 1 */
    for (int halving = 0; halving < 60; halving++) {
        double middle = 0.5 * (low + high);
        if (moran_sum(f, middle) > 1)
            low = middle;
        else
            high = middle;
    }
    return 0.5 * (low + high);
}

/* a = scale Rz(azimuth) Ry(inclination) Rz(roll), b = (0, 0, position). */
static void compose_map(struct wf_ifs_map *m)
{
    double ca = cos(m->azimuth), sa = sin(m->azimuth), ci = cos(m->inclination), si = sin(m->inclination),
           cr = cos(m->roll), sr = sin(m->roll);
    const double turn[9] = { ca * ci * cr - sa * sr,
                             -ca * ci * sr - sa * cr,
                             ca * si,
                             sa * ci * cr + ca * sr,
                             -sa * ci * sr + ca * cr,
                             sa * si,
                             -si * cr,
                             si * sr,
                             ci };
    for (int k = 0; k < 9; k++) m->a[k] = m->scale * turn[k];
    m->b[0] = m->b[1] = 0;
    m->b[2] = m->position;
}

static bool map_of_matrix(struct wf_yaml *y, struct wf_ifs_map *m)
{
    static const char *const others[] = { "position", "scale", "inclination", "azimuth", "roll" };
    for (size_t k = 0; k < WF_COUNT(others); k++)
        if (wf_yaml_has(y, others[k])) wf_yaml_error(y, others[k], "is not used beside 'matrix'");
    if (m->cells != 12)
        return wf_yaml_error(y, "matrix", "%zu numbers; three rows of four are 12", m->cells), false;
    for (size_t i = 0; i < 3; i++) {
        for (size_t k = 0; k < 3; k++) m->a[3 * i + k] = m->matrix[4 * i + k];
        m->b[i] = m->matrix[4 * i + 3];
    }
    m->position = m->b[2];
    if (fabs(m->b[0]) > 1e-9 || fabs(m->b[1]) > 1e-9 || !(m->b[2] > 0 && m->b[2] <= 1))
        wf_yaml_error(
            y, "matrix",
            "the copy starts at (%g, %g, %g), not on the axis: the last column is 0, 0 and a position "
            "above 0, at most 1",
            m->b[0], m->b[1], m->b[2]);
    return true;
}

static void map_finish(struct wf_yaml *y, void *map)
{
    struct wf_ifs_map *m = map;
    const char *name = m->name ? m->name : "this map";
    if (wf_yaml_has(y, "matrix")) {
        if (!m->matrix || !map_of_matrix(y, m)) return;
    } else {
        bool whole = true;
        for (int k = 0; k < 2; k++) {
            const char *key = k ? "scale" : "position";
            if (!wf_yaml_has(y, key)) whole = false, wf_yaml_error(y, "", "missing key '%s'", key);
        }
        if (!whole || !isfinite(m->scale) || !isfinite(m->position)) return;
        compose_map(m);
    }
    for (int k = 0; k < 9; k++)
        if (!isfinite(m->a[k])) return;
    m->factor = wf_stretch(m->a);
    double length = sqrt(m->a[2] * m->a[2] + m->a[5] * m->a[5] + m->a[8] * m->a[8]);
    if (m->factor >= 1)
        wf_yaml_error(y, m->matrix ? "matrix" : "scale",
                      "%s does not contract: its factor (largest stretch) is %.6g; it must be below 1", name,
                      m->factor);
    else if (length < 1e-3)
        wf_yaml_error(y, "matrix", "%s leaves nothing of the axis: its length is %.3g of the parent's", name,
                      length);
    if (isnan(m->radius)) m->radius = fmin(length, 1);
}

#define T struct wf_ifs_map

static const struct wf_yaml_row map_rows[] = {
    WF_KEY_TEXT("name", name, "Readable name.", .absent = "named by its number", .example = "upper side"),
    WF_KEY_NUMBER("position", position, 1e-3, 1, "Where the copy stands on the axis, 1 = its tip.",
                  .absent = "needed unless matrix is given", .example = "0.6"),
    WF_KEY_NUMBER("scale", scale, 1e-3, 100, "Size of the copy over the whole; below 1.",
                  .absent = "needed unless matrix is given", .example = "0.5"),
    WF_KEY_ANGLE("inclination", inclination, 0, 0.5, "Between the axis and the axis of the copy.",
                 .initial = "0 deg", .example = "50 deg"),
    WF_KEY_ANGLE("azimuth", azimuth, -1, 1, "Direction of the copy about the axis.", .initial = "0 deg",
                 .example = "120 deg"),
    WF_KEY_ANGLE("roll", roll, -1, 1, "Turn of the copy about its own axis, before it is inclined.",
                 .initial = "0 deg", .example = "90 deg"),
    WF_KEY_NUMBER(
        "radius", radius, 1e-3, 1,
        "Base radius of the copy's axis over the base radius of the axis; not above the local radius.",
        .absent = "as the length", .example = "0.4"),
    WF_KEY_INTEGER("until", until, 1, WF_BRANCH_LEVELS_MAX,
                   "Last level on which the map acts, 1 = the branches on the stem.", .initial = "8",
                   .example = "1"),
    WF_KEY_NUMBERS("matrix", matrix, cells, -10, 10,
                   "The affine map itself, three rows of four: x -> A x + b with b in the last column, in "
                   "units of the axis, which runs from (0, 0, 0) to (0, 0, 1).",
                   .absent = "made of position, scale and angles",
                   .example = "[0.5, 0, 0, 0, 0, 0.5, 0, 0, 0, 0, 0.5, 0.6]"),
    { .key = NULL },
};

static const struct wf_yaml_table map_table = {
    .title = "a map", .row = map_rows, .size = sizeof(struct wf_ifs_map), .finish = map_finish, .doc = ""
};

/* False dichotomy: to each map add its copy, rotated by half a turn about the axis. */
static void double_maps(struct wf_yaml *y, struct wf_ifs *f)
{
    struct wf_ifs_map *two = wf_yaml_take(y, 2 * f->maps, sizeof *two);
    if (!two) return;
    for (size_t i = 0; i < f->maps; i++) {
        two[2 * i] = two[2 * i + 1] = f->map[i];
        for (int k = 0; k < 6; k++) two[2 * i + 1].a[k] = -f->map[i].a[k];
    }
    f->map = two;
    f->maps *= 2;
}

static void ifs_finish(struct wf_yaml *y, void *ifs)
{
    struct wf_ifs *f = ifs;
    size_t tip = 0, wanted = f->form == WF_IFS_MONOPODIAL ? 0 : 1;
    char key[32];
    for (size_t i = 0; i < f->maps; i++) {
        bool at_tip = f->map[i].position >= 1;
        tip += at_tip;
        (void)snprintf(key, sizeof key, "maps[%zu]", i);
        if (at_tip && wanted == 0)
            wf_yaml_error(y, key,
                          "stands at the tip; in form 'monopodial' the axis continues above every copy");
    }
    if (f->maps && wanted == 1 && tip != 1)
        wf_yaml_error(y, "maps", "%zu stand at the tip (position 1); form '%s' needs exactly one", tip,
                      ifs_words[f->form]);
    if (f->form == WF_IFS_FALSE_DICHOTOMOUS) double_maps(y, f);
}

#undef T
#define T struct wf_ifs

static const struct wf_yaml_row ifs_rows[] = {
    WF_KEY_ENUM(
        "form", form, ifs_words,
        "monopodial: the axis continues above every copy; sympodial: its tip dies and one copy at the tip "
        "continues it; false_dichotomous: its tip dies, every map stands for two copies opposite "
        "each other, and those at the tip form the fork.",
        .initial = "monopodial", .example = "monopodial"),
    WF_KEY_INTEGER("levels", levels, 1, WF_BRANCH_LEVELS_MAX, "How many levels grow, the stem included.",
                   .required = true, .example = "3"),
    WF_KEY_LIST("maps", map, maps, map_table, "The contractive maps of the whole to its copies.",
                .required = true),
    { .key = NULL },
};

const struct wf_yaml_table wf_ifs_table = {
    .title = "an iterated function system", .row = ifs_rows, .finish = ifs_finish, .doc = ""
};
