/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_DATA_CROWN_MASS_H
#define WF_DATA_CROWN_MASS_H
/* Fresh mass of a crown (branches and leaves) by rules of others, where it was not weighed. A rule is a row
 * with its source; it has kinds of trees with numbers of their own. It is named "RULE", which takes the kind
 * of the tree's species, or "RULE:KIND". */
#include "base/arena.h"
#include "base/err.h"
#include <stdbool.h>

struct wf_crown_kind {
    const char *name;    /* "spruce" */
    const char *species; /* keys of species tables, apart by blanks; "": none is shipped */
    double number[4];    /* of the rule */
    double bare;         /* instead of the first number without leaves; 0: not known */
};

/* What a rule may need of a tree; NAN: not known. */
struct wf_crown_size {
    double diameter;     /* of the stem at 1.3 m, over bark [m] */
    double width, depth; /* of the crown [m] */
    bool leaves;
};

struct wf_crown_rule {
    const char *name, *title, *source, *validity;
    const struct wf_crown_kind *kind; /* ends at name == NULL */
    bool by_cone;                     /* by the crown's width and depth; else by the diameter */
    double (*mass)(const struct wf_crown_kind *k, const struct wf_crown_size *s); /* [kg] */
};
extern const struct wf_crown_rule wf_crown_rules[]; /* forestgales, wcc; ends at name == NULL */

/* Check the words "RULE" or "RULE:KIND". Errors: WF_EINPUT with what is known. */
enum wf_status wf_crown_rule_check(const char *words, struct wf_err *e);

/* Fresh mass [kg] of the crown of a tree of a species (key of its table). Returned: *mass; the rule and its
 * kind. Errors: WF_EINPUT where the words are unknown, the
 * rule has no kind of this species, or what it needs of the tree is not known. */
enum wf_status wf_crown_rule_mass(const char *words, const char *species, const struct wf_crown_size *size,
                                  double *mass, const struct wf_crown_rule **rule,
                                  const struct wf_crown_kind **of, struct wf_err *e);
#endif
