#include "cmd/validate_print.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

enum { SHORT_LIST = 12, WORST = 3 };

static const char *const outcome_word[WF_OUTCOME_COUNT] = { "passed", "FAILED", "skipped" };

void wf_validate_count(struct wf_validate_tally *t, const struct wf_verdict *v)
{
    if (v->of->kind >= 0) t->of_kind[v->of->kind][v->outcome]++;
    t->outcome[v->outcome]++;
    t->checks += v->n;
}

void wf_validate_print_file(const struct wf_case *first)
{
    printf("\n%s\n", first->file);
    if (first->title) printf("  %s\n", first->title);
    printf("  source: %s\n", first->source);
}

static double used(const struct wf_check *c) { return isnan(c->error) ? HUGE_VAL : c->error / c->allowed; }

/* Whether a line is among the few closest to their tolerance. */
static bool among_worst(const struct wf_verdict *v, size_t i)
{
    size_t worse = 0;
    for (size_t k = 0; k < v->n && worse < WORST; k++)
        worse +=
            used(&v->check[k]) > used(&v->check[i]) || (k < i && used(&v->check[k]) == used(&v->check[i]));
    return worse < WORST;
}

static void print_check(const struct wf_check *c)
{
    char what[160], margin[32] = "exact", relative[32] = "-";
    double f = c->want->unit_factor;
    wf_want_print(c->want, c->component, what, sizeof what);
    if (c->error > 0.0) (void)snprintf(margin, sizeof margin, "%.2g", c->allowed / c->error);
    if (isnan(c->error)) (void)snprintf(margin, sizeof margin, "none");
    if (!isnan(c->relative)) (void)snprintf(relative, sizeof relative, "%.1e", c->relative);
    printf("    %-30s %20.12g %20.12g %-6s %9s %9s%s\n", what, c->wanted / f, c->got / f, c->want->unit,
           relative, margin, c->passed ? "" : "  FAILED");
}

void wf_validate_print_case(const struct wf_verdict *v, bool all)
{
    const struct wf_case *c = v->of;
    size_t shown = 0;
    printf("  %s [%s, %s]: %s", c->name, v->solver, wf_case_kind_name((enum wf_case_kind)c->kind),
           outcome_word[v->outcome]);
    if (v->n)
        printf(", %zu value%s, the worst uses %.2g of its tolerance", v->n, v->n == 1 ? "" : "s", v->worst);
    printf("\n");
    if (v->why) printf("    %s\n", v->why);
    if (all && c->note) printf("    %s\n", c->note);
    if (!v->n) return;
    printf("    %-30s %20s %20s %-6s %9s %9s\n", "quantity", "wanted", "got", "unit", "rel.error", "margin");
    bool full = all || v->n <= SHORT_LIST;
    for (size_t i = 0; i < v->n; i++)
        if (full || !v->check[i].passed || among_worst(v, i)) print_check(&v->check[i]), shown++;
    if (shown < v->n) printf("    and %zu more within tolerance (--verbose lists them)\n", v->n - shown);
}

static bool all_ran(const struct wf_case *c, const struct wf_verdict *mesh)
{
    for (size_t i = 0; i < c->pieces; i++) {
        if (!mesh[i].why) continue;
        printf("    order of convergence: %zu parts a row: %s\n", c->piece[i], mesh[i].why);
        return false;
    }
    return true;
}

void wf_validate_print_order(const struct wf_case *c, const struct wf_verdict *mesh, bool all)
{
    if (!all_ran(c, mesh)) return;
    size_t lines = all || mesh[0].n <= SHORT_LIST ? mesh[0].n : SHORT_LIST;
    printf(
        "    order of convergence: error with every row in so many elements; in brackets the order observed\n"
        "    %-30s",
        "parts");
    for (size_t i = 0; i < c->pieces; i++) printf(" %15zu", c->piece[i]);
    printf("\n");
    for (size_t k = 0; k < lines; k++) {
        char what[160];
        wf_want_print(mesh[0].check[k].want, mesh[0].check[k].component, what, sizeof what);
        printf("    %-30s", what);
        for (size_t i = 0; i < c->pieces; i++) {
            double now = mesh[i].check[k].error / mesh[i].check[k].want->unit_factor;
            double before = i ? mesh[i - 1].check[k].error / mesh[i - 1].check[k].want->unit_factor : 0.0;
            char order[24] = "";
            if (now > 0.0 && before > 0.0)
                (void)snprintf(order, sizeof order, "(%.2f)",
                               log(before / now) / log((double)c->piece[i] / (double)c->piece[i - 1]));
            printf(" %8.1e%7s", now, order);
        }
        printf("\n");
    }
}

void wf_validate_print_tally(const struct wf_validate_tally *t)
{
    printf("\n%-34s %8s %8s %8s\n", "kind", "passed", "failed", "skipped");
    for (int k = 0; k < WF_CASE_KIND_COUNT; k++) {
        const size_t *n = t->of_kind[k];
        if (n[WF_PASSED] + n[WF_FAILED] + n[WF_SKIPPED] == 0) continue;
        char kind[64];
        (void)snprintf(kind, sizeof kind, "%s%s", wf_case_kind_name((enum wf_case_kind)k),
                       k == WF_CASE_REGRESSION ? " (no evidence)" : "");
        printf("%-34s %8zu %8zu %8zu\n", kind, n[WF_PASSED], n[WF_FAILED], n[WF_SKIPPED]);
    }
    printf("%zu values compared\n%zu passed, %zu failed, %zu skipped\n", t->checks, t->outcome[WF_PASSED],
           t->outcome[WF_FAILED], t->outcome[WF_SKIPPED]);
}
