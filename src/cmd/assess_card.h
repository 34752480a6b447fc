/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_ASSESS_CARD_H
#define WF_CMD_ASSESS_CARD_H
/* Options of windfirm assess: a tree card, and those of windfirm analyze that go with it. */
#include "cmd/analyze_request.h"
#include "grow/card.h"

struct wf_assess_options {
    struct wf_analyze_options run; /* comes first: its rows are taken as they are */
    const char *name, *species;    /* NULL: not given */
    double height, girth, dbh, crown_base;
    double lean, lean_towards; /* [rad], clockwise from north; NAN: not given */
    double required;           /* safety [-] */
};

/* Set the options that are not rows of assess, and give its rows; they end at name == NULL. */
const struct wf_option *wf_assess_options_of(struct wf_assess_options *o);

/* The model of a card with all that is said of its tree; `sp` NULL: the species is not known, only the card
 * is checked. Errors: WF_EINPUT with mistakes in `d`; any other error is in `e`. */
enum wf_status wf_assess_model(const struct wf_assess_options *o, const struct wf_species *sp,
                               struct wf_arena *a, struct wf_model *out, struct wf_diag *d, struct wf_err *e);
#endif
