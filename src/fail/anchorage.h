/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FAIL_ANCHORAGE_H
#define WF_FAIL_ANCHORAGE_H
/* How large a moment the root carries before the tree overturns: methods as rows. docs/failure.md derives
 * them. The criterion 'overturning' compares it with the moment on the ground. */
#include "base/arena.h"
#include "base/err.h"
#include "fail/fail.h"
#include <stdbool.h>

struct wf_species;

/* Ground that the roots are in. */
struct wf_soil {
    const char *name, *text;
    bool known;
    double held; /* anchorage of pulled conifers per stem mass, over that on freely draining soil [-]; NAN */
    const char
        *others; /* names that mean it, as wf_text_among takes them: English, German, French, Chinese */
};
extern const struct wf_soil wf_soils[]; /* ends at name == NULL */
/* The name of the row that a word means: its own, or one of the others. NULL: none, as for clay, which drains
 * freely in one place and is gleyed in another. */
const char *wf_soil_meant(const char *word);

struct wf_anchorage_method {
    const char *name, *title, *source, *validity;
    double scatter; /* standard deviation of the logarithm of the moment; NAN: not known, or by species */
    bool counts_self_weight; /* the moment includes what the leaning tree's weight adds; else it is the
                                applied one, and a demand that includes weight is on the safe side */
    bool any_soil;           /* of trees whose soil is not known: the same number for every kind of soil */
    /* Returned: moment, scatter and text of *out; moment NAN where the method has nothing for this tree.
     * Errors: WF_EINPUT where what is given does not fit. */
    enum wf_status (*find)(const struct wf_anchorage_request *q, const struct wf_tree *t,
                           const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                           struct wf_err *e);
};
extern const struct wf_anchorage_method wf_anchorage_methods[]; /* ends at name == NULL */

/* Near saturation the largest moment is 35 to 50 % lower (camphor, one study): what is left of it. */
#define WF_SATURATED_HIGH 0.65
#define WF_SATURATED_LOW 0.50

/* Find the anchorage of a tree. Given: what is said of it (NULL: nothing), the tree as grown, its species.
 * Returned: *out; where the anchorage is not known, method NULL and the reason. Errors: WF_EUSAGE, WF_EINPUT,
 * WF_ENOMEM. */
enum wf_status wf_anchorage_find(const struct wf_anchorage_request *q, const struct wf_tree *t,
                                 const struct wf_species *sp, struct wf_arena *a, struct wf_anchorage *out,
                                 struct wf_err *e);
/* The moment where the method's is a factor larger or smaller: never less than what was carried [N m]. */
double wf_anchorage_varied(const struct wf_anchorage *q, double factor);
/* Share of the anchorage that is left in wind that blows towards an azimuth [rad]; 1: nothing was lost. */
double wf_anchorage_left(const struct wf_anchorage_request *q, double azimuth);
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
