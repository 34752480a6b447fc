#include "cmd/shelter_tables.h"
#include <math.h>

/* Row at the base of the branch that ends in a tip: the lowest row of the tip's own level. */
static size_t branch_base(const struct wf_tree *t, size_t row)
{
    while (t->parent[row] >= 0 && t->level[t->parent[row]] == t->level[row]) row = (size_t)t->parent[row];
    return row;
}

static double speed_at(const struct wf_wind *w, const struct wf_tree *t, const struct wf_response *r,
                       size_t i)
{
    const double x[3] = { t->x1[i] + r->end[3 * i], t->y1[i] + r->end[3 * i + 1],
                          t->z1[i] + r->end[3 * i + 2] };
    double u[3], du[9];
    w->sample(w, x, u, du);
    return sqrt(u[0] * u[0] + u[1] * u[1] + u[2] * u[2]);
}

static double size3(double x, double y, double z) { return sqrt(x * x + y * y + z * z); }

/* How far a branch's end moves when its base is held in place, but not its direction there. */
static double swing(const struct wf_tree *t, const struct wf_response *r, size_t row)
{
    int32_t from = t->parent[branch_base(t, row)];
    const double *end = &r->end[3 * row], *base = from >= 0 ? &r->end[3 * (size_t)from] : NULL;
    return base ? size3(end[0] - base[0], end[1] - base[1], end[2] - base[2]) : size3(end[0], end[1], end[2]);
}

enum wf_status wf_shelter_tips(struct wf_shelter_run *r, const struct wf_loads *open, struct wf_arena *a,
                               struct wf_err *e)
{
    const struct wf_tree *t = r->tree;
    const double *to = r->still.axis[0];
    bool *carries = WF_TAKE(a, t->n, bool);
    r->tip = WF_TAKE(a, t->n, struct wf_tip);
    if (!carries || !r->tip) return wf_fail(e, WF_ENOMEM, "no room for %zu tips", t->n);
    for (size_t i = 0; i < t->n; i++)
        if (t->parent[i] >= 0) carries[t->parent[i]] = true;
    for (size_t i = 0; i < t->n; i++) {
        if (carries[i]) continue;
        double place = to[0] * t->x1[i] + to[1] * t->y1[i] + to[2] * t->z1[i];
        struct wf_tip *p = &r->tip[r->tips++];
        *p = (struct wf_tip){ .row = i,
                              .along =
                                  (place - r->still.low[0]) / (r->still.step[0] * (double)r->still.slabs) };
        const struct wf_response *both[2] = { &r->open, &r->own };
        const struct wf_wind *wind[2] = { open->wind, &r->sheltered->wind };
        for (int k = 0; k < 2; k++) {
            const double *end = &both[k]->end[3 * i];
            p->wind[k] = speed_at(wind[k], t, both[k], i);
            p->move[k] = size3(end[0], end[1], end[2]);
            p->swing[k] = swing(t, both[k], i);
        }
    }
    return WF_OK;
}

static void print_slabs(FILE *to, const struct wf_shelter *s)
{
    fprintf(to,
            "slab  from the front   wood     leaves   covered  cells: cylinder hole slit transmitting (full)"
            "   arriving wind  volume flux  passes beside\n");
    fprintf(to, "                 m      m2         m2        m2\n");
    for (size_t k = 0; k <= s->slabs; k++) {
        const struct wf_shelter_slab *b = &s->slab[k];
        if (k == s->slabs)
            fprintf(to, "behind      %6.2f  %72s", (double)k * s->step[0], "");
        else
            fprintf(to, "%4zu        %6.2f  %8.4f  %8.4f  %8.4f         %8zu %4zu %4zu %12zu %6zu", k + 1,
                    (double)k * s->step[0], b->wood, b->leaf, b->covered, b->cells[WF_CELL_CYLINDER],
                    b->cells[WF_CELL_HOLE], b->cells[WF_CELL_SLIT], b->cells[WF_CELL_TRANSMITTING], b->full);
        fprintf(to, "   %12.4f %12.4f %13.4f\n", b->speed, b->flux, 1.0 - b->flux);
    }
}

struct third {
    double n, wind[2], move[2], swing[2];
};

static void print_thirds(FILE *to, const struct wf_shelter_run *r)
{
    static const char *const name[] = { "windward", "middle", "leeward" };
    struct third third[3] = { { 0 } };
    for (size_t i = 0; i < r->tips; i++) {
        const struct wf_tip *p = &r->tip[i];
        struct third *h = &third[(int)fmin(fmax(3.0 * p->along, 0.0), 2.0)];
        h->n += 1.0;
        for (int k = 0; k < 2; k++)
            h->wind[k] += p->wind[k], h->move[k] += p->move[k], h->swing[k] += p->swing[k];
    }
    fprintf(to, "\n%-10s %6s   %-22s %-24s %s\n", "branch", "", "wind at tips m/s", "tips move m",
            "relative to the branch's base m");
    fprintf(to, "%-10s %6s   %-10s %-11s %-11s %-12s %-10s %s\n", "ends", "number", "open", "sheltered",
            "open", "sheltered", "open", "sheltered");
    for (int k = 0; k < 3; k++)
        if (third[k].n > 0.0)
            fprintf(to, "%-10s %6.0f   %-10.3f %-11.3f %-11.4f %-12.4f %-10.4f %.4f\n", name[k], third[k].n,
                    third[k].wind[0] / third[k].n, third[k].wind[1] / third[k].n,
                    third[k].move[0] / third[k].n, third[k].move[1] / third[k].n,
                    third[k].swing[0] / third[k].n, third[k].swing[1] / third[k].n);
    fprintf(
        to,
        "base moment %.6g N m in the open, %.6g N m sheltered; shape and shelter agree after %zu passes\n",
        hypot(r->open.base_moment[0], r->open.base_moment[1]),
        hypot(r->own.base_moment[0], r->own.base_moment[1]), r->sheltered->passes);
}

void wf_shelter_print(FILE *to, const struct wf_shelter_run *r)
{
    const struct wf_shelter *s = &r->still;
    const struct wf_shelter_request *q = &s->request;
    fprintf(to, "wind %.4g m/s, a 10-min mean at %.6g m\n", r->speed, s->base.reference_height);
    fprintf(to, "law %s: %s\n", q->law->name, q->law->title);
    fprintf(to, "a covered cell lets %.0f %% of the %s through: %.3f of the speed\n", 100.0 * q->transmission,
            q->energy ? "energy" : "speed", wf_shelter_speed_share(q));
    fprintf(to, "%zu slabs of %.3f m, %zu x %zu cells of %.3f x %.3f m\n\n", s->slabs, s->step[0], s->across,
            s->up, s->step[1], s->step[2]);
    print_slabs(to, s);
    fprintf(
        to,
        "The air that no longer passes the grid's cross-section (%.1f x %.1f m) must pass beside or above "
        "it.\n",
        (double)s->across * s->step[1], (double)s->up * s->step[2]);
    if (r->moved) print_thirds(to, r);
}
