/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/shelter_results.h"
#include "out/doc.h"
#include "out/inputs.h"
#include <math.h>

enum { MAP = 64, CUT_LONG = 160, CUT_WIDE = 100 };

/* Row at the base of the branch that ends in a tip: the lowest row of the tip's own level. */
static size_t branch_base(const struct wf_tree *t, size_t row)
{
    while (t->parent[row] >= 0 && t->level[t->parent[row]] == t->level[row]) row = (size_t)t->parent[row];
    return row;
}

static double speed_at(const struct wf_wind *w, const struct wf_tree *t, const struct wf_response *r,
                       size_t i)
{
    const double x[3] = { t->x1[i] + r->end[3 * i], t->y1[i] + r->end[3 * i + 1],
                          t->z1[i] + r->end[3 * i + 2] };
    double u[3], du[9];
    w->sample(w, x, u, du);
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

static double size3(double x, double y, double z) { return sqrt(x * x + y * y + z * z); }

/* Displacement of a branch's end relative to the branch's base, including what the rotation of the base
 * causes. */
static double swing(const struct wf_tree *t, const struct wf_response *r, size_t row)
{
    int32_t from = t->parent[branch_base(t, row)];
    const double *end = &r->end[3 * row], *base = from >= 0 ? &r->end[3 * (size_t)from] : NULL;
    return base ? size3(end[0] - base[0], end[1] - base[1], end[2] - base[2]) : size3(end[0], end[1], end[2]);
}

enum wf_status wf_shelter_tips(struct wf_shelter_run *r, const struct wf_loads *open, struct wf_arena *a,
                               struct wf_err *e)
{
    const struct wf_tree *t = r->tree;
    const double *to = r->still.axis[0];
    bool *carries = WF_TAKE(a, t->n, bool);
    r->tip = WF_TAKE(a, t->n, struct wf_tip);
    if (!carries || !r->tip) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu tips", t->n);
    for (size_t i = 0; i < t->n; i++)
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
    for (size_t i = 0; i < t->n; i++) {
        if (carries[i]) continue;
        double place = to[0] * t->x1[i] + to[1] * t->y1[i] + to[2] * t->z1[i];
        struct wf_tip *p = &r->tip[r->tips++];
        *p = (struct wf_tip){ .row = i,
                              .along =
                                  (place - r->still.low[0]) / (r->still.step[0] * (double)r->still.slabs) };
        const struct wf_response *both[2] = { &r->open, &r->own };
        const struct wf_wind *wind[2] = { open->wind, &r->sheltered->wind };
        for (int k = 0; k < 2; k++) {
            const double *end = &both[k]->end[3 * i];
            p->wind[k] = speed_at(wind[k], t, both[k], i);
            p->move[k] = size3(end[0], end[1], end[2]);
            p->swing[k] = swing(t, both[k], i);
        }
    }
    return WF_OK;
}

static void slabs(FILE *f, const struct wf_shelter_run *r)
{
    const struct wf_shelter *s = &r->still;
    fputs("slab,front_m,wood_m2,leaf_m2,covered_m2,cylinder,hole,slit,transmitting,full,arriving_ratio,"
          "flux_ratio\n",
          f);
    for (size_t k = 0; k <= s->slabs; k++) {
        const struct wf_shelter_slab *b = &s->slab[k];
        fprintf(f, "%zu,%.6g,%.7g,%.7g,%.7g,%zu,%zu,%zu,%zu,%zu,%.7g,%.7g\n", k + 1, (double)k * s->step[0],
                b->wood, b->leaf, b->covered, b->cells[WF_CELL_CYLINDER], b->cells[WF_CELL_HOLE],
                b->cells[WF_CELL_SLIT], b->cells[WF_CELL_TRANSMITTING], b->full, b->speed, b->flux);
    }
}

/* Coverage and class of a block of cells: the mean, and the most frequent class other than none, if there is
 * one. */
static double block(const struct wf_shelter *s, size_t slab, const size_t from[2], const size_t to[2],
                    enum wf_cell_class *class)
{
    size_t count[WF_CELL_CLASSES] = { 0 }, n = 0;
    double sum = 0.0;
    for (size_t k = from[1]; k < to[1]; k++)
        for (size_t i = from[0]; i < to[0]; i++, n++) {
            size_t cell = (slab * s->up + k) * s->across + i;
            sum += wf_shelter_coverage(s, cell);
            count[s->class[cell]]++;
        }
    *class = WF_CELL_NONE;
    for (int c = 1; c < WF_CELL_CLASSES; c++)
        if (count[c] && (*class == WF_CELL_NONE || count[c] > count[*class])) *class = (enum wf_cell_class)c;
    return n ? sum / (double)n : 0.0;
}

/* Coverage and class on at most MAP x MAP places of every slab. */
static void cells(FILE *f, const struct wf_shelter_run *r)
{
    const struct wf_shelter *s = &r->still;
    size_t n = s->across < MAP ? s->across : MAP;
    fputs("slab,across_m,up_m,coverage,class\n", f);
    for (size_t p = 0; p < s->slabs; p++) {
        if (p) fputs("\n\n", f); /* blocks of gnuplot's `index` */
        for (size_t k = 0; k < n; k++)
            for (size_t i = 0; i < n; i++) {
                const size_t from[2] = { i * s->across / n, k * s->up / n },
                             to[2] = { (i + 1) * s->across / n, (k + 1) * s->up / n };
                enum wf_cell_class class;
                double coverage = block(s, p, from, to, &class);
                fprintf(f, "%zu,%.5g,%.5g,%.4g,%d\n", p + 1,
                        s->low[1] + ((double)i + 0.5) * s->step[1] * (double)s->across / (double)n,
                        s->low[2] + ((double)k + 0.5) * s->step[2] * (double)s->up / (double)n, coverage,
                        (int)class);
            }
    }
}

/* Speed over the undisturbed speed on a cut along the wind: level (`up` given) or upright (`across` given).
 */
static void cut(FILE *f, const struct wf_shelter *s, int axis, double fixed)
{
    double depth = s->step[0] * (double)s->slabs, from = s->low[0] - 0.15 * depth, length = 2.1 * depth;
    double low = s->low[axis], wide = s->step[axis] * (double)(axis == 1 ? s->across : s->up);
    fputs(axis == 1 ? "along_m,across_m,ratio\n" : "along_m,up_m,ratio\n", f);
    for (int k = 0; k < CUT_WIDE; k++)
        for (int i = 0; i < CUT_LONG; i++) {
            double local[3], x[3] = { 0 }, ratio[3], slope[9];
            local[0] = from + length * ((double)i + 0.5) / CUT_LONG;
            local[axis] = low + wide * ((double)k + 0.5) / CUT_WIDE;
            local[3 - axis] = fixed;
            for (int j = 0; j < 3; j++)
                for (int d = 0; d < 3; d++) x[d] += s->axis[j][d] * local[j];
            wf_shelter_ratio(s, x, ratio, slope);
            fprintf(f, "%.5g,%.5g,%.5g\n", local[0], local[axis],
                    sqrt(ratio[0] * ratio[0] + ratio[1] * ratio[1] + ratio[2] * ratio[2]));
        }
}

/* Height of the centre of what is covered, and its place across [m]. */
static void middle(const struct wf_shelter *s, double out[2])
{
    double sum = 0.0;
    out[0] = out[1] = 0.0;
    for (size_t c = 0; c < s->slabs * s->up * s->across; c++) {
        double w = wf_shelter_coverage(s, c);
        sum += w;
        out[0] += w * (s->low[1] + ((double)(c % s->across) + 0.5) * s->step[1]);
        out[1] += w * (s->low[2] + ((double)(c / s->across % s->up) + 0.5) * s->step[2]);
    }
    for (int k = 0; k < 2; k++) out[k] = sum > 0.0 ? out[k] / sum : s->low[k + 1];
}

static void cut_level(FILE *f, const struct wf_shelter_run *r)
{
    double at[2];
    middle(&r->still, at);
    cut(f, &r->still, 1, at[1]);
}

static void cut_upright(FILE *f, const struct wf_shelter_run *r)
{
    double at[2];
    middle(&r->still, at);
    cut(f, &r->still, 2, at[0]);
}

/* Ends of the rows seen from the side: along the wind and up, at rest, in the open, sheltered. */
static void rows(FILE *f, const struct wf_shelter_run *r)
{
    const struct wf_tree *t = r->tree;
    const double *to = r->still.axis[0];
    static const double none[3] = { 0 };
    fputs("row,along0_m,up0_m,along1_m,up1_m,open0_m,open_up0_m,open1_m,open_up1_m,own0_m,own_up0_m,own1_m,"
          "own_up1_m,radius_m\n",
          f);
    for (size_t i = 0; i < t->n && r->moved; i++) {
        const double a[3] = { t->x0[i], t->y0[i], t->z0[i] }, b[3] = { t->x1[i], t->y1[i], t->z1[i] };
        int32_t p = t->parent[i];
        fprintf(f, "%lld", (long long)t->id[i]);
        for (int state = 0; state < 3; state++)
            for (int end = 0; end < 2; end++) {
                const double *all = state == 1 ? r->open.end : r->own.end, *x = end ? b : a;
                const double *move = state == 0 ? none
                                     : end      ? &all[3 * i]
                                     : p < 0    ? none
                                                : &all[3 * (size_t)p];
                double along = 0.0;
                for (int k = 0; k < 3; k++) along += to[k] * (x[k] + move[k]);
                fprintf(f, ",%.5g,%.5g", along, x[2] + move[2]);
            }
        fprintf(f, ",%.5g\n", t->r0[i]);
    }
}

static void tips(FILE *f, const struct wf_shelter_run *r)
{
    fputs("row,depth_share,wind_open_ms,wind_own_ms,move_open_m,move_own_m,swing_open_m,swing_own_m\n", f);
    for (size_t i = 0; i < r->tips; i++) {
        const struct wf_tip *p = &r->tip[i];
        fprintf(f, "%lld,%.5g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g\n", (long long)r->tree->id[p->row], p->along,
                p->wind[0], p->wind[1], p->move[0], p->move[1], p->swing[0], p->swing[1]);
    }
}

static void plot_data(struct wf_plot_data *p, const struct wf_shelter_run *r)
{
    const struct wf_shelter *s = &r->still;
    double at[2];
    middle(s, at);
    const struct {
        const char *key;
        double x;
    } number[] = { { "SPEED", r->speed },
                   { "SLABS", (double)s->slabs },
                   { "CELLS", (double)s->across },
                   { "FRONT", s->low[0] },
                   { "DEPTH", s->step[0] * (double)s->slabs },
                   { "LEFT", s->low[1] },
                   { "WIDE", s->step[1] * (double)s->across },
                   { "BOTTOM", s->low[2] },
                   { "TALL", s->step[2] * (double)s->up },
                   { "CUT_UP", at[1] },
                   { "CUT_ACROSS", at[0] },
                   { "MOVED", (double)r->moved } };
    wf_plot_data_text(p, "LAW", 0, s->request.law->name);
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        wf_plot_data_number(p, number[i].key, 0, number[i].x);
}

size_t wf_shelter_thirds(const struct wf_shelter_run *r, struct wf_shelter_third third[3])
{
    size_t used = 0;
    for (int k = 0; k < 3; k++) third[k] = (struct wf_shelter_third){ 0 };
    for (size_t i = 0; i < r->tips; i++) {
        const struct wf_tip *p = &r->tip[i];
        struct wf_shelter_third *h = &third[(int)fmin(fmax(3.0 * p->along, 0.0), 2.0)];
        h->n++;
        for (int k = 0; k < 2; k++)
            h->wind[k] += p->wind[k], h->move[k] += p->move[k], h->swing[k] += p->swing[k];
    }
    for (int i = 0; i < 3; i++) {
        used += third[i].n > 0;
        for (int k = 0; k < 2; k++) {
            double n = (double)third[i].n;
            third[i].wind[k] /= n, third[i].move[k] /= n, third[i].swing[k] /= n;
        }
    }
    return used;
}

static json_t *slab_part(struct wf_doc *d, const struct wf_shelter *s, size_t k)
{
    const struct wf_shelter_slab *b = &s->slab[k];
    json_t *o = wf_doc_object(d);
    const struct {
        const char *key;
        double x;
    } x[] = {
        { "front_m", (double)k * s->step[0] }, { "wood_m2", b->wood },         { "leaf_m2", b->leaf },
        { "covered_m2", b->covered },          { "arriving_ratio", b->speed }, { "flux_ratio", b->flux }
    };
    for (size_t i = 0; i < sizeof x / sizeof *x; i++) wf_doc_number(d, o, x[i].key, x[i].x);
    wf_doc_count(d, o, "cylinder", b->cells[WF_CELL_CYLINDER]);
    wf_doc_count(d, o, "hole", b->cells[WF_CELL_HOLE]);
    wf_doc_count(d, o, "slit", b->cells[WF_CELL_SLIT]);
    wf_doc_count(d, o, "transmitting", b->cells[WF_CELL_TRANSMITTING]);
    wf_doc_count(d, o, "full", b->full);
    return o;
}

static json_t *moved_part(struct wf_doc *d, const struct wf_shelter_run *r)
{
    struct wf_shelter_third third[3];
    json_t *o = wf_doc_object(d), *list = wf_doc_put(d, o, "thirds", wf_doc_array(d));
    wf_shelter_thirds(r, third);
    for (int k = 0; k < 3; k++) {
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "number", third[k].n);
        wf_doc_numbers(d, q, "wind_m_s", third[k].wind, 2);
        wf_doc_numbers(d, q, "move_m", third[k].move, 2);
        wf_doc_numbers(d, q, "swing_m", third[k].swing, 2);
    }
    wf_doc_number(d, o, "base_moment_open_N_m", hypot(r->open.base_moment[0], r->open.base_moment[1]));
    wf_doc_number(d, o, "base_moment_own_N_m", hypot(r->own.base_moment[0], r->own.base_moment[1]));
    wf_doc_count(d, o, "passes", r->sheltered->passes);
    return o;
}

static void law_part(struct wf_doc *d, json_t *o, const struct wf_shelter_request *q)
{
    json_t *law = wf_doc_put(d, o, "law", wf_doc_object(d));
    wf_doc_text(d, law, "name", q->law->name), wf_doc_text(d, law, "title", q->law->title);
    wf_doc_text(d, law, "source", q->law->source), wf_doc_text(d, law, "validity", q->law->validity);
    wf_doc_number(d, o, "transmission", q->transmission);
    wf_doc_flag(d, o, "energy", q->energy);
    wf_doc_number(d, o, "speed_share", wf_shelter_speed_share(q));
}

static enum wf_status document(const struct wf_shelter_run *r, const struct wf_doc_head *head,
                               const struct wf_diag *diag, struct wf_err *e)
{
    const struct wf_shelter *s = &r->still;
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-shelter", head);
    wf_doc_text(&d, o, "species", r->species), wf_doc_text(&d, o, "tree", r->tree_name);
    wf_doc_count(&d, o, "segments", r->tree->n);
    wf_doc_number(&d, o, "speed_m_s", r->speed);
    wf_doc_number(&d, o, "reference_height_m", s->base.reference_height);
    wf_doc_put(&d, o, "scenario", wf_part_site(&d, r->scenario));
    law_part(&d, o, &s->request);
    wf_doc_numbers(&d, o, "step_m", s->step, 3);
    wf_doc_count(&d, o, "across", s->across), wf_doc_count(&d, o, "up", s->up);
    json_t *list = wf_doc_put(&d, o, "slabs", wf_doc_array(&d));
    for (size_t k = 0; k <= s->slabs; k++) wf_doc_add(&d, list, slab_part(&d, s, k));
    if (r->moved) wf_doc_put(&d, o, "moved", moved_part(&d, r));
    wf_doc_warnings(&d, wf_doc_put(&d, o, "warnings", wf_doc_array(&d)), diag);
    list = wf_doc_put(&d, o, "figures", wf_doc_array(&d));
    wf_doc_figure(&d, list, "shelter_wind", "shelter_wind", 0);
    wf_doc_figure(&d, list, "shelter_slabs", "shelter_slabs", 0);
    if (r->moved) wf_doc_figure(&d, list, "shelter_motion", "shelter_motion", 0);
    return wf_doc_end(&d, o, r->folder, e);
}

enum wf_status wf_shelter_results_write(const struct wf_shelter_run *r, const struct wf_doc_head *head,
                                        const struct wf_diag *diag, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(FILE *f, const struct wf_shelter_run *r);
    } table[] = { { "tables/slabs.csv", slabs },         { "tables/cells.csv", cells },
                  { "tables/cut_level.csv", cut_level }, { "tables/cut_upright.csv", cut_upright },
                  { "tables/rows.csv", rows },           { "tables/tips.csv", tips } };
    enum wf_status status = wf_folder_make(r->folder, e);
    for (size_t i = 0; i < sizeof table / sizeof table[0] && !status; i++) {
        struct wf_file f = { 0 };
        status = wf_folder_begin(&f, r->folder, table[i].name, e);
        if (status) break;
        table[i].write(f.stream, r);
        status = wf_file_commit(&f, e);
    }
    struct wf_plot_data p;
    if (!status) status = wf_plot_data_begin(&p, r->folder, "run", e);
    if (status) return status;
    plot_data(&p, r);
    status = wf_plot_data_end(&p, e);
    return status ? status : document(r, head, diag, e);
}
