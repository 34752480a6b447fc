/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm tree: the size of measured trees, and pictures of trees. */
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option.h"
#include "cmd/option_groups.h"
#include "data/species.h"
#include "grow/grow.h"
#include "load/drag.h"
#include "load/qsm_metrics.h"
#include "out/tree_picture.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- windfirm tree info: what is printed ---- */

static void print_repairs(FILE *to, const struct wf_qsm *q, bool note, const char *title)
{
    size_t kinds = 0;
    for (int k = 0; k < WF_REPAIR_COUNT; k++) {
        const struct wf_repair_row *row = &wf_repair_rows[k];
        if (row->note != note || !q->repairs.count[k]) continue;
        wf_show(to, "  %-20s", kinds++ ? "" : title);
        if (!row->once) wf_show(to, "%zu ", q->repairs.count[k]);
        wf_show(to, "%s%s%s\n", row->text, q->detail[k] ? "; " : "", q->detail[k] ? q->detail[k] : "");
    }
    if (!kinds) wf_show(to, "  %-20snone\n", title);
}

static void print_orders(FILE *to, const struct wf_qsm_metrics *g)
{
    wf_show(to, "  %-20s%8s %12s %12s\n", "by branch order", "order", "length m", "wood m3");
    for (int k = 0; k <= g->highest_order && k < WF_QSM_ORDERS; k++)
        wf_show(to, "  %-20s%8d %12.2f %12.6f\n", "", k, g->order_length[k], g->order_volume[k]);
}

static void print_modelled(FILE *to, const struct wf_qsm_metrics *g, const struct wf_qsm_model *m)
{
    wf_show(to, "  %-20s%zu segments, wood %.6g m3 (%+.2f %% of that measured)\n", "for analysis", m->tree.n,
            m->volume, 100 * (m->volume / g->volume - 1));
    wf_show(
        to,
        "  %-20s%zu lateral branches, %zu links in the parents' wood, %zu bridges of unseen wood (%.3g m3)\n",
        "", m->laterals, m->links, m->bridges, m->bridge_volume);
    wf_show(to, "  %-20s%zu gaps closed, the widest %.3f m; %zu rows too short to keep\n", "", m->gaps,
            m->widest_gap, m->short_rows);
}

/* Findings that put the figures below them in doubt. */
static void print_doubts(FILE *to, const struct wf_diag *d)
{
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->code && (!strcmp(f->code, "unseen-wood") || !strcmp(f->code, "stems-apart")))
            wf_show(to, "  %-20s%s\n", "WARNING", f->text);
}

/* One tree, one page. */
static void print_page(FILE *to, const char *path, const struct wf_qsm *q, const struct wf_qsm_model *m,
                       const struct wf_tree_wear *w, const struct wf_diag *d)
{
    struct wf_qsm_metrics g;
    wf_qsm_measure(q, &g);
    double mass = wf_tree_wear_mass(&g, w), leaf = wf_tree_wear_sail(w);
    wf_show(to, "%s\n", path);
    print_doubts(to, d);
    wf_show(to, "  %-20s%s\n", "format", q->format);
    wf_show(to, "  %-20s%zu cylinders, %zu branches, %zu tips, highest order %d, %zu stem%s\n", "rows",
            g.cylinders, g.branches, g.tips, g.highest_order, g.stems, g.stems == 1 ? "" : "s");
    wf_show(to, "  %-20s%.3f m\n", "height", g.height);
    if (isnan(g.dbh))
        wf_show(to, "  %-20snone: the stem is lower than 1.3 m\n", "dbh");
    else
        wf_show(to, "  %-20s%.4f m at 1.3 m\n", "dbh", g.dbh);
    wf_show(to, "  %-20s%.4f m\n", "base diameter", g.base_diameter);
    wf_show(to, "  %-20s%.2f x %.2f m\n", "width x, y", g.width_x, g.width_y);
    if (!isnan(g.crown_base)) wf_show(to, "  %-20s%.2f m (lowest branch end)\n", "crown base", g.crown_base);
    wf_show(to, "  %-20s%.2f m\n", "length of axes", g.length);
    wf_show(to, "  %-20s%.6g m3\n", "wood and bark", g.volume);
    if (!isnan(mass)) wf_show(to, "  %-20s%.6g kg\n", "mass of wood", mass);
    wf_show(to, "  %-20s%.5g m2\n", "woody surface", g.area);
    if (!isnan(w->leaf_area)) wf_show(to, "  %-20s%.5g m2 one-sided\n", "leaf area", w->leaf_area);
    wf_show(to, "  %-20s", "sail of bare wood");
    for (int deg = 0; deg < 180; deg += 45)
        wf_show(to, "%s%.4g m2 at %d", deg ? ", " : "", wf_qsm_sail(q, deg * M_PI / 180), deg);
    wf_show(to, " degrees from +x\n");
    if (!isnan(leaf)) wf_show(to, "  %-20s%.4g m2 in still air, any direction\n", "sail of leaves", leaf);
    print_orders(to, &g);
    print_modelled(to, &g, m);
    print_repairs(to, q, false, "repairs");
    print_repairs(to, q, true, "notes");
}

/* ---- windfirm tree info ---- */

struct info_options {
    struct wf_args args;
    struct wf_import_asked import;
    const char *joint, *species;
    double density, leaf_area; /* [kg m-3], [m2]; NAN: not given */
    bool csv;
};

#define OPTIONS struct info_options
static const struct wf_option info_options[] = {
    WF_IMPORT_ROWS(import, NULL),
    CHOICE("--joint", joint, "HOW", "axis|bridge", "axis",
           "how branches are held in the analysis: where they leave the parent's axis, or at its end"),
    PATH("--species", species, "SPECIES", NULL, "take density and leaves from this species table",
         .letter = "-s"),
    NUMBER("--density", density, "DENSITY", DENSITY, "kg/m3", 1, 3000, NULL,
           "of the wood as it stands, for the mass"),
    NUMBER("--leaf-area", leaf_area, "AREA", AREA, "m2", 0, 1e5, NULL,
           "one-sided leaf area of the whole tree"),
    FLAG("--csv", csv, "one line a tree, with a header, for many trees"),
    QUIET("no repairs and notes, only the figures"),
    { 0 },
};

static const char info_about[] =
    "  windfirm tree info FILE...\n"
    "Size of measured trees: height, dbh, wood, surface, sail, branches, and what had to be repaired. "
    "Of a file of several trees, or with --scan-model all: a line for each tree or model. "
    "A file that cannot be read does not stop the others; the exit code is then 2.";

struct ask {
    const struct info_options *options;
    struct wf_import_options import;
    struct wf_tree_wear known;
};

/* The page counts repairs by kind, and so does a line of --csv; other findings are printed separately. */
static void print_rows_left_out(const struct wf_diag *d, bool quiet, bool csv)
{
    char line[2048];
    for (const struct wf_finding *f = d->first; f; f = f->next)
        if (f->severity == WF_ERROR ||
            (!quiet && f->code &&
             (!strcmp(f->code, "row-left-out") || !strcmp(f->code, "thick-stem") ||
              !strcmp(f->code, "unit-assumed") || !strcmp(f->code, "not-utf8") ||
              !strcmp(f->code, "root-not-lowest") || (csv && !strcmp(f->code, "unseen-wood")))))
            wf_show(stderr, "%s\n", wf_finding_print(f, line, sizeof line));
}

/* ---- Several trees, or several models of one tree, in a file: a line each ---- */

struct several {
    const char *path;
    const struct ask *ask;
    bool models; /* of one tree */
    size_t n, good;
    double low[3], high[3]; /* height, dbh [m], wood [m3] over those that were read */
};

static void several_head(const struct several *v)
{
    if (v->ask->options->csv) return;
    wf_show(stdout, "%s: %zu %s\n  %8s %10s %10s %10s %12s %9s  %s\n", v->path, v->n,
            v->models ? "models of one tree" : "trees", v->models ? "model" : "tree", "cylinders", "height m",
            "dbh m", "wood m3", "repairs", "base in the file, m");
}

static void several_line(struct several *v, size_t number, const struct wf_qsm *q,
                         const struct wf_qsm_model *m, const char *name)
{
    struct wf_qsm_metrics g;
    size_t repairs = 0;
    wf_qsm_measure(q, &g);
    const double value[3] = { g.height, g.dbh, g.volume };
    for (int k = 0; k < 3; k++) {
        v->low[k] = v->good ? fmin(v->low[k], value[k]) : value[k];
        v->high[k] = v->good ? fmax(v->high[k], value[k]) : value[k];
    }
    v->good++;
    for (int k = 0; k < WF_REPAIR_COUNT; k++) repairs += wf_repair_rows[k].note ? 0 : q->repairs.count[k];
    if (v->ask->options->csv)
        wf_tree_table_line(stdout, name, q, m, &v->ask->known);
    else
        wf_show(stdout, "  %8zu %10zu %10.3f %10.4f %12.6g %9zu  %.10g, %.10g, %.10g\n", number, g.cylinders,
                g.height, g.dbh, g.volume, repairs, q->base[0], q->base[1], q->base[2]);
}

/* Over models of one tree: how far they differ, which is how sure the scan is. */
static void several_range(const struct several *v)
{
    if (!v->models || !v->good || v->ask->options->csv) return;
    wf_show(stdout,
            "  range over %zu models: height %.3f to %.3f m, dbh %.4f to %.4f m, wood %.6g to %.6g m3\n",
            v->good, v->low[0], v->high[0], v->low[1], v->high[1], v->low[2], v->high[2]);
}

/* One of them that cannot be read does not stop the others. */
static enum wf_status measure_several(struct several *v, struct wf_err *e)
{
    enum wf_status worst = WF_OK;
    several_head(v);
    for (size_t i = 1; i <= v->n; i++) {
        struct wf_arena a = { 0 };
        struct wf_diag d = { .arena = &a };
        struct wf_err own = { 0 };
        struct wf_import_options o = v->ask->import;
        struct wf_qsm q;
        struct wf_qsm_model m;
        const char *number = wf_arena_print(&a, "%zu", i), *name = wf_arena_print(&a, "%s#%zu", v->path, i);
        if (v->models)
            o.scan_model = number;
        else
            o.tree_id = number;
        enum wf_status s = number && name ? wf_import_read(v->path, &o, &a, &q, &d, &own)
                                          : wf_fail(&own, WF_ENOMEM, "%s: no memory", v->path);
        if (!s) s = wf_qsm_to_tree(&q, wf_joint_named(v->ask->options->joint), &a, &m, &own);
        if (!s) several_line(v, i, &q, &m, name);
        print_rows_left_out(&d, v->ask->options->args.quiet, true);
        if (s) wf_show(stderr, "windfirm: %s %zu: %s\n", v->models ? "model" : "tree", i, own.text);
        if (s && !worst) worst = s;
        wf_arena_free(&a);
    }
    several_range(v);
    if (!worst) return WF_OK;
    return wf_fail(e, worst, "%s: %zu of %zu could not be read", v->path, v->n - v->good, v->n);
}

static enum wf_status measure_file(const char *path, const struct ask *k, struct wf_arena *a,
                                   struct wf_err *e)
{
    bool quiet = k->options->args.quiet;
    struct wf_import_options o = k->import;
    struct wf_diag d = { .arena = a };
    struct wf_qsm q;
    struct wf_qsm_model m;
    bool all = o.scan_model && !strcmp(o.scan_model, "all");
    if (all) o.scan_model = "1";
    enum wf_status s = wf_import_read(path, &o, a, &q, &d, e);
    struct several v = { path, k, all, all ? q.models : q.trees, 0, { 0 }, { 0 } };
    if (all ? v.n > 0 : s == WF_EINPUT && v.n > 1 && !o.tree_id) {
        *e = (struct wf_err){ 0 };
        return measure_several(&v, e);
    }
    if (!s) s = wf_qsm_to_tree(&q, wf_joint_named(k->options->joint), a, &m, e);
    if (!s && k->options->csv)
        wf_tree_table_line(stdout, path, &q, &m, &k->known);
    else if (!s)
        print_page(stdout, path, &q, &m, &k->known, &d);
    print_rows_left_out(&d, quiet, k->options->csv);
    return s;
}

static int measure_files(struct ask *k, struct wf_arena *a)
{
    struct wf_diag d = { .arena = a };
    struct wf_err e = { 0 };
    struct wf_species species;
    const char *name = k->options->species;
    int worst = 0;
    k->known.density = k->options->density;
    k->known.leaf_area = k->options->leaf_area;
    if (name) {
        enum wf_status s = wf_species_named(name, a, &species, &d, &e);
        wf_print_findings(&d, false);
        if (s) return wf_complain(&e);
        k->known.species = &species;
    }
    if (k->options->csv) wf_tree_table_head(stdout);
    for (size_t i = 1; i < k->options->args.n; i++) {
        struct wf_arena tree = { 0 };
        e = (struct wf_err){ 0 };
        int code = measure_file(k->options->args.operand[i], k, &tree, &e) ? wf_complain(&e) : 0;
        worst = code > worst ? code : worst;
        fflush(stdout);
        wf_arena_free(&tree);
    }
    return worst;
}

/* ---- windfirm tree draw ---- */

struct draw_options {
    struct wf_args args;
    struct wf_tree_asked tree;
    const char *species, *output;
};

#undef OPTIONS
#define OPTIONS struct draw_options
static const struct wf_option draw_options[] = {
    WF_TREE_ROWS(tree),
    PATH("--species", species, "SPECIES", NULL,
         "radius of a stem whose model names none (without: that of beech), names of the levels",
         .letter = "-s"),
    TEXT("--output", output, "FILE", "tree.svg",
         "the picture: .svg, .png or .pdf; many thousand segments are better as .png", .letter = "-o"),
    WF_QUIET_ROW,
    { 0 },
};

static const char draw_about[] =
    "  windfirm tree draw --model MODEL --species SPECIES -o FILE.svg\n"
    "  windfirm tree draw TREE -o FILE.png\n"
    "A tree from the front and the side, coloured by branching level, with its parameters.";

static enum wf_status draw_picture(const struct draw_options *o, struct wf_arena *a, struct wf_diag *d,
                                   struct wf_err *e)
{
    struct wf_model model;
    struct wf_species species;
    struct wf_tree tree;
    const char *path, *to = o->output;
    enum wf_status s =
        wf_tree_asked_read(&o->tree, o->args.n ? o->args.operand[0] : NULL, a, &model, &path, d, e);
    if (!s) s = wf_species_named(o->species ? o->species : "beech", a, &species, d, e);
    if (!s) s = wf_grow(&model, &species, a, &tree, d, e);
    if (!s) s = wf_tree_check(&tree, d, e);
    if (s) return s;
    const struct wf_tree_picture picture = { &tree, &model, &species, o->species == NULL };
    if ((s = wf_tree_picture_draw(&picture, to, d, e))) return s;
    if (!o->args.quiet) wf_show(stdout, "%s: %zu segments -> %s\n", model.name, tree.n, to);
    return WF_OK;
}

/* Given: the command line after "tree". Returned: exit code. */
static int draw_tree(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct draw_options o;
    struct wf_diag d = { .arena = &arena };
    struct wf_err e = { 0 };
    int code = wf_args_read(argc, argv, draw_options, draw_about, 0, 1, &arena, &o.args);
    if (code < 0) code = wf_tree_asked_check(&o.tree, argv[0], o.args.n ? o.args.operand[0] : NULL);
    if (code < 0) {
        enum wf_status s = draw_picture(&o, &arena, &d, &e);
        wf_print_findings(&d, o.args.quiet);
        code = s ? wf_complain(&e) : 0;
    }
    wf_arena_free(&arena);
    return code;
}

int wf_cmd_tree(int argc, char **argv)
{
    struct wf_arena arena = { 0 };
    struct info_options o;
    if (argc > 1 && !strcmp(argv[1], "draw")) {
        static char name[] = "tree draw";
        argv[1] = name;
        return draw_tree(argc - 1, argv + 1);
    }
    int code = wf_args_read(argc, argv, info_options, info_about, 2, (size_t)argc, &arena, &o.args);
    if (code < 0 && strcmp(o.args.operand[0], "info")) {
        static const char *const words[] = { "info", "draw" };
        wf_show(stderr,
                "windfirm tree: '%s' is not known%s; it is: windfirm tree info FILE..., windfirm tree "
                "draw\n",
                o.args.operand[0], wf_did_you_mean(o.args.operand[0], words, WF_COUNT(words)).text);
        code = 2;
    }
    if (code < 0) {
        struct ask k = { .options = &o, .import = wf_import_asked_options(&o.import) };
        code = measure_files(&k, &arena);
    }
    wf_arena_free(&arena);
    return code;
}
