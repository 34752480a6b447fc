/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The outline of a crown from an SVG path: every command, scale, and files that must be refused. */
#include "close.h"
#include "grow/outline_svg.h"
#include "grow/silhouette.h"
#include "scratch.h"
#include <stdlib.h>
#include <string.h>

#define PI 3.14159265358979324

struct reading {
    struct wf_arena arena;
    struct wf_silhouette s;
    struct wf_err err;
    enum wf_status status;
};

static void read_bytes(struct reading *r, const void *bytes, size_t size, double base, double top)
{
    struct scratch f;
    *r = (struct reading){ .arena = { 0 } };
    scratch_write(&f, bytes, size);
    r->status = wf_outline_svg_read(f.path, base, top, &r->s, &r->arena, &r->err);
    scratch_remove(&f);
}

static void read_file(struct reading *r, const char *text) { read_bytes(r, text, strlen(text), 4, 12); }

static void read_data(struct reading *r, const char *d)
{
    char text[4000];
    snprintf(text, sizeof text, "<svg xmlns='http://www.w3.org/2000/svg'><path d='%s'/></svg>", d);
    read_file(r, text);
}

static struct wf_outline_size size_of(const struct wf_silhouette *s)
{
    struct wf_model m = { .key = "m", .silhouette = *s };
    return wf_silhouette_size(&m, 12);
}

/* Area, centre and breadth of shapes known in closed form; the outline is 8 m high, from 4 to 12 m. */
static void shapes(void **state)
{
    (void)state;
    static const struct {
        const char *d;
        double area, centre, breadth, tolerance;
    } row[] = {
        { "M0 0 L10 0 10 20 0 20Z", 32, 8, 4, 1e-13 },
        { "m5,5h10v20h-10z", 32, 8, 4, 1e-13 },
        { "M5 5H15V25H5Z", 32, 8, 4, 1e-13 },
        { " M 0 0 L 10 20 L -10 20 L 0 0 ", 32, 4 + 8.0 / 3, 8, 1e-13 },
        { "M0-.5.5.5-.5.5z", 32, 4 + 8.0 / 3, 8, 1e-13 },
        { "M-40 0A40 40 0 1 1 40 0 40 40 0 1 1-40 0Z", 16 * PI, 8, 8, 1e-3 },
        { "m10 50a40 40 0 1180 0 40 40 0 11-80 0z", 16 * PI, 8, 8, 1e-3 },
        { "M0-40A20 40 0 0 1 0 40A20 40 0 0 1 0-40", 8 * PI, 8, 4, 1e-3 },
        /* 20 x 40 turned by 90 degrees is 40 x 20 */
        { "M-40 0A20 40 90 0 1 40 0A20 40 90 0 1-40 0Z", 32 * PI, 8, 16, 1e-3 },
        /* radii too small are enlarged to half the chord */
        { "M-40 0A1 1 0 0 1 40 0A1 1 0 0 1-40 0Z", 16 * PI, 8, 8, 1e-3 },
        /* under a parabola of the height 1/2: area 2/3 of the rectangle, centre 2/5 of the height */
        { "M0 0Q1-1 2 0Z", 2.0 / 3 * 8 * 32, 4 + 0.4 * 8, 32, 1e-3 },
        { "M0 0T10 0L10 20 0 20Z", 32, 8, 4, 1e-13 },
        /* the parabola as a cubic */
        { "M0 0C.66666666666667-.66666666666667 1.3333333333333-.66666666666667 2 0Z", 2.0 / 3 * 8 * 32,
          4 + 0.4 * 8, 32, 1e-3 },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct reading r;
        read_data(&r, row[i].d);
        if (r.status) fail_msg("%s: %s", row[i].d, r.err.text);
        struct wf_outline_size z = size_of(&r.s);
        assert_close(z.height, 8, 1e-13);
        assert_close(z.area, row[i].area, row[i].tolerance);
        assert_close(z.centre, row[i].centre, row[i].tolerance);
        assert_close(z.breadth, row[i].breadth, row[i].tolerance);
        wf_arena_free(&r.arena);
    }
}

/* Relative and absolute commands, shorthand and full ones give the same points. */
static void same_points(void **state)
{
    (void)state;
    static const char *const pairs[][2] = {
        { "M1 1C1 6 11 6 11 11C11 16 1 16 1 21Z", "m1 1c0 5 10 5 10 10s-10 5-10 10z" },
        { "M1 1Q6 1 6 6Q6 11 1 11L-9 6Z", "m1 1q5 0 5 5t-5 5l-10-5z" },
        { "M0 0L4 0L4 5L0 5Z", "m0 0 4 0 0 5-4 0z" },
        { "M0 0A5 5 0 0 1 10 0L5 9Z", "m0 0a5 5 0 0 1 10 0l-5 9z" },
        { "M0 0S4 0 4 5L0 5Z", "M0 0C0 0 4 0 4 5L0 5Z" },
    };
    for (size_t i = 0; i < sizeof pairs / sizeof *pairs; i++) {
        struct reading r[2];
        for (int k = 0; k < 2; k++) read_data(&r[k], pairs[i][k]);
        if (r[0].status || r[1].status) fail_msg("%s: %s%s", pairs[i][1], r[0].err.text, r[1].err.text);
        assert_int_equal(r[0].s.points, r[1].s.points);
        for (size_t k = 0; k < r[0].s.points; k++) {
            assert_close(r[0].s.x[k] + 100, r[1].s.x[k] + 100, 1e-12);
            assert_close(r[0].s.z[k], r[1].s.z[k], 1e-12);
        }
        for (int k = 0; k < 2; k++) wf_arena_free(&r[k].arena);
    }
}

#define SQUARE "d='M0 0H9V9H0Z'"
#define SVG(inside) "<svg xmlns='http://www.w3.org/2000/svg'>" inside "</svg>"

/* Which path is taken. */
static void one_path(void **state)
{
    (void)state;
    static const char *const good[] = {
        SVG("<path " SQUARE "/>"),
        "\xEF\xBB\xBF<?xml version='1.0' encoding='UTF-8'?>\n<!DOCTYPE svg PUBLIC '-//W3C//DTD SVG 1.1//EN' "
        "'http://www.w3.org/Graphics/SVG/1.1/DTD/svg11.dtd'>\n" SVG("<g><path " SQUARE "/></g>"),
        SVG("<defs><path d='M0 0'/></defs><g transform='translate(3, 4)'><path " SQUARE "/></g>"),
        SVG("<path d='M0 0L1 1'/><path id='crown' " SQUARE "/><path d='M3 3'/>"),
        SVG("<image href='file:///etc/passwd'/><path " SQUARE "/>"),
        "<svg><path " SQUARE "/></svg>",
    };
    for (size_t i = 0; i < sizeof good / sizeof *good; i++) {
        struct reading r;
        read_file(&r, good[i]);
        if (r.status) fail_msg("%s: %s", good[i], r.err.text);
        assert_int_equal(r.s.points, 4);
        assert_close(size_of(&r.s).area, 64, 1e-13);
        wf_arena_free(&r.arena);
    }
}

static void refused_data(void **state)
{
    (void)state;
    static const struct {
        const char *d, *words;
    } row[] = {
        { "", "character 1 of the path's data: the path is empty" },
        { "L1 1 2 2Z", "begins with M" },
        { "M", "character 2 of the path's data: M needs 2 numbers" },
        { "M1 1L", "L needs 2 numbers" },
        { "M1 1L2", "L needs 2 numbers" },
        { "M1 1L2 x", "L needs 2 numbers" },
        { "M1 1 2 2 3 nanZ", "L needs 2 numbers" },
        { "M1 1 2 2 inf 3Z", "one of the letters" },
        { "M0 0h1e400v1z", "H needs 1 number" },
        { "M0 0h1e308v1z", "too large" },
        { "M0 0L1 0 1 1X", "character 13 of the path's data: one of the letters" },
        { "M0 0H9V9", "not closed" },
        { "M0 0", "not closed" },
        { "M0 0Z", "no size" },
        { "M0 0H9Z", "no height" },
        { "M0 0H9V9H0ZM1 1H2V2Z", "goes on behind its end" },
        { "M0 0H9V9H0M1 1H2V2Z", "second part" },
        { "M0 0H9V9H0ZL3 3", "goes on behind its end" },
        { "M0 0A5 5 0 2 1 9 0L5 9Z", "a flag of an arc is 0 or 1" },
        { "M0 0A5 5 0 0 1 9", "A needs 7 numbers" },
        { "M0 0L9 9 9 0 0 9Z", "crosses itself" },
        { "M0 0L9 9Z", "has 2 points" },
        { "M0 0L9 9 0 0", "points" },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct reading r;
        read_data(&r, row[i].d);
        if (r.status != WF_EINPUT) fail_msg("%s: accepted (%d)", row[i].d, r.status);
        if (!strstr(r.err.text, row[i].words)) fail_msg("%s: %s", row[i].d, r.err.text);
        assert_int_equal(r.s.points, 0);
        wf_arena_free(&r.arena);
    }
}

static void refused_files(void **state)
{
    (void)state;
    static const struct {
        const char *text, *words;
    } row[] = {
        { "", "line" },
        { "x_m,z_m\n0,4\n", "line 1" },
        { "<svg><path " SQUARE "></svg>", "line 1" },
        { "<html><path " SQUARE "/></html>", "no SVG" },
        { SVG("<circle r='4'/>"), "turned into paths" },
        { SVG("<defs><path " SQUARE "/></defs>"), "no path is drawn" },
        { SVG("<path/>"), "the path is empty" },
        { SVG("<path " SQUARE "/><path " SQUARE "/>"), "2 paths are drawn" },
        { SVG("<path transform='scale(2)' " SQUARE "/>"), "other than one translate()" },
        { SVG("<g transform='translate(1) rotate(90)'><path " SQUARE "/></g>"),
          "other than one translate()" },
        { SVG("<path transform='translate' " SQUARE "/>"), "" },
        { "<svg viewBox='0 0 9 9' preserveAspectRatio='none'><path " SQUARE "/></svg>", "distorts" },
        { "<!DOCTYPE svg [<!ENTITY a 'M0 0H9'><!ENTITY b '&a;&a;&a;&a;'>]><svg><path d='&b;Z'/></svg>",
          "document type with declarations" },
        { "<!DOCTYPE svg [<!ENTITY a SYSTEM 'file:///etc/passwd'>]><svg><path d='M0 0'/></svg>",
          "document type with declarations" },
        { "<!DOCTYPE svg [\n%x;\n]><svg/>", "document type with declarations" },
        { "<svg><path d='&undeclared;'/></svg>", "line 1" },
        { "\xff\xfe<\0s\0v\0g\0/\0>\0", "line" },
    };
    for (size_t i = 0; i < sizeof row / sizeof *row; i++) {
        struct reading r;
        read_file(&r, row[i].text);
        if (i == 10) { /* text that begins with the word but has no bracket */
            assert_true(r.status == WF_EINPUT);
        } else {
            if (r.status != WF_EINPUT) fail_msg("%s: accepted", row[i].text);
            if (!strstr(r.err.text, row[i].words)) fail_msg("%s: %s", row[i].text, r.err.text);
        }
        assert_null(strchr(r.err.text, '\n'));
        wf_arena_free(&r.arena);
    }
}

/* Sizes are bounded: a file too large, too many points, a path too deep. */
static void bounds(void **state)
{
    (void)state;
    enum { LARGE = 5 * 1024 * 1024, MANY = 3000, DEEP = 100000 };
    struct reading r;
    char *text = malloc(LARGE);
    assert_non_null(text);
    memset(text, ' ', LARGE);
    read_bytes(&r, text, LARGE, 4, 12);
    assert_int_equal(r.status, WF_EINPUT);
    assert_non_null(strstr(r.err.text, "4 MiB"));
    wf_arena_free(&r.arena);
    for (int curves = 0; curves < 2; curves++) {
        char *at = text;
        at += sprintf(at, "<svg><path d='M0 0");
        for (int i = 1; i < (curves ? 600 : MANY); i++)
            at += sprintf(at, curves ? "Q%d %d %d 0" : "L%d %d", curves ? 2 * i - 1 : i, i % 2, 2 * i);
        at += sprintf(at, "V9999H0Z'/></svg>");
        read_bytes(&r, text, (size_t)(at - text), 4, 12);
        assert_int_equal(r.status, curves ? WF_OK : WF_EINPUT);
        if (curves) assert_true(r.s.points <= WF_OUTLINE_POINTS && r.s.points > 600);
        if (!curves) assert_non_null(strstr(r.err.text, "more than 2000 points"));
        wf_arena_free(&r.arena);
    }
    char *at = text;
    for (int i = 0; i < DEEP; i++) at += sprintf(at, i ? "<g>" : "<svg>");
    read_bytes(&r, text, (size_t)(at - text), 4, 12);
    assert_int_equal(r.status, WF_EINPUT);
    wf_arena_free(&r.arena);
    free(text);
}

static void heights(void **state)
{
    (void)state;
    static const double bad[][2] = { { NAN, NAN }, { 4, NAN }, { NAN, 12 }, { 12, 4 }, { 4, 4 }, { -1, 4 } };
    struct reading r;
    const char *text = SVG("<path d='M0 0H9V18H0Z'/>");
    for (size_t i = 0; i < sizeof bad / sizeof *bad; i++) {
        read_bytes(&r, text, strlen(text), bad[i][0], bad[i][1]);
        assert_int_equal(r.status, WF_EUSAGE);
        assert_non_null(strstr(r.err.text, "--outline-base and --outline-top"));
        wf_arena_free(&r.arena);
    }
    read_bytes(&r, text, strlen(text), 0, 1);
    assert_int_equal(r.status, WF_OK);
    assert_close(size_of(&r.s).area, 0.5, 1e-13);
    wf_arena_free(&r.arena);
}

/* Any bytes of a good file changed: an answer or an error, nothing else. */
static void changed_bytes(void **state)
{
    (void)state;
    const char *good = SVG("<g transform='translate(1,2)'><path id='crown' d='M0 0c0 5 10 5 10 10s-10 "
                           "5-10 10q-4-4-2-9t1-2A5 5 0 0 1 0 0z'/></g>");
    static const char bytes[] = "09.-eEMmZzAaQqTtSs <>'/&\x01\xff";
    size_t n = strlen(good);
    unsigned seed = 7;
    for (int i = 0; i < 3000; i++) {
        char text[400];
        struct reading r;
        memcpy(text, good, n + 1);
        for (int k = 0; k < 1 + i % 3; k++) {
            seed = seed * 1103515245u + 12345u;
            text[(seed >> 8) % n] = bytes[(seed >> 20) % (sizeof bytes - 1)];
        }
        read_bytes(&r, text, n, 4, 12);
        assert_true(r.status == WF_OK || r.status == WF_EINPUT);
        if (r.status == WF_OK) assert_true(size_of(&r.s).area > 0);
        wf_arena_free(&r.arena);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(shapes),       cmocka_unit_test(same_points),   cmocka_unit_test(one_path),
        cmocka_unit_test(refused_data), cmocka_unit_test(refused_files), cmocka_unit_test(bounds),
        cmocka_unit_test(heights),      cmocka_unit_test(changed_bytes),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
