#include "study/validate_build.h"
#include <math.h>
#include <string.h>

static const double pi = 3.14159265358979323846;

static double or_else(double v, double otherwise) { return isnan(v) ? otherwise : v; }

double wf_case_length(const struct wf_case *c)
{
    return c->shape == WF_SHAPE_ARC ? c->arc[0] * c->arc[1] : c->length;
}

void wf_case_radius(const struct wf_case *c, double outer[2], double inner[2])
{
    outer[0] = or_else(c->radius[0], wf_case_length(c) / 1000.0);
    outer[1] = or_else(c->radius[1], outer[0]) * or_else(c->taper, 1.0);
    for (int k = 0; k < 2; k++) inner[k] = or_else(c->inner[k], 0.0);
}

/* Section and material of every row; base bending stiffness and mass per length of a single axis. */
static enum wf_status material(const struct wf_case *c, struct wf_tree *t, struct wf_arena *a, double *ei,
                               double *mass, struct wf_err *e)
{
    double r = t->r0[0], q = t->i0[0], area = pi * (r * r - q * q),
           inertia = 0.25 * pi * (pow(r, 4) - pow(q, 4));
    double youngs = or_else(c->youngs, c->ei / inertia), poisson = or_else(c->poisson, 0.0);
    double shear = or_else(c->shear, 0.5 * youngs / (1.0 + poisson));
    *mass = or_else(c->mass_per_length, or_else(c->density * area, isnan(c->weight_parameter) ? 0.0 : 1.0));
    *ei = youngs * inertia;
    double density = or_else(c->density, *mass / area);
    bool direct = !isnan(c->ea);
    if (direct && !(t->stiff = WF_TAKE(a, 4 * t->n, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < t->n; i++) {
        t->youngs[i] = youngs;
        t->shear[i] = shear;
        t->density[i] = density;
        t->drag[i] = c->axis_drag ? c->drag : or_else(c->drag, 0.0);
        t->sail0[i] = t->sail1[i] = or_else(c->crown_area, 0.0);
        if (direct) memcpy(t->stiff + 4 * i, (double[]){ c->ea, c->ga, c->ei, c->gj }, 4 * sizeof(double));
    }
    return WF_OK;
}

/* Dead loads per length: uniform, and in proportion to the radius (given for the base). */
static double *line_load(const struct wf_case *c, const struct wf_tree *t, struct wf_arena *a)
{
    double *line = WF_TAKE(a, 6 * t->n, double);
    for (size_t i = 0; line && i < t->n; i++)
        for (size_t k = 0; k < 3; k++) {
            double uniform = or_else(c->line_load[k], 0.0),
                   by_radius = or_else(c->line_by_radius[k], 0.0) / t->r0[0];
            line[6 * i + k] = uniform + by_radius * t->r0[i];
            line[6 * i + 3 + k] = uniform + by_radius * t->r1[i];
        }
    return line;
}

/* Row of a place before splitting; -1 the base, -2 not there. */
static int32_t row_of(const struct wf_setup *s, const struct wf_tree *t, const struct wf_place *p)
{
    switch (p->kind) {
    case WF_PLACE_BASE:
    case WF_PLACE_NONE:
    case WF_PLACE_POINT:
        return -1;
    case WF_PLACE_TIP:
        return (int32_t)t->n - 1;
    case WF_PLACE_AT:
        if (p->share < 1e-9) return -1;
        for (size_t i = 0; i < t->n; i++)
            if (fabs(s->end[i] - p->share) <= 1e-9) return (int32_t)i;
        return -2;
    case WF_PLACE_NODE:
    case WF_PLACE_ROW:
        for (size_t i = 0; i < t->n; i++)
            if (t->id[i] == p->id) return (int32_t)i;
        return -2;
    }
    return -2;
}

int32_t wf_setup_row(const struct wf_setup *s, const struct wf_place *p)
{
    return p->row < 0 ? -1 : s->last[p->row];
}

static enum wf_status place(const struct wf_case *c, const struct wf_setup *s, const struct wf_tree *t,
                            struct wf_place *p, size_t line, struct wf_err *e)
{
    p->row = row_of(s, t, p);
    if (p->row > -2) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s:%zu: there is no node or row %lld", c->file, line, (long long)p->id);
}

/* Find the rows of every place the case names; point masses go into the tree. */
static enum wf_status places(const struct wf_case *c, const struct wf_setup *s, struct wf_tree *t,
                             struct wf_arena *a, struct wf_err *e)
{
    struct wf_case_load *l = c->loads.data;
    struct wf_case_mass *m = c->masses.data;
    struct wf_want *w = c->wants.data;
    for (size_t i = 0; i < c->loads.n; i++)
        if (place(c, s, t, &l[i].at, l[i].line, e)) return e->code;
    for (size_t i = 0; i < c->wants.n; i++)
        if (place(c, s, t, &w[i].at, w[i].line, e)) return e->code;
    if (c->masses.n && !(t->mass1 = WF_TAKE(a, t->n, double))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < c->masses.n; i++) {
        if (place(c, s, t, &m[i].at, m[i].line, e)) return e->code;
        if (m[i].at.row >= 0) t->mass1[m[i].at.row] += m[i].mass;
    }
    return WF_OK;
}

static enum wf_status point_loads(const struct wf_case *c, struct wf_setup *s, struct wf_arena *a,
                                  struct wf_err *e)
{
    const struct wf_case_load *l = c->loads.data;
    struct wf_point_load *p = WF_TAKE(a, c->loads.n, struct wf_point_load);
    if (!p) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < c->loads.n; i++) {
        if (wf_setup_row(s, &l[i].at) < 0)
            return wf_fail(e, WF_EINPUT, "%s:%zu: the base is held; a load there does nothing", c->file,
                           l[i].line);
        p[i].segment = wf_setup_row(s, &l[i].at);
        p[i].kind = l[i].follower ? WF_POINT_FOLLOWER : WF_POINT_DEAD;
        memcpy(l[i].moment ? p[i].moment : p[i].force, l[i].value, sizeof l[i].value);
    }
    s->loads.point = p;
    s->loads.points = c->loads.n;
    return WF_OK;
}

/* Wind, air and gravity. Cauchy number 1/2 rho Cd D U^2 L^3/EI and weight parameter m g L^3/EI with base
 * values. */
static void fields(const struct wf_case *c, struct wf_setup *s, double ei, double mass, double diameter)
{
    double u[3] = { or_else(c->wind[0], isnan(c->cauchy) ? 0.0 : 1.0), or_else(c->wind[1], 0.0),
                    or_else(c->wind[2], 0.0) };
    double length = wf_case_length(c), speed = sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
    wf_loads_default(&s->loads);
    s->loads.air_density = or_else(c->air_density, s->loads.air_density);
    s->loads.air_viscosity = or_else(c->air_viscosity, s->loads.air_viscosity);
    if (c->axis_drag) s->loads.axis_drag = c->axis_drag, s->loads.axis_drag_par = c->axis_drag_par;
    s->loads.streamline = c->streamlining, s->loads.streamline_par = c->streamlining_par;
    s->loads.gravity = or_else(c->gravity, 0.0);
    if (!isnan(c->weight_parameter)) s->loads.gravity = c->weight_parameter * ei / (mass * pow(length, 3));
    if (speed > 0.0) {
        s->wind = (struct wf_wind){ .sample = wf_profile_named("uniform")->sample,
                                    .speed = speed,
                                    .reference_height = 10.0 };
        for (int k = 0; k < 3; k++) s->wind.direction[k] = u[k] / speed;
        s->loads.wind = &s->wind;
        if (!isnan(c->cauchy))
            s->loads.air_density =
                2.0 * c->cauchy * ei / (c->drag * diameter * speed * speed * pow(length, 3));
    }
}

static void options(const struct wf_case *c, struct wf_solve_options *o)
{
    wf_solve_options_default(o);
    o->inextensible = c->model == WF_MODEL_K;
    o->shear_flexible = c->model == WF_MODEL_SR;
    o->shear_factor = or_else(c->shear_factor, 0.0);
    o->tolerance = or_else(c->accuracy, o->tolerance);
    o->mesh_tolerance = or_else(c->mesh_tolerance, o->mesh_tolerance);
    for (int k = 0; k < 2; k++) o->root_stiffness[k] = or_else(c->spring[k], 0.0);
}

enum wf_status wf_setup_build(const struct wf_case *c, size_t pieces, struct wf_arena *a, struct wf_setup *s,
                              struct wf_err *e)
{
    struct wf_tree rows;
    double ei, mass, *line = NULL, *split_line;
    *s = (struct wf_setup){ 0 };
    if (wf_case_shape_build(c, a, s, &rows, e) || material(c, &rows, a, &ei, &mass, e) ||
        places(c, s, &rows, a, e))
        return e->code;
    fields(c, s, ei, mass, 2.0 * rows.r0[0]);
    options(c, &s->options);
    if ((!isnan(c->line_load[0]) || !isnan(c->line_by_radius[0])) && !(line = line_load(c, &rows, a)))
        return wf_fail(e, WF_ENOMEM, "no memory");
    if (wf_tree_split(&rows, line, pieces, a, &s->tree, &split_line, e)) return e->code;
    s->tree.name = c->name;
    s->loads.line = split_line;
    s->rows = rows.n;
    if (!(s->last = WF_TAKE(a, rows.n, int32_t))) return wf_fail(e, WF_ENOMEM, "no memory");
    for (size_t i = 0; i < rows.n; i++) s->last[i] = (int32_t)((i + 1) * pieces - 1);
    return point_loads(c, s, a, e);
}
