#include "wind/shelter.h"
#include "wind/shelter_parts.h"
#include <math.h>
#include <string.h>

const struct wf_shelter_law wf_shelter_laws[] = {
    { "wake", "drag takes momentum, wakes spread and recover",
      "momentum balance of a porous sheet; Gaussian wake: Bastankhah M., Porte-Agel F. 2014, A new "
      "analytical "
      "model for wind-turbine wakes, Renew. Energy 70:116-123; local superposition: Niayifar A., Porte-Agel "
      "F. "
      "2016, Analytical modeling of wind farms, Energies 9:741",
      "inside a crown and behind it up to some crown widths; no speed-up beside it, no eddies behind dense "
      "walls; the growth of wakes is borrowed from turbines (0.03 to 0.08 for turbulence of 7 to 20 %)",
      false, 1, wf_shelter_wake },
    { "feng1999", "classes and potential flows as printed",
      "Feng J., Yan T., Chen Y., Wu E. 1999, Research on whole tree's movement and tree's inner wind field, "
      "section 3",
      "for comparison: potential flow has no wake (behind a cylinder 96 % of the wind are back at 5 radii; a "
      "real wake takes tens of diameters), and behind covered cells the wind never recovers",
      true, 3, wf_shelter_feng },
    { .name = NULL },
};

const struct wf_shelter_law *wf_shelter_law_named(const char *name)
{
    for (const struct wf_shelter_law *l = wf_shelter_laws; name && l->name; l++)
        if (strcmp(l->name, name) == 0) return l;
    return NULL;
}

const char *wf_cell_class_name(enum wf_cell_class c)
{
    static const char *const name[WF_CELL_CLASSES] = { "none", "cylinder", "hole", "slit", "transmitting" };
    return c < WF_CELL_CLASSES ? name[c] : "?";
}

void wf_shelter_request_default(struct wf_shelter_request *q)
{
    *q = (struct wf_shelter_request){ .law = wf_shelter_laws,
                                      .slabs = 32,
                                      .cells = 128,
                                      .transmission = 0.2,
                                      .energy = true,
                                      .wood_drag = 1.0,
                                      .crown_drag = 1.0,
                                      .sail_share = 1.0,
                                      .leaf_reach = 0.25,
                                      .clear = 0.05,
                                      .full = 0.95,
                                      .gap = 1,
                                      .wake_growth = 0.08 };
}

enum wf_status wf_shelter_request_check(const struct wf_shelter_request *q, struct wf_err *e)
{
    const struct {
        const char *name, *unit;
        double value, low, high;
    } limit[] = {
        { "number of slabs", "", (double)q->slabs, 1, 512 },
        { "number of cells", "", (double)q->cells, 8, 1024 },
        { "transmission of a covered cell", "", q->transmission, 0, 1 },
        { "drag coefficient of wood", "", q->wood_drag, 1e-3, 10 },
        { "drag coefficient of the crown", "", q->crown_drag, 1e-3, 10 },
        { "share of the sail", "", q->sail_share, 0, 1 },
        { "reach of leaves", " m", q->leaf_reach, 1e-3, 100 },
        { "coverage of an open cell", "", q->clear, 0, 0.5 },
        { "coverage of a full cell", "", q->full, 0.5, 1 },
        { "widest gap", " cells", (double)q->gap, 1, 64 },
        { "growth of a wake", "", q->wake_growth, 0, 1 },
    };
    if (!q->law) return wf_fail(e, WF_EUSAGE, "no law of shelter is named");
    for (size_t i = 0; i < sizeof limit / sizeof *limit; i++)
        if (!(limit[i].value >= limit[i].low && limit[i].value <= limit[i].high))
            return wf_fail(e, WF_EUSAGE, "%s %.6g%s is outside %.6g..%.6g", limit[i].name, limit[i].value,
                           limit[i].unit, limit[i].low, limit[i].high);
    if (q->slabs * q->cells * q->cells > WF_SHELTER_CELLS_MAX)
        return wf_fail(e, WF_EUSAGE, "%zu slabs of %zu by %zu cells are more than the %d cells allowed",
                       q->slabs, q->cells, q->cells, WF_SHELTER_CELLS_MAX);
    return WF_OK;
}

double wf_shelter_speed_share(const struct wf_shelter_request *q)
{
    return q->energy ? sqrt(q->transmission) : q->transmission;
}

double wf_shelter_coverage(const struct wf_shelter *s, size_t cell)
{
    double leaf = s->leaf[cell];
    return leaf > 0.0 ? 1.0 - (1.0 - s->wood[cell]) * exp(-leaf) : s->wood[cell];
}

/* Mean ratio and volume flux of a plane of arriving wind; plane < 0: undisturbed. */
static void flux(struct wf_shelter *s, long plane, struct wf_shelter_slab *out)
{
    size_t cells = s->up * s->across;
    double ratio = 0.0, flow = 0.0, all = 0.0;
    for (size_t k = 0; k < s->up; k++) {
        double row = (double)s->across, x[3], u[3], du[9];
        if (plane >= 0)
            for (size_t i = 0; i < s->across; i++)
                row -= s->part[0][(size_t)plane * cells + k * s->across + i];
        for (int i = 0; i < 3; i++)
            x[i] = s->axis[0][i] * s->low[0] +
                   s->axis[1][i] * (s->low[1] + 0.5 * (double)s->across * s->step[1]) +
                   s->axis[2][i] * (s->low[2] + ((double)k + 0.5) * s->step[2]);
        s->base.sample(&s->base, x, u, du);
        double speed = u[0] * s->axis[0][0] + u[1] * s->axis[0][1] + u[2] * s->axis[0][2];
        ratio += row;
        flow += row * speed;
        all += (double)s->across * speed;
    }
    out->speed = ratio / (double)cells;
    out->flux = all > 0.0 ? flow / all : out->speed;
}

static void state(struct wf_shelter *s)
{
    size_t cells = s->up * s->across;
    double area = s->step[1] * s->step[2];
    for (size_t k = 0; k <= s->slabs; k++) {
        struct wf_shelter_slab *out = &s->slab[k];
        flux(s, (long)k - 1, out);
        for (size_t c = k * cells; k < s->slabs && c < (k + 1) * cells; c++) {
            double coverage = wf_shelter_coverage(s, c);
            out->cells[s->class[c]]++;
            out->full += coverage >= s->request.full;
            out->wood += s->wood[c] * area;
            out->leaf += s->leaf[c] * area;
            out->covered += coverage * area;
        }
    }
}

enum wf_status wf_shelter_wind(struct wf_shelter *s, struct wf_arena *a, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    size_t n = s->planes * s->up * s->across;
    s->slab = WF_TAKE(a, s->slabs + 1, struct wf_shelter_slab);
    for (size_t i = 0; i < s->request.law->parts; i++)
        if (!(s->part[i] = WF_TAKE(a, n, double))) s->slab = NULL;
    if (!s->slab) return wf_fail(e, WF_ENOMEM, "no room for a wind field of %zu points", n);
    enum wf_status status = s->request.law->fill(s, &scratch, e);
    wf_arena_free(&scratch);
    if (!status) state(s);
    return status;
}

enum wf_status wf_shelter_make(const struct wf_tree *t, const struct wf_wind *base,
                               const struct wf_shelter_request *q, struct wf_arena *a, struct wf_shelter *out,
                               struct wf_err *e)
{
    double thickest = 0.0;
    enum wf_status s = wf_shelter_cover(t, base, q, a, out, e);
    if (s) return s;
    for (size_t i = 0; i < t->n; i++) thickest = fmax(thickest, 2.0 * fmax(t->r0[i], t->r1[i]));
    wf_shelter_classify(out, thickest);
    return wf_shelter_wind(out, a, e);
}
