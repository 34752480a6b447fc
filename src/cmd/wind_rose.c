#include "cmd/wind_rose.h"
#include "out/wind_results.h"
#include "wind/rose.h"
#include <math.h>
#include <stdio.h>

static double degrees(double rad) { return rad * 57.295779513082321; }

static void print(const char *file, const struct wf_rose *r)
{
    printf("%s: %zu directions, frequencies sum to %g in the file\n\n", file, r->sectors, r->typed_sum);
    printf("%-8s %10s %10s %7s  above", "from", "frequency", "mean m/s", "shape");
    for (int k = 0; k < WF_ROSE_CLASSES; k++) printf(" %6.0f", wf_rose_classes[k]);
    printf(" m/s (hours a year)\n");
    for (size_t s = 0; s <= r->sectors; s++) {
        bool all = s == r->sectors;
        if (all)
            printf("%-8s %10.4f %10.3f %7s       ", "all", 1.0, wf_rose_mean(r), "");
        else
            printf("%5.1f    %10.4f %10.3f %7.3f       ", degrees(r->from[s]), r->frequency[s],
                   r->scale[s] * tgamma(1.0 + 1.0 / r->shape[s]), r->shape[s]);
        for (int k = 0; k < WF_ROSE_CLASSES; k++)
            printf(" %6.1f",
                   8766.0 * (all ? wf_rose_above(r, wf_rose_classes[k])
                                 : r->frequency[s] * wf_rose_sector_above(r, s, wf_rose_classes[k])));
        printf("\n");
    }
    printf("\nhourly mean exceeded 1 %% of the time: %.2f m/s; 0.1 %%: %.2f m/s\n", wf_rose_speed(r, 0.01),
           wf_rose_speed(r, 0.001));
}

enum wf_status wf_wind_rose(const struct wf_args *g, const struct wf_doc_head *head, struct wf_arena *a,
                            struct wf_err *e)
{
    const char *file = wf_args_text(g, "--file"), *folder = wf_args_text(g, "--output");
    bool quiet = wf_args_given(g, "--quiet");
    struct wf_diag d = { .arena = a };
    struct wf_rose r;
    if (!file) return wf_fail(e, WF_EUSAGE, "the wind rose needs --file");
    enum wf_status status = wf_rose_read(file, a, &d, &r, e);
    if (!status && !quiet) print(file, &r);
    if (!status) status = wf_rose_results_write(&r, file, head, &d, folder, e);
    if (!status && !wf_args_given(g, "--no-plots"))
        status = wf_pages_make(folder, wf_args_text(g, "--lang"), a, e);
    wf_print_findings(&d, quiet);
    return status;
}
