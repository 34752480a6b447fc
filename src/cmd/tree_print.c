#include "cmd/tree_print.h"
#include <math.h>

static void repairs(FILE *to, const struct wf_qsm *q, bool note, const char *title)
{
    size_t kinds = 0;
    for (int k = 0; k < WF_REPAIR_COUNT; k++) {
        const struct wf_repair_row *row = &wf_repair_rows[k];
        if (row->note != note || !q->repairs.count[k]) continue;
        fprintf(to, "  %-20s", kinds++ ? "" : title);
        if (!row->once) fprintf(to, "%zu ", q->repairs.count[k]);
        fprintf(to, "%s\n", row->text);
    }
    if (!kinds) fprintf(to, "  %-20snone\n", title);
}

static void orders(FILE *to, const struct wf_qsm_metrics *g)
{
    fprintf(to, "  %-20s%8s %12s %12s\n", "by branch order", "order", "length m", "wood m3");
    for (int k = 0; k <= g->highest_order && k < WF_QSM_ORDERS; k++)
        fprintf(to, "  %-20s%8d %12.2f %12.6f\n", "", k, g->order_length[k], g->order_volume[k]);
}

static void modelled(FILE *to, const struct wf_qsm_metrics *g, const struct wf_qsm_model *m)
{
    fprintf(to, "  %-20s%zu segments, wood %.6g m3 (%+.2f %% of that measured)\n", "for analysis", m->tree.n,
            m->volume, 100 * (m->volume / g->volume - 1));
    fprintf(
        to,
        "  %-20s%zu lateral branches, %zu links in the parents' wood, %zu bridges of unseen wood (%.3g m3)\n",
        "", m->laterals, m->links, m->bridges, m->bridge_volume);
    fprintf(to, "  %-20s%zu gaps drawn together, the widest %.3f m; %zu rows too short to keep\n", "",
            m->gaps, m->widest_gap, m->short_rows);
}

void wf_tree_print_page(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                        const struct wf_tree_wear *w)
{
    struct wf_qsm_metrics g;
    wf_qsm_measure(q, &g);
    double mass = wf_tree_wear_mass(&g, w), leaf = wf_tree_wear_sail(w);
    fprintf(to, "%s\n  %-20s%s\n", path, "format", q->format);
    fprintf(to, "  %-20s%zu cylinders, %zu branches, %zu tips, highest order %d, %zu stem%s\n", "rows",
            g.cylinders, g.branches, g.tips, g.highest_order, g.stems, g.stems == 1 ? "" : "s");
    fprintf(to, "  %-20s%.3f m\n", "height", g.height);
    if (isnan(g.dbh))
        fprintf(to, "  %-20snone: the stem is lower than 1.3 m\n", "dbh");
    else
        fprintf(to, "  %-20s%.4f m at 1.3 m\n", "dbh", g.dbh);
    fprintf(to, "  %-20s%.4f m\n", "base diameter", g.base_diameter);
    fprintf(to, "  %-20s%.2f x %.2f m\n", "width x, y", g.width_x, g.width_y);
    if (!isnan(g.crown_base)) fprintf(to, "  %-20s%.2f m (lowest branch end)\n", "crown base", g.crown_base);
    fprintf(to, "  %-20s%.2f m\n", "length of axes", g.length);
    fprintf(to, "  %-20s%.6g m3\n", "wood and bark", g.volume);
    if (!isnan(mass)) fprintf(to, "  %-20s%.6g kg\n", "mass of wood", mass);
    fprintf(to, "  %-20s%.5g m2\n", "woody surface", g.area);
    if (!isnan(w->leaf_area)) fprintf(to, "  %-20s%.5g m2 one-sided\n", "leaf area", w->leaf_area);
    fprintf(to, "  %-20s", "sail of bare wood");
    for (int deg = 0; deg < 180; deg += 45)
        fprintf(to, "%s%.4g m2 at %d", deg ? ", " : "", wf_qsm_sail(q, deg * M_PI / 180), deg);
    fprintf(to, " degrees from +x\n");
    if (!isnan(leaf)) fprintf(to, "  %-20s%.4g m2 in still air, any direction\n", "sail of leaves", leaf);
    orders(to, &g);
    modelled(to, &g, m);
    repairs(to, q, false, "repairs");
    repairs(to, q, true, "notes");
}
