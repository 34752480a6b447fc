/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "out/wind_stream.h"
#include "base/file.h"
#include "wind/gust_report.h"
#include "wind/gust_spectral.h"
#include <math.h>
#include <stdint.h>
#include <string.h>
#include <time.h>

enum { TILE = 32 };

struct stream {
    const struct wf_gust_spec *spec;
    FILE *to;
    bool text;
    float *row;                                       /* TILE * points * components             */
    double sum[WF_COMPONENTS], square[WF_COMPONENTS]; /* of the first point, about its mean asked for */
};

static void head(const struct stream *w)
{
    static const char *const name[WF_COMPONENTS] = { "u", "v", "w" };
    const struct wf_gust_spec *s = w->spec;
    if (w->text) {
        fputs("t_s", w->to);
        for (size_t p = 0; p < s->points; p++)
            for (unsigned c = 0; c < s->components; c++) fprintf(w->to, ",%s%zu_m_s", name[c], p + 1);
        fputc('\n', w->to);
        return;
    }
    const uint16_t one = 1;
    char words[118]; /* with the ten bytes before it a multiple of 64 */
    int n =
        snprintf(words, sizeof words, "{'descr': '%cf4', 'fortran_order': False, 'shape': (%zu, %zu, %u), }",
                 *(const char *)&one ? '<' : '>', s->steps, s->points, s->components);
    memset(words + n, ' ', sizeof words - (size_t)n);
    words[sizeof words - 1] = '\n';
    fwrite("\x93NUMPY\x01\x00\x76\x00", 1, 10, w->to); /* 0x76: length of the words */
    fwrite(words, 1, sizeof words, w->to);
}

/* Steps of a block from `i` on, at most TILE: steps are the slowest in the file and the fastest in the block,
 * so that a tile of them keeps both in reach. */
static void tile(struct stream *w, const double *block, size_t stride, size_t i, size_t steps, size_t at)
{
    const struct wf_gust_spec *s = w->spec;
    size_t rows = s->points * s->components;
    for (size_t p = 0; p < s->points; p++)
        for (unsigned c = 0; c < s->components; c++)
            for (size_t k = 0; k < steps; k++)
                w->row[k * rows + p * s->components + c] = (float)block[(c * s->points + p) * stride + i + k];
    if (!w->text) fwrite(w->row, sizeof *w->row, steps * rows, w->to);
    for (size_t k = 0; k < steps && w->text; k++) {
        fprintf(w->to, "%.7g", (double)(at + k) * s->step);
        for (size_t r = 0; r < rows; r++) fprintf(w->to, ",%.6g", (double)w->row[k * rows + r]);
        fputc('\n', w->to);
    }
}

static enum wf_status blocks(struct stream *w, struct wf_gust *g, double *block,
                             void (*progress)(size_t block, size_t blocks), struct wf_err *e)
{
    const struct wf_gust_spec *s = w->spec;
    double mean = s->mean ? s->mean[0] : s->speed;
    for (size_t b = 0; b < g->blocks; b++) {
        if (progress) progress(b + 1, g->blocks);
        enum wf_status status = wf_gust_block(g, b, block, e);
        if (status) return status;
        size_t first = b * g->block, n = s->steps - first < g->block ? s->steps - first : g->block;
        for (size_t i = 0; i < n; i += TILE)
            tile(w, block, g->block, i, n - i < TILE ? n - i : TILE, first + i);
        for (unsigned c = 0; c < s->components; c++)
            for (size_t i = 0; i < n; i++) {
                double x = block[c * s->points * g->block + i] - (c ? 0.0 : mean);
                w->sum[c] += x, w->square[c] += x * x;
            }
        if (ferror(w->to)) break; /* the commit tells why */
    }
    return WF_OK;
}

static struct wf_wind_streamed streamed(const struct stream *w, const struct wf_gust *g, double seconds,
                                        struct wf_arena *a)
{
    const struct wf_gust_spec *s = w->spec;
    double n = (double)s->steps;
    struct wf_wind_streamed out = { .blocks = g->blocks,
                                    .block = g->block,
                                    .seconds = seconds,
                                    .joint = g->joint,
                                    .coherence = s->points > 1 ? wf_gust_coherence_error(g, a) : NAN };
    for (unsigned c = 0; c < s->components; c++) {
        double off = w->sum[c] / n;
        out.mean[c] = off + (c ? 0.0 : s->mean ? s->mean[0] : s->speed);
        out.deviation[c] = sqrt(fmax(w->square[c] / n - off * off, 0.0));
        out.asked[c] = sqrt(wf_gust_variance(s, 0, (enum wf_component)c));
    }
    return out;
}

enum wf_status wf_wind_stream(const struct wf_gust_spec *s, const char *path,
                              void (*progress)(size_t block, size_t blocks), struct wf_arena *a,
                              struct wf_diag *d, struct wf_wind_streamed *out, struct wf_err *e)
{
    struct wf_gust g;
    struct wf_file f = { 0 };
    size_t length = strlen(path), rows = s->points * s->components;
    clock_t start = clock();
    enum wf_status status = wf_gust_open(s, a, d, &g, e);
    if (status) return status;
    struct stream w = { .spec = s,
                        .text = length > 4 && strcmp(path + length - 4, ".csv") == 0,
                        .row = WF_TAKE(a, TILE * rows, float) };
    double *block = WF_TAKE(a, rows * g.block, double);
    if (!w.row || !block)
        status = wf_fail(e, WF_ENOMEM, "no room for a block of %zu points", s->points);
    else if (!(status = wf_file_begin(&f, path, e))) {
        w.to = f.stream;
        head(&w);
        status = blocks(&w, &g, block, progress, e);
    }
    if (!status) status = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    if (!status) *out = streamed(&w, &g, (double)(clock() - start) / CLOCKS_PER_SEC, a);
    wf_gust_close(&g);
    return status;
}
