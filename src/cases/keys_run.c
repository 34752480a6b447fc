/* Readers of the keys that say what acts, how a case is run and what is wanted of it. */
#include "cases/keys_read.h"
#include "cases/want.h"
#include "solve/chain_variants.h"
#include <string.h>

bool wf_key_point(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    struct wf_case_load l = { .line = w->line };
    size_t n;
    l.moment = !strcmp(k->name, "moment");
    l.follower = !strcmp(k->name, "follower");
    if (!wf_place_read(w, &l.at) || !wf_words_quantities(w, l.moment ? WF_DIM_MOMENT : WF_DIM_FORCE, 3, 3,
                                                         false, NULL, l.value, &n, NULL))
        return false;
    if (l.at.kind == WF_PLACE_BASE)
        return wf_words_wrong(w, 1, "the base is held; a load there does nothing");
    return wf_list_add(&c->loads, &l, sizeof l, w->arena) || wf_words_wrong(w, 1, "no memory");
}

bool wf_key_mass(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_case_mass m = { .line = w->line };
    size_t n;
    if (!wf_place_read(w, &m.at) ||
        !wf_words_quantities(w, WF_DIM_MASS, 1, 1, false, NULL, &m.mass, &n, NULL))
        return false;
    if (m.at.kind == WF_PLACE_BASE)
        return wf_words_wrong(w, 1, "the base is held; a mass there does nothing");
    if (m.mass < 0.0) return wf_words_wrong(w, w->n - 1, "a mass is not negative");
    return wf_list_add(&c->masses, &m, sizeof m, w->arena) || wf_words_wrong(w, 1, "no memory");
}

bool wf_key_solver(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    enum { KNOWN = 32 };
    const struct wf_solver *known[KNOWN];
    const char *name[KNOWN];
    size_t n = 0, chosen;
    for (size_t i = 0; n < KNOWN && wf_solvers[i]; i++) known[n++] = wf_solvers[i];
    for (size_t i = 0; n < KNOWN && wf_chain_variants[i]; i++) known[n++] = wf_chain_variants[i];
    for (size_t i = 0; i < n; i++) name[i] = known[i]->name;
    c->solvers = 0;
    do {
        if (c->solvers == WF_CASE_SOLVERS_MAX)
            return wf_words_wrong(w, w->next, "at most %d solvers", WF_CASE_SOLVERS_MAX);
        if (!wf_words_choice(w, "solver", name, n, &chosen)) return false;
        c->solver[c->solvers++] = known[chosen];
    } while (wf_words_peek(w));
    return true;
}

bool wf_key_mesh(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    static const char *const known[] = { "default", "one-element-per-row", "tolerance" };
    size_t kind;
    struct wf_solve_options o;
    wf_solve_options_default(&o);
    if (!wf_words_choice(w, "mesh", known, 3, &kind)) return false;
    c->mesh_tolerance = kind == 0 ? o.mesh_tolerance : 0.0;
    if (kind == 2) {
        if (!wf_words_number(w, "tolerance", &c->mesh_tolerance)) return false;
        if (!(c->mesh_tolerance > 0.0 && c->mesh_tolerance < 1.0))
            return wf_words_wrong(w, w->next - 1, "a mesh tolerance lies between 0 and 1");
    }
    return wf_words_end(w);
}

bool wf_key_fit(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (c->shape != WF_SHAPE_NONE && c->shape != WF_SHAPE_FIT)
        return wf_words_wrong(w, 0, "the case has a structure; a fit brings its own");
    if (!wf_words_peek(w))
        return wf_words_wrong(w, w->n,
                              "the name of a calibration study, from the case's folder, is expected");
    c->shape = WF_SHAPE_FIT;
    c->fit_study = w->word[w->next++];
    return wf_words_end(w);
}

bool wf_key_free(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    if (!*w->rest) return wf_words_wrong(w, w->n, "names of parameters are expected");
    c->fit_free = w->rest;
    w->next = w->n;
    return true;
}

bool wf_key_order(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    long long parts, before = 0;
    for (c->pieces = 0; wf_words_peek(w); c->piece[c->pieces++] = (size_t)parts, before = parts) {
        if (c->pieces == WF_CASE_PIECES_MAX)
            return wf_words_wrong(w, w->next, "at most %d meshes", WF_CASE_PIECES_MAX);
        if (!wf_words_whole(w, "parts of a row", before + 1, 4096, &parts)) return false;
    }
    return c->pieces >= 2 ||
           wf_words_wrong(w, w->n, "at least two meshes are needed, for example: order 1 2 4 8");
}

bool wf_key_want(struct wf_words *w, struct wf_case *c, const struct wf_case_key *k)
{
    (void)k;
    struct wf_want want;
    if (!wf_want_read(w, &want)) return false;
    return wf_list_add(&c->wants, &want, sizeof want, w->arena) || wf_words_wrong(w, 1, "no memory");
}
