/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/modes.h"
#include "out/inputs.h"
#include <math.h>
#include <string.h>

enum {
    DRAWN = 5,
    ROWS_DRAWN = 5000
}; /* modes of a figure beside the sway of the tree; segments of a drawn tree */

static const char *leaves_word(const struct wf_mode_block *b)
{
    return b->water > 0 ? "leaf_wet" : b->season == WF_LEAF_ON ? "leaf_on" : "leaf_off";
}

static void number(FILE *f, double x) { isfinite(x) ? fprintf(f, ",%.6g", x) : fputc(',', f); }

static void mode_row(FILE *f, size_t run, const struct wf_mode_block *b, size_t k)
{
    const struct wf_sway_mode *m = &b->modes.mode[k];
    const double x[] = { m->frequency, m->mass,    m->share[0],   m->share[1], m->share[2],
                         m->turn[0],   m->turn[1], m->structural, m->air,      m->damping };
    fprintf(f, "%zu,%s,%.6g,%zu,%s", run, leaves_word(b), b->speed, k + 1, wf_mode_direction(m));
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) number(f, x[i]);
    fputc('\n', f);
}

/* The sway of the whole tree is in the row of mode 0. */
static void sway_row(FILE *f, size_t run, const struct wf_mode_block *b)
{
    const struct wf_sway *s = &b->modes.sway;
    fprintf(f, "%zu,%s,%.6g,0,tree", run, leaves_word(b), b->speed);
    number(f, s->frequency), number(f, s->mass);
    fputs(",,,", f);
    number(f, s->participation);
    fputs(",,", f);
    number(f, s->air), number(f, b->modes.damping);
    fputc('\n', f);
}

static void modes_table(FILE *f, const struct wf_mode_list *l)
{
    fputs("run,season,wind_m_s,mode,direction,frequency_Hz,modal_mass_kg,mass_share_along,mass_share_across,"
          "mass_share_up,overturning_along,overturning_across,damping_structural,damping_air,damping\n",
          f);
    for (size_t i = 0; i < l->blocks; i++) {
        if (l->block[i].modes.count) sway_row(f, i + 1, &l->block[i]);
        for (size_t k = 0; k < l->block[i].modes.count; k++) mode_row(f, i + 1, &l->block[i], k);
    }
}

/* Is the block the one whose shapes are drawn: the first of its season? */
static bool drawn(const struct wf_mode_list *l, size_t i)
{
    return l->block[i].modes.count && (i == 0 || l->block[i - 1].season != l->block[i].season ||
                                       l->block[i - 1].water != l->block[i].water);
}

/* Highest level of branches that is drawn. */
static int32_t top_level(const struct wf_tree *t)
{
    for (int32_t top = 0;; top++) {
        size_t up_to = 0, all = 0;
        for (size_t i = 0; i < t->n; i++) up_to += t->level[i] <= top + 1, all += t->level[i] <= top;
        if (up_to > ROWS_DRAWN || all == t->n) return top;
    }
}

/* Mode 0 is the sway of the whole tree: a segment's ends seen along the wind and from the left, and how they
 * move. */
static void shape_row(FILE *f, size_t run, size_t k, const struct wf_mode_block *b, size_t i)
{
    const struct wf_tree *t = &b->tree;
    const double *to = b->direction, still[3] = { 0 };
    const double *shape = k ? b->modes.mode[k - 1].shape : b->modes.shape;
    const double x[2][3] = { { t->x0[i], t->y0[i], t->z0[i] }, { t->x1[i], t->y1[i], t->z1[i] } };
    const double *u[2] = { t->parent[i] < 0 ? still : shape + 3 * t->parent[i], shape + 3 * i };
    fprintf(f, "%zu,%zu,%lld,%d", run, k, (long long)t->id[i], (int)t->level[i]);
    for (int end = 0; end < 2; end++) {
        const double *at = x[end], *by = u[end];
        fprintf(f, ",%.6g,%.6g,%.6g,%.4g,%.4g,%.4g", at[0] * to[0] + at[1] * to[1],
                at[1] * to[0] - at[0] * to[1], at[2], by[0] * to[0] + by[1] * to[1],
                by[1] * to[0] - by[0] * to[1], by[2]);
    }
    fputc('\n', f);
}

static void shapes_table(FILE *f, const struct wf_mode_list *l)
{
    fputs("run,mode,segment,level,along0_m,across0_m,z0_m,move_along0,move_across0,move_up0,along1_m,across1_"
          "m,z1_m,"
          "move_along1,move_across1,move_up1\n",
          f);
    for (size_t r = 0; r < l->blocks; r++) {
        const struct wf_mode_block *b = &l->block[r];
        if (!drawn(l, r)) continue;
        int32_t top = top_level(&b->tree);
        for (size_t k = 0; k <= b->modes.count && k <= DRAWN; k++)
            for (size_t i = 0; i < b->tree.n; i++)
                if (b->tree.level[i] <= top) shape_row(f, r + 1, k, b, i);
    }
}

static void plot_data(struct wf_plot_data *p, const struct wf_mode_list *l)
{
    char key[40];
    wf_plot_data_number(p, "HEIGHT", 0, l->height);
    for (size_t r = 0; r < l->blocks; r++) {
        const struct wf_mode_block *b = &l->block[r];
        if (!drawn(l, r)) continue;
        size_t n = b->modes.count < DRAWN ? b->modes.count : DRAWN;
        snprintf(key, sizeof key, "MODES_%zu", r + 1);
        wf_plot_data_count(p, key, 0, n);
        snprintf(key, sizeof key, "TREE_%zu", r + 1);
        wf_plot_data_print(p, key, 0, "%.3g", b->modes.sway.frequency);
        for (size_t k = 0; k < n; k++) {
            const struct wf_sway_mode *m = &b->modes.mode[k];
            snprintf(key, sizeof key, "FREQUENCY_%zu", r + 1);
            wf_plot_data_print(p, key, k + 1, "%.3g", m->frequency);
            snprintf(key, sizeof key, "DIRECTION_%zu", r + 1);
            wf_plot_data_words(p, key, k + 1, wf_mode_direction(m));
            snprintf(key, sizeof key, "ACROSS_%zu", r + 1);
            wf_plot_data_count(p, key, k + 1, m->share[1] > m->share[0]);
        }
    }
}

static json_t *mode_part(struct wf_doc *d, const struct wf_sway_mode *m, size_t k)
{
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "number", k + 1);
    wf_doc_text(d, o, "direction", wf_mode_direction(m));
    wf_doc_number(d, o, "frequency", m->frequency);
    wf_doc_number(d, o, "mass_kg", m->mass);
    wf_doc_number(d, o, "mass_along", m->share[0]);
    wf_doc_number(d, o, "mass_across", m->share[1]);
    wf_doc_number(d, o, "mass_up", m->share[2]);
    wf_doc_number(d, o, "turn_along", m->turn[0]);
    wf_doc_number(d, o, "turn_across", m->turn[1]);
    wf_doc_number(d, o, "structural", m->structural);
    wf_doc_number(d, o, "air", m->air);
    wf_doc_number(d, o, "damping", m->damping);
    return o;
}

json_t *wf_part_modes(struct wf_doc *d, const struct wf_sway_modes *m)
{
    json_t *list = wf_doc_array(d);
    for (size_t k = 0; k < m->count; k++) wf_doc_add(d, list, mode_part(d, &m->mode[k], k));
    return list;
}

static json_t *block_part(struct wf_doc *d, const struct wf_mode_list *l, size_t i)
{
    const struct wf_mode_block *b = &l->block[i];
    json_t *o = wf_doc_object(d);
    wf_doc_count(d, o, "run", i + 1);
    wf_doc_text(d, o, "season", leaves_word(b));
    if (b->water > 0) wf_doc_number(d, o, "film_mm", b->water);
    wf_doc_number(d, o, "speed", b->speed);
    wf_doc_text(d, o, "status", b->status ? wf_status_text(b->status) : "ok");
    wf_doc_flag(d, o, "damping_known", b->modes.damping_known);
    wf_doc_put(d, o, "modes", wf_part_modes(d, &b->modes));
    if (!b->modes.count) return o;
    const struct wf_sway *sway = &b->modes.sway;
    wf_doc_number(d, o, "tree_frequency", sway->frequency);
    wf_doc_number(d, o, "tree_share", sway->participation);
    wf_doc_number(d, o, "mass_kg", sway->mass);
    wf_doc_number(d, o, "air", sway->air);
    wf_doc_number(d, o, "damping", b->modes.damping);
    if (!(b->speed > 0.0)) wf_doc_number(d, o, "ratio_to_measured", sway->frequency / l->measured);
    return o;
}

static enum wf_status document(const struct wf_mode_list *l, const char *name, const struct wf_diag *findings,
                               const struct wf_doc_head *head, const char *folder, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    char figure[32];
    json_t *o = wf_doc_begin(&d, "windfirm-modes", head);
    wf_doc_text(&d, o, "name", name);
    wf_doc_text(&d, o, "name_zh", l->name_zh);
    wf_doc_put(&d, o, "scenario", wf_part_site(&d, l->scenario));
    json_t *line = wf_doc_put(&d, o, "measured", wf_doc_object(&d));
    wf_doc_flag(&d, line, "conifer", l->conifer);
    wf_doc_text(&d, line, "of", l->line->name);
    wf_doc_number(&d, line, "line_first_Hz", l->line->first);
    wf_doc_number(&d, line, "line_slope_Hz_m", l->line->slope);
    wf_doc_number(&d, line, "diameter_m", l->diameter);
    wf_doc_number(&d, line, "height", l->height);
    wf_doc_number(&d, line, "frequency", l->measured);
    wf_doc_text(&d, line, "source", wf_sway_lines_source);
    json_t *blocks = wf_doc_put(&d, o, "blocks", wf_doc_array(&d));
    for (size_t i = 0; i < l->blocks; i++) wf_doc_add(&d, blocks, block_part(&d, l, i));
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), findings);
    json_t *figures = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    for (size_t i = 0; i < l->blocks; i++) {
        snprintf(figure, sizeof figure, "modes_%zu", i + 1);
        if (drawn(l, i)) wf_doc_figure(&d, figures, figure, "modes", i + 1);
    }
    return wf_doc_end(&d, o, folder, e);
}

static enum wf_status table(const struct wf_mode_list *l, const char *folder, const char *name,
                            void (*write)(FILE *f, const struct wf_mode_list *l), struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_folder_begin(&f, folder, name, e);
    if (s) return s;
    write(f.stream, l);
    return wf_file_commit(&f, e);
}

enum wf_status wf_modes_write(const struct wf_mode_list *l, const char *name, const struct wf_diag *findings,
                              const struct wf_doc_head *head, const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_folder_make(folder, e);
    if (!s) s = table(l, folder, "tables/modes.csv", modes_table, e);
    if (!s) s = table(l, folder, "tables/mode_shapes.csv", shapes_table, e);
    if (!s) s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    plot_data(&p, l);
    s = wf_plot_data_end(&p, e);
    return s ? s : document(l, name, findings, head, folder, e);
}
