/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CASES_BUILD_H
#define WF_CASES_BUILD_H
/* From the words of a validation case to rows. Inside wf_setup_build. */
#include "cases/measure.h"

#endif
