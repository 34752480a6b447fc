/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/reader.h"
#include "base/arena.h"
#include "base/file.h"
#include "base/text.h"
#include "out/folder.h"
#include <dirent.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

/* The form of a document. A key means the same in every kind of document, so one table serves them all. A
 * quantity is an object of value, unit and reason. */

enum { NUMBER = 1, COUNT = 2, TEXT = 4, FLAG = 8, LIST = 16, OBJECT = 32 };

static const struct {
    unsigned types;
    const char *keys;
} rows[] = {
    { COUNT, "across answers axes branch_count columns cylinder evaluations frames freedom full hole "
             "iterations keys number passes readings records resampled rows run segment segments size "
             "censored decimals left_out lost_in_still_air samples slit starts starts_same transmitting up "
             "facets fell grid hits hung leaves merged missed ran "
             "scene springs vertices wood_hits" },
    { COUNT | LIST, "branches levels prisms" },
    { COUNT | TEXT, "level seed version" },
    { FLAG,
      "from_specified gustier open conifer damping_known staged as_printed converged energy estimated given "
      "nuisance priors "
      "stands_at_low stands_at_high searched_to_the_end beyond_loss counts_self_weight loses_tree "
      "applies unsaid "
      "sigma_estimated small_deflection spectral stopped twig used within within_limits" },
    { LIST, "guys braces record removals scenarios holds union_classes largest_unions cavities wall_limits "
            "least_walls_mm outline_x_mm outline_y_mm thicknesses not_assessed at "
            "classes_m_s criteria figures files findings hours_a_year_above "
            "methods move_m "
            "not_determined parameters ratios run_files runs sectors sensors share slabs statistics step_m "
            "blocks modes budget criticals_m_s drags_N deflections_m frequencies_Hz moments_N_m speeds sways "
            "swing_m args "
            "lost_by safeties varied table_share wind_notes parts "
            "table_speed_m_s tables taper_at taper_share thirds trees "
            "values walls warnings wind_m_s winds" },
    { LIST | OBJECT, "directions" },
    { NUMBER, "aspect_ratio ratio_from at_m from_m to_m wood_radius_mm thinnest_wall_mm strength_loss "
              "worst_towards_deg "
              "strength_loss_with_wind stiffness_loss safety_basic safety_present wall_share wall_safety "
              "aicc arriving_ratio asked base_moment_open_N_m base_moment_own_N_m beam bootstrap_high "
              "bootstrap_low bound_high bound_low cell_m chi_square coherence_error components "
              "covered_m2 damping damping_sd deviation_m_s flux_ratio frequency frequency_sd from_deg "
              "front_m gain got gust_factor gust_period_s gust_periods gust_window_s "
              "height_above_ground_m high highest_m_s hill_half_width_m inner_layer_m intensity joint "
              "kurtosis largest_m leaf_m2 leeward_m length length_scale_m low lowest_m_s mean mean_m "
              "mean_m_s middle own_aicc own_m peak_factor points reduced_chi_square reference_height_m "
              "rms roughness_m scatter sd shape sigma skewness speed_exceeded_0_1_percent_m_s "
              "speed_exceeded_1_percent_m_s speed_m_s speed_share start steepest_slope step_s steps "
              "time_scale_s tip tip_deflection_largest_m tip_deflection_mean_m topex_distance_m "
              "transmission typed_sum value wind_mean_m_s windward_m within_5_percent wood_m2 "
              "youngs_modulus_Pa film_mm leaf_area_m2 mass_kg decrement diameter_mm drops duration_s "
              "euler_limit_s fallen_at_s "
              "frequency_Hz frequency_percent hanging_mg intensity_mm_h paper restoring_N_m "
              "ring_decrement ring_frequency_Hz spread_mm steps_a_second tests_a_way tip_percent "
              "beta searched_to_gust_m_s critical_at_high_m_s critical_at_low_m_s high_gust_m_s high_m_s "
              "low_gust_m_s low_m_s "
              "median_m_s middle_gust_m_s middle_m_s searched_to_m_s "
              "air diameter_m line_first_Hz line_slope_Hz_m mass_across mass_along mass_up "
              "ratio_to_measured structural tree_frequency tree_share turn_across turn_along "
              "exceedance_a_year exceedance_over_life life_years return_period_low return_period_high "
              "exceedance_at_low_end branch_gusts branch_damping "
              "required cut least_reduction least_reduction_cut least_reduction_tried "
              "saturated_low saturated_high twist_percent water_off energy_off with_restoring "
              "frequency_with_restoring damping_ratio" },
    { NUMBER | LIST, "correlation explained" },
    { NUMBER | OBJECT, "height height_m profile_high profile_low speed" },
    { OBJECT,
      "distance towards stiffness pretension pull pull_critical slack breaking branch_safety "
      "unions above branch branch_diameter above_diameter below_diameter "
      "assessment breakage overturning sound return_period judged_to "
      "branch_strength factor required_safety resistance stress "
      "verdict anchorage moment moment_by_method moment_carried branches_from critical_gust loss_safety "
      "thickness_low thickness_high "
      "fails_at "
      "measured mean_state peak peak_method structural_damping load_breadth load_factor_gusts "
      "stand_spacing stand_height edge_distance gap winter_wind "
      "load_factor_branches "
      "sway_frequency participation modal_mass damping_total damping_air turbulence background resonance "
      "peak_of_gusts carried gust_over_mean wind_height clusters wetted winter gust_load_factor air_density "
      "all altitude attenuation "
      "averaging_time axis_drag azimuth "
      "base_moment "
      "base_radius base_shear canopy_height critical critical_speed critical_stem first crown_base "
      "crown_top displacement drag exponent fit from governing_section gradient gravity "
      "interval lognormal "
      "hours_a_year hours_a_year_10_min imbalance largest_stress leaf_area lean lean_azimuth "
      "least_safety lift load_factor main_from method moved north position provenance "
      "reference_height reference_speed reynolds_high reynolds_low rival roughness safety "
      "scenario schema searched_to site_x site_y speed_high speed_low speed_up streamlining "
      "weight_stress node_spacing strongest_10_min_over_hourly sweep sweep_speed_high taper_power "
      "temperature tip_angle "
      "tip_deflection tip_deflection_share tip_share top top_deflection topex_deg utilisation weight "
      "wind_factor "
      "wind_profile" },
    { TEXT,
      "word least_reduction_unknown return_period_bound return_period_low_bound return_period_high_bound "
      "exceedance_at_low_end_text "
      "return_period_by exceedance_a_year_text exceedance_over_life_text "
      "wants form from_point to_point of stepping term air_density_from averaging_law beaufort beaufort_text "
      "bound climate_file "
      "code command "
      "criterion date differs direction file generator ground_file gust key kind latin meaning name "
      "name_zh note outcome outcome_text part path preset profile profile_file program quantity "
      "reason reference message model_name species_zh role scope script season sensor sha256 source "
      "species_name status "
      "status_text taper terrain test text title tree unit validity winds_said terrain_text terrain_from "
      "site_kind design safety_criterion "
      "wind_terrain" },
    { TEXT | OBJECT, "law loss model shelter solver species" },
};

enum { DEPTH_MAX = 32, MISTAKES_MAX = 20 };
static const size_t text_max = 1 << 20, list_max = 1000 * 1000;
static const double number_max = 1e100, count_max = 1e15;

struct check {
    const char *file;
    struct wf_arena scratch; /* of messages */
    struct wf_diag *d;
    size_t mistakes;
    char place[256]; /* "trees[0].species" */
};

static unsigned types_of(const char *key)
{
    size_t n = strlen(key);
    for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
        for (const char *at = rows[i].keys; (at = strstr(at, key)); at += n)
            if ((at == rows[i].keys || at[-1] == ' ') && (at[n] == ' ' || !at[n])) return rows[i].types;
    return 0;
}

static unsigned type_of(const json_t *v)
{
    switch (json_typeof(v)) {
    case JSON_OBJECT:
        return OBJECT;
    case JSON_ARRAY:
        return LIST;
    case JSON_STRING:
        return TEXT;
    case JSON_INTEGER:
        return json_integer_value(v) >= 0 ? NUMBER | COUNT : NUMBER;
    case JSON_REAL:
        return NUMBER;
    default:
        return FLAG;
    }
}

static void mistake(struct check *c, const json_t *v, const char *wanted)
{
    if (++c->mistakes > MISTAKES_MAX) return;
    char *said = json_dumps(v, JSON_COMPACT | JSON_ENCODE_ANY | JSON_REAL_PRECISION(12));
    const char *brief = said ? wf_text_shortened(said, 60, &c->scratch) : NULL;
    wf_diag_error(c->d, c->file, 0, 0, "%s: %s is not %s", c->place, brief ? brief : "this", wanted);
    free(said);
}

static const char *name_of(unsigned types)
{
    static const struct {
        unsigned type;
        const char *name;
    } names[] = { { NUMBER, "a number" },    { COUNT, "a count" }, { TEXT, "a text" },
                  { FLAG, "true or false" }, { LIST, "a list" },   { OBJECT, "an object" } };
    for (size_t i = 0; i < sizeof names / sizeof *names; i++)
        if (types & names[i].type) return names[i].name;
    return "known";
}

/* Bounds of one value; they hold for every key. */
static const char *beyond(const json_t *v, size_t depth)
{
    if (depth > DEPTH_MAX) return "nested less than 32 deep";
    if (json_is_string(v) && json_string_length(v) > text_max) return "shorter than 1 MB";
    if (json_is_array(v) && json_array_size(v) > list_max) return "shorter than 1000000 items";
    if (json_is_integer(v) && fabs((double)json_integer_value(v)) > count_max) return "a number up to 1e15";
    if (json_is_real(v) && !(fabs(json_real_value(v)) <= number_max)) return "a number up to 1e100";
    return NULL;
}

static void check_value(struct check *c, const json_t *v, unsigned allowed, size_t depth);

/* Check a member or an item, with its name at the end of the place. */
static void check_part(struct check *c, const json_t *v, unsigned allowed, size_t depth, const char *name)
{
    size_t n = strlen(c->place);
    snprintf(c->place + n, sizeof c->place - n, "%s", name);
    check_value(c, v, allowed, depth);
    c->place[n] = '\0';
}

static void check_value(struct check *c, const json_t *v, unsigned allowed, size_t depth)
{
    char name[80];
    const char *bound = beyond(v, depth);
    if (bound) {
        mistake(c, v, bound);
        return;
    }
    if (allowed && !json_is_null(v) && !(type_of(v) & allowed)) mistake(c, v, name_of(allowed));
    for (size_t i = 0; i < json_array_size(v); i++) {
        snprintf(name, sizeof name, "[%zu]", i);
        check_part(c, json_array_get(v, i), allowed ? NUMBER | OBJECT | LIST : 0, depth + 1, name);
    }
    /* jansson's iterator needs an object that is not const, although it does not change it. */
    union {
        const json_t *given;
        json_t *wanted;
    } o = { .given = v };
    for (void *at = json_object_iter(o.wanted); at; at = json_object_iter_next(o.wanted, at)) {
        const char *key = json_object_iter_key(at);
        snprintf(name, sizeof name, "%s%.70s", *c->place ? "." : "", key);
        check_part(c, json_object_iter_value(at), types_of(key), depth + 1, name);
    }
}

enum wf_status wf_document_read(const char *path, json_t **out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_bytes text;
    json_error_t why;
    struct check c = { .file = path, .d = d };
    *out = NULL;
    enum wf_status code = wf_file_read(path, &c.scratch, &text, e);
    if (!code && !(*out = json_loadb(text.data, text.size, JSON_REJECT_DUPLICATES, &why)))
        code = wf_fail(e, WF_EINPUT, "%s:%d:%d: error: %s", path, why.line, why.column, why.text);
    const char *name = json_string_value(json_object_get(json_object_get(*out, "schema"), "name"));
    if (!code && (!name || strncmp(name, "windfirm-", strlen("windfirm-")) != 0))
        code = wf_fail(e, WF_EINPUT, "%s: is not a results document of windfirm", path);
    if (!code) check_value(&c, *out, OBJECT, 0);
    if (c.mistakes > 0)
        code = wf_fail(e, WF_EINPUT, "%s: %zu value%s not of the form that windfirm writes", path, c.mistakes,
                       c.mistakes > 1 ? "s are" : " is");
    if (code) json_decref(*out), *out = NULL;
    wf_arena_free(&c.scratch);
    return code;
}

/* Tables. */

enum { LINE_MAX_BYTES = 1 << 20 };

/* A table as far as it was read. */
struct table {
    size_t line, columns, cells;
    bool inside; /* a quoted cell, which may go on in the next line */
};

/* Count the cells of a line; quotes hold commas, and are doubled within. */
static void count_cells(struct table *t, const char *line)
{
    t->cells += !t->inside;
    for (; *line; line++) {
        if (*line == '"') t->inside = !t->inside;
        if (*line == ',' && !t->inside) t->cells++;
    }
}

static bool plain_head(const char *line)
{
    static const char allowed[] = "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789_-.,";
    return *line && !line[strspn(line, allowed)];
}

/* What is wrong with a line, NULL when nothing is. */
static const char *wrong(struct table *t, const char *line, size_t size, bool numbers)
{
    struct wf_utf8_fault fault;
    if (!wf_utf8_valid(line, size, &fault)) return "is not UTF-8 text";
    for (size_t i = 0; i < size; i++)
        if ((unsigned char)line[i] < 0x20 && line[i] != '\t') return "holds a control character";
    if (numbers) return line[strspn(line, "0123456789+-.eEnaif \t")] ? "is not a row of numbers" : NULL;
    if (t->line == 1 && !plain_head(line)) return "is not a head of plain names";
    if (!size && !t->inside) return NULL; /* between the rows of a grid */
    count_cells(t, line);
    if (t->inside) return NULL;
    if (t->line == 1) t->columns = t->cells;
    bool fits = t->cells == t->columns;
    t->cells = 0;
    return fits ? NULL : "has another number of cells than the head";
}

static enum wf_status check_table(const char *path, bool numbers, struct wf_err *e)
{
    enum wf_status code = WF_OK;
    char *line = NULL;
    size_t room = 0;
    struct table t = { 0 };
    ssize_t n;
    FILE *f = fopen(path, "rbe");
    if (!f && errno == ENOENT) return WF_OK; /* the figure that wants it says so */
    if (!f) return wf_fail(e, WF_EINPUT, "%s: cannot be read: %s", path, strerror(errno));
    while (!code && (n = getdelim(&line, &room, '\n', f)) > 0) {
        t.line++;
        if (line[n - 1] == '\n') line[--n] = '\0';
        const char *why = n > LINE_MAX_BYTES ? "is longer than 1 MB" : wrong(&t, line, (size_t)n, numbers);
        if (why) code = wf_fail(e, WF_EINPUT, "%s:%zu: the line %s", path, t.line, why);
    }
    if (!code && t.inside) code = wf_fail(e, WF_EINPUT, "%s:%zu: a quote is not closed", path, t.line);
    free(line);
    fclose(f);
    return code;
}

static bool is_csv(const char *name)
{
    size_t n = strlen(name);
    return n > 4 && !strcmp(name + n - 4, ".csv");
}

enum wf_status wf_tables_check(const char *folder, struct wf_err *e)
{
    static const char *const plots[] = { "plots/run.csv", "plots/tree.csv", "plots/tree.dat" };
    char path[WF_PATH_MAX], name[300];
    enum wf_status code = wf_folder_path(folder, "tables", path, e);
    DIR *list = code ? NULL : opendir(path);
    for (struct dirent *at; list && !code && (at = readdir(list));) {
        if (!is_csv(at->d_name)) continue;
        snprintf(name, sizeof name, "tables/%.256s", at->d_name);
        code = wf_folder_path(folder, name, path, e);
        if (!code) code = check_table(path, false, e);
    }
    if (list) closedir(list);
    for (size_t i = 0; !code && i < sizeof plots / sizeof *plots; i++) {
        code = wf_folder_path(folder, plots[i], path, e);
        if (!code) code = check_table(path, !is_csv(plots[i]), e);
    }
    return code;
}
