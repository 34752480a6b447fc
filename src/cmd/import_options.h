#ifndef WF_CMD_IMPORT_OPTIONS_H
#define WF_CMD_IMPORT_OPTIONS_H
/* What the commands that read tree files have in common. */
#include "cmd/cmd.h"
#include "grow/import.h"

/* The i-th format name for --format, NULL behind the last. */
const char *wf_import_word(size_t i);
/* Reading options from --format, --strict, --length-unit, --diameter-unit of a command that has these rows.
 */
struct wf_import_options wf_import_typed(const struct wf_args *g);

#define WF_IMPORT_OPTIONS                                                                                    \
    { .name = "--format",                                                                                    \
      .letter = "-f",                                                                                        \
      .kind = WF_OPTION_CHOICE,                                                                              \
      .value = "FORMAT",                                                                                     \
      .word = wf_import_word,                                                                                \
      .help = "of the files; normally told by their content" },                                              \
        { .name = "--strict", .kind = WF_OPTION_FLAG, .help = "refuse a file that needs a repair" },         \
        { .name = "--length-unit",                                                                           \
          .kind = WF_OPTION_CHOICE,                                                                          \
          .value = "UNIT",                                                                                   \
          .choices = "m|cm|mm",                                                                              \
          .help = "of coordinates and lengths whose column names no unit (m; MTG: cm)" },                    \
    {                                                                                                        \
        .name = "--diameter-unit", .kind = WF_OPTION_CHOICE, .value = "UNIT", .choices = "m|cm|mm",          \
        .help = "of radii and diameters whose column names no unit (as lengths; MTG: by size)"               \
    }
#endif
