/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/series.h"
#include "base/file.h"
#include "data/species.h"
#include "out/doc.h"
#include <math.h>
#include <string.h>

/* Position along the wind [m]. The panels show it and the height above ground. */
static double along(const struct wf_series *s, const double x[3])
{
    const double *to = s->an.wind.direction;
    return to[0] * x[0] + to[1] * x[1];
}

/* Position across the wind, positive to the left [m]. */
static double across(const struct wf_series *s, const double x[3])
{
    const double *to = s->an.wind.direction;
    return to[0] * x[1] - to[1] * x[0];
}

static void base_of(const struct wf_series *s, size_t frame, size_t row, double x[3])
{
    const struct wf_tree *t = &s->an.tree;
    const double *p = s->place + frame * 3 * t->n;
    int32_t below = t->parent[row];
    const double ground[3] = { t->x0[row], t->y0[row], t->z0[row] };
    for (int k = 0; k < 3; k++) x[k] = below < 0 ? ground[k] : p[3 * below + k];
}

static void end_of(const struct wf_series *s, size_t frame, size_t row, double x[3])
{
    const double *p = s->place + (frame * s->an.tree.n + row) * 3;
    for (int k = 0; k < 3; k++) x[k] = p[k];
}

/* A comma and the number, or nothing after the comma where it is not finite. */
static void cell(FILE *f, double x)
{
    fputc(',', f);
    if (isfinite(x)) fprintf(f, "%.7g", x);
}

static void series(const struct wf_series_page *p, FILE *f)
{
    fputs("run,frame,time_s,wind_m_s,tip_deflection_m,tip_along_m,tip_z_m,base_moment_N_m,wind_across_m_s,"
          "wind_up_m_s,tip_across_m,safety,beyond_breakage\n",
          f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        for (size_t k = 0; k < s->frames; k++) {
            double x[3];
            end_of(s, k, s->tip, x);
            fprintf(f, "%zu,%zu,%.7g", r + 1, k, (double)k * s->spec.step);
            cell(f, s->wind[k]), cell(f, s->deflection[k]), cell(f, along(s, x)), cell(f, x[2]);
            cell(f, s->moment[k]), cell(f, s->across ? s->across[k] : 0);
            cell(f, s->up ? s->up[k] : 0), cell(f, across(s, x)), cell(f, s->safety[k]);
            fprintf(f, ",%d\n", k >= s->broken);
        }
    }
}

/* Key 0 is the unloaded tree. */
static void frames(const struct wf_series_page *p, FILE *f)
{
    fputs("run,key,time_s,wind_m_s,segment,level,radius_m,along0_m,z0_m,along1_m,z1_m\n", f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        const struct wf_tree *t = &s->an.tree;
        for (size_t k = 0; k <= s->spec.keys; k++)
            for (size_t i = 0; i < t->n; i++) {
                double a[3] = { t->x0[i], t->y0[i], t->z0[i] }, b[3] = { t->x1[i], t->y1[i], t->z1[i] };
                size_t frame = k ? s->key[k - 1] : 0;
                if (k) base_of(s, frame, i, a), end_of(s, frame, i, b);
                fprintf(f, "%zu,%zu,%.7g,%.6g,%lld,%d,%.5g,%.6g,%.6g,%.6g,%.6g\n", r + 1, k,
                        k ? (double)frame * s->spec.step : 0, k ? s->wind[frame] : 0, (long long)t->id[i],
                        (int)t->level[i], 0.5 * (t->r0[i] + t->r1[i]), along(s, a), a[2], along(s, b), b[2]);
            }
    }
}

static void levels(const struct wf_series_page *p, FILE *f)
{
    fputs("run,level,axes,amplitude_mean_m,amplitude_largest_m,amplitude_own_mean_m,amplitude_windward_m,"
          "amplitude_leeward_m,amplitude_own_windward_m,amplitude_own_leeward_m\n",
          f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].series->levels; k++) {
            const struct wf_series_level *l = &p->run[r].series->level[k];
            fprintf(f, "%zu,%zu,%zu", r + 1, k, l->axes);
            cell(f, l->swing_mean), cell(f, l->swing_most), cell(f, l->own_mean);
            cell(f, l->windward), cell(f, l->leeward), cell(f, l->own_windward), cell(f, l->own_leeward);
            fputc('\n', f);
        }
}

static void text(FILE *f, const char *words)
{
    fputc('"', f);
    for (; *words; words++) {
        if (*words == '"') fputc('"', f);
        fputc(*words, f);
    }
    fputc('"', f);
}

/* Two cells: a file that was read, and the hash of its bytes. */
static void file(FILE *f, const char *path, struct wf_arena *a)
{
    char hash[WF_SHA256_TEXT] = "";
    struct wf_err unread = { 0 };
    fputc(',', f);
    text(f, path ? path : "");
    if (path && wf_sha256_file(path, a, hash, &unread)) hash[0] = '\0';
    fprintf(f, ",%s", hash);
}

static void runs(const struct wf_series_page *p, FILE *f)
{
    fputs("run,name,species,model,preset,solver,gust,wind_m_s,youngs_modulus_Pa,shelter,seed,frames,step_s,"
          "tip_deflection_mean_m,tip_deflection_largest_m,wind_lowest_m_s,wind_highest_m_s,wind_mean_m_s,"
          "gust_components,gust_parameters,gust_file,gust_sha256,profile,profile_file,profile_sha256\n",
          f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        double sum = 0, most = 0, low = INFINITY, high = -INFINITY, n = 0, wind = 0;
        for (size_t k = 0; k < s->frames; k++) {
            wind += s->wind[k] / (double)s->frames;
            low = fmin(low, s->wind[k]), high = fmax(high, s->wind[k]);
            if (!isfinite(s->deflection[k])) continue;
            sum += s->deflection[k], n++, most = fmax(most, s->deflection[k]);
        }
        fprintf(f, "%zu,", r + 1);
        text(f, s->spec.name);
        fprintf(f, ",%s,%s,%s,%s,%s,%.6g", s->spec.species->key, s->spec.model->key, s->spec.preset->name,
                s->spec.solver->name, s->spec.gust ? s->spec.gust : "steady", s->spec.speed);
        cell(f, s->an.tree.youngs[0]);
        fprintf(f, ",%s,%llu,%zu,%.6g", s->spec.shelter ? s->spec.shelter->name : "none",
                (unsigned long long)s->spec.seed, s->frames, s->spec.step);
        cell(f, sum / n), cell(f, most), cell(f, low), cell(f, high), cell(f, wind);
        fprintf(f, ",%d,", s->across ? 3 : 1);
        text(f, s->gust_words ? s->gust_words : "");
        file(f, s->spec.gust_file, p->run[r].diag->arena);
        fprintf(f, ",%s", s->an.scenario.profile);
        file(f, s->an.scenario.profile_file, p->run[r].diag->arena);
        fputc('\n', f);
    }
}

static void warnings(const struct wf_series_page *p, FILE *f)
{
    fputs("run,code,text\n", f);
    for (size_t r = 0; r < p->n; r++)
        for (const struct wf_finding *w = p->run[r].diag->first; w; w = w->next) {
            fprintf(f, "%zu,%s,", r + 1, w->code ? w->code : "");
            text(f, w->text);
            fputc('\n', f);
        }
}

static void trajectories(const struct wf_series_page *p, FILE *f)
{
    fputs("run,frame,time_s,segment,x_m,y_m,z_m\n", f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        const struct wf_tree *t = &s->an.tree;
        bool all = s->frames * t->n <= 200000;
        for (size_t i = 0; i < t->n; i++) {
            bool tip = i + 1 == t->n || t->parent[i + 1] != (int32_t)i;
            for (size_t k = 0; (all || tip) && k < s->frames; k++) {
                double x[3];
                end_of(s, k, i, x);
                fprintf(f, "%zu,%zu,%.6g,%lld,%.6g,%.6g,%.6g\n", r + 1, k, (double)k * s->spec.step,
                        (long long)t->id[i], x[0], x[1], x[2]);
            }
        }
    }
}

enum { LEAVES_SHOWN = 12 };

static enum wf_status leaves(const struct wf_series_page *p, FILE *f, struct wf_err *e)
{
    fputs("run,key,leaf,along0_m,z0_m,along1_m,z1_m\n", f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        struct wf_arena scratch = { 0 };
        double *at = WF_TAKE(&scratch, 3 * s->leaves.n, double),
               *tip = WF_TAKE(&scratch, 3 * s->leaves.n, double);
        for (size_t k = 0; at && tip && s->leaves.n && k < s->spec.keys; k++) {
            wf_series_leaves(s, s->key[k], at, tip);
            for (size_t i = 0; i < s->leaves.n; i++)
                fprintf(f, "%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g\n", r + 1, k + 1, i + 1, along(s, at + 3 * i),
                        at[3 * i + 2], along(s, tip + 3 * i), tip[3 * i + 2]);
        }
        wf_arena_free(&scratch);
        if (!at || !tip) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu leaves", s->leaves.n);
    }
    return WF_OK;
}

/* A column for each angle of each motion; those of other motions stay empty. */
static enum wf_status angles(const struct wf_series_page *p, FILE *f, struct wf_err *e)
{
    const double degree = 57.29577951308232;
    (void)e;
    fputs("run,frame,time_s,wind_m_s,leaf,segment", f);
    for (const struct wf_leaf_motion *m = wf_leaf_motions; m->name; m++)
        for (int k = 0; k < 3 && m->angles[k]; k++) fprintf(f, ",%s_deg", m->angles[k]);
    fputc('\n', f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        size_t shown = s->leaves.n < LEAVES_SHOWN ? s->leaves.n : LEAVES_SHOWN;
        for (size_t c = 0; c < s->frames * shown; c++) {
            size_t k = c / shown, leaf = c % shown * s->leaves.n / shown;
            double angle[3];
            wf_series_leaf_angles(s, leaf, k, angle);
            fprintf(f, "%zu,%zu,%.6g", r + 1, k, (double)k * s->spec.step);
            cell(f, s->wind[k]);
            fprintf(f, ",%zu,%lld", leaf + 1, (long long)s->an.tree.id[s->leaves.row[leaf]]);
            for (const struct wf_leaf_motion *m = wf_leaf_motions; m->name; m++)
                for (int j = 0; j < 3 && m->angles[j]; j++)
                    cell(f, m == s->spec.leaf_motion ? angle[j] * degree : NAN);
            fputc('\n', f);
        }
    }
    return WF_OK;
}

static enum wf_status leaf_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        enum wf_status (*write)(const struct wf_series_page *p, FILE *f, struct wf_err *e);
    } table[] = { { "tables/leaves.csv", leaves }, { "tables/leaf_angles.csv", angles } };
    enum wf_status status = WF_OK;
    for (size_t i = 0; i < 2 && !status; i++) {
        struct wf_file f = { 0 };
        status = wf_folder_begin(&f, folder, table[i].name, e);
        if (!status) status = table[i].write(p, f.stream, e);
        if (!status) status = wf_file_commit(&f, e);
        wf_file_abandon(&f);
    }
    return status;
}

/* Runs that differ in the modulus alone: a sweep, drawn as one curve. */
static bool differ_in_modulus(const struct wf_series *a, const struct wf_series *b)
{
    return a->frames == 1 && b->frames == 1 && !strcmp(a->spec.species->key, b->spec.species->key) &&
           !strcmp(a->spec.model->key, b->spec.model->key) && a->spec.solver == b->spec.solver &&
           a->spec.speed == b->spec.speed && a->an.tree.youngs[0] != b->an.tree.youngs[0];
}

static size_t count_sweep(const struct wf_series_page *p, size_t r)
{
    size_t n = 1;
    for (size_t k = 0; k < p->n; k++) n += differ_in_modulus(p->run[r].series, p->run[k].series);
    return n;
}

static size_t largest_sweep(const struct wf_series_page *p, size_t *first)
{
    size_t most = 0;
    for (size_t r = 0; r < p->n; r++) {
        size_t n = count_sweep(p, r);
        if (n > most) most = n, *first = r;
    }
    return most >= 3 ? most : 0;
}

static void plot_sweep(const struct wf_series_page *p, struct wf_plot_data *to)
{
    size_t first = 0, n = 0;
    if (!largest_sweep(p, &first)) return;
    const struct wf_series *s = p->run[first].series;
    for (size_t r = 0; r < p->n; r++)
        if (r == first || differ_in_modulus(s, p->run[r].series)) wf_plot_data_count(to, "SWEPT", ++n, r + 1);
}

/* Extent of the tree along the wind and in height, unloaded and in the key frames [m]. */
static void extent(const struct wf_series *s, double *left, double *right, double *top)
{
    const struct wf_tree *t = &s->an.tree;
    *left = *right = *top = 0;
    for (size_t k = 0; k < s->spec.keys; k++)
        for (size_t i = 0; i < t->n; i++) {
            double x[3], rest[3] = { t->x1[i], t->y1[i], t->z1[i] };
            end_of(s, s->key[k], i, x);
            *left = fmin(*left, fmin(along(s, x), along(s, rest)));
            *right = fmax(*right, fmax(along(s, x), along(s, rest)));
            *top = fmax(*top, fmax(x[2], rest[2]));
        }
}

static void plot_run(struct wf_plot_data *p, const struct wf_series *s, size_t run)
{
    double left, right, top;
    extent(s, &left, &right, &top);
    const struct {
        const char *key;
        double x;
    } number[] = { { "KEYS", (double)s->spec.keys },
                   { "FRAMES", (double)s->frames },
                   { "HEIGHT_M", s->an.tallness },
                   { "LEFT", left },
                   { "RIGHT", right },
                   { "TOP", top },
                   { "LEAVES", (double)s->leaves.n },
                   { "STEP", s->spec.step },
                   { "LEVELS", (double)s->levels } };
    bool named = strcmp(s->spec.name, s->spec.species->key) != 0;
    wf_plot_data_text(p, "NAME", run, named ? s->spec.name : s->spec.species->name);
    for (size_t i = 0; i < sizeof number / sizeof *number; i++)
        wf_plot_data_number(p, number[i].key, run, number[i].x);
    wf_plot_data_text(p, "MOTION", run, s->spec.leaf_motion->name);
    char key[32];
    for (size_t k = 0; k < s->spec.keys; k++) {
        snprintf(key, sizeof key, "KEY_TIME_%zu", run);
        wf_plot_data_number(p, key, k + 1, (double)s->key[k] * s->spec.step);
        snprintf(key, sizeof key, "KEY_WIND_%zu", run);
        wf_plot_data_number(p, key, k + 1, s->wind[s->key[k]]);
        snprintf(key, sizeof key, "KEY_BROKEN_%zu", run);
        wf_plot_data_number(p, key, k + 1, s->key[k] >= s->broken ? 1.0 : 0.0);
    }
}

/* What the figure scripts need to know: names, key frames, extent along the wind and in height. */
static enum wf_status plot_data(const struct wf_series_page *page, const char *folder, struct wf_err *e)
{
    struct wf_plot_data p;
    enum wf_status s = wf_plot_data_begin(&p, folder, "run", e);
    if (s) return s;
    wf_plot_data_count(&p, "RUNS", 0, page->n);
    for (size_t r = 0; r < page->n; r++) plot_run(&p, page->run[r].series, r + 1);
    plot_sweep(page, &p);
    if (page->explained) wf_explain_plot_data(page->explain, page->explained, &p);
    return wf_plot_data_end(&p, e);
}

static void deflections(const struct wf_series *s, double *wind, double *mean, double *most)
{
    double sum = 0, n = 0;
    *wind = *most = 0;
    for (size_t k = 0; k < s->frames; k++) {
        *wind += s->wind[k] / (double)s->frames;
        if (isfinite(s->deflection[k])) sum += s->deflection[k], *most = fmax(*most, s->deflection[k]), n++;
    }
    *mean = sum / n;
}

/* Of all frames; NAN: not known. */
static double least_safety(const struct wf_series *s)
{
    double least = NAN;
    for (size_t k = 0; k < s->frames; k++) least = fmin(least, s->safety[k]);
    return least;
}

static json_t *run_part(struct wf_doc *d, const struct wf_series *s)
{
    double wind, mean, most;
    deflections(s, &wind, &mean, &most);
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "name", s->spec.name);
    wf_doc_text(d, o, "species", s->spec.species->key);
    wf_doc_text(d, o, "species_name", s->spec.species->name);
    wf_doc_text(d, o, "species_zh", s->spec.species->name_zh);
    wf_doc_text(d, o, "model", s->spec.model->key);
    wf_doc_text(d, o, "model_name", s->spec.model->name);
    wf_doc_text(d, o, "preset", s->spec.preset->name);
    wf_doc_text(d, o, "solver", s->spec.solver->name);
    wf_doc_text(d, o, "gust", s->spec.gust);
    if (s->spec.gust) wf_doc_count(d, o, "seed", s->spec.seed);
    wf_doc_count(d, o, "components", s->across ? 3 : 1);
    wf_doc_text(d, o, "shelter", s->spec.shelter ? s->spec.shelter->name : NULL);
    wf_doc_text(d, o, "profile", s->an.scenario.profile);
    wf_doc_count(d, o, "frames", s->frames);
    wf_doc_count(d, o, "keys", s->spec.keys);
    wf_doc_number(d, o, "wind_mean_m_s", wind);
    wf_doc_number(d, o, "youngs_modulus_Pa", s->an.tree.youngs[0]);
    wf_doc_number(d, o, "tip_deflection_mean_m", mean);
    wf_doc_number(d, o, "tip_deflection_largest_m", most);
    wf_doc_number(d, o, "height_m", s->an.tallness);
    wf_doc_number(d, o, "safety_least", least_safety(s));
    wf_doc_number(d, o, "breaks_at_s", s->broken < s->frames ? (double)s->broken * s->spec.step : NAN);
    json_t *list = wf_doc_put(d, o, "levels", wf_doc_array(d));
    for (size_t k = 0; k < s->levels; k++) {
        const struct wf_series_level *l = &s->level[k];
        json_t *q = wf_doc_add(d, list, wf_doc_object(d));
        wf_doc_count(d, q, "axes", l->axes);
        wf_doc_number(d, q, "mean_m", l->swing_mean);
        wf_doc_number(d, q, "largest_m", l->swing_most);
        wf_doc_number(d, q, "own_m", l->own_mean);
        wf_doc_number(d, q, "windward_m", l->windward);
        wf_doc_number(d, q, "leeward_m", l->leeward);
        wf_doc_number(d, q, "own_windward_m", l->own_windward);
        wf_doc_number(d, q, "own_leeward_m", l->own_leeward);
    }
    return o;
}

/* Figures of key frames, time series, leaves and compared methods, as far as the runs contain them. */
static void figures(struct wf_doc *d, json_t *list, const struct wf_series_page *p)
{
    bool course = false, single = false, leafy = false;
    size_t swept;
    char name[32];
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        course |= s->frames > 1, single |= s->spec.keys == 1, leafy |= s->frames > 1 && s->leaves.n > 0;
    }
    if (single && largest_sweep(p, &swept)) wf_doc_figure(d, list, "modulus", "modulus", 0);
    if (single) wf_doc_figure(d, list, "frames_all", "frames", 0);
    for (size_t r = 0; r < p->n; r++) {
        if (p->run[r].series->spec.keys < 2) continue;
        snprintf(name, sizeof name, "frames_%zu", r + 1);
        wf_doc_figure(d, list, name, "frames", r + 1);
    }
    if (course) wf_doc_figure(d, list, "series", "series", 0);
    if (leafy) wf_doc_figure(d, list, "leaf_angles", "leaf_angles", 0);
    for (size_t i = 0; i < p->explained; i++) wf_explain_figure(d, list, &p->explain[i]);
}

static enum wf_status document(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    struct wf_doc_head head = {
        .title = p->title, .note = p->note, .command = p->command, .version = p->version, .date = p->date
    };
    struct wf_doc d = { 0 };
    size_t swept;
    for (size_t i = 0; i < p->n; i++) {
        wf_doc_head_file(&head, "model", p->run[i].series->spec.model->file);
        wf_doc_head_file(&head, "species", p->run[i].series->spec.species->file);
        wf_doc_head_file(&head, "data", p->run[i].series->spec.gust_file);
    }
    json_t *o = wf_doc_begin(&d, "windfirm-series", &head);
    json_t *runs = wf_doc_put(&d, o, "runs", wf_doc_array(&d));
    for (size_t r = 0; r < p->n; r++) wf_doc_add(&d, runs, run_part(&d, p->run[r].series));
    if (largest_sweep(p, &swept)) {
        const struct wf_series *s = p->run[swept].series;
        json_t *q = wf_doc_put(&d, o, "sweep", wf_doc_object(&d));
        wf_doc_text(&d, q, "species_name", s->spec.species->name);
        wf_doc_number(&d, q, "speed_m_s", s->spec.speed);
    }
    json_t *explained = wf_doc_put(&d, o, "explained", wf_doc_array(&d));
    for (size_t i = 0; i < p->explained; i++) wf_doc_add(&d, explained, wf_explain_part(&d, &p->explain[i]));
    json_t *warnings_list = wf_doc_put(&d, o, "warnings", wf_doc_array(&d));
    for (size_t r = 0; r < p->n; r++) wf_doc_warnings(&d, warnings_list, p->run[r].diag);
    figures(&d, wf_doc_put(&d, o, "figures", wf_doc_array(&d)), p);
    return wf_doc_end(&d, o, folder, e);
}

enum wf_status wf_series_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(const struct wf_series_page *p, FILE *f);
    } table[] = { { "tables/series.csv", series },     { "tables/frames.csv", frames },
                  { "tables/levels.csv", levels },     { "tables/runs.csv", runs },
                  { "tables/warnings.csv", warnings }, { "tables/trajectories.csv", trajectories } };
    enum wf_status status = wf_folder_make(folder, e);
    for (size_t i = 0; i < sizeof table / sizeof *table && !status; i++) {
        struct wf_file f = { 0 };
        if ((status = wf_folder_begin(&f, folder, table[i].name, e))) break;
        table[i].write(p, f.stream);
        status = wf_file_commit(&f, e);
    }
    if (!status) status = plot_data(p, folder, e);
    if (!status) status = leaf_tables(p, folder, e);
    if (!status && p->explained) status = wf_explain_tables(p->explain, p->explained, folder, e);
    return status ? status : document(p, folder, e);
}

/* Frames as VTK poly data and their index in time (Kitware, VTK file formats). */
enum { FRAMES_MOST = 60 };

static void vtk_array(FILE *f, const char *name, const char *type, int parts)
{
    fprintf(f, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n", type, name,
            parts);
}

static void vtk_frame(FILE *f, const struct wf_series *s, size_t k)
{
    const struct wf_tree *t = &s->an.tree;
    const double *p = s->place + k * 3 * t->n;
    fprintf(
        f,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<PolyData><Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"0\" NumberOfLines=\"%zu\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Scalars=\"radius\" "
        "Vectors=\"displacement\">\n",
        2 * t->n, t->n);
    vtk_array(f, "radius", "Float32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%.5g %.5g\n", t->r0[i], t->r1[i]);
    fputs("</DataArray>\n", f);
    vtk_array(f, "displacement", "Float32", 3);
    for (size_t i = 0; i < t->n; i++) {
        int32_t b = t->parent[i];
        double low[3] = { 0 };
        if (b >= 0)
            low[0] = p[3 * b] - t->x1[b], low[1] = p[3 * b + 1] - t->y1[b], low[2] = p[3 * b + 2] - t->z1[b];
        fprintf(f, "%.6g %.6g %.6g %.6g %.6g %.6g\n", low[0], low[1], low[2], p[3 * i] - t->x1[i],
                p[3 * i + 1] - t->y1[i], p[3 * i + 2] - t->z1[i]);
    }
    fputs("</DataArray>\n</PointData>\n<CellData Scalars=\"level\">\n", f);
    vtk_array(f, "level", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%d\n", (int)t->level[i]);
    fputs("</DataArray>\n</CellData>\n<Points>\n", f);
    vtk_array(f, "points", "Float32", 3);
    for (size_t i = 0; i < t->n; i++) {
        int32_t b = t->parent[i];
        if (b >= 0)
            fprintf(f, "%.7g %.7g %.7g ", p[3 * b], p[3 * b + 1], p[3 * b + 2]);
        else
            fprintf(f, "%.7g %.7g %.7g ", t->x0[i], t->y0[i], t->z0[i]);
        fprintf(f, "%.7g %.7g %.7g\n", p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    }
    fputs("</DataArray>\n</Points>\n<Lines>\n", f);
    vtk_array(f, "connectivity", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%zu %zu\n", 2 * i, 2 * i + 1);
    fputs("</DataArray>\n", f);
    vtk_array(f, "offsets", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%zu\n", 2 * i + 2);
    fputs("</DataArray>\n</Lines>\n</Piece></PolyData>\n</VTKFile>\n", f);
}

static enum wf_status vtk_run(const struct wf_series *s, size_t run, const char *folder, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    size_t every = (s->frames + FRAMES_MOST - 1) / FRAMES_MOST;
    struct wf_file index = { 0 };
    snprintf(path, sizeof path, "%.4000s/vtk/run%zu.pvd", folder, run);
    enum wf_status status = wf_file_begin(&index, path, e);
    if (status) return status;
    fputs(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n",
        index.stream);
    for (size_t k = 0; k < s->frames && !status; k += every) {
        struct wf_file f = { 0 };
        snprintf(path, sizeof path, "%.4000s/vtk/run%zu_%05zu.vtp", folder, run, k);
        if ((status = wf_file_begin(&f, path, e))) break;
        vtk_frame(f.stream, s, k);
        status = wf_file_commit(&f, e);
        fprintf(index.stream,
                "<DataSet timestep=\"%.7g\" group=\"\" part=\"0\" file=\"run%zu_%05zu.vtp\"/>\n",
                (double)k * s->spec.step, run, k);
    }
    fputs("</Collection>\n</VTKFile>\n", index.stream);
    if (!status) status = wf_file_commit(&index, e);
    wf_file_abandon(&index);
    return status;
}

enum wf_status wf_series_vtk(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    snprintf(path, sizeof path, "%.4000s/vtk", folder);
    enum wf_status status = wf_mkdirs(path, e);
    for (size_t r = 0; r < p->n && !status; r++) status = vtk_run(p->run[r].series, r + 1, folder, e);
    return status;
}
