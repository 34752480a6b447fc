/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_WIND_FOURIER_H
#define WF_WIND_FOURIER_H
/* Fourier transforms of four real series at once, each a lane of a vector register. */
#include "base/arena.h"
#include "base/err.h"

enum { WF_FOURIER_SERIES = 4 };

struct wf_fourier; /* tables and work space for one length */

/* Prepare transforms of n steps, a power of two of at least 4. Returned: *out, in the arena. Errors:
 * WF_EUSAGE for another n; WF_ENOMEM. */
enum wf_status wf_fourier_open(size_t n, struct wf_arena *a, struct wf_fourier **out, struct wf_err *e);

/* In place. Spectra are in the halfcomplex order of GSL: r0 r1 i1 r2 i2 ... r(n/2), with exp(-2 pi i jk/n)
 * forward; the inverse divides by n. The same pointer may stand for several series. Method: Stockham, radix
 * 4, on n/2 complex numbers (Van Loan C. 1992, Computational Frameworks for the Fast Fourier Transform, ch. 2
 * and 4). */
void wf_fourier_forward(struct wf_fourier *f, double *const series[WF_FOURIER_SERIES]);
void wf_fourier_inverse(struct wf_fourier *f, double *const series[WF_FOURIER_SERIES]);
#endif
