/* Single values: numbers with units, texts, choices. */
#include "base/near.h"
#include "base/yaml_parts.h"
#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

double wf_yaml_quantity(struct wf_yaml *y, const yaml_node_t *n, const char *text,
                        const struct wf_yaml_row *r)
{
    struct wf_err why = { 0 };
    double v;
    const char *unit = r->unit ? r->unit : "";
    if (wf_quantity_read_as(y->units, text, r->dimension, unit, &v, &why)) {
        wf_yaml_at(y, n, "%s", why.text);
        return NAN;
    }
    /* a bound written in its own unit may differ from its SI value in the last digit */
    double slack = 1e-12 * fmax(fabs(r->low), fabs(r->high));
    if (v >= r->low - slack && v <= r->high + slack) return v;
    char low[64], high[64];
    (void)wf_quantity_print(y->units, r->low, r->dimension, unit, low, sizeof low);
    (void)wf_quantity_print(y->units, r->high, r->dimension, unit, high, sizeof high);
    wf_yaml_at(y, n, "%s is outside %s to %s", text, low, high);
    return NAN;
}

static void choice(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                   unsigned char *out)
{
    unsigned i = 0;
    while (r->choices[i] && strcmp(r->choices[i], text) != 0) i++;
    if (r->choices[i]) {
        if (r->kind == WF_YAML_ENUM)
            memcpy(out + r->offset, &i, sizeof i);
        else
            memcpy(out + r->offset, &r->choices[i], sizeof r->choices[i]);
        return;
    }
    char all[256] = "";
    size_t used = 0;
    for (size_t k = 0; k < i && used < sizeof all; k++)
        used += (size_t)snprintf(all + used, sizeof all - used, "%s%s", k ? ", " : "", r->choices[k]);
    const char *near = wf_nearest(text, r->choices, i);
    if (near)
        wf_yaml_at(y, n, "'%.60s' is not one of: %s; did you mean '%s'?", text, all, near);
    else
        wf_yaml_at(y, n, "'%.60s' is not one of: %s", text, all);
}

static void integer(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                    unsigned char *out)
{
    size_t digits = strspn(text, "0123456789");
    size_t v = digits && digits <= 15 && !text[digits] ? (size_t)strtoull(text, NULL, 10) : (size_t)-1;
    if (!digits || text[digits])
        wf_yaml_at(y, n, "'%.60s' is not a whole number; write for example '%s'", text, r->example);
    else if ((double)v < r->low || (double)v > r->high)
        wf_yaml_at(y, n, "%.60s is outside %.15g to %.15g", text, r->low, r->high);
    else
        memcpy(out + r->offset, &v, sizeof v);
}

static void words(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                  unsigned char *out)
{
    if (!text[strspn(text, " \t\n")]) {
        wf_yaml_at(y, n, "a text is expected, not %s", wf_yaml_type(n));
        return;
    }
    for (const char *p = text; r->kind == WF_YAML_NAME && *p; p++)
        if (!isalnum((unsigned char)*p) && *p != '_' && *p != '-') {
            wf_yaml_at(y, n, "'%.60s': a name has only letters a-z, digits, '_' and '-'", text);
            return;
        }
    if (r->offset == WF_YAML_DROP) return;
    const char *copy = wf_arena_text(y->arena, text);
    if (!copy) y->no_memory = true;
    memcpy(out + r->offset, &copy, sizeof copy);
}

void wf_yaml_put(struct wf_yaml *y, const yaml_node_t *n, const char *text, const struct wf_yaml_row *r,
                 const struct wf_yaml_row *outer, unsigned char *out)
{
    struct wf_yaml_row own = *r;
    if (r->dimension == WF_DIM_COUNT && outer) {
        own.dimension = outer->dimension;
        own.unit = outer->unit;
        own.low = outer->low;
        own.high = outer->high;
    }
    if (r->kind == WF_YAML_QUANTITY) {
        double v = wf_yaml_quantity(y, n, text, &own);
        memcpy(out + r->offset, &v, sizeof v);
    } else if (r->kind == WF_YAML_INTEGER) {
        integer(y, n, text, r, out);
    } else if (r->kind == WF_YAML_CHOICE || r->kind == WF_YAML_ENUM) {
        choice(y, n, text, r, out);
    } else {
        words(y, n, text, r, out);
    }
}
