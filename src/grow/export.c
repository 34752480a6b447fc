#include "grow/export.h"
#include "base/file.h"
#include <math.h>
#include <string.h>

/* Radius of the cylinder that holds as much wood as row i. */
static double radius(const struct wf_qsm *q, size_t i)
{
    double r0 = q->r0[i], r1 = q->r1[i];
    return r0 == r1 ? r0 : sqrt((r0 * r0 + r0 * r1 + r1 * r1) / 3);
}

static void axis(const struct wf_qsm *q, size_t i, double out[3])
{
    double d = wf_qsm_distance(q, i);
    out[0] = (q->x1[i] - q->x0[i]) / d, out[1] = (q->y1[i] - q->y0[i]) / d,
    out[2] = (q->z1[i] - q->z0[i]) / d;
}

static void normalised(const struct wf_qsm *q, FILE *to)
{
    bool tapered = false;
    for (size_t i = 0; i < q->n; i++) tapered = tapered || q->r0[i] != q->r1[i];
    fprintf(to,
            "id,radius_m,length_m,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension,branch,"
            "branch_order,pos_in_branch,added%s\n",
            tapered ? ",radius0_m,radius1_m" : "");
    for (size_t i = 0; i < q->n; i++) {
        double a[3];
        axis(q, i, a);
        fprintf(to, "%zu,%.10g,%.10g,%.10g,%.10g,%.10g,%.12g,%.12g,%.12g,%d,%d,%d,%d,%d,%d", i + 1,
                radius(q, i), q->length[i], q->x0[i], q->y0[i], q->z0[i], a[0], a[1], a[2], q->parent[i] + 1,
                q->next[i] + 1, q->branch[i], q->order[i], q->place[i], q->added[i]);
        if (tapered) fprintf(to, ",%.10g,%.10g", q->r0[i], q->r1[i]);
        fputc('\n', to);
    }
}

static void treeqsm(const struct wf_qsm *q, FILE *to)
{
    for (size_t i = 0; i < q->n; i++) {
        double a[3], r = radius(q, i);
        axis(q, i, a);
        fprintf(to, "%.10g\t%.10g\t%.10g\t%.10g\t%.10g\t%.12g\t%.12g\t%.12g\t%d\t%d\t%d\t%d\t%d\t%d\t%.10g\n",
                r, q->length[i], q->x0[i], q->y0[i], q->z0[i], a[0], a[1], a[2], q->parent[i] + 1,
                q->next[i] + 1, q->branch[i], q->order[i], q->place[i], q->added[i], r);
    }
}

static void vtk(const struct wf_qsm *q, FILE *to)
{
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
}

const struct wf_export_format wf_export_formats[] = {
    { ".csv", "normalised CSV", normalised },
    { ".txt", "TreeQSM columns", treeqsm },
    { ".vtk", "VTK PolyData", vtk },
    { NULL, NULL, NULL },
};

enum wf_status wf_qsm_write(const struct wf_qsm *q, const char *path, struct wf_err *e)
{
    const char *dot = strrchr(path, '.');
    const struct wf_export_format *f = wf_export_formats;
    while (f->ending && (!dot || strcmp(dot, f->ending))) f++;
    if (!f->ending)
        return wf_fail(e, WF_EUSAGE,
                       "%s: the name must end in .csv (normalised), .txt (TreeQSM) or .vtk (ParaView)", path);
    struct wf_file file;
    enum wf_status s = wf_file_begin(&file, path, e);
    if (s) return s;
    f->write(q, file.stream);
    return wf_file_commit(&file, e);
}
