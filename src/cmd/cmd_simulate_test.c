/* SPDX-License-Identifier: GPL-3.0-or-later */
/* windfirm simulate-test: which values a planned test would determine, and how accurately. */
#include "base/file.h"
#include "base/num.h"
#include "cmd/args.h"
#include "cmd/commands.h"
#include "cmd/option_groups.h"
#include "cmd/read_mat.h"
#include "fit/build.h"
#include "fit/predict.h"
#include <gsl/gsl_linalg.h>
#include <math.h>
#include <string.h>

struct simulate_options {
    struct wf_args args;
    const char *free; /* NULL: the calibration's */
    size_t seed;
    const char *output;
};

#define OPTIONS struct simulate_options
static const struct wf_option options[] = {
    TEXTS("--free", free, "NAME[,NAME]", "parameters the test is to determine, in place of the study's",
          .letter = "-f"),
    WHOLE("--seed", seed, 0, 9007199254740992.0, "1", "of the noise"),
    TEXT("--output", output, "FOLDER", "out/simulate-test",
         "where the simulated data go, one CSV file a test", .letter = "-o"),
    WF_QUIET_ROW,
    { 0 },
};
static const char about[] =
    "STUDY is a calibration study whose tests have 'loads' or 'speeds' and whose sensors have 'sigma' or "
    "'sigma_share'. The "
    "tree is taken as the species table has it; readings are simulated with noise, and the 95 % interval "
    "each "
    "layout would "
    "give is computed: all sensors, each alone, all but one.\n"
    "\n"
    "  windfirm simulate-test models/field/sample_pull.yaml --free level0.youngs_modulus,root.stiffness";

struct plan {
    struct wf_arena arena;
    struct simulate_options options;
    struct wf_calibration calibration;
    struct wf_experiment x;
    struct wf_fit_param *param;
    size_t params, free;
    double *reading, *slope;
};

/* 95 % half widths of the internal values when only the sensors in `with` are used; INFINITY where one is not
 * determined. The singular values below 1e-9 of the largest count as none. */
static enum wf_status expect_widths(const struct plan *p, const bool *with, double *half, struct wf_err *e)
{
    size_t n = p->params, rows = p->x.data > n ? p->x.data : n, i = 0;
    wf_quiet_begin();
    gsl_matrix *W = gsl_matrix_calloc(rows, n), *V = gsl_matrix_alloc(n, n);
    gsl_vector *s = gsl_vector_alloc(n), *work = gsl_vector_alloc(n);
    bool ok = W && V && s && work;
    for (size_t d = 0, sensor = 0; ok && d < p->x.data; d++) {
        const struct wf_fit_datum *q = &p->x.datum[d];
        sensor = q->sensor;
        for (size_t t = 0; t < q->test; t++) sensor += p->x.test[t].sensors;
        for (size_t k = 0; with[sensor] && k < n; k++)
            gsl_matrix_set(W, i, k, p->slope[d * n + k] / q->sigma);
        i++;
    }
    ok = ok && !gsl_linalg_SV_decomp(W, V, s, work);
    for (size_t k = 0; k < p->free; k++) {
        double sum = 0, top = ok ? gsl_vector_get(s, 0) : 0;
        for (size_t m = 0; ok && m < n; m++) {
            double v = gsl_matrix_get(V, k, m), size = gsl_vector_get(s, m);
            if (size > 1e-9 * top)
                sum += v * v / (size * size);
            else if (fabs(v) > 1e-6)
                sum = INFINITY;
        }
        half[k] = 1.96 * sqrt(top > 0 ? sum : INFINITY);
    }
    if (W) gsl_matrix_free(W);
    if (V) gsl_matrix_free(V);
    if (s) gsl_vector_free(s);
    if (work) gsl_vector_free(work);
    wf_quiet_end();
    return ok ? WF_OK : wf_fail(e, WF_ENOMEM, "not enough memory for the plan");
}

static void print_widths(const struct plan *p, const char *name, const double *half)
{
    wf_show(stdout, "%-44s", name);
    for (size_t k = 0; k < p->free; k++) {
        const struct wf_fit_quantity_row *q = &wf_fit_quantities[p->param[k].quantity];
        double share = q->log ? expm1(half[k]) : half[k];
        if (share < 10 && !q->log && *q->unit)
            wf_show(stdout, "  %+8.1f %-3s", share * q->factor, q->unit);
        else if (share < 10)
            wf_show(stdout, "  %+10.1f %%", 100 * share);
        else
            wf_show(stdout, "  %12s", "-");
    }
    wf_show(stdout, "\n");
}

static enum wf_status print_layouts(const struct plan *p, struct wf_err *e)
{
    bool with[256] = { false };
    size_t sensors = 0, at = 0;
    double half[64];
    char name[96];
    for (size_t t = 0; t < p->x.tests; t++) sensors += p->x.test[t].sensors;
    if (sensors > 256 || p->params > 64)
        return wf_fail(e, WF_EUSAGE, "more than 256 sensors or 64 parameters in one plan");
    wf_show(stdout, "%-44s", "sensors: upper half of the 95 % interval");
    for (size_t k = 0; k < p->free; k++) wf_show(stdout, "  %12.24s", p->param[k].name);
    wf_show(stdout, "\n");
    for (size_t i = 0; i < sensors; i++) with[i] = true;
    enum wf_status s = expect_widths(p, with, half, e);
    if (!s) print_widths(p, "all", half);
    for (int alone = 1; alone >= 0 && sensors > 1; alone--, at = 0)
        for (size_t t = 0; t < p->x.tests; t++)
            for (size_t k = 0; k < p->x.test[t].sensors && !s; k++, at++) {
                for (size_t i = 0; i < sensors; i++) with[i] = (i == at) == (alone == 1);
                snprintf(name, sizeof name, "%s %.30s %.30s", alone ? "only" : "without", p->x.test[t].name,
                         p->x.test[t].sensor[k].name);
                s = expect_widths(p, with, half, e);
                if (!s) print_widths(p, name, half);
            }
    return s;
}

/* Write one file per test: load and readings with noise, in columns named after the sensors. */
static enum wf_status write_test(const struct plan *p, size_t test, const char *folder, struct wf_err *e)
{
    const struct wf_fit_test *t = &p->x.test[test];
    const char *path = wf_arena_print((struct wf_arena *)&p->arena, "%s/%s.csv", folder, t->name);
    struct wf_file f = { 0 };
    enum wf_status s = path ? wf_file_begin(&f, path, e) : wf_fail(e, WF_ENOMEM, "not enough memory");
    if (s) return s;
    fprintf(f.stream, "t_s,%s",
            t->load == WF_FIT_PULL     ? "force_N"
            : t->load == WF_FIT_WIND   ? "wind_m_s"
            : t->load == WF_FIT_WEIGHT ? "along_m"
                                       : "none");
    static const char *const unit[WF_SENSOR_KINDS] = { "_m", "_m", "_m",   "_rad", "_um_m", "_m",
                                                       "_m", "_m", "_N_m", "_Hz",  "" };
    for (size_t k = 0; k < t->sensors; k++)
        fprintf(f.stream, ",%s%s", t->sensor[k].name, unit[t->sensor[k].kind]);
    fputc('\n', f.stream);
    for (size_t i = 0, d = 0; i < t->states; i++) {
        fprintf(f.stream, "%.9g,%.9g", t->state[i].time, t->state[i].load);
        for (size_t k = 0; k < t->sensors; k++) {
            while (p->x.datum[d].test != test || p->x.datum[d].state != i || p->x.datum[d].sensor != k) d++;
            double v = p->x.datum[d].value;
            fprintf(f.stream, ",%.9g", t->sensor[k].kind == WF_SENSOR_STRAIN ? 1e6 * v : v);
        }
        fputc('\n', f.stream);
    }
    s = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return s;
}

static enum wf_status simulate(struct plan *p, struct wf_diag *d, bool quiet, struct wf_err *e)
{
    struct wf_fit_build b = {
        .calibration = &p->calibration, .share = wf_share(), .plan = true, .mat = wf_read_mat
    };
    const char *folder = p->options.output;
    enum wf_status s = wf_calibration_read(p->options.args.operand[0], &p->arena, &p->calibration, d, e);
    if (s) return s;
    struct wf_fit_input *in = WF_TAKE(&p->arena, p->calibration.tests, struct wf_fit_input);
    if (!in) return wf_fail(e, WF_ENOMEM, "not enough memory for the study");
    s = wf_fit_build(&b, &p->arena, d, &p->x, in, e);
    if (!s)
        s = wf_fit_params(&p->calibration, p->options.free, &p->x, true, &p->arena, &p->param, &p->params, e);
    if (!s && !p->params)
        s = wf_fail(e, WF_EUSAGE, "nothing is free: name parameters with --free or in the study");
    if (s) return s;
    size_t n = p->params, m = p->x.data;
    p->reading = WF_TAKE(&p->arena, m, double), p->slope = WF_TAKE(&p->arena, m * n, double);
    if (!p->reading || !p->slope) return wf_fail(e, WF_ENOMEM, "not enough memory for the plan");
    for (size_t k = 0; k < n; k++) p->free += !wf_param_nuisance(&p->param[k]);
    s = wf_fit_expect(&p->x, p->param, n, &p->arena, p->reading, p->slope, d, e);
    if (!s) wf_fit_make_up(&p->x, p->reading, p->options.seed, 1);
    if (!s && !quiet) s = print_layouts(p, e);
    if (!s) s = wf_mkdirs(folder, e);
    for (size_t t = 0; t < p->x.tests && !s; t++) s = write_test(p, t, folder, e);
    if (!s && !quiet) wf_show(stdout, "\nSimulated readings: %s\n", folder);
    return s;
}

int wf_cmd_simulate_test(int argc, char **argv)
{
    struct plan p = { 0 };
    struct wf_err e = { 0 };
    struct wf_diag d = { .arena = &p.arena };
    int code = wf_args_read(argc, argv, options, about, 1, 1, &p.arena, &p.options.args);
    if (code < 0) {
        bool quiet = p.options.args.quiet;
        enum wf_status s = simulate(&p, &d, quiet, &e);
        fflush(stdout);
        wf_print_findings(&d, quiet);
        code = s ? wf_complain(&e) : 0;
    }
    wf_arena_free(&p.arena);
    return code;
}
