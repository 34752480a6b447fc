/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_SPECIES_NAMES_H
#define WF_DATA_SPECIES_NAMES_H
/* Names of the shipped species tables: a table is found by its key and by every name in it, Latin, English,
 * Chinese, German, French. Letter case, accents, '-' and '_' make no difference (wf_text_folded). */
#include "base/arena.h"
#include "base/err.h"
#include "data/law.h"
#include "data/species.h"
#include <stddef.h>

/* All tables of SHARE/species, by key. */
struct wf_species_library {
    size_t n;
    struct wf_species *species;
};

/* Read them. A table with mistakes is left out and its mistakes are in `d`. Errors: WF_EINPUT where there is
 * no table; WF_ENOMEM. */
enum wf_status wf_species_library_read(const char *share, const struct wf_laws *laws, struct wf_arena *a,
                                       struct wf_species_library *out, struct wf_diag *d, struct wf_err *e);

/* The k-th name of a species: key, English, Chinese, Latin (each of several between " / "), then the further
 * ones. Returned: text in the arena; NULL after the last, or without memory. */
const char *wf_species_name(const struct wf_species *sp, size_t k, struct wf_arena *a);

/* Search. Returned: the name of the species that is the text, else the first that contains it; NULL: none
 * does. */
const char *wf_species_name_with(const struct wf_species *sp, const char *text, struct wf_arena *a);

/* The tables nearest to a name that is none of theirs: it is their genus ("Acer", "Acer sp."), else one of
 * their names shares a word with it, contains it or is contained in it, else the genus of a Latin name is the
 * same, else the spelling of a name is near. Returned: how many of at
 * most `room` stand in `out`. */
size_t wf_species_near(const struct wf_species_library *l, const char *name, struct wf_arena *a,
                       const struct wf_species **out, size_t room);

/* The shipped table that a name means: SHARE/species/NAME.yaml, else the only table with that name. Returned:
 * *path in the arena. Errors: WF_EINPUT, several tables have that name, or none, with the nearest ones;
 * WF_ENOMEM. */
enum wf_status wf_species_path(const char *share, const char *name, const struct wf_laws *laws,
                               struct wf_arena *a, const char **path, struct wf_err *e);
#endif
