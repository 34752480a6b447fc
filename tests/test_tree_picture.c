/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Pictures of trees: what is written for gnuplot, what is drawn, what is refused. */
#include "base/arena.h"
#include "base/err.h"
#include "branched.h"
#include "data/model.h"
#include "edited.h"
#include "imported.h"
#include "out/figures.h"
#include "out/tree_picture.h"
#include <sys/stat.h>

static const char plain[] =
    "model: m\n"
    "name: It's a tree\n"
    "generator: levels\n"
    "stem: {height: 10 m, base_radius: 100 mm, taper: {law: linear, tip_share: 1}, segments: "
    "10}\n"
    "branches:\n"
    "  - name: limb\n"
    "    place: {at: [0.5, 0.8]}\n"
    "    azimuth: {rule: spiral, divergence: 0 deg}\n"
    "    insertion: {angle: 90 deg}\n"
    "    length: {law: absolute, value: 3 m}\n"
    "    radius: {law: absolute, value: 1 mm}\n"
    "    taper: {tip_share: 1}\n"
    "    segments: 3\n"
    "leaves: {area: 4 m2}\n";

static struct grown g;
static char folder[] = "/tmp/windfirm-picture-XXXXXX";

static int set_up(void **state)
{
    (void)state;
    strcpy(folder, "/tmp/windfirm-picture-XXXXXX");
    return mkdtemp(folder) ? 0 : -1;
}

static int tear_down(void **state)
{
    (void)state;
    char path[128];
    static const char *const names[] = { "plots/tree.dat", "plots/tree.csv", "plots/tree.svg",
                                         "plots/tree.png", "plots",          "a.svg",
                                         "a.png" };
    wf_arena_free(&g.arena);
    for (size_t k = 0; k < sizeof names / sizeof *names; k++) {
        snprintf(path, sizeof path, "%s/%s", folder, names[k]);
        (void)remove(path);
    }
    return rmdir(folder); /* nothing else may be left */
}

static struct wf_tree_picture picture(void)
{
    return (struct wf_tree_picture){ &g.tree, &g.model, &g.species, false };
}

static void summary_counts_axes_and_wood(void **state)
{
    (void)state;
    struct wf_tree_summary s;
    struct wf_err e = { 0 };
    grown_make(&g, plain);
    assert_int_equal(wf_tree_summarise(&g.tree, NULL, &s, &e), WF_OK);
    assert_int_equal(s.levels, 2);
    assert_int_equal(s.level[0].axes, 1);
    assert_int_equal(s.level[0].segments, 10);
    assert_int_equal(s.level[1].axes, 2);
    assert_close(s.level[1].length_mean, 3, 1e-12);
    assert_close(s.level[1].diameter_mean, 0.002, 1e-12);
    assert_close(s.wood_volume, M_PI * (0.01 * 10 + 1e-6 * 6), 1e-12);
    assert_close(s.leaf_area, 4, 1e-12);
    assert_close(s.high[0], 3, 1e-12);
    assert_close(s.high[1] - s.low[1], 0, 1e-12);
    assert_close(s.height, 10, 1e-12);
}

/* Links lie inside the wood of the parent: they add no wood, no length, and not their thickness. */
static void links_are_not_counted(void **state)
{
    (void)state;
    struct imported t;
    struct wf_qsm_model m;
    struct wf_tree_summary s;
    import_path(&t, "tests/data/qsm/normalised.csv");
    assert_joined(&t, WF_JOINT_AXIS, &m);
    assert_int_equal(m.links, 2);
    assert_int_equal(wf_tree_summarise(&m.tree, m.kind, &s, &t.err), WF_OK);
    assert_close(s.wood_volume, m.volume, 1e-12);
    assert_int_equal(s.level[1].axes, 2);
    assert_int_equal(s.level[0].segments + s.level[1].segments, m.tree.n - m.links);
    assert_close(s.level[1].diameter_mean, 0.04, 1e-12); /* of the branches; of their links: 0.12 */
    wf_arena_free(&t.arena);
}

/* Blocks: thick and thin outlines by view and level; a thick one is as wide as the stem. */
static void outlines_are_true_to_scale(void **state)
{
    (void)state;
    char path[128], line[256];
    struct wf_err e = { 0 };
    struct wf_tree_picture p;
    grown_make(&g, plain);
    p = picture();
    snprintf(path, sizeof path, "%s/plots", folder);
    assert_int_equal(mkdir(path, 0700), 0);
    assert_int_equal(wf_tree_picture_write(&p, folder, &e), WF_OK);
    assert_true(wf_tree_picture_there(folder));
    snprintf(path, sizeof path, "%s/plots/tree.dat", folder);
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    size_t block = 0, polygons[8] = { 0 }, empty = 0;
    double low = INFINITY, high = -INFINITY, x, z;
    while (fgets(line, sizeof line, f)) {
        if (sscanf(line, "%lf %lf", &x, &z) == 2) {
            if (empty == 1) polygons[block]++;
            if (empty >= 2) block++;
            empty = 0;
            if (block == 0) low = fmin(low, x), high = fmax(high, x);
        } else {
            empty++;
        }
    }
    fclose(f);
    assert_int_equal(block, 7);           /* 2 levels x 2 views x 2 kinds, the last not empty */
    assert_int_equal(polygons[0], 10);    /* the stem from the front */
    assert_int_equal(polygons[1], 0);     /* none of it thin         */
    assert_int_equal(polygons[5], 2 * 3); /* limbs of 2 mm are lines */
    assert_close(low, -0.1, 1e-12);
    assert_close(high, 0.1, 1e-12);
    wf_tree_picture_remove(folder);
    assert_false(wf_tree_picture_there(folder));
}

static bool has_gnuplot(void) { return system("gnuplot --version >/dev/null 2>&1") == 0; }

static void drawn_as_lines_and_as_points(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    char path[128], head[9] = "";
    struct wf_tree_picture p;
    if (!has_gnuplot()) skip();
    grown_make(&g, plain);
    p = picture();
    snprintf(path, sizeof path, "%s/a.svg", folder);
    if (wf_tree_picture_draw(&p, path, NULL, &e)) fail_msg("%s", e.text);
    FILE *f = fopen(path, "r");
    assert_non_null(f);
    static char text[1 << 20];
    text[fread(text, 1, sizeof text - 1, f)] = '\0';
    fclose(f);
    assert_non_null(strstr(text, "</svg>"));
    assert_non_null(strstr(text, "limb"));
    assert_null(strstr(text, "nan"));
    snprintf(path, sizeof path, "%s/a.png", folder);
    if (wf_tree_picture_draw(&p, path, NULL, &e)) fail_msg("%s", e.text);
    f = fopen(path, "rb");
    assert_non_null(f);
    assert_int_equal(fread(head, 1, 8, f), 8);
    fclose(f);
    assert_memory_equal(head, "\x89PNG\r\n\x1a\n", 8);
}

static void another_ending_is_refused(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    struct wf_tree_picture p;
    grown_make(&g, plain);
    p = picture();
    assert_int_equal(wf_tree_picture_draw(&p, "tree.bmp", NULL, &e), WF_EUSAGE);
    assert_string_equal(e.text, "tree.bmp: a picture ends in .svg, .png or .pdf");
}

/* A tree of many segments goes into a page as points, of few as lines. */
static void a_page_gets_points_for_many_segments(void **state)
{
    (void)state;
    struct wf_err e = { 0 };
    struct wf_tree_picture p;
    char path[128];
    if (!has_gnuplot()) skip();
    for (int many = 0; many < 2; many++) {
        xmlDoc *svg;
        char *text = edited(
            plain, &(struct edit){ "segments: 10}", many ? "segments: 9000}" : "segments: 10}", NULL });
        grown_make(&g, text);
        free(text);
        p = picture();
        snprintf(path, sizeof path, "%s/plots", folder);
        (void)mkdir(path, 0700);
        if (wf_tree_picture_write(&p, folder, &e)) fail_msg("%s", e.text);
        assert_true(wf_tree_picture_lines(folder) == !many);
        if (many)
            (void)wf_tree_picture_report(folder, "en", &svg, NULL, &e);
        else
            wf_figures_draw(folder, &(struct wf_figure){ "tree", "tree", 0 }, 1, "en", &svg, NULL, &e);
        if (!svg) fail_msg("%s", e.text);
        const xmlNode *root = xmlDocGetRootElement(svg), *image = NULL;
        for (const xmlNode *n = root->children; n; n = n->next)
            if (!strcmp((const char *)n->name, "image")) image = n;
        assert_string_equal((const char *)root->name, "svg");
        assert_true((image != NULL) == (many == 1));
        if (many) {
            xmlChar *href = xmlGetProp(image, BAD_CAST "href");
            assert_non_null(strstr((const char *)href, "data:image/png;base64,iVBORw0KGgo"));
            xmlFree(href);
        }
        xmlFreeDoc(svg);
        wf_arena_free(&g.arena);
    }
}

int main(void)
{
#define T(name) cmocka_unit_test_setup_teardown(name, set_up, tear_down)
    const struct CMUnitTest tests[] = {
        T(summary_counts_axes_and_wood),         T(outlines_are_true_to_scale),
        T(drawn_as_lines_and_as_points),         T(another_ending_is_refused),
        T(a_page_gets_points_for_many_segments), T(links_are_not_counted),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
