/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_OUT_FITTED_SPECIES_H
#define WF_OUT_FITTED_SPECIES_H
/* A species table with fitted values in place of the old ones, ready for analyze. */
#include "out/fit_results.h"

/* Write the species table of the first tree to `path` with the fitted values in place. The file takes its
 * name only after it was read back by the reader of species tables and says the same. Errors: WF_EOUTPUT,
 * WF_ENOMEM, WF_EMISSING without the units database. */
enum wf_status wf_fit_species_write(const struct wf_fit_results *of, const char *path, struct wf_err *e);
#endif
