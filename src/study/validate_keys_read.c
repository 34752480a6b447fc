#include "study/validate_keys_read.h"
#include "study/validate_want.h"
#include <math.h>
#include <string.h>

static void *field(struct wf_case *c, const struct wf_case_key *k) { return (char *)c + k->offset; }

bool wf_key_text(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    const char **text = field(c, k), *joined = w->rest;
    if (!*w->rest) return wf_words_wrong(w, w->n, "words are expected");
    bool continues = *text && c->given[k - wf_case_keys] >= c->line;
    if (continues) joined = wf_arena_print(w->arena, "%s %s", *text, w->rest);
    if (!joined) return wf_words_wrong(w, 1, "no memory");
    *text = joined;
    return true;
}

bool wf_key_choice(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    const char *word[8];
    char *all = wf_arena_text(w->arena, k->choices), *save = NULL;
    size_t n = 0, chosen;
    if (!all) return wf_words_wrong(w, 1, "no memory");
    for (char *s = strtok_r(all, "|", &save); s && n < 8; s = strtok_r(NULL, "|", &save)) word[n++] = s;
    if (!wf_words_choice(w, "word", word, n, &chosen) || !wf_words_end(w)) return false;
    *(int *)field(c, k) = (int)chosen;
    return true;
}

bool wf_key_numbers(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    double v[3];
    size_t n, at = w->next;
    if (!wf_words_quantities(w, k->dimension, k->count_low, k->count, false, NULL, v, &n, NULL) ||
        !wf_words_end(w))
        return false;
    for (size_t i = 0; i < n; i++)
        if (v[i] < k->low || v[i] > k->high)
            return wf_words_wrong(w, at + i, "'%s' is outside what is allowed: %g to %g", w->word[at + i],
                                  k->low, k->high);
    for (size_t i = 0; i < k->count; i++) ((double *)field(c, k))[i] = v[i < n ? i : 0];
    return true;
}

/* A case has one structure. */
static bool shape(struct wf_words *w, struct wf_case *c, enum wf_case_shape s)
{
    if (c->shape != WF_SHAPE_NONE && c->shape != s)
        return wf_words_wrong(
            w, 0, "the case already has another structure (cantilever, arc, node/branch, tree or flow)");
    c->shape = s;
    return true;
}

bool wf_key_cantilever(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    size_t n;
    if (!shape(w, c, WF_SHAPE_CANTILEVER) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 1, 1, false, NULL, &c->length, &n, NULL) || !wf_words_end(w))
        return false;
    return c->length > 0.0 || wf_words_wrong(w, 1, "a length is positive");
}

static bool vector_after(struct wf_words *w, const char *word, double out[3])
{
    if (!wf_words_skip(w, word)) return wf_words_wrong(w, w->next, "'%s X Y Z' is expected here", word);
    for (int i = 0; i < 3; i++)
        if (!wf_words_number(w, word, &out[i])) return false;
    return true;
}

bool wf_key_arc(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    size_t n;
    if (!shape(w, c, WF_SHAPE_ARC) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 1, 1, false, "angle", &c->arc[0], &n, NULL))
        return false;
    if (!wf_words_skip(w, "angle"))
        return wf_words_wrong(w, w->n, "'angle NUMBER UNIT' is expected after the radius");
    if (!wf_words_quantities(w, WF_DIM_ANGLE, 1, 1, false, "from", &c->arc[1], &n, NULL) ||
        !vector_after(w, "from", c->arc_from) || !vector_after(w, "towards", c->arc_towards) ||
        !wf_words_end(w))
        return false;
    if (c->arc[0] <= 0.0 || c->arc[1] <= 0.0 || c->arc[1] > 6.2831)
        return wf_words_wrong(w, 1, "the radius is positive and the angle lies between 0 and a full turn");
    double dot = 0.0, ff = 0.0, tt = 0.0;
    for (int i = 0; i < 3; i++) {
        dot += c->arc_from[i] * c->arc_towards[i];
        ff += c->arc_from[i] * c->arc_from[i];
        tt += c->arc_towards[i] * c->arc_towards[i];
    }
    if (!(ff > 0.0 && tt > 0.0 && fabs(dot) <= 1e-12 * sqrt(ff * tt)))
        return wf_words_wrong(w, 1, "'from' (root tangent) and 'towards' must be perpendicular");
    return true;
}

bool wf_key_node(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_node node = { .line = w->line };
    long long id;
    size_t n;
    if (!shape(w, c, WF_SHAPE_BRANCHES) || !wf_words_whole(w, "node", 0, INT64_MAX, &id) ||
        !wf_words_quantities(w, WF_DIM_LENGTH, 3, 3, false, NULL, node.x, &n, NULL))
        return false;
    node.id = id;
    const struct wf_case_node *other = c->nodes.data;
    for (size_t i = 0; i < c->nodes.n; i++)
        if (other[i].id == id)
            return wf_words_wrong(w, 1, "node %lld was given on line %zu", id, other[i].line);
    return wf_list_add(&c->nodes, &node, sizeof node, w->arena) || wf_words_wrong(w, 1, "no memory");
}

static const struct wf_case_node *node_named(const struct wf_case *c, long long id)
{
    const struct wf_case_node *node = c->nodes.data;
    for (size_t i = 0; i < c->nodes.n; i++)
        if (node[i].id == id) return &node[i];
    return NULL;
}

bool wf_key_branch(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_branch b = { .line = w->line };
    long long end[2];
    size_t n;
    if (!shape(w, c, WF_SHAPE_BRANCHES)) return false;
    for (int i = 0; i < 2; i++) {
        if (!wf_words_whole(w, "node", 0, INT64_MAX, &end[i])) return false;
        if (!node_named(c, end[i]))
            return wf_words_wrong(w, w->next - 1, "there is no node %lld above this line", end[i]);
    }
    b.from = end[0];
    b.to = end[1];
    if (!wf_words_quantities(w, WF_DIM_LENGTH, 2, 2, false, NULL, b.radius, &n, NULL)) return false;
    if (b.radius[0] <= 0.0 || b.radius[1] <= 0.0) return wf_words_wrong(w, 3, "a radius is positive");
    const struct wf_case_branch *other = c->branches.data;
    bool reached = c->branches.n == 0;
    for (size_t i = 0; i < c->branches.n; i++) {
        reached |= other[i].to == b.from || other[i].from == b.from;
        if (other[i].to == b.to || other[i].from == b.to)
            return wf_words_wrong(w, 2, "node %lld is already reached by line %zu", end[1], other[i].line);
    }
    if (!reached)
        return wf_words_wrong(w, 1, "no branch above this line reaches node %lld; begin at the ground",
                              end[0]);
    return wf_list_add(&c->branches, &b, sizeof b, w->arena) || wf_words_wrong(w, 1, "no memory");
}

bool wf_key_tree(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (!shape(w, c, WF_SHAPE_TREE)) return false;
    if (!wf_words_peek(w))
        return wf_words_wrong(w, w->n, "the name of a tree file beside the case is expected");
    c->tree_file = w->word[w->next++];
    return wf_words_end(w);
}

/* The parameters of a law behind their names, in the order of its row. */
static bool law_parameters(struct wf_words *w, const struct wf_law *l, struct wf_law_values *out)
{
    for (size_t k = 0, n = wf_law_count(l), got; k < n; k++) {
        const struct wf_law_parameter *p = &l->parameter[k];
        bool list = p->kind == WF_LAW_LIST;
        double *v = wf_arena_take(w->arena, WF_WORDS_MAX, sizeof *v);
        if (!v) return wf_words_wrong(w, 1, "no memory");
        if (!wf_words_skip(w, p->name))
            return wf_words_wrong(w, w->next, "'%s NUMBER' is expected here", p->name);
        size_t at = w->next;
        if (!wf_words_quantities(w, p->dimension, 1, list ? WF_WORDS_MAX : 1, false, p[1].name, v, &got,
                                 NULL))
            return false;
        for (size_t i = 0; i < got; i++)
            if (v[i] < p->low || v[i] > p->high)
                return wf_words_wrong(w, at + i, "'%s' is outside what is allowed: %g to %g", w->word[at + i],
                                      p->low, p->high);
        if (list && out->n && out->n != got)
            return wf_words_wrong(w, at, "%zu numbers, but the list before has %zu", got, out->n);
        if (list)
            out->list[k] = v, out->n = got;
        else
            out->number[k] = *v;
    }
    return wf_words_end(w);
}

bool wf_key_law(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    enum { MOST = 24 };
    bool axis = !strcmp(k->name, "axis_drag");
    const char *known[MOST];
    size_t n = 0, chosen;
    for (const struct wf_law *l;
         n < MOST && (l = wf_law_row(axis ? wf_laws.axis_drag : wf_laws.streamlining, n)); n++)
        known[n] = l->name;
    if (!wf_words_choice(w, "law", known, n, &chosen)) return false;
    if (!axis) {
        c->streamlining = &wf_streamline_laws[chosen];
        return law_parameters(w, &c->streamlining->law, &c->streamlining_par);
    }
    c->axis_drag = &wf_axis_drag_laws[chosen];
    return law_parameters(w, &c->axis_drag->law, &c->axis_drag_par);
}

bool wf_key_support(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "clamped", "spring" };
    size_t kind, n;
    if (!wf_words_choice(w, "support", known, 2, &kind)) return false;
    c->spring[0] = c->spring[1] = 0.0;
    if (kind == 0) return wf_words_end(w);
    if (!wf_words_quantities(w, WF_DIM_ROTATIONAL_STIFFNESS, 1, 2, false, NULL, c->spring, &n, NULL))
        return false;
    if (n == 1) c->spring[1] = c->spring[0];
    if (c->spring[0] <= 0.0 || c->spring[1] <= 0.0)
        return wf_words_wrong(w, 2, "a spring stiffness is positive");
    return true;
}

bool wf_key_flow(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "cylinder", "line-source", "point-source", "finite-line-source" };
    size_t kind;
    if (!shape(w, c, WF_SHAPE_FLOW) || !wf_words_choice(w, "flow", known, 4, &kind) || !wf_words_end(w))
        return false;
    c->flow = known[kind];
    return true;
}
