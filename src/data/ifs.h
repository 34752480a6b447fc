/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_IFS_H
#define WF_DATA_IFS_H
/* An iterated function system that makes a tree: its maps, their schema and what makes them contractive. */
#include "base/yaml.h"
#include <stddef.h>

enum wf_ifs_form {
    WF_IFS_MONOPODIAL,       /* the axis goes on; every map stands below its tip                   */
    WF_IFS_SYMPODIAL,        /* the tip dies; one map at the tip takes over                        */
    WF_IFS_FALSE_DICHOTOMOUS /* the tip dies; every map stands for two, opposite each other, those at
                                the tip make the fork                                              */
};

/* x -> a x + b in units of the parent's axis, which runs from 0 to (0, 0, 1). */
struct wf_ifs_map {
    const char *name;
    double position, scale, inclination, azimuth, roll;
    double radius; /* base radius over the parent's base radius */
    size_t until;  /* last level on which the map acts          */
    double *matrix;
    size_t cells;
    double a[9], b[3];
    double factor; /* largest stretch: spectral norm of a */
};

struct wf_ifs {
    enum wf_ifs_form form;
    size_t levels; /* the stem included */
    size_t maps;
    struct wf_ifs_map *map;
};

/* Largest stretch of a linear map of space (row by row), its spectral norm. */
double wf_stretch(const double a[9]);
/* Similarity dimension D of the maps that act on every level: sum of factor^D = 1 (Moran 1946; for maps that
 * stretch unequally an upper bound). 0 for fewer than two maps. */
double wf_ifs_dimension(const struct wf_ifs *f);

extern const struct wf_yaml_table wf_ifs_table; /* struct wf_ifs */
#endif
