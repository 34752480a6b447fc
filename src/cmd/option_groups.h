/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_CMD_OPTION_GROUPS_H
#define WF_CMD_OPTION_GROUPS_H
/* Groups of options that several commands have in the same words. A group is a struct, which is a member of
 * the command's options struct, and a macro with its rows, whose argument `in` is the name of that member. */
#include "cmd/option.h"
#include "data/model.h"
#include "fail/anchorage.h"
#include "grow/import.h"
#include "grow/qsm_model.h"
#include "load/scene.h"
#include "out/job.h"
#include "out/page_units.h"
#include "wind/gust.h"

/* Words of choices by number; NULL after the last. For a shelter, "none" comes first. */
const char *wf_solver_word(size_t i);
const char *wf_preset_word(size_t i);
const char *wf_shelter_word(size_t i);
const char *wf_branch_strength_word(size_t i);
/* Strength of branches; into a const char * (NULL: not given). */
#define WF_BRANCH_STRENGTH_ROW(in)                                                                           \
    WORD("--branch-strength", in, "HOW", wf_branch_strength_word, NULL,                                      \
         "what branches bear at most, over the clear wood of the stem: full: what the species table says; "  \
         "inside-bark 0.72; over-bark 0.55; over-bark-circle 0.40, where one diameter was measured "         \
         "[over-bark, inside-bark where bark is taken off; full with the preset or the table of a paper]")
const char *wf_profile_word(size_t i);
const char *wf_site_word(size_t i);
const char *wf_design_word(size_t i);
const char *wf_import_word(size_t i);

/* The last rows of most commands. `no`: the option that leaves out figures and pages, "--no-report" or
 * "--no-plots"; `in`: a struct wf_pages (cmd/commands.h). */
#define WF_QUIET_ROW QUIET("print errors only")
#define WF_LANGUAGE_ROW(m) CHOICE("--lang", m, "NAME", "en|zh", "en", "language of the report")
/* The same of a command without a page. */
#define WF_SPOKEN_ROW(m) CHOICE("--lang", m, "NAME", "en|zh", "en", "language of what is printed")
#define WF_UNITS_ROW(m)                                                                                      \
    WORD("--units", m, "SYSTEM", wf_page_units_word, "metric",                                               \
         "of the printed page and of what the terminal says; results.json and tables stay in SI, columns "   \
         "of the terminal, and figures of other pages than reports, metric")
bool wf_template_row_wrong(const void *options, const struct wf_option *o, char *why);
#define WF_TEMPLATE_ROW(in)                                                                                  \
    PATH("--template", in.templates, "FOLDER", NULL,                                                         \
         "make the page by the stylesheets, words and style of this folder ('windfirm init template' "       \
         "writes one to change)",                                                                            \
         .group = WF_MEMBER(in, struct wf_pages), .wrong = wf_template_row_wrong)
bool wf_pages_row_unused(const void *options, const struct wf_option *o, char *why);
#define WF_NO_PDF_ROW(in)                                                                                    \
    FLAG("--no-pdf", in.no_pdf, "leave out the PDF of the page; 'windfirm report' prints it later",          \
         .group = WF_MEMBER(in, struct wf_pages), .unused = wf_pages_row_unused)
bool wf_docx_row_wrong(const void *options, const struct wf_option *o, char *why);
#define WF_DOCX_ROW(in)                                                                                      \
    FLAG("--docx", in.docx, "write the page also for a word processor, PAGE.docx, by pandoc",                \
         .group = WF_MEMBER(in, struct wf_pages), .unused = wf_pages_row_unused, .wrong = wf_docx_row_wrong)
#define WF_XLSX_ROW(in) FLAG("--xlsx", in.xlsx, "write the tables also as one workbook, tables/tables.xlsx")
#define WF_PAGE_ROWS(no, in, help)                                                                           \
    FLAG(no, in.none, help), WF_NO_PDF_ROW(in), WF_XLSX_ROW(in), WF_LANGUAGE_ROW(in.lang),                   \
        WF_UNITS_ROW(in.units), WF_TEMPLATE_ROW(in), WF_DOCX_ROW(in)

/* Head of a report for a client; into a struct wf_job. */
#define WF_JOB_ROWS(in)                                                                                      \
    TEXT("--title", in.title, "TEXT", NULL, "of the page [composed of the trees' names]"),                   \
        TEXT("--client", in.client, "TEXT", NULL, "for whom the report is"),                                 \
        TEXT("--site-name", in.site, "TEXT", NULL, "where the tree stands, in words"),                       \
        TEXT("--tree-number", in.tree_number, "TEXT", NULL, "of the tree in a register"),                    \
        TEXT("--assessor", in.assessor, "TEXT", NULL, "who answers for the report"),                         \
        TEXT("--organisation", in.organisation, "TEXT", NULL, "the assessor's"),                             \
        PATH("--photo", in.photo, "FILE", NULL,                                                              \
             "photograph of the tree, PNG or JPEG up to 20 MB and 40 megapixels: encoded anew, without "     \
             "place, time and camera"),                                                                      \
        PATH("--logo", in.logo, "FILE", NULL, "the organisation's, as --photo"),                             \
        TEXT("--disclaimer", in.disclaimer, "TEXT", NULL, "a paragraph at the end of the first page")

#define WF_AZIMUTH_ROW(m)                                                                                    \
    NUMBER("--azimuth", m, "ANGLE", ANGLE, "deg", -360, 360, "0",                                            \
           "direction the wind blows towards, from +x towards +y")

#define WF_NODE_SPACING_ROW(m)                                                                               \
    NUMBER("--node-spacing", m, "DISTANCE", LENGTH, "cm", 1, 500, NULL,                                      \
           "longest distance between the nodes of a culm of bamboo: its diaphragms then hold the wall "      \
           "round, by judgement [they are left out, on the safe side]")

/* How many samples an interval has; into members samples and seed. `f`: when they have no effect. */
#define WF_SAMPLE_ROWS(f)                                                                                    \
    WHOLE("--samples", samples, 0, 4096, "256",                                                              \
          "samples of what is not known exactly, for the interval of the critical wind: 0, none, or 20 and " \
          "more. Where it is not given, none for trees of more than 65536 segments times samples",           \
          .unused = f),                                                                                      \
        WHOLE("--seed", seed, 0, 1000000000, "1", "of the samples", .unused = f)

/* For the rows of a group: its struct, and when a row has no effect. */
#define WF_UNUSED(in, f) .group = offsetof(OPTIONS, in), .unused = f
bool wf_profile_row_unused(const void *options, const struct wf_option *o, char *why);
bool wf_tree_row_unused(const void *options, const struct wf_option *o, char *why);

bool wf_site_row_unused(const void *options, const struct wf_option *o, char *why);

/* The ground around the tree, and winds of design codes; into a struct wf_profile_words. cmd/wind_speed.c
 * finds the words by the row --design. */
#define WF_OF_SITE(in) WF_UNUSED(in, wf_site_row_unused)
#define WF_SITE_ROWS(in)                                                                                     \
    TEXT("--terrain", in.design.terrain, "CATEGORY", NULL,                                                   \
         "ground the wind comes over: 0, I, II, III or IV of EN 1991-1-4, or a terrain of the code of "      \
         "--design; a wind named is then of open country (II, 10 m) and carried to it [II, assumed; with "   \
         "the wind as it is named]"),                                                                        \
        WORD("--site", in.site, "KIND", wf_site_word, NULL,                                                  \
             "the same by what stands around the tree, unless --terrain names it"),                          \
        CHOICE("--wind-at", in.at, "PLACE", "open|site", NULL,                                               \
               "where the winds named are measured: in open country at 10 m, or at the site at the "         \
               "reference height [open]",                                                                    \
               WF_OF_SITE(in)),                                                                              \
        NUMBER("--gust-factor", in.gust_factor, "NUMBER", NONE, NULL, 1, 4, NULL,                            \
               "3-s gust over 10-min mean where the winds are measured [sqrt(1 + 7 I_v) of EN 1991-1-4 for " \
               "its terrain]",                                                                               \
               WF_OF_SITE(in)),                                                                              \
        WORD("--design", in.design.code, "CODE", wf_design_word, NULL,                                       \
             "take the design wind of a code in place of --wind; `windfirm wind list` shows them",           \
             WF_OF_SITE(in)),                                                                                \
        NUMBER("--basic-wind", in.design.basic, "SPEED", SPEED, "m/s", 1, 120, NULL,                         \
               "basic wind of the code, averaged as the code does", WF_OF_SITE(in)),                         \
        NUMBER("--basic-pressure", in.design.pressure, "PRESSURE", PRESSURE, "kPa", 0.001, 10, NULL,         \
               "in its place, the basic pressure: w0 of gb50009, q_p0 of sia261", WF_OF_SITE(in)),           \
        TEXT("--region", in.design.region, "NAME", NULL, "wind region of asnzs1170", WF_OF_SITE(in)),        \
        NUMBER("--return-period", in.design.years, "YEARS", NONE, NULL, 0, 1e6, NULL,                        \
               "of the design wind [that of the basic wind]", WF_OF_SITE(in))

/* How the mean wind grows with height; into a struct wf_profile_words. */
#define WF_OF_PROFILE(in) WF_UNUSED(in, wf_profile_row_unused)
#define WF_PROFILE_ROWS(in)                                                                                  \
    WORD("--profile", in.name, "NAME", wf_profile_word, NULL,                                                \
         "how the wind grows with height [power; terrain with --terrain or --site; that of --design; "       \
         "measured with --profile-file]"),                                                                   \
        PATH("--profile-file", in.file, "FILE", NULL,                                                        \
             "measured mean winds, a CSV with columns height_m and speed_ms; only their ratios count, "      \
             "--wind gives the speed at the reference height"),                                              \
        NUMBER("--reference-height", in.reference_height, "LENGTH", LENGTH, "m", 0.01, 1000, "10",           \
               "height at which the wind has the speed named"),                                              \
        NUMBER("--exponent", in.exponent, "NUMBER", NONE, NULL, 0, 1, NULL, "of the power profile [0.16]",   \
               WF_OF_PROFILE(in)),                                                                           \
        NUMBER("--roughness", in.roughness, "LENGTH", LENGTH, "m", 1e-6, 10, NULL,                           \
               "roughness length of the log and canopy profiles [0.03 m; with canopy 0.1 of its height]",    \
               WF_OF_PROFILE(in)),                                                                           \
        NUMBER("--displacement", in.displacement, "LENGTH", LENGTH, "m", 0, 100, NULL,                       \
               "zero-plane displacement: height the log profile is lifted by, above and in a stand [0 m; "   \
               "with canopy 0.7 of its height]",                                                             \
               WF_OF_PROFILE(in)),                                                                           \
        NUMBER("--canopy-height", in.canopy_height, "LENGTH", LENGTH, "m", 0, 100, NULL,                     \
               "of the stand around the tree, for the canopy profile [displacement / 0.7]",                  \
               WF_OF_PROFILE(in)),                                                                           \
        NUMBER("--attenuation", in.attenuation, "NUMBER", NONE, NULL, 0, 10, NULL,                           \
               "of the wind inside the canopy [0: joins the log law smoothly]", WF_OF_PROFILE(in)),          \
        WF_SITE_ROWS(in)

/* How the peak load follows from the mean wind. */
struct wf_peak_asked {
    const char *method, *table, *exponent;   /* NULL: not given */
    double damping;                          /* of critical; NAN: not given */
    double spacing, stand_height, edge, gap; /* [m]; NAN: not given */
};
const char *wf_peak_word(size_t i);
bool wf_peak_row_unused(const void *options, const struct wf_option *o, char *why);
#define WF_OF_PEAK(in) WF_UNUSED(in, wf_peak_row_unused)
#define WF_PEAK_ROWS(in)                                                                                     \
    WORD("--peak", in.method, "METHOD", wf_peak_word, NULL,                                                  \
         "how the load of gusts follows from the mean wind: by a code (en1991, gb50009, asce7), for stands " \
         "(gales), a steady wind of the gust's speed (gust), a table of factors, or mean: no gusts "         \
         "[en1991; mean with the preset of a paper]"),                                                       \
        NUMBER("--damping", in.damping, "NUMBER", NONE, NULL, 0.001, 0.5, NULL,                              \
               "structural damping of the tree's sway, of critical [the species'; else 0.05, assumed, and "  \
               "at most 0.10 with the damping of the air]",                                                  \
               WF_OF_PEAK(in)),                                                                              \
        CHOICE("--gust-exponent", in.exponent, "HOW", "square|law", "square",                                \
               "how the load grows from the mean wind to the gust: by the square of the speed, or by the "   \
               "crown's streamlining law, which gives a lower load",                                         \
               WF_OF_PEAK(in)),                                                                              \
        PATH("--peak-table", in.table, "FILE", NULL,                                                         \
             "factors on the mean wind load, a CSV with columns speed_ms and factor; of --peak table",       \
             WF_OF_PEAK(in)),                                                                                \
        NUMBER("--spacing", in.spacing, "LENGTH", LENGTH, "m", 0.1, 100, NULL,                               \
               "mean distance between the trees of the stand; of --peak gales", WF_OF_PEAK(in)),             \
        NUMBER("--stand-height", in.stand_height, "LENGTH", LENGTH, "m", 1, 120, NULL,                       \
               "height of the stand [that of the tree]; of --peak gales", WF_OF_PEAK(in)),                   \
        NUMBER("--edge-distance", in.edge, "LENGTH", LENGTH, "m", 0, 1e5, NULL,                              \
               "distance of the tree from the upwind edge of the stand [9 heights: well inside; 0 with "     \
               "--site forest-edge]; of --peak gales",                                                       \
               WF_OF_PEAK(in)),                                                                              \
        NUMBER("--gap", in.gap, "LENGTH", LENGTH, "m", 0, 1e5, NULL,                                         \
               "length of the open ground before that edge [10 heights]; of --peak gales", WF_OF_PEAK(in))
/* Put them into a scenario; `height` of the tree [m]; `preset`: whether a paper's preset is used. A table is
 * read; its mistakes are in `d`. */
enum wf_status wf_peak_asked_read(const struct wf_peak_asked *asked, bool preset, struct wf_arena *a,
                                  struct wf_diag *d, struct wf_scenario *out, struct wf_err *e);

/* Water that rain leaves on the leaves of a tree. */
struct wf_water_asked {
    const char *storage; /* row of wf_storages                */
    double film, rain;   /* [m], [m/s]; NAN: not given        */
};
const char *wf_storage_word(size_t i);
bool wf_water_row_unused(const void *options, const struct wf_option *o, char *why);
#define WF_OF_WATER(in) WF_UNUSED(in, wf_water_row_unused)
#define WF_WATER_ROWS(in)                                                                                    \
    NUMBER("--water-film", in.film, "DEPTH", LENGTH, "mm", 0, 5, NULL,                                       \
           "rain held by the leaves, per one-sided leaf area: added mass; the tree is compared with the "    \
           "dry one"),                                                                                       \
        NUMBER("--rain", in.rain, "RATE", SPEED, "mm/h", 0, 3600, NULL,                                      \
               "rain that has filled what leaves can hold, see --storage; heavier rain fills it sooner",     \
               WF_OF_WATER(in)),                                                                             \
        WORD("--storage", in.storage, "NAME", wf_storage_word, "watergap",                                   \
             "water that leaves hold per one-sided area: watergap 0.3 mm, dipped 0.19 mm, simulator-least "  \
             "0.51 mm, simulator-most 1.81 mm",                                                              \
             WF_OF_WATER(in))
/* Water per one-sided leaf area that these words mean [kg m-2]; 0: dry. */
double wf_water_asked_film(const struct wf_water_asked *w);
/* Where it is a storage: a warning that says whose. */
void wf_water_asked_warn(const struct wf_water_asked *w, struct wf_diag *d);

/* What is said of soil and root. */
struct wf_anchorage_asked {
    const char *soil, *rooting, *method; /* NULL: not given */
    const char *curve, *table;
    double pull_moment, secant; /* [N m], [N m rad-1]; NAN: not given */
};
const char *wf_soil_word(size_t i);
const char *wf_season_meant(const char *text);
bool wf_anchorage_row_unused(const void *options, const struct wf_option *o, char *why);
#define WF_ANCHORAGE_ROWS(in)                                                                                \
    WORD(                                                                                                    \
        "--soil", in.soil, "KIND", wf_soil_word, NULL,                                                       \
        "ground that the roots are in: unless a test says more, anchorage is then taken by size, of trees "  \
        "in several soils, so that overturning is assessed; unknown: it is not; sand and loam are mineral, " \
        "gley is gleyed",                                                                                    \
        .meant = wf_soil_meant),                                                                             \
        CHOICE("--rooting", in.rooting, "DEPTH", "shallow|medium|deep", NULL,                                \
               "depth of the roots, for rows of --anchorage-table: below 40 cm, 40 to 80 cm, above 80 cm",   \
               WF_UNUSED(in, wf_anchorage_row_unused)),                                                      \
        NUMBER("--pull-moment", in.pull_moment, "MOMENT", MOMENT, "kN m", 1e-3, 1e5, NULL,                   \
               "anchorage by a pulling test: moment on the ground at 0.25 deg of the root plate; 2.5 times " \
               "that overturns the tree"),                                                                   \
        NUMBER("--root-secant", in.secant, "STIFFNESS", ROTATIONAL_STIFFNESS, "N m/rad", 1, 1e12, NULL,      \
               "the same by the root's secant stiffness at 0.25 deg"),                                       \
        PATH("--tipping-curve", in.curve, "FILE", NULL,                                                      \
             "the same by a measured curve up to its largest moment, a CSV with columns phi_deg and "        \
             "moment_kNm"),                                                                                  \
        PATH("--anchorage-table", in.table, "FILE", NULL,                                                    \
             "the same per mass of the stem: a CSV with columns species, soil, rooting and Nm_per_kg"),      \
        CHOICE("--anchorage", in.method, "METHOD", "size|mass|root-stiffness", NULL,                         \
               "the same without a test: by diameter and height; by the stem's mass, of four conifers of "   \
               "British Columbia; or by --root-stiffness, where that was fitted at 0.25 deg")
/* Put them into a scenario; the stiffness of --root-stiffness (NAN: none). Files are read; their mistakes are
 * in `d`. */
enum wf_status wf_anchorage_asked_read(const struct wf_anchorage_asked *asked, double root_stiffness,
                                       struct wf_arena *a, struct wf_diag *d, struct wf_scenario *out,
                                       struct wf_err *e);

/* A gust model's parameters and file; into any struct with texts set, file (NULL: not given) and a struct
 * wf_record_words record. `f`: when they have no effect. */
#define WF_GUST_ROWS(in, f)                                                                                  \
    TEXT("--set", in.set, "NAME=NUMBER,...", NULL,                                                           \
         "parameters of the gust model; `windfirm wind list` shows them", .unused = f),                      \
        PATH("--file", in.file, "FILE", NULL,                                                                \
             "anemometer CSV of the gust model record (of `windfirm wind rose`: a wind climate)",            \
             .unused = f),                                                                                   \
        TEXT("--columns", in.record.columns, "T,U[,V[,W]]", WF_RECORD_COLUMNS,                               \
             "its columns: time, two horizontal components (or one speed) and the vertical one; units are "  \
             "read from the names (t_s, u_kmh, v_kn) or the logger's head, T - means that there is no time", \
             .unused = f),                                                                                   \
        NUMBER("--rate", in.record.rate, "FREQUENCY", FREQUENCY, "Hz", 1e-3, 1e4, NULL,                      \
               "rows a second of a record without a time column", .unused = f),                              \
        TEXT("--missing", in.record.missing, "NUMBER,...|none", NULL,                                        \
             "numbers that mean 'no reading' in the file's own unit; none: every number is a wind [found: "  \
             "negative speeds, and impossible numbers that are repeated]",                                   \
             .unused = f),                                                                                   \
        CHOICE("--dates", in.record.dates, "ORDER", "day-first|month-first", NULL,                           \
               "of dates such as 05/01/2024 [found by a number above 12]", .unused = f)

/* What of a scan is taken. The rows end with designators of when they have no effect. */
struct wf_scan_asked {
    const char *tree_id, *scan_model; /* NULL: not given */
    bool force, cap_children;
};
#define WF_SCAN_ROWS(in, ...)                                                                                \
    TEXT("--tree-id", in.tree_id, "ID", NULL,                                                                \
         "which tree of a file of several: a value of its column treeID, or the number of the line of the "  \
         "tree, from 1",                                                                                     \
         __VA_ARGS__),                                                                                       \
        TEXT("--scan-model", in.scan_model, "N|all", NULL,                                                   \
             "which model of a MATLAB file with several models of one tree, from 1 [the first]; all: the "   \
             "range over the models (tree info, analyze)",                                                   \
             __VA_ARGS__),                                                                                   \
        FLAG("--force", in.force,                                                                            \
             "take a measured tree whose stems stand more than 2 m apart, or of whose wood more than 25 % "  \
             "was not scanned",                                                                              \
             __VA_ARGS__),                                                                                   \
        FLAG("--cap-children", in.cap_children,                                                              \
             "thin measured branches that are thicker than what they grow on", __VA_ARGS__)

/* How tree files are read. */
struct wf_import_asked {
    struct wf_scan_asked scan;
    const char *format, *length_unit, *diameter_unit; /* NULL: not given */
    bool strict;
};
/* `f`: when they have no effect; NULL: never. */
#define WF_IMPORT_ROWS(in, f)                                                                                \
    WORD("--format", in.format, "FORMAT", wf_import_word, NULL,                                              \
         "of the files; by default recognised by their content", .letter = "-f", .unused = f),               \
        FLAG("--strict", in.strict, "refuse a file that needs a repair", .unused = f),                       \
        CHOICE("--length-unit", in.length_unit, "UNIT", "m|cm|mm", NULL,                                     \
               "of coordinates and lengths whose column names no unit (m; MTG: cm)", .unused = f),           \
        CHOICE("--diameter-unit", in.diameter_unit, "UNIT", "m|cm|mm", NULL,                                 \
               "of radii and diameters whose column names no unit (as lengths; MTG: by size)", .unused = f), \
        WF_SCAN_ROWS(in.scan, .unused = f)
/* The same as the library takes it. */
struct wf_import_options wf_import_asked_options(const struct wf_import_asked *asked);

/* Which tree is meant: a model or a measured tree, and its season. */
struct wf_tree_asked {
    const char *model, *file;         /* one of them; NULL: not given                    */
    const char *joint;                /* of a measured tree: "axis" or "bridge"          */
    double leaf_area;                 /* in place of the model's [m2]; NAN: the model's */
    const char *season;               /* "leaf_on" or "leaf_off"; NULL: the model's      */
    struct wf_silhouette crown;       /* in place of the model's; NAN: not given */
    const char *crown_form, *outline; /* NULL: not given                         */
    double outline_base, outline_top; /* heights of an SVG's lowest and highest point [m]; NAN: not given */
    bool unload, strict;
    const char *rest;    /* "as-drawn" or "stress-free"; NULL: a measured tree as drawn, a model as it says */
    const char *scanned; /* "leaf_on" or "leaf_off"; NULL: as the season */
    const char *bark, *cavities; /* NULL: the model's */
    struct wf_scan_asked scan;
};
#define WF_TREE_ROWS(in)                                                                                     \
    PATH("--model", in.model, "MODEL", NULL,                                                                 \
         "tree model: a file, or the name of a shipped one (culm, moso_culm)", .letter = "-m"),              \
        PATH("--tree", in.file, "FILE", NULL,                                                                \
             "a measured tree in place of a model, any format of 'windfirm import'", .letter = "-t"),        \
        CHOICE("--joint", in.joint, "HOW", "axis|bridge", "axis",                                            \
               "how branches of a measured tree are held: where they leave the parent's axis, or at its "    \
               "end",                                                                                        \
               WF_UNUSED(in, wf_tree_row_unused)),                                                           \
        NUMBER("--leaf-area", in.leaf_area, "AREA", AREA, "m2", 0, 1e5, NULL,                                \
               "one-sided leaf area of the whole tree, in place of the model's; a measured tree has none"),  \
        CHOICE("--season", in.season, "SEASON", "leaf_on|leaf_off", NULL,                                    \
               "in place of the model's: with its leaves, or when they have fallen",                         \
               .meant = wf_season_meant, WF_UNUSED(in, wf_tree_row_unused)),                                 \
        CHOICE(                                                                                              \
            "--rest", in.rest, "STATE", "as-drawn|stress-free", NULL,                                        \
            "what the shape measured or drawn is: as-drawn: the tree standing under its own weight, whose "  \
            "forces are in it [a measured tree]; stress-free: its weight bends it further"),                 \
        CHOICE("--scanned", in.scanned, "SEASON", "leaf_on|leaf_off", NULL,                                  \
               "whether the tree carried its leaves in the shape measured or drawn [as in --season]",        \
               WF_UNUSED(in, wf_tree_row_unused)),                                                           \
        FLAG("--strict", in.strict,                                                                          \
             "refuse a tree with parts that would not stand in the shape drawn, which are else stiffened"),  \
        NUMBER(                                                                                              \
            "--frontal-area", in.crown.area, "AREA", AREA, "m2", 1e-3, 1e4, NULL,                            \
            "area of the crown in leaf, seen from the side in still air: the wind's load is on it, not on "  \
            "the leaf area"),                                                                                \
        NUMBER("--crown-width", in.crown.width, "LENGTH", LENGTH, "m", 0.01, 100, NULL,                      \
               "with --crown-depth and --crown-form, in place of --frontal-area"),                           \
        NUMBER("--crown-depth", in.crown.depth, "LENGTH", LENGTH, "m", 0.01, 150, NULL,                      \
               "height of the crown from its base to the top of the tree"),                                  \
        CHOICE("--crown-form", in.crown_form, "FORM", "ellipse|triangle|diamond|paraboloid|rectangle", NULL, \
               "its share of the rectangle: 0.785, 0.5, 0.5, 0.667, 1 [ellipse]"),                           \
        PATH(                                                                                                \
            "--crown-outline", in.outline, "FILE", NULL,                                                     \
            "the crown's outline on a photograph, in place of --frontal-area: a table with the columns x_m " \
            "and z_m (height above the ground), a point a row, or an SVG file with one closed path"),        \
        NUMBER("--outline-base", in.outline_base, "HEIGHT", LENGTH, "m", 0, 150, NULL,                       \
               "of the lowest point of an SVG's outline above the ground",                                   \
               WF_UNUSED(in, wf_tree_row_unused)),                                                           \
        NUMBER("--outline-top", in.outline_top, "HEIGHT", LENGTH, "m", 0.01, 150, NULL,                      \
               "of its highest point: both scale the drawing", WF_UNUSED(in, wf_tree_row_unused)),           \
        NUMBER("--crown-mass", in.crown.mass, "MASS", MASS, "kg", 1e-6, 1e6, NULL,                           \
               "fresh mass of branches and leaves of a stem without branches"),                              \
        NUMBER("--crown-density", in.crown.density, "DENSITY", DENSITY, "kg/m3", 1e-3, 100, NULL,            \
               "the same per volume of the cone of crown width and depth; ForestGALES: 2.5 most "            \
               "conifers, 1.22 birch, 1.38 beech and oak"),                                                  \
        TEXT("--crown-mass-by", in.crown.by, "RULE", NULL,                                                   \
             "the same by a rule: forestgales, per volume of the cone, or wcc, by the diameter at 1.3 m; "   \
             "the "                                                                                          \
             "kind of the species, or RULE:KIND (forestgales:oak)"),                                         \
        NUMBER(                                                                                              \
            "--leaf-off-share", in.crown.leafless, "SHARE", NONE, NULL, 0, 1, NULL,                          \
            "share of the crown's load that is left in the season leaf_off [0.5 without branches, else 0]"), \
        TEXT("--bark", in.bark, "THICKNESS", NULL,                                                           \
             "bark of the stem, which is mass without strength or stiffness: a thickness at 1.3 m (15mm), "  \
             "species, or none [by the species for a measured tree; the model's]"),                          \
        TEXTS("--cavity", in.cavities, "AT:WALL|AT:FILE|FILE",                                               \
              "cavities of the stem in place of the model's: height and sound wall (1.3m:80mm), height and " \
              "a tomograph's CSV (angle_deg, outer_m, sound_m), or a YAML file with 'cavities'"),            \
        FLAG("--unload", in.unload,                                                                          \
             "find the stress-free shape of a tree that stands under its own weight, and take that"),        \
        WF_SCAN_ROWS(in.scan, WF_UNUSED(in, wf_tree_row_unused))

/* "20 %", at most 90 %, or "3 m", at most 50 m; NULL: nothing. Returned: whether it is one of them; in *out
 * which. */
bool wf_reduction_read(const char *text, struct wf_reduced *out);
/* "40 %" all around, "30deg:120deg" or "30deg:120deg:40 %", clockwise from north; NULL: nothing. Returned:
 * whether it is one of them; in *q the loss, its sector as on a compass: middle and half the width [rad]. */
bool wf_root_loss_read(const char *text, struct wf_anchorage_request *q);

/* The joint of a measured tree that a word of --joint means. */
enum wf_joint wf_joint_named(const char *word);
/* Is exactly one tree specified? Returned: -1 to go on, 2 after saying what is missing. `file`: a tree file
 * given otherwise than by --tree; NULL: none. */
int wf_tree_asked_check(const struct wf_tree_asked *t, const char *command, const char *file);
/* Put what is specified beside the tree itself on a model: season, state at rest, bark, cavities, crown.
 * `imported`: it is a measured tree. Errors: as below. */
enum wf_status wf_tree_asked_onto(const struct wf_tree_asked *t, bool imported, struct wf_arena *a,
                                  struct wf_model *out, struct wf_diag *d, struct wf_err *e);
/* Read the specified tree, or `file`, in the specified season. Returned: *out; *path, the file it was read
 * from. Errors: mistakes of a file are findings in `d`; any other error is in `e`. */
enum wf_status wf_tree_asked_read(const struct wf_tree_asked *t, const char *file, struct wf_arena *a,
                                  struct wf_model *out, const char **path, struct wf_diag *d,
                                  struct wf_err *e);
#endif
