/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_mat.h"
#include "base/file.h"
#include "base/num.h"
#include <math.h>
#include <stdio.h>
#include <string.h>
#ifdef WF_MATIO
#include <dlfcn.h>
#include <matio.h>
#include <zlib.h>
#endif

#ifndef WF_MATIO

static enum wf_status read_mat(const struct wf_import_head *h, bool apart, const struct wf_import_options *o,
                               struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    (void)apart, (void)o, (void)a, (void)q, (void)d;
    return wf_fail(e, WF_EMISSING,
                   "%s is a MATLAB file; windfirm was built without libmatio (Debian: install libmatio-dev "
                   "and build again)",
                   h->path);
}
#else

/* libmatio is loaded when a MATLAB file is read: with the libraries that it needs in turn, half of all that a
 * program would load, it takes 6 ms. WF_MATIO: its name. */
static struct {
    __typeof__(Mat_Open) *open;
    __typeof__(Mat_Close) *close;
    __typeof__(Mat_VarReadNext) *next;
    __typeof__(Mat_VarFree) *free;
    __typeof__(Mat_VarGetCell) *cell;
    __typeof__(Mat_VarGetNumberOfFields) *fields;
    __typeof__(Mat_VarGetStructFieldnames) *names;
    __typeof__(Mat_VarGetStructFieldByIndex) *field;
} mat;

static enum wf_status load_matio(const char *path, struct wf_err *e)
{
    const struct {
        const char *name;
        void *function; /* a pointer to it */
    } all[] = { { "Mat_Open", &mat.open },
                { "Mat_Close", &mat.close },
                { "Mat_VarReadNext", &mat.next },
                { "Mat_VarFree", &mat.free },
                { "Mat_VarGetCell", &mat.cell },
                { "Mat_VarGetNumberOfFields", &mat.fields },
                { "Mat_VarGetStructFieldnames", &mat.names },
                { "Mat_VarGetStructFieldByIndex", &mat.field } };
    void *library = dlopen(WF_MATIO, RTLD_NOW | RTLD_LOCAL);
    bool whole = library;
    for (size_t k = 0; k < WF_COUNT(all) && whole; k++) {
        void *found = dlsym(library, all[k].name);
        memcpy(all[k].function, &found, sizeof found);
        whole = found;
    }
    if (whole) return WF_OK;
    return wf_fail(e, WF_EMISSING,
                   "%s is a MATLAB file; %s, which reads it, cannot be loaded (Debian: libmatio11)", path,
                   WF_MATIO);
}

/* ---- Check of a version 5 file, before libmatio sees it ----
 *
 * libmatio takes sizes, types and names of a damaged file as they are: it crashes where a field has no name,
 * and what it could not read or inflate stays uninitialised memory. So the whole file is walked first: every
 * element must lie within the one around it, every array must hold the numbers its dimensions promise, every
 * compressed element must inflate to its end and to the size stated within. Source of the layout: MATLAB
 * MAT-File Format, The MathWorks, R2019b, chapter 1. */

enum mat_kind { MAT_KIND_OTHER, MAT_KIND_5, MAT_KIND_73, MAT_KIND_CUT };
enum { MAT_HEAD = 128, MAT_TAG = 8, DEEPEST = 32, INFLATED_MAX = 1 << 30, NAMES_MAX = 1 << 16 };

/* A part of the file's bytes that is read from front to back. */
struct mat_view {
    const unsigned char *at, *end;
    bool small_end;
};
struct mat_element {
    uint32_t type;
    struct mat_view data;
};

static uint32_t mat_number(const unsigned char *at, bool small_end)
{
    uint32_t n = 0;
    for (int k = 0; k < 4; k++) n = n << 8 | at[small_end ? 3 - k : k];
    return n;
}

static size_t mat_left(const struct mat_view *v) { return (size_t)(v->end - v->at); }

/* The next element: a tag of type and size, or both and up to four bytes of data in one tag. Data end at a
 * multiple of 8 bytes, except that the last of a file may lack the filling. */
static bool mat_next(struct mat_view *v, struct mat_element *out)
{
    if (mat_left(v) < MAT_TAG) return false;
    uint32_t type = mat_number(v->at, v->small_end), size = type >> 16;
    const unsigned char *data = v->at + 4;
    v->at += MAT_TAG;
    if (size) {
        type &= 0xFFFF;
        if (size > 4) return false;
    } else {
        size = mat_number(data, v->small_end);
        data = v->at;
        if (size > mat_left(v)) return false;
        size_t filled = ((size_t)size + 7) / 8 * 8;
        v->at += filled < mat_left(v) ? filled : mat_left(v);
    }
    *out = (struct mat_element){ type, { data, data + size, v->small_end } };
    return true;
}

static bool mat_next_of(struct mat_view *v, uint32_t type, struct mat_element *out)
{
    return mat_next(v, out) && out->type == type;
}

/* Bytes of a number of a stored type; 0: not a type of numbers. */
static size_t mat_type_size(uint32_t type)
{
    static const unsigned char size[] = {
        [MAT_T_INT8] = 1,   [MAT_T_UINT8] = 1,  [MAT_T_INT16] = 2,  [MAT_T_UINT16] = 2, [MAT_T_INT32] = 4,
        [MAT_T_UINT32] = 4, [MAT_T_SINGLE] = 4, [MAT_T_DOUBLE] = 8, [MAT_T_INT64] = 8,  [MAT_T_UINT64] = 8
    };
    return type < sizeof size ? size[type] : 0;
}

/* Exactly n numbers. */
static bool mat_numbers(struct mat_view *v, size_t n)
{
    struct mat_element x;
    if (!mat_next(v, &x)) return false;
    size_t size = mat_type_size(x.type);
    return size && mat_left(&x.data) % size == 0 && mat_left(&x.data) / size == n;
}

/* Text is not used; its length only has to be possible. A UTF-8 character has up to four bytes. */
static bool mat_text(struct mat_view *v, size_t n)
{
    struct mat_element x;
    if (!mat_next(v, &x)) return false;
    size_t size = mat_left(&x.data);
    if (x.type == MAT_T_UTF8) return size <= 4 * n;
    size_t one = x.type == MAT_T_UTF16 ? 2 : x.type == MAT_T_UTF32 ? 4 : mat_type_size(x.type);
    return one && (size == n * one || (!n && !size));
}

static bool mat_sparse(struct mat_view *v, size_t columns, bool complex)
{
    struct mat_element row, column, value;
    if (!mat_next_of(v, MAT_T_INT32, &row) || !mat_next_of(v, MAT_T_INT32, &column)) return false;
    if (mat_left(&column.data) != 4 * (columns + 1)) return false;
    uint32_t used = mat_number(column.data.end - 4, v->small_end);
    for (int part = 0; part <= complex; part++) {
        if (!mat_next(v, &value) || !mat_type_size(value.type)) return false;
        if (mat_left(&value.data) / mat_type_size(value.type) < used) return false;
    }
    return mat_left(&row.data) / 4 >= used;
}

static bool mat_matrix(struct mat_view v, int depth);

static bool mat_members(struct mat_view *v, size_t n, int depth)
{
    struct mat_element x;
    if (n > mat_left(v) / MAT_TAG) return false;
    for (size_t i = 0; i < n; i++) {
        if (!mat_next_of(v, MAT_T_MATRIX, &x)) return false;
        if (mat_left(&x.data) && !mat_matrix(x.data, depth + 1)) return false; /* no data: an empty array */
    }
    return true;
}

/* Field names of equal size, each ended by a zero byte within it, and the fields of each of n structures. */
static bool mat_struct(struct mat_view *v, size_t n, bool object, int depth)
{
    struct mat_element x, width, names;
    if (object && !mat_next_of(v, MAT_T_INT8, &x)) return false; /* name of the class */
    if (!mat_next_of(v, MAT_T_INT32, &width) || mat_left(&width.data) != 4) return false;
    if (!mat_next_of(v, MAT_T_INT8, &names) || mat_left(&names.data) > NAMES_MAX) return false;
    size_t size = mat_number(width.data.at, v->small_end), all = mat_left(&names.data);
    if (!size || all % size) return false;
    for (const unsigned char *p = names.data.at; p < names.data.end; p += size)
        if (!*p || !memchr(p, '\0', size)) return false;
    size_t parts;
    return !__builtin_mul_overflow(n, all / size, &parts) && mat_members(v, parts, depth);
}

/* Number of elements of an array by its dimensions. */
static bool mat_count(const struct mat_view *dims, size_t *out)
{
    size_t rank = mat_left(dims) / 4;
    *out = 1;
    if (rank < 2 || rank > DEEPEST || mat_left(dims) % 4) return false;
    for (const unsigned char *p = dims->at; p < dims->end; p += 4) {
        uint32_t n = mat_number(p, dims->small_end);
        if (n > INT32_MAX || __builtin_mul_overflow(*out, (size_t)n, out)) return false;
    }
    return *out <= INFLATED_MAX;
}

/* Functions and objects of classes are not looked at, but libmatio takes memory for names of any length, and
 * for as many functions as the dimensions say. */
static bool mat_unknown(struct mat_view v, bool function)
{
    struct mat_element x;
    struct mat_view dims = v;
    size_t n = 0;
    if (function && mat_next_of(&dims, MAT_T_INT32, &x) &&
        !(mat_count(&x.data, &n) && n <= mat_left(&dims) / MAT_TAG))
        return false;
    while (v.at < v.end)
        if (!mat_next(&v, &x)) return false;
    return true;
}

/* An array: flags, dimensions, name, and what its class demands. */
static bool mat_matrix(struct mat_view v, int depth)
{
    struct mat_element flags, dims, name;
    size_t n;
    if (depth > DEEPEST || !mat_next_of(&v, MAT_T_UINT32, &flags) || mat_left(&flags.data) != 8) return false;
    uint32_t word = mat_number(flags.data.at, v.small_end), class = word & 0xFF;
    bool complex = word & 0x800, good;
    if (class == MAT_C_FUNCTION || class == MAT_C_OPAQUE) return mat_unknown(v, class == MAT_C_FUNCTION);
    if (!mat_next_of(&v, MAT_T_INT32, &dims) || !mat_count(&dims.data, &n)) return false;
    if (!mat_next_of(&v, MAT_T_INT8, &name) || mat_left(&name.data) > NAMES_MAX) return false;
    if (class >= MAT_C_DOUBLE && class <= MAT_C_UINT64)
        good = mat_numbers(&v, n) && (!complex || mat_numbers(&v, n));
    else if (class == MAT_C_CHAR)
        good = mat_text(&v, n);
    else if (class == MAT_C_SPARSE)
        good =
            mat_left(&dims.data) == 8 && mat_sparse(&v, mat_number(dims.data.at + 4, v.small_end), complex);
    else if (class == MAT_C_CELL)
        good = mat_members(&v, n, depth);
    else
        good = (class == MAT_C_STRUCT || class == MAT_C_OBJECT) &&
               mat_struct(&v, n, class == MAT_C_OBJECT, depth);
    return good && v.at == v.end;
}

/* Inflate a compressed element of the file, and check the array in it. Given: bytes that all elements may
 * still inflate to; they are counted down. Returned: NULL, or what is wrong. */
static const char *mat_inflate(struct mat_view in, size_t *room, struct wf_arena *a)
{
    z_stream z = { .next_in = (Bytef *)(uintptr_t)in.at, .avail_in = (uInt)mat_left(&in) };
    unsigned char tag[MAT_TAG], *data = NULL;
    const char *wrong = NULL;
    if (inflateInit(&z) != Z_OK) return "is compressed, and there is no memory to inflate it";
    z.next_out = tag, z.avail_out = sizeof tag;
    int state = inflate(&z, Z_SYNC_FLUSH);
    size_t size = z.avail_out ? 0 : mat_number(tag + 4, in.small_end);
    if ((state != Z_OK && state != Z_STREAM_END) || z.avail_out ||
        mat_number(tag, in.small_end) != MAT_T_MATRIX)
        wrong = "is compressed, and its data are damaged";
    else if (size > *room)
        wrong = "is compressed, and is more than 1 GiB (all variables together) when inflated";
    else if (!(data = WF_TAKE(a, size, unsigned char)))
        wrong = "is compressed, and there is no memory to inflate it";
    if (!wrong) {
        z.next_out = data, z.avail_out = (uInt)size;
        if (state == Z_OK) state = inflate(&z, Z_FINISH);
        *room -= size;
        if (state != Z_STREAM_END || z.avail_out) wrong = "is compressed, and its data are damaged";
    }
    (void)inflateEnd(&z);
    if (!wrong && !mat_matrix((struct mat_view){ data, data + size, in.small_end }, 0))
        wrong = "is not the array that it says it is";
    return wrong;
}

/* The variable at v, whose tag has been read. Returned: NULL, or what is wrong with it. */
static const char *variable_wrong(uint32_t type, struct mat_view v, size_t *room)
{
    if (type == MAT_T_MATRIX) return mat_matrix(v, 0) ? NULL : "is not the array that it says it is";
    if (type != MAT_T_COMPRESSED) return "is not an array";
    struct wf_arena scratch = { 0 };
    const char *wrong = mat_inflate(v, room, &scratch);
    wf_arena_free(&scratch);
    return wrong;
}

/* Check a file of b; *variables: how many it holds. */
static enum wf_status check_variables(const char *path, const struct wf_bytes *b, size_t *variables,
                                      struct wf_err *e)
{
    const unsigned char *bytes = (const unsigned char *)b->data, *end = bytes + b->size;
    size_t room = INFLATED_MAX;
    bool cut = b->size < MAT_HEAD, small_end = !cut && bytes[MAT_HEAD - 2] == 'I';
    for (const unsigned char *at = bytes + MAT_HEAD; !cut && at < end;) {
        size_t left = (size_t)(end - at), size = left < MAT_TAG ? left : mat_number(at + 4, small_end);
        if ((cut = left < MAT_TAG || size > left - MAT_TAG)) break;
        uint32_t type = mat_number(at, small_end);
        at += MAT_TAG + size;
        const char *wrong = variable_wrong(type, (struct mat_view){ at - size, at, small_end }, &room);
        *variables += 1;
        if (wrong)
            return wf_fail(e, WF_EINPUT, "%s: the MATLAB file is damaged: its variable %zu %s", path,
                           *variables, wrong);
    }
    return cut ? wf_fail(e, WF_EINPUT, "%s: the MATLAB file is cut off", path) : WF_OK;
}

static enum wf_status check_mat5(const char *path, size_t *variables, struct wf_err *e)
{
    struct wf_arena file = { 0 };
    struct wf_bytes b;
    enum wf_status status = wf_file_read(path, &file, &b, e);
    if (!status) status = check_variables(path, &b, variables, e);
    wf_arena_free(&file);
    return status;
}

/* The version as libmatio tells it: by a number in the header, not by the text before it. */
static enum mat_kind kind_of(const char *path)
{
    unsigned char head[MAT_HEAD];
    FILE *f = fopen(path, "rb");
    size_t got = f ? fread(head, 1, sizeof head, f) : 0;
    if (f) (void)fclose(f);
    if (got < sizeof head) return got >= 7 && !memcmp(head, "MATLAB ", 7) ? MAT_KIND_CUT : MAT_KIND_OTHER;
    bool small_end = head[126] == 'I' && head[127] == 'M';
    if (!small_end && !(head[126] == 'M' && head[127] == 'I')) return MAT_KIND_OTHER;
    int version = head[small_end ? 125 : 124] << 8 | head[small_end ? 124 : 125];
    return version == 0x0100 ? MAT_KIND_5 : version == 0x0200 ? MAT_KIND_73 : MAT_KIND_OTHER;
}

/* ---- The cylinders among the variables ---- */

/* Where a field of the cylinders is found: a column of a MATLAB array. */
struct mat_source {
    const matvar_t *var;
    size_t column;
};
struct mat_sources {
    struct mat_source of[WF_FIELD_COUNT];
    size_t n;          /* cylinders                                       */
    size_t model;      /* of several, from 0                              */
    bool uneven;       /* arrays of different height                      */
    const char *field; /* the first part that cannot be used; NULL: none  */
    const char *wrong; /* what is wrong with it                           */
};

/* Names in TreeQSM's cylinder structure, in the separate variables of its early versions, and the column
 * (from 1) of the CylData matrix. */
static const struct {
    const char *name, *early;
    size_t matrix, width;
    enum wf_field field;
    bool needed;
} mat_parts[] = {
    { "radius", "Rad", 1, 1, WF_FIELD_RADIUS, true },    { "length", "Len", 2, 1, WF_FIELD_LENGTH, true },
    { "start", "Sta", 3, 3, WF_FIELD_X0, true },         { "axis", "Axe", 6, 3, WF_FIELD_AX, true },
    { "parent", "CPar", 9, 1, WF_FIELD_PARENT, true },   { "extension", "CExt", 10, 1, WF_FIELD_NEXT, false },
    { "BranchOrder", "", 12, 1, WF_FIELD_ORDER, false }, { "added", "Added", 14, 1, WF_FIELD_ADDED, false },
};
enum { PARTS = WF_COUNT(mat_parts), PART_RADIUS = 0, PART_START = 2, MATRIX = 14, VARIABLES = 64 };

static size_t class_size(enum matio_classes c)
{
    static const unsigned char size[] = {
        [MAT_C_DOUBLE] = 8, [MAT_C_SINGLE] = 4, [MAT_C_INT8] = 1,   [MAT_C_UINT8] = 1, [MAT_C_INT16] = 2,
        [MAT_C_UINT16] = 2, [MAT_C_INT32] = 4,  [MAT_C_UINT32] = 4, [MAT_C_INT64] = 8, [MAT_C_UINT64] = 8
    };
    return (size_t)c < sizeof size ? size[c] : 0;
}

/* Number of elements; 0 also for dimensions whose product is no number. */
static size_t element_count(const matvar_t *v)
{
    size_t n = v->rank > 0 && v->dims ? 1 : 0;
    for (int k = 0; n && k < v->rank; k++)
        if (__builtin_mul_overflow(n, v->dims[k], &n)) return 0;
    return n;
}

/* What is wrong with a table of real numbers; NULL: all of them are there. */
static const char *table_wrong(const matvar_t *v)
{
    size_t size = class_size(v->class_type), bytes;
    if (!size || v->isComplex || v->rank != 2 || !v->dims) return "is not a table of real numbers";
    if (__builtin_mul_overflow(v->dims[0], v->dims[1], &bytes) || __builtin_mul_overflow(bytes, size, &bytes))
        return "has impossible dimensions";
    if (bytes && (!v->data || v->data_size < 0 || (size_t)v->data_size != size || v->nbytes < bytes))
        return "has no data or not all of them";
    return NULL;
}

/* Field of a structure, the `at`-th of several, by name; NULL: none. libmatio may give a field no name. */
static matvar_t *field_named(matvar_t *v, const char *name, size_t at)
{
    char *const *names = mat.names(v);
    size_t fields = mat.fields(v);
    if (!names || !v->data || at >= element_count(v)) return NULL;
    if (fields && v->nbytes / sizeof(matvar_t *) / fields <= at) return NULL;
    for (size_t k = 0; k < fields; k++)
        if (names[k] && !strcmp(names[k], name)) return mat.field(v, k, at);
    return NULL;
}

static double array_element(const matvar_t *v, size_t i)
{
    switch (v->class_type) {
    case MAT_C_DOUBLE:
        return ((const double *)v->data)[i];
    case MAT_C_SINGLE:
        return (double)((const float *)v->data)[i];
    case MAT_C_INT8:
        return ((const int8_t *)v->data)[i];
    case MAT_C_UINT8:
        return ((const uint8_t *)v->data)[i];
    case MAT_C_INT16:
        return ((const int16_t *)v->data)[i];
    case MAT_C_UINT16:
        return ((const uint16_t *)v->data)[i];
    case MAT_C_INT32:
        return ((const int32_t *)v->data)[i];
    case MAT_C_UINT32:
        return ((const uint32_t *)v->data)[i];
    case MAT_C_INT64:
        return (double)((const int64_t *)v->data)[i];
    case MAT_C_UINT64:
        return (double)((const uint64_t *)v->data)[i];
    default:
        return (double)NAN;
    }
}

/* Use an array for a part: it must be all there and have the right width; a vector may be a row or a column.
 * A part that is not needed may be missing or empty. */
static void take_array(struct mat_sources *s, size_t part, const matvar_t *v)
{
    const char *wrong = v ? table_wrong(v) : "is missing";
    size_t height = wrong ? 0 : v->dims[0], width = wrong ? 0 : v->dims[1];
    if (!mat_parts[part].needed && (!v || (!wrong && (!height || !width)))) return;
    if (mat_parts[part].width == 1 && height == 1) height = width, width = 1;
    if (!wrong && width < mat_parts[part].width) wrong = "has too few columns";
    if (wrong) {
        if (!s->wrong) s->wrong = wrong, s->field = mat_parts[part].name;
        return;
    }
    if (s->n && s->n != height) s->uneven = true;
    s->n = height;
    for (size_t k = 0; k < mat_parts[part].width; k++)
        s->of[mat_parts[part].field + k] = (struct mat_source){ v, k };
}

/* A structure with radius and start is a tree; whatever else is wrong with it is an error then. */
static bool sources_of_struct(struct mat_sources *s, matvar_t *v, size_t at)
{
    if (!field_named(v, mat_parts[PART_RADIUS].name, at) || !field_named(v, mat_parts[PART_START].name, at))
        return false;
    for (size_t p = 0; p < PARTS; p++) take_array(s, p, field_named(v, mat_parts[p].name, at));
    return true;
}

static bool sources_of_variable(struct mat_sources *s, matvar_t *v, int depth, size_t *models);

/* The cylinders in a cell array: several cells are several models, a single one is what is in it. */
static bool sources_of_cells(struct mat_sources *s, matvar_t *v, int depth, size_t *models)
{
    size_t cells = element_count(v), at = cells > 1 ? s->model : 0, inner = 0;
    if (depth >= DEEPEST || !cells || !v->data || v->nbytes / sizeof(matvar_t *) < cells) return false;
    matvar_t *cell = mat.cell(v, (int)(at < cells ? at : 0));
    if (cells > 1) s->model = 0;
    if (!cell || !sources_of_variable(s, cell, depth + 1, &inner)) return false;
    *models = cells > 1 ? cells : inner;
    if (at >= cells) s->model = at;
    return true;
}

/* The cylinders of a variable: a QSM structure (one of several models), its cylinder structure, or a matrix.
 * Of a model that is not there the first is taken; s->model stays, and the caller compares it with *models.
 */
static bool sources_of_variable(struct mat_sources *s, matvar_t *v, int depth, size_t *models)
{
    if (v->class_type == MAT_C_CELL) return sources_of_cells(s, v, depth, models);
    if (v->class_type == MAT_C_STRUCT) {
        size_t n = element_count(v), at = s->model < n ? s->model : 0;
        if (!n) return false;
        matvar_t *cylinder = field_named(v, "cylinder", at);
        if (cylinder && cylinder->class_type != MAT_C_STRUCT) cylinder = NULL;
        if (!sources_of_struct(s, cylinder ? cylinder : v, cylinder ? 0 : at)) return false;
        *models = n;
        return true;
    }
    if (table_wrong(v) || v->dims[1] != MATRIX) return false;
    *models = 1;
    s->n = v->dims[0];
    for (size_t p = 0; p < PARTS; p++)
        for (size_t k = 0; k < mat_parts[p].width; k++)
            s->of[mat_parts[p].field + k] = (struct mat_source){ v, mat_parts[p].matrix - 1 + k };
    return true;
}

/* The tree as separate variables, as early versions wrote it. */
static bool sources_of_early(struct mat_sources *s, matvar_t **var, size_t n)
{
    const matvar_t *part[PARTS] = { NULL };
    for (size_t k = 0; k < n; k++)
        for (size_t p = 0; p < PARTS; p++)
            if (var[k]->name && *var[k]->name && !strcmp(var[k]->name, mat_parts[p].early)) part[p] = var[k];
    if (!part[PART_RADIUS] || !part[PART_START]) return false;
    for (size_t p = 0; p < PARTS; p++) take_array(s, p, part[p]);
    return true;
}

static bool find_sources(struct mat_sources *s, matvar_t **var, size_t n, size_t *models)
{
    const size_t model = s->model;
    for (size_t k = 0; k < n; k++) {
        *s = (struct mat_sources){ .model = model };
        if (sources_of_variable(s, var[k], 0, models)) return true;
    }
    *s = (struct mat_sources){ .model = model };
    *models = 1;
    return sources_of_early(s, var, n);
}

static enum wf_status read_cylinders(const struct mat_sources *s, const struct wf_import_options *o,
                                     struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d,
                                     struct wf_err *e)
{
    double value[WF_FIELD_COUNT];
    size_t n = 0;
    enum wf_status status = wf_qsm_alloc(q, s->n, a, e);
    if (status) return status;
    for (size_t i = 0; i < s->n; i++) {
        for (int f = 0; f < WF_FIELD_COUNT; f++)
            value[f] = s->of[f].var ? array_element(s->of[f].var, s->of[f].column * s->n + i) : (double)NAN;
        value[WF_FIELD_ID] = (double)(i + 1);
        if (value[WF_FIELD_RADIUS] < 0)
            value[WF_FIELD_RADIUS] = (double)NAN; /* not measured: repaired later */
        const char *wrong = isnan(value[WF_FIELD_X0]) ? "no start point" : wf_field_cylinder(q, n, value);
        if (wrong)
            wf_import_bad_row(q, o->strict, i + 1, 0, wrong, d);
        else
            n++;
    }
    q->n = n;
    return WF_OK;
}

/* The tree among variables that were read, of a file with `expected` variables (0: not known). */
static enum wf_status read_variables(const char *path, matvar_t **var, size_t n, size_t expected,
                                     size_t model, const struct wf_import_options *o, struct wf_arena *a,
                                     struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    struct mat_sources s = { .model = model };
    size_t models = 1;
    if (n < expected && n < VARIABLES)
        return wf_fail(e, WF_EINPUT, "%s: the MATLAB file is damaged: its variable %zu of %zu cannot be read",
                       path, n + 1, expected);
    if (!find_sources(&s, var, n, &models))
        return wf_fail(
            e, WF_EINPUT,
            "%s: no tree in %zu variables: neither a structure with radius, length, start, axis and parent "
            "nor a matrix of 14 columns",
            path, n);
    if (s.wrong) return wf_fail(e, WF_EINPUT, "%s: %s of the cylinders %s", path, s.field, s.wrong);
    if (s.uneven)
        return wf_fail(e, WF_EINPUT, "%s: the arrays of the cylinders have different lengths", path);
    if (s.n > WF_MAT_CYLINDERS_MAX)
        return wf_fail(e, WF_EINPUT, "%s: %zu cylinders; at most %d are read from a MATLAB file", path, s.n,
                       WF_MAT_CYLINDERS_MAX);
    if (model >= models)
        return wf_fail(e, WF_EINPUT, "%s: --scan-model %zu: the file has %zu model%s", path, model + 1,
                       models, models == 1 ? "" : "s");
    q->models = models;
    if (!o->scan_model) wf_qsm_count(q, WF_NOTE_MODELS, models - 1, -1);
    q->format = "MATLAB file";
    return read_cylinders(&s, o, a, q, d, e);
}

/* The number of the model, from 0. */
static bool model_number(const char *text, size_t *out)
{
    size_t n = 0;
    for (const char *p = text ? text : "1"; *p; p++) {
        if (*p < '0' || *p > '9' || n > 1000000) return false;
        n = 10 * n + (size_t)(*p - '0');
    }
    *out = n - 1;
    return n > 0;
}

/* Given: whether this process does nothing else, so that libhdf5 may crash in it. */
static enum wf_status read_mat(const struct wf_import_head *h, bool apart, const struct wf_import_options *o,
                               struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    matvar_t *var[VARIABLES];
    size_t n = 0, expected = 0, model;
    enum mat_kind kind = kind_of(h->path);
    if (!model_number(o->scan_model, &model))
        return wf_fail(e, WF_EINPUT, "%s: --scan-model '%.40s': not the number of a model, from 1", h->path,
                       o->scan_model);
    if (kind == MAT_KIND_CUT) return wf_fail(e, WF_EINPUT, "%s: the MATLAB file is cut off", h->path);
    if (kind == MAT_KIND_OTHER)
        return wf_fail(e, WF_EINPUT, "%s: not a MATLAB file of version 5 or 7.3", h->path);
    if (kind == MAT_KIND_73 && !apart)
        return wf_fail(e, WF_EINPUT,
                       "%s: a MATLAB file of version 7.3 (HDF5) is read by the program only, in a process of "
                       "its own; 'windfirm import FILE.mat -o FILE.csv' writes the tree as CSV",
                       h->path);
    enum wf_status status = kind == MAT_KIND_5 ? check_mat5(h->path, &expected, e) : WF_OK;
    if (status) return status;
    if ((status = load_matio(h->path, e))) return status;
    mat_t *file = mat.open(h->path, MAT_ACC_RDONLY);
    if (!file) return wf_fail(e, WF_EINPUT, "%s: not a MATLAB file that libmatio can read", h->path);
    while (n < VARIABLES && (var[n] = mat.next(file))) n++;
    status = read_variables(h->path, var, n, expected, model, o, a, q, d, e);
    for (size_t k = 0; k < n; k++) mat.free(var[k]);
    (void)mat.close(file);
    return status;
}

#endif

enum wf_status wf_import_mat(const struct wf_import_head *h, const struct wf_import_options *o,
                             struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    return read_mat(h, false, o, a, q, d, e);
}

enum wf_status wf_import_mat_apart(const struct wf_import_head *h, const struct wf_import_options *o,
                                   struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    return read_mat(h, true, o, a, q, d, e);
}
