/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Anchorage of the root by every method, files that are refused, and the criterion 'overturning': against the
 * moments of GALES, HWIND's pine, a rigid stem whose moment is known, and the moment of a leaning tree. */
#include "base/column.h"
#include "beam_cases.h"
#include "data/model.h"
#include "data/out/folder.h"
#include "data/species.h"
#include "fail/anchorage.h"
#include "load/drag.h"
#include "study/analysis.h"
#include "study/node.h"
#include <stdlib.h>
#include <string.h>

static const struct wf_anchorage_request nothing = { .pull_moment = NAN, .secant = NAN };

/* A stem of one row: a cylinder, or a cone cut off. */
static void stem(struct beam_case *c, double height, double r0, double r1)
{
    beam_stem(c, 1, upright, height, r0, r1);
}

static struct wf_anchorage find(const struct beam_case *c, const char *latin, struct wf_anchorage_request q,
                                struct wf_arena *a)
{
    static struct wf_level level = { .name = "stem" };
    struct wf_anchorage out;
    struct wf_err e = { 0 };
    const struct wf_species sp = {
        .key = "a", .name = "A tree", .latin = latin, .levels = 1, .level = &level
    };
    if (wf_anchorage_find(&q, &c->tree, &sp, a, &out, &e)) fail_msg("%s", e.text);
    return out;
}

static void rows_are_complete(void **state)
{
    (void)state;
    for (const struct wf_anchorage_method *m = wf_anchorage_methods; m->name; m++) {
        assert_true(m->title && m->source && m->validity && m->find);
        assert_ptr_equal(wf_anchorage_method_named(m->name), m);
    }
    assert_null(wf_anchorage_method_named("guess"));
}

/* Nothing said: not assessed, with the reason. A known soil: by size. */
static void what_is_said_decides(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage_request q = nothing;
    stem(&c, 20, 0.11, 0.11);
    struct wf_anchorage out = find(&c, "Pinus sylvestris", q, &c.arena);
    assert_null(out.method);
    assert_true(isnan(out.moment));
    assert_string_equal(out.text, WF_ANCHORAGE_UNSAID);
    q.soil = "unknown";
    assert_null(find(&c, "Pinus sylvestris", q, &c.arena).method);
    q.soil = "peat";
    assert_string_equal(find(&c, "Pinus sylvestris", q, &c.arena).method->name, "size");
    q.pull_moment = 1e4; /* a test says more than the soil */
    out = find(&c, "Pinus sylvestris", q, &c.arena);
    assert_string_equal(out.method->name, "pull");
    assert_close(out.moment, 2.5e4, 1e-15);
    assert_close(out.scatter, 0.33, 0);
    beam_free(&c);
}

/* Diameter 1.3 m along a stem that tapers over several rows; species with a row of their own and without. */
static void by_size(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage_request q = nothing;
    q.method = "size";
    beam_stem(&c, 10, upright, 20, 0.20, 0.02);
    double d = 2 * (0.20 - 0.18 * 1.3 / 20);
    struct wf_anchorage spruce = find(&c, "Picea abies", q, &c.arena),
                        oak = find(&c, "Quercus robur", q, &c.arena);
    assert_close(spruce.moment, 24.8e3 * d * d * 20, 1e-12);
    assert_close(spruce.scatter, 0.32, 0);
    assert_close(oak.moment, 32.9e3 * d * d * 20, 1e-12);
    assert_close(oak.scatter, 0.435, 0);
    assert_non_null(strstr(oak.text, "none of Quercus robur"));
    beam_free(&c);
    stem(&c, 1.2, 0.1, 0.1);
    assert_null(find(&c, "Picea abies", q, &c.arena).method);
    beam_free(&c);
}

/* The kind of soil leaves an anchorage of other trees as it is, and widens its scatter by the ratio of pulled
 * conifers (Sitka spruce in GALES' table: 138.5, 151.2 and 172.1 over 156.2 N m/kg); a test is of its own
 * soil. */
static void kinds_of_soil(void **state)
{
    (void)state;
    static const struct {
        const char *soil;
        double ratio;
    } kind[] = {
        { "mineral", 1 }, { "gleyed", 138.5 / 156.2 }, { "peaty", 151.2 / 156.2 }, { "peat", 172.1 / 156.2 }
    };
    struct beam_case c;
    stem(&c, 20, 0.11, 0.11);
    for (size_t k = 0; k < WF_COUNT(kind); k++) {
        struct wf_anchorage_request q = nothing;
        q.soil = kind[k].soil;
        struct wf_anchorage out = find(&c, "Quercus robur", q, &c.arena);
        assert_close(out.moment, 32.9e3 * 0.22 * 0.22 * 20, 1e-12);
        assert_string_equal(out.soil->name, kind[k].soil);
        assert_close(out.soil->held, kind[k].ratio, 2e-3);
        assert_close(out.scatter, sqrt(0.435 * 0.435 + pow(log(kind[k].ratio), 2)), 1e-3);
        q.pull_moment = 1e4;
        out = find(&c, "Quercus robur", q, &c.arena);
        assert_null(out.soil);
        assert_close(out.scatter, 0.33, 0);
    }
    struct wf_anchorage_request q = nothing;
    q.method = "size";
    assert_false(find(&c, "Quercus robur", q, &c.arena).soil->known);
    beam_free(&c);
}

/* A root carries at least what a test put on it, by whatever method its anchorage is found, and in every
 * sample. */
static void carried(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage_request q = nothing;
    stem(&c, 20, 0.11, 0.11);
    q.carried = 3e4;
    assert_null(find(&c, "Quercus robur", q, &c.arena).method); /* alone it is no anchorage */
    q.pull_moment = 1e4;
    struct wf_anchorage out = find(&c, "Quercus robur", q, &c.arena);
    assert_close(out.moment, 3e4, 0);
    assert_close(out.by_method, 2.5e4, 1e-15);
    assert_close(wf_anchorage_varied(&out, 0.5), 3e4, 0);
    assert_close(wf_anchorage_varied(&out, 1.5), 3.75e4, 1e-15);
    q.carried = 2e4;
    out = find(&c, "Quercus robur", q, &c.arena);
    assert_close(out.moment, 2.5e4, 1e-15);
    assert_close(wf_anchorage_varied(&out, 0.5), 2e4, 0);
    beam_free(&c);
}

/* No tree says how a culm is held, nor one stem how several are. */
static void not_by_size(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage out;
    double share = 0.2;
    struct wf_level level = { .name = "culm", .wall = { 1, &share, &share } };
    const struct wf_species sp = { .name = "Bamboo", .levels = 1, .level = &level };
    struct wf_anchorage_request q = nothing;
    q.method = "size";
    stem(&c, 14, 0.05, 0.01);
    assert_int_equal(wf_anchorage_find(&q, &c.tree, &sp, &c.arena, &out, &c.err), WF_OK);
    assert_null(out.method);
    assert_non_null(strstr(out.text, "culm"));
    beam_free(&c);
    beam_new(&c, 2);
    for (int i = 0; i < 2; i++)
        beam_row(&c, (size_t)i, -1, (double[]){ i, 0, 0 }, (double[]){ i, 0, 9 }, 0.1, 0.1);
    out = find(&c, "Picea abies", q, &c.arena);
    assert_null(out.method);
    assert_non_null(strstr(out.text, "several stems"));
    beam_free(&c);
}

/* Roots lost in a sector: integrals of (1 + cos) / 2 pi over it, by hand; never less than its share of the
 * circumference; all around the share itself, and with all roots an anchorage that is still known. */
static void lost_by_sector(void **state)
{
    (void)state;
    struct wf_anchorage_request q = nothing;
    assert_close(wf_anchorage_left(&q, 1), 1, 0);
    q.lost = 0.4, q.lost_half = PI;
    for (int k = 0; k < 8; k++) assert_close(wf_anchorage_left(&q, k), 0.6, 1e-14);
    q.lost = 1, q.lost_half = PI / 2, q.lost_middle = 0.3;
    assert_close(wf_anchorage_left(&q, 0.3 + PI), 0.5 - 1 / PI, 1e-14); /* all to windward */
    assert_close(wf_anchorage_left(&q, 0.3), 0.5, 1e-14);               /* all to leeward */
    assert_close(wf_anchorage_left(&q, 0.3 + PI / 2), 0.5, 1e-14);
    q.lost = 0.5, q.lost_half = PI / 6;
    assert_close(wf_anchorage_left(&q, 0.3 + PI), 1 - 0.5 * (1.0 / 6 + 0.5 / PI), 1e-14);
    q.lost = 1, q.lost_half = PI;
    assert_close(wf_anchorage_left(&q, 0), 1e-3, 1e-14);
}

/* Wood of British Columbia by mass: a cone cut off, whose volume is known. */
static void by_mass(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage_request q = nothing;
    q.method = "mass";
    stem(&c, 18, 0.2, 0.05);
    double mass = 800 * PI * 18 / 3 * (0.2 * 0.2 + 0.2 * 0.05 + 0.05 * 0.05);
    assert_close(find(&c, "Thuja plicata", q, &c.arena).moment, 94.5 * mass, 1e-12);
    assert_null(find(&c, "Picea abies", q, &c.arena).method);
    beam_free(&c);
}

static void given_twice(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_anchorage out;
    static const struct wf_species sp = { .name = "A" };
    stem(&c, 9, 0.1, 0.1);
    struct wf_anchorage_request q = { .pull_moment = 1e4, .secant = 1e6 };
    assert_int_equal(wf_anchorage_find(&q, &c.tree, &sp, &c.arena, &out, &c.err), WF_EUSAGE);
    assert_non_null(strstr(c.err.text, "'pull' and 'secant'"));
    beam_free(&c);
}

/* The moment at which GALES lets a stand's tree overturn, by the anchorage of the stand and the mass of its
 * stem; our row is of the stem's volume and density. */
static void moments_of_gales(void **state)
{
    (void)state;
    const char *reference = getenv("WINDFIRM_REFERENCE");
    char path[4096];
    if (!reference) skip();
    snprintf(path, sizeof path, "%s/gales/reference_stands.csv", reference);
    FILE *f = fopen(path, "r");
    if (!f) skip();
    static char head[8192], line[8192];
    static const char *const names[] = { "used_c_reg_Nm_per_kg", "used_stem_density_kgpm3",
                                         "rou_stem_volume_m3",   "rou_overturning_moment_Nm",
                                         "tmc_stem_volume_m3",   "tmc_overturning_moment_Nm" };
    enum { NAMES = sizeof names / sizeof *names };
    size_t column[NAMES], stands = 0;
    assert_non_null(fgets(head, sizeof head, f));
    for (int k = 0; k < NAMES; k++) {
        const char *at = strstr(head, names[k]);
        assert_non_null(at);
        column[k] = 0;
        for (const char *p = head; p < at; p++) column[k] += *p == ',';
    }
    for (; fgets(line, sizeof line, f); stands++) {
        double v[NAMES];
        for (int k = 0; k < NAMES; k++) {
            char *p = line;
            for (size_t i = 0; i < column[k]; i++) p = strchr(p, ',') + 1;
            v[k] = strtod(p, NULL);
        }
        for (int way = 0; way < 2; way++) {
            double volume = v[2 + 2 * way], want = v[3 + 2 * way], place;
            struct beam_case c;
            struct folder folder;
            struct wf_anchorage_request q = nothing;
            stem(&c, 15, sqrt(volume / 15 / PI), sqrt(volume / 15 / PI));
            c.tree.density[0] = v[1];
            assert_true(folder_make(&folder));
            FILE *table = fopen(folder_file(&folder, "c.csv"), "w");
            assert_non_null(table);
            fprintf(table, "species,soil,rooting,Nm_per_kg\nanother,,,50\na,,,%.17g\n", v[0]);
            fclose(table);
            if (wf_anchorage_table_read(folder_file(&folder, "c.csv"), &c.arena, &c.diag, &q.table, &c.err))
                fail_msg("%s", c.err.text);
            struct wf_anchorage out = find(&c, NULL, q, &c.arena);
            assert_close(out.moment, want, 1e-9);
            const struct wf_response r = { .base_moment = { 0, want, 0 } };
            c.tree.anchorage = out.moment;
            assert_close(wf_criteria[WF_OVERTURNING].safety(&c.tree, &r, NULL, 0, &place), 1, 1e-9);
            folder_remove(&folder);
            beam_free(&c);
        }
    }
    fclose(f);
    assert_int_equal(stands, 40);
}

/* HWIND's pine: 20 m, 20 cm, mean moments 7.68 and 1.61 kN m of wind and weight at the breaking wind, gust
 * factor 3.55, anchorage 26.69 kN m, modulus of rupture 39.1 MPa. */
static void pine_of_hwind(void **state)
{
    (void)state;
    const double ground = (7.68e3 + 1.61e3) * 3.55, breast = ground * (1 - 1.3 / 14.7);
    struct beam_case c;
    struct wf_anchorage_request q = nothing;
    double place;
    assert_close(ground, 32.98e3, 1e-4);
    stem(&c, 20, 0.1, 0.1);
    q.secant = 2.4467e6; /* 10.676 kN m at 0.25 deg */
    assert_close(find(&c, "Pinus sylvestris", q, &c.arena).moment, 26.69e3, 1e-4);
    q = nothing, q.method = "size";
    assert_close(find(&c, "Pinus sylvestris", q, &c.arena).moment, 26.69e3, 0.03);
    c.tree.anchorage = 26.69e3;
    struct wf_response r = { .base_moment = { ground, 0, 0 } };
    assert_close(wf_criteria[WF_OVERTURNING].safety(&c.tree, &r, NULL, 0, &place), 26.69e3 / 32.98e3, 1e-4);
    assert_close(wf_criteria[WF_OVERTURNING_WET].safety(&c.tree, &r, NULL, 0, &place), 0.65 * 26.69 / 32.98,
                 1e-4);
    assert_close(wf_criteria[WF_OVERTURNING_WETTEST].safety(&c.tree, &r, NULL, 0, &place),
                 0.5 * 26.69 / 32.98, 1e-4);
    /* it breaks at breast height within 3 % of its strength */
    double zero[3] = { 0 }, along[3] = { 0, 0, 1 }, moment[3] = { breast, 0, 0 };
    struct wf_breakage b;
    r = (struct wf_response){ .n = 1,
                              .force0 = zero,
                              .force1 = zero,
                              .moment0 = moment,
                              .moment1 = zero,
                              .tangent0 = along,
                              .tangent1 = along };
    c.tree.strength[0] = 39.1e6;
    assert_int_equal(wf_breakage_check(&c.tree, &r, NULL, &c.arena, &b, &c.err), WF_OK);
    assert_close(b.safety0[0], 30.71 / 30.1, 2e-3);
    assert_close(b.safety0[0], 1, 0.03);
    beam_free(&c);
}

/* ---- Files ---- */

static void refused(bool curve, const char *text, const char *finding)
{
    struct beam_case c;
    struct folder folder;
    const struct wf_tipping_curve *tipping = NULL;
    const struct wf_anchorage_table *table = NULL;
    bool said = false;
    beam_new(&c, 1);
    assert_true(folder_make(&folder));
    FILE *f = fopen(folder_file(&folder, "f.csv"), "w");
    assert_non_null(f);
    fputs(text, f);
    fclose(f);
    enum wf_status s =
        curve ? wf_tipping_curve_read(folder_file(&folder, "f.csv"), &c.arena, &c.diag, &tipping, &c.err)
              : wf_anchorage_table_read(folder_file(&folder, "f.csv"), &c.arena, &c.diag, &table, &c.err);
    assert_int_equal(s, WF_EINPUT);
    assert_true(!tipping && !table);
    for (const struct wf_finding *at = c.diag.first; at; at = at->next)
        said = said || strstr(at->text, finding);
    if (!said) fail_msg("nothing about '%s' in what was said of: %s", finding, text);
    folder_remove(&folder);
    beam_free(&c);
}

static void curves_that_are_refused(void **state)
{
    (void)state;
    refused(true, "phi_deg,moment_kNm\n0,9\n0.25,8\n1,20\n", "falls before it rises");
    refused(true, "phi_deg,moment_kNm\n0,9\n0.1,9\n0.25,8\n1,20\n", "falls before it rises");
    refused(true, "phi_deg,moment_kNm\n0,0\n0.25,8\n0.2,20\n", "must ascend");
    refused(true, "phi_deg,moment_kNm\n0,0\n0.25,0\n1,0\n", "does not rise");
    refused(true, "phi_deg,moment_kNm\n0,0\n0.25,-4\n", "moment_kNm");
    refused(true, "phi_deg,moment_kNm\n0,0\n0.25,nan\n", "moment_kNm");
    refused(true, "phi_deg,moment_kNm\n", "does not rise");
    refused(true, "phi_deg,M\n0,0\n1,2\n", "moment_kNm");
    refused(true, "phi_deg,moment_foo\n0,0\n1,2\n", "moment_kNm");
    refused(true, "phi_deg,moment_kN\n0,0\n1,2\n", "moment_kNm");
    refused(false, "species,soil,rooting,Nm_per_kg\noak,clay,,100\n", "'clay'");
    refused(false, "species,soil,rooting,Nm_per_kg\noak,peat,very,100\n", "'very'");
    refused(false, "species,soil,rooting,Nm_per_kg\noak,peat,deep,0\n", "Nm_per_kg");
    refused(false, "species,soil,rooting,Nm_per_kg\n,peat,deep,100\n", "a species is needed");
    refused(false, "species,soil,rooting,Nm_per_kg\n", "no rows");
    refused(false, "species,soil,Nm_per_kg\noak,peat,100\n", "rooting");
}

/* The top of a curve is the anchorage, in either unit; one that ends rising is said to be a lower bound, one
 * that falls before its top is warned of. */
static void curves(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double moment;
        size_t warnings;
    } rows[] = { { "phi_deg,moment_kNm\n0,0\n0.25,10\n2.2,27\n4,22\n", 27e3, 0 },
                 { "phi_deg;moment_Nm\n0;0\n0,25;10000\n2,2;27000\n4;22000\n", 27e3, 0 },
                 { "phi_rad,moment_MNm\n0,0\n0.01,0.010\n0.02,0.027\n0.04,0.022\n", 27e3, 0 },
                 { "phi_deg,moment_kNm\n0.25,10\n0.5,16\n", 16e3, 1 },
                 { "phi_deg,moment_kNm\n0,1\n1,5\n2,4.6\n3,6\n4,2\n", 6e3, 0 },
                 { "phi_deg,moment_kNm\n0,1\n1,5\n2,4\n3,6\n4,2\n", 6e3, 1 } };
    for (size_t k = 0; k < WF_COUNT(rows); k++) {
        struct beam_case c;
        struct folder folder;
        struct wf_anchorage_request q = nothing;
        size_t warnings = 0;
        stem(&c, 9, 0.1, 0.1);
        assert_true(folder_make(&folder));
        FILE *f = fopen(folder_file(&folder, "f.csv"), "w");
        assert_non_null(f);
        fputs(rows[k].text, f);
        fclose(f);
        if (wf_tipping_curve_read(folder_file(&folder, "f.csv"), &c.arena, &c.diag, &q.curve, &c.err))
            fail_msg("%s", c.err.text);
        assert_close(find(&c, NULL, q, &c.arena).moment, rows[k].moment, 1e-12);
        for (const struct wf_finding *at = c.diag.first; at; at = at->next) warnings++;
        assert_int_equal(warnings, rows[k].warnings);
        folder_remove(&folder);
        beam_free(&c);
    }
}

/* A required column whose name ends in no unit is refused, not taken as it stands in SI. */
static void a_name_without_a_unit(void **state)
{
    (void)state;
    struct folder folder;
    struct wf_arena arena = { 0 };
    struct wf_diag d = { .arena = &arena };
    struct wf_csv csv = { 0 };
    struct wf_err e = { 0 };
    struct wf_units *u;
    double factor;
    assert_true(folder_make(&folder));
    FILE *f = fopen(folder_file(&folder, "f.csv"), "w");
    assert_non_null(f);
    fputs("moment_foo,moment_kNm\n1,2\n", f);
    fclose(f);
    assert_int_equal(wf_csv_open(&csv, folder_file(&folder, "f.csv"), &arena, &d, &e), WF_OK);
    assert_int_equal(wf_units_open(&u, &e), WF_OK);
    assert_int_equal(wf_column_need(&csv, u, "moment_kNm", WF_DIM_MOMENT, &factor, &e), 1);
    assert_true(factor == 1e3 && d.errors == 0);
    assert_true(wf_column_need(&csv, u, "moment_foo", WF_DIM_MOMENT, &factor, &e) == WF_CSV_NONE);
    assert_int_equal(d.errors, 1);
    assert_non_null(
        strstr(d.first->text, "column 'moment_foo' does not say its unit, that of a moment (N m, kN m"));
    wf_units_close(u);
    wf_arena_free(&arena);
    folder_remove(&folder);
}

/* Words for the soil in four languages; clay may be the one or the other. */
static void soil_words(void **state)
{
    (void)state;
    static const char *const words[][2] = {
        { "mineral", "mineral" },   { "Sandy loam", "mineral" }, { "Lehmboden", "mineral" }, { "sable", "mineral" },
        { "sol minéral", "mineral" }, { "壤土", "mineral" },      { "gley", "gleyed" },       { "Pseudogley", "gleyed" },
        { "sol à gley", "gleyed" }, { "潜育土", "gleyed" },       { "surface-water gley", "gleyed" },
        { "anmoorig", "peaty" },    { "sol tourbeux", "peaty" }, { "Torf", "peat" },         { "tourbière", "peat" },
        { "泥炭土", "peat" },       { "unbekannt", "unknown" },  { "clay", NULL },           { "Ton", NULL },
        { "argile", NULL },         { "黏土", NULL },            { "", NULL },               { "gle", NULL },
    };
    for (size_t i = 0; i < WF_COUNT(words); i++) {
        const char *meant = wf_soil_meant(words[i][0]);
        if (!meant != !words[i][1] || (meant && strcmp(meant, words[i][1])))
            fail_msg("%s: %s", words[i][0], meant ? meant : "none");
    }
}

/* The row of soil and rooting; a blank cell fits everything, and one row must fit. */
static void table_rows(void **state)
{
    (void)state;
    static const struct {
        const char *soil, *rooting;
        double factor; /* NAN: refused */
    } rows[] = { { "mineral", "deep", 130 }, { "mineral", NULL, NAN }, { "peat", NULL, 150 },
                 { "peat", "deep", 150 },    { NULL, NULL, NAN },      { "gleyed", "deep", NAN } };
    struct folder folder;
    assert_true(folder_make(&folder));
    FILE *f = fopen(folder_file(&folder, "f.csv"), "w");
    assert_non_null(f);
    fputs("species,soil,rooting,Nm_per_kg\nA TREE,Sand,deep,130\nA tree,mineral,shallow,110\nA "
          "tree,peat,,150\n"
          "oak,,,99\n",
          f);
    fclose(f);
    for (size_t k = 0; k < WF_COUNT(rows); k++) {
        static const struct wf_species sp = { .key = "a", .name = "A tree" };
        struct beam_case c;
        struct wf_anchorage out;
        struct wf_anchorage_request q = nothing;
        q.soil = rows[k].soil, q.rooting = rows[k].rooting;
        stem(&c, 9, 0.1, 0.1);
        double mass = 800 * 9 * PI * 0.01;
        assert_int_equal(
            wf_anchorage_table_read(folder_file(&folder, "f.csv"), &c.arena, &c.diag, &q.table, &c.err),
            WF_OK);
        enum wf_status s = wf_anchorage_find(&q, &c.tree, &sp, &c.arena, &out, &c.err);
        assert_int_equal(s, isnan(rows[k].factor) ? WF_EINPUT : WF_OK);
        if (!s) assert_close(out.moment, rows[k].factor * mass, 1e-12);
        beam_free(&c);
    }
    folder_remove(&folder);
}

/* ---- In the wind ---- */

static void open_analysis(struct beam_case *c, struct wf_analysis *an)
{
    static struct wf_level level[1] = { { .name = "stem" } };
    static const struct wf_species wood = { .name = "wood", .level = level, .levels = 1 };
    *an = (struct wf_analysis){
        .species = &wood, .solver = &wf_solver_beam, .tree = c->tree, .loads = c->loads
    };
    wf_scenario_default(&an->scenario);
    an->scenario.profile = "uniform";
    wf_search_default(&an->search);
    an->tallness = wf_tree_height(&c->tree);
    wf_scenario_wind(&an->scenario, &an->wind);
    an->loads.wind = &an->wind;
}

static void find_breaks(struct beam_case *c, const struct wf_analysis *an, struct wf_break (*out)[WF_SCOPES])
{
    assert_non_null(an->solver);
    struct wf_nodes *nodes = wf_nodes_open(an, NULL);
    if (wf_analysis_breaks(an, &c->options, nodes, out, &c->err)) fail_msg("%s", c->err.text);
    wf_nodes_close(nodes);
}

/* A stem too stiff to bend, drag coefficient 1, in a uniform wind: moment rho D H^2 U^2 / 4. */
static void rigid_stem(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_analysis an;
    struct wf_break out[WF_CRITERIA][WF_SCOPES];
    const double height = 10, radius = 0.15, moment = 2e4;
    beam_stem(&c, 4, upright, height, radius, radius);
    for (size_t i = 0; i < 4; i++) c.tree.youngs[i] = c.tree.shear[i] = 1e17;
    c.loads.air_density = 1.2;
    c.tree.anchorage = moment;
    open_analysis(&c, &an);
    find_breaks(&c, &an, out);
    double want = sqrt(4 * moment / (1.2 * 2 * radius * height * height));
    static const double left[] = { 1, WF_SATURATED_HIGH, WF_SATURATED_LOW };
    for (int k = 0; k < 3; k++) {
        const struct wf_break *b = &out[WF_OVERTURNING + k][WF_SCOPE_STEM];
        assert_int_equal(b->critical.outcome, WF_CRITICAL_FOUND);
        assert_close(b->critical.speed, want * sqrt(left[k]), 1e-6);
        assert_int_equal(b->row, 0);
        assert_close(b->height, 0, 0);
    }
    assert_int_equal(out[WF_OVERTURNING][WF_SCOPE_BRANCHES].critical.outcome, WF_CRITICAL_NO_STRENGTH);
    assert_int_equal(out[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_NO_STRENGTH);
    beam_free(&c);
}

/* Solved anew at its critical wind, a tree that bends far is at its limit. */
static void safety_is_one(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_analysis an;
    struct wf_break out[WF_CRITERIA][WF_SCOPES];
    struct wf_at_speed at;
    beam_stem(&c, 12, upright, 16, 0.10, 0.02);
    c.loads.gravity = 9.81;
    c.tree.anchorage = 6e3;
    open_analysis(&c, &an);
    for (int slopes = 0; slopes < 2; slopes++) {
        an.solver = slopes ? &wf_solver_beam : wf_solver_named("rod");
        find_breaks(&c, &an, out);
        for (int k = WF_OVERTURNING; k <= WF_OVERTURNING_WETTEST; k++) {
            const struct wf_critical *found = &out[k][WF_SCOPE_TREE].critical;
            assert_int_equal(found->outcome, WF_CRITICAL_FOUND);
            assert_int_equal(wf_speed_totals(&an, &c.options, found->speed, &at, &c.err), WF_OK);
            assert_close(at.worst[k][WF_SCOPE_TREE].safety, 1, slopes ? 1e-6 : 1e-5);
        }
    }
    beam_free(&c);
}

/* Distance of a corridor and turn of the tip, of a weightless cylinder that bends little in a uniform wind: w
 * L^4 / (8 E I) and w L^3 / (6 E I), with w = rho C_d D U^2 / 2. */
static void room_of_a_cantilever(void **state)
{
    (void)state;
    const double length = 8, radius = 0.08, youngs = 9e9, air = 1.2, corridor = 0.1, angle = 0.004;
    const double stiff = youngs * PI * pow(radius, 4) / 4, per = air * radius; /* w / U^2 */
    struct beam_case c;
    struct wf_analysis an;
    struct wf_break out[WF_CRITERIA][WF_SCOPES];
    beam_stem(&c, 8, upright, length, radius, radius);
    c.loads.air_density = air;
    c.tree.room = (struct wf_room){ .corridor = corridor, .towards = { 1, 0 }, .tip_angle = angle };
    open_analysis(&c, &an);
    an.solver = wf_solver_named("linear");
    find_breaks(&c, &an, out);
    const struct wf_break *reach = &out[WF_CORRIDOR][WF_SCOPE_TREE],
                          *turn = &out[WF_TIP_ANGLE][WF_SCOPE_TREE];
    assert_int_equal(reach->critical.outcome, WF_CRITICAL_FOUND);
    assert_int_equal(turn->critical.outcome, WF_CRITICAL_FOUND);
    assert_close(reach->critical.speed, sqrt((corridor - radius) * 8 * stiff / (per * pow(length, 4))), 1e-6);
    assert_close(turn->critical.speed, sqrt(angle * 6 * stiff / (per * pow(length, 3))), 1e-6);
    assert_int_equal(reach->row, 7);
    assert_close(reach->height, length, 1e-12);
    assert_int_equal(out[WF_BREAKAGE][WF_SCOPE_TREE].critical.outcome, WF_CRITICAL_NO_STRENGTH);
    beam_free(&c);
}

/* Solved anew in the wind that was found, a slender tree that bends far is at each limit; behind it lies no
 * corridor that it could reach. */
static void room_is_used_up(void **state)
{
    (void)state;
    struct beam_case c;
    struct wf_analysis an;
    struct wf_break out[WF_CRITERIA][WF_SCOPES];
    struct wf_at_speed at;
    beam_stem(&c, 12, upright, 16, 0.10, 0.02);
    c.loads.gravity = 9.81;
    open_analysis(&c, &an);
    for (int run = 0; run < 3; run++) {
        an.scenario.corridor = 3, an.scenario.corridor_towards = run == 2 ? PI : NAN;
        an.scenario.tip_angle = 0.5;
        wf_analysis_turned(&an);
        an.solver = run == 1 ? wf_solver_named("rod") : &wf_solver_beam;
        find_breaks(&c, &an, out);
        for (int k = WF_CORRIDOR; k <= WF_TIP_ANGLE; k++) {
            const struct wf_critical *found = &out[k][WF_SCOPE_TREE].critical;
            bool behind = run == 2 && k == WF_CORRIDOR;
            assert_int_equal(found->outcome, behind ? WF_CRITICAL_ABOVE : WF_CRITICAL_FOUND);
            if (behind) continue;
            assert_int_equal(wf_speed_totals(&an, &c.options, found->speed, &at, &c.err), WF_OK);
            assert_close(at.worst[k][WF_SCOPE_TREE].safety, 1, run == 1 ? 1e-5 : 1e-6);
            if (k == WF_TIP_ANGLE) assert_close(at.tip_angle, 0.5, run == 1 ? 1e-5 : 1e-6);
        }
    }
    beam_free(&c);
}

/* A leaning tree in still air: the demand is its weight times its lever, whether it stands so or bends so. */
static void leaning_tree(void **state)
{
    (void)state;
    for (int stands = 0; stands < 2; stands++) {
        struct beam_case c;
        struct wf_analysis an;
        struct wf_at_speed at;
        const double lean = 0.3, length = 8, radius = 0.1;
        beam_stem(&c, 6, (double[]){ sin(lean), 0, cos(lean) }, length, radius, radius);
        for (size_t i = 0; i < 6; i++)
            if (!stands) c.tree.youngs[i] = c.tree.shear[i] = 1e17;
        c.loads.gravity = 9.81;
        c.tree.anchorage = 1e4;
        if (stands) assert_int_equal(wf_tree_stand(&c.tree, &c.tree, &c.arena, &c.err), WF_OK);
        open_analysis(&c, &an);
        assert_int_equal(wf_speed_totals(&an, &c.options, 0, &at, &c.err), WF_OK);
        double weight = 800 * PI * radius * radius * length * 9.81;
        assert_close(at.worst[WF_OVERTURNING][WF_SCOPE_STEM].safety,
                     1e4 / (weight * 0.5 * length * sin(lean)), 1e-7);
        beam_free(&c);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(rows_are_complete),
        cmocka_unit_test(what_is_said_decides),
        cmocka_unit_test(by_size),
        cmocka_unit_test(kinds_of_soil),
        cmocka_unit_test(carried),
        cmocka_unit_test(lost_by_sector),
        cmocka_unit_test(not_by_size),
        cmocka_unit_test(by_mass),
        cmocka_unit_test(given_twice),
        cmocka_unit_test(moments_of_gales),
        cmocka_unit_test(pine_of_hwind),
        cmocka_unit_test(curves),
        cmocka_unit_test(a_name_without_a_unit),
        cmocka_unit_test(room_of_a_cantilever),
        cmocka_unit_test(room_is_used_up),
        cmocka_unit_test(curves_that_are_refused),
        cmocka_unit_test(soil_words),
        cmocka_unit_test(table_rows),
        cmocka_unit_test(rigid_stem),
        cmocka_unit_test(safety_is_one),
        cmocka_unit_test(leaning_tree),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
