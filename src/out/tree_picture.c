#include "out/tree_picture.h"
#include "base/file.h"
#include "out/tree_summary.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char *const parts[] = { "tree.dat", "tree_data.gp" };

static enum wf_status path_of(const char *folder, const char *name, char path[static WF_PATH_MAX],
                              struct wf_err *e)
{
    int n = snprintf(path, WF_PATH_MAX, "%s/plots/%s", folder, name);
    if (n >= 0 && n < WF_PATH_MAX) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
}

void wf_tree_picture_remove(const char *folder)
{
    char path[WF_PATH_MAX];
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (!path_of(folder, parts[k], path, NULL)) (void)unlink(path);
}

bool wf_tree_picture_there(const char *folder)
{
    char path[WF_PATH_MAX];
    return !path_of(folder, "tree_data.gp", path, NULL) && !access(path, R_OK);
}

/* A segment seen from a side: across x (front) or y (side). Segments thinner than `thin` become lines. */
static void outline(FILE *f, const struct wf_tree *t, size_t i, bool side, bool thick)
{
    double x0 = side ? t->y0[i] : t->x0[i], x1 = side ? t->y1[i] : t->x1[i], z0 = t->z0[i], z1 = t->z1[i];
    if (!thick) {
        fprintf(f, "%.5g %.5g\n%.5g %.5g\n\n", x0, z0, x1, z1);
        return;
    }
    double dx = x1 - x0, dz = z1 - z0, length = hypot(dx, dz);
    double nx = length > 0 ? -dz / length : 1, nz = length > 0 ? dx / length : 0;
    double a = t->r0[i], b = t->r1[i];
    if (length < a) { /* seen end on: a square is as near to the disc as a line's width shows */
        fprintf(f, "%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n\n", x0 - a, z0 - a, x0 + a,
                z0 - a, x0 + a, z0 + a, x0 - a, z0 + a, x0 - a, z0 - a);
        return;
    }
    fprintf(f, "%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n\n", x0 + a * nx, z0 + a * nz,
            x1 + b * nx, z1 + b * nz, x1 - b * nx, z1 - b * nz, x0 - a * nx, z0 - a * nz, x0 + a * nx,
            z0 + a * nz);
}

/* Blocks by level, view and thickness, in the order the script counts them; one empty mark at the base keeps
 * a block without segments from being no block at all. */
static void outlines(FILE *f, const struct wf_tree *t, size_t levels, double thin)
{
    for (size_t l = 0; l < levels; l++)
        for (int kind = 0; kind < 4; kind++) {
            bool side = kind >= 2, thick = kind % 2 == 0;
            double x = side ? t->y0[0] : t->x0[0];
            for (int corner = 0; corner < (thick ? 5 : 2); corner++) fprintf(f, "%.5g %.5g\n", x, t->z0[0]);
            fputc('\n', f);
            for (size_t i = 0; i < t->n; i++) {
                size_t level = t->level[i] > 0 ? (size_t)t->level[i] : 0;
                if (level >= levels) level = levels - 1;
                if (level == l && (fmax(t->r0[i], t->r1[i]) > 0.5 * thin) == thick)
                    outline(f, t, i, side, thick);
            }
            fputc('\n', f);
        }
}

static void quote(FILE *f, const char *text)
{
    fputc('\'', f);
    for (const char *c = text ? text : ""; *c; c++) {
        if (*c == '\'') fputc('\'', f);
        fputc(*c == '\n' ? ' ' : *c, f);
    }
    fputc('\'', f);
}

/* Rows of the table: a name and a value. */
struct table {
    FILE *f;
    size_t rows;
};
static void entry(struct table *t, const char *name, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
static void entry(struct table *t, const char *name, const char *fmt, ...)
{
    char value[160];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(value, sizeof value, fmt, args);
    va_end(args);
    fprintf(t->f, "P_NAME[%zu] = ", ++t->rows);
    quote(t->f, name);
    fprintf(t->f, "; P_VALUE[%zu] = ", t->rows);
    quote(t->f, value);
    fputc('\n', t->f);
}

static void parameters(struct table *t, const struct wf_tree_picture *p, const struct wf_tree_summary *s)
{
    const struct wf_model *m = p->model;
    entry(t, "model", "%s", m->key);
    entry(t, "species", "%s", p->species->name);
    entry(t, "generator", "%s",
          m->generator == WF_GENERATOR_MEASURED ? "measured" : wf_generator_words[m->generator]);
    entry(t, "height", "%.4g m", s->height);
    entry(t, "base diameter", "%.4g mm", 2e3 * p->tree->r0[0]);
    entry(t, "wood", "%.4g m³", s->wood_volume);
    if (s->leaf_area > 0)
        entry(t, "leaf area", "%.4g m²", s->leaf_area);
    else
        entry(t, "leaf area", "no leaves");
    entry(t, "segments", "%zu", p->tree->n);
    if (m->generator == WF_GENERATOR_LEVELS) entry(t, "seed", "%zu", m->seed);
    if (m->generator == WF_GENERATOR_IFS) {
        double factor = 0;
        for (size_t i = 0; i < m->ifs.maps; i++) factor = fmax(factor, m->ifs.map[i].factor);
        entry(t, "maps", "%zu", m->ifs.maps);
        entry(t, "contraction", "%.3g", factor);
        entry(t, "dimension", "%.3g", wf_ifs_dimension(&m->ifs));
    }
}

/* A column of the table of levels, one text a level. */
static void column(FILE *f, const char *name, const struct wf_tree_summary *s, int which)
{
    fprintf(f, "array %s[%zu] = [", name, s->levels);
    for (size_t l = 0; l < s->levels; l++) {
        const struct wf_level_summary *v = &s->level[l];
        char text[64] = "";
        if (which == 0) (void)snprintf(text, sizeof text, "%zu", v->axes);
        if (which == 1 && v->length_most - v->length_least > 0.005 * v->length_most)
            (void)snprintf(text, sizeof text, "%.2g–%.2g", v->length_least, v->length_most);
        else if (which == 1)
            (void)snprintf(text, sizeof text, "%.3g", v->length_mean);
        if (which == 2) (void)snprintf(text, sizeof text, "%.3g", 1e3 * v->diameter_mean);
        if (l) fputs(", ", f);
        quote(f, text);
    }
    fputs("]\n", f);
}

static void data(FILE *f, const struct wf_tree_picture *p, const struct wf_tree_summary *s)
{
    struct table t = { .f = f };
    fputs("# A tree for reports/plots/tree.gp; written by windfirm.\nTITLE = ", f);
    quote(f, p->model->name);
    fprintf(f, "\nLEVELS = %zu\nSEGMENTS = %zu\narray LEVEL[%zu] = [", s->levels, p->tree->n, s->levels);
    for (size_t l = 0; l < s->levels; l++) {
        if (l) fputs(", ", f);
        quote(f, wf_model_level_name(p->model, p->species, (int32_t)l));
    }
    fprintf(f, "]\nX_LOW = %.6g; X_HIGH = %.6g\nY_LOW = %.6g; Y_HIGH = %.6g\nZ_LOW = %.6g; Z_HIGH = %.6g\n",
            s->low[0], s->high[0], s->low[1], s->high[1], s->low[2], s->high[2]);
    column(f, "L_COUNT", s, 0);
    column(f, "L_LENGTH", s, 1);
    column(f, "L_DIAMETER", s, 2);
    fputs("array P_NAME[40]; array P_VALUE[40]\n", f);
    parameters(&t, p, s);
    fprintf(f, "P_ROWS = %zu\n", t.rows);
}

enum wf_status wf_tree_picture_write(const struct wf_tree_picture *p, const char *folder, struct wf_err *e)
{
    const double pixels = 420; /* height of a view in the picture: what is thinner than one is a line */
    char path[WF_PATH_MAX];
    struct wf_tree_summary s;
    enum wf_status code = wf_tree_summarise(p->tree, &s, e);
    if (code) return code;
    double size = fmax(s.high[2] - s.low[2], fmax(s.high[0] - s.low[0], s.high[1] - s.low[1]));
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++) {
        struct wf_file f = { 0 };
        code = path_of(folder, parts[k], path, e);
        if (!code) code = wf_file_begin(&f, path, e);
        if (code) return code;
        if (k == 0)
            outlines(f.stream, p->tree, s.levels, size / pixels);
        else
            data(f.stream, p, &s);
        code = wf_file_commit(&f, e);
        wf_file_abandon(&f);
        if (code) return code;
    }
    return WF_OK;
}
