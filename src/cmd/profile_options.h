#ifndef WF_CMD_PROFILE_OPTIONS_H
#define WF_CMD_PROFILE_OPTIONS_H
/* How the mean wind grows with height, asked for in the same words by every command. */
#include "cmd/cmd.h"
#include "load/scene.h"

const char *wf_profile_word(size_t i);

#define WF_AZIMUTH_OPTION                                                                                    \
    {                                                                                                        \
        .name = "--azimuth", .kind = WF_OPTION_NUMBER, .value = "ANGLE", .initial = "0",                     \
        .dimension = WF_DIM_ANGLE, .unit = "deg", .low = -360, .high = 360,                                  \
        .help = "direction the wind blows towards, from +x towards +y"                                       \
    }

#define WF_PROFILE_OPTIONS                                                                                   \
    { .name = "--profile",                                                                                   \
      .kind = WF_OPTION_CHOICE,                                                                              \
      .value = "NAME",                                                                                       \
      .word = wf_profile_word,                                                                               \
      .help = "how the wind grows with height [power; measured with --profile-file]" },                      \
        { .name = "--profile-file",                                                                          \
          .kind = WF_OPTION_TEXT,                                                                            \
          .value = "FILE",                                                                                   \
          .help = "measured mean winds, a CSV with columns height_m and speed_ms; only their ratios count, " \
                  "--wind says how strong it is at the reference height" },                                  \
        { .name = "--reference-height",                                                                      \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "LENGTH",                                                                                 \
          .initial = "10",                                                                                   \
          .dimension = WF_DIM_LENGTH,                                                                        \
          .unit = "m",                                                                                       \
          .low = 0.01,                                                                                       \
          .high = 1000,                                                                                      \
          .help = "height at which the wind has the speed named" },                                          \
        { .name = "--exponent",                                                                              \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "NUMBER",                                                                                 \
          .dimension = WF_DIM_NONE,                                                                          \
          .low = 0,                                                                                          \
          .high = 1,                                                                                         \
          .help = "of the power profile [0.16]" },                                                           \
        { .name = "--roughness",                                                                             \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "LENGTH",                                                                                 \
          .dimension = WF_DIM_LENGTH,                                                                        \
          .unit = "m",                                                                                       \
          .low = 1e-6,                                                                                       \
          .high = 10,                                                                                        \
          .help =                                                                                            \
              "roughness length of the log and canopy profiles [0.03 m; with canopy 0.1 of its height]" },   \
        { .name = "--displacement",                                                                          \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "LENGTH",                                                                                 \
          .dimension = WF_DIM_LENGTH,                                                                        \
          .unit = "m",                                                                                       \
          .low = 0,                                                                                          \
          .high = 100,                                                                                       \
          .help = "zero-plane displacement: height the log profile is lifted by, above and in a stand [0 "   \
                  "m; with canopy 0.7 of its height]" },                                                     \
        { .name = "--canopy-height",                                                                         \
          .kind = WF_OPTION_NUMBER,                                                                          \
          .value = "LENGTH",                                                                                 \
          .dimension = WF_DIM_LENGTH,                                                                        \
          .unit = "m",                                                                                       \
          .low = 0,                                                                                          \
          .high = 100,                                                                                       \
          .help = "of the stand around the tree, for the canopy profile [displacement / 0.7]" },             \
    {                                                                                                        \
        .name = "--attenuation", .kind = WF_OPTION_NUMBER, .value = "NUMBER", .dimension = WF_DIM_NONE,      \
        .low = 0, .high = 10, .help = "of the wind inside the canopy [0: joins the log law smoothly]"        \
    }

/* The profile these options ask for. */
struct wf_profile_words wf_profile_asked(const struct wf_args *g);
#endif
