#include "cmd/wind_rose.h"
#include "base/file.h"
#include "cmd/wind_tables.h"
#include "wind/rose.h"
#include <math.h>
#include <stdio.h>

static const double above[] = { 5.0, 10.0, 15.0, 20.0 };
enum { CLASSES = sizeof above / sizeof above[0] };

static double degrees(double rad) { return rad * 57.295779513082321; }

static void print(const char *file, const struct wf_rose *r)
{
    printf("%s: %zu directions, frequencies sum to %g in the file\n\n", file, r->sectors, r->typed_sum);
    printf("%-8s %10s %10s %7s  above", "from", "frequency", "mean m/s", "shape");
    for (int k = 0; k < CLASSES; k++) printf(" %6.0f", above[k]);
    printf(" m/s (hours a year)\n");
    for (size_t s = 0; s <= r->sectors; s++) {
        bool all = s == r->sectors;
        if (all)
            printf("%-8s %10.4f %10.3f %7s       ", "all", 1.0, wf_rose_mean(r), "");
        else
            printf("%5.1f    %10.4f %10.3f %7.3f       ", degrees(r->from[s]), r->frequency[s],
                   r->scale[s] * tgamma(1.0 + 1.0 / r->shape[s]), r->shape[s]);
        for (int k = 0; k < CLASSES; k++)
            printf(" %6.1f", 8766.0 * (all ? wf_rose_above(r, above[k])
                                           : r->frequency[s] * wf_rose_sector_above(r, s, above[k])));
        printf("\n");
    }
    printf("\nhourly mean exceeded 1 %% of the time: %.2f m/s; 0.1 %%: %.2f m/s\n", wf_rose_speed(r, 0.01),
           wf_rose_speed(r, 0.001));
}

static enum wf_status write(const char *folder, const struct wf_rose *r, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status status = wf_wind_begin(&f, folder, "tables/rose.csv", e);
    if (status) return status;
    fprintf(f.stream, "from_deg,frequency,weibull_scale_m_s,weibull_shape");
    for (int k = 0; k < CLASSES; k++) fprintf(f.stream, ",share_above_%g_m_s", above[k]);
    for (size_t s = 0; s < r->sectors; s++) {
        fprintf(f.stream, "\n%.6g,%.6g,%.6g,%.6g", degrees(r->from[s]), r->frequency[s], r->scale[s],
                r->shape[s]);
        for (int k = 0; k < CLASSES; k++)
            fprintf(f.stream, ",%.6g", r->frequency[s] * wf_rose_sector_above(r, s, above[k]));
    }
    fputc('\n', f.stream);
    status = wf_file_commit(&f, e);
    if (!status) status = wf_wind_begin(&f, folder, "plots/run.gp", e);
    if (status) return status;
    fprintf(f.stream, "SECTORS = %zu\n", r->sectors);
    return wf_file_commit(&f, e);
}

enum wf_status wf_wind_rose(const char *file, const char *folder, bool draw, bool quiet, struct wf_arena *a,
                            struct wf_diag *d, struct wf_err *e)
{
    static const char *const figures[] = { "wind_rose", NULL };
    struct wf_rose r;
    if (!file) return wf_fail(e, WF_EUSAGE, "the wind rose needs --file");
    enum wf_status status = wf_rose_read(file, a, d, &r, e);
    if (status) return status;
    if (!quiet) print(file, &r);
    status = wf_wind_folders(folder, e);
    if (!status) status = write(folder, &r, e);
    if (!status && draw) status = wf_wind_figures(folder, figures, e);
    return status;
}
