/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_CARD_H
#define WF_GROW_CARD_H
/* A tree card: what a person measures with a tape and a hypsometer, as a model of a stem with a crown. */
#include "base/arena.h"
#include "base/err.h"
#include "data/model.h"
#include <stdbool.h>

struct wf_card {
    double height;             /* from the ground to the top [m] */
    double girth, dbh;         /* over bark at WF_BREAST_HEIGHT; one of them, or both where they agree [m] */
    double crown_width;        /* [m]; NAN: the crown is described otherwise */
    double crown_base;         /* height of the lowest living branch of the crown [m] */
    enum wf_crown_form form;   /* of the crown seen from the side */
    double lean, lean_azimuth; /* [rad] */
};

/* Radius of the stem above breast height over that at breast height. Rows, by genus. */
struct wf_stem_form {
    const char *name;  /* "pine", "spruce", "power" */
    const char *genus; /* first word of the Latin name; NULL: all others */
    /* Polynomial of the relative diameter, exponents 1, 2, 3, 5, 8, 13, 21, 34 of 1 - h/H; all 0: a power of
     * (H - h) / (H - 1.3 m) */
    double c[8];
    double power;     /* of the power law [-] */
    double low, high; /* powers of these shares that 5 and 95 % of stems follow [-] */
    const char *source, *validity;
};
const struct wf_stem_form *wf_stem_form_of(const char *latin);
/* Given: form, height of the tree and above the ground [m]. Returned: radius over that at breast height,
 * 1 below it, falling to 0 at the top [-]. */
double wf_stem_form_share(const struct wf_stem_form *f, double height, double at);

/* The values of a card, in the order of their checks. */
enum wf_card_value {
    WF_CARD_HEIGHT,
    WF_CARD_GIRTH,
    WF_CARD_DBH,
    WF_CARD_WIDTH,
    WF_CARD_BASE,
    WF_CARD_VALUES
};
/* Whether a value is missing, beyond any known tree, or contradicts the values before it. Returned: *why, in
 * words, in `size` bytes. */
bool wf_card_wrong(const struct wf_card *c, enum wf_card_value value, char *why, size_t size);

/* Given: a card; its species' Latin name (NULL: unknown). Errors: WF_EINPUT with each mistake in `d`.
 * Warning `card-unusual`: dbh differs from that of trees of this height and crown width by more than 2
 * standard deviations. */
enum wf_status wf_card_check(const struct wf_card *c, const char *latin, struct wf_diag *d, struct wf_err *e);

struct wf_species;
/* The card as a model: the stem has the dbh up to breast height (butt swell is not counted, which is safe)
 * and the form of its genus above; its bark is the species', or assumed where that has none; the crown is
 * that of the silhouette (grow/silhouette.h) between its base and the top, with the mass of a rule by the
 * cone of width and depth, or without a width by the dbh. Above the middle of the crown, where limbs share
 * the load, the stem's strength is taken as not known. Given: a card that wf_card_check has passed. Returned:
 * *out in the arena. Errors: WF_EINPUT for a species whose stems are culms; WF_ENOMEM. */
enum wf_status wf_card_model(const struct wf_card *c, const struct wf_species *sp, struct wf_arena *a,
                             struct wf_model *out, struct wf_err *e);

/* What is done to a tree, or happens to it. */
struct wf_card_change {
    double reduce_share, reduce_length; /* off the crown, all round: of its height and width [-]; [m] */
    double thin;                        /* share of the crown taken out [-] */
    double cavity_growth;               /* off the wall of each cavity [m] */
};
/* Change a card's model: the crown keeps its base and its form; the stem keeps its thickness below the cut.
 * Returned: *cut, the share of the crown's frontal area that is gone [-]. Errors: WF_EINPUT where nothing of
 * the crown or of a wall is left; WF_ENOMEM. */
enum wf_status wf_card_change(const struct wf_card_change *x, struct wf_arena *a, struct wf_model *m,
                              double *cut, struct wf_err *e);
/* Whether a tree of such a card grew in a stand: 60 times as high as thick, its crown above 0.35 of the
 * height (a rule). */
bool wf_card_of_stand(const struct wf_card *c);
#endif
