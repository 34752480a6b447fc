/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_GROW_IMPORT_FILE_H
#define WF_GROW_IMPORT_FILE_H
/* What all readers of tree files share: options, the beginning of the file, the meaning of column names, the
 * conversion of a row to a cylinder, and the reporting of rows that cannot be read. */
#include "base/units.h"
#include "grow/qsm.h"

struct wf_import_head;
struct wf_import_options;

/* Read a file of one format. Given: its beginning, options. Returned: *q, not repaired; unreadable rows are
 * reported in `d` and left out. Errors: WF_EINPUT, WF_EMISSING, WF_ENOMEM. */
typedef enum wf_status wf_import_reader(const struct wf_import_head *h, const struct wf_import_options *o,
                                        struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d,
                                        struct wf_err *e);

struct wf_import_options {
    const char *format;     /* a row of wf_import_formats; NULL = by content                            */
    bool strict;            /* refuse a file that needs a repair                                        */
    bool force;             /* take stems that stand apart, and any share of unseen wood                */
    bool cap_children;      /* thin rows to the thickness of what they grow on                          */
    const char *tree_id;    /* value of a table's column of trees, or the number of the tree in a file with a
                               line a    tree; NULL: the file holds one tree */
    const char *scan_model; /* which model of a MATLAB file of several, "1" ..; NULL: the first          */
    double length_unit;     /* metres per unit of lengths without a unit; NAN: 1 (an MTG: 0.01)         */
    double diameter_unit;   /* the same for radii and diameters; NAN: 1 (an MTG: from the sizes)        */
    wf_import_reader *mat;  /* of MATLAB files; NULL: in this process, for trusted files of version 5   */
};

/* The beginning of a file, enough to recognise its format. */
struct wf_import_head {
    const char *path;
    char *text; /* NUL-terminated */
    size_t size;
    bool ends_open; /* the file's last line has no line end */
    bool piped;     /* no file on a disk: only wf_file_read reads it */
};

enum wf_field {
    WF_FIELD_ID,
    WF_FIELD_PARENT,
    WF_FIELD_NEXT,
    WF_FIELD_ORDER,
    WF_FIELD_ADDED,
    WF_FIELD_X0,
    WF_FIELD_Y0,
    WF_FIELD_Z0,
    WF_FIELD_X1,
    WF_FIELD_Y1,
    WF_FIELD_Z1,
    WF_FIELD_AX,
    WF_FIELD_AY,
    WF_FIELD_AZ,
    WF_FIELD_RADIUS,
    WF_FIELD_R0,
    WF_FIELD_R1,
    WF_FIELD_LENGTH,
    WF_FIELD_ANGLE,    /* from the parent's axis                           */
    WF_FIELD_ZENITH,   /* from the vertical                                */
    WF_FIELD_AZIMUTH,  /* of the horizontal direction, from +x towards +y  */
    WF_FIELD_DISTANCE, /* of the start from the parent's base              */
    WF_FIELD_SHARE,    /* the same as a share of the parent's length       */
    WF_FIELD_TREE,     /* which tree of the table the row belongs to: text */
    WF_FIELD_COUNT,
    WF_FIELD_NONE = WF_FIELD_COUNT
};

enum wf_field_unit { WF_FIELD_PLAIN, WF_FIELD_METRES, WF_FIELD_RADIANS };

struct wf_field_row {
    enum wf_field field;
    const char *names;       /* spellings, lower case, letters and digits only, between blanks */
    double factor;           /* 0.5 for diameters, 1 / (2 pi) for girths                       */
    enum wf_field_unit unit; /* of `field`                                                     */
};

/* Meaning of a column by its name. Given: a header cell such as " startX", "diameter_mm", "radius (m)",
 * "girth_in"; metres per unit for lengths, and for diameters and radii, whose name has no unit. Returned: the
 * field (WF_FIELD_NONE for a column that is not used) and the factor to SI. */
enum wf_field wf_field_of(struct wf_units *u, const char *name, double length_unit, double diameter_unit,
                          double *factor, struct wf_err *e);

/* Whether text[0..n) is the mark of a missing value. Spreadsheets write errors as #N/A, #DIV/0!, #WERT! and
 * so on. */
bool wf_field_missing(const char *text, size_t n);

/* Convert a row of a file to a cylinder. Given: value[WF_FIELD_COUNT] in SI, NAN = not in the file. Returned:
 * NULL and row i of q, or what is wrong with the row. A number that is not finite is taken as missing. The
 * end is the given one; without it, start + length along the normalised axis. In rows without coordinates the
 * start and end are NAN. */
const char *wf_field_cylinder(struct wf_qsm *q, size_t i, const double value[WF_FIELD_COUNT]);

/* Report an unreadable row: an error when strict, otherwise a warning; counted in q. At most 100 are listed.
 */
void wf_import_bad_row(struct wf_qsm *q, bool strict, size_t line, size_t column, const char *text,
                       struct wf_diag *d);
/* The last row of the file was counted as unreadable, but the file ends within it: count it as truncated
 * instead. */
void wf_import_last_row_cut(struct wf_qsm *q, size_t line);
#endif
