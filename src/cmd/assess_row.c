/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_row.h"
#include "base/csv.h"
#include "base/file.h"
#include "base/interrupt.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/args.h"
#include "cmd/assess_cell.h"
#include "cmd/assess_columns.h"
#include "cmd/commands.h"
#include "data/cavity.h"
#include "data/species.h"
#include "data/species_names.h"
#include "load/drag.h"
#include "out/verdict_part.h"
#include "study/interval.h"
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

/* Is it the load of gusts in a stand, without its spacing? */
static bool lacks_spacing(const struct wf_args *line)
{
    size_t peak = wf_head_option(line->option, "--peak");
    return line->given[peak] && line->text[peak] && !strcmp(line->text[peak], "gales") &&
           !line->given[wf_head_option(line->option, "--spacing")];
}

/* Mistakes of options that are said of every row, once. A column by an option's own name may be what an
 * option needs, unless it stands apart: then rows say theirs. */
static enum wf_status check_line(const struct wf_tree_columns *c, struct wf_err *e)
{
    const struct wf_analyze_options *o = &c->line->run;
    struct wf_arena a = { 0 };
    struct wf_diag d = { .arena = &a };
    struct wf_analyze_request q;
    struct wf_cavity *cavity;
    size_t cavities;
    const struct wf_interval_request samples = { o->samples, o->seed, o->threads };
    static const char apart[] = "wind guy cable rod altitude temperature winter-wind snow-density";
    bool own = false;
    enum wf_status s = wf_interval_check(&samples, e);
    for (size_t k = 0; k < c->rows->columns; k++) {
        const struct wf_head *h = &c->heads.head[k];
        own = own || (h->own && !wf_text_among(apart, o->args.option[h->option].name + 2));
    }
    if (!s && lacks_spacing(&o->args) && c->heads.spacing == WF_HEAD_NONE)
        s = wf_fail(e, WF_EUSAGE,
                    "--peak gales needs the spacing of the stand: --spacing, or a column spacing");
    if (!s && o->tree.cavities) s = wf_cavities_asked(o->tree.cavities, &a, &cavity, &cavities, &d, e);
    if (!s && !own) s = wf_analyze_request_read(o, &a, &d, &q, e);
    if (s) wf_print_findings(&d, o->args.quiet);
    wf_arena_free(&a);
    return s;
}

enum wf_status wf_tree_columns_check(const struct wf_tree_columns *c, struct wf_err *e)
{
    enum wf_status s = wf_heads_check(&c->heads, &c->of_rows, e);
    return s ? s : check_line(c, e);
}

/* ---- Reading a row ---- */

/* Is the option given by the command line, or by a cell of the row? */
static bool is_given(const struct wf_args *line, const char *name, const size_t *option,
                     const char *const *cell, size_t n)
{
    size_t row = wf_head_option(line->option, name);
    bool given = line->given[row];
    for (size_t i = 0; i < n; i++) given = given || (option[i] == row && *cell[i]);
    return given;
}

static void drop(struct wf_args *line, const char *name)
{
    line->given[wf_head_option(line->option, name)] = false;
}

/* Options of the command line that act in a row: those that act beside others alone, where one of these is
 * given; the wind in one way, that of a cell before that of the line. That a stand has its load of gusts is
 * said where a row is read as one. */
static struct wf_args acting(const struct wf_args *line, const size_t *option, const char *const *cell,
                             size_t n)
{
    static const char *const of_design[] = { "--design", "--basic-wind", "--basic-pressure", "--region",
                                             "--return-period" };
    struct wf_args out = *line;
    const struct wf_args cells = { .option = line->option }; /* nothing given by the line */
    if (is_given(&cells, "--design", option, cell, n)) drop(&out, "--wind");
    for (size_t k = 0; k < WF_COUNT(of_design) && is_given(&cells, "--wind", option, cell, n); k++)
        drop(&out, of_design[k]);
    for (const struct wf_assess_beside *b = wf_assess_besides; b->option; b++) {
        bool acts = false;
        for (size_t k = 0; k < WF_COUNT(b->other) && b->other[k]; k++)
            acts = acts || is_given(line, b->other[k], option, cell, n);
        if (!acts) drop(&out, b->option);
    }
    if (lacks_spacing(line)) drop(&out, "--peak");
    return out;
}

/* Is every tree one of a stand, by an option that no column repeats? */
static bool stands_by_line(const struct wf_tree_columns *c)
{
    return c->heads.spacing == WF_HEAD_NONE && WF_GIVEN(&c->line->run, peak.spacing);
}

/* What is said of a name, without files: rows open none. */
static const char *without_files(char *text)
{
    static const char files[] = "there is no such file, and ";
    char *at = strstr(text, files);
    if (at) memmove(at, at + strlen(files), strlen(at + strlen(files)) + 1);
    return text;
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
        if (head->use < WF_HEAD_READ || k == c->heads.scan) continue;
        if (head->stand && !stand && !stands_by_line(c)) continue;
        const char *fault = wf_cell_fault(&c->heads, r, k, &row->arena);
        if (!row->reason) row->reason = fault;
        if (head->use == WF_HEAD_REFUSED) continue;
        option[n] = head->option;
        if (!(cell[n++] = wf_cell_value(&c->heads, k, r->cell[k], &row->arena)))
            return wf_fail(e, WF_ENOMEM, "not enough memory for a row");
        peak_given = peak_given || (head->option == peak && *cell[n - 1]);
    }
    if (stand && !peak_given) option[n] = peak, cell[n++] = "gales";
    *out = *c->line; /* what is no option */
    enum wf_status s = take_scan(c, r, row, &out->scan, e);
    if (s) return s;
    const struct wf_args line = acting(&c->of_rows, option, cell, n);
    bool right =
        wf_args_read_cells(&line, "assess", option, cell, n, c->units, &row->arena, &out->run.args, &sink);
    if (!right && !row->reason) row->reason = wf_arena_text(&row->arena, without_files(sink.text));
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
    row->reason =
        wf_arena_print(&row->arena, "species: %s", d.first ? d.first->text : without_files(why.text));
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

/* Which cells of a stand are not used, because the row has no spacing. NULL: none. */
static const char *unused_stand(const struct wf_tree_columns *c, const struct wf_rows *r, struct wf_arena *a)
{
    const char *text = NULL;
    if (any_stand_cell(c, r) || stands_by_line(c)) return NULL;
    for (size_t k = 0; k < r->cells && k < r->columns; k++)
        if (c->heads.head[k].stand && !wf_csv_missing(r->cell[k], strlen(r->cell[k])))
            text = wf_arena_print(a, "%s%s%.60s", text ? text : "", text ? ", " : "", r->name[k]);
    return text ? wf_arena_print(a,
                                 "%s: not used, because the row has no spacing; assessed as a tree that "
                                 "stands alone",
                                 text)
                : NULL;
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

/* Is the row the header again, as behind the end of a table that another was put to? */
static bool is_header(const struct wf_tree_columns *c, const struct wf_rows *r)
{
    size_t same = 0;
    for (size_t k = 0; k < r->columns; k++) {
        if (c->heads.head[k].use < WF_HEAD_READ) continue;
        if (k >= r->cells || strcmp(r->cell[k], r->name[k]) != 0) return false;
        same++;
    }
    return same > 0;
}

static const char *row_fault(const struct wf_tree_columns *c, const struct wf_rows *r, struct wf_arena *a)
{
    const char *rest = "";
    if (r->wrong)
        return wf_arena_print(a, "line %zu: %s; the row stands in the first cell", r->line, r->wrong);
    if (is_empty(c, r)) return wf_arena_print(a, "line %zu: the row is empty", r->line);
    if (is_header(c, r)) return wf_arena_print(a, "line %zu: the row is the header again", r->line);
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
    out->note = unused_stand(c, r, &out->arena);
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
    if (!s && row->note)
        row->reason = row->reason ? wf_arena_print(&row->arena, "%s; %s", row->reason, row->note) : row->note;
}
