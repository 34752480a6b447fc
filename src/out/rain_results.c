/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/rain_results.h"
#include "base/num.h"
#include "data/species.h"
#include "load/drop_shape.h"
#include <math.h>
#include <string.h>

static double degrees(double angle) { return angle * 180 / WF_PI; }

/* ---- Tables ---- */

static void series(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,time_s,air,rest,run_drops,hang,held_mg,film_mg,fell_mg,ground_mg,tip_along_mm,tip_across_mm,"
          "tip_up_mm,"
          "branch_up_mm,twist_deg,petiole_force_mN,petiole_moment_mNm,branch_moment_mNm,energy_mJ,wetted\n",
          f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t i = 0; i < p->run[r].of->rows; i++) {
            const struct wf_rain_row *w = &p->run[r].of->row[i];
            fprintf(f,
                    "%zu,%.6g,%zu,%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%.6g,%."
                    "7g,%.5g\n",
                    r + 1, w->time, w->air, w->state[WF_DROP_REST], w->state[WF_DROP_RUN],
                    w->state[WF_DROP_HANG], 1e6 * w->held, 1e6 * w->film, 1e6 * w->fell, 1e6 * w->ground,
                    1e3 * w->tip[0], 1e3 * w->tip[1], 1e3 * w->tip[2], 1e3 * w->branch_tip[2],
                    degrees(w->twist), 1e3 * w->petiole_force, 1e3 * w->petiole_moment,
                    1e3 * w->branch_moment, 1e3 * w->energy, w->wetted);
        }
}

static void keys(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,key,event,time_s,leaf,drops\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].of->keys; k++) {
            const struct wf_rain_key *q = &p->run[r].of->key[k];
            fprintf(f, "%zu,%zu,%s,%.6g,%zu,%zu\n", r + 1, k + 1, q->event, q->time, q->leaf + 1,
                    q->water->drops);
        }
}

static void line(FILE *f, size_t run, size_t key, size_t part, const char *kind, const double *place,
                 size_t a, size_t b)
{
    fprintf(f, "%zu,%zu,%zu,%s", run, key, part, kind);
    for (int c = 0; c < 3; c++) fprintf(f, ",%.6g", place[3 * a + (size_t)c]);
    for (int c = 0; c < 3; c++) fprintf(f, ",%.6g", place[3 * b + (size_t)c]);
    fputc('\n', f);
}

/* Outlines and veins of the blades, axes of the wood, in every key frame. */
static void scene(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,key,part,kind,x0_m,y0_m,z0_m,x1_m,y1_m,z1_m\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].of->keys; k++) {
            const struct wf_rain_scene *s = &p->run[r].of->scene;
            const double *place = p->run[r].of->key[k].place;
            size_t wide = 2 * s->spec.mesh[1] + 1, axes = s->spec.leaves * s->mesh.points;
            for (size_t l = 0; l < s->spec.leaves; l++)
                for (size_t i = 0; i < s->spec.mesh[0]; i++) {
                    size_t at = s->leaf[l].mesh + i * wide, mid = at + s->spec.mesh[1];
                    line(f, r + 1, k + 1, l + 1, "edge", place, at, at + wide);
                    line(f, r + 1, k + 1, l + 1, "edge", place, at + wide - 1, at + 2 * wide - 1);
                    line(f, r + 1, k + 1, l + 1, "vein", place, mid, mid + wide);
                }
            for (size_t a = 0; a <= s->spec.leaves; a++) {
                size_t from = axes + (size_t)s->prism.first[a],
                       n = a ? s->spec.petiole_prisms + 1 : s->sections;
                for (size_t i = 0; i + 1 < n; i++)
                    line(f, r + 1, k + 1, a, a ? "petiole" : "branch", place, from + i, from + i + 1);
            }
        }
}

static void air(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,key,x_m,y_m,z_m,vx_m_s,vy_m_s,vz_m_s\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].of->keys; k++)
            for (size_t i = 0; i < p->run[r].of->key[k].air; i++) {
                const double *d = p->run[r].of->key[k].drop + 6 * i;
                fprintf(f, "%zu,%zu,%.6g,%.6g,%.6g,%.5g,%.5g,%.5g\n", r + 1, k + 1, d[0], d[1], d[2], d[3],
                        d[4], d[5]);
            }
}

/* Drops of the leaf of every key frame; subdrop 0 is the drop or its head. */
static void drops(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,key,leaf,drop,subdrop,state,along_mm,across_mm,mass_mg,radius_mm,base_mm,speed_mm_s\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].of->keys; k++) {
            const struct wf_rain_key *q = &p->run[r].of->key[k];
            const struct wf_water_law *law = &p->run[r].of->spec->water;
            for (size_t i = 0; i < q->water->drops; i++) {
                const struct wf_leaf_drop *d = &q->water->drop[i];
                double radius[WF_TAIL_MOST];
                size_t n = wf_leaf_tail(law, d, radius);
                for (size_t j = 0; j < n; j++) {
                    const double *at = j ? d->behind[j - 1] : d->at;
                    fprintf(f, "%zu,%zu,%zu,%zu,%zu,%s,%.5g,%.5g,%.5g,%.5g,%.5g,%.5g\n", r + 1, k + 1,
                            q->leaf + 1, i + 1, j, wf_drop_states[d->state], 1e3 * at[0], 1e3 * at[1],
                            1e6 * d->mass, 1e3 * radius[j], 1e3 * d->base * radius[j] / d->radius,
                            1e3 * hypot(d->v[0], d->v[1]));
                }
            }
        }
}

/* Wetness and depth on the leaf of a key frame, empty beside the blade. */
static void map(FILE *f, const struct wf_rain_key *q)
{
    const struct wf_blade *b = &q->water->blade;
    fputs("along_mm,across_mm,wetness,depth_mm\n", f);
    for (size_t i = 0; i < WF_RAIN_MAP; i++)
        for (size_t j = 0; j < WF_RAIN_MAP; j++) {
            double wet = (double)q->wetness[i * WF_RAIN_MAP + j],
                   deep = (double)q->height[i * WF_RAIN_MAP + j];
            fprintf(f, "%.4g,%.4g,", 1e3 * ((double)i + 0.5) / WF_RAIN_MAP * b->length,
                    1e3 * (((double)j + 0.5) / WF_RAIN_MAP * 2 - 1) * b->half);
            if (isfinite(wet))
                fprintf(f, "%.3g,%.3g\n", wet, 1e3 * deep);
            else
                fputs(",\n", f);
        }
}

/* A file for each key frame of each run. */
static enum wf_status write_maps(const struct wf_rain_page *p, const char *folder, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    for (size_t r = 0; r < p->n && !s; r++)
        for (size_t k = 0; k < p->run[r].of->keys && !s; k++) {
            struct wf_file f = { 0 };
            char name[80];
            snprintf(name, sizeof name, "tables/map_%zu_%zu.csv", r + 1, k + 1);
            if ((s = wf_folder_begin(&f, folder, name, e))) break;
            map(f.stream, &p->run[r].of->key[k]);
            s = wf_file_commit(&f, e);
        }
    return s;
}

static void events(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,time_s,leaf,event,mass_mg\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t i = 0; i < p->run[r].of->events; i++) {
            const struct wf_rain_event *v = &p->run[r].of->event[i];
            fprintf(f, "%zu,%.6g,%zu,%s,%.5g\n", r + 1, v->time, v->leaf + 1, v->what, 1e6 * v->mass);
        }
}

/* Terms of the two budgets. */
struct term {
    const char *of, *name;
    double value; /* [mg], [uJ] */
};
enum { TERMS = 17 };

static void terms_of(const struct wf_rain_result *r, struct term t[TERMS])
{
    const struct wf_water_budget *w = &r->water;
    const struct wf_energy_budget *b = &r->energy;
    const struct term all[TERMS] = { { "water", "rain", 1e6 * w->rain },
                                     { "water", "air", 1e6 * w->air },
                                     { "water", "ground", 1e6 * w->ground },
                                     { "water", "splash", 1e6 * w->splash },
                                     { "water", "wood", 1e6 * w->wood },
                                     { "water", "held", 1e6 * w->held },
                                     { "water", "film", 1e6 * w->film },
                                     { "energy", "drops", 1e6 * b->drops },
                                     { "energy", "start", 1e6 * b->start },
                                     { "energy", "weight", 1e6 * b->weight },
                                     { "energy", "load", 1e6 * b->load },
                                     { "energy", "wind", 1e6 * b->wind },
                                     { "energy", "push", 1e6 * b->push },
                                     { "energy", "damping", -1e6 * b->damping },
                                     { "energy", "solver", 1e6 * b->solver },
                                     { "energy", "end", 1e6 * b->end },
                                     { NULL, NULL, 0 } };
    memcpy(t, all, sizeof all);
}

static void budget(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,budget,term,mg_or_uJ\n", f);
    for (size_t r = 0; r < p->n; r++) {
        struct term t[TERMS];
        terms_of(p->run[r].of, t);
        for (size_t i = 0; t[i].of; i++)
            fprintf(f, "%zu,%s,%s,%.9g\n", r + 1, t[i].of, t[i].name, t[i].value);
    }
}

/* How many springs of a kind there are, and the range of their constants; INFINITY, 0: there are none. */
static size_t spring_range(const struct wf_prism *q, int32_t row, double *low, double *high)
{
    size_t n = 0;
    *low = INFINITY, *high = 0;
    for (size_t i = 0; i < q->springs; i++) {
        if (q->spring[i].row != row) continue;
        *low = fmin(*low, q->spring[i].k), *high = fmax(*high, q->spring[i].k), n++;
    }
    return n;
}

static void springs(FILE *f, const struct wf_rain_page *p)
{
    fputs("run,row,joins,springs,lowest_N_m,highest_N_m\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (int32_t k = 0; k < WF_PRISM_ROWS; k++) {
            double low, high;
            size_t n = spring_range(&p->run[r].of->scene.prism, k, &low, &high);
            fprintf(f, "%zu,%s,\"%s\",%zu,", r + 1, wf_prism_kinds[k].name, wf_prism_kinds[k].joins, n);
            if (n)
                fprintf(f, "%.5g,%.5g\n", low, high);
            else
                fputs(",\n", f);
        }
}

/* Springs without a law, without restoring springs and with them. */
static void orders(FILE *f, const struct wf_rain_page *p)
{
    fputs("prisms,restoring_N_m,sag_over_length,fold_deg,strain,back_s,left_over_length\n", f);
    for (size_t k = 0; k < WF_PRISM_ORDERS; k++) {
        const struct wf_prism_order *o = &p->order[k];
        fprintf(f, "%zu,%.4g,%.4g,%.4g,%.4g,", o->prisms, o->restoring, o->sag, degrees(o->fold), o->strain);
        if (isfinite(o->back)) fprintf(f, "%.4g", o->back);
        fprintf(f, ",%.4g\n", o->left);
    }
}

/* Axes, side by side: loaded, and after the load was taken away. */
static void order_lines(FILE *f, const struct wf_rain_page *p)
{
    fputs("prisms,restoring_N_m,state,x_m,z_m\n", f);
    for (size_t k = 0; k < WF_PRISM_ORDERS; k++) {
        const struct wf_prism_order *o = &p->order[k];
        for (size_t i = 0; i < 2 * (o->prisms + 1); i++)
            fprintf(f, "%zu,%.4g,%s,%.5g,%.5g\n", o->prisms, o->restoring, i > o->prisms ? "free" : "loaded",
                    o->line[3 * i], o->line[3 * i + 2]);
    }
}

static void prisms(FILE *f, const struct wf_rain_page *p)
{
    fputs("prisms,tip_error,twist_error,frequency_error,tip_with_restoring,frequency_with_restoring\n", f);
    for (size_t k = 0; k < WF_PRISM_CHECKS; k++)
        fprintf(f, "%zu,%.5g,%.5g,%.5g,%.5g,%.5g\n", p->check[k].prisms, p->check[k].bend, p->check[k].twist,
                p->check[k].frequency, p->check[k].held, p->check[k].quick);
}

/* Speeds of fall by every law, and the drops that arrive by Marshall and Palmer at 10 mm/h. */
static void falls(FILE *f, const struct wf_rain_page *p)
{
    (void)p;
    struct wf_spectrum_sums sums;
    wf_marshall_palmer(10 / 3.6e6, 1e-4, 6e-3, &wf_fall_laws[0], &sums);
    fputs("diameter_mm", f);
    for (const struct wf_fall_law *l = wf_fall_laws; l->name; l++) fprintf(f, ",%s_m_s", l->name);
    fputs(",number_m3_mm\n", f);
    for (int i = 1; i <= 60; i++) {
        fprintf(f, "%.1f", i / 10.0);
        for (const struct wf_fall_law *l = wf_fall_laws; l->name; l++)
            fprintf(f, ",%.5g", l->speed(i * 1e-4));
        fprintf(f, ",%.5g\n", 10 / 3.6e6 / sums.flux * 8000 * exp(-4.1 * pow(10, -0.21) * i / 10.0));
    }
}

static void speeds(FILE *f, const struct wf_rain_page *p)
{
    fputs("scene,leaves,vertices,facets,paper_vertices,paper_facets,grid,drops,paper_frames_s,steps_s\n", f);
    for (size_t i = 0; i < p->speeds; i++) {
        const struct wf_rain_speed *s = &p->speed[i];
        fprintf(f, "%zu,%zu,%zu,%zu,%zu,%zu,%zu,%zu,%.4g,%.4g\n", s->scene, s->leaves, s->vertices, s->facets,
                s->paper_vertices, s->paper_facets, s->grid, s->drops, s->paper, s->steps);
    }
}

static void clusters(FILE *f, const struct wf_rain_page *p)
{
    fputs("cluster,x_m,y_m,z_m,points\n", f);
    for (size_t k = 0; k < p->clusters->n; k++) {
        const double *c = p->clusters->centre + 3 * k;
        fprintf(f, "%zu,%.6g,%.6g,%.6g,%zu\n", k + 1, c[0], c[1], c[2], p->clusters->count[k]);
    }
}

static void points(FILE *f, const struct wf_rain_page *p)
{
    enum { SHOWN = 4000 };
    size_t every = p->points->n / SHOWN + 1;
    fputs("x_m,y_m,z_m,cluster\n", f);
    for (size_t i = 0; i < p->points->n; i += every)
        fprintf(f, "%.6g,%.6g,%.6g,%d\n", p->points->at[3 * i], p->points->at[3 * i + 1],
                p->points->at[3 * i + 2], (int)p->clusters->of[i] + 1);
}

/* ---- Data of the figures ---- */

static void plot_run(struct wf_plot_data *to, const struct wf_rain_page_run *run, size_t k)
{
    const struct wf_rain_result *r = run->of;
    double low[3] = { INFINITY, INFINITY, INFINITY }, high[3] = { -INFINITY, -INFINITY, -INFINITY };
    char key[32];
    for (size_t i = 0; i < r->scene.places; i++)
        for (size_t c = 0; c < 3; c++)
            low[c] = fmin(low[c], r->scene.place[3 * i + c]),
            high[c] = fmax(high[c], r->scene.place[3 * i + c]);
    const struct {
        const char *key;
        double x;
    } number[] = { { "KEYS", (double)r->keys },
                   { "LENGTH", 1e3 * r->scene.blade.length },
                   { "HALF", 1e3 * r->scene.blade.half },
                   { "LOW_X", low[0] },
                   { "HIGH_X", high[0] },
                   { "LOW_Z", low[2] },
                   { "HIGH_Z", high[2] },
                   { "DURATION", r->spec->duration },
                   { "FALLEN", r->fallen_at },
                   { "QUIET", fmax(isfinite(r->fallen_at) ? r->fallen_at : 0, r->struck_at) },
                   { "FREQUENCY", r->frequency },
                   { "RATIO", r->spec->damping } };
    wf_plot_data_text(to, "NAME", k, run->name);
    for (size_t i = 0; i < WF_COUNT(number); i++) wf_plot_data_number(to, number[i].key, k, number[i].x);
    for (size_t i = 0; i < r->keys; i++) {
        snprintf(key, sizeof key, "EVENT_%zu", k);
        wf_plot_data_words(to, key, i + 1, r->key[i].event);
        snprintf(key, sizeof key, "TIME_%zu", k);
        wf_plot_data_number(to, key, i + 1, r->key[i].time);
        snprintf(key, sizeof key, "LEAF_%zu", k);
        wf_plot_data_count(to, key, i + 1, r->key[i].leaf + 1);
    }
}

static enum wf_status plot_data(const struct wf_rain_page *page, const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    wf_plot_data_count(&p, "RUNS", 0, page->n);
    for (size_t r = 0; r < page->n; r++) plot_run(&p, &page->run[r], r + 1);
    return wf_plot_data_end(&p, e);
}

/* ---- The document ---- */

static void run_numbers(struct wf_doc *d, json_t *o, const struct wf_rain_result *r)
{
    const struct wf_rain_spec *s = r->spec;
    double area = wf_blade_area(&r->scene.blade);
    const struct {
        const char *key;
        double x;
    } number[] = { { "duration_s", s->duration },
                   { "step_s", s->step },
                   { "intensity_mm_h", s->rain.intensity * 3.6e6 },
                   { "drops", (double)s->drops },
                   { "diameter_mm", 1e3 * s->rain.diameter },
                   { "steps_a_second", (double)r->steps / fmax(r->seconds, 1e-9) },
                   { "vein_mm", 1e3 * s->scene.leaf_length },
                   { "leaf_cm2", 1e4 * area },
                   { "leaf_mg", 1e6 * area * s->scene.species->crown.leaf_mass_per_area.value },
                   { "petiole_mm", 1e3 * s->scene.petiole },
                   { "petiole_diameter_mm", 2e3 * s->scene.petiole_radius },
                   { "petiole_GPa", 1e-9 * s->scene.petiole_youngs },
                   { "contact_angle_deg", degrees(s->water.angle) },
                   { "receding_deg", s->printed ? NAN : degrees(s->water.receding) },
                   { "advancing_deg", s->printed ? NAN : degrees(s->water.advancing) },
                   { "tests_a_way", (double)r->tests / fmax(1, (double)r->ways) },
                   { "frequency_Hz", r->frequency },
                   { "damping_ratio", s->damping },
                   { "decrement", WF_TURN * s->damping / sqrt(1 - s->damping * s->damping) },
                   { "ring_frequency_Hz", r->ring_frequency },
                   { "ring_decrement", r->ring_decrement },
                   { "fallen_at_s", r->fallen_at },
                   { "euler_limit_s", r->euler_limit },
                   { "hanging_mg", 1e6 * wf_leaf_hanging(&s->water) },
                   { "water_off", r->water.off },
                   { "energy_off", r->energy.off } };
    for (size_t i = 0; i < WF_COUNT(number); i++) wf_doc_number(d, o, number[i].key, number[i].x);
}

static void spring_kinds(struct wf_doc *d, json_t *o, const struct wf_prism *p)
{
    json_t *kinds = wf_doc_put(d, o, "spring_kinds", wf_doc_array(d));
    for (int32_t k = 0; k < WF_PRISM_ROWS; k++) {
        double low, high;
        size_t n = spring_range(p, k, &low, &high);
        json_t *q = wf_doc_add(d, kinds, wf_doc_object(d));
        wf_doc_text(d, q, "name", wf_prism_kinds[k].name), wf_doc_count(d, q, "number", n);
        wf_doc_number(d, q, "low", n ? low : NAN), wf_doc_number(d, q, "high", n ? high : NAN);
    }
}

static json_t *run_part(struct wf_doc *d, const struct wf_rain_page_run *run)
{
    const struct wf_rain_result *r = run->of;
    const struct wf_rain_spec *s = r->spec;
    size_t most[WF_DROP_STATES] = { 0 }, count[WF_WATER_EVENTS] = { 0 };
    json_t *o = wf_doc_object(d);
    for (size_t i = 0; i < r->rows; i++)
        for (int k = 0; k < WF_DROP_STATES; k++)
            if (r->row[i].state[k] > most[k]) most[k] = r->row[i].state[k];
    for (size_t l = 0; l < s->scene.leaves; l++)
        for (int k = 0; k < WF_WATER_EVENTS; k++) count[k] += r->leaf[l].count[k];
    wf_doc_text(d, o, "name", run->name);
    wf_doc_text(d, o, "preset", s->printed ? "yang2011" : "corrected");
    wf_doc_text(d, o, "species", s->scene.species->name), wf_doc_text(d, o, "form", s->scene.form->name);
    wf_doc_text(d, o, "species_zh", s->scene.species->name_zh);
    wf_doc_text(d, o, "stepping", s->method == WF_PRISM_EULER ? "euler" : "midpoint");
    wf_doc_flag(d, o, "staged", s->staged);
    wf_doc_count(d, o, "keys", r->keys);
    wf_doc_count(d, o, "leaves", s->scene.leaves), wf_doc_count(d, o, "grid", s->grid);
    wf_doc_count(d, o, "vertices", r->scene.vertices), wf_doc_count(d, o, "facets", r->scene.facets);
    wf_doc_count(d, o, "steps", r->steps), wf_doc_count(d, o, "springs", r->scene.prism.springs);
    wf_doc_count(d, o, "hits", r->hits), wf_doc_count(d, o, "wood_hits", r->wood_hits);
    wf_doc_count(d, o, "missed", r->missed);
    for (int k = 0; k < WF_WATER_EVENTS; k++) wf_doc_count(d, o, wf_water_events[k], count[k]);
    run_numbers(d, o, r), spring_kinds(d, o, &r->scene.prism);
    json_t *list = wf_doc_put(d, o, "budget", wf_doc_array(d));
    struct term t[TERMS];
    terms_of(r, t);
    for (size_t i = 0; t[i].of; i++) {
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_text(d, q, "of", t[i].of), wf_doc_text(d, q, "term", t[i].name),
            wf_doc_number(d, q, "value", t[i].value);
    }
    return o;
}

static void check_part(struct wf_doc *d, json_t *o, const struct wf_rain_page *p)
{
    json_t *list = wf_doc_put(d, o, "prisms", wf_doc_array(d));
    for (size_t k = 0; k < WF_PRISM_CHECKS; k++) {
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "prisms", p->check[k].prisms);
        wf_doc_number(d, q, "tip_percent", 100 * p->check[k].bend);
        wf_doc_number(d, q, "twist_percent", 100 * p->check[k].twist);
        wf_doc_number(d, q, "frequency_percent", 100 * p->check[k].frequency);
        wf_doc_number(d, q, "with_restoring", p->check[k].held);
        wf_doc_number(d, q, "frequency_with_restoring", p->check[k].quick);
    }
    wf_doc_number(d, o, "restoring_N_m", p->rod.restoring);
    if (p->order) wf_doc_number(d, o, "order_N_m", p->order[0].constant);
    list = wf_doc_put(d, o, "order", wf_doc_array(d));
    for (size_t k = 0; p->order && k < WF_PRISM_ORDERS; k++) {
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "prisms", p->order[k].prisms);
        wf_doc_number(d, q, "restoring", p->order[k].restoring);
        wf_doc_number(d, q, "sag_percent", 100 * p->order[k].sag);
        wf_doc_number(d, q, "fold_deg", degrees(p->order[k].fold));
        wf_doc_number(d, q, "strain_percent", 100 * p->order[k].strain);
        wf_doc_number(d, q, "back", p->order[k].back);
        wf_doc_number(d, q, "left_percent", 100 * p->order[k].left);
    }
    list = wf_doc_put(d, o, "speeds", wf_doc_array(d));
    for (size_t i = 0; i < p->speeds; i++) {
        const struct wf_rain_speed *s = &p->speed[i];
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "scene", s->scene), wf_doc_count(d, q, "leaves", s->leaves);
        wf_doc_count(d, q, "vertices", s->vertices), wf_doc_count(d, q, "facets", s->facets);
        wf_doc_count(d, q, "paper_vertices", s->paper_vertices);
        wf_doc_count(d, q, "paper_facets", s->paper_facets);
        wf_doc_count(d, q, "grid", s->grid), wf_doc_count(d, q, "drops", s->drops);
        wf_doc_number(d, q, "paper", s->paper), wf_doc_number(d, q, "steps", s->steps);
    }
}

static void figures(struct wf_doc *d, json_t *list, const struct wf_rain_page *p)
{
    static const char *const of_run[] = { "rain_scene", "rain_leaf", "rain_series", "rain_ring" };
    char name[32];
    for (size_t r = 0; r < p->n; r++)
        for (size_t i = 0; i < WF_COUNT(of_run); i++) {
            if (i == 3 && !isfinite(p->run[r].of->ring_frequency)) continue;
            snprintf(name, sizeof name, "%s_%zu", of_run[i], r + 1);
            wf_doc_figure(d, list, name, of_run[i], r + 1);
        }
    wf_doc_figure(d, list, "rain_prisms", "rain_prisms", 0);
    if (p->order) wf_doc_figure(d, list, "rain_order", "rain_order", 0);
    wf_doc_figure(d, list, "rain_falls", "rain_falls", 0);
    if (p->clusters) wf_doc_figure(d, list, "rain_clusters", "rain_clusters", 0);
}

static enum wf_status document(const struct wf_rain_page *p, const struct wf_doc_head *head,
                               const char *folder, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    json_t *o = wf_doc_begin(&d, "windfirm-rain", head);
    json_t *runs = wf_doc_put(&d, o, "runs", wf_doc_array(&d));
    for (size_t r = 0; r < p->n; r++) wf_doc_add(&d, runs, run_part(&d, &p->run[r]));
    check_part(&d, o, p);
    if (p->clusters) {
        json_t *q = wf_doc_put(&d, o, "clusters", wf_doc_object(&d));
        wf_doc_count(&d, q, "points", p->points->n), wf_doc_count(&d, q, "number", p->clusters->n);
        wf_doc_number(&d, q, "spread_mm", 1e3 * p->clusters->spread);
    }
    json_t *list = wf_doc_put(&d, o, "warnings", wf_doc_array(&d));
    for (size_t r = 0; r < p->n; r++) wf_doc_warnings(&d, list, p->run[r].diag);
    figures(&d, wf_doc_put(&d, o, "figures", wf_doc_array(&d)), p);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_rain_results_write(const struct wf_rain_page *p, const struct wf_doc_head *head,
                                     const char *folder, struct wf_err *e)
{
    const struct {
        const char *name;
        void (*write)(FILE *f, const struct wf_rain_page *p);
        bool left_out;
    } table[] = { { "tables/series.csv", series, false },
                  { "tables/keys.csv", keys, false },
                  { "tables/scene.csv", scene, false },
                  { "tables/air.csv", air, false },
                  { "tables/drops.csv", drops, false },
                  { "tables/events.csv", events, false },
                  { "tables/budget.csv", budget, false },
                  { "tables/prisms.csv", prisms, false },
                  { "tables/springs.csv", springs, false },
                  { "tables/falls.csv", falls, false },
                  { "tables/speeds.csv", speeds, !p->speeds },
                  { "tables/clusters.csv", clusters, !p->clusters },
                  { "tables/points.csv", points, !p->clusters },
                  { "tables/order.csv", orders, !p->order },
                  { "tables/order_lines.csv", order_lines, !p->order } };
    enum wf_status s = wf_folder_make(folder, e);
    for (size_t i = 0; i < WF_COUNT(table) && !s; i++) {
        struct wf_file f = { 0 };
        if (table[i].left_out) continue;
        if ((s = wf_folder_begin(&f, folder, table[i].name, e))) break;
        table[i].write(f.stream, p);
        s = wf_file_commit(&f, e);
    }
    if (!s) s = write_maps(p, folder, e);
    if (!s) s = plot_data(p, folder, e);
    return s ? s : document(p, head, folder, e);
}
