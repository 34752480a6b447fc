/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "solve/rod_integrate.h"
#include "base/num.h"
#include "data/section.h"
#include "solve/beam_mesh.h"
#include <gsl/gsl_errno.h>
#include <math.h>

/* Pieces: sections, and how rows are cut. */

void wf_rod_section_at(const struct wf_tree *t, const struct wf_loads *l, size_t i, double s,
                       struct wf_rod_section *out)
{
    double a = wf_between(t->r0[i], t->r1[i], s), b = wf_between(t->i0[i], t->i1[i], s);
    double inertia = wf_ring_inertia(wf_wood_radius(t, i, s), b);
    out->ei = t->stiff ? t->stiff[4 * i + 2] : t->youngs[i] * inertia;
    out->gj = t->stiff ? t->stiff[4 * i + 3] : t->shear[i] * 2 * inertia;
    out->line = (struct wf_line_point){ .diameter = 2 * a,
                                        .drag = t->drag[i],
                                        .lift = t->lift[i],
                                        .sail = wf_between(t->sail0[i], t->sail1[i], s),
                                        .mass = t->density[i] * wf_ring_area(a, b) +
                                                wf_between(t->burden0[i], t->burden1[i], s) };
    for (size_t k = 0; k < 3; k++)
        out->dead[k] =
            l->line ? l->point_scale * wf_between(l->line[6 * i + k], l->line[6 * i + 3 + k], s) : 0;
}

/* Magnitude of the load on a row and its end, on the unloaded shape [N]. */
static double load_size(const struct wf_tree *t, const struct wf_loads *l, size_t i)
{
    struct wf_rod_section section;
    struct wf_line_load load;
    double mass = t->mass1 ? t->mass1[i] * l->gravity * fabs(l->weight_scale) : 0;
    double x[3] = { 0.5 * (t->x0[i] + t->x1[i]), 0.5 * (t->y0[i] + t->y1[i]), 0.5 * (t->z0[i] + t->z1[i]) };
    double axis[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    double chord = sqrt(wf_dot(axis, axis));
    for (int k = 0; k < 3; k++) axis[k] /= chord;
    wf_rod_section_at(t, l, i, 0.5, &section);
    wf_load_on_line(l, &section.line, x, axis, &load);
    v3_add(load.force, 1, section.dead);
    return mass + wf_tree_length(t, i) * sqrt(wf_dot(load.force, load.force));
}

struct wf_rod_piece *wf_rod_cut(const struct wf_tree *t, const struct wf_loads *l, int32_t least,
                                struct wf_arena *a, size_t *n)
{
    const double reach = 1.5, most = 32;
    double *above = WF_TAKE(a, t->n, double);
    int32_t *cut = WF_TAKE(a, t->n, int32_t), *last = WF_TAKE(a, t->n, int32_t);
    *n = 0;
    if (!above || !cut || !last) return NULL;
    for (size_t k = 0; k < l->points; k++)
        above[l->point[k].segment] +=
            fabs(l->point_scale) * sqrt(wf_dot(l->point[k].force, l->point[k].force));
    for (size_t i = t->n; i-- > 0;) {
        struct wf_rod_section s0, s1;
        wf_rod_section_at(t, l, i, 0, &s0);
        wf_rod_section_at(t, l, i, 1, &s1);
        above[i] += load_size(t, l, i);
        if (t->parent[i] >= 0) above[t->parent[i]] += above[i];
        double pieces = ceil(wf_tree_length(t, i) * sqrt(above[i] / fmin(s0.ei, s1.ei)) / reach);
        cut[i] = (int32_t)fmin(fmax(pieces, least), most);
        *n += (size_t)cut[i];
    }
    struct wf_rod_piece *piece = WF_TAKE(a, *n, struct wf_rod_piece);
    int32_t at = 0;
    for (size_t i = 0; piece && i < t->n; i++) {
        for (int32_t k = 0; k < cut[i]; k++, at++) {
            struct wf_rod_section s0, s1;
            struct wf_rod_piece *p = &piece[at];
            p->row = (int32_t)i;
            p->parent = k ? at - 1 : t->parent[i] < 0 ? -1 : last[t->parent[i]];
            p->last = k + 1 == cut[i];
            p->s0 = (double)k / cut[i], p->s1 = (double)(k + 1) / cut[i];
            p->h = wf_tree_length(t, i) / cut[i];
            wf_rod_section_at(t, l, i, p->s0, &s0);
            wf_rod_section_at(t, l, i, p->s1, &s1);
            p->stiffness = fmin(s0.ei, s1.ei);
            p->first_step = 1;
        }
        last[i] = at - 1;
    }
    return piece;
}

/* The steps by which one piece is integrated.
 *
 * They are chosen by GSL's error control and end at kinks of the wind profile: inside a step a jump of a
 * derivative would reduce the order of the eighth-order formula and cause many rejected steps. The steps
 * taken are stored with the piece. Repeating them makes the end of a piece a smooth function of its base;
 * steps chosen anew each time would scatter the end by the accepted error, and Newton's method cannot
 * converge below that scatter (Bock 1981, internal numerical differentiation, in: Modelling of Chemical
 * Reaction Systems, Springer, 102-125). */

enum { STEPS_MOST = 4000 };

static bool keep_step(struct wf_rod_integrator *g, double length)
{
    struct wf_rod_piece *p = g->piece;
    if (p->steps == p->room) {
        size_t room = p->room ? 2 * p->room : 8;
        double *more = WF_TAKE(g->arena, room, double);
        if (!more) return false;
        if (p->steps) memcpy(more, p->step, p->steps * sizeof *more);
        p->step = more, p->room = room;
    }
    p->step[p->steps++] = length;
    return true;
}

/* Distance to the next kink of the wind profile, as a share of the piece. */
static double share_to_kink(struct wf_rod_integrator *g, double sigma, const double *y)
{
    const struct wf_wind *w = g->loads->wind;
    double rate[WF_ROD_ANGLES], at[3];
    if (!w || !w->clear || g->state_system.function(sigma, y, rate, g)) return INFINITY;
    for (int k = 0; k < 3; k++) at[k] = g->place[k] + g->piece->h * y[k];
    return w->clear(w, at, rate) / g->piece->h; /* state and rate begin with position and tangent */
}

static bool choose_steps(struct wf_rod_integrator *g, double *y)
{
    gsl_odeiv2_driver *d = g->state;
    struct wf_rod_piece *p = g->piece;
    double sigma = 0, size = p->first_step;
    p->steps = 0;
    if (gsl_odeiv2_driver_reset(d)) return false;
    for (int k = 0; sigma < 1; k++) {
        double from = sigma, to = fmin(1, sigma + share_to_kink(g, sigma, y)), next = size;
        if (k == STEPS_MOST ||
            gsl_odeiv2_evolve_apply(d->e, d->c, d->s, d->sys, &sigma, to, &next, y) != GSL_SUCCESS ||
            !keep_step(g, sigma - from))
            return false;
        size = sigma < to
                   ? next
                   : fmax(size, next); /* a step that was cut short tells little about the next step size */
    }
    p->first_step = fmin(fmax(size, 1e-3), 1);
    return true;
}

static bool repeat_steps(struct wf_rod_integrator *g, double *y)
{
    gsl_odeiv2_driver *d = g->state;
    const struct wf_rod_piece *p = g->piece;
    double sigma = 0;
    for (size_t k = 0; k < p->steps; sigma += p->step[k++])
        if (gsl_odeiv2_step_apply(d->s, sigma, p->step[k], y, d->e->yerr, NULL, NULL, d->sys) != GSL_SUCCESS)
            return false;
    return true;
}

/* Integrate from base to end. Given: the state y at the base; g->piece is the present piece. Returned: y at
 * the end; false when a step fails. */
static bool rod_drive(struct wf_rod_integrator *g, double *y)
{
    return g->fixed ? repeat_steps(g, y) : choose_steps(g, y);
}

/* The equations. */

/* Layout of the state, in the piece's units: lengths by h, forces by EI/h2, moments by EI/h, arc by h. */
enum { PLACE = 0, QUATERNION = 3, FORCE = 7, MOMENT = 10, TALLY = 13, VARIED = 13 };
enum { ANGLE = 3, RATE = 6, A_FORCE = 9, A_MOMENT = 12, A_TALLY = 15 };

struct local {
    double t[3], bend, twist; /* tangent; compliances times the piece's stiffness */
    struct wf_line_load load; /* per length */
    double f[3];              /* load in the piece's units */
};

static void local_at(const struct wf_rod_integrator *g, double sigma, const double x[3], const double t[3],
                     struct local *o)
{
    const struct wf_rod_piece *p = g->piece;
    struct wf_rod_section c;
    double r[3], measure = p->h * p->h * p->h / p->stiffness;
    wf_rod_section_at(g->tree, g->loads, (size_t)p->row, p->s0 + (p->s1 - p->s0) * sigma, &c);
    for (int k = 0; k < 3; k++) r[k] = g->place[k] + p->h * x[k];
    wf_load_on_line(g->loads, &c.line, r, t, &o->load);
    memcpy(o->t, t, sizeof o->t);
    o->bend = p->stiffness / (g->printed ? g->ei : c.ei);
    o->twist = p->stiffness / (g->printed ? g->gj : c.gj);
    for (int k = 0; k < 3; k++) o->f[k] = measure * (o->load.force[k] + c.dead[k]);
}

static void tangent_at(const struct wf_rod_integrator *g, double sigma, const double q[4], double t[3])
{
    const struct wf_rod_piece *p = g->piece;
    double axis[3], place[3];
    memcpy(axis, g->axis, sizeof axis);
    if (g->tree->bend) wf_row_axis(g->tree, (size_t)p->row, p->s0 + (p->s1 - p->s0) * sigma, place, axis);
    double norm = sqrt(q[0] * q[0] + wf_dot(q + 1, q + 1)), unit[4];
    for (int k = 0; k < 4; k++) unit[k] = q[k] / norm;
    wf_rod_turn(unit, axis, t);
}

/* curvature k = bend M + (twist - bend) (M.t) t */
static void curvature_of(const struct local *o, const double M[3], double k[3])
{
    v3_section(o->bend, o->twist, o->t, M, k);
}

static void force_rates(const struct local *o, const double N[3], double dN[3], double dM[3])
{
    wf_cross(N, o->t, dM); /* -t x n */
    for (int k = 0; k < 3; k++) dN[k] = -o->f[k];
}

static void frame_rates(const struct local *o, const double y[], double dy[])
{
    double k[3], spin[4] = { 0 };
    curvature_of(o, y + MOMENT, k);
    for (int j = 0; j < 3; j++) spin[1 + j] = 0.5 * k[j];
    memcpy(dy + PLACE, o->t, sizeof o->t);
    wf_rod_times(spin, y + QUATERNION, dy + QUATERNION);
    force_rates(o, y + FORCE, dy + FORCE, dy + MOMENT);
}

static int frame_equations(double sigma, const double y[], double dy[], void *context)
{
    const struct wf_rod_integrator *g = context;
    struct local o;
    double t[3];
    tangent_at(g, sigma, y + QUATERNION, t);
    local_at(g, sigma, y + PLACE, t, &o);
    frame_rates(&o, y, dy);
    wf_cross(y + PLACE, o.f, dy + TALLY);
    return isfinite(dy[QUATERNION]) && isfinite(dy[FORCE]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

static int varied_equations(double sigma, const double y[], double dy[], void *context)
{
    const struct wf_rod_integrator *g = context;
    const struct wf_rod_piece *p = g->piece;
    struct local o;
    double t[3], k[3], measure = p->h * p->h * p->h / p->stiffness;
    tangent_at(g, sigma, y + QUATERNION, t);
    local_at(g, sigma, y + PLACE, t, &o);
    frame_rates(&o, y, dy);
    curvature_of(&o, y + MOMENT, k);
    const double *M = y + MOMENT, *N = y + FORCE;
    double along = wf_dot(M, t), extra = o.twist - o.bend;
    for (int c = 0; c < 12; c++) {
        const double *u = y + VARIED + 12 * c, *spin = u + 3, *dn = u + 6, *dm = u + 9;
        double *du = dy + VARIED + 12 * c, dt[3], turn[3], push[3], by_spin[3], a[3], b[3];
        wf_cross(spin, t, dt);
        wf_cross(k, spin, turn);
        double pull = wf_dot(dm, t) + wf_dot(M, dt);
        m3_apply(o.load.by_place, u, push);
        m3_apply(o.load.by_turn, spin, by_spin);
        wf_cross(N, dt, a);
        wf_cross(dn, t, b);
        for (int j = 0; j < 3; j++) {
            du[j] = dt[j];
            du[3 + j] = turn[j] + o.bend * dm[j] + extra * (pull * t[j] + along * dt[j]);
            du[6 + j] = -measure * (p->h * push[j] + by_spin[j]);
            du[9 + j] = a[j] + b[j];
        }
    }
    return isfinite(dy[QUATERNION]) && isfinite(dy[FORCE]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

/* Columns of the rotated axes e1, e2, e3 in base axes, from the angles (about e3, then e2, then e1). */
static void axes_of(const double a[3], double R[9])
{
    double cf = cos(a[0]), sf = sin(a[0]), ct = cos(a[1]), st = sin(a[1]), cp = cos(a[2]), sp = sin(a[2]);
    const double all[9] = { ct * cf,
                            sp * st * cf - cp * sf,
                            cp * st * cf + sp * sf,
                            ct * sf,
                            sp * st * sf + cp * cf,
                            cp * st * sf - sp * cf,
                            -st,
                            sp * ct,
                            cp * ct };
    memcpy(R, all, sizeof all);
}

static int angle_equations(double sigma, const double y[], double dy[], void *context)
{
    struct wf_rod_integrator *g = context;
    struct local o;
    double R[9], E[9], t[3], rate[3];
    const double *a = y + ANGLE;
    double ct = cos(a[1]), cf = cos(a[0]), sf = sin(a[0]);
    if (ct < 1e-3) {
        g->fault = "an angle theta reached 90 degrees, where the three angles are not defined";
        return GSL_EBADFUNC;
    }
    axes_of(a, R);
    m3_mul(g->frame, R, E);
    for (int k = 0; k < 3; k++) t[k] = E[3 * k];
    local_at(g, sigma, y + PLACE, t, &o);
    memcpy(dy + PLACE, t, sizeof t);
    force_rates(&o, y + A_FORCE, dy + A_FORCE, rate);
    memcpy(dy + A_MOMENT, rate, sizeof rate);
    double about[3]; /* change of the moments about e1, e2, e3 */
    m3_apply_transposed(E, rate, about);
    memcpy(dy + ANGLE, y + RATE, 3 * sizeof *dy);
    dy[RATE] = o.bend * (about[2] * cf + about[1] * sf) / ct;
    dy[RATE + 1] = o.bend * (about[1] * cf - about[2] * sf) / ct;
    dy[RATE + 2] = o.twist * about[0] + dy[RATE] * sin(a[1]);
    wf_cross(y + PLACE, o.f, dy + A_TALLY);
    return isfinite(dy[RATE]) && isfinite(dy[A_FORCE]) ? GSL_SUCCESS : GSL_EBADFUNC;
}

/* The integrator: open, close, integrate along a piece. */

void wf_rod_close(struct wf_rod_integrator *g)
{
    if (g->state) gsl_odeiv2_driver_free(g->state);
    if (g->varied) gsl_odeiv2_driver_free(g->varied);
    g->state = g->varied = NULL;
}

enum wf_status wf_rod_open(struct wf_rod_integrator *g, const struct wf_tree *t, const struct wf_loads *l,
                           bool printed, struct wf_arena *a, struct wf_err *e)
{
    const double tight = 1e-11,
                 loose = 1e-4; /* a derivative accurate to four digits gains four digits per Newton step */
    *g = (struct wf_rod_integrator){ .tree = t, .loads = l, .arena = a, .printed = printed };
    g->state_system = (gsl_odeiv2_system){ .function = printed ? angle_equations : frame_equations,
                                           .dimension = printed ? WF_ROD_ANGLES : WF_ROD_FRAME,
                                           .params = g };
    g->varied_system =
        (gsl_odeiv2_system){ .function = varied_equations, .dimension = WF_ROD_VARIED, .params = g };
    g->state = gsl_odeiv2_driver_alloc_y_new(&g->state_system, gsl_odeiv2_step_rk8pd, 1, tight, 0);
    g->varied = gsl_odeiv2_driver_alloc_y_new(&g->varied_system, gsl_odeiv2_step_rkck, 1, loose, loose);
    if (g->state && g->varied && !gsl_odeiv2_driver_set_nmax(g->varied, 400)) return WF_OK;
    wf_rod_close(g);
    return wf_fail(e, WF_ENOMEM, "not enough memory for the integrators of the rods");
}

void wf_rod_accuracy(struct wf_rod_integrator *g, double error)
{
    gsl_odeiv2_control_init(g->state->c, fmax(error, 1e-15), 0, 1, 0);
}

/* Base axes: e1 the tangent, e2 and e3 any two that complete a right-handed frame. */
static void complete_axes(const double t[3], double F[9])
{
    int least = fabs(t[0]) < fabs(t[1]) ? 0 : 1;
    if (fabs(t[2]) < fabs(t[least])) least = 2;
    double up[3] = { 0 }, e2[3], e3[3];
    up[least] = 1;
    wf_cross(up, t, e2);
    double size = sqrt(wf_dot(e2, e2));
    for (int k = 0; k < 3; k++) e2[k] /= size;
    wf_cross(t, e2, e3);
    for (int k = 0; k < 3; k++) F[3 * k] = t[k], F[3 * k + 1] = e2[k], F[3 * k + 2] = e3[k];
}

/* Base axes chosen on the unloaded axis and rotated with the base: axes chosen on the loaded axis would jump
 * where the choice changes, and the printed equations with them. */
static void carried_axes(const double axis[3], const double q[4], double F[9])
{
    double unloaded[9], e[3], turned[3];
    complete_axes(axis, unloaded);
    for (int c = 0; c < 3; c++) {
        for (int k = 0; k < 3; k++) e[k] = unloaded[3 * k + c];
        wf_rod_turn(q, e, turned);
        for (int k = 0; k < 3; k++) F[3 * k + c] = turned[k];
    }
}

static void start_piece(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base)
{
    double place[3];
    g->piece = p;
    g->fault = NULL;
    memcpy(g->place, base->r, sizeof g->place);
    memcpy(g->base, base->q, sizeof g->base);
    wf_row_axis(g->tree, (size_t)p->row, p->s0, place, g->axis);
    if (!g->printed) return;
    struct wf_rod_section middle;
    wf_rod_section_at(g->tree, g->loads, (size_t)p->row, 0.5, &middle);
    g->ei = middle.ei, g->gj = middle.gj;
    if (!g->tree->bend) return;
    const struct wf_tree *t = g->tree;
    const size_t i = (size_t)p->row;
    const double chord[3] = { t->x1[i] - t->x0[i], t->y1[i] - t->y0[i], t->z1[i] - t->z0[i] };
    double size = sqrt(wf_dot(chord, chord));
    for (int k = 0; k < 3; k++) g->axis[k] = chord[k] / size;
}

bool wf_rod_along(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                  const struct wf_rod_wrench *at, struct wf_rod_pose *end, struct wf_rod_wrench *wrench,
                  double tally[3])
{
    double y[WF_ROD_ANGLES] = { 0 }, force = p->stiffness / (p->h * p->h), moment = p->stiffness / p->h;
    int f = g->printed ? A_FORCE : FORCE, m = g->printed ? A_MOMENT : MOMENT,
        w = g->printed ? A_TALLY : TALLY;
    start_piece(g, p, base);
    for (int k = 0; k < 3; k++) y[f + k] = at->n[k] / force, y[m + k] = at->m[k] / moment;
    if (g->printed) {
        double about[3];
        carried_axes(g->axis, base->q, g->frame);
        m3_apply_transposed(g->frame, y + m, about);
        y[RATE] = about[2] * p->stiffness / g->ei;
        y[RATE + 1] = about[1] * p->stiffness / g->ei;
        y[RATE + 2] = about[0] * p->stiffness / g->gj;
    } else {
        memcpy(y + QUATERNION, base->q, sizeof base->q);
    }
    if (!rod_drive(g, y)) return false;
    for (int k = 0; k < 3; k++) {
        end->r[k] = base->r[k] + p->h * y[PLACE + k];
        wrench->n[k] = force * y[f + k];
        wrench->m[k] = moment * y[m + k];
        tally[k] = moment * y[w + k];
    }
    if (g->printed) {
        double R[9], E[9], FT[9], turn[9], v[3], q[4];
        axes_of(y + ANGLE, R);
        m3_mul(g->frame, R, E);
        for (int i = 0; i < 3; i++)
            for (int j = 0; j < 3; j++) FT[3 * i + j] = g->frame[3 * j + i];
        m3_mul(E, FT, turn);
        rotation_vector(turn, v);
        wf_rod_quaternion(v, q);
        wf_rod_times(q, base->q, end->q);
    } else {
        memcpy(end->q, y + QUATERNION, sizeof end->q);
    }
    double norm = sqrt(end->q[0] * end->q[0] + wf_dot(end->q + 1, end->q + 1));
    for (int k = 0; k < 4; k++) end->q[k] /= norm;
    return true;
}

bool wf_rod_vary(struct wf_rod_integrator *g, struct wf_rod_piece *p, const struct wf_rod_pose *base,
                 const struct wf_rod_wrench *at, double J[144])
{
    double y[WF_ROD_VARIED] = { 0 }, force = p->stiffness / (p->h * p->h), moment = p->stiffness / p->h;
    const double measure[4] = { p->h, 1, force, moment };
    start_piece(g, p, base);
    memcpy(y + QUATERNION, base->q, sizeof base->q);
    for (int k = 0; k < 3; k++) y[FORCE + k] = at->n[k] / force, y[MOMENT + k] = at->m[k] / moment;
    for (int c = 0; c < 12; c++) y[VARIED + 13 * c] = 1;
    double sigma = 0;
    if (gsl_odeiv2_driver_reset_hstart(g->varied, 1) ||
        gsl_odeiv2_driver_apply(g->varied, &sigma, 1, y) != GSL_SUCCESS)
        return false;
    for (int c = 0; c < 12; c++)
        for (int r = 0; r < 12; r++) J[12 * r + c] = y[VARIED + 12 * c + r] * measure[r / 3] / measure[c / 3];
    return true;
}
