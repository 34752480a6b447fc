#ifndef WF_CMD_GUST_OPTIONS_H
#define WF_CMD_GUST_OPTIONS_H
/* A gust model's parameters and file, asked for in the same words by every command. */
#include "cmd/cmd.h"
#include "wind/gust.h"

#define WF_GUST_OPTIONS                                                                                      \
    { .name = "--set",                                                                                       \
      .kind = WF_OPTION_TEXT,                                                                                \
      .value = "NAME=NUMBER,...",                                                                            \
      .help = "parameters of the gust model; `windfirm wind list` shows them" },                             \
        { .name = "--file",                                                                                  \
          .kind = WF_OPTION_TEXT,                                                                            \
          .value = "FILE",                                                                                   \
          .help = "anemometer CSV of the gust model record (of `windfirm wind rose`: a wind climate)" },     \
    {                                                                                                        \
        .name = "--columns", .kind = WF_OPTION_TEXT, .value = "T,U[,V[,W]]", .initial = WF_RECORD_COLUMNS,   \
        .help = "its columns: time in s, two horizontal components (or one speed) and the vertical one in "  \
                "m/s"                                                                                        \
    }
#endif
