/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Wind roses: sectors by name, empty sectors, frequencies; roses made from records whose distribution is
 * known. */
#include "close.h"
#include "scratch.h"
#include "wind/climate.h"
#include "wind/rose_record.h"
#include <math.h>
#include <stdlib.h>
#include <string.h>

struct reading {
    struct wf_arena arena;
    struct wf_diag diag;
    struct wf_err err;
    struct wf_rose rose;
    struct wf_rose_record record;
};

static void begin(struct reading *r)
{
    *r = (struct reading){ 0 };
    r->diag.arena = &r->arena;
}

static enum wf_status read_rose(struct reading *r, const char *text)
{
    struct scratch s;
    begin(r);
    scratch_write(&s, text, strlen(text));
    enum wf_status status = wf_rose_read(s.path, &r->arena, &r->diag, &r->rose, &r->err);
    scratch_remove(&s);
    return status;
}

static const char *found(const struct reading *r, const char *code)
{
    for (const struct wf_finding *f = r->diag.first; f; f = f->next)
        if (f->code && !strcmp(f->code, code)) return f->text;
    return NULL;
}

/* The sectors of tests/data/public/rose_empty_sector.csv. */
static void check_empty(const struct wf_rose *r)
{
    assert_int_equal(r->sectors, 8);
    assert_close(r->frequency[2], 0, 0);
    assert_true(isnan(r->scale[2]) && isnan(r->shape[2]) && isnan(wf_rose_sector_mean(r, 2)));
    for (double u = 0; u < 20; u += 5) assert_close(r->frequency[2] * wf_rose_sector_above(r, 2, u), 0, 0);
    assert_close(r->frequency[5], 0.3, 1e-12);
    assert_close(r->scale[5], 7.3, 1e-9);
    assert_close(r->shape[6], 2.2, 1e-12);
    double sum = 0;
    for (size_t s = 0; s < 8; s++) sum += r->frequency[s];
    assert_close(sum, 1, 1e-12);
}

static double by_hand(double u)
{
    static const double f[] = { 5.9, 4.4, 6.5, 12, 30, 28, 13.2 }, A[] = { 5.6, 5, 5.5, 6, 7.3, 8.4, 6.6 },
                        k[] = { 1.9, 1.8, 2, 1.9, 2, 2.2, 1.9 };
    double sum = 0;
    for (int i = 0; i < 7; i++) sum += f[i] / 100 * exp(-pow(u / A[i], k[i]));
    return sum;
}

static void empty_sectors(void **state)
{
    (void)state;
    struct reading r;
    static const char *const same[] = {
        /* another unit, and names in place of degrees */
        "sector,frequency,weibull_scale_kmh,weibull_shape\nN,5.9,20.16,1.9\nne,4.4,18,1.8\nE,0,0,0\n"
        "SE,6.5,19.8,2\nS,12,21.6,1.9\nSW,30,26.28,2\nW,28,30.24,2.2\nNW,13.2,23.76,1.9\n",
        /* another separator and decimal sign, cells of the empty sector left empty, names in Chinese */
        "direction;frequency;weibull_scale_m_s;weibull_shape\n北;5,9;5,6;1,9\n东北风;4,4;5,0;1,8\n东;0;;\n"
        "东南;6,5;5,5;2\n南;12;6;1,9\n西南;30;7,3;2\n西;28;8,4;2,2\n西北;13,2;6,6;1,9\n",
        /* another order of rows and columns, shares */
        "weibull_shape,weibull_scale_ms,frequency,direction_deg\n1.9,6.6,0.132,315\n2.2,8.4,0.28,270\n"
        "2,7.3,0.30,225\n1.9,6,0.12,180\n2,5.5,0.065,135\nx,-3,0,90\n1.8,5,0.044,45\n1.9,5.6,0.059,360\n",
    };
    begin(&r);
    assert_int_equal(
        wf_rose_read("tests/data/public/rose_empty_sector.csv", &r.arena, &r.diag, &r.rose, &r.err), WF_OK);
    assert_null(r.diag.first);
    double above = wf_rose_above(&r.rose, 8);
    assert_close(above, by_hand(8), 1e-12);
    wf_arena_free(&r.arena);
    for (size_t i = 0; i < sizeof same / sizeof *same; i++) {
        if (read_rose(&r, same[i])) fail_msg("%zu: %s", i, r.diag.first ? r.diag.first->text : r.err.text);
        assert_null(r.diag.first);
        check_empty(&r.rose);
        assert_close(wf_rose_above(&r.rose, 8), above, 1e-9);
        wf_arena_free(&r.arena);
    }
}

static void names(void **state)
{
    (void)state;
    static const struct {
        const char *text;
        double degrees;
    } good[] = { { "N", 0 },         { "nne", 22.5 },    { "WSW", 247.5 },
                 { "NNW", 337.5 },   { "270", 270 },     { "22,5", 22.5 },
                 { "北东北", 22.5 }, { "东", 90 },       { "东南偏南", 157.5 },
                 { "西北风", 315 },  { "西南西", 247.5 } };
    double degrees;
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        assert_true(wf_rose_direction(good[i].text, &degrees, NULL));
        assert_close(degrees, good[i].degrees, 1e-12);
    }
    static const char *const bad[] = { "", "VRB", "NEN", "12x", "中", "风" };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++)
        assert_false(wf_rose_direction(bad[i], &degrees, NULL));
}

#define HEAD "sector,frequency,weibull_scale_ms,weibull_shape\n"
static void frequency_sums(void **state)
{
    (void)state;
    struct reading r;
    static const struct {
        double each;
        bool said;
    } sum[] = { { 0.125, false }, { 12.5, false }, { 12.51, false },
                { 0.12, true },   { 11, true },    { 438, true } };
    static const char *const name[] = { "N", "NE", "E", "SE", "S", "SW", "W", "NW" };
    for (size_t i = 0; i < sizeof sum / sizeof *sum; i++) {
        char text[800] = HEAD;
        for (int s = 0; s < 8; s++)
            snprintf(text + strlen(text), sizeof text - strlen(text), "%s,%g,5,2\n", name[s], sum[i].each);
        assert_int_equal(read_rose(&r, text), WF_OK);
        assert_int_equal(found(&r, "frequency-sum") != NULL, sum[i].said);
        assert_close(r.rose.frequency[3], 0.125, 1e-12);
        wf_arena_free(&r.arena);
    }
}

static void mistakes(void **state)
{
    (void)state;
    struct reading r;
    static const struct {
        const char *text, *says;
    } bad[] = {
        { HEAD "N,1,5,2\nNEN,1,5,2\n", "'NEN' is neither a number of degrees nor a name" },
        { HEAD "N,1,0,2\nNE,1,5,2\n", "0 is outside 0.1 to 40" },
        { "sector,frequency,weibull_scale,weibull_shape\nN,1,5,2\n", "weibull_scale_ms" },
        { HEAD "N,0,5,2\nNE,0,5,2\nE,0,5,2\nSE,0,5,2\nS,0,5,2\nSW,0,5,2\nW,0,5,2\nNW,0,5,2\n",
          "all are zero" },
        { HEAD "N,1,5,2\nNE,1,5,2\nN,1,5,2\nSE,1,5,2\nS,1,5,2\nSW,1,5,2\nW,1,5,2\nNW,1,5,2\n",
          "given twice" },
        { HEAD "N,1,5,2\nNNE,1,5,2\nE,1,5,2\nSE,1,5,2\nS,1,5,2\nSW,1,5,2\nW,1,5,2\nNW,1,5,2\n",
          "22.5 is not a multiple of 45" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_int_equal(read_rose(&r, bad[i].text), WF_EINPUT);
        assert_non_null(r.diag.first);
        if (!strstr(r.diag.first->text, bad[i].says)) fail_msg("%zu: %s", i, r.diag.first->text);
        wf_arena_free(&r.arena);
    }
}

/* ---- Records ---- */

enum { HOURS = 30000, SECTORS = 12 };
static double chance(void) { return (double)rand() / ((double)RAND_MAX + 1.0); }
static double true_scale(size_t s) { return 4.0 + 0.5 * (double)s; }
static double true_shape(size_t s) { return 1.5 + 0.1 * (double)s; }
static double true_share(size_t s) { return (1.0 + (double)s) / 78.0; }

enum style { PLAIN, KNOTS, COMMA, ORDER };

static void row(FILE *f, enum style style, double u, const char *direction)
{
    char speed[32];
    snprintf(speed, sizeof speed, "%.4f", style == KNOTS ? u * 3600 / 1852 : u);
    if (style == COMMA) *strchr(speed, '.') = ',';
    if (style == ORDER)
        fprintf(f, "%s,7,%s\n", direction, speed);
    else
        fprintf(f, style == COMMA ? "%s;%s\n" : "%s,%s\n", speed, direction);
}

/* 5 % calms, 2 % winds without direction, the rest from twelve sectors. */
static void write_record(struct scratch *to, enum style style)
{
    static const char *const head[] = { "speed_ms,direction_deg\n", "speed_kn,direction_deg\n",
                                        "speed_ms;direction_deg\n", "direction_deg,t_degC,speed_ms\n" };
    scratch_write(to, head[style], strlen(head[style]));
    FILE *f = fopen(to->path, "ab");
    assert_non_null(f);
    srand(7);
    for (int i = 0; i < HOURS; i++) {
        char direction[32];
        size_t s = 0;
        for (double c = chance(); s < SECTORS - 1 && c >= true_share(s); s++) c -= true_share(s);
        double kind = chance(), u = true_scale(s) * pow(-log(1.0 - chance()), 1.0 / true_shape(s));
        snprintf(direction, sizeof direction, "%.1f",
                 fmod(360 + 30.0 * (double)s + 29.8 * (chance() - 0.5), 360));
        row(f, style, kind < 0.05 ? 0 : u, kind < 0.03 ? "" : kind < 0.07 ? "VRB" : direction);
    }
    fclose(f);
}

static void known_distributions(void **state)
{
    (void)state;
    for (enum style style = PLAIN; style <= ORDER; style++) {
        struct scratch s;
        struct reading r;
        begin(&r);
        write_record(&s, style);
        const struct wf_rose_request q = { 0 };
        if (wf_rose_from_record(s.path, &q, &r.arena, &r.diag, &r.record, &r.err)) fail_msg("%s", r.err.text);
        scratch_remove(&s);
        const struct wf_rose_record *x = &r.record;
        assert_int_equal(x->rose.sectors, SECTORS);
        assert_int_equal(x->rows, HOURS);
        assert_int_equal(x->directed + x->undirected + x->calm, HOURS);
        assert_close((double)x->calm / HOURS, 0.05, 0.1);
        assert_close((double)x->undirected / HOURS, 0.02, 0.15);
        for (size_t k = 0; k < SECTORS; k++) {
            const struct wf_rose_fit *f = &x->fit[k];
            assert_true(fabs(f->scale - true_scale(k)) < 3 * f->scale_error);
            assert_true(fabs(f->shape - true_shape(k)) < 3 * f->shape_error);
            assert_close(f->shape_error, f->shape * sqrt(6.0 / (9.8696044 * (double)f->hours)), 1e-3);
            double share = true_share(k), error = sqrt(share * (1 - share) / (double)x->directed);
            assert_true(fabs(x->rose.frequency[k] - share) < 3.5 * error);
        }
        /* the fits count as many hours as the record, and calms are among them */
        assert_close(wf_rose_above(&x->rose, 8), wf_rose_record_above(x, 8), 0.02);
        assert_close(wf_rose_above(&x->rose, 1e-9), 1 - (double)x->calm / HOURS, 1e-6);
        assert_non_null(strstr(found(&r, "rose-record"), "calm"));
        assert_null(found(&r, "rose-few"));
        assert_null(found(&r, "rose-steps"));
        wf_arena_free(&r.arena);
    }
}

static enum wf_status read_record(struct reading *r, const char *text, const char *columns, size_t sectors)
{
    struct scratch s;
    const struct wf_rose_request q = { columns, sectors };
    begin(r);
    scratch_write(&s, text, strlen(text));
    enum wf_status status = wf_rose_from_record(s.path, &q, &r->arena, &r->diag, &r->record, &r->err);
    scratch_remove(&s);
    return status;
}

/* 60 rows of u = 1, 2, ... from directions that go round in steps. */
static char *stepped(double step)
{
    static char text[4000];
    strcpy(text, "speed_ms,direction_deg\n");
    for (int i = 0; i < 60; i++)
        snprintf(text + strlen(text), sizeof text - strlen(text), "%d,%g\n", 1 + i % 9, fmod(i * step, 360));
    return text;
}

static void few_and_steps(void **state)
{
    (void)state;
    struct reading r;
    assert_int_equal(read_record(&r, stepped(10), NULL, 0), WF_OK);
    assert_int_equal(r.record.rose.sectors, 12);
    assert_null(found(&r, "rose-steps")); /* three steps of ten degrees make a sector */
    assert_non_null(strstr(found(&r, "rose-few"), "A and k of all directions"));
    assert_close(r.record.rose.scale[0], r.record.fit[12].scale, 0);
    assert_true(isnan(r.record.fit[0].scale));
    wf_arena_free(&r.arena);
    assert_int_equal(read_record(&r, stepped(10), NULL, 16), WF_OK);
    assert_non_null(strstr(found(&r, "rose-steps"), "more steps than others"));
    wf_arena_free(&r.arena);
    assert_int_equal(read_record(&r, stepped(22.5), NULL, 0), WF_OK);
    assert_int_equal(r.record.rose.sectors, 16);
    assert_null(found(&r, "rose-steps"));
    wf_arena_free(&r.arena);
}

/* The head of a Campbell logger gives the unit; a number that is impossible and repeated is a missing mark,
 * in the file's own unit; one that the file declares is one too. */
static void logger_and_marks(void **state)
{
    (void)state;
    static const char *const heads[] = {
        "\"TOA5\",\"st\",\"CR1000\",\"1\",\"2\",\"3\",\"4\",\"W\"\n\"TIMESTAMP\",\"WS\",\"WD\"\n"
        "\"TS\",\"kilometers/hour\",\"Deg\"\n\"\",\"Avg\",\"Avg\"\n",
        "# missing: 99.9\nt;WS_kmh;WD\n",
    };
    for (int form = 0; form < 2; form++) {
        char text[8000];
        struct reading r;
        strcpy(text, heads[form]);
        for (int i = 0; i < 122; i++) {
            double kmh = i % 61 == 60 ? (form ? 99.9 : 999.9) : 3.6 * (1 + i % 9);
            size_t n = strlen(text);
            if (form)
                snprintf(text + n, sizeof text - n, "%d;%.1f;%d\n", i, kmh, 45 * (i % 8));
            else
                snprintf(text + n, sizeof text - n, "\"2024-01-0%d %02d:00:00\",%.1f,%d\n", 1 + i / 24,
                         i % 24, kmh, 45 * (i % 8));
        }
        if (read_record(&r, text, form ? "WS_kmh,WD" : "WS,WD", 8)) fail_msg("%s", r.err.text);
        assert_int_equal(r.record.missing, 2);
        assert_int_equal(r.record.n, 120);
        double most = 0;
        for (size_t k = 0; k < r.record.n; k++) most = fmax(most, r.record.speed[k]);
        assert_close(most, 9, 1e-12);
        assert_true(form || found(&r, "missing-marks"));
        wf_arena_free(&r.arena);
    }
}

static void bad_records(void **state)
{
    (void)state;
    struct reading r;
    static const struct {
        const char *text, *columns, *says;
    } bad[] = {
        { "speed_ms,direction_deg\n", NULL, "0 rows with wind" },
        { "speed_ms,direction_deg\n3,10\n3,20\n", NULL, "2 rows with wind" },
        { "speed_ms,direction_deg\nfast,10\n3,20\n", NULL, "line 2, column 1: 'fast'" },
        { "speed_ms,direction_deg\n130,10\n3,20\n", NULL, "130 (130 m/s) is a missing mark or a peak" },
        { "speed_ms,direction_deg\n3,10\n", "speed_ms", "a rose needs two" },
        { "speed_ms,direction_deg\n3,10\n", "speed_ms,direction_deg,t", "a rose needs two" },
        { "speed,direction_deg\n3,10\n", "speed,direction_deg", "does not say its unit" },
        { "speed_ms,direction_deg\n3,10\n", "speed_ms,direktion_deg", "is it 'direction_deg'" },
    };
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        assert_true(read_record(&r, bad[i].text, bad[i].columns, 0) != WF_OK);
        const char *text = r.diag.first ? r.diag.first->text : r.err.text;
        if (!strstr(text, bad[i].says)) fail_msg("%zu: %s", i, text);
        wf_arena_free(&r.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(empty_sectors),       cmocka_unit_test(names),
        cmocka_unit_test(frequency_sums),      cmocka_unit_test(mistakes),
        cmocka_unit_test(known_distributions), cmocka_unit_test(few_and_steps),
        cmocka_unit_test(logger_and_marks),    cmocka_unit_test(bad_records)
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
