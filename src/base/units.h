/* SPDX-License-Identifier: GPL-3.0-or-later */
#ifndef WF_BASE_UNITS_H
#define WF_BASE_UNITS_H
/* Quantities as text: "10 GPa" to SI and back, with UDUNITS-2. */
#include "base/err.h"
#include <stdbool.h>
#include <stddef.h>

enum wf_dimension {
    WF_DIM_NONE, /* a plain number or a percentage */
    WF_DIM_LENGTH,
    WF_DIM_AREA,
    WF_DIM_SPEED,
    WF_DIM_TIME,
    WF_DIM_FREQUENCY,
    WF_DIM_MASS,
    WF_DIM_FORCE,
    WF_DIM_PRESSURE,
    WF_DIM_DENSITY,
    WF_DIM_MASS_PER_AREA,
    WF_DIM_ANGLE,
    WF_DIM_TEMPERATURE,
    WF_DIM_ROTATIONAL_STIFFNESS,
    WF_DIM_BENDING_STIFFNESS,
    WF_DIM_VISCOSITY, /* kinematic */
    WF_DIM_ACCELERATION,
    WF_DIM_MOMENT,
    WF_DIM_FORCE_PER_LENGTH,
    WF_DIM_MASS_PER_LENGTH,
    WF_DIM_COUNT
};

struct wf_dimension_row {
    const char *name;  /* "a pressure", for messages               */
    const char *si;    /* UDUNITS spelling of the SI unit          */
    const char *units; /* units to suggest, separated by commas    */
};
/* The row of a dimension; never NULL. */
const struct wf_dimension_row *wf_dimension_row(enum wf_dimension d);

struct wf_units; /* a table of units; must not be used by two threads at once */

/* Read the units database; takes about 3 ms. UDUNITS 2.2 never frees the prefixes of a database it has read
 * (7 kB each time), so a caller with many quantities should open one table for all of them. Errors:
 * WF_EMISSING when UDUNITS' database is not installed or damaged, WF_ENOMEM. */
enum wf_status wf_units_open(struct wf_units **out, struct wf_err *e);
/* Free a table; NULL is allowed. */
void wf_units_close(struct wf_units *u);

/* Whether a text is a unit of any dimension; false also without memory. */
bool wf_unit_known(const struct wf_units *u, const char *text);

/* Read a quantity. Given: text such as "10 GPa", "36 km/h", "0.35", "12 %", "15 degC", and the dimension
 * wanted. Returned: *si, the value in the SI unit of the dimension. Errors: WF_EINPUT with a message that
 * shows the text, says what is wrong and what would be right. Only a dimensionless value may lack a unit, and
 * only an angle may be in degrees or radians; a unit of the reciprocal dimension is refused. A unit is words
 * with exponents of one digit, products, quotients and brackets, at most 60 bytes: UDUNITS reads nothing
 * else. WF_ENOMEM. */
enum wf_status wf_quantity_read(struct wf_units *u, const char *text, enum wf_dimension d, double *si,
                                struct wf_err *e);
/* The same; messages give their examples in `usual`, the customary unit of the value. */
enum wf_status wf_quantity_read_as(struct wf_units *u, const char *text, enum wf_dimension d,
                                   const char *usual, double *si, struct wf_err *e);
/* SI value in `unit`: 1e10, "GPa" gives 10. A unit that does not fit the dimension, or "": the SI value. NAN
 * without memory. */
double wf_quantity_in(struct wf_units *u, double si, enum wf_dimension d, const char *unit);
/* Write an SI value to buf[size] in `unit` ("" for dimensionless values) with six significant digits: 1e10
 * and "GPa" give "10 GPa". Returned: buf. If the unit does not fit the dimension, or without memory, the SI
 * unit is used. */
char *wf_quantity_print(struct wf_units *u, double si, enum wf_dimension d, const char *unit, char *buf,
                        size_t size);
#endif
