/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_ANCHORAGE_H
#define WF_FAIL_ANCHORAGE_H
/* How large a moment the root carries before the tree overturns: methods as rows. docs/failure.md derives
 * them. The criterion 'overturning' compares it with the moment on the ground. */
#include "base/arena.h"
#include "base/err.h"
#include "data/tree.h"
#include <stdbool.h>
#include <stddef.h>

struct wf_species;

/* Ground that the roots are in. */
struct wf_soil {
    const char *name, *text;
    bool known;
};
extern const struct wf_soil wf_soils[]; /* ends at name == NULL */

struct wf_tipping_curve; /* base moment by the inclination of the root plate, read from a file */
struct wf_anchorage_table;

/* What is said of soil and root; NULL, NAN: not given. */
struct wf_anchorage_request {
    const char *method;  /* row of wf_anchorage_methods; NULL: by size where the soil is known */
    const char *soil;    /* row of wf_soils */
    const char *rooting; /* "shallow", "medium" or "deep"; of a table */
    double pull_moment;  /* moment on the ground at 0.25 deg of the root plate [N m] */
    double secant;       /* that moment over that angle [N m rad-1] */
    const struct wf_tipping_curve *curve;
    const struct wf_anchorage_table *table;
};

struct wf_anchorage;
struct wf_anchorage_method {
    const char *name, *title, *source, *validity;
    double scatter; /* standard deviation of the logarithm of the moment; NAN: not known, or by species */
    bool counts_self_weight; /* the moment includes what the leaning tree's weight adds; else it is the
                                applied one, and a demand that includes weight is on the safe side */
    /* Returned: moment, scatter and text of *out; moment NAN where the method has nothing for this tree.
     * Errors: WF_EINPUT where what is given does not fit. */
    enum wf_status (*find)(const struct wf_anchorage_request *q, const struct wf_tree *t,
                           const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                           struct wf_err *e);
};
extern const struct wf_anchorage_method wf_anchorage_methods[]; /* ends at name == NULL */

/* The reason where nothing is said of soil and root. */
#define WF_ANCHORAGE_UNSAID "soil and anchorage unknown"

/* The anchorage of one tree. */
struct wf_anchorage {
    const struct wf_anchorage_method *method; /* NULL: overturning is not assessed */
    double moment;  /* largest moment on the ground that the root carries, as tested or by size [N m]; NAN */
    double scatter; /* standard deviation of its logarithm; NAN: not known */
    const char *text; /* what it was computed from; or why overturning is not assessed */
};

/* Near saturation the largest moment is 35 to 50 % lower (camphor, one study): what is left of it. */
#define WF_SATURATED_HIGH 0.65
#define WF_SATURATED_LOW 0.50

/* Find the anchorage of a tree. Given: what is said of it (NULL: nothing), the tree as grown, its species.
 * Returned: *out; where the anchorage is not known, method NULL and the reason. Errors: WF_EUSAGE, WF_EINPUT,
 * WF_ENOMEM. */
enum wf_status wf_anchorage_find(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                 const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                 struct wf_err *e);
/* The row of that name; NULL when there is none. */
const struct wf_anchorage_method *wf_anchorage_method_named(const char *name);

/* Read a tipping curve: a CSV with columns phi_deg, ascending, and moment_kNm (or moment_Nm), which must rise
 * before it falls. Its largest moment is the anchorage. Errors: WF_EINPUT with every mistake in `d`. A curve
 * that still rises at its end is a warning: its last moment is then a lower bound. */
enum wf_status wf_tipping_curve_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                     const struct wf_tipping_curve **out, struct wf_err *e);
/* Read anchorage per stem mass: a CSV with columns species (key, English or Latin name), soil (row of
 * wf_soils, or blank: any), rooting (shallow, medium, deep, or blank: any) and Nm_per_kg. Errors: as above.
 */
enum wf_status wf_anchorage_table_read(const char *path, struct wf_arena *a, struct wf_diag *d,
                                       const struct wf_anchorage_table **out, struct wf_err *e);
#endif
