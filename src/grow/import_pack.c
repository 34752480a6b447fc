/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_pack.h"
#include "base/num.h"
#include "grow/import_mat.h"
#include <math.h>
#include <string.h>

enum { PACK_VERSION = 2, PACK_ROWS_LISTED = 100, PACK_TEXT_MAX = 1024 };
static const char pack_magic[8] = { 'W', 'F', 'T', 'R', 'E', 'E', '\r', '\n' };

/* Order: this head, message, format, repairs, unreadable rows, columns. */
struct pack_head {
    char magic[8];
    uint32_t version, status;
    uint64_t size; /* of everything, with this head */
    uint64_t n;    /* cylinders                     */
    uint64_t models;
    uint32_t message, format, listed, repairs;
};
/* An unreadable row; its text follows. */
struct pack_row {
    uint64_t line;
    uint64_t text;
};

/* The columns that a reader of cylinders fills in. */
#define COLUMN(name)                                                                                         \
    {                                                                                                        \
        offsetof(struct wf_qsm, name), sizeof *((struct wf_qsm *)0)->name                                    \
    }
static const struct {
    size_t offset, size;
} pack_columns[] = {
    COLUMN(id), COLUMN(parent_id), COLUMN(order), COLUMN(next_id), COLUMN(x0), COLUMN(y0),     COLUMN(z0),
    COLUMN(x1), COLUMN(y1),        COLUMN(z1),    COLUMN(r0),      COLUMN(r1), COLUMN(length), COLUMN(added),
};
#undef COLUMN

static void *pack_column(const struct wf_qsm *q, size_t c)
{
    void *p;
    memcpy(&p, (const char *)q + pack_columns[c].offset, sizeof p);
    return p;
}

static size_t pack_cylinder_size(void)
{
    size_t size = 0;
    for (size_t c = 0; c < WF_COUNT(pack_columns); c++) size += pack_columns[c].size;
    return size;
}

static bool pack_put(FILE *to, const void *bytes, size_t size)
{
    return !size || fwrite(bytes, 1, size, to) == size;
}

/* Unreadable rows; to == NULL only counts. Returned: bytes. */
static size_t pack_rows(const struct wf_diag *d, uint32_t *listed, FILE *to)
{
    size_t size = 0;
    *listed = 0;
    for (const struct wf_finding *f = d->first; f && *listed < PACK_ROWS_LISTED; f = f->next) {
        if (f->severity != WF_ERROR) continue;
        struct pack_row row = { f->line, strlen(f->text) };
        if (row.text > PACK_TEXT_MAX) row.text = PACK_TEXT_MAX;
        size += sizeof row + row.text;
        *listed += 1;
        if (to) (void)(pack_put(to, &row, sizeof row) && pack_put(to, f->text, row.text));
    }
    return size;
}

enum wf_status wf_import_pack(const struct wf_qsm *q, const struct wf_diag *d, const struct wf_err *e,
                              FILE *to)
{
    const char *format = q->format ? q->format : "";
    struct pack_head h = { .version = PACK_VERSION,
                           .status = (uint32_t)e->code,
                           .n = e->code ? 0 : q->n,
                           .models = q->models,
                           .message = (uint32_t)strlen(e->text),
                           .format = (uint32_t)strlen(format),
                           .repairs = WF_REPAIR_COUNT };
    memcpy(h.magic, pack_magic, sizeof h.magic);
    h.size = sizeof h + h.message + h.format + sizeof q->repairs + pack_rows(d, &h.listed, NULL) +
             h.n * pack_cylinder_size();
    bool good = pack_put(to, &h, sizeof h) && pack_put(to, e->text, h.message) &&
                pack_put(to, format, h.format) && pack_put(to, &q->repairs, sizeof q->repairs);
    (void)pack_rows(d, &h.listed, to);
    for (size_t c = 0; c < WF_COUNT(pack_columns); c++)
        good = good && pack_put(to, pack_column(q, c), h.n * pack_columns[c].size);
    return good && !ferror(to) ? WF_OK : wf_fail(NULL, WF_EINTERNAL, "a reader's answer was not accepted");
}

/* Receiving. */

struct unpack {
    const char *at;
    size_t left;
};

/* The next `size` bytes; NULL when there are fewer. */
static const char *unpack_take(struct unpack *u, uint64_t size)
{
    const char *p = u->at;
    if (size > u->left) return NULL;
    u->at += size, u->left -= size;
    return p;
}

static bool unpack_to(struct unpack *u, void *out, size_t size)
{
    const char *p = unpack_take(u, size);
    if (p && size) memcpy(out, p, size);
    return p != NULL;
}

/* Text as the terminal and the results may have it: what is not plain ASCII becomes '?'. */
static const char *unpack_text(const char *text, size_t size, struct wf_arena *a)
{
    char *out = WF_TAKE(a, size + 1, char);
    for (size_t k = 0; out && k < size; k++)
        out[k] = (char)(text[k] >= ' ' && text[k] <= '~' ? text[k] : '?');
    return out;
}

/* The reader's message, which begins with the path as long as it is whole. */
static void unpack_failure(const struct pack_head *h, const char *text, const char *path, struct wf_arena *a,
                           struct wf_err *e)
{
    size_t n = strlen(path), size = h->message;
    if (size > n + 2 && !strncmp(text, path, n) && text[n] == ':') text += n + 2, size -= n + 2;
    const char *words = unpack_text(text, size, a);
    enum wf_status s =
        h->status == WF_EMISSING || h->status == WF_ENOMEM ? (enum wf_status)h->status : WF_EINPUT;
    (void)wf_fail(e, s, "%s: %s", path, words && *words ? words : "the MATLAB file could not be read");
}

/* Counts of repairs, and the unreadable rows, reported as by a reader in this process. */
static bool unpack_rows(struct unpack *u, const struct pack_head *h, const struct wf_import_options *o,
                        struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d)
{
    struct wf_repairs r;
    if (!unpack_to(u, &r, sizeof r)) return false;
    for (size_t k = 0; k < WF_REPAIR_COUNT; k++)
        if (r.count[k] > INT32_MAX) return false;
    size_t bad = r.count[WF_REPAIR_BAD_ROW];
    if (h->listed > PACK_ROWS_LISTED || h->listed > bad || bad > WF_MAT_CYLINDERS_MAX) return false;
    r.count[WF_REPAIR_BAD_ROW] = 0;
    q->repairs = r;
    for (uint32_t k = 0; k < h->listed; k++) {
        struct pack_row row;
        const char *text = unpack_to(u, &row, sizeof row) && row.line && row.line <= WF_MAT_CYLINDERS_MAX &&
                                   row.text <= PACK_TEXT_MAX
                               ? unpack_take(u, row.text)
                               : NULL;
        const char *words = text ? unpack_text(text, row.text, a) : NULL;
        if (!words) return false;
        wf_import_bad_row(q, o->strict, row.line, 0, words, d);
    }
    if (bad > h->listed) wf_qsm_count(q, WF_REPAIR_BAD_ROW, bad - h->listed, r.first[WF_REPAIR_BAD_ROW]);
    return true;
}

static bool unpack_place(double v) { return fabs(v) <= 2e8; /* [m]; false for NAN */ }

/* Radius or length: not known, or one that wf_field_cylinder lets pass. */
static bool unpack_size(double v, double most) { return isnan(v) || (isfinite(v) && v <= most); }

static bool unpack_cylinder(const struct wf_qsm *q, size_t i)
{
    const int64_t most = INT64_C(9000000000000000);
    return q->id[i] >= 0 && q->id[i] <= most && q->parent_id[i] >= -1 && q->parent_id[i] <= most &&
           q->next_id[i] >= 0 && q->next_id[i] <= most && q->order[i] >= -1 && q->order[i] < 1000 &&
           q->added[i] <= 1 && unpack_place(q->x0[i]) && unpack_place(q->y0[i]) && unpack_place(q->z0[i]) &&
           unpack_place(q->x1[i]) && unpack_place(q->y1[i]) && unpack_place(q->z1[i]) &&
           unpack_size(q->r0[i], 10) && unpack_size(q->r1[i], 10) && unpack_size(q->length[i], 1000);
}

/* Everything behind the head. Returned: NULL, or what is wrong with the bytes. */
static const char *unpack_body(struct unpack *u, const struct pack_head *h, const char *path,
                               const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                               struct wf_diag *d, struct wf_err *e)
{
    const char *message = unpack_take(u, h->message), *format = message ? unpack_take(u, h->format) : NULL;
    if (!format) return "its texts are cut off";
    if (h->status) {
        unpack_failure(h, message, path, a, e);
        return NULL;
    }
    if (!(q->format = unpack_text(format, h->format, a))) return "there is no memory for it";
    if (!unpack_rows(u, h, o, a, q, d)) return "its findings are not possible";
    if (h->models < 1 || h->models > WF_MAT_CYLINDERS_MAX) return "its number of models is not possible";
    q->models = h->models;
    if (h->n > WF_MAT_CYLINDERS_MAX || u->left != h->n * pack_cylinder_size())
        return "its size does not fit its number of cylinders";
    if (wf_qsm_alloc(q, h->n, a, e)) return NULL;
    for (size_t c = 0; c < WF_COUNT(pack_columns); c++)
        (void)unpack_to(u, pack_column(q, c), h->n * pack_columns[c].size);
    for (size_t i = 0; i < q->n; i++)
        if (!unpack_cylinder(q, i)) return "a cylinder has impossible values";
    return NULL;
}

enum wf_status wf_import_unpack(const void *bytes, size_t size, const char *path,
                                const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                struct wf_diag *d, struct wf_err *e)
{
    struct unpack u = { bytes, size };
    struct pack_head h;
    struct wf_err own = { 0 };
    const char *wrong = NULL;
    if (!unpack_to(&u, &h, sizeof h) || memcmp(h.magic, pack_magic, sizeof h.magic) != 0 ||
        h.version != PACK_VERSION || h.repairs != WF_REPAIR_COUNT || h.status >= WF_STATUS_COUNT)
        wrong = "it is no answer of this version";
    else if (h.size != size || size > WF_PACK_MAX)
        wrong = "it is not complete";
    else if (h.message > PACK_TEXT_MAX || h.format > PACK_TEXT_MAX)
        wrong = "its texts are too long";
    else
        wrong = unpack_body(&u, &h, path, o, a, q, d, &own);
    if (wrong)
        return wf_fail(e, WF_EINPUT,
                       "%s: the MATLAB file could not be read: the reader's answer is damaged (%s)", path,
                       wrong);
    return own.code ? wf_fail(e, own.code, "%s", own.text) : WF_OK;
}
