/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "load/interception.h"
#include <string.h>

const struct wf_storage wf_storages[] = {
    { "watergap", "0.3 mm per leaf area index, of the hydrological model WaterGAP", 0.3 },
    { "simulator-least",
      "least of 20 species in a rain simulator, film on plant surface, Bradford pear: US Forest Service, "
      "McPherson, Xiao "
      "et al.",
      0.51 },
    { "simulator-most", "most of them, blue spruce", 1.81 },
    { "dipped", "leaves of ten species, Qingdao: 0.12 to 0.19 mm; twigs hold as much again", 0.19 },
    { 0 },
};

const struct wf_storage *wf_storage_named(const char *name)
{
    for (const struct wf_storage *s = wf_storages; s->name; s++)
        if (!strcmp(s->name, name)) return s;
    return NULL;
}

double wf_tree_leaf_area(const struct wf_tree *t)
{
    double sum = 0;
    for (size_t i = 0; i < t->n; i++) sum += 0.5 * (t->leaf0[i] + t->leaf1[i]) * wf_tree_length(t, i);
    return sum;
}

double wf_leaves_of_sail(struct wf_tree *t, double drag_coefficient, double frontal_share)
{
    for (size_t i = 0; i < t->n; i++) {
        t->leaf0[i] = t->sail0[i] / (drag_coefficient * frontal_share);
        t->leaf1[i] = t->sail1[i] / (drag_coefficient * frontal_share);
    }
    return wf_tree_leaf_area(t);
}

double wf_intercept(struct wf_tree *t, double film)
{
    for (size_t i = 0; i < t->n; i++)
        t->burden0[i] += film * t->leaf0[i], t->burden1[i] += film * t->leaf1[i];
    return film * wf_tree_leaf_area(t);
}
