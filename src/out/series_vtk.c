/* Frames as VTK poly data and their index in time (Kitware, VTK file formats). */
#include "base/file.h"
#include "out/series.h"
#include <math.h>
#include <string.h>

enum { FRAMES_MOST = 60 };

static void array(FILE *f, const char *name, const char *type, int parts)
{
    fprintf(f, "<DataArray type=\"%s\" Name=\"%s\" NumberOfComponents=\"%d\" format=\"ascii\">\n", type, name,
            parts);
}

static void frame(FILE *f, const struct wf_series *s, size_t k)
{
    const struct wf_tree *t = &s->an.tree;
    const double *p = s->place + k * 3 * t->n;
    fprintf(
        f,
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<PolyData><Piece NumberOfPoints=\"%zu\" NumberOfVerts=\"0\" NumberOfLines=\"%zu\" "
        "NumberOfStrips=\"0\" NumberOfPolys=\"0\">\n<PointData Scalars=\"radius\" "
        "Vectors=\"displacement\">\n",
        2 * t->n, t->n);
    array(f, "radius", "Float32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%.5g %.5g\n", t->r0[i], t->r1[i]);
    fputs("</DataArray>\n", f);
    array(f, "displacement", "Float32", 3);
    for (size_t i = 0; i < t->n; i++) {
        int32_t b = t->parent[i];
        double low[3] = { 0 };
        if (b >= 0)
            low[0] = p[3 * b] - t->x1[b], low[1] = p[3 * b + 1] - t->y1[b], low[2] = p[3 * b + 2] - t->z1[b];
        fprintf(f, "%.6g %.6g %.6g %.6g %.6g %.6g\n", low[0], low[1], low[2], p[3 * i] - t->x1[i],
                p[3 * i + 1] - t->y1[i], p[3 * i + 2] - t->z1[i]);
    }
    fputs("</DataArray>\n</PointData>\n<CellData Scalars=\"level\">\n", f);
    array(f, "level", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%d\n", (int)t->level[i]);
    fputs("</DataArray>\n</CellData>\n<Points>\n", f);
    array(f, "points", "Float32", 3);
    for (size_t i = 0; i < t->n; i++) {
        int32_t b = t->parent[i];
        if (b >= 0)
            fprintf(f, "%.7g %.7g %.7g ", p[3 * b], p[3 * b + 1], p[3 * b + 2]);
        else
            fprintf(f, "%.7g %.7g %.7g ", t->x0[i], t->y0[i], t->z0[i]);
        fprintf(f, "%.7g %.7g %.7g\n", p[3 * i], p[3 * i + 1], p[3 * i + 2]);
    }
    fputs("</DataArray>\n</Points>\n<Lines>\n", f);
    array(f, "connectivity", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%zu %zu\n", 2 * i, 2 * i + 1);
    fputs("</DataArray>\n", f);
    array(f, "offsets", "Int32", 1);
    for (size_t i = 0; i < t->n; i++) fprintf(f, "%zu\n", 2 * i + 2);
    fputs("</DataArray>\n</Lines>\n</Piece></PolyData>\n</VTKFile>\n", f);
}

static enum wf_status write_run(const struct wf_series *s, size_t run, const char *folder, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    size_t every = (s->frames + FRAMES_MOST - 1) / FRAMES_MOST;
    struct wf_file index = { 0 };
    snprintf(path, sizeof path, "%.4000s/vtk/run%zu.pvd", folder, run);
    enum wf_status status = wf_file_begin(&index, path, e);
    if (status) return status;
    fputs(
        "<?xml version=\"1.0\"?>\n<VTKFile type=\"Collection\" version=\"0.1\" byte_order=\"LittleEndian\">\n"
        "<Collection>\n",
        index.stream);
    for (size_t k = 0; k < s->frames && !status; k += every) {
        struct wf_file f = { 0 };
        snprintf(path, sizeof path, "%.4000s/vtk/run%zu_%05zu.vtp", folder, run, k);
        if ((status = wf_file_begin(&f, path, e))) break;
        frame(f.stream, s, k);
        status = wf_file_commit(&f, e);
        fprintf(index.stream,
                "<DataSet timestep=\"%.7g\" group=\"\" part=\"0\" file=\"run%zu_%05zu.vtp\"/>\n",
                (double)k * s->spec.step, run, k);
    }
    fputs("</Collection>\n</VTKFile>\n", index.stream);
    if (!status) status = wf_file_commit(&index, e);
    wf_file_abandon(&index);
    return status;
}

enum wf_status wf_series_vtk(const struct wf_series_page *p, const char *folder, struct wf_err *e)
{
    char path[WF_PATH_MAX];
    snprintf(path, sizeof path, "%.4000s/vtk", folder);
    enum wf_status status = wf_mkdirs(path, e);
    for (size_t r = 0; r < p->n && !status; r++) status = write_run(p->run[r].series, r + 1, folder, e);
    return status;
}
