#ifndef WF_GROW_IMPORT_FIELD_H
#define WF_GROW_IMPORT_FIELD_H
/* What a column of a tree file can mean, and one row of such columns turned into a cylinder. */
#include "grow/qsm.h"

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
    WF_FIELD_COUNT,
    WF_FIELD_NONE = WF_FIELD_COUNT
};

enum wf_field_unit { WF_FIELD_PLAIN, WF_FIELD_METRES, WF_FIELD_RADIANS };

struct wf_field_row {
    enum wf_field field;
    const char *names;       /* spellings, lower case, letters and digits only, between blanks */
    double factor;           /* 0.5 for diameters                                              */
    enum wf_field_unit unit; /* of `field`                                                     */
};
/* Ends at field == WF_FIELD_NONE. */
extern const struct wf_field_row wf_field_rows[];

/* Meaning of a column by its name. Given: a header cell such as " startX", "diameter_mm", "radius (m)";
 * metres per unit for lengths and for diameters and radii without a unit in their name. Returned: the field
 * (WF_FIELD_NONE for a column of no interest) and the factor to SI. */
enum wf_field wf_field_of(const char *name, double length_unit, double diameter_unit, double *factor);

/* Given: value[WF_FIELD_COUNT] in SI, NAN = not in the file. Returned: NULL and row i of q, or what is wrong
 * with the row. An end is taken as given, else start + length along the normalised axis. Rows without
 * coordinates keep NAN ends.
 */
const char *wf_field_cylinder(struct wf_qsm *q, size_t i, const double value[WF_FIELD_COUNT]);
#endif
