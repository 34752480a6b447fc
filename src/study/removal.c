/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "study/removal.h"
#include "base/num.h"
#include "base/text.h"
#include "data/model.h"
#include "load/interception.h"
#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* ---- Reading ---- */

static enum wf_status read_part(char *text, struct wf_removed_part *out, struct wf_err *e)
{
    char *end = text;
    text = wf_text_trim(text);
    *out = (struct wf_removed_part){ .level = text };
    if (!strncmp(text, "level:", 6)) out->level = text + 6;
    if (strncmp(text, "id:", 3))
        return *out->level ? WF_OK : wf_fail(e, WF_EUSAGE, "--remove: a part has no name");
    errno = 0;
    out->level = NULL, out->id = strtoll(text + 3, &end, 10);
    if (end > text + 3 && !*end && !errno) return WF_OK;
    return wf_fail(e, WF_EUSAGE, "--remove: '%.40s': id: and the number of a segment, for example id:14",
                   text);
}

static enum wf_status read_removal(char *text, struct wf_arena *a, struct wf_removed *out, struct wf_err *e)
{
    enum wf_status s = WF_OK;
    *out = (struct wf_removed){ .name = wf_arena_text(a, text) };
    if (!out->name) return wf_fail(e, WF_ENOMEM, "not enough memory for a removal");
    for (char *p = text; (p = strchr(p, ';'));) *p = '+';
    for (char *next; text && !s; text = next) {
        if ((next = strchr(text, '+'))) *next++ = '\0';
        s = out->n < WF_REMOVED_PARTS
                ? read_part(text, &out->part[out->n++], e)
                : wf_fail(e, WF_EUSAGE, "--remove: more than %d parts at once", (int)WF_REMOVED_PARTS);
    }
    return s;
}

enum wf_status wf_removals_read(const char *text, struct wf_arena *a, const struct wf_removed **out,
                                size_t *n, struct wf_err *e)
{
    struct wf_removed *list = WF_TAKE(a, WF_REMOVALS_MAX, struct wf_removed);
    char *rest = wf_arena_text(a, text), *item;
    enum wf_status s = list && rest ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for removals");
    for (*n = 0; !s && (item = wf_list_item(&rest)); (*n)++)
        s = *n < WF_REMOVALS_MAX ? read_removal(item, a, &list[*n], e)
                                 : wf_fail(e, WF_EUSAGE, "--remove: more than %d", (int)WF_REMOVALS_MAX);
    *out = list;
    return s;
}

/* ---- On the tree ---- */

/* Is a row of the level that a part names, by its name or number? */
static bool is_level(const struct wf_analysis *an, const struct wf_removed_part *p, size_t row)
{
    char number[24];
    int32_t level = an->tree.level[row];
    (void)snprintf(number, sizeof number, "%d", (int)level);
    return !strcmp(p->level, number) || !strcmp(p->level, wf_model_level_name(an->model, an->species, level));
}

static enum wf_status mark(const struct wf_analysis *an, const struct wf_removed *what, bool *gone,
                           struct wf_err *e)
{
    const struct wf_tree *t = &an->tree;
    for (size_t k = 0; k < what->n; k++) {
        const struct wf_removed_part *p = &what->part[k];
        size_t found = 0;
        for (size_t i = 0; i < t->n; i++) {
            if (!(p->level ? is_level(an, p, i) : t->id[i] == p->id)) continue;
            if (t->level[i] == 0)
                return wf_fail(e, WF_EINPUT, "%s: --remove %s: that is of the stem; branches can be removed",
                               an->model->name, what->name);
            gone[i] = true, found++;
        }
        if (!found)
            return wf_fail(e, WF_EINPUT,
                           "%s: --remove %s: the tree has no such branch; columns 'level' and 'segment' "
                           "of tables/segments.csv name them",
                           an->model->name, what->name);
    }
    for (size_t i = 0; i < t->n; i++) gone[i] = gone[i] || (t->parent[i] >= 0 && gone[t->parent[i]]);
    return WF_OK;
}

/* Leaves; where there are none the crown's sail, else what branches show from the side. */
enum crown { CROWN_LEAVES, CROWN_SAIL, CROWN_WOOD, CROWNS };
static double crown_of(const struct wf_tree *t, enum crown by)
{
    double sum = 0;
    if (by == CROWN_LEAVES) return wf_tree_leaf_area(t);
    for (size_t i = 0; i < t->n; i++) {
        double sail = 0.5 * (t->sail0[i] + t->sail1[i]), wood = t->level[i] > 0 ? t->r0[i] + t->r1[i] : 0;
        sum += (by == CROWN_SAIL ? sail : wood) * wf_tree_length(t, i);
    }
    return sum;
}

double wf_crown_gone(const struct wf_tree *whole, const struct wf_tree *left)
{
    for (int by = 0; by < CROWNS; by++) {
        double all = crown_of(whole, (enum crown)by);
        if (all > 0) return 1 - crown_of(left, (enum crown)by) / all;
    }
    return 0;
}

enum wf_status wf_removal_onto(struct wf_analysis *an, struct wf_arena *a, struct wf_err *e)
{
    struct wf_tree *t = &an->tree, out;
    if (!an->scenario.removed) return WF_OK;
    bool *gone = WF_TAKE(a, t->n, bool);
    int32_t *to = WF_TAKE(a, t->n, int32_t);
    size_t left = 0;
    if (!gone || !to) return wf_fail(e, WF_ENOMEM, "not enough memory for a removal");
    enum wf_status s = mark(an, an->scenario.removed, gone, e);
    for (size_t i = 0; i < t->n; i++) to[i] = (int32_t)left, left += !gone[i];
    if (!s) s = wf_tree_alloc_like(t, left, a, &out, e);
    for (size_t i = 0; i < t->n && !s; i++) {
        if (gone[i]) continue;
        size_t at = (size_t)to[i];
        wf_tree_copy_part(t, i, 0, 1, &out, at);
        out.parent[at] = t->parent[i] < 0 ? -1 : to[t->parent[i]];
        if (t->mass1) out.mass1[at] = t->mass1[i];
    }
    if (s) return s;
    an->cut = wf_crown_gone(t, &out);
    *t = out;
    return WF_OK;
}
