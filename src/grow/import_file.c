/* SPDX-License-Identifier: GPL-3.0-or-later */
#include "grow/import_file.h"
#include "base/column.h"
#include "base/csv.h"
#include "base/num.h"
#include <ctype.h>
#include <math.h>
#include <string.h>

/* Rows that cannot be read. */

void wf_import_bad_row(struct wf_qsm *q, bool strict, size_t line, size_t column, const char *text,
                       struct wf_diag *d)
{
    enum { LISTED = 100 };
    wf_qsm_count(q, WF_REPAIR_BAD_ROW, 1, (int64_t)line);
    if (q->repairs.count[WF_REPAIR_BAD_ROW] > LISTED) return;
    if (strict)
        wf_diag_error(d, q->file, line, column, "%s", text);
    else
        wf_diag_warn(d, "row-left-out", "%s:%zu: %s", q->file, line, text);
}

void wf_import_last_row_cut(struct wf_qsm *q, size_t line)
{
    q->repairs.count[WF_REPAIR_BAD_ROW]--;
    wf_qsm_count(q, WF_REPAIR_TRUNCATED, 1, (int64_t)line);
}

/* What a column means. */

static const struct wf_field_row field_rows[] = {
    { WF_FIELD_ID, " id cylid cylinderid cylinder segid nodeid ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_PARENT, " parent parentid parentcylinder parentcylid parentnodeid parentnode ", 1,
      WF_FIELD_PLAIN },
    { WF_FIELD_NEXT, " extension extensionid ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_ORDER, " branchorder branchingorder level order ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_ADDED, " added ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_X0, " startx x0 basex xstart ", 1, WF_FIELD_METRES },
    { WF_FIELD_Y0, " starty y0 basey ystart ", 1, WF_FIELD_METRES },
    { WF_FIELD_Z0, " startz z0 basez zstart ", 1, WF_FIELD_METRES },
    { WF_FIELD_X1, " endx x1 tipx xend ", 1, WF_FIELD_METRES },
    { WF_FIELD_Y1, " endy y1 tipy yend ", 1, WF_FIELD_METRES },
    { WF_FIELD_Z1, " endz z1 tipz zend ", 1, WF_FIELD_METRES },
    { WF_FIELD_AX, " axisx ax ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_AY, " axisy ay ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_AZ, " axisz az ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_RADIUS, " radius radiuscyl rad r ", 1, WF_FIELD_METRES },
    { WF_FIELD_R0, " radius0 r0 baseradius radiusbase ", 1, WF_FIELD_METRES },
    { WF_FIELD_R1, " radius1 r1 tipradius radiustip endradius ", 1, WF_FIELD_METRES },
    { WF_FIELD_RADIUS, " diameter diam dia d ", 0.5, WF_FIELD_METRES },
    { WF_FIELD_R0, " diameter0 basediameter diameterbase dbase d0 ", 0.5, WF_FIELD_METRES },
    { WF_FIELD_R1, " diameter1 tipdiameter diametertip dtip d1 ", 0.5, WF_FIELD_METRES },
    { WF_FIELD_RADIUS, " girth circumference circ cbh gbh perimeter ", 0.5 / WF_PI, WF_FIELD_METRES },
    { WF_FIELD_R0, " girth0 basegirth girthbase ", 0.5 / WF_PI, WF_FIELD_METRES },
    { WF_FIELD_R1, " girth1 tipgirth girthtip ", 0.5 / WF_PI, WF_FIELD_METRES },
    { WF_FIELD_LENGTH, " length len ", 1, WF_FIELD_METRES },
    { WF_FIELD_ANGLE, " angle insertionangle branchangle ", 1, WF_FIELD_RADIANS },
    { WF_FIELD_ZENITH, " zenith inclination tilt ", 1, WF_FIELD_RADIANS },
    { WF_FIELD_AZIMUTH, " azimuth ", 1, WF_FIELD_RADIANS },
    { WF_FIELD_DISTANCE, " distance offset ", 1, WF_FIELD_METRES },
    { WF_FIELD_SHARE, " share position relativeposition ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_TREE, " tree treeid treename treenumber treeno treenr ", 1, WF_FIELD_PLAIN },
    { WF_FIELD_NONE, "", 1, WF_FIELD_PLAIN },
};

/* Letters and digits of a name's first `size` bytes in lower case, between blanks, to be searched for in
 * field_rows. */
static void plain_word(const char *name, size_t size, char *out, size_t room)
{
    size_t n = 0;
    out[n++] = ' ';
    for (size_t i = 0; i < size && n + 2 < room; i++)
        if (isalnum((unsigned char)name[i])) out[n++] = (char)tolower((unsigned char)name[i]);
    out[n++] = ' ';
    out[n] = '\0';
}

static const struct wf_field_row *field_named(const char *name, size_t size)
{
    char word[64];
    plain_word(name, size, word, sizeof word);
    const struct wf_field_row *f = field_rows;
    while (f->field != WF_FIELD_NONE && !strstr(f->names, word)) f++;
    return f;
}

enum wf_field wf_field_of(struct wf_units *u, const char *name, double length_unit, double diameter_unit,
                          double *factor, struct wf_err *e)
{
    static const enum wf_dimension dimension[] = {
        [WF_FIELD_METRES] = WF_DIM_LENGTH, [WF_FIELD_RADIANS] = WF_DIM_ANGLE
    };
    for (enum wf_field_unit k = WF_FIELD_METRES; k <= WF_FIELD_RADIANS; k++) {
        size_t stem;
        if (!wf_name_unit(u, name, dimension[k], factor, &stem, e)) continue;
        const struct wf_field_row *f = field_named(name, stem);
        if (f->field == WF_FIELD_NONE || f->unit != k) continue;
        *factor *= f->factor;
        return f->field;
    }
    const struct wf_field_row *f = field_named(name, strlen(name));
    bool thick = f->field == WF_FIELD_RADIUS || f->field == WF_FIELD_R0 || f->field == WF_FIELD_R1;
    *factor = f->factor;
    if (f->unit == WF_FIELD_METRES) *factor *= thick ? diameter_unit : length_unit;
    if (f->unit == WF_FIELD_RADIANS) *factor *= WF_PI / 180;
    return f->field;
}

/* Missing values. */

bool wf_field_missing(const char *text, size_t n) { return (n && text[0] == '#') || wf_csv_missing(text, n); }

/* Rows. */

/* Larger values cannot be a tree in metres; the thickest trees known have a radius of 5.8 m. */
static const double FARTHEST = 1e8, LONGEST = 200, THICKEST = 6; /* [m] */

static bool is_point(const double v[3])
{
    return fabs(v[0]) <= FARTHEST && fabs(v[1]) <= FARTHEST && fabs(v[2]) <= FARTHEST;
}

/* Compute the end of row i from start, axis and length. Returned: NULL, or what is wrong. */
static const char *end_by_axis(struct wf_qsm *q, size_t i, const double *v)
{
    const double *axis = v + WF_FIELD_AX;
    double norm = sqrt(axis[0] * axis[0] + axis[1] * axis[1] + axis[2] * axis[2]),
           length = v[WF_FIELD_LENGTH];
    if (isnan(length)) return "neither an end point nor a length";
    if (!(norm > 0 && norm < INFINITY)) return "neither an end point nor an axis direction";
    if (fabs(norm - 1) > 1e-3) wf_qsm_count(q, WF_REPAIR_AXIS, 1, q->id[i]);
    q->x1[i] = q->x0[i] + length * axis[0] / norm;
    q->y1[i] = q->y0[i] + length * axis[1] / norm;
    q->z1[i] = q->z0[i] + length * axis[2] / norm;
    return NULL;
}

static const char *cylinder_numbers(struct wf_qsm *q, size_t i, const double *v)
{
    double id = v[WF_FIELD_ID], parent = v[WF_FIELD_PARENT];
    if (id < 0 || id > 9e15 || id != floor(id)) return "the id is not a whole number from 0";
    if (!isnan(parent) && (parent < -1 || parent > 9e15 || parent != floor(parent)))
        return "the parent is not a whole number";
    q->id[i] = isnan(id) ? (int64_t)i + 1 : (int64_t)id;
    q->parent_id[i] = isnan(parent) ? WF_QSM_NO_PARENT : (int64_t)parent;
    double order = v[WF_FIELD_ORDER], next = v[WF_FIELD_NEXT];
    q->order[i] = order >= 0 && order < 1000 ? (int32_t)order : -1;
    q->next_id[i] = next > 0 && next < 9e15 ? (int64_t)next : 0;
    q->added[i] = v[WF_FIELD_ADDED] > 0;
    return NULL;
}

const char *wf_field_cylinder(struct wf_qsm *q, size_t i, const double given[WF_FIELD_COUNT])
{
    double v[WF_FIELD_COUNT];
    for (int f = 0; f < WF_FIELD_COUNT; f++) v[f] = isfinite(given[f]) ? given[f] : (double)NAN;
    const char *wrong = cylinder_numbers(q, i, v);
    if (wrong) return wrong;
    double r = v[WF_FIELD_RADIUS], r0 = v[WF_FIELD_R0], r1 = v[WF_FIELD_R1], length = v[WF_FIELD_LENGTH];
    q->r0[i] = isnan(r0) ? r : r0;
    q->r1[i] = isnan(r1) ? r : r1;
    if (q->r0[i] > THICKEST || q->r1[i] > THICKEST)
        return "a radius beyond 6 m; is its unit in the column's name, as in diameter_cm?";
    if (length < 0 || length > LONGEST) return "a length below 0 or beyond 200 m";
    q->length[i] = length;
    if (isnan(v[WF_FIELD_X0])) { /* a table of lengths and angles: placed later */
        q->x0[i] = q->y0[i] = q->z0[i] = q->x1[i] = q->y1[i] = q->z1[i] = (double)NAN;
        return isnan(length) ? "no length" : NULL;
    }
    if (!is_point(v + WF_FIELD_X0)) return "the start is not a point within 100000 km";
    q->x0[i] = v[WF_FIELD_X0], q->y0[i] = v[WF_FIELD_Y0], q->z0[i] = v[WF_FIELD_Z0];
    if (isnan(v[WF_FIELD_X1])) return end_by_axis(q, i, v);
    if (!is_point(v + WF_FIELD_X1)) return "the end is not a point within 100000 km";
    q->x1[i] = v[WF_FIELD_X1], q->y1[i] = v[WF_FIELD_Y1], q->z1[i] = v[WF_FIELD_Z1];
    return wf_qsm_distance(q, i) > LONGEST ? "start and end are more than 200 m apart" : NULL;
}
