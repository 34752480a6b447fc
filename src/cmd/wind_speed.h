#ifndef WF_CMD_WIND_SPEED_H
#define WF_CMD_WIND_SPEED_H
/* Mean winds as typed: speeds with or without a unit, grades of a scale, means over another time than 10 min.
 * All commands that take a wind read it here (option kinds SPEED and SPEEDS). */
#include "cmd/args.h"

/* The averaging laws by number, for a row of choices. */
const char *wf_averaging_word(size_t i);

/* Rows beside a wind: what its speeds are averaged over, and how they come to 10 min. */
#define WF_AVERAGING_OPTIONS                                                                                 \
    { .name = "--averaging-time",                                                                            \
      .kind = WF_OPTION_NUMBER,                                                                              \
      .value = "TIME",                                                                                       \
      .initial = "600",                                                                                      \
      .dimension = WF_DIM_TIME,                                                                              \
      .unit = "s",                                                                                           \
      .low = 1,                                                                                              \
      .high = 3600,                                                                                          \
      .help = "time the speeds of --wind are averaged over: 3 s for gusts, 1 h for hourly means; they are "  \
              "brought to 10 min. Grades have their own" },                                                  \
    {                                                                                                        \
        .name = "--averaging", .kind = WF_OPTION_CHOICE, .value = "LAW", .word = wf_averaging_word,          \
        .help = "law that brings a wind averaged over another time to 10 min [grades of cma: in-land, else " \
                "durst]"                                                                                     \
    }

/* One wind, and the above. */
#define WF_WIND_OPTIONS(least, most, text)                                                                   \
    { .name = "--wind",                                                                                      \
      .letter = "-w",                                                                                        \
      .kind = WF_OPTION_SPEED,                                                                               \
      .value = "SPEED",                                                                                      \
      .initial = "10",                                                                                       \
      .dimension = WF_DIM_SPEED,                                                                             \
      .unit = "m/s",                                                                                         \
      .low = least,                                                                                          \
      .high = most,                                                                                          \
      .help = text },                                                                                        \
        WF_AVERAGING_OPTIONS

/* Read every wind of a command line whose other options are read: numbers and speeds of r->out in [m/s] as
 * 10-min means, and in r->out->winds_said what was converted and by which law. Mistakes are printed and
 * counted. */
void wf_args_winds(struct wf_reading *r);
#endif
