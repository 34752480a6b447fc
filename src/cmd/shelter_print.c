#include "cmd/shelter_print.h"
#include <math.h>

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

static void print_thirds(FILE *to, const struct wf_shelter_run *r)
{
    static const char *const name[] = { "windward", "middle", "leeward" };
    struct wf_shelter_third third[3];
    wf_shelter_thirds(r, third);
    fprintf(to, "\n%-10s %6s   %-22s %-24s %s\n", "branch", "", "wind at tips m/s", "tips move m",
            "relative to the branch's base m");
    fprintf(to, "%-10s %6s   %-10s %-11s %-11s %-12s %-10s %s\n", "ends", "number", "open", "sheltered",
            "open", "sheltered", "open", "sheltered");
    for (int k = 0; k < 3; k++)
        if (third[k].n > 0)
            fprintf(to, "%-10s %6zu   %-10.3f %-11.3f %-11.4f %-12.4f %-10.4f %.4f\n", name[k], third[k].n,
                    third[k].wind[0], third[k].wind[1], third[k].move[0], third[k].move[1], third[k].swing[0],
                    third[k].swing[1]);
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
