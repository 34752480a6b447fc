#ifndef WF_CMD_PROFILE_OPTIONS_H
#define WF_CMD_PROFILE_OPTIONS_H
/* How the mean wind grows with height, asked for in the same words by every command. */
#include "cmd/cmd.h"

const char *wf_profile_word(size_t i);

#define WF_PROFILE_OPTIONS                                                                                   \
    { .name = "--profile",                                                                                   \
      .kind = WF_OPTION_CHOICE,                                                                              \
      .value = "NAME",                                                                                       \
      .word = wf_profile_word,                                                                               \
      .help = "how the wind grows with height [power; measured with --profile-file]" },                      \
    {                                                                                                        \
        .name = "--profile-file", .kind = WF_OPTION_TEXT, .value = "FILE",                                   \
        .help = "measured mean winds, a CSV with columns height_m and speed_ms; only their ratios count, "   \
                "--wind says how strong it is at the reference height"                                       \
    }

#endif
