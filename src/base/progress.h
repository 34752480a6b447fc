/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_PROGRESS_H
#define WF_BASE_PROGRESS_H
/* How far a long computation is. The library counts; the program shows it (cmd/commands.c). A program that
 * only uses the library sees nothing, and counting costs it a comparison. */
#include <stdbool.h>
#include <stddef.h>

/* A part of a run whose steps are counted. */
struct wf_stage {
    char what[160];     /* "Common oak: critical wind speed"                              */
    size_t done, of;    /* steps; of = 0: their number is not known                       */
    bool about;         /* `of` is an estimate: there can be more                         */
    size_t item, items; /* the stage belongs to one of several trees, files, ...; 0: none */
    double seconds;     /* since the stage began                                         */
    double run;         /* since wf_progress_watch [s]                                   */
};

/* From now on call show(stage) when a step is done, at most five times a second, from one thread at a time;
 * NULL: no more. */
void wf_progress_watch(void (*show)(const struct wf_stage *stage));
/* Begin a stage of `of` steps. Not while other threads count. */
void wf_stage_begin(size_t of, bool about, const char *fmt, ...) __attribute__((format(printf, 3, 4)));
/* The stages from now on belong to the item-th of several, from 1. */
void wf_stage_item(size_t item, size_t items);
/* So many steps more are done; 0: none, but time went by. From any thread. */
void wf_stage_step(size_t steps);
#endif
