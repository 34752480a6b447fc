/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_WIND_SPEED_H
#define WF_CMD_WIND_SPEED_H
/* Winds as typed: speeds with or without a unit, gusts, grades of a scale, means over another time than
 * 10 min, design winds of codes.
 * All commands that take a wind read it here (option kinds SPEED and SPEEDS). */
#include "cmd/option.h"

/* What the speeds of a wind are averaged over, and the law that converts them to 10-min means. */
struct wf_averaging {
    double time;              /* [s]                                                               */
    const char *law;          /* a row of wf_averaging_laws; NULL: wf_averaging_usual, or that of a scale */
    const char *climate;      /* whose hourly means the law converts too; NULL: none             */
    double gust;              /* 3-s gust over 10-min mean by the law, where it converted gusts; else 0 */
    bool time_used, law_used; /* set when the winds are read */
};
/* The averaging laws by number, for a row of choices. */
const char *wf_averaging_word(size_t i);

/* When the rows below have no effect. */
bool wf_averaging_row_unused(const void *options, const struct wf_option *o, char *why);
/* Rows that stand beside a wind; `in`: the member of type struct wf_averaging. */
#define WF_AVERAGING_ROWS(in)                                                                                \
    NUMBER("--averaging-time", in.time, "TIME", TIME, "s", 1, 3600, "600",                                   \
           "time the speeds of --wind are averaged over: 3 s for gusts, 1 h for hourly means; they are "     \
           "brought to 10 min. 'gust:36 m/s' and 'hourly:20 m/s' say the same. Grades have their own",       \
           .group = offsetof(OPTIONS, in), .unused = wf_averaging_row_unused),                               \
        WORD("--averaging", in.law, "LAW", wf_averaging_word, NULL,                                          \
             "law that brings a wind averaged over another time to 10 min [gusts of 3 s: en1991, by the "    \
             "turbulence where they are measured; grades of cma: in-land; else durst]",                      \
             .group = offsetof(OPTIONS, in), .unused = wf_averaging_row_unused)
/* One wind, 10 m/s unless given, and the rows above. The help is the last argument but for members of the
 * row.
 */
#define WF_WIND_ROWS(m, in, least, most, ...)                                                                \
    SPEED("--wind", m, in, least, most, "10", __VA_ARGS__, .letter = "-w"), WF_AVERAGING_ROWS(in)

/* Read every wind of a command line. This is the last pass over the options, because a speed depends on the
 * averaging time and law beside it. Given: a reading whose other options are read and have their defaults.
 * Returned: the members of the winds [m/s], as 10-min means, and in args->winds_said what was converted and
 * by which law. Mistakes are reported and counted. */
void wf_winds_read(struct wf_reading *r);
/* The word of an averaging time at the start of a text, "gust:", with its colon. Returned: its letters, 0:
 * none; *which of them. */
size_t wf_wind_time_word(const char *text, size_t *which);
#endif
