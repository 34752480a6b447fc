#ifndef WF_STUDY_VALIDATE_KEYS_READ_H
#define WF_STUDY_VALIDATE_KEYS_READ_H
/* Readers of the keys of a case file: each takes the words of its line; false after a report. */
#include "study/validate_keys.h"

typedef bool wf_key_reader(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k);

wf_key_reader wf_key_text;       /* prose; a repeated key continues it                 */
wf_key_reader wf_key_choice;     /* one word of k->choices                             */
wf_key_reader wf_key_numbers;    /* k->count_low..k->count numbers and a unit, within k->low..k->high */
wf_key_reader wf_key_cantilever; /* LENGTH                                             */
wf_key_reader wf_key_arc;        /* RADIUS UNIT ANGLE UNIT from X Y Z towards X Y Z    */
wf_key_reader wf_key_node;       /* ID X Y Z UNIT                                      */
wf_key_reader wf_key_branch;     /* FROM TO RADIUS RADIUS UNIT                         */
wf_key_reader wf_key_tree;       /* FILE.csv                                           */
wf_key_reader wf_key_law;        /* NAME [PARAMETER NUMBERS UNIT]...                   */
wf_key_reader wf_key_support;    /* clamped | spring ABOUT_X [ABOUT_Y] UNIT            */
wf_key_reader wf_key_point;      /* force|moment|follower PLACE X Y Z UNIT             */
wf_key_reader wf_key_mass;       /* PLACE MASS UNIT                                    */
wf_key_reader wf_key_flow;       /* cylinder | line-source | point-source | finite-line-source */
wf_key_reader wf_key_fit;        /* STUDY.yaml                                         */
wf_key_reader wf_key_free;       /* NAME...                                            */
wf_key_reader wf_key_solver;     /* NAME...                                            */
wf_key_reader wf_key_mesh;       /* default | one-element-per-row | tolerance NUMBER   */
wf_key_reader wf_key_order;      /* PARTS PARTS...                                     */
wf_key_reader wf_key_want;       /* see wf_want_read                                   */
#endif
