#include "base/file.h"
#include "out/series_parts.h"
#include <math.h>
#include <string.h>

double wf_series_along(const struct wf_series *s, const double x[3])
{
    const double *to = s->an.wind.direction;
    return to[0] * x[0] + to[1] * x[1];
}

/* To the left of the wind. */
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

void wf_series_number(FILE *f, double x)
{
    fputc(',', f);
    if (isfinite(x)) fprintf(f, "%.7g", x);
}

static void series(const struct wf_series_page *p, FILE *f)
{
    fputs("run,frame,time_s,wind_m_s,tip_deflection_m,tip_along_m,tip_z_m,base_moment_N_m,wind_across_m_s,"
          "wind_up_m_s,tip_across_m\n",
          f);
    for (size_t r = 0; r < p->n; r++) {
        const struct wf_series *s = p->run[r].series;
        for (size_t k = 0; k < s->frames; k++) {
            double x[3];
            end_of(s, k, s->tip, x);
            fprintf(f, "%zu,%zu,%.7g", r + 1, k, (double)k * s->spec.step);
            wf_series_number(f, s->wind[k]), wf_series_number(f, s->deflection[k]),
                wf_series_number(f, wf_series_along(s, x)), wf_series_number(f, x[2]);
            wf_series_number(f, s->moment[k]), wf_series_number(f, s->across ? s->across[k] : 0);
            wf_series_number(f, s->up ? s->up[k] : 0), wf_series_number(f, across(s, x));
            fputc('\n', f);
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
                fprintf(f, "%zu,%zu,%.6g,%.6g,%lld,%d,%.5g,%.6g,%.6g,%.6g,%.6g\n", r + 1, k,
                        k ? (double)frame * s->spec.step : 0, k ? s->wind[frame] : 0, (long long)t->id[i],
                        (int)t->level[i], 0.5 * (t->r0[i] + t->r1[i]), wf_series_along(s, a), a[2],
                        wf_series_along(s, b), b[2]);
            }
    }
}

static void levels(const struct wf_series_page *p, FILE *f)
{
    fputs("run,level,axes,amplitude_mean_m,amplitude_largest_m,amplitude_own_mean_m,amplitude_windward_m,"
          "amplitude_leeward_m\n",
          f);
    for (size_t r = 0; r < p->n; r++)
        for (size_t k = 0; k < p->run[r].series->levels; k++) {
            const struct wf_series_level *l = &p->run[r].series->level[k];
            fprintf(f, "%zu,%zu,%zu", r + 1, k, l->axes);
            wf_series_number(f, l->swing_mean), wf_series_number(f, l->swing_most),
                wf_series_number(f, l->own_mean);
            wf_series_number(f, l->windward), wf_series_number(f, l->leeward);
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
static void file(FILE *f, const char *path)
{
    char hash[WF_SHA256_TEXT] = "";
    struct wf_err unread = { 0 };
    fputc(',', f);
    text(f, path ? path : "");
    if (path && wf_sha256_file(path, hash, &unread)) hash[0] = '\0';
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
        wf_series_number(f, s->an.tree.youngs[0]);
        fprintf(f, ",%s,%llu,%zu,%.6g", s->spec.shelter ? s->spec.shelter->name : "none",
                (unsigned long long)s->spec.seed, s->frames, s->spec.step);
        wf_series_number(f, sum / n), wf_series_number(f, most), wf_series_number(f, low),
            wf_series_number(f, high), wf_series_number(f, wind);
        fprintf(f, ",%d,", s->across ? 3 : 1);
        text(f, s->gust_words ? s->gust_words : "");
        file(f, s->spec.gust_file);
        fprintf(f, ",%s", s->an.scenario.profile);
        file(f, s->an.scenario.profile_file);
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

/* gnuplot's own quoting */
static void quoted(FILE *f, const char *words)
{
    fputc('\'', f);
    for (; *words; words++) {
        if (*words == '\'') fputc('\'', f);
        fputc(*words, f);
    }
    fputc('\'', f);
}

/* What the figure scripts need to know: names, key frames, extent along the wind and in height. */
static void plot_facts(const struct wf_series_page *p, FILE *f)
{
    fprintf(f, "# What the figure scripts need to know about these runs; written by windfirm.\nRUNS = %zu\n",
            p->n);
    const char *const name[] = { "NAME",  "KEYS", "FRAMES", "HEIGHT_M", "LEFT",
                                 "RIGHT", "TOP",  "LEAVES", "STEP" };
    for (size_t c = 0; c < sizeof name / sizeof *name; c++) {
        fprintf(f, "array %s[%zu] = [", name[c], p->n);
        for (size_t r = 0; r < p->n; r++) {
            const struct wf_series *s = p->run[r].series;
            const struct wf_tree *t = &s->an.tree;
            double left = 0, right = 0, top = 0;
            for (size_t k = 0; k < s->spec.keys; k++)
                for (size_t i = 0; i < t->n; i++) {
                    double x[3], rest[3] = { t->x1[i], t->y1[i], t->z1[i] };
                    end_of(s, s->key[k], i, x);
                    left = fmin(left, fmin(wf_series_along(s, x), wf_series_along(s, rest)));
                    right = fmax(right, fmax(wf_series_along(s, x), wf_series_along(s, rest)));
                    top = fmax(top, fmax(x[2], rest[2]));
                }
            const double value[] = {
                0,   (double)s->spec.keys, (double)s->frames, s->an.tallness, left, right,
                top, (double)s->leaves.n,  s->spec.step
            };
            if (r) fputs(", ", f);
            if (c)
                fprintf(f, "%.6g", value[c]);
            else
                quoted(f, s->spec.name);
        }
        fputs("]\n", f);
    }
    fprintf(f, "array MOTION[%zu] = [", p->n);
    for (size_t r = 0; r < p->n; r++)
        fprintf(f, r ? ", '%s'" : "'%s'", p->run[r].series->spec.leaf_motion->name);
    fprintf(f, "]\narray LEVELS[%zu] = [", p->n);
    for (size_t r = 0; r < p->n; r++) fprintf(f, r ? ", %zu" : "%zu", p->run[r].series->levels);
    for (int c = 0; c < 2; c++) {
        fprintf(f, "]\n# of the key frames\narray %s[%zu] = [", c ? "WINDS" : "TIMES", p->n);
        for (size_t r = 0; r < p->n; r++) {
            const struct wf_series *s = p->run[r].series;
            fputs(r ? ", \"" : "\"", f);
            for (size_t k = 0; k < s->spec.keys; k++)
                fprintf(f, "%.3g ", c ? s->wind[s->key[k]] : (double)s->key[k] * s->spec.step);
            fputc('"', f);
        }
    }
    fputs("]\n", f);
    wf_series_sweep_facts(p, f);
}

enum wf_status wf_series_begin(struct wf_file *f, const char *folder, const char *name, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    int n = snprintf(path, sizeof path, "%s/%s", folder, name);
    if (n < 0 || (size_t)n >= sizeof path)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    return wf_file_begin(f, path, e);
}

enum wf_status wf_series_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        void (*write)(const struct wf_series_page *p, FILE *f);
    } table[] = { { "tables/series.csv", series },     { "tables/frames.csv", frames },
                  { "tables/levels.csv", levels },     { "tables/runs.csv", runs },
                  { "tables/warnings.csv", warnings }, { "tables/trajectories.csv", trajectories },
                  { "plots/run.gp", plot_facts } };
    static const char *const room[] = { "tables", "plots" };
    enum wf_status status = WF_OK;
    for (size_t i = 0; i < 2 && !status; i++) {
        char path[WF_PATH_MAX];
        snprintf(path, sizeof path, "%.4000s/%s", folder, room[i]);
        status = wf_mkdirs(path, e);
    }
    for (size_t i = 0; i < sizeof table / sizeof *table && !status; i++) {
        struct wf_file f = { 0 };
        if ((status = wf_series_begin(&f, folder, table[i].name, e))) break;
        table[i].write(p, f.stream);
        status = wf_file_commit(&f, e);
    }
    if (!status) status = wf_series_leaf_tables(p, folder, e);
    return status || !p->explained ? status : wf_explain_tables(p->explain, p->explained, folder, e);
}
