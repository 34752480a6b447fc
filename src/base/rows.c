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

/* Leave out the rest of a line that is too long. */
static void skip_line(struct wf_rows *r)
{
    int c;
    r->held_size = 0;
    while ((c = fgetc(r->stream)) != EOF && c != '\n')
        ;
    r->next_line++;
}

/* Does a quote close a cell, by the character behind it? */
static bool closes(const struct wf_rows *r, int behind)
{
    return behind == r->separator || behind == '\r' || behind == '\n' || behind == EOF;
}

/* Behind the bytes held a quote is open. Is the next one that which closes it? Then the cell is one, however
 * long, and the stream stands behind its line, whose number of line ends is in *lines; else the stream is
 * where it was. A file with many such rows is not read again and again. */
static bool skip_quoted(struct wf_rows *r, size_t *lines)
{
    enum { TRIES = 8 };
    long at = ftell(r->stream);
    int c;
    bool found;
    *lines = 0;
    if (at < 0 || r->scanned++ >= TRIES) return false;
    do {
        while ((c = fgetc(r->stream)) != EOF && c != '"') *lines += c == '\n';
        found = c == '"';
        c = found ? fgetc(r->stream) : EOF;
    } while (c == '"'); /* a doubled one is text */
    if (!found || !closes(r, c)) return fseek(r->stream, at, SEEK_SET), false;
    while (c != EOF && c != '\n') c = fgetc(r->stream);
    *lines += c == '\n';
    return true;
}

/* Of a row with an open quote that has `upto` bytes at the most that is held: keep its first line. Its other
 * lines are left out where the quote is closed behind them; else they are rows. Returned: bytes of that line.
 */
static size_t give_up(struct wf_rows *r, size_t upto)
{
    size_t lines = 0, size = first_line(r);
    bool closed = !is_open(r, r->held, upto);
    if (!closed) {
        closed = upto == r->held_size && skip_quoted(r, &lines);
        r->wrong = "a quote is opened and not closed";
    }
    if (!closed) return size;
    r->wrong = "a cell in quotes is longer than 1 MB or 100 lines; its first line alone is kept";
    for (size_t k = size; k < upto; k++) lines += r->held[k] == '\n';
    memmove(r->held + size, r->held + upto, r->held_size - upto);
    r->held_size -= upto - size;
    r->skipped = lines;
    return size;
}

/* The bytes of the next row. Returned: false at the end of the file. */
static bool read_raw(struct wf_rows *r)
{
    size_t lines = 1;
    r->wrong = NULL, r->skipped = 0;
    if (!r->held_size && !hold_line(r)) return false;
    size_t size = first_line(r);
    while (is_open(r, r->held, size) && r->held[0] != '#') {
        bool more = size < r->held_size || hold_line(r);
        const char *end = memchr(r->held + size, '\n', r->held_size - size);
        size_t next = end ? (size_t)(end - r->held) + 1 : r->held_size;
        if (!more || ++lines > WF_ROW_LINES || r->held_size + 1 >= r->room) {
            size = give_up(r, next);
            break;
        }
        size = next;
    }
    bool cut = size + 1 >= r->room && r->held[size - 1] != '\n' && !r->skipped;
    if (cut && !r->wrong) r->wrong = "the row is longer than 1 MB; its beginning alone is kept";
    take(r, size);
    r->next_line += r->skipped;
    if (cut) skip_line(r);
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
    r->cp1252 = r->cp1252 || n != (size_t)-1;
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
    char separator = '\0'; /* of a line "sep=;", as spreadsheets write it */
    r->separator = ',';
    while (read_raw(r)) {
        char *text = r->raw;
        if (r->line == 1 && !strncmp(text, "\xEF\xBB\xBF", 3))
            r->size -= 3, memmove(text, text + 3, r->size + 1), r->marked = true;
        bool said = r->line == 1 && r->size == 5 && !strncasecmp(text, "sep=", 4) && strchr(",;\t", text[4]);
        if (r->line == 1 && (!strncmp(text, "PK\003\004", 4) || !strncmp(text, "\xD0\xCF\x11\xE0", 4)))
            return wf_fail(e, WF_EINPUT, "%s: is a workbook; save its sheet as CSV in UTF-8", r->file);
        const char *alone = strchr(text, '\r');
        if (alone && alone[1] != '\n')
            return wf_fail(e, WF_EINPUT,
                           "%s:%zu: error: lines end in CR alone; save the table as CSV in UTF-8", r->file,
                           r->line);
        r->separator = said ? text[4] : separator ? separator : find_separator(text);
        if (said) separator = text[4];
        split(r);
        before(context, r->raw);
        if (r->blank || said) continue;
        if (r->wrong) return wf_fail(e, WF_EINPUT, "%s:%zu: error: %s", r->file, r->line, r->wrong);
        return keep_names(r, e);
    }
    return wf_fail(e, WF_EINPUT, "%s: has no header row", r->file);
}

/* ---- UTF-16 ---- */

static enum wf_status copy_utf16(FILE *from, FILE *to, enum wf_utf16 order)
{
    enum { PIECE = 1 << 16 };
    static const enum wf_status bad = WF_EINPUT;
    char *piece = malloc(PIECE + 2), *text = malloc(2 * PIECE);
    size_t kept = 0, got;
    enum wf_status s = piece && text ? WF_OK : WF_ENOMEM;
    while (!s && (got = fread(piece + kept, 1, PIECE - kept, from)) > 0) {
        size_t n = kept + got, used = n & ~(size_t)1;
        if (used >= 2 && used == PIECE) {
            unsigned char high = (unsigned char)piece[used - (order == WF_UTF16_LITTLE ? 1 : 2)];
            if (high >= 0xD8 && high < 0xDC) used -= 2; /* half of a pair: with the next piece */
        }
        size_t size = wf_utf16_to_utf8(piece, used, order, text);
        if (size == (size_t)-1)
            s = bad;
        else if (fwrite(text, 1, size, to) != size)
            s = WF_EOUTPUT;
        memmove(piece, piece + used, n - used), kept = n - used;
    }
    free(piece), free(text);
    return s ? s : kept ? bad : WF_OK;
}

/* A table in UTF-16, as spreadsheets write "Unicode text": read from a copy in UTF-8. */
static enum wf_status take_utf16(struct wf_rows *r, struct wf_err *e)
{
    char start[4];
    size_t n = fread(start, 1, sizeof start, r->stream);
    enum wf_utf16 order = wf_utf16_order(start, n);
    if (fseek(r->stream, 0, SEEK_SET))
        return wf_fail(e, WF_EINPUT, "%s: %s; a file is needed", r->file, strerror(errno));
    if (order == WF_UTF16_NOT) return WF_OK;
    FILE *copy = tmpfile();
    if (!copy) return wf_fail(e, WF_EINPUT, "%s: is UTF-16; save it as CSV in UTF-8", r->file);
    enum wf_status s = copy_utf16(r->stream, copy, order);
    fclose(r->stream);
    r->stream = copy, r->utf16 = r->marked = true;
    if (!s && fseek(copy, 0, SEEK_SET)) s = WF_EOUTPUT;
    if (s == WF_EOUTPUT)
        return wf_fail(e, s, "%s: no room for a copy in UTF-8: %s", r->file, strerror(errno));
    return s ? wf_fail(e, s, "%s: is UTF-16 with bytes that are none; save it as CSV in UTF-8", r->file)
             : WF_OK;
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
    enum wf_status s = take_utf16(r, e);
    return s ? s : read_header(r, before, context, e);
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
