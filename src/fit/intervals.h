/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_FIT_INTERVALS_H
#define WF_FIT_INTERVALS_H
/* How well a fit knows its parameters: scatter, covariance, profiles, resampling, what the data leave open.
 */
#include "fit/session.h"

/* Parts of wf_fit_run; they fill *out from a session at its optimum. */
enum wf_status wf_fit_spread(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
/* The best of several random starts within a factor of 3 of the given one, with the sigmas as they are;
 * sigmas and misfit are found again where it is a better one. */
enum wf_status wf_fit_restart(struct wf_session *s, struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_covariance(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                                 struct wf_err *e);
enum wf_status wf_fit_loose(struct wf_fit *out, struct wf_arena *a, struct wf_err *e);
enum wf_status wf_fit_profiles(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
enum wf_status wf_fit_resample(struct wf_session *s, struct wf_fit *out, struct wf_arena *a,
                               struct wf_err *e);
#endif
