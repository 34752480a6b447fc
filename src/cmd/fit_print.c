#include "cmd/fit_job.h"
#include <math.h>
#include <string.h>

static void range(FILE *to, double low, double high, double factor, const char *none)
{
    if (isnan(low) && isnan(high))
        fprintf(to, "  %-21s", none);
    else if (isnan(low))
        fprintf(to, "  below %-15.4g", high * factor);
    else if (isnan(high))
        fprintf(to, "  above %-15.4g", low * factor);
    else {
        char text[48];
        snprintf(text, sizeof text, "%.4g to %.4g", low * factor, high * factor);
        fprintf(to, "  %-21s", text);
    }
}

static void parameters(FILE *to, const struct wf_fit *f)
{
    bool resampled = f->resampled >= 20;
    fprintf(to, "%-34s %12s %-9s  %-21s  %-21s%s\n", "parameter", "estimate", "", "95 % by covariance",
            "95 % by profile", resampled ? "  95 % by bootstrap" : "");
    for (size_t k = 0; k < f->params; k++) {
        const struct wf_estimate *q = &f->estimate[k];
        double factor;
        const char *unit = wf_param_unit(f->x, &f->param[k], &factor);
        fprintf(to, "%-34s %12.5g %-9s", f->param[k].name, q->value * factor, unit);
        range(to, q->low, q->high, factor, "-");
        range(to, q->profile_low, q->profile_high, factor, q->profiled ? "no limit" : "-");
        if (resampled) range(to, q->resampled_low, q->resampled_high, factor, "-");
        fputs(q->at_low ? "  AT LOWER BOUND\n" : q->at_high ? "  AT UPPER BOUND\n" : "\n", to);
    }
}

static void correlations(FILE *to, const struct wf_fit *f)
{
    if (f->free < 2) return;
    fprintf(to, "\ncorrelation of the estimates\n");
    for (size_t i = 0; i < f->free; i++) {
        fprintf(to, "%-34s", f->param[i].name);
        for (size_t k = 0; k <= i; k++) fprintf(to, " %6.3f", f->correlation[i * f->params + k]);
        fputc('\n', to);
    }
}

static void sensors(FILE *to, const struct wf_fit *f)
{
    fprintf(to, "\n%-30s %8s %12s %12s  neighbours\n", "sensor", "readings", "sigma", "rms residual");
    for (size_t i = 0; i < f->groups; i++) {
        const struct wf_fit_group *g = &f->group[i];
        const struct wf_fit_test *t = &f->x->test[g->test];
        const struct wf_sensor_row *r = &wf_sensor_rows[t->sensor[g->sensor].kind];
        char name[64];
        snprintf(name, sizeof name, "%.30s %.30s", t->name, t->sensor[g->sensor].name);
        fprintf(to, "%-30s %8zu %12.4g %12.4g  %5.2f  [%s]%s\n", name, g->n, g->sigma * r->factor,
                g->rms * r->factor, g->correlation, r->unit,
                t->sensor[g->sensor].estimated ? ", sigma from the scatter" : "");
    }
}

void wf_fit_print(FILE *to, const struct wf_fit_results *of)
{
    const struct wf_fit *f = &of->fit;
    bool bound = false;
    fprintf(to, "%s\n%zu readings in %zu test%s, %zu parameters%s\n\n", of->study.name, f->x->data,
            f->x->tests, f->x->tests == 1 ? "" : "s", f->params,
            f->params > f->free ? " (offsets and drifts included)" : "");
    parameters(to, f);
    for (size_t k = 0; k < of->x.tests; k++)
        if (of->input[k].swung) {
            const struct wf_ring_down *s = &of->input[k].sway;
            fprintf(to, "\n%s: %.4f +- %.4f Hz, damping %.2f +- %.2f %%, %.1f %% of the variance explained",
                    of->x.test[k].name, s->frequency, 1.96 * s->frequency_sd, 100 * s->damping,
                    196 * s->damping_sd, 100 * s->explained);
        }
    if (of->x.tests && of->input[0].swung) fputc('\n', to);
    correlations(to, f);
    sensors(to, f);
    fprintf(to, "\nreduced chi-square %.4g with %zu degrees of freedom%s\n", f->reduced, f->freedom,
            f->sigma_estimated ? " (1 by construction where sigmas are estimated)" : "");
    for (size_t k = 0; k < f->free; k++) bound |= f->estimate[k].at_low || f->estimate[k].at_high;
    if (f->loose_n == 0)
        fprintf(to, "the data determine every parameter%s\n", bound ? " that did not end on a bound" : "");
    for (size_t i = 0; i < f->loose_n; i++) fprintf(to, "NOT DETERMINED: %s\n", f->loose[i].text);
    if (of->rival.made) {
        const struct wf_fit *r = &of->rival.fit;
        fprintf(to, "\nthe same with a %s:", of->rival.text);
        for (size_t k = 0; k < r->free; k++) {
            double factor;
            const char *unit = wf_param_unit(r->x, &r->param[k], &factor);
            fprintf(to, "%s %s %.5g%s%s%s", k ? "," : "", r->param[k].name, r->estimate[k].value * factor,
                    *unit ? " " : "", unit,
                    r->estimate[k].at_high || r->estimate[k].at_low ? " (at its bound)"
                    : isnan(r->estimate[k].low)                     ? " (not determined)"
                                                                    : "");
        }
        if (!isnan(of->rival.aicc) && !isnan(of->rival.own))
            fprintf(to, "\nAICc %.2f here, %.2f there: the data %s\n", of->rival.own, of->rival.aicc,
                    fabs(of->rival.own - of->rival.aicc) < 2 ? "do not choose between them"
                    : of->rival.own < of->rival.aicc         ? "prefer this fit"
                                                             : "prefer the other");
        else
            fprintf(to, "\ntoo few readings to compare the two\n");
    }
    if (of->study.reference) fprintf(to, "\nfor comparison: %s\n", of->study.reference);
}
