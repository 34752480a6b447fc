/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/qsm_write.h"
#include "base/file.h"
#include "base/num.h"
#include <math.h>
#include <stdio.h>
#include <string.h>

/* ---- Tables of cylinders ---- */

/* Radius of the cylinder that has the volume of row i. */
static double radius_of_volume(const struct wf_qsm *q, size_t i)
{
    double r0 = q->r0[i], r1 = q->r1[i];
    return r0 == r1 ? r0 : sqrt((r0 * r0 + r0 * r1 + r1 * r1) / 3);
}

static void axis_of_row(const struct wf_qsm *q, size_t i, double out[3])
{
    double d = wf_qsm_distance(q, i);
    out[0] = (q->x1[i] - q->x0[i]) / d, out[1] = (q->y1[i] - q->y0[i]) / d,
    out[2] = (q->z1[i] - q->z0[i]) / d;
}

static enum wf_status write_normalised(const struct wf_qsm *q, FILE *to, struct wf_err *e)
{
    (void)e;
    bool tapered = false;
    for (size_t i = 0; i < q->n; i++) tapered = tapered || q->r0[i] != q->r1[i];
    fprintf(to,
            "id,radius_m,length_m,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension,branch,"
            "branch_order,pos_in_branch,added%s\n",
            tapered ? ",radius0_m,radius1_m" : "");
    for (size_t i = 0; i < q->n; i++) {
        double a[3];
        axis_of_row(q, i, a);
        fprintf(to, "%zu,%.10g,%.10g,%.10g,%.10g,%.10g,%.12g,%.12g,%.12g,%d,%d,%d,%d,%d,%d", i + 1,
                radius_of_volume(q, i), q->length[i], q->x0[i], q->y0[i], q->z0[i], a[0], a[1], a[2],
                q->parent[i] + 1, q->next[i] + 1, q->branch[i], q->order[i], q->place[i], q->added[i]);
        if (tapered) fprintf(to, ",%.10g,%.10g", q->r0[i], q->r1[i]);
        fputc('\n', to);
    }
    return WF_OK;
}

static enum wf_status write_treeqsm(const struct wf_qsm *q, FILE *to, struct wf_err *e)
{
    (void)e;
    for (size_t i = 0; i < q->n; i++) {
        double a[3], r = radius_of_volume(q, i);
        axis_of_row(q, i, a);
        fprintf(to, "%.10g\t%.10g\t%.10g\t%.10g\t%.10g\t%.12g\t%.12g\t%.12g\t%d\t%d\t%d\t%d\t%d\t%d\t%.10g\n",
                r, q->length[i], q->x0[i], q->y0[i], q->z0[i], a[0], a[1], a[2], q->parent[i] + 1,
                q->next[i] + 1, q->branch[i], q->order[i], q->place[i], q->added[i], r);
    }
    return WF_OK;
}

static enum wf_status write_vtk(const struct wf_qsm *q, FILE *to, struct wf_err *e)
{
    (void)e;
    fprintf(to, "# vtk DataFile Version 3.0\ntree\nASCII\nDATASET POLYDATA\nPOINTS %zu double\n", 2 * q->n);
    for (size_t i = 0; i < q->n; i++)
        fprintf(to, "%.9g %.9g %.9g\n%.9g %.9g %.9g\n", q->x0[i], q->y0[i], q->z0[i], q->x1[i], q->y1[i],
                q->z1[i]);
    fprintf(to, "LINES %zu %zu\n", q->n, 3 * q->n);
    for (size_t i = 0; i < q->n; i++) fprintf(to, "2 %zu %zu\n", 2 * i, 2 * i + 1);
    fprintf(to, "POINT_DATA %zu\nSCALARS radius double 1\nLOOKUP_TABLE default\n", 2 * q->n);
    for (size_t i = 0; i < q->n; i++) fprintf(to, "%.9g\n%.9g\n", q->r0[i], q->r1[i]);
    fprintf(to, "CELL_DATA %zu\n", q->n);
    const struct {
        const char *name;
        const int32_t *value;
    } column[] = { { "level", q->order }, { "branch", q->branch } };
    for (size_t k = 0; k < 2; k++) {
        fprintf(to, "SCALARS %s int 1\nLOOKUP_TABLE default\n", column[k].name);
        for (size_t i = 0; i < q->n; i++) fprintf(to, "%d\n", column[k].value[i]);
    }
    fprintf(to, "SCALARS id long 1\nLOOKUP_TABLE default\n");
    for (size_t i = 0; i < q->n; i++) fprintf(to, "%lld\n", (long long)q->id[i]);
    return WF_OK;
}

/* ---- MTG ----
 *
 * Rows are entities N of plants P, one plant a stem. A row that continues its parent follows it ('<') in the
 * same column; others branch from it ('+') one column further right. Lengths are metres. XX, YY, ZZ and
 * radius are those that PlantScan3D writes; the others, which other programs pass over, say where a cylinder
 * starts that does not touch its parent. */

enum { MTG_DEEPEST = 250 }; /* columns; readers have a limit */

/* Columns of all rows, parents before children. Returned: the largest. */
static int32_t mtg_columns(const struct wf_qsm *q, int32_t *column)
{
    int32_t most = 0;
    for (size_t i = 0; i < q->n; i++) {
        int32_t p = q->parent[i];
        column[i] = p < 0 ? 0 : column[p] + (q->next[p] != (int32_t)i);
        if (column[i] > most) most = column[i];
    }
    return most;
}

static void write_mtg_head(FILE *to, int32_t columns)
{
    static const char *const features[] = {
        "XX",     "YY",     "ZZ",           "radius",       "StartX",
        "StartY", "StartZ", "BottomRadius", "StatedLength", "BranchOrder"
    };
    fprintf(to, "CODE:\tFORM-A\n\nCLASSES:\nSYMBOL\tSCALE\tDECOMPOSITION\tINDEXATION\tDEFINITION\n"
                "$\t0\tFREE\tFREE\tIMPLICIT\nP\t1\tCONNECTED\tFREE\tIMPLICIT\nN\t2\tNONE\tFREE\tEXPLICIT\n\n"
                "DESCRIPTION:\nLEFT\tRIGHT\tRELTYPE\tMAX\nN\tN\t<\t1\nN\tN\t+\t?\n\nFEATURES:\nNAME\tTYPE\n");
    for (size_t k = 0; k < WF_COUNT(features); k++)
        fprintf(to, "%s\t%s\n", features[k], k + 1 < WF_COUNT(features) ? "REAL" : "INT");
    fprintf(to, "\nMTG:\nENTITY-CODE");
    for (int32_t k = 0; k <= columns; k++) fputc('\t', to);
    for (size_t k = 0; k < WF_COUNT(features); k++)
        fprintf(to, "%s%c", features[k], k + 1 < WF_COUNT(features) ? '\t' : '\n');
}

/* A row and its features; `columns`: the largest. */
static void write_mtg_row(const struct wf_qsm *q, size_t i, int32_t column, int32_t columns, size_t plant,
                          FILE *to)
{
    int32_t p = q->parent[i];
    bool along = p >= 0 && q->next[p] == (int32_t)i;
    if (p < 0) fprintf(to, "/P%zu\n", plant);
    for (int32_t k = 0; k < column; k++) fputc('\t', to);
    fprintf(to, "%s%cN%zu", p < 0 || along ? "^" : "", p < 0 ? '/' : along ? '<' : '+', i + 1);
    for (int32_t k = column; k <= columns; k++) fputc('\t', to);
    fprintf(to, "%.14g\t%.14g\t%.14g\t%.14g\t%.14g\t%.14g\t%.14g\t%.14g\t%.14g\t%d\n", q->x1[i], q->y1[i],
            q->z1[i], q->r1[i], q->x0[i], q->y0[i], q->z0[i], q->r0[i], q->length[i], q->order[i]);
}

static enum wf_status write_mtg(const struct wf_qsm *q, FILE *to, struct wf_err *e)
{
    struct wf_arena a = { 0 };
    struct wf_children c;
    int32_t *column = WF_TAKE(&a, q->n, int32_t), *stack = WF_TAKE(&a, q->n, int32_t);
    enum wf_status s = column && stack ? wf_children_of(q->parent, q->n, &a, &c, e)
                                       : wf_fail(e, WF_ENOMEM, "not enough memory for %zu rows", q->n);
    int32_t most = s ? 0 : mtg_columns(q, column);
    if (most > MTG_DEEPEST)
        s = wf_fail(e, WF_EOUTPUT, "%s: branches fork %d times, an MTG takes %d", q->name, most, MTG_DEEPEST);
    size_t depth = 0, plants = 0;
    if (!s) {
        write_mtg_head(to, most);
        for (int32_t k = c.begin[q->n + 1]; k-- > c.begin[q->n];) stack[depth++] = c.child[k];
    }
    while (depth) { /* the laterals of a row before the row that continues it */
        int32_t i = stack[--depth];
        plants += q->parent[i] < 0 ? 1 : 0;
        write_mtg_row(q, (size_t)i, column[i], most, plants, to);
        if (q->next[i] >= 0) stack[depth++] = q->next[i];
        for (int32_t k = c.begin[i + 1]; k-- > c.begin[i];)
            if (c.child[k] != q->next[i]) stack[depth++] = c.child[k];
    }
    wf_arena_free(&a);
    return s;
}

/* ---- TreeQSM's structure as a MATLAB file of version 5 ----
 *
 * QSM.cylinder as TreeQSM 2.3 and 2.4 have it, without the fitting errors, and of QSM.branch order, parent
 * and length. Not written, because a table of cylinders does not have them: rundata, treedata, pmdistance,
 * triangulation. All numbers are of class double, in the byte order of this machine, which the header states.
 * Source of the layout: MATLAB MAT-File Format, The MathWorks, R2019b, chapter 1. */

enum { MI_INT8 = 1, MI_INT32 = 5, MI_UINT32 = 6, MI_DOUBLE = 9, MI_MATRIX = 14 };
enum { MX_STRUCT = 2, MX_DOUBLE = 6, MX_NAME = 32 };

/* A column of a structure: its numbers by row and place. */
struct mat_column {
    const char *name;
    size_t width;
    double (*number)(const struct wf_qsm *q, size_t i, size_t k);
};

static double of_radius(const struct wf_qsm *q, size_t i, size_t k)
{
    return (void)k, radius_of_volume(q, i);
}
static double of_length(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->length[i]; }
static double of_start(const struct wf_qsm *q, size_t i, size_t k)
{
    return k == 0 ? q->x0[i] : k == 1 ? q->y0[i] : q->z0[i];
}
static double of_axis(const struct wf_qsm *q, size_t i, size_t k)
{
    double axis[3];
    axis_of_row(q, i, axis);
    return axis[k];
}
static double of_parent(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->parent[i] + 1; }
static double of_extension(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->next[i] + 1; }
static double of_added(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->added[i]; }
static double of_branch(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->branch[i]; }
static double of_order(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->order[i]; }
static double of_place(const struct wf_qsm *q, size_t i, size_t k) { return (void)k, q->place[i]; }

static const struct mat_column cylinder_columns[] = {
    { "radius", 1, of_radius },     { "length", 1, of_length },          { "start", 3, of_start },
    { "axis", 3, of_axis },         { "parent", 1, of_parent },          { "extension", 1, of_extension },
    { "added", 1, of_added },       { "UnmodRadius", 1, of_radius },     { "branch", 1, of_branch },
    { "BranchOrder", 1, of_order }, { "PositionInBranch", 1, of_place },
};

/* Bytes of an array behind its tag; everything is a multiple of 8 there. */
static size_t mat_array_size(size_t numbers) { return 16 + 16 + 8 + 8 + 8 * numbers; }
static size_t mat_struct_head(size_t fields, size_t name)
{
    return 16 + 16 + 8 + name + 8 + 8 + MX_NAME * fields;
}

static void mat_put(FILE *to, uint32_t type, size_t size, const void *data)
{
    static const char zeros[8];
    const uint32_t tag[] = { type, (uint32_t)size };
    fwrite(tag, 4, 2, to);
    if (!data) return;
    fwrite(data, 1, size, to);
    fwrite(zeros, 1, (8 - size % 8) % 8, to);
}

static void mat_open(FILE *to, size_t size, uint32_t class, size_t rows, size_t columns, const char *name)
{
    const uint32_t flags[] = { class, 0 };
    const int32_t dims[] = { (int32_t)rows, (int32_t)columns };
    mat_put(to, MI_MATRIX, size, NULL);
    mat_put(to, MI_UINT32, sizeof flags, flags);
    mat_put(to, MI_INT32, sizeof dims, dims);
    mat_put(to, MI_INT8, strlen(name), name);
}

/* Names of fields, each in MX_NAME bytes. */
static void mat_fields(FILE *to, const char *const *name, size_t n)
{
    const int32_t small[] = { 4 << 16 | MI_INT32, MX_NAME }; /* a tag with its four bytes of data */
    fwrite(small, 4, 2, to);
    mat_put(to, MI_INT8, MX_NAME * n, NULL);
    for (size_t k = 0; k < n; k++) {
        char text[MX_NAME] = { 0 };
        (void)snprintf(text, sizeof text, "%s", name[k]);
        fwrite(text, 1, sizeof text, to);
    }
}

static void mat_numbers(FILE *to, const double *number, size_t rows, size_t columns)
{
    mat_open(to, mat_array_size(rows * columns), MX_DOUBLE, rows, columns, "");
    mat_put(to, MI_DOUBLE, 8 * rows * columns, number);
}

static size_t cylinder_size(const struct wf_qsm *q)
{
    size_t size = mat_struct_head(WF_COUNT(cylinder_columns), 0);
    for (size_t k = 0; k < WF_COUNT(cylinder_columns); k++)
        size += 8 + mat_array_size(q->n * cylinder_columns[k].width);
    return size;
}

static void write_cylinder(const struct wf_qsm *q, double *room, FILE *to)
{
    const char *name[WF_COUNT(cylinder_columns)];
    for (size_t k = 0; k < WF_COUNT(cylinder_columns); k++) name[k] = cylinder_columns[k].name;
    mat_open(to, cylinder_size(q), MX_STRUCT, 1, 1, "");
    mat_fields(to, name, WF_COUNT(name));
    for (size_t k = 0; k < WF_COUNT(cylinder_columns); k++) {
        const struct mat_column *c = &cylinder_columns[k];
        for (size_t w = 0; w < c->width; w++)
            for (size_t i = 0; i < q->n; i++) room[w * q->n + i] = c->number(q, i, w);
        mat_numbers(to, room, q->n, c->width);
    }
}

enum { BRANCH_FIELDS = 3 };

static size_t branch_size(size_t branches)
{
    return mat_struct_head(BRANCH_FIELDS, 0) + BRANCH_FIELDS * (8 + mat_array_size(branches));
}

/* Order, branch of the parent (0: none) and length of each branch; given: room for three columns. */
static void write_branch(const struct wf_qsm *q, size_t n, double *room, FILE *to)
{
    static const char *const name[BRANCH_FIELDS] = { "order", "parent", "length" };
    double *order = room, *parent = room + n, *length = room + 2 * n;
    memset(room, 0, BRANCH_FIELDS * n * sizeof *room);
    for (size_t i = 0; i < q->n; i++) {
        size_t b = (size_t)q->branch[i] - 1;
        if (q->place[i] == 1) {
            order[b] = q->order[i];
            parent[b] = q->parent[i] < 0 ? 0 : q->branch[q->parent[i]];
        }
        length[b] += q->length[i];
    }
    mat_open(to, branch_size(n), MX_STRUCT, 1, 1, "");
    mat_fields(to, name, BRANCH_FIELDS);
    for (size_t k = 0; k < BRANCH_FIELDS; k++) mat_numbers(to, room + k * n, n, 1);
}

static enum wf_status write_mat(const struct wf_qsm *q, FILE *to, struct wf_err *e)
{
    static const char *const name[] = { "cylinder", "branch" };
    const uint16_t version[] = { 0x0100, 'M' << 8 | 'I' };
    char head[124] = { 0 };
    size_t branches = 0;
    for (size_t i = 0; i < q->n; i++)
        if ((size_t)q->branch[i] > branches) branches = (size_t)q->branch[i];
    size_t size = mat_struct_head(2, 8) + 8 + cylinder_size(q) + 8 + branch_size(branches);
    if (size > INT32_MAX)
        return wf_fail(e, WF_EOUTPUT, "%s: %zu cylinders are more than a MATLAB file of version 5 holds",
                       q->name, q->n);
    struct wf_arena a = { 0 };
    double *room = WF_TAKE(&a, BRANCH_FIELDS * (q->n + branches), double);
    if (!room) return wf_fail(e, WF_ENOMEM, "not enough memory for %zu rows", q->n);
    memset(head, ' ', 116);
    memcpy(head, "MATLAB 5.0 MAT-file, written by windfirm", 40);
    fwrite(head, 1, sizeof head, to);
    fwrite(version, 2, 2, to);
    mat_open(to, size, MX_STRUCT, 1, 1, "QSM");
    mat_fields(to, name, WF_COUNT(name));
    write_cylinder(q, room, to);
    write_branch(q, branches, room, to);
    wf_arena_free(&a);
    return WF_OK;
}

/* ---- The forms ---- */

static const struct {
    const char *name;
    enum wf_status (*write)(const struct wf_qsm *q, FILE *to, struct wf_err *e);
} forms[] = {
    { "csv", write_normalised }, { "txt", write_treeqsm }, { "vtk", write_vtk },
    { "mtg", write_mtg },        { "mat", write_mat },
};

enum wf_status wf_qsm_write(const struct wf_qsm *q, const char *path, const char *form, struct wf_err *e)
{
    const char *dot = strrchr(path, '.'), *name = form ? form : dot ? dot + 1 : "";
    size_t k = 0;
    while (k < WF_COUNT(forms) && strcmp(name, forms[k].name) != 0) k++;
    if (k == WF_COUNT(forms))
        return wf_fail(
            e, WF_EUSAGE,
            "%s: the name must end in .csv (normalised), .txt (TreeQSM columns), .mtg, .mat (TreeQSM "
            "structure) or .vtk (ParaView)",
            path);
    struct wf_file file;
    enum wf_status s = wf_file_begin(&file, path, e);
    if (!s) s = forms[k].write(q, file.stream, e);
    if (s) wf_file_abandon(&file);
    return s ? s : wf_file_commit(&file, e);
}
