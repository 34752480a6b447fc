/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_row.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/assess_columns.h"
#include "cmd/commands.h"
#include "cmd/scenarios.h"
#include "data/species.h"
#include "data/species_names.h"
#include "load/drag.h"
#include "out/verdict_part.h"
#include "study/verdict.h"
#include <ctype.h>
#include <errno.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* ---- The columns ---- */

enum { SPECIES_KEPT = 256 };
struct kept_species {
    const char *name; /* as a cell or the command line has it */
    bool cell;
    struct wf_species species;
};

struct wf_tree_columns {
    struct wf_arena arena;
    struct wf_units *units;
    const struct wf_assess_options *line;
    struct wf_args of_rows; /* what of the command line is said of each row */
    const struct wf_rows *rows;
    struct wf_heads heads;
    char *root; /* of the column of files: the folder that they lie in, links resolved */
    size_t kept;
    struct kept_species keep[SPECIES_KEPT];
};

/* ---- Added columns ---- */

static void put_number(double x, FILE *to)
{
    if (isfinite(x)) fprintf(to, "%.5g", x);
}

/* A safety: with all digits where five would put it on the other side of 1 or of the required one. */
static void put_safety(double x, double required, FILE *to)
{
    char text[32];
    if (!isfinite(x)) return;
    (void)snprintf(text, sizeof text, "%.5g", x);
    double shown = strtod(text, NULL);
    bool same = (shown < required) == (x < required) && (shown > 1) == (x > 1);
    fprintf(to, same ? "%.5g" : "%.10g", x);
}

/* A text as a cell: in quotes where it needs them; a spreadsheet must not take it for a formula. */
static void put_text(const char *text, char separator, FILE *to)
{
    bool quote = strpbrk(text, "\"\r\n") || strchr(text, separator);
    if (quote) fputc('"', to);
    if (*text && strchr("=+-@\t", *text)) fputc('\'', to);
    for (const char *p = text; *p; p++) {
        if (*p == '"') fputc('"', to);
        fputc(*p, to);
    }
    if (quote) fputc('"', to);
}

static const char *state_word(const struct wf_tree_row *r)
{
    static const char *const word[] = { "", "", "assessed", "mistake", "failed" };
    return word[r->state];
}

static const struct wf_critical *loss(const struct wf_assess_case *r, enum wf_criterion_id *by)
{
    struct wf_verdict v = wf_verdict_of(r->an.breaks);
    *by = v.criterion;
    return v.loss ? &v.loss->critical : NULL;
}

static void put_result(const struct wf_assess_case *r, char separator, bool years, FILE *to)
{
    const struct wf_assessment *x = &r->x;
    enum wf_criterion_id by;
    const struct wf_critical *c = loss(r, &by);
    enum { SAFETIES = 5 };
    const bool falls = c && c->outcome == WF_CRITICAL_SELF_WEIGHT, /* without wind */
        found = falls || (c && c->outcome == WF_CRITICAL_FOUND);
    const double speed = falls ? 0 : found ? c->speed : (double)NAN;
    put_text(wf_assess_rows[x->word].name, separator, to);
    const double number[] = { x->breakage.safety,
                              x->sound,
                              x->overturning.safety,
                              x->low,
                              x->high,
                              speed,
                              wf_scenario_gust(&r->an.scenario, speed),
                              found ? fmod(x->from * 180 / WF_PI + 360, 360) : (double)NAN };
    for (size_t k = 0; k < WF_COUNT(number); k++) {
        fputc(separator, to);
        if (k < SAFETIES)
            put_safety(number[k], x->required, to);
        else
            put_number(number[k], to);
    }
    fputc(separator, to);
    if (found) put_text(wf_criteria[by].name, separator, to);
    if (!years) return;
    char text[40];
    fputc(separator, to), put_number(x->years_least || x->years_most ? (double)NAN : x->years, to);
    fputc(separator, to);
    if (isfinite(x->exceedance)) put_text(wf_assess_chance(x, x->exceedance, text), separator, to);
    fputc(separator, to);
    if (isfinite(x->over_life)) put_text(wf_assess_chance(x, x->over_life, text), separator, to);
    fputc(separator, to), put_number(x->breakage.height, to);
}

#define RESULT(p)                                                                                            \
    p "verdict", p "safety_breakage", p "safety_sound", p "safety_overturning", p "safety_low",              \
        p "safety_high", p "critical_wind_m_s", p "critical_gust_m_s", p "critical_wind_from_deg",           \
        p "lost_by"
static const char *const added[] = { "wf_status",
                                     "wf_reason",
                                     RESULT("wf_"),
                                     "wf_return_period_years",
                                     "wf_exceedance_a_year",
                                     "wf_exceedance_over_life",
                                     "wf_section_height_m",
                                     "wf_warnings",
                                     NULL };
static const char *const added_stand[] = { RESULT("wf_stand_"), NULL };

void wf_tree_header_write(const struct wf_tree_columns *c, const char *header, FILE *to)
{
    fputs(header, to);
    for (const char *const *n = added; *n; n++) fprintf(to, "%c%s", c->rows->separator, *n);
    for (const char *const *n = added_stand; *n && c->heads.spacing != WF_HEAD_NONE; n++)
        fprintf(to, "%c%s", c->rows->separator, *n);
    fputc('\n', to);
}

static void put_nothing(size_t cells, char separator, FILE *to)
{
    for (size_t k = 1; k < cells; k++) fputc(separator, to);
}

static void put_warnings(const struct wf_diag *d, char separator, FILE *to)
{
    char text[400] = "";
    for (const struct wf_finding *f = d->first; f; f = f->next) {
        size_t n = strlen(text);
        if (f->severity != WF_WARNING || !f->code || strstr(text, f->code)) continue;
        (void)snprintf(text + n, sizeof text - n, "%s%s", n ? " " : "", f->code);
    }
    put_text(text, separator, to);
}

void wf_tree_row_write(const struct wf_tree_columns *c, const struct wf_tree_row *row, FILE *to)
{
    const char s = c->rows->separator;
    const size_t cells = WF_COUNT(added) - 4, stand = WF_COUNT(added_stand) - 1;
    struct wf_arena scratch = { 0 };
    fputs(row->text, to);
    if (row->state != WF_ROW_BLANK) {
        fputc(s, to), put_text(state_word(row), s, to);
        const char *reason = row->reason ? row->reason : "",
                   *own = row->cp1252 ? wf_utf8_to_cp1252(reason, &scratch) : reason;
        fputc(s, to), put_text(own ? own : "", s, to);
        fputc(s, to);
        if (row->state == WF_ROW_DONE)
            put_result(&row->single, s, true, to);
        else
            put_nothing(cells, s, to);
        fputc(s, to), put_warnings(&row->diag, s, to);
        if (c->heads.spacing != WF_HEAD_NONE) {
            fputc(s, to);
            if (row->state == WF_ROW_DONE && row->in_stand)
                put_result(&row->stand, s, false, to);
            else
                put_nothing(stand, s, to);
        }
    }
    fputc('\n', to);
    wf_arena_free(&scratch);
}

/* ---- Files of trees ---- */

enum { SCAN_MOST = 64 << 20 }; /* largest file of a tree [bytes] */

/* The name of a cell from the folder of the files. */
static const char *scan_named(const struct wf_tree_columns *c, const char *cell, struct wf_arena *a)
{
    const char *folder = c->line->scans, *table = c->rows->file, *slash = strrchr(table, '/');
    if (*cell == '/') return wf_arena_text(a, cell);
    if (folder) return wf_arena_print(a, "%s/%s", folder, cell);
    return wf_arena_print(a, "%.*s%s", slash ? (int)(slash - table + 1) : 0, table, cell);
}

static bool climbs(const char *cell)
{
    for (const char *at = cell; at; at = strchr(at, '/'), at += at != NULL)
        if (!strncmp(at, "..", 2) && (at[2] == '/' || !at[2])) return true;
    return *cell == '/';
}

static bool lies_in(const char *root, const char *path)
{
    size_t n = strlen(root);
    if (n && root[n - 1] == '/') n--;
    return !strncmp(root, path, n) && path[n] == '/';
}

/* May a model name files of its own? A backslash in a YAML text can hide any word. */
static bool names_more(const char *model, struct wf_arena *a)
{
    struct wf_bytes text;
    struct wf_err unsaid = { WF_OK, "" };
    return !wf_file_read_text(model, a, &text, &unsaid) &&
           (strstr(text.data, "rays") || strchr(text.data, '\\'));
}

/* What is wrong with the file of a cell; NULL: nothing. */
static const char *scan_fault(const struct wf_tree_columns *c, const char *cell, const char *path,
                              struct wf_arena *a)
{
    struct stat there;
    const char *out = "leads out of the folder of the table; --scans names another folder", *fault = NULL;
    if (c->line->scans) out = "leads out of the folder of --scans";
    if (!c->line->scans && climbs(cell)) return out;
    char *found = realpath(path, NULL);
    if (!found) return strerror(errno);
    if (!lies_in(c->root, found))
        fault = out;
    else if (stat(found, &there))
        fault = strerror(errno);
    else if (!S_ISREG(there.st_mode))
        fault = "is no file";
    else if (there.st_size > SCAN_MOST)
        fault = "is larger than 64 MB";
    else if (wf_assess_is_yaml(path) && names_more(path, a))
        fault =
            "may name files of its own (rays), or has a backslash: a model that a table names has neither";
    free(found);
    return fault;
}

/* The file that a row names in place of its card. Returned: *out, NULL where there is none. */
static enum wf_status take_scan(const struct wf_tree_columns *c, const struct wf_rows *r,
                                struct wf_tree_row *row, const char **out, struct wf_err *e)
{
    *out = NULL;
    if (c->heads.scan == WF_HEAD_NONE || c->heads.scan >= r->cells) return WF_OK;
    const char *cell = r->cell[c->heads.scan];
    if (wf_csv_missing(cell, strlen(cell))) return WF_OK;
    if (!(*out = scan_named(c, cell, &row->arena)))
        return wf_fail(e, WF_ENOMEM, "not enough memory for a row");
    const char *fault = scan_fault(c, cell, *out, &row->arena);
    if (fault)
        row->reason = wf_arena_print(&row->arena, "%s: '%.60s': %s", r->name[c->heads.scan], cell, fault);
    return WF_OK;
}

/* ---- Opening ---- */

static enum wf_status open_root(struct wf_tree_columns *c, struct wf_err *e)
{
    const char *folder = c->line->scans;
    if (c->heads.scan == WF_HEAD_NONE && folder)
        return wf_fail(e, WF_EUSAGE, "--scans: %s has no column that names files of trees, such as 'scan'",
                       c->rows->file);
    if (c->heads.scan == WF_HEAD_NONE) return WF_OK;
    if (!folder) folder = scan_named(c, ".", &c->arena);
    if (!folder) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    if ((c->root = realpath(folder, NULL))) return WF_OK;
    return wf_fail(e, WF_EINPUT, "%s: %s", folder, strerror(errno));
}

enum wf_status wf_tree_columns_open(struct wf_tree_columns **out, const struct wf_rows *r,
                                    const struct wf_assess_options *line, struct wf_err *e)
{
    struct wf_tree_columns *c = *out = calloc(1, sizeof *c);
    if (!c) return wf_fail(e, WF_ENOMEM, "not enough memory for a table");
    c->rows = r, c->line = line;
    c->of_rows = line->run.args;
    c->of_rows.given[wf_head_option(line->run.args.option, "--reports")] = false;
    c->of_rows.given[wf_head_option(line->run.args.option, "--scans")] = false;
    enum wf_status s = wf_units_open(&c->units, e);
    if (!s) s = wf_heads_read(r, line, c->units, &c->arena, &c->heads, e);
    return s ? s : open_root(c, e);
}

void wf_tree_columns_close(struct wf_tree_columns *c)
{
    if (!c) return;
    wf_units_close(c->units);
    wf_arena_free(&c->arena);
    free(c->root);
    free(c);
}

void wf_tree_columns_say(const struct wf_tree_columns *c, struct wf_arena *a) { wf_heads_say(&c->heads, a); }

enum wf_status wf_tree_columns_check(const struct wf_tree_columns *c, struct wf_err *e)
{
    return wf_heads_check(&c->heads, &c->of_rows, e);
}

/* ---- Reading a row ---- */

/* Does a cell say that there is nothing? "none" is a word of --bark; "no" of what a tree may have or not. */
static bool is_nothing(const char *option, const char *cell)
{
    static const char *const of_things[] = { "--cavity", "--guy", "--cable", "--rod" };
    bool thing = false;
    for (size_t k = 0; k < WF_COUNT(of_things); k++) thing = thing || !strcmp(option, of_things[k]);
    if (thing && wf_text_among("no nein non keine aucune 无 否 没有", cell)) return true;
    return wf_csv_missing(cell, strlen(cell)) && !(!strcmp(option, "--bark") && wf_text_among("none", cell));
}

static bool is_word(const struct wf_option *o, const char *cell)
{
    char list[512];
    const char *word[WF_OPTION_CHOICES];
    for (size_t n = wf_option_choices(o, word, list, sizeof list); n-- > 0;)
        if (!strcmp(word[n], cell)) return true;
    return false;
}

/* "1,3m:80mm" of a table whose cells are not apart by commas: a decimal comma, also of a wind. */
static const char *with_points(const struct wf_tree_columns *c, const struct wf_option *o, const char *cell,
                               struct wf_arena *a)
{
    static const char *const composed[] = { "--cavity", "--guy", "--cable", "--rod", "--bark", "--wind" };
    bool is = false;
    char *text = wf_arena_text(a, cell);
    for (size_t k = 0; k < WF_COUNT(composed); k++) is = is || !strcmp(o->name, composed[k]);
    for (char *p = text; p && is && c->rows->separator != ',' && (p = strchr(p, ',')); p++)
        if (p > text && isdigit((unsigned char)p[-1]) && isdigit((unsigned char)p[1])) *p = '.';
    return text;
}

/* A cell as an option takes it: a plain number in SI where the column has a unit, with a decimal point. NULL:
 * no memory. */
static const char *value_of(const struct wf_tree_columns *c, size_t column, const char *cell,
                            struct wf_arena *a)
{
    const struct wf_head *head = &c->heads.head[column];
    const struct wf_option *o = &c->line->run.args.option[head->option];
    bool speeds = o->kind == WF_OPTION_SPEED || o->kind == WF_OPTION_SPEEDS;
    double v;
    if (is_nothing(o->name, cell) || (head->use == WF_HEAD_WORDS && !is_word(o, cell))) return "";
    if (o->kind != WF_OPTION_NUMBER && !(speeds && isfinite(head->factor))) return with_points(c, o, cell, a);
    const char *end = cell + strlen(cell), *stop = wf_number_read(cell, end, '.', &v);
    if (c->rows->separator != ',' && stop && *stop == ',') stop = wf_number_read(cell, end, ',', &v);
    if (!stop) return wf_arena_text(a, cell);
    if (*stop) return wf_arena_print(a, "%.17g%s", v, stop);
    if (isnan(head->factor)) return wf_arena_print(a, "%.17g", v);
    return wf_arena_print(a, "%.17g %s", v * head->factor, wf_dimension_row(o->dimension)->si);
}

/* Does a cell name a file? A table may come from anywhere: its cells open none. */
static bool names_file(const char *option, const char *cell)
{
    const char *colon = strchr(cell, ':');
    bool cavity = !strcmp(option, "--cavity");
    if (is_nothing(option, cell) || (!cavity && strcmp(option, "--species") != 0)) return false;
    if (cavity && !(colon && isdigit((unsigned char)colon[1]))) return true;
    return strchr(cell, '/') || strstr(cell, ".csv") || strstr(cell, ".yaml");
}

/* What is wrong with a cell by its column alone; NULL: nothing. */
static const char *cell_fault(const struct wf_tree_columns *c, const struct wf_rows *r, size_t k,
                              struct wf_arena *a)
{
    const struct wf_head *head = &c->heads.head[k];
    const char *cell = r->cell[k], *option = c->line->run.args.option[head->option].name;
    bool card =
        wf_scenario_changes(&c->line->run.args.option[head->option]) || !strcmp(option, "--scenarios");
    if (head->use == WF_HEAD_REFUSED && !wf_csv_missing(cell, strlen(cell)))
        return wf_arena_print(
            a,
            "line %zu: column '%.60s' with '%.60s' is not read from a table, and would change "
            "the answer: %s%s",
            r->line, r->name[k], cell, card ? "assess this tree by a card" : option,
            card ? "" : " is given for all rows");
    if (head->use != WF_HEAD_REFUSED && !strcmp(option, "--cavity") && !strpbrk(cell, ":./") &&
        !is_nothing(option, cell))
        return wf_arena_print(
            a,
            "%s: '%.60s' is no cavity, which is a height and the sound wall there, for example "
            "1.3m:80mm",
            r->name[k], cell);
    if (head->use != WF_HEAD_REFUSED && names_file(option, cell))
        return wf_arena_print(a, "%s: '%.60s' names a file; cells of a table open none", r->name[k], cell);
    return NULL;
}

/* Options of the row, without or with those of a stand. */
static enum wf_status read_options(const struct wf_tree_columns *c, const struct wf_rows *r, bool stand,
                                   struct wf_tree_row *row, struct wf_assess_options *out, struct wf_err *e)
{
    size_t option[WF_OPTIONS_MAX + 1], n = 0;
    const char *cell[WF_OPTIONS_MAX + 1];
    const size_t peak = wf_head_option(c->line->run.args.option, "--peak");
    bool peak_given = false;
    struct wf_sink sink;
    for (size_t k = 0; k < r->cells && k < r->columns; k++) {
        const struct wf_head *head = &c->heads.head[k];
        if (head->use < WF_HEAD_READ || k == c->heads.scan || (head->stand && !stand)) continue;
        const char *fault = cell_fault(c, r, k, &row->arena);
        if (!row->reason) row->reason = fault;
        if (head->use == WF_HEAD_REFUSED) continue;
        option[n] = head->option;
        if (!(cell[n++] = value_of(c, k, r->cell[k], &row->arena)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for a row");
        peak_given = peak_given || (head->option == peak && *cell[n - 1]);
    }
    if (stand && !peak_given) option[n] = peak, cell[n++] = "gales";
    *out = *c->line; /* what is no option */
    enum wf_status s = take_scan(c, r, row, &out->scan, e);
    if (s) return s;
    bool right = wf_args_read_cells(&c->of_rows, "assess", option, cell, n, c->units, &row->arena,
                                    &out->run.args, &sink);
    if (!right && !row->reason) row->reason = wf_arena_text(&row->arena, sink.text);
    if (!WF_GIVEN(&c->line->run, samples)) out->run.samples = 0;
    out->run.threads = 1;
    out->reports = c->line->reports;
    out->scans = c->line->scans;
    return WF_OK;
}

/* The species of a name, read once. NULL: it cannot be read; the reason is in the row. */
static const struct wf_species *species_of(struct wf_tree_columns *c, const char *name, bool cell,
                                           struct wf_tree_row *row)
{
    struct wf_err why = { WF_OK, "" };
    struct wf_diag d = { .arena = &row->arena };
    const char *path = name;
    for (size_t k = 0; k < c->kept; k++)
        if (c->keep[k].cell == cell && !strcmp(c->keep[k].name, name)) return &c->keep[k].species;
    enum wf_status s = cell ? wf_species_path(wf_share(), name, &wf_laws, &row->arena, &path, &why)
                            : wf_shipped("species", name, &row->arena, &path, &d, &why);
    if (!s && c->kept == SPECIES_KEPT) s = wf_fail(&why, WF_EINPUT, "more than %d species", SPECIES_KEPT);
    struct kept_species *k = &c->keep[c->kept];
    if (!s) s = wf_species_read(path, &wf_laws, &c->arena, &k->species, &d, &why);
    if (!s && (k->name = wf_arena_text(&c->arena, name))) {
        k->cell = cell;
        c->kept++;
        return &k->species;
    }
    row->reason = wf_arena_print(&row->arena, "species: %s", d.first ? d.first->text : why.text);
    return NULL;
}

/* The first mistake that was found, else the error, as the row's reason. */
static void take_reason(struct wf_tree_row *row, const struct wf_err *why)
{
    for (const struct wf_finding *f = row->diag.first; f && !row->reason; f = f->next)
        if (f->severity == WF_ERROR) row->reason = f->text;
    if (!row->reason) row->reason = wf_arena_text(&row->arena, why->text);
    if (row->reason) row->reason += strspn(row->reason, "-"); /* a cell is no option */
}

/* From options to what is computed. Mistakes become the row's reason. */
static void prepare(struct wf_tree_columns *c, struct wf_tree_row *row, struct wf_assess_case *out)
{
    struct wf_err why = { WF_OK, "" };
    bool cell = out->options.species != c->line->species;
    if (!(out->species = species_of(c, out->options.species, cell, row))) return;
    if (wf_assess_case_read(out, &row->arena, &row->diag, &why)) take_reason(row, &why);
}

static bool any_stand_cell(const struct wf_tree_columns *c, const struct wf_rows *r)
{
    size_t k = c->heads.spacing;
    return k != WF_HEAD_NONE && k < r->cells && !wf_csv_missing(r->cell[k], strlen(r->cell[k]));
}

/* The row as it is written: as it is, with the cells it lacks; or rebuilt where it is not in the columns of
 * the table. */
static const char *text_of(const struct wf_rows *r, struct wf_tree_row *row)
{
    char *text = NULL;
    size_t size = 0;
    FILE *to = open_memstream(&text, &size);
    if (!to) return NULL;
    if (r->wrong) {
        put_text(r->raw, r->separator, to);
        put_nothing(r->columns, r->separator, to);
    } else if (r->cells <= r->columns) {
        fputs(r->raw, to);
        put_nothing(r->columns - r->cells + 1, r->separator, to);
    } else {
        for (size_t k = 0; k < r->columns; k++) {
            if (k) fputc(r->separator, to);
            const char *own = row->cp1252 ? wf_utf8_to_cp1252(r->cell[k], &row->arena) : r->cell[k];
            put_text(own ? own : "", r->separator, to);
        }
    }
    bool whole = !fclose(to);
    const char *kept = whole ? wf_arena_text(&row->arena, text) : NULL;
    free(text);
    return kept;
}

static const char *number_of(const struct wf_tree_columns *c, const struct wf_rows *r, struct wf_arena *a)
{
    enum { LONGEST = 80 };
    for (size_t k = 0; k < r->cells && k < r->columns; k++) {
        const char *cell = r->cell[k];
        if (!c->heads.head[k].number || wf_csv_missing(cell, strlen(cell)) || strlen(cell) > LONGEST)
            continue;
        const char *at = cell;
        while ((unsigned char)*at >= ' ') at++;
        if (!*at) return wf_arena_text(a, cell);
    }
    return NULL;
}

/* Does no column that was taken hold anything in this row? */
static bool is_empty(const struct wf_tree_columns *c, const struct wf_rows *r)
{
    for (size_t k = 0; k < r->cells && k < r->columns; k++)
        if (c->heads.head[k].use >= WF_HEAD_READ && !wf_csv_missing(r->cell[k], strlen(r->cell[k])))
            return false;
    return true;
}

static const char *row_fault(const struct wf_tree_columns *c, const struct wf_rows *r, struct wf_arena *a)
{
    const char *rest = "";
    if (r->wrong)
        return wf_arena_print(a, "line %zu: %s; the row stands in the first cell", r->line, r->wrong);
    if (is_empty(c, r)) return wf_arena_print(a, "line %zu: the row is empty", r->line);
    if (r->cells == r->columns) return NULL;
    for (size_t k = r->columns; k < r->cells && rest; k++)
        rest = wf_arena_print(a, "%s%s'%s'", rest, *rest ? ", " : ": ", r->cell[k]);
    return wf_arena_print(a, "line %zu: %zu cells for %zu columns%s", r->line, r->cells, r->columns, rest);
}

static bool has_accents(const char *text)
{
    while (*text && (unsigned char)*text < 128) text++;
    return *text;
}

enum wf_status wf_tree_row_read(struct wf_tree_columns *c, const struct wf_rows *r, struct wf_tree_row *out,
                                struct wf_err *e)
{
    *out = (struct wf_tree_row){ .state = WF_ROW_BLANK, .line = r->line };
    out->diag.arena = &out->arena;
    if (r->blank) {
        out->text = wf_arena_text(&out->arena, r->raw);
        return out->text ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for a row");
    }
    out->state = WF_ROW_MISTAKE;
    out->cp1252 =
        r->cp1252 && !(has_accents(r->raw) && wf_utf8_valid(r->raw, r->size, &(struct wf_utf8_fault){ 0 }));
    out->text = text_of(r, out);
    out->reason = row_fault(c, r, &out->arena);
    out->number = number_of(c, r, &out->arena);
    if (!out->text) return wf_fail(e, WF_ENOMEM, "not enough memory for a row");
    if (out->reason) return WF_OK;
    enum wf_status s = read_options(c, r, false, out, &out->single.options, e);
    if (!s && !out->reason) prepare(c, out, &out->single);
    if (!s && !out->reason && any_stand_cell(c, r)) {
        s = read_options(c, r, true, out, &out->stand.options, e);
        if (!s && !out->reason) prepare(c, out, &out->stand);
        out->in_stand = true;
    }
    if (!s && !out->reason) out->state = WF_ROW_READ;
    return s;
}

/* ---- Assessing it ---- */

/* Of a tree of a file: what was taken, so that a wrong file is seen. */
static void note_scan(struct wf_tree_row *row)
{
    const struct wf_assess_options *o = &row->single.options;
    const struct wf_tree *t = &row->single.an.tree;
    const double off = 0.15; /* of height or thickness [-] */
    struct wf_breast b = wf_tree_breast(t);
    double height = wf_tree_height(t), said = isnan(o->dbh) ? o->girth / WF_PI : o->dbh;
    const char *differs = "", *name = strrchr(o->scan, '/');
    if (fabs(o->height / height - 1) > off)
        differs = wf_arena_print(&row->arena, "; the row says %.4g m high", o->height);
    if (differs && fabs(said / b.diameter - 1) > off)
        differs = wf_arena_print(&row->arena, "%s; the row says %.0f mm thick", differs, 1e3 * said);
    row->reason =
        wf_arena_print(&row->arena, "by %s in place of the card: %.4g m high, %.0f mm thick at 1.3 m%s",
                       name ? name + 1 : o->scan, height, 1e3 * b.diameter, differs ? differs : "");
}

void wf_tree_row_assess(struct wf_tree_row *row)
{
    struct wf_err why = { WF_OK, "" };
    if (row->state != WF_ROW_READ) return;
    enum wf_status s = wf_assess_case_run(&row->single, &row->arena, &row->diag, &why);
    if (!s && row->in_stand) s = wf_assess_case_run(&row->stand, &row->arena, &row->diag, &why);
    if (wf_interrupted()) return; /* any part of it may have been cut short */
    row->state = s == WF_EINPUT || s == WF_EUSAGE ? WF_ROW_MISTAKE : s ? WF_ROW_FAILED : WF_ROW_DONE;
    if (s)
        take_reason(row, &why);
    else if (row->single.options.scan)
        note_scan(row);
}
