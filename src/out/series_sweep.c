/* Runs that differ in the modulus alone: a sweep, to be drawn as one curve. */
#include "out/series_parts.h"
#include <string.h>

static bool differ_in_modulus(const struct wf_series *a, const struct wf_series *b)
{
    return a->frames == 1 && b->frames == 1 && !strcmp(a->spec.species->key, b->spec.species->key) &&
           !strcmp(a->spec.model->key, b->spec.model->key) && a->spec.solver == b->spec.solver &&
           a->spec.speed == b->spec.speed && a->an.tree.youngs[0] != b->an.tree.youngs[0];
}

static size_t count(const struct wf_series_page *p, size_t r)
{
    size_t n = 1;
    for (size_t k = 0; k < p->n; k++) n += differ_in_modulus(p->run[r].series, p->run[k].series);
    return n;
}

size_t wf_series_sweep(const struct wf_series_page *p, size_t *first)
{
    size_t most = 0;
    for (size_t r = 0; r < p->n; r++) {
        size_t n = count(p, r);
        if (n > most) most = n, *first = r;
    }
    return most >= 3 ? most : 0;
}

void wf_series_sweep_facts(const struct wf_series_page *p, struct wf_plot_data *to)
{
    size_t first = 0, n = 0;
    if (!wf_series_sweep(p, &first)) return;
    const struct wf_series *s = p->run[first].series;
    for (size_t r = 0; r < p->n; r++)
        if (r == first || differ_in_modulus(s, p->run[r].series)) wf_plot_data_count(to, "SWEPT", ++n, r + 1);
}
