/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "cmd/assess_cell.h"
#include "base/csv.h"
#include "base/num.h"
#include "base/text.h"
#include "cmd/scenarios.h"
#include "cmd/wind_speed.h"
#include "wind/climate.h"
#include <ctype.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

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

/* "1,3m:80mm" of a table whose cells are not apart by commas: a decimal comma. */
static const char *with_points(const struct wf_heads *h, const struct wf_option *o, const char *cell,
                               struct wf_arena *a)
{
    static const char *const composed[] = { "--cavity", "--guy", "--cable", "--rod", "--bark" };
    bool is = false;
    char *text = wf_arena_text(a, cell);
    for (size_t k = 0; k < WF_COUNT(composed); k++) is = is || !strcmp(o->name, composed[k]);
    for (char *p = text; p && is && h->rows->separator != ',' && (p = strchr(p, ',')); p++)
        if (p > text && isdigit((unsigned char)p[-1]) && isdigit((unsigned char)p[1])) *p = '.';
    return text;
}

/* May a cell be a list of winds, or one wind with a decimal comma? */
static bool may_be_list(const struct wf_heads *h, const struct wf_option *o, const char *cell)
{
    if (o->kind != WF_OPTION_SPEEDS || h->rows->separator == ',') return false;
    for (const char *p = cell; (p = strchr(p, ',')); p++)
        if (p > cell && isdigit((unsigned char)p[-1]) && isdigit((unsigned char)p[1])) return true;
    return false;
}

/* Where the numbers of winds begin that have no unit of their own, behind "gust:" or another word: "36,54",
 * "gust:120". NULL: there are none, or not only such. */
static const char *plain_winds(const char *cell)
{
    size_t which;
    const char *at = cell + wf_wind_time_word(cell, &which);
    return *at && !at[strspn(at, "0123456789.,: ")] ? at : NULL;
}

/* Winds of a column with a unit in which a number has none of its own, beside words: "30,beaufort:8". */
static bool lacks_unit(const struct wf_head *head, const struct wf_option *o, const char *cell)
{
    if (o->kind != WF_OPTION_SPEEDS || !isfinite(head->factor) || plain_winds(cell)) return false;
    if (wf_wind_scale_is(cell) && !strchr(cell, ',')) return false; /* one grade */
    const char *last = cell + strlen(cell);
    while (last > cell && !isdigit((unsigned char)last[-1])) last--;
    last += strspn(last, " .");
    return last > cell && (!*last || *last == ',');
}

/* The same in SI, each number times the unit of the column. */
static const char *winds_in_si(const struct wf_head *head, const struct wf_option *o, const char *cell,
                               struct wf_arena *a)
{
    const char *p = plain_winds(cell), *end = cell + strlen(cell);
    char *text = p ? wf_arena_print(a, "%.*s", (int)(p - cell), cell) : wf_arena_text(a, cell);
    while (p && *p && text) {
        double v;
        bool number = isdigit((unsigned char)*p) || *p == '.';
        const char *stop = number ? wf_number_read(p, end, '.', &v) : NULL;
        if (stop && *stop == '.') return wf_arena_text(a, cell); /* "1.2.3" is none, with any unit */
        text =
            stop ? wf_arena_print(a, "%s%.17g", text, v * head->factor) : wf_arena_print(a, "%s%c", text, *p);
        p = stop ? stop : p + 1;
    }
    return text && p ? wf_arena_print(a, "%s %s", text, wf_dimension_row(o->dimension)->si) : text;
}

const char *wf_cell_value(const struct wf_heads *h, size_t column, const char *cell, struct wf_arena *a)
{
    const struct wf_head *head = &h->head[column];
    const struct wf_option *o = &h->option[head->option];
    double v;
    if (is_nothing(o->name, cell) || (head->use == WF_HEAD_WORDS && !is_word(o, cell))) return "";
    if (o->kind == WF_OPTION_SPEEDS && isfinite(head->factor)) return winds_in_si(head, o, cell, a);
    if (o->kind != WF_OPTION_NUMBER) return with_points(h, o, cell, a);
    const char *end = cell + strlen(cell), *stop = wf_number_read(cell, end, '.', &v);
    if (h->rows->separator != ',' && stop && *stop == ',') stop = wf_number_read(cell, end, ',', &v);
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

/* May a plain number be a grade of Beaufort, or a class of exposure? */
static bool may_be_class(const struct wf_head *head, const struct wf_option *o, const char *cell)
{
    const long highest = 12;
    return o->kind == WF_OPTION_SPEEDS && isnan(head->factor) && *cell && !cell[strspn(cell, "0123456789")] &&
           strtol(cell, NULL, 10) <= highest;
}

/* What is wrong with a cell of winds; NULL: nothing. */
static const char *winds_fault(const struct wf_heads *h, const struct wf_rows *r, size_t k,
                               struct wf_arena *a)
{
    const struct wf_head *head = &h->head[k];
    const struct wf_option *o = &h->option[head->option];
    const char *cell = r->cell[k];
    if (may_be_list(h, o, cell))
        return wf_arena_print(a,
                              "%s: '%.60s' may be a decimal comma or a list; write one wind with a point, as "
                              "15.25, and several winds with a blank behind each comma, as 15, 25",
                              r->name[k], cell);
    if (may_be_class(head, o, cell))
        return wf_arena_print(a,
                              "%s: '%.60s' may be a class or a grade of Beaufort; write '%.60s m/s' or "
                              "'beaufort:%.60s', or name the column wind_m_s",
                              r->name[k], cell, cell, cell);
    if (lacks_unit(head, o, cell))
        return wf_arena_print(
            a,
            "%s: '%.60s' is neither winds in the unit of the column nor winds with their own; "
            "write the unit behind the last number, for example 36, 54 km/h",
            r->name[k], cell);
    return NULL;
}

const char *wf_cell_fault(const struct wf_heads *h, const struct wf_rows *r, size_t k, struct wf_arena *a)
{
    const struct wf_head *head = &h->head[k];
    const char *cell = r->cell[k], *option = h->option[head->option].name;
    bool card = wf_scenario_changes(&h->option[head->option]) || !strcmp(option, "--scenarios");
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
    return head->use == WF_HEAD_REFUSED ? NULL : winds_fault(h, r, k, a);
}
