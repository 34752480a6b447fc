/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/tree_picture.h"
#include "base/file.h"
#include "base/num.h"
#include "data/species.h"
#include "out/doc.h"
#include "out/figures.h"
#include <math.h>
#include <stdarg.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static size_t level_of(const struct wf_tree *t, size_t i)
{
    size_t level = t->level[i] > 0 ? (size_t)t->level[i] : 0;
    return level < WF_SUMMARY_LEVELS ? level : WF_SUMMARY_LEVELS - 1;
}

static bool goes_on(const struct wf_tree *t, size_t i)
{
    return t->parent[i] >= 0 && t->level[t->parent[i]] == t->level[i];
}

static double wood(const struct wf_tree *t, size_t i)
{
    double outer = t->r0[i] * t->r0[i] + t->r0[i] * t->r1[i] + t->r1[i] * t->r1[i];
    double inner = t->i0[i] * t->i0[i] + t->i0[i] * t->i1[i] + t->i1[i] * t->i1[i];
    return M_PI / 3 * (outer - inner) * wf_tree_length(t, i);
}

static bool is_link(const uint8_t *kind, size_t i) { return kind && kind[i] == WF_SEGMENT_LINK; }

/* Length of every axis, kept at its first row of wood; first[i] is -1 for a link that leads to an axis. */
static void axis_lengths(const struct wf_tree *t, const uint8_t *kind, int32_t *first, double *length)
{
    for (size_t i = 0; i < t->n; i++) {
        first[i] = goes_on(t, i) ? first[t->parent[i]] : -1;
        if (is_link(kind, i)) continue;
        if (first[i] < 0) first[i] = (int32_t)i;
        length[first[i]] += wf_tree_length(t, i);
    }
}

static void stretch(struct wf_tree_summary *s, double x, double y, double z)
{
    const double p[3] = { x, y, z };
    for (int k = 0; k < 3; k++) {
        s->low[k] = fmin(s->low[k], p[k]);
        s->high[k] = fmax(s->high[k], p[k]);
    }
}

enum wf_status wf_tree_summarise(const struct wf_tree *t, const uint8_t *kind, struct wf_tree_summary *out,
                                 struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    int32_t *first = WF_TAKE(&scratch, t->n, int32_t);
    double *length = WF_TAKE(&scratch, t->n, double);
    *out = (struct wf_tree_summary){ .low = { INFINITY, INFINITY, INFINITY },
                                     .high = { -INFINITY, -INFINITY, -INFINITY },
                                     .height = wf_tree_height(t) };
    if (!first || !length) {
        wf_arena_free(&scratch);
        return wf_fail(e, WF_ENOMEM, "not enough memory for %zu segments", t->n);
    }
    axis_lengths(t, kind, first, length);
    for (size_t i = 0; i < t->n; i++) {
        struct wf_level_summary *l = &out->level[level_of(t, i)];
        if (level_of(t, i) + 1 > out->levels) out->levels = level_of(t, i) + 1;
        stretch(out, t->x0[i], t->y0[i], t->z0[i]);
        stretch(out, t->x1[i], t->y1[i], t->z1[i]);
        if (is_link(kind, i)) continue;
        l->segments++;
        out->wood_volume += wood(t, i);
        out->leaf_area += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
        if (first[i] != (int32_t)i) continue;
        l->length_least = l->axes ? fmin(l->length_least, length[i]) : length[i];
        l->length_most = fmax(l->length_most, length[i]);
        l->length_mean += length[i];
        l->diameter_mean += 2 * t->r0[i];
        l->axes++;
    }
    for (size_t k = 0; k < out->levels; k++) {
        struct wf_level_summary *l = &out->level[k];
        if (!l->axes) continue;
        l->length_mean /= (double)l->axes;
        l->diameter_mean /= (double)l->axes;
    }
    wf_arena_free(&scratch);
    return WF_OK;
}

double wf_tree_wear_mass(const struct wf_qsm_metrics *g, const struct wf_tree_wear *w)
{
    double mass = 0;
    for (size_t k = 0; k < WF_QSM_ORDERS; k++) {
        double density = w->density;
        if (isnan(density) && w->species && w->species->levels) {
            size_t level = k < w->species->levels ? k : w->species->levels - 1;
            density = w->species->level[level].density.value;
        }
        mass += density * g->order_volume[k];
    }
    return mass;
}

double wf_tree_wear_sail(const struct wf_tree_wear *w)
{
    return w->species ? w->leaf_area * w->species->crown.frontal_share.value : (double)NAN;
}

void wf_tree_table_head(FILE *to)
{
    fprintf(
        to,
        "file,format,cylinders,branches,tips,stems,highest_order,height_m,dbh_m,base_diameter_m,width_x_m,"
        "width_y_m,"
        "crown_base_m,length_m,volume_m3,mass_kg,area_m2,leaf_area_m2,sail_0_m2,sail_45_m2,sail_90_m2,"
        "sail_135_m2,leaf_sail_m2,segments,model_volume_m3,links,bridges,bridge_volume_m3,gaps,widest_gap_m");
    for (int k = 0; k < WF_REPAIR_COUNT; k++) fprintf(to, ",%s", wf_repair_rows[k].code);
    fputc('\n', to);
}

/* A number cell; empty when unknown. */
static void cell(FILE *to, double v)
{
    if (isnan(v))
        fputc(',', to);
    else
        fprintf(to, ",%.8g", v);
}

void wf_tree_table_line(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w)
{
    struct wf_qsm_metrics g;
    wf_qsm_measure(q, &g);
    fputc('"', to);
    for (const char *p = path; *p; p++) fprintf(to, "%s%c", *p == '"' ? "\"" : "", *p);
    fprintf(to, "\",%s,%zu,%zu,%zu,%zu,%d", q->format, g.cylinders, g.branches, g.tips, g.stems,
            g.highest_order);
    const double v[] = { g.height, g.dbh,    g.base_diameter,          g.width_x, g.width_y,   g.crown_base,
                         g.length, g.volume, wf_tree_wear_mass(&g, w), g.area,    w->leaf_area };
    for (size_t k = 0; k < sizeof v / sizeof *v; k++) cell(to, v[k]);
    for (int deg = 0; deg < 180; deg += 45) cell(to, wf_qsm_sail(q, deg * M_PI / 180));
    cell(to, wf_tree_wear_sail(w));
    fprintf(to, ",%zu,%.8g,%zu,%zu,%.8g,%zu,%.6g", m->tree.n, m->volume, m->links, m->bridges,
            m->bridge_volume, m->gaps, m->widest_gap);
    for (int k = 0; k < WF_REPAIR_COUNT; k++) fprintf(to, ",%zu", q->repairs.count[k]);
    fputc('\n', to);
}

static const char *const parts[] = { "plots/tree.dat", "plots/tree.csv" };

void wf_tree_picture_remove(const char *folder)
{
    char path[WF_PATH_MAX];
    for (size_t k = 0; k < sizeof parts / sizeof *parts; k++)
        if (!wf_folder_path(folder, parts[k], path, NULL)) (void)unlink(path);
}

bool wf_tree_picture_there(const char *folder)
{
    char path[WF_PATH_MAX];
    return !wf_folder_path(folder, "plots/tree.csv", path, NULL) && !access(path, R_OK);
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
    if (length < a) { /* seen end on: a square, which at a line's width looks like the disc */
        fprintf(f, "%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n\n", x0 - a, z0 - a, x0 + a,
                z0 - a, x0 + a, z0 + a, x0 - a, z0 + a, x0 - a, z0 - a);
        return;
    }
    fprintf(f, "%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n%.5g %.5g\n\n", x0 + a * nx, z0 + a * nz,
            x1 + b * nx, z1 + b * nz, x1 - b * nx, z1 - b * nz, x0 - a * nx, z0 - a * nz, x0 + a * nx,
            z0 + a * nz);
}

/* Blocks by level, view and thickness, in the order the script counts them; every block begins with an empty
 * outline at the base, so that one without segments still counts as a block. */
static void outlines(FILE *f, const struct wf_tree *t, const uint8_t *kinds, size_t levels, double thin)
{
    for (size_t l = 0; l < levels; l++)
        for (int kind = 0; kind < 4; kind++) {
            bool side = kind >= 2, thick = kind % 2 == 0;
            double x = side ? t->y0[0] : t->x0[0];
            for (int corner = 0; corner < (thick ? 5 : 2); corner++) fprintf(f, "%.5g %.5g\n", x, t->z0[0]);
            fputc('\n', f);
            for (size_t i = 0; i < t->n; i++) {
                if (is_link(kinds, i)) continue;
                size_t level = t->level[i] > 0 ? (size_t)t->level[i] : 0;
                if (level >= levels) level = levels - 1;
                if (level == l && (fmax(t->r0[i], t->r1[i]) > 0.5 * thin) == thick)
                    outline(f, t, i, side, thick);
            }
            fputc('\n', f);
        }
}

/* Rows of the table beside the picture: a name, whose label is in the figure's list of words, and a value. */
struct side_table {
    struct wf_plot_data *p;
    size_t rows;
};

/* Width of the character that begins with this byte, in halves of a small letter's. */
static size_t letter_width(char first)
{
    unsigned char c = (unsigned char)first;
    if (c >= 0xE1 || strchr("mMW@%", first)) return 4; /* from 0xE1 on: Chinese and other wide scripts */
    return (c >= 'A' && c <= 'Z') || c == 'w' ? 3 : 2;
}

/* Length of the start of a UTF-8 text that is at most as wide as `letters` small letters. */
static size_t bytes_that_fit(const char *text, size_t letters)
{
    size_t n = 0, wide = 0;
    while (text[n]) {
        size_t size = 1;
        while (((unsigned char)text[n + size] & 0xC0) == 0x80) size++;
        if ((wide += letter_width(text[n])) > 2 * letters) break;
        n += size;
    }
    return n;
}

/* A name over as many rows of the table as it needs, broken behind a blank or a sign where there is one. */
static void entry_name(struct side_table *t, const char *name, const char *value)
{
    enum { LETTERS = 24, LONGEST = 4 * LETTERS + 1 };
    char part[LONGEST];
    if (!value) value = "";
    do {
        size_t n = bytes_that_fit(value, LETTERS), end = n;
        while (value[n] && end > n / 2 && !strchr(" _-.,/", value[end - 1])) end--;
        if (value[n] && end > n / 2) n = end;
        (void)snprintf(part, sizeof part, "%.*s", (int)n, value);
        wf_plot_data_text(t->p, "P_NAME", ++t->rows, name);
        wf_plot_data_text(t->p, "P_VALUE", t->rows, part);
        name = "", value += n;
    } while (*value);
}

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

/* The same with a value that is a word, which also has a label. */
static void entry_word(struct side_table *t, const char *name, const char *word)
{
    wf_plot_data_text(t->p, "P_NAME", ++t->rows, name);
    wf_plot_data_text(t->p, "P_WORD", t->rows, word);
}

static void parameters(struct side_table *t, const struct wf_tree_picture *p, const struct wf_tree_summary *s)
{
    const struct wf_model *m = p->model;
    entry_name(t, "model", m->key);
    if (!p->unspecified) entry_name(t, "species", p->species->name);
    if (p->unspecified && isnan(m->radius)) {
        char text[256];
        (void)snprintf(text, sizeof text, "none; stem as thick as %s", p->species->name);
        entry_name(t, "species", text);
    }
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

enum { LEVEL_LETTERS = 19 }; /* room for a level's name beside its numbers */

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
        const char *name = wf_model_level_name(p->model, p->species, (int32_t)l);
        size_t fits = bytes_that_fit(name, LEVEL_LETTERS);
        bool whole = !name[fits];
        if (!whole) fits = bytes_that_fit(name, LEVEL_LETTERS - 1);
        wf_plot_data_print(&to, "LEVEL", l + 1, "%.*s%s", (int)fits, name, whole ? "" : "…");
        level_row(&to, &s->level[l], l + 1);
    }
    parameters(&t, p, s);
    wf_plot_data_count(&to, "P_ROWS", 0, t.rows);
    return wf_plot_data_end(&to, e);
}

/* Kinds of the rows; of a tree whose rows were cut at cavities, none: links are then drawn as wood. */
static const uint8_t *kinds_of(const struct wf_tree_picture *p)
{
    const struct wf_model *m = p->model;
    return m->measured && m->measured->n == p->tree->n ? m->measured_kind : NULL;
}

enum wf_status wf_tree_picture_write(const struct wf_tree_picture *p, const char *folder, struct wf_err *e)
{
    const double pixels = 420; /* height of a view; segments thinner than one pixel become lines */
    char path[WF_PATH_MAX];
    struct wf_tree_summary s;
    enum wf_status code = wf_tree_summarise(p->tree, kinds_of(p), &s, e);
    if (code) return code;
    double size = fmax(s.high[2] - s.low[2], fmax(s.high[0] - s.low[0], s.high[1] - s.low[1]));
    struct wf_file f = { 0 };
    if (!code) code = wf_folder_path(folder, "plots/tree.dat", path, e);
    if (!code) code = wf_file_begin(&f, path, e);
    if (code) return code;
    outlines(f.stream, p->tree, kinds_of(p), s.levels, size / pixels);
    code = wf_file_commit(&f, e);
    return code ? code : plot_data(folder, p, &s, e);
}

static const struct wf_figure tree_figure = { "tree", "tree", 0 };

/* The bytes of a finished picture; one that is cut short is refused. */
static enum wf_status read_picture(const char *picture, struct wf_arena *a, struct wf_bytes *out,
                                   struct wf_err *e)
{
    enum wf_status s = wf_file_read(picture, a, out, e);
    if (s) return s;
    static const char png[] = "IEND";
    const char *tail = strstr(picture, ".png") ? png : strstr(picture, ".pdf") ? "%%EOF" : "</svg>";
    size_t n = strlen(tail), from = out->size > 64 ? out->size - 64 : 0;
    for (size_t i = from; i + n <= out->size; i++)
        if (!memcmp(out->data + i, tail, n)) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%s: the picture is not complete (is the disk full?)", picture);
}

static enum wf_status write_picture(const char *path, const struct wf_bytes *b, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_file_begin(&f, path, e);
    if (s) return s;
    if (fwrite(b->data, 1, b->size, f.stream) != b->size)
        s = wf_fail(e, WF_EOUTPUT, "%s: cannot be written", path);
    else
        s = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return s;
}

static const char *ending(const char *path)
{
    static const char *const known[] = { ".svg", ".png", ".pdf" };
    size_t n = strlen(path);
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (n > 4 && !strcmp(path + n - 4, known[k])) return known[k];
    return NULL;
}

/* Draw the picture in a temporary folder, which the caller removes. */
static enum wf_status draw_in(const struct wf_tree_picture *p, const char *folder, const char *path,
                              struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    char picture[WF_PATH_MAX], name[16], plots[WF_PATH_MAX];
    struct wf_bytes bytes;
    snprintf(name, sizeof name, "picture%s", ending(path));
    enum wf_status s = wf_folder_path(folder, "plots", plots, e);
    if (!s) s = wf_mkdirs(plots, e);
    if (!s) s = wf_tree_picture_write(p, folder, e);
    if (!s) s = wf_folder_path(folder, name, picture, e);
    if (!s) s = wf_figures_run(folder, &tree_figure, name, "en", d, e);
    if (!s) s = read_picture(picture, a, &bytes, e);
    if (!s) s = write_picture(path, &bytes, e);
    (void)unlink(picture);
    wf_tree_picture_remove(folder);
    if (!wf_folder_path(folder, "plots", plots, NULL)) (void)rmdir(plots);
    return s;
}

enum wf_status wf_tree_picture_draw(const struct wf_tree_picture *p, const char *path, struct wf_diag *d,
                                    struct wf_err *e)
{
    const char *base = getenv("TMPDIR");
    char folder[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    if (!ending(path)) return wf_fail(e, WF_EUSAGE, "%s: a picture ends in .svg, .png or .pdf", path);
    int n = snprintf(folder, sizeof folder, "%s/windfirm-XXXXXX", base && *base ? base : "/tmp");
    if (n < 0 || (size_t)n >= sizeof folder || !mkdtemp(folder))
        return wf_fail(e, WF_EOUTPUT, "%s: no temporary folder can be made there", base ? base : "/tmp");
    enum wf_status s = draw_in(p, folder, path, &a, d, e);
    (void)rmdir(folder);
    wf_arena_free(&a);
    return s;
}

static char *base64(const struct wf_bytes *b, struct wf_arena *a)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const char lead[] = "data:image/png;base64,";
    size_t n = 0;
    char *out = WF_TAKE(a, sizeof lead + (b->size + 2) / 3 * 4, char);
    if (!out) return NULL;
    memcpy(out, lead, sizeof lead - 1);
    n = sizeof lead - 1;
    for (size_t i = 0; i < b->size; i += 3) {
        uint32_t v = 0;
        for (size_t k = 0; k < 3; k++) v = v << 8 | (i + k < b->size ? (unsigned char)b->data[i + k] : 0);
        for (size_t k = 0; k < 4; k++) out[n++] = i + k <= b->size ? digit[v >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

/* Width and height of a PNG, big-endian behind its signature. */
static unsigned png_number(const struct wf_bytes *b, size_t at)
{
    unsigned v = 0;
    for (size_t k = 0; k < 4; k++) v = v << 8 | (unsigned char)b->data[at + k];
    return v;
}

/* An SVG that holds the points of a PNG. */
static enum wf_status wrap_picture(const struct wf_bytes *png, xmlDoc **svg, struct wf_arena *a,
                                   struct wf_err *e)
{
    char size[64];
    char *data = base64(png, a);
    *svg = xmlNewDoc(BAD_CAST "1.0");
    xmlNode *root = *svg ? xmlNewDocNode(*svg, NULL, BAD_CAST "svg", NULL) : NULL;
    if (root) xmlDocSetRootElement(*svg, root);
    xmlNs *ns = root ? xmlNewNs(root, BAD_CAST "http://www.w3.org/2000/svg", NULL) : NULL;
    xmlNode *image = ns ? xmlNewChild(root, ns, BAD_CAST "image", NULL) : NULL;
    if (!data || !image) return wf_fail(e, WF_ENOMEM, "no memory for a picture");
    xmlSetNs(root, ns);
    snprintf(size, sizeof size, "0 0 %u %u", png_number(png, 16), png_number(png, 20));
    xmlNewProp(root, BAD_CAST "viewBox", BAD_CAST size);
    snprintf(size, sizeof size, "%u", png_number(png, 16));
    xmlNewProp(image, BAD_CAST "width", BAD_CAST size);
    snprintf(size, sizeof size, "%u", png_number(png, 20));
    xmlNewProp(image, BAD_CAST "height", BAD_CAST size);
    xmlNewProp(image, BAD_CAST "href", BAD_CAST data);
    return WF_OK;
}

bool wf_tree_picture_lines(const char *folder)
{
    char path[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    struct wf_bytes b;
    const char *at = NULL;
    if (!wf_folder_path(folder, "plots/tree.csv", path, NULL) && !wf_file_read_text(path, &a, &b, NULL))
        at = strstr(b.data, "\nSEGMENTS,0,");
    size_t segments = at ? strtoul(at + strlen("\nSEGMENTS,0,"), NULL, 10) : 0;
    wf_arena_free(&a);
    return segments <= WF_PICTURE_LINES_MAX;
}

enum wf_status wf_tree_picture_report(const char *folder, const char *language, xmlDoc **svg,
                                      struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_bytes png;
    static const char drawn[] = "plots/tree.part.png";
    char path[WF_PATH_MAX], part[WF_PATH_MAX];
    enum wf_status s;
    *svg = NULL;
    s = wf_folder_path(folder, "plots/tree.png", path, e);
    if (!s) s = wf_folder_path(folder, drawn, part, e);
    if (!s) s = wf_figures_run(folder, &tree_figure, drawn, language, d, e);
    if (!s) s = read_picture(part, &a, &png, e);
    if (!s) s = write_picture(path, &png, e);
    (void)unlink(part);
    if (!s) s = wrap_picture(&png, svg, &a, e);
    if (s && *svg) xmlFreeDoc(*svg), *svg = NULL;
    wf_arena_free(&a);
    return s;
}
