#include "fit/build.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* Who wants to know the row of a place. */
struct place {
    struct wf_fit_place at;
    int32_t *row;
};
enum { PLACES = 64 };

static enum wf_status place(struct place *list, size_t *n, double at, bool along, int32_t *row,
                            const char *tree, struct wf_err *e)
{
    if (*n == PLACES) return wf_fail(e, WF_EINPUT, "tree %s: more than %d places", tree, (int)PLACES);
    list[(*n)++] = (struct place){ { at, along }, row };
    return WF_OK;
}

/* Cut a tree where its tests pull and measure, and tell them the rows. */
static enum wf_status cut(const struct wf_fit_build *b, struct wf_experiment *x, size_t tree,
                          struct wf_arena *a, struct wf_err *e)
{
    struct place list[PLACES];
    struct wf_fit_place at[PLACES] = { { 0 } };
    int32_t row[PLACES];
    size_t n = 0;
    struct wf_fit_tree *t = &x->tree[tree];
    enum wf_status status = WF_OK;
    for (size_t k = 0; k < x->tests && !status; k++) {
        struct wf_fit_test *q = &x->test[k];
        if (q->tree != tree) continue;
        if (q->load == WF_FIT_PULL)
            status = place(list, &n, b->study->test[k].pull.height, false, &q->pull_row, t->name, e);
        bool places = b->study->test[k].along != NULL;
        for (size_t s = 0; places && s < q->states && !status; s++)
            status = place(list, &n, q->state[s].load, true, &q->state[s].row, t->name, e);
        for (size_t s = 0; s < q->sensors && !status; s++) {
            struct wf_fit_sensor *w = &q->sensor[s];
            bool gauge = w->kind == WF_SENSOR_STRAIN || w->kind == WF_SENSOR_EXTENSION;
            if (gauge && t->tree.section)
                return wf_fail(e, WF_EINPUT,
                               "%s: test %s: %s: strain is not computed for a stem with 'sections'",
                               b->study->file, q->name, w->name);
            if (!wf_sensor_rows[w->kind].placed || places) continue;
            status = place(list, &n, w->height + (gauge ? 0.5 * w->gauge : 0), w->along, &w->row, t->name, e);
            if (gauge && !status)
                status =
                    place(list, &n, fmax(w->height - 0.5 * w->gauge, 0), w->along, &w->low_row, t->name, e);
        }
    }
    for (size_t k = 0; k < n; k++) at[k] = list[k].at;
    struct wf_err why = { 0 };
    if (!status && wf_fit_divide(&t->tree, t->size / 40, at, n, row, a, &why))
        return wf_fail(e, why.code, "%s: tree %s: %s", b->study->file, t->name, why.text);
    for (size_t k = 0; k < n && !status; k++) *list[k].row = row[k];
    return status;
}

enum wf_status wf_fit_build(const struct wf_fit_build *b, struct wf_arena *a, struct wf_diag *d,
                            struct wf_experiment *x, struct wf_fit_input *in, struct wf_err *e)
{
    const struct wf_fit_study *s = b->study;
    size_t used = 0, room = 0;
    *x = (struct wf_experiment){ .trees = s->trees, .tests = s->tests };
    x->tree = WF_TAKE(a, s->trees, struct wf_fit_tree), x->test = WF_TAKE(a, s->tests, struct wf_fit_test);
    if (!x->tree || !x->test) return wf_fail(e, WF_ENOMEM, "%s: no room", s->file);
    enum wf_status status = WF_OK;
    for (size_t k = 0; k < s->trees && !status; k++) status = wf_fit_build_tree(b, k, a, d, &x->tree[k], e);
    for (size_t k = 0; k < s->tests && !status; k++) {
        const char *named = s->test[k].data;
        bool wants = s->test[k].along ||
                     (!b->plan && (s->test[k].pull.given || s->test[k].wind.given || s->test[k].sway.given));
        if (wants && !named && used < b->datas) named = b->data[used++];
        if (wants && !named)
            return wf_fail(e, WF_EUSAGE, "%s: test %s names no data; give it with --data FILE", s->file,
                           s->test[k].name);
        struct wf_fit_datum *data = NULL;
        size_t n = 0;
        status = wf_fit_build_test(b, k, wants ? named : NULL, a, d, &x->test[k], &in[k], &data, &n, e);
        if (status) break;
        if (x->data + n > room) {
            room = 2 * (x->data + n);
            struct wf_fit_datum *more = WF_TAKE(a, room, struct wf_fit_datum);
            if (!more) return wf_fail(e, WF_ENOMEM, "%s: no room for its data", s->file);
            if (x->data) memcpy(more, x->datum, x->data * sizeof *more);
            x->datum = more;
        }
        for (size_t i = 0; i < n; i++) {
            data[i].test = k;
            x->datum[x->data++] = data[i];
        }
    }
    if (!status && used < b->datas)
        return wf_fail(e, WF_EUSAGE, "--data: '%s' is not needed: every test of %s names its own data",
                       b->data[used], s->file);
    for (size_t k = 0; k < s->trees && !status; k++) status = cut(b, x, k, a, e);
    for (size_t k = 0; k < s->trees && !status; k++) status = wf_tree_check(&x->tree[k].tree, d, e);
    return status;
}

static enum wf_status bound(struct wf_units *u, const struct wf_fit_study *s, const struct wf_fit_param *p,
                            const char *key, const char *text, double *value, struct wf_err *e)
{
    struct wf_err why = { 0 };
    const struct wf_fit_quantity_row *r = &wf_fit_quantities[p->quantity];
    if (!text || !wf_quantity_read_as(u, text, r->dimension, r->unit, value, &why)) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: free: %s: %s: %s", s->file, p->name, key, why.text);
}

enum wf_status wf_fit_params(const struct wf_fit_study *s, const char *names, const struct wf_experiment *x,
                             bool plan, struct wf_arena *a, struct wf_fit_param **out, size_t *n,
                             struct wf_err *e)
{
    struct wf_units *u;
    char *list = names ? wf_arena_text(a, names) : NULL, *rest = NULL;
    size_t count = s->frees;
    for (const char *c = names; c && *c; c++) count += *c == ',';
    *n = 0;
    *out = WF_TAKE(a, (count + 1) * x->trees + wf_param_nuisances(x), struct wf_fit_param);
    if (!*out || (names && !list)) return wf_fail(e, WF_ENOMEM, "%s: no room for parameters", s->file);
    enum wf_status status = WF_OK;
    for (char *p = list ? strtok_r(list, ", ", &rest) : NULL; p && !status; p = strtok_r(NULL, ", ", &rest))
        status = wf_param_add(x, p, a, *out, n, e);
    if (!status) status = wf_units_open(&u, e);
    if (status) return status;
    /* limits of the study also hold for a parameter named on the command line */
    for (size_t k = 0; k < s->frees && !status; k++) {
        size_t from = *n, to;
        if (!names) status = wf_param_add(x, s->free[k].parameter, a, *out, n, e);
        to = *n;
        for (size_t i = names ? 0 : from; i < to && !status; i++) {
            struct wf_fit_param *p = &(*out)[i];
            if (names && strcmp(p->name, s->free[k].parameter) != 0) continue;
            double table = p->start;
            status = bound(u, s, p, "start", s->free[k].start, &p->start, e);
            if (plan) p->start = table;
            if (!status) status = bound(u, s, p, "low", s->free[k].low, &p->low, e);
            if (!status) status = bound(u, s, p, "high", s->free[k].high, &p->high, e);
            if (!status && wf_fit_quantities[p->quantity].log && !(p->low > 0 && p->start > 0))
                status = wf_fail(e, WF_EINPUT, "%s: free: %s: start and bounds must be above zero", s->file,
                                 p->name);
        }
    }
    wf_units_close(u);
    return status ? status : wf_param_add_nuisance(x, a, *out, n, e);
}
