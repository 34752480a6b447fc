/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "base/rows.h"
#include "base/text.h"
#include <errno.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

/* ---- Bytes of a row ---- */

/* Read on until a line more is held. Returned: false at the end of the file. */
static bool hold_line(struct wf_rows *r)
{
    int c = EOF;
    size_t before = r->held_size;
    while (r->held_size + 1 < r->room && (c = fgetc(r->stream)) != EOF) {
        r->held[r->held_size++] = (char)c;
        if (c == '\n') break;
    }
    r->held[r->held_size] = '\0';
    return r->held_size > before;
}

/* Is a quote open at the end of the text? A quote opens at the start of a cell alone. */
static bool is_open(const struct wf_rows *r, const char *text, size_t size)
{
    bool inside = false, start = true;
    for (size_t i = 0; i < size; i++) {
        if (inside) {
            if (text[i] != '"') continue;
            if (i + 1 < size && text[i + 1] == '"')
                i++;
            else
                inside = start = false;
        } else if (text[i] == '"' && start) {
            inside = true;
        } else {
            start = text[i] == r->separator || text[i] == '\n' || (start && text[i] == ' ');
        }
    }
    return inside;
}

/* Bytes of the first line held, its end included. */
static size_t first_line(const struct wf_rows *r)
{
    const char *end = memchr(r->held, '\n', r->held_size);
    return end ? (size_t)(end - r->held) + 1 : r->held_size;
}

/* Move the first bytes held to the current row. */
static void take(struct wf_rows *r, size_t size)
{
    memcpy(r->raw, r->held, size);
    memmove(r->held, r->held + size, r->held_size - size);
    r->held_size -= size;
    r->line = r->next_line;
    for (size_t i = 0; i < size; i++) {
        r->next_line += r->raw[i] == '\n';
        if (r->raw[i]) continue;
        r->raw[i] = '?'; /* the text ends at its size */
        r->wrong = "it holds zero bytes, which are shown as '?'";
    }
    while (size && (r->raw[size - 1] == '\n' || r->raw[size - 1] == '\r')) size--;
    r->raw[size] = '\0';
    r->size = size;
}

/* The bytes of the next row. Returned: false at the end of the file. */
static bool read_raw(struct wf_rows *r)
{
    size_t lines = 1;
    r->wrong = NULL;
    if (!r->held_size && !hold_line(r)) return false;
    size_t size = first_line(r);
    while (is_open(r, r->held, size) && r->held[0] != '#') {
        bool more = size < r->held_size || hold_line(r);
        if (!more || ++lines > WF_ROW_LINES || r->held_size + 1 >= r->room) {
            r->wrong = "a quote is opened and not closed";
            size = first_line(r);
            break;
        }
        const char *end = memchr(r->held + size, '\n', r->held_size - size);
        size = end ? (size_t)(end - r->held) + 1 : r->held_size;
    }
    if (!r->wrong && size + 1 >= r->room) r->wrong = "the row is longer than 1 MB";
    take(r, size);
    return true;
}

/* ---- Cells ---- */

static char *trim(char *from, char *to)
{
    while (to > from && (to[-1] == ' ' || to[-1] == '\t')) to--;
    *to = '\0';
    while (*from == ' ' || *from == '\t') from++;
    return from;
}

/* One cell from `p` on. Returned: where the next begins; NULL: it was the last. */
static char *split_cell(struct wf_rows *r, char *p, char **cell)
{
    while (*p == ' ') p++;
    char *to = p, *from = p;
    bool quoted = *p == '"';
    if (quoted) {
        for (p++; *p && (*p != '"' || p[1] == '"'); p++) {
            p += *p == '"';
            *to++ = *p;
        }
        if (*p) p++;
        while (*p == ' ') p++;
        if (*p && *p != r->separator && !r->wrong) r->wrong = "text follows a closing quote";
    }
    for (; *p && *p != r->separator; p++) *to++ = *p;
    bool more = *p == r->separator;
    *cell = quoted ? from : trim(from, to);
    *to = '\0';
    return more ? p + 1 : NULL;
}

/* The row's text as UTF-8, in r->split. */
static void decode(struct wf_rows *r)
{
    struct wf_utf8_fault fault;
    if (wf_utf8_valid(r->raw, r->size, &fault)) {
        memcpy(r->split, r->raw, r->size + 1);
        return;
    }
    size_t n = wf_cp1252_to_utf8(r->raw, r->size, r->split);
    if (n == (size_t)-1) {
        n = 0;
        r->wrong = "its bytes are neither UTF-8 nor Windows-1252";
    }
    r->split[n] = '\0';
}

static void split(struct wf_rows *r)
{
    const char *p = r->raw + strspn(r->raw, r->separator == '\t' ? " " : " \t");
    r->cells = 0;
    r->blank = !*p || *p == '#';
    if (r->blank) return;
    decode(r);
    for (char *at = r->split; at;) {
        if (r->cells == WF_ROW_CELLS) {
            r->wrong = "it has more than 1024 cells";
            return;
        }
        at = split_cell(r, at, &r->cell[r->cells++]);
    }
}

bool wf_rows_next(struct wf_rows *r)
{
    if (!read_raw(r)) return false;
    split(r);
    return true;
}

/* ---- The header ---- */

static char find_separator(const char *header)
{
    size_t n[3] = { 0 };
    static const char sign[] = "\t;,";
    bool inside = false;
    for (const char *p = header; *p; p++) {
        inside ^= *p == '"';
        const char *at = inside ? NULL : strchr(sign, *p);
        if (at) n[at - sign]++;
    }
    if (n[0] && n[0] >= n[1] && n[0] >= n[2]) return '\t';
    return n[1] && n[1] >= n[2] ? ';' : ',';
}

static enum wf_status keep_names(struct wf_rows *r, struct wf_err *e)
{
    r->columns = r->cells;
    r->name = calloc(r->columns + 1, sizeof *r->name);
    if (!r->name) return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its header", r->file);
    for (size_t i = 0; i < r->columns; i++) {
        for (size_t j = 0; j < i; j++)
            if (*r->cell[i] && !strcasecmp(r->cell[i], r->name[j]))
                return wf_fail(e, WF_EINPUT, "%s:%zu: error: column '%.100s' occurs twice", r->file, r->line,
                               r->cell[i]);
        if (!(r->name[i] = strdup(r->cell[i])))
            return wf_fail(e, WF_ENOMEM, "%s: not enough memory for its header", r->file);
    }
    return WF_OK;
}

static enum wf_status read_header(struct wf_rows *r, void (*before)(void *context, const char *raw),
                                  void *context, struct wf_err *e)
{
    r->separator = ',';
    while (read_raw(r)) {
        char *text = r->raw;
        if (r->line == 1 && !strncmp(text, "\xEF\xBB\xBF", 3))
            r->size -= 3, memmove(text, text + 3, r->size + 1);
        if (r->line == 1 && wf_utf16_order(text, r->size) != WF_UTF16_NOT)
            return wf_fail(e, WF_EINPUT, "%s: is UTF-16; save it as CSV in UTF-8", r->file);
        r->separator = find_separator(text);
        split(r);
        before(context, r->raw);
        if (r->blank) continue;
        if (r->wrong) return wf_fail(e, WF_EINPUT, "%s:%zu: error: %s", r->file, r->line, r->wrong);
        return keep_names(r, e);
    }
    return wf_fail(e, WF_EINPUT, "%s: has no header row", r->file);
}

enum wf_status wf_rows_open(struct wf_rows *r, const char *file,
                            void (*before)(void *context, const char *raw), void *context, struct wf_err *e)
{
    *r = (struct wf_rows){ .file = file, .room = WF_ROW_BYTES, .next_line = 1 };
    errno = 0;
    r->stream = fopen(file, "rb");
    if (!r->stream) return wf_fail(e, WF_EINPUT, "%s: %s", file, strerror(errno));
    r->raw = malloc(r->room);
    r->held = malloc(r->room);
    r->split = malloc(3 * r->room); /* Windows-1252 may take three bytes for one */
    r->cell = calloc(WF_ROW_CELLS, sizeof *r->cell);
    if (!r->raw || !r->held || !r->split || !r->cell)
        return wf_fail(e, WF_ENOMEM, "%s: not enough memory for a row", file);
    return read_header(r, before, context, e);
}

void wf_rows_close(struct wf_rows *r)
{
    if (r->stream) fclose(r->stream);
    for (size_t i = 0; r->name && i < r->columns; i++) free(r->name[i]);
    free(r->name);
    free(r->raw);
    free(r->held);
    free(r->split);
    free(r->cell);
    *r = (struct wf_rows){ .file = r->file };
}
