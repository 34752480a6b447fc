/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_IFS_H
#define WF_DATA_IFS_H
/* An iterated function system (IFS) that generates a tree: its maps, their schema, and the check that each
 * map is a contraction. */
#include "base/yaml.h"
#include <stddef.h>

enum wf_ifs_form {
    WF_IFS_MONOPODIAL,       /* the axis continues; all copies start below its tip                 */
    WF_IFS_SYMPODIAL,        /* the tip dies; one copy, at the tip, continues the axis             */
    WF_IFS_FALSE_DICHOTOMOUS /* the tip dies; every map gives two copies opposite each other, those at
                                the tip are the fork                                               */
};

/* A map x -> a x + b, in units of the parent's axis, which runs from 0 to (0, 0, 1). */
struct wf_ifs_map {
    const char *name;
    double position, scale, inclination, azimuth, roll; /* [-], [-], [rad]; with `matrix` only position */
    double radius;                                      /* base radius over the parent's base radius */
    size_t until;                                       /* last level on which the map acts          */
    double *matrix;    /* a and b as given, three rows of four; NULL: made of position, scale and angles */
    size_t cells;      /* numbers in `matrix`                   */
    double a[9], b[3]; /* row by row                            */
    double factor;     /* largest stretch: spectral norm of a */
};

struct wf_ifs {
    enum wf_ifs_form form;
    size_t levels; /* the stem included */
    size_t maps;
    struct wf_ifs_map *map;
};

/* Spectral norm of a 3x3 matrix (row by row): the largest factor by which it stretches a vector. Returned:
 * INFINITY when it cannot be computed. */
double wf_stretch(const double a[9]);
/* Similarity dimension D of the maps that act on every level: sum of factor^D = 1 (Moran 1946). An upper
 * bound for maps that stretch directions unequally. 0 for fewer than two maps. */
double wf_ifs_dimension(const struct wf_ifs *f);

extern const struct wf_yaml_table wf_ifs_table; /* struct wf_ifs */
#endif
