/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_SOLVE_STATIONS_H
#define WF_SOLVE_STATIONS_H
/* Solutions of one beam at several wind speeds, between and beside which others may start. */
#include "solve/beam_state.h"

/* Unknowns of all elements and root plates. */
struct wf_form {
    struct wf_beam_shape *shape;
    double (*tilt)[3];
};
/* How a form grows with the wind speed: between stiff trees (2) and streamlined ones. */
#define WF_FORM_GROWTH 1.5

struct wf_station {
    double speed; /* of its wind [m/s] */
    bool led;     /* `lead` is known: by how much the form changes to that of a wind */
    double share; /* that is faster by this share */
    struct wf_form at, lead;
};
enum { WF_STATIONS = 6 };
struct wf_stations {
    size_t n;
    struct wf_station at[WF_STATIONS];
};

/* The unknowns of the beam itself; room for as many (false: not enough memory); copy; to += share times from.
 */
struct wf_form wf_form_of(const struct wf_beam *b);
bool wf_form_take(const struct wf_beam *b, struct wf_arena *a, struct wf_form *out);
void wf_form_copy(const struct wf_beam *b, struct wf_form to, struct wf_form from);
void wf_form_add(const struct wf_beam *b, struct wf_form to, double share, struct wf_form from);
/* to: the form at a wind speed near that of a solution, moved along its derivative where that is known. */
void wf_form_lead(const struct wf_beam *b, struct wf_form to, const struct wf_station *s, double speed);
/* to: the form at a wind speed between those of two solutions, by their values and derivatives. */
void wf_form_between(const struct wf_beam *b, struct wf_form to, const struct wf_station *low,
                     const struct wf_station *high, double speed);

/* Logarithm of the ratio of two wind speeds, without sign. */
double wf_speeds_apart(double a, double b);
/* The nearest to a speed; the same within a ratio of speeds. NULL: there is none. */
struct wf_station *wf_stations_nearest(struct wf_stations *s, double speed);
struct wf_station *wf_stations_near(struct wf_stations *s, double speed, double ratio);
/* Those with derivatives that are next below and above a wind speed; NULL: none. */
void wf_stations_beside(const struct wf_stations *s, double speed, const struct wf_station *beside[2]);
/* Room for another station, of forms in the arena: the place of one of nearly this speed, a new one, or that
 * of the station which has another closest to it. NULL: not enough memory. */
struct wf_station *wf_stations_place(struct wf_stations *s, const struct wf_beam *b, struct wf_arena *a,
                                     double speed);
#endif
