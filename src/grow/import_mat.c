/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_mat.h"
#include "base/file.h"
#include "base/num.h"
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>
#ifdef WF_MATIO
#include <matio.h>
#endif

#ifndef WF_MATIO

enum wf_status wf_import_mat(const struct wf_import_head *h, const struct wf_import_options *o,
                             struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    (void)o, (void)a, (void)q, (void)d;
    return wf_fail(e, WF_EMISSING,
                   "%s is a MATLAB file; windfirm was built without libmatio (Debian: install libmatio-dev "
                   "and build again)",
                   h->path);
}
#else

/* Where a field of the cylinders is found: a column of a MATLAB array. */
struct mat_source {
    const matvar_t *var;
    size_t column;
};
struct mat_sources {
    struct mat_source of[WF_FIELD_COUNT];
    size_t n;    /* cylinders                  */
    bool uneven; /* arrays of different height */
};

/* Names in TreeQSM's cylinder structure, in the separate variables of its early versions, and the column
 * (from 1) of the CylData matrix. */
static const struct {
    const char *name, *early;
    size_t matrix, width;
    enum wf_field field;
} mat_parts[] = {
    { "radius", "Rad", 1, 1, WF_FIELD_RADIUS },   { "length", "Len", 2, 1, WF_FIELD_LENGTH },
    { "start", "Sta", 3, 3, WF_FIELD_X0 },        { "axis", "Axe", 6, 3, WF_FIELD_AX },
    { "parent", "CPar", 9, 1, WF_FIELD_PARENT },  { "extension", "CExt", 10, 1, WF_FIELD_NEXT },
    { "BranchOrder", "", 12, 1, WF_FIELD_ORDER }, { "added", "Added", 14, 1, WF_FIELD_ADDED },
};
enum { PARTS = WF_COUNT(mat_parts), MATRIX = 14, VARIABLES = 64 };

static bool is_numeric(const matvar_t *v)
{
    return v && v->rank == 2 && v->data && !v->isComplex &&
           ((v->class_type >= MAT_C_DOUBLE && v->class_type <= MAT_C_UINT64) || v->isLogical);
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

/* Use an array for a part, if it is numeric and has the right width; a vector may be a row or a column. */
static void take_array(struct mat_sources *s, size_t part, const matvar_t *v)
{
    if (!is_numeric(v)) return;
    size_t height = v->dims[0], width = v->dims[1];
    if (mat_parts[part].width == 1 && height == 1) height = width, width = 1;
    if (width < mat_parts[part].width || v->nbytes < height * width * (size_t)v->data_size) return;
    if (s->n && s->n != height) s->uneven = true;
    s->n = height;
    for (size_t k = 0; k < mat_parts[part].width; k++)
        s->of[mat_parts[part].field + k] = (struct mat_source){ v, k };
}

static bool sources_of_struct(struct mat_sources *s, matvar_t *v)
{
    for (size_t p = 0; p < PARTS; p++) take_array(s, p, Mat_VarGetStructFieldByName(v, mat_parts[p].name, 0));
    return s->of[WF_FIELD_RADIUS].var && s->of[WF_FIELD_X0].var;
}

/* The cylinders of a variable: a QSM structure (the first model of several), its cylinder structure, or a
 * matrix. */
static bool sources_of_variable(struct mat_sources *s, matvar_t *v, size_t *models)
{
    if (v->class_type == MAT_C_CELL && v->data && v->nbytes) {
        matvar_t *first = Mat_VarGetCell(v, 0);
        return first && sources_of_variable(s, first, models);
    }
    if (v->class_type == MAT_C_STRUCT && v->data) {
        size_t count = 1;
        for (int k = 0; k < v->rank; k++) count *= v->dims[k];
        if (!count) return false;
        matvar_t *cylinder = Mat_VarGetStructFieldByName(v, "cylinder", 0);
        if (cylinder && cylinder->class_type != MAT_C_STRUCT) cylinder = NULL;
        if (!sources_of_struct(s, cylinder ? cylinder : v)) return false;
        *models = count;
        return true;
    }
    if (!is_numeric(v) || v->dims[1] != MATRIX) return false;
    if (v->nbytes < v->dims[0] * MATRIX * (size_t)v->data_size) return false;
    s->n = v->dims[0];
    for (size_t p = 0; p < PARTS; p++)
        for (size_t k = 0; k < mat_parts[p].width; k++)
            s->of[mat_parts[p].field + k] = (struct mat_source){ v, mat_parts[p].matrix - 1 + k };
    return true;
}

static bool find_sources(struct mat_sources *s, matvar_t **var, size_t n, size_t *models)
{
    for (size_t k = 0; k < n; k++) {
        *s = (struct mat_sources){ 0 };
        if (sources_of_variable(s, var[k], models)) return true;
    }
    *s = (struct mat_sources){ 0 };
    for (size_t k = 0; k < n; k++)
        for (size_t p = 0; p < PARTS; p++)
            if (var[k]->name && !strcmp(var[k]->name, mat_parts[p].early)) take_array(s, p, var[k]);
    *models = 1;
    return s->of[WF_FIELD_RADIUS].var && s->of[WF_FIELD_X0].var;
}

/* Whether a version 5 file is complete. It is a sequence of elements, each preceded by its size; this is
 * checked because libmatio fills a truncated element with zeros without an error. */
static bool is_complete_mat(const char *path)
{
    unsigned char head[128], tag[8];
    FILE *f = fopen(path, "rb");
    if (!f) return false;
    bool whole = fread(head, 1, sizeof head, f) == sizeof head && fseek(f, 0, SEEK_END) == 0;
    long size = ftell(f), at = (long)sizeof head;
    bool small_end = whole && head[126] == 'I';
    if (whole && strncmp((const char *)head, "MATLAB 5.0", 10)) at = size; /* HDF5 checks itself */
    while (whole && at < size) {
        whole = fseek(f, at, SEEK_SET) == 0 && fread(tag, 1, sizeof tag, f) == sizeof tag;
        uint32_t n = 0;
        for (int k = 0; k < 4; k++) n = n << 8 | tag[small_end ? 7 - k : 4 + k];
        at += (long)sizeof tag + (long)n;
        whole = whole && at <= size;
    }
    (void)fclose(f);
    return whole;
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
        const char *wrong = isnan(value[WF_FIELD_X0]) ? "no start point" : wf_field_cylinder(q, n, value);
        if (wrong)
            wf_import_bad_row(q, o->strict, i + 1, 0, wrong, d);
        else
            n++;
    }
    q->n = n;
    return WF_OK;
}

/* A file on a disk for libmatio, which does not read pipes. Returned: the file's name, or the name of a copy
 * that is to be removed. */
static enum wf_status put_on_disk(const struct wf_import_head *h, struct wf_arena *a, const char **path,
                                  struct wf_err *e)
{
    const char *folder = getenv("TMPDIR");
    char *copy = wf_arena_print(a, "%s/windfirm-XXXXXX", folder && *folder ? folder : "/tmp");
    struct wf_bytes b;
    *path = h->path;
    if (!h->piped) return WF_OK;
    if (!copy) return wf_fail(e, WF_ENOMEM, "%s: no memory", h->path);
    enum wf_status s = wf_file_read(h->path, a, &b, e);
    if (s) return s;
    int fd = mkstemp(copy);
    if (fd < 0)
        return wf_fail(e, WF_EOUTPUT, "%s: no file can be made in the folder for temporary files", copy);
    *path = copy;
    size_t done = 0;
    for (ssize_t n = 1; done < b.size && n > 0; done += n > 0 ? (size_t)n : 0)
        n = write(fd, b.data + done, b.size - done);
    bool whole = close(fd) == 0 && done == b.size;
    if (whole) return WF_OK;
    (void)unlink(copy);
    return wf_fail(e, WF_EOUTPUT, "%s: cannot be written", copy);
}

static enum wf_status read_on_disk(const struct wf_import_head *h, const char *path,
                                   const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                   struct wf_diag *d, struct wf_err *e);

enum wf_status wf_import_mat(const struct wf_import_head *h, const struct wf_import_options *o,
                             struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d, struct wf_err *e)
{
    const char *path;
    enum wf_status s = put_on_disk(h, a, &path, e);
    if (s) return s;
    s = read_on_disk(h, path, o, a, q, d, e);
    if (h->piped) (void)unlink(path);
    return s;
}

static enum wf_status read_on_disk(const struct wf_import_head *h, const char *path,
                                   const struct wf_import_options *o, struct wf_arena *a, struct wf_qsm *q,
                                   struct wf_diag *d, struct wf_err *e)
{
    matvar_t *var[VARIABLES];
    struct mat_sources s = { 0 };
    size_t n = 0, models = 1;
    if (!is_complete_mat(path)) return wf_fail(e, WF_EINPUT, "%s: the MATLAB file is cut off", h->path);
    mat_t *mat = Mat_Open(path, MAT_ACC_RDONLY);
    if (!mat) return wf_fail(e, WF_EINPUT, "%s: not a MATLAB file that libmatio can read", h->path);
    while (n < VARIABLES && (var[n] = Mat_VarReadNext(mat))) n++;
    enum wf_status status;
    if (!find_sources(&s, var, n, &models))
        status = wf_fail(
            e, WF_EINPUT,
            "%s: no tree in %zu variables: neither a structure with radius, length, start, axis and parent "
            "nor a matrix of 14 columns",
            h->path, n);
    else if (s.uneven)
        status = wf_fail(e, WF_EINPUT, "%s: the arrays of the cylinders have different lengths", h->path);
    else
        status = read_cylinders(&s, o, a, q, d, e);
    q->format = "MATLAB file";
    wf_qsm_count(q, WF_NOTE_MODELS, models - 1, -1);
    for (size_t k = 0; k < n; k++) Mat_VarFree(var[k]);
    (void)Mat_Close(mat);
    return status;
}

#endif
