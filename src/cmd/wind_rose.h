#ifndef WF_CMD_WIND_ROSE_H
#define WF_CMD_WIND_ROSE_H
/* `windfirm wind rose`: a wind climate read, summed up, drawn. */
#include "base/arena.h"
#include "base/diag.h"
#include "base/err.h"
#include <stdbool.h>

/* Read the rose FILE, print what it says to stdout unless quiet, write FOLDER/tables/rose.csv and draw
 * FOLDER/plots/wind_rose.svg where `draw` is set. */
enum wf_status wf_wind_rose(const char *file, const char *folder, bool draw, bool quiet, struct wf_arena *a,
                            struct wf_diag *d, struct wf_err *e);
#endif
