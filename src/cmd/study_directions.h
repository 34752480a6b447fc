#ifndef WF_CMD_STUDY_DIRECTIONS_H
#define WF_CMD_STUDY_DIRECTIONS_H
/* Analyses over all directions of the wind, with a climate and the ground around: options, request, table for
 * a terminal. */
#include "cmd/study.h"
#include "study/directions.h"
#include "wind/terrain.h"

#define WF_EXPOSURE_OPTIONS                                                                                  \
    { .name = "--speed-up",                                                                                  \
      .kind = WF_OPTION_NUMBER,                                                                              \
      .value = "NUMBER",                                                                                     \
      .dimension = WF_DIM_NONE,                                                                              \
      .low = 0.1,                                                                                            \
      .high = 5,                                                                                             \
      .help = "exposure of the site: wind at the tree over the wind named [1]" },                            \
        { .name = "--dem",                                                                                   \
          .kind = WF_OPTION_TEXT,                                                                            \
          .value = "FILE",                                                                                   \
          .help =                                                                                            \
              "or found, for each direction, on heights of the ground, an ESRI ASCII grid, as 'windfirm "    \
              "terrain' finds it at the reference height" },                                                 \
    {                                                                                                        \
        .name = "--at", .kind = WF_OPTION_TEXT, .value = "X,Y", .help = "where the tree stands on it [m]"    \
    }

#define WF_DIRECTION_OPTIONS                                                                                 \
    { .name = "--directions",                                                                                \
      .kind = WF_OPTION_CHOICE,                                                                              \
      .value = "NUMBER",                                                                                     \
      .choices = "8|12|16|36",                                                                               \
      .help = "also let the wind come from all around, in so many directions" },                             \
        { .name = "--climate",                                                                               \
          .kind = WF_OPTION_TEXT,                                                                            \
          .value = "FILE",                                                                                   \
          .help =                                                                                            \
              "how often and how strongly the wind comes from where, for hours a year above the critical "   \
              "wind: a CSV as for 'windfirm wind rose', hourly means at the reference height; its "          \
              "directions are taken" },                                                                      \
        { .name = "--north",                                                                                 \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "ANGLE",                                                                                  \
          .initial = "0",                                                                                    \
          .dimension = WF_DIM_ANGLE,                                                                         \
          .unit = "deg",                                                                                     \
          .low = -360,                                                                                       \
          .high = 360,                                                                                       \
          .help = "where north is in the model: clockwise from +y as seen from above; 0: north is +y, east " \
                  "+x" },                                                                                    \
    {                                                                                                        \
        .name = "--threads", .kind = WF_OPTION_WHOLE, .value = "NUMBER", .initial = "0",                     \
        .dimension = WF_DIM_NONE, .low = 0, .high = 64,                                                      \
        .help = "processors to use, 0: all; the results are the same"                                        \
    }

/* What the options ask for; a climate is read, its mistakes are in `d`. Returned: *out, n = 0 where no
 * directions are asked for. */
enum wf_status wf_directions_asked(const struct wf_args *g, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_directions_request *out, struct wf_err *e);
/* The exposure the options ask for, into the scenario and, by direction, into the request. */
enum wf_status wf_exposure_asked(const struct wf_args *g, struct wf_arena *a, struct wf_scenario *s,
                                 struct wf_directions_request *q, struct wf_err *e);
/* The table of one analysis; nothing where it has no directions. */
void wf_directions_print(FILE *to, const struct wf_analysis *an);
#endif
