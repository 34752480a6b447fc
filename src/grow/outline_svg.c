/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/outline_svg.h"
#include "base/file.h"
#include "base/num.h"
#include "grow/silhouette.h"
#include <ctype.h>
#include <libxml/parser.h>
#include <math.h>
#include <stdarg.h>
#include <string.h>

/* ---- Path data ---- */

enum { MOST_NUMBERS = 7 };
static const struct command {
    char letter;
    int numbers;
} commands[] = { { 'M', 2 }, { 'L', 2 }, { 'H', 1 }, { 'V', 1 }, { 'C', 6 },
                 { 'S', 4 }, { 'Q', 4 }, { 'T', 2 }, { 'A', 7 }, { 'Z', 0 } };

struct pen {
    const char *data, *at; /* whole text, what is not read yet */
    double x, y;           /* where it is */
    double handle[2];      /* last control point of a curve, else where it is */
    char before;           /* letter of the last command, as a capital */
    bool started, closed;
    double tolerance; /* of flattening; INFINITY: a chord for a curve */
    double *px, *py;
    size_t n, most; /* points; more than `most` are counted, not kept */
    struct wf_err *e;
};

__attribute__((format(printf, 2, 3))) static bool wrong(struct pen *p, const char *fmt, ...)
{
    char text[200];
    va_list args;
    va_start(args, fmt);
    (void)vsnprintf(text, sizeof text, fmt, args);
    va_end(args);
    (void)wf_fail(p->e, WF_EINPUT, "character %zu of the path's data: %s", (size_t)(p->at - p->data) + 1,
                  text);
    return false;
}

static void put(struct pen *p, double x, double y)
{
    p->x = x, p->y = y;
    if (p->n && p->n <= p->most && p->px[p->n - 1] == x && p->py[p->n - 1] == y) return;
    if (p->n < p->most) p->px[p->n] = x, p->py[p->n] = y;
    p->n++;
}

/* Number of chords for a curve whose distance from n chords is `far`/n^2. */
static size_t chords(const struct pen *p, double far)
{
    double n = ceil(sqrt(far / p->tolerance));
    return n < 1 ? 1 : n < WF_OUTLINE_POINTS + 1 ? (size_t)n : WF_OUTLINE_POINTS + 1;
}

/* Cubic from where the pen is, by its control points and end. */
static void cubic(struct pen *p, const double c[6])
{
    const double x0 = p->x, y0 = p->y;
    double bend = fmax(hypot(x0 - 2 * c[0] + c[2], y0 - 2 * c[1] + c[3]),
                       hypot(c[0] - 2 * c[2] + c[4], c[1] - 2 * c[3] + c[5]));
    size_t n = chords(p, 0.75 * bend); /* 6 bend/8: largest second derivative over 8 */
    for (size_t i = 1; i <= n; i++) {
        double t = (double)i / (double)n, u = 1 - t;
        double a = u * u * u, b = 3 * u * u * t, d = 3 * u * t * t, g = t * t * t;
        if (i == n)
            put(p, c[4], c[5]);
        else
            put(p, a * x0 + b * c[0] + d * c[2] + g * c[4], a * y0 + b * c[1] + d * c[3] + g * c[5]);
    }
}

static void quadratic(struct pen *p, const double c[4])
{
    const double third = 2.0 / 3.0;
    cubic(p, (double[]){ p->x + third * (c[0] - p->x), p->y + third * (c[1] - p->y),
                         c[2] + third * (c[0] - c[2]), c[3] + third * (c[1] - c[3]), c[2], c[3] });
}

/* Elliptical arc: radii, turn of the ellipse [degrees], large arc, positive angles, end. Centre and angles:
 * SVG 1.1, F.6.5; radii that are too small are enlarged, F.6.6. */
static void arc(struct pen *p, const double v[7])
{
    const double x0 = p->x, y0 = p->y, x1 = v[5], y1 = v[6];
    double rx = fabs(v[0]), ry = fabs(v[1]), c = cos(v[2] * WF_PI / 180), s = sin(v[2] * WF_PI / 180);
    if (rx == 0 || ry == 0 || (x0 == x1 && y0 == y1)) {
        put(p, x1, y1);
        return;
    }
    double hx = 0.5 * (x0 - x1), hy = 0.5 * (y0 - y1), ux = (c * hx + s * hy) / rx,
           uy = (c * hy - s * hx) / ry;
    double size = ux * ux + uy * uy;
    if (size > 1) rx *= sqrt(size), ry *= sqrt(size), ux /= sqrt(size), uy /= sqrt(size), size = 1;
    double away = sqrt(fmax(0, 1 / size - 1)) * ((v[3] != 0) == (v[4] != 0) ? -1 : 1);
    double cx = away * uy, cy = -away * ux; /* on the unit circle, from the middle of the chord */
    double from = atan2(uy - cy, ux - cx), sweep = atan2(-uy - cy, -ux - cx) - from;
    if (v[4] != 0 && sweep < 0) sweep += WF_TURN;
    if (v[4] == 0 && sweep > 0) sweep -= WF_TURN;
    size_t n = chords(p, fmax(rx, ry) * sweep * sweep / 8);
    if (n < 2) n = 2; /* half a circle has no chord of its own */
    for (size_t i = 1; i < n; i++) {
        double t = from + sweep * (double)i / (double)n, ex = rx * (cos(t) + cx), ey = ry * (sin(t) + cy);
        put(p, 0.5 * (x0 + x1) + c * ex - s * ey, 0.5 * (y0 + y1) + s * ex + c * ey);
    }
    put(p, x1, y1);
}

/* Draw one command with its numbers, coordinates absolute. */
static bool draw(struct pen *p, char letter, const double v[MOST_NUMBERS])
{
    bool after_cubic = p->before == 'C' || p->before == 'S',
         after_quadratic = p->before == 'Q' || p->before == 'T';
    double mx = p->x, my = p->y; /* the last handle mirrored */
    if (letter == 'S' ? after_cubic : after_quadratic) mx += p->x - p->handle[0], my += p->y - p->handle[1];
    switch (letter) {
    case 'C':
        cubic(p, v), memcpy(p->handle, v + 2, sizeof p->handle);
        break;
    case 'S':
        cubic(p, (double[]){ mx, my, v[0], v[1], v[2], v[3] }), memcpy(p->handle, v, sizeof p->handle);
        break;
    case 'Q':
        quadratic(p, v), memcpy(p->handle, v, sizeof p->handle);
        break;
    case 'T':
        quadratic(p, (double[]){ mx, my, v[0], v[1] }), p->handle[0] = mx, p->handle[1] = my;
        break;
    case 'A':
        arc(p, v);
        break;
    case 'H':
        put(p, v[0], p->y);
        break;
    case 'V':
        put(p, p->x, v[0]);
        break;
    default:
        put(p, v[0], v[1]);
    }
    p->before = letter;
    return true;
}

static void skip(struct pen *p, const char *what)
{
    while (*p->at && strchr(what, *p->at)) p->at++;
}

/* Numbers of a command; those of a relative one are added to where the pen is. */
static bool numbers(struct pen *p, const struct command *c, bool relative, double v[MOST_NUMBERS])
{
    const double far = 1e9;
    const char *end = p->at + strlen(p->at);
    for (int i = 0; i < c->numbers; i++) {
        bool flag = c->letter == 'A' && (i == 3 || i == 4);
        skip(p, " \t\r\n,");
        const char *next = wf_number_read(p->at, flag && *p->at ? p->at + 1 : end, '.', &v[i]);
        if (!next) return wrong(p, "%c needs %d number%s", c->letter, c->numbers, c->numbers == 1 ? "" : "s");
        if (flag && v[i] != 0 && v[i] != 1) return wrong(p, "a flag of an arc is 0 or 1");
        if (!(fabs(v[i]) < far)) return wrong(p, "the number is too large");
        p->at = next;
        bool up = c->letter == 'V' || (c->letter == 'A' ? i == 6 : c->letter != 'H' && i % 2);
        if (relative && !(c->letter == 'A' && i < 5)) v[i] += up ? p->y : p->x;
    }
    return true;
}

static const struct command *command_of(char letter)
{
    for (size_t i = 0; i < WF_COUNT(commands); i++)
        if (commands[i].letter == toupper((unsigned char)letter)) return &commands[i];
    return NULL;
}

/* One command and its repetitions. */
static bool step(struct pen *p)
{
    const struct command *c = command_of(*p->at);
    double v[MOST_NUMBERS];
    bool relative = c && *p->at != c->letter;
    if (!c) return wrong(p, "one of the letters M L H V C S Q T A Z is expected");
    if (p->closed && c->letter != 'Z') return wrong(p, "the path goes on behind its end; one part is taken");
    if (!p->started && c->letter != 'M') return wrong(p, "a path begins with M");
    if (p->started && c->letter == 'M') return wrong(p, "the path has a second part; one is taken");
    p->started = true;
    p->at++;
    if (c->letter == 'Z') return p->closed = true;
    do {
        if (!numbers(p, c, relative, v) || !draw(p, c->letter, v)) return false;
        if (c->letter == 'M') c = command_of('L');
        skip(p, " \t\r\n,");
    } while (*p->at && strchr("+-.0123456789", *p->at));
    return true;
}

/* The points of a path's data; the first is not repeated at the end. */
static bool trace(struct pen *p)
{
    p->at = p->data, p->n = 0;
    p->x = p->y = 0, p->before = 0;
    p->started = p->closed = false;
    for (skip(p, " \t\r\n"); *p->at; skip(p, " \t\r\n"))
        if (!step(p)) return false;
    if (!p->n) return wrong(p, "the path is empty");
    if (p->n > p->most) return true;
    bool back = p->n > 1 && p->px[p->n - 1] == p->px[0] && p->py[p->n - 1] == p->py[0];
    if (!back && !p->closed) return wrong(p, "the path is not closed; it ends with Z");
    p->n -= back;
    return true;
}

static void extent(const double *v, size_t n, double *low, double *high)
{
    *low = INFINITY, *high = -INFINITY;
    for (size_t i = 0; i < n; i++) *low = fmin(*low, v[i]), *high = fmax(*high, v[i]);
}

/* Flatten a path: the size from its chords, then as fine as the points allow. */
static enum wf_status flatten(struct pen *p)
{
    const double finest = 1e-4, coarsest = 2e-3;
    double low[2], high[2];
    p->tolerance = INFINITY;
    if (!trace(p)) return WF_EINPUT;
    if (p->n <= p->most) {
        extent(p->px, p->n, &low[0], &high[0]), extent(p->py, p->n, &low[1], &high[1]);
        double size = fmax(high[0] - low[0], high[1] - low[1]);
        for (double t = finest; t <= coarsest; t *= 2) {
            p->tolerance = t * size;
            if (!(p->tolerance > 0)) return wf_fail(p->e, WF_EINPUT, "the path has no size");
            if (!trace(p)) return WF_EINPUT;
            if (p->n <= p->most) return WF_OK;
        }
    }
    return wf_fail(p->e, WF_EINPUT, "the path needs more than %zu points; simplify it", p->most);
}

/* ---- The file ---- */

static bool named(const xmlNode *node, const char *name)
{
    return node->type == XML_ELEMENT_NODE && !strcmp((const char *)node->name, name);
}

/* Is the node inside one that is not drawn as it stands? */
static bool hidden(const xmlNode *node)
{
    static const char *const stores[] = { "defs", "clipPath", "symbol", "marker", "pattern", "mask" };
    for (; node && node->type == XML_ELEMENT_NODE; node = node->parent)
        for (size_t i = 0; i < WF_COUNT(stores); i++)
            if (named(node, stores[i])) return true;
    return false;
}

/* The node behind this one in the order of the document. */
static xmlNode *following(xmlNode *node)
{
    if (node->type == XML_ELEMENT_NODE && node->children) return node->children;
    while (node && !node->next) node = node->parent;
    return node ? node->next : NULL;
}

static enum wf_status find_path(xmlNode *root, xmlNode **out, struct wf_err *e)
{
    xmlNode *only = NULL, *crown = NULL;
    size_t paths = 0;
    for (xmlNode *at = root; at; at = following(at)) {
        if (!named(at, "path") || hidden(at)) continue;
        only = at, paths++;
        xmlChar *id = xmlGetProp(at, BAD_CAST "id");
        if (id && !strcmp((const char *)id, "crown")) crown = at;
        xmlFree(id);
    }
    if (!paths)
        return wf_fail(e, WF_EINPUT,
                       "no path is drawn; other shapes must be turned into paths (in Inkscape: "
                       "Path, Object to Path)");
    if (paths > 1 && !crown)
        return wf_fail(e, WF_EINPUT, "%zu paths are drawn; leave one, or give one the id 'crown'", paths);
    *out = crown ? crown : only;
    return WF_OK;
}

/* Translations do not matter, because the heights of lowest and highest point are given. */
static enum wf_status check_transforms(xmlNode *node, struct wf_err *e)
{
    for (; node && node->type == XML_ELEMENT_NODE; node = node->parent) {
        xmlChar *value = xmlGetProp(node, BAD_CAST "transform");
        const char *text = (const char *)value, *open = value ? strchr(text, '(') : NULL;
        bool taken = !value || (!strncmp(text, "translate(", 10) && !strchr(open + 1, '('));
        xmlFree(value);
        if (!taken)
            return wf_fail(e, WF_EINPUT,
                           "line %ld: a transform other than one translate() is not taken; "
                           "apply it to the path",
                           xmlGetLineNo(node));
        value = xmlGetProp(node, BAD_CAST "preserveAspectRatio");
        bool distorted = value && strstr((const char *)value, "none");
        xmlFree(value);
        if (distorted)
            return wf_fail(e, WF_EINPUT, "line %ld: preserveAspectRatio=\"none\" distorts the drawing",
                           xmlGetLineNo(node));
    }
    return WF_OK;
}

/* Entities can make a small file huge or name other files: a document type may have no declarations. */
static bool declares(const char *text)
{
    const char *type = strstr(text, "<!DOCTYPE"), *end = type ? strchr(type, '>') : NULL;
    return strstr(text, "<!ENTITY") || (type && (!end || memchr(type, '[', (size_t)(end - type))));
}

static enum wf_status parse(const struct wf_bytes *text, xmlDoc **out, struct wf_err *e)
{
    enum { LARGEST = 4 * 1024 * 1024 };
    if (text->size > LARGEST) return wf_fail(e, WF_EINPUT, "the file is larger than 4 MiB");
    if (memchr(text->data, '\0', text->size) || declares(text->data))
        return wf_fail(e, WF_EINPUT, "a document type with declarations is not taken; save as plain SVG");
    xmlResetLastError();
    *out = xmlReadMemory(text->data, (int)text->size, "outline.svg", "UTF-8",
                         XML_PARSE_NONET | XML_PARSE_NOERROR | XML_PARSE_NOWARNING);
    const xmlError *why = xmlGetLastError();
    const char *words = why && why->message ? why->message : "it is no XML";
    if (!*out)
        return wf_fail(e, WF_EINPUT, "line %d: %.*s", why ? why->line : 0, (int)strcspn(words, "\n"), words);
    xmlNode *root = xmlDocGetRootElement(*out);
    return root && named(root, "svg") ? WF_OK : wf_fail(e, WF_EINPUT, "it is no SVG: no element 'svg'");
}

/* y of a drawing points downwards. */
static void scale(struct wf_silhouette *s, double base, double top)
{
    double low, high, left, right;
    extent(s->z, s->points, &low, &high), extent(s->x, s->points, &left, &right);
    for (size_t i = 0; i < s->points; i++) {
        double up = (high - s->z[i]) / (high - low);
        s->z[i] = base + up * (top - base);
        s->x[i] = (s->x[i] - 0.5 * (left + right)) * (top - base) / (high - low);
    }
}

static enum wf_status read_path(xmlDoc *document, double base, double top, struct wf_silhouette *s,
                                struct wf_err *e)
{
    xmlNode *node = NULL;
    double low, high;
    if (find_path(xmlDocGetRootElement(document), &node, e) || check_transforms(node, e)) return e->code;
    xmlChar *data = xmlGetProp(node, BAD_CAST "d");
    struct pen pen = {
        .data = data ? (const char *)data : "", .px = s->x, .py = s->z, .most = WF_OUTLINE_POINTS, .e = e
    };
    enum wf_status status = flatten(&pen);
    xmlFree(data);
    if (status) return status;
    s->points = pen.n;
    extent(s->z, s->points, &low, &high);
    if (!(high > low)) return wf_fail(e, WF_EINPUT, "the path has no height");
    scale(s, base, top);
    return wf_silhouette_check(&(struct wf_silhouette){ .points = s->points, .x = s->x, .z = s->z }, e);
}

enum wf_status wf_outline_svg_read(const char *path, double base, double top, struct wf_silhouette *s,
                                   struct wf_arena *a, struct wf_err *e)
{
    struct wf_err why = { WF_OK, "" };
    struct wf_bytes text;
    xmlDoc *document = NULL;
    s->points = 0;
    if (!(base >= 0 && top > base))
        return wf_fail(e, WF_EUSAGE,
                       "%s: an outline of an SVG needs the heights of its lowest and of its highest "
                       "point above the ground, --outline-base and --outline-top above it",
                       path);
    s->x = WF_TAKE(a, WF_OUTLINE_POINTS, double), s->z = WF_TAKE(a, WF_OUTLINE_POINTS, double);
    if (!s->x || !s->z) return wf_fail(e, WF_ENOMEM, "%s: no memory", path);
    if (wf_file_read(path, a, &text, e)) return e->code;
    enum wf_status status = parse(&text, &document, &why);
    if (!status) status = read_path(document, base, top, s, &why);
    xmlFreeDoc(document);
    if (!status) return WF_OK;
    s->points = 0;
    return wf_fail(e, status, "%s: %s", path, why.text);
}
