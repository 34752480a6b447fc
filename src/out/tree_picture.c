#include "out/tree_picture.h"
#include "base/file.h"
#include "out/plot_data.h"
#include "out/tree_summary.h"
#include <math.h>
#include <stdarg.h>
#include <stdio.h>
#include <string.h>
#include <unistd.h>

static const char *const parts[] = { "tree.dat", "tree.csv" };

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
    return !path_of(folder, "tree.csv", path, NULL) && !access(path, R_OK);
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

/* Rows of the table beside the picture: a name that has a label in the figure's words, and a value. */
struct side_table {
    struct wf_plot_data *p;
    size_t rows;
};
static void entry(struct side_table *t, const char *name, const char *fmt, ...)
    __attribute__((format(printf, 3, 4)));
static void entry(struct side_table *t, const char *name, const char *fmt, ...)
{
    char value[160];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(value, sizeof value, fmt, args);
    va_end(args);
    wf_plot_data_text(t->p, "P_NAME", ++t->rows, name);
    wf_plot_data_text(t->p, "P_VALUE", t->rows, value);
}

/* The same with a value that is a word, with a label of its own. */
static void entry_word(struct side_table *t, const char *name, const char *word)
{
    wf_plot_data_text(t->p, "P_NAME", ++t->rows, name);
    wf_plot_data_text(t->p, "P_WORD", t->rows, word);
}

static void parameters(struct side_table *t, const struct wf_tree_picture *p, const struct wf_tree_summary *s)
{
    const struct wf_model *m = p->model;
    entry(t, "model", "%s", m->key);
    entry(t, "species", "%s", p->species->name);
    entry_word(t, "generator",
               m->generator == WF_GENERATOR_MEASURED ? "measured" : wf_generator_words[m->generator]);
    entry(t, "height", "%.4g m", s->height);
    entry(t, "base diameter", "%.4g mm", 2e3 * p->tree->r0[0]);
    entry(t, "wood", "%.4g m³", s->wood_volume);
    if (s->leaf_area > 0)
        entry(t, "leaf area", "%.4g m²", s->leaf_area);
    else
        entry_word(t, "leaf area", "no leaves");
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

static void level_row(struct wf_plot_data *p, const struct wf_level_summary *v, size_t level)
{
    wf_plot_data_count(p, "L_COUNT", level, v->axes);
    if (v->length_most - v->length_least > 0.005 * v->length_most)
        wf_plot_data_print(p, "L_LENGTH", level, "%.2g–%.2g", v->length_least, v->length_most);
    else
        wf_plot_data_print(p, "L_LENGTH", level, "%.3g", v->length_mean);
    wf_plot_data_print(p, "L_DIAMETER", level, "%.3g", 1e3 * v->diameter_mean);
}

static enum wf_status plot_data(const char *folder, const struct wf_tree_picture *p,
                                const struct wf_tree_summary *s, struct wf_err *e)
{
    static const char *const low[] = { "X_LOW", "Y_LOW", "Z_LOW" }, *const high[] = { "X_HIGH", "Y_HIGH",
                                                                                      "Z_HIGH" };
    struct wf_plot_data to;
    struct side_table t = { .p = &to };
    enum wf_status code = wf_plot_data_begin(&to, folder, "tree", e);
    if (code) return code;
    wf_plot_data_text(&to, "TITLE", 0, p->model->name);
    wf_plot_data_count(&to, "LEVELS", 0, s->levels);
    wf_plot_data_count(&to, "SEGMENTS", 0, p->tree->n);
    for (int k = 0; k < 3; k++) {
        wf_plot_data_number(&to, low[k], 0, s->low[k]);
        wf_plot_data_number(&to, high[k], 0, s->high[k]);
    }
    for (size_t l = 0; l < s->levels; l++) {
        wf_plot_data_text(&to, "LEVEL", l + 1, wf_model_level_name(p->model, p->species, (int32_t)l));
        level_row(&to, &s->level[l], l + 1);
    }
    parameters(&t, p, s);
    wf_plot_data_count(&to, "P_ROWS", 0, t.rows);
    return wf_plot_data_end(&to, e);
}

enum wf_status wf_tree_picture_write(const struct wf_tree_picture *p, const char *folder, struct wf_err *e)
{
    const double pixels = 420; /* height of a view in the picture: what is thinner than one is a line */
    char path[WF_PATH_MAX];
    struct wf_tree_summary s;
    enum wf_status code = wf_tree_summarise(p->tree, &s, e);
    if (code) return code;
    double size = fmax(s.high[2] - s.low[2], fmax(s.high[0] - s.low[0], s.high[1] - s.low[1]));
    struct wf_file f = { 0 };
    if (!code) code = path_of(folder, "tree.dat", path, e);
    if (!code) code = wf_file_begin(&f, path, e);
    if (code) return code;
    outlines(f.stream, p->tree, s.levels, size / pixels);
    code = wf_file_commit(&f, e);
    return code ? code : plot_data(folder, p, &s, e);
}
