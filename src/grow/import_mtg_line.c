/* Lines of a multi-scale tree graph: where an entity stands in the graph follows from its tab column and
 * edges. */
#include "base/number.h"
#include "grow/import_mtg.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

static int scale_of(const struct wf_mtg *g, const char *p, size_t n)
{
    for (size_t k = 0; k < g->classes; k++)
        if (strlen(g->class[k].symbol) == n && !strncmp(g->class[k].symbol, p, n)) return g->class[k].scale;
    return -1;
}

/* The entity of a coarser or equal scale that contains `v`. */
static int32_t at_scale(const struct wf_mtg *g, int32_t v, int scale)
{
    while (v >= 0 && g->entity[v].scale > scale) v = g->entity[v].complex;
    return v;
}

/* Add one entity reached from `from` over `edge`. Returned: its index, -1 when the graph does not allow it.
 */
static int32_t add(struct wf_mtg *g, int32_t from, char edge, int scale, size_t line)
{
    struct wf_mtg_entity v = { .scale = scale, .edge = edge, .complex = -1, .below = -1, .line = line };
    if (from >= 0 && edge == '/') {
        v.complex = at_scale(g, from, scale - 1);
        if (v.complex < 0 || g->entity[v.complex].scale >= scale) return -1;
        const struct wf_mtg_entity *c = &g->entity[v.complex];
        v.first = c->fine == v.complex; /* no finer part yet */
        v.below = v.first ? c->below : c->fine;
        v.edge = v.first ? c->edge : '<';
    } else if (from >= 0) {
        int32_t p = at_scale(g, from, scale);
        if (p < 0 || g->entity[p].scale != scale) return -1;
        v.complex = g->entity[p].complex;
        v.below = g->entity[from].fine;
    }
    int32_t me = (int32_t)g->n++;
    v.fine = me;
    for (int k = 0; k < 3; k++) v.point[k] = (double)NAN;
    v.diameter = (double)NAN;
    g->entity[me] = v;
    for (int32_t c = v.complex; c >= 0; c = g->entity[c].complex) g->entity[c].fine = me;
    if (scale > g->finest) g->finest = scale;
    return me;
}

/* A code such as "^<S2" or "/P1/A1": every entity of it in turn. Returned: NULL or what is wrong. */
static const char *code(struct wf_mtg *g, size_t column, const char *p, const char *stop, size_t line)
{
    int32_t from = -1;
    if (*p == '^') {
        from = g->last[column];
        if (from < 0) return "'^' without an entity above it in this column";
        p++;
    } else {
        for (size_t k = column; k-- > 0 && from < 0;) from = g->last[k];
        if (column && from < 0) return "no entity in a column to the left to start from";
    }
    if (p == stop) return "an entity is expected behind '^'";
    while (p < stop) {
        char edge = *p++;
        if (edge != '/' && edge != '<' && edge != '+') return "an entity starts with '/', '<' or '+'";
        const char *symbol = p;
        while (p < stop && isalpha((unsigned char)*p)) p++;
        int scale = scale_of(g, symbol, (size_t)(p - symbol));
        if (scale < 0) return "the entity is not of a class this file declares";
        while (p < stop && isdigit((unsigned char)*p)) p++;
        if (g->n == g->room) return "more entities than there are places for";
        from = add(g, from, edge, scale, line);
        if (from < 0) return "the edge does not fit the scales of the two entities";
    }
    g->last[column] = from;
    for (size_t k = column + 1; k < g->entity_columns; k++) g->last[k] = -1;
    return NULL;
}

static const char *features(struct wf_mtg *g, const char *p, const char *stop)
{
    struct wf_mtg_entity *v = &g->entity[g->n - 1];
    double value[4] = { (double)NAN, (double)NAN, (double)NAN, (double)NAN };
    for (size_t column = 0;; column++) {
        const char *tab = memchr(p, '\t', (size_t)(stop - p)), *end = tab ? tab : stop;
        for (int f = 0; f < 4; f++)
            if (g->column[f] == column && end > p && wf_number_read(p, end, '.', &value[f]) != end)
                return "a coordinate or diameter is not a number";
        if (!tab) break;
        p = tab + 1;
    }
    memcpy(v->point, value, sizeof v->point);
    v->diameter = value[3] * g->diameter_share;
    return NULL;
}

const char *wf_mtg_line(struct wf_mtg *g, const char *start, const char *stop, size_t line)
{
    const char *p = start;
    size_t column = 0;
    while (stop > start && (stop[-1] == '\r' || stop[-1] == ' ')) stop--;
    while (p < stop && *p == '\t') p++, column++;
    if (p == stop || *p == '#') return NULL;
    if (column >= g->entity_columns) return "features without an entity";
    const char *end = memchr(p, '\t', (size_t)(stop - p));
    if (!end) end = stop;
    const char *trimmed = end;
    while (trimmed > p && trimmed[-1] == ' ') trimmed--;
    const char *wrong = code(g, column, p, trimmed, line);
    return wrong ? wrong : features(g, start, stop);
}
