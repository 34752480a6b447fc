/* Header of a multi-scale tree graph: symbols with their scale, and which tab column holds which feature. */
#include "grow/import_mtg.h"
#include <ctype.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* The next line without its end; false at the end of the text. */
static bool next_line(const char **at, const char **stop, size_t *line)
{
    if (!**at) return false;
    *stop = *at + strcspn(*at, "\n");
    (*line)++;
    return true;
}

static void class_row(struct wf_mtg *g, const char *p)
{
    char symbol[16];
    size_t n = strcspn(p, " \t\r\n");
    if (!n || n >= sizeof symbol || g->classes == WF_MTG_CLASSES) return;
    memcpy(symbol, p, n);
    symbol[n] = '\0';
    p += n + strspn(p + n, " \t");
    if (!isdigit((unsigned char)*p)) return;
    struct wf_mtg_class *c = &g->class[g->classes++];
    memcpy(c->symbol, symbol, sizeof symbol);
    c->scale = (int)strtol(p, NULL, 10);
}

/* Given a cell of the ENTITY-CODE line: which feature it names, -1 when none that matters. */
static int feature(struct wf_mtg *g, const char *p, size_t n)
{
    static const struct {
        const char *name;
        int feature;
        double share;
    } names[] = {
        { "XX", 0, 1 },     { "X", 0, 1 },        { "YY", 1, 1 },       { "Y", 1, 1 },
        { "ZZ", 2, 1 },     { "Z", 2, 1 },        { "TopDia", 3, 1 },   { "Diam", 3, 1 },
        { "Dia", 3, 1 },    { "Diameter", 3, 1 }, { "diameter", 3, 1 }, { "TopDiameter", 3, 1 },
        { "radius", 3, 2 },
    };
    while (n && (p[n - 1] == ' ' || p[n - 1] == '\r')) n--;
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        if (strlen(names[k].name) != n || strncasecmp(p, names[k].name, n)) continue;
        if (names[k].feature == 3) g->diameter_share = names[k].share;
        return names[k].feature;
    }
    return -1;
}

static enum wf_status feature_columns(struct wf_mtg *g, const char *file, const char *p, const char *stop,
                                      size_t line, struct wf_err *e)
{
    bool found[4] = { false };
    g->entity_columns = 0;
    for (size_t column = 0;; column++) {
        size_t n = strcspn(p, "\t\n");
        if (column && n && *p != '\r' && !g->entity_columns) g->entity_columns = column;
        int f = column ? feature(g, p, n) : -1;
        if (f >= 0) g->column[f] = column, found[f] = true;
        p += n;
        if (p >= stop || *p != '\t') break;
        p++;
    }
    if (!found[0] || !found[1] || !found[2] || !found[3])
        return wf_fail(
            e, WF_EINPUT,
            "%s:%zu: error: the features XX, YY, ZZ and a diameter (TopDia, Diam, diameter) are needed; "
            "%s is missing",
            file, line, !found[3] ? "a diameter" : "a coordinate");
    if (!g->entity_columns || g->entity_columns > WF_MTG_COLUMNS)
        return wf_fail(e, WF_EINPUT, "%s:%zu: error: no column for entities before the features", file, line);
    return WF_OK;
}

enum wf_status wf_mtg_head(struct wf_mtg *g, const char *file, const char **at, size_t *line,
                           struct wf_err *e)
{
    enum { BEFORE, CLASSES, BEHIND } part = BEFORE;
    const char *stop;
    for (; next_line(at, &stop, line); *at = *stop ? stop + 1 : stop) {
        if (!strncmp(*at, "ENTITY-CODE", 11)) {
            if (!g->classes) return wf_fail(e, WF_EINPUT, "%s: error: no classes before ENTITY-CODE", file);
            enum wf_status s = feature_columns(g, file, *at, stop, *line, e);
            *at = *stop ? stop + 1 : stop;
            return s;
        }
        if (!strncmp(*at, "CLASSES", 7))
            part = CLASSES;
        else if (!strncmp(*at, "DESCRIPTION", 11) || !strncmp(*at, "FEATURES", 8))
            part = BEHIND;
        else if (part == CLASSES && strncmp(*at, "SYMBOL", 6))
            class_row(g, *at);
    }
    return wf_fail(e, WF_EINPUT, "%s: error: no ENTITY-CODE line in this tree graph", file);
}
