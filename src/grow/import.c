/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import.h"
#include "base/file.h"
#include "base/num.h"
#include "base/text.h"
#include "grow/import_mat.h"
#include "grow/import_mtg.h"
#include "grow/import_nodes.h"
#include "grow/import_text.h"
#include "grow/qsm_model.h"
#include "grow/qsm_repair.h"
#include <errno.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

const struct wf_import_format wf_import_formats[] = {
    { "normalised", "normalised CSV", "radius, length, start, axis, parent" },
    { "plain", "plain CSV of segments", "parent, x0, y0, z0, x1, y1, z1, radius0, radius1" },
    { "simpleforest", "SimpleForest CSV", "ID, parentID, start, end, radius" },
    { "archi", "aRchi CSV", "cyl_ID, parent_ID, start, end, radius_cyl" },
    { "rtwig", "rTwig CSV", "parent, start, axis or end, radius, length" },
    { "cylinders", "CSV of cylinders", "parent, radius, start, and end or axis and length" },
    { "hand", "hand-measured table", "parent, length, diameter; angle or zenith, azimuth, distance" },
    { "treeqsm", "TreeQSM text", "14, 15 or 17 columns of numbers" },
    { "mat", "MATLAB file", "a QSM or cylinder structure or a matrix of 14 columns" },
    { "mtg", "OpenAlea MTG", "features XX, YY, ZZ and a diameter or radius" },
    { "nodes", "nodes with their parents",
      "x, y, z, radius, parent; or a line a tree; or SWC; or treegraph JSON" },
    { NULL, NULL, NULL },
};

struct wf_import_options wf_import_default(void)
{
    return (struct wf_import_options){ .length_unit = (double)NAN, .diameter_unit = (double)NAN };
}

/* Choice of the reader by the file's content. */

enum { HEAD = 65536 };

/* The beginning of a pipe, which is read whole: it cannot be opened again. */
static enum wf_status read_piped(struct wf_import_head *h, struct wf_arena *a, struct wf_err *e)
{
    struct wf_bytes b;
    enum wf_status s = wf_file_read(h->path, a, &b, e);
    if (s) return s;
    h->size = b.size < HEAD ? b.size : HEAD;
    memcpy(h->text, b.data, h->size);
    h->ends_open = b.size && b.data[b.size - 1] != '\n';
    h->piped = true;
    return h->size ? WF_OK : wf_fail(e, WF_EINPUT, "%s: the file is empty", h->path);
}

static bool is_matlab(const struct wf_import_head *h)
{
    static const unsigned char hdf5[] = { 0x89, 'H', 'D', 'F' };
    return !strncmp(h->text, "MATLAB ", 7) || (h->size > 4 && !memcmp(h->text, hdf5, 4));
}

/* Read the beginning of a file as it is. */
static enum wf_status read_head(const char *path, struct wf_import_head *h, struct wf_arena *a,
                                struct wf_err *e)
{
    *h = (struct wf_import_head){ .path = path, .text = WF_TAKE(a, HEAD + 1, char) };
    if (!h->text) return wf_fail(e, WF_ENOMEM, "%s: not enough memory to read it", path);
    struct stat s;
    if (!stat(path, &s) && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode)) return read_piped(h, a, e);
    FILE *f = fopen(path, "rb");
    if (!f) return wf_fail(e, WF_EINPUT, "%s: %s", path, strerror(errno));
    h->size = fread(h->text, 1, HEAD, f);
    bool bad = ferror(f) != 0;
    int why = errno;
    (void)fclose(f);
    if (bad) return wf_fail(e, WF_EINPUT, "%s: %s", path, strerror(why));
    return h->size ? WF_OK : wf_fail(e, WF_EINPUT, "%s: the file is empty", path);
}

/* A copy of a pipe on a disk, which libmatio needs. Returned: its name, to be removed. */
static enum wf_status copy_piped(const char *pipe, struct wf_arena *a, char **copy, struct wf_err *e)
{
    const char *folder = getenv("TMPDIR");
    struct wf_bytes b;
    *copy = wf_arena_print(a, "%s/windfirm-XXXXXX", folder && *folder ? folder : "/tmp");
    if (!*copy) return wf_fail(e, WF_ENOMEM, "%s: not enough memory to read it", pipe);
    enum wf_status s = wf_file_read(pipe, a, &b, e);
    if (s) return s;
    int fd = mkstemp(*copy);
    if (fd < 0) return wf_fail(e, WF_EOUTPUT, "%s: cannot be made: %s", *copy, strerror(errno));
    size_t done = 0;
    for (ssize_t n = 1; done < b.size && n > 0; done += n > 0 ? (size_t)n : 0)
        n = write(fd, b.data + done, b.size - done);
    if (close(fd) == 0 && done == b.size) return WF_OK;
    (void)unlink(*copy);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written", *copy);
}

/* Call a reader of MATLAB files on a copy of a pipe. */
static enum wf_status read_copy(wf_import_reader *reader, const struct wf_import_head *h,
                                const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                struct wf_diag *d, struct wf_err *e)
{
    struct wf_import_head on_disk = *h;
    char *copy;
    enum wf_status s = copy_piped(h->path, a, &copy, e);
    if (s) return s;
    on_disk.path = copy;
    s = reader(&on_disk, o, a, q, d, e);
    (void)unlink(copy);
    return s;
}

/* The same as UTF-8 text, for a file that is not MATLAB's; ways of writing are noted. */
static enum wf_status head_as_text(struct wf_import_head *h, struct wf_arena *a, struct wf_qsm *q,
                                   struct wf_diag *d, struct wf_err *e)
{
    struct wf_bytes b;
    struct wf_err why = { 0 };
    bool mark = !strncmp(h->text, "\xEF\xBB\xBF", 3),
         utf16 = wf_utf16_order(h->text, h->size) != WF_UTF16_NOT;
    if (!utf16 && memchr(h->text, '\0', h->size))
        return wf_fail(e, WF_EINPUT, "%s: neither text nor a MATLAB file", h->path);
    if (wf_file_read_table(h->path, a, &b, d, &why)) return wf_fail(e, why.code, "%s", why.text);
    h->size = b.size < HEAD ? b.size : HEAD;
    memcpy(h->text, b.data, h->size);
    h->text[h->size] = '\0';
    h->ends_open = b.size && b.data[b.size - 1] != '\n';
    if (mark) wf_qsm_count(q, WF_NOTE_BOM, 1, -1);
    if (strstr(h->text, "\r\n")) wf_qsm_count(q, WF_NOTE_CRLF, 1, -1);
    return WF_OK;
}

static wf_import_reader *reader_for(const struct wf_import_head *h, const char *format)
{
    if (format) {
        if (!strcmp(format, "mat")) return wf_import_mat;
        if (!strcmp(format, "mtg")) return wf_import_mtg;
        if (!strcmp(format, "nodes")) return wf_import_nodes;
        return strcmp(format, "treeqsm") ? wf_import_table : wf_import_bare;
    }
    if (is_matlab(h)) return wf_import_mat;
    if (strstr(h->text, "ENTITY-CODE") || (strstr(h->text, "CODE:") && strstr(h->text, "FORM-")))
        return wf_import_mtg;
    if (wf_import_is_nodes(h)) return wf_import_nodes;
    return wf_import_is_bare(h) ? wf_import_bare : wf_import_table;
}

static enum wf_status known_format(const char *format, struct wf_err *e)
{
    const char *names[16];
    size_t n = 0;
    if (!format) return WF_OK;
    for (const struct wf_import_format *f = wf_import_formats; f->name; f++) {
        if (!strcmp(f->name, format)) return WF_OK;
        if (n < WF_COUNT(names)) names[n++] = f->name;
    }
    return wf_fail(e, WF_EUSAGE, "format '%s' is not known%s; see 'windfirm import --help'", format,
                   wf_did_you_mean(format, names, n).text);
}

static const char *file_name(const char *path)
{
    const char *slash = strrchr(path, '/');
    return slash ? slash + 1 : path;
}

/* Warn when the stem is thicker than a fifth of the tree's height: then a unit is probably wrong, or the tree
 * is a stump. */
static void suspect_units(const struct wf_qsm *q, struct wf_diag *d)
{
    double low = INFINITY, high = -INFINITY, thick = 0;
    for (size_t i = 0; i < q->n; i++) {
        low = fmin(low, fmin(q->z0[i], q->z1[i]));
        high = fmax(high, fmax(q->z0[i], q->z1[i]));
        thick = fmax(thick, 2 * fmax(q->r0[i], q->r1[i]));
    }
    if (thick > 0.2 * (high - low))
        wf_diag_warn(d, "thick-stem",
                     "%s: %.3g m thick and %.3g m high; check --diameter-unit and --length-unit", q->name,
                     thick, high - low);
}

/* Wood and bridges that no scan saw, as shares of the wood measured and lengths [m]: above the first a
 * warning, above the second an error. Good scans stay below 3 % and 0.25 m. */
static const double UNSEEN_WARN = 0.05, UNSEEN_MOST = 0.25, BRIDGE_WARN = 1, BRIDGE_MOST = 3;

/* How much of the tree would be made up when its rows are joined. Branches are held where they leave the
 * axis, whatever the joint of the analysis: the other way of joining moves wood, and says nothing of the
 * scan. */
static enum wf_status check_unseen(const struct wf_qsm *q, bool force, struct wf_diag *d, struct wf_err *e)
{
    struct wf_arena scratch = { 0 };
    struct wf_qsm_model m;
    struct wf_err none = { 0 };
    double measured = 0;
    for (size_t i = 0; i < q->n; i++) measured += wf_qsm_volume(q, i);
    enum wf_status s = wf_qsm_to_tree(q, WF_JOINT_AXIS, &scratch, &m, &none);
    double unseen = s ? 0 : fmax(m.bridge_volume, m.volume - measured), share = unseen / measured;
    double gap = s ? 0 : m.widest_gap;
    wf_arena_free(&scratch);
    if (s == WF_ENOMEM) return wf_fail(e, s, "%s", none.text);
    if (!(share > UNSEEN_WARN || gap > BRIDGE_WARN)) return WF_OK;
    char text[256], longest[96] = "";
    if (gap > 0)
        (void)snprintf(longest, sizeof longest, "; the widest gap is %.3g m, below id %lld", gap,
                       (long long)q->id[m.widest_row]);
    (void)snprintf(text, sizeof text, "%.3g m3 of wood was not scanned, %.3g %% of the wood measured%s",
                   unseen, 100 * share, longest);
    if (!force && (share > UNSEEN_MOST || gap > BRIDGE_MOST))
        return wf_fail(
            e, WF_EINPUT,
            "%s: error: %s; more than %g %% or %g m is not taken as one tree: rows are missing, or the "
            "file holds several trees; --force takes it",
            q->file, text, 100 * UNSEEN_MOST, BRIDGE_MOST);
    wf_diag_warn(d, "unseen-wood", "%s: %s", q->name, text);
    return WF_OK;
}

enum wf_status wf_import_read(const char *path, const struct wf_import_options *o, struct wf_arena *a,
                              struct wf_qsm *out, struct wf_diag *d, struct wf_err *e)
{
    struct wf_import_head h;
    *out = (struct wf_qsm){ .file = path, .name = file_name(path) };
    enum wf_status s = known_format(o->format, e);
    if (!s && o->scan_model && !strcmp(o->scan_model, "all"))
        s = wf_fail(e, WF_EUSAGE,
                    "--scan-model all: for 'tree info' and 'analyze'; here a model is named by its "
                    "number, from 1");
    if (!s) s = read_head(path, &h, a, e);
    if (s) return s;
    bool matlab = o->format ? !strcmp(o->format, "mat") : is_matlab(&h);
    if (!matlab && (s = head_as_text(&h, a, out, d, e))) return s;
    wf_import_reader *reader = reader_for(&h, o->format);
    bool copied = reader == wf_import_mat && h.piped;
    if (reader == wf_import_mat && o->mat) reader = o->mat;
    s = copied ? read_copy(reader, &h, o, a, out, d, e) : reader(&h, o, a, out, d, e);
    if (s) return s;
    if (o->tree_id && !out->trees)
        return wf_fail(e, WF_EINPUT, "%s: error: --tree-id: a file of this format holds one tree (%s)", path,
                       out->format);
    if (o->scan_model && !out->models)
        return wf_fail(
            e, WF_EINPUT,
            "%s: error: --scan-model: only a MATLAB file holds several models of a tree; this is: %s", path,
            out->format);
    size_t bad = out->repairs.count[WF_REPAIR_BAD_ROW] + out->repairs.count[WF_REPAIR_TRUNCATED];
    if (bad > out->n)
        return wf_fail(e, WF_EINPUT, "%s: %zu of %zu rows cannot be read", path, bad, bad + out->n);
    if ((s = wf_qsm_repair(out, o, a, d, e))) return s;
    if ((s = check_unseen(out, o->force, d, e))) return s;
    wf_qsm_report(out, d);
    suspect_units(out, d);
    return WF_OK;
}
