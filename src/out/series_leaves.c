/* Leaves in tables: where they are in the key frames, and their own angles in every frame. */
#include "out/series_parts.h"
#include <math.h>

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
                fprintf(f, "%zu,%zu,%zu,%.6g,%.6g,%.6g,%.6g\n", r + 1, k + 1, i + 1,
                        wf_series_along(s, at + 3 * i), at[3 * i + 2], wf_series_along(s, tip + 3 * i),
                        tip[3 * i + 2]);
        }
        wf_arena_free(&scratch);
        if (!at || !tip) return wf_fail(e, WF_ENOMEM, "no room for %zu leaves", s->leaves.n);
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
            wf_series_number(f, s->wind[k]);
            fprintf(f, ",%zu,%lld", leaf + 1, (long long)s->an.tree.id[s->leaves.row[leaf]]);
            for (const struct wf_leaf_motion *m = wf_leaf_motions; m->name; m++)
                for (int j = 0; j < 3 && m->angles[j]; j++)
                    wf_series_number(f, m == s->spec.leaf_motion ? angle[j] * degree : NAN);
            fputc('\n', f);
        }
    }
    return WF_OK;
}

enum wf_status wf_series_leaf_tables(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    static const struct {
        const char *name;
        enum wf_status (*write)(const struct wf_series_page *p, FILE *f, struct wf_err *e);
    } table[] = { { "tables/leaves.csv", leaves }, { "tables/leaf_angles.csv", angles } };
    enum wf_status status = WF_OK;
    for (size_t i = 0; i < 2 && !status; i++) {
        struct wf_file f = { 0 };
        status = wf_series_begin(&f, folder, table[i].name, e);
        if (!status) status = table[i].write(p, f.stream, e);
        if (!status) status = wf_file_commit(&f, e);
        wf_file_abandon(&f);
    }
    return status;
}
