/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_BARK_H
#define WF_DATA_BARK_H
/* Bark on the stem: how thick it is, by species or as measured. */
#include "base/err.h"
#include "data/law.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_yaml_table;

extern const struct wf_yaml_table wf_bark_table; /* struct wf_bark_law */

enum wf_bark_kind {
    WF_BARK_BY_TREE, /* nothing is said: by species on a measured tree, else none */
    WF_BARK_NONE,
    WF_BARK_SPECIES,
    WF_BARK_MEASURED,
    WF_BARK_ASSUMED /* by the program, of a species of which nothing is known */
};
/* What is said of a tree's bark. */
struct wf_bark_said {
    enum wf_bark_kind kind;
    double thickness; /* measured or assumed, at 1.3 m above the ground, of one side [m] */
};

/* Thickness of the bark of one side where the stem has that diameter over bark, both [m]. Below 10 cm, where
 * the laws were not fitted, the bark's share of the diameter is that at 10 cm; beyond the maximum of the law
 * it is held. At most a third of the radius. */
double wf_bark_by_law(const struct wf_bark_law *law, double diameter);

/* Read "species", "none" or a thickness such as "15 mm". Returned: false after a mistake; *why says what is
 * allowed. */
bool wf_bark_read(const char *text, struct wf_bark_said *out, struct wf_err *why);
#endif
