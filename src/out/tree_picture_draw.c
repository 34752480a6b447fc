/* The picture of a tree by gnuplot: for a file, and for a page. */
#include "base/file.h"
#include "out/figures.h"
#include "out/tree_picture.h"
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

static enum wf_status join(const char *folder, const char *name, char path[static WF_PATH_MAX],
                           struct wf_err *e)
{
    int n = snprintf(path, WF_PATH_MAX, "%s/%s", folder, name);
    if (n >= 0 && n < WF_PATH_MAX) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
}

static const struct wf_figure tree_figure = { "tree", "tree", 0 };

/* The bytes of a finished picture; one that is cut short is refused. */
static enum wf_status take(const char *picture, struct wf_arena *a, struct wf_bytes *out, struct wf_err *e)
{
    enum wf_status s = wf_file_read(picture, a, out, e);
    if (s) return s;
    static const char png[] = "IEND";
    const char *tail = strstr(picture, ".png") ? png : strstr(picture, ".pdf") ? "%%EOF" : "</svg>";
    size_t n = strlen(tail), from = out->size > 64 ? out->size - 64 : 0;
    for (size_t i = from; i + n <= out->size; i++)
        if (!memcmp(out->data + i, tail, n)) return WF_OK;
    return wf_fail(e, WF_EOUTPUT, "%s: the picture is not complete (is the disk full?)", picture);
}

static enum wf_status put(const char *path, const struct wf_bytes *b, struct wf_err *e)
{
    struct wf_file f = { 0 };
    enum wf_status s = wf_file_begin(&f, path, e);
    if (s) return s;
    if (fwrite(b->data, 1, b->size, f.stream) != b->size)
        s = wf_fail(e, WF_EOUTPUT, "%s: cannot be written", path);
    else
        s = wf_file_commit(&f, e);
    wf_file_abandon(&f);
    return s;
}

static const char *ending(const char *path)
{
    static const char *const known[] = { ".svg", ".png", ".pdf" };
    size_t n = strlen(path);
    for (size_t k = 0; k < sizeof known / sizeof *known; k++)
        if (n > 4 && !strcmp(path + n - 4, known[k])) return known[k];
    return NULL;
}

/* Everything in a folder of its own that is removed afterwards. */
static enum wf_status draw_in(const struct wf_tree_picture *p, const char *folder, const char *path,
                              struct wf_arena *a, struct wf_err *e)
{
    char picture[WF_PATH_MAX], name[16], plots[WF_PATH_MAX];
    struct wf_bytes bytes;
    snprintf(name, sizeof name, "picture%s", ending(path));
    enum wf_status s = join(folder, "plots", plots, e);
    if (!s) s = wf_mkdirs(plots, e);
    if (!s) s = wf_tree_picture_write(p, folder, e);
    if (!s) s = join(folder, name, picture, e);
    if (!s) s = wf_figures_run(folder, &tree_figure, picture, "en", e);
    if (!s) s = take(picture, a, &bytes, e);
    if (!s) s = put(path, &bytes, e);
    (void)unlink(picture);
    wf_tree_picture_remove(folder);
    if (!join(folder, "plots", plots, NULL)) (void)rmdir(plots);
    return s;
}

enum wf_status wf_tree_picture_draw(const struct wf_tree_picture *p, const char *path, struct wf_err *e)
{
    const char *base = getenv("TMPDIR");
    char folder[WF_PATH_MAX];
    struct wf_arena a = { 0 };
    if (!ending(path)) return wf_fail(e, WF_EUSAGE, "%s: a picture ends in .svg, .png or .pdf", path);
    int n = snprintf(folder, sizeof folder, "%s/windfirm-XXXXXX", base && *base ? base : "/tmp");
    if (n < 0 || (size_t)n >= sizeof folder || !mkdtemp(folder))
        return wf_fail(e, WF_EOUTPUT, "%s: no temporary folder can be made there", base ? base : "/tmp");
    enum wf_status s = draw_in(p, folder, path, &a, e);
    (void)rmdir(folder);
    wf_arena_free(&a);
    return s;
}

static char *base64(const struct wf_bytes *b, struct wf_arena *a)
{
    static const char digit[] = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    static const char lead[] = "data:image/png;base64,";
    size_t n = 0;
    char *out = WF_TAKE(a, sizeof lead + (b->size + 2) / 3 * 4, char);
    if (!out) return NULL;
    memcpy(out, lead, sizeof lead - 1);
    n = sizeof lead - 1;
    for (size_t i = 0; i < b->size; i += 3) {
        uint32_t v = 0;
        for (size_t k = 0; k < 3; k++) v = v << 8 | (i + k < b->size ? (unsigned char)b->data[i + k] : 0);
        for (size_t k = 0; k < 4; k++) out[n++] = i + k <= b->size ? digit[v >> (18 - 6 * k) & 63] : '=';
    }
    return out;
}

/* Width and height of a PNG, big-endian behind its signature. */
static unsigned png_number(const struct wf_bytes *b, size_t at)
{
    unsigned v = 0;
    for (size_t k = 0; k < 4; k++) v = v << 8 | (unsigned char)b->data[at + k];
    return v;
}

/* An SVG that holds the points of a PNG. */
static enum wf_status wrap(const struct wf_bytes *png, xmlDoc **svg, struct wf_arena *a, struct wf_err *e)
{
    char size[64];
    char *data = base64(png, a);
    *svg = xmlNewDoc(BAD_CAST "1.0");
    xmlNode *root = *svg ? xmlNewDocNode(*svg, NULL, BAD_CAST "svg", NULL) : NULL;
    if (root) xmlDocSetRootElement(*svg, root);
    xmlNs *ns = root ? xmlNewNs(root, BAD_CAST "http://www.w3.org/2000/svg", NULL) : NULL;
    xmlNode *image = ns ? xmlNewChild(root, ns, BAD_CAST "image", NULL) : NULL;
    if (!data || !image) return wf_fail(e, WF_ENOMEM, "no memory for a picture");
    xmlSetNs(root, ns);
    snprintf(size, sizeof size, "0 0 %u %u", png_number(png, 16), png_number(png, 20));
    xmlNewProp(root, BAD_CAST "viewBox", BAD_CAST size);
    snprintf(size, sizeof size, "%u", png_number(png, 16));
    xmlNewProp(image, BAD_CAST "width", BAD_CAST size);
    snprintf(size, sizeof size, "%u", png_number(png, 20));
    xmlNewProp(image, BAD_CAST "height", BAD_CAST size);
    xmlNewProp(image, BAD_CAST "href", BAD_CAST data);
    return WF_OK;
}

static size_t segments(const char *folder, struct wf_arena *a)
{
    char path[WF_PATH_MAX];
    struct wf_bytes b;
    if (join(folder, "plots/tree.csv", path, NULL) || wf_file_read_text(path, a, &b, NULL)) return 0;
    const char *at = strstr(b.data, "\nSEGMENTS,0,");
    return at ? strtoul(at + strlen("\nSEGMENTS,0,"), NULL, 10) : 0;
}

enum wf_status wf_tree_picture_report(const char *folder, const char *language, xmlDoc **svg,
                                      struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_bytes png;
    char path[WF_PATH_MAX], part[WF_PATH_MAX];
    enum wf_status s;
    *svg = NULL;
    if (segments(folder, &a) <= WF_PICTURE_LINES_MAX) {
        wf_arena_free(&a);
        return wf_figures_draw(folder, &tree_figure, language, svg, e);
    }
    s = join(folder, "plots/tree.png", path, e);
    if (!s) s = join(folder, "plots/tree.part.png", part, e);
    if (!s) s = wf_figures_run(folder, &tree_figure, part, language, e);
    if (!s) s = take(part, &a, &png, e);
    if (!s) s = put(path, &png, e);
    (void)unlink(part);
    if (!s) s = wrap(&png, svg, &a, e);
    if (s && *svg) xmlFreeDoc(*svg), *svg = NULL;
    wf_arena_free(&a);
    return s;
}
