#include "study/validate_keys.h"
#include "study/validate_keys_read.h"
#include <math.h>
#include <stdint.h>
#include <string.h>

#define AT(field) offsetof(struct wf_case, field)
#define NUMBER(name, field, dim, lo, hi)                                                                     \
    {                                                                                                        \
        name, wf_key_numbers, AT(field), dim, 1, 1, lo, hi, NULL, false                                      \
    }
#define PAIR(name, field, dim, lo, hi)                                                                       \
    {                                                                                                        \
        name, wf_key_numbers, AT(field), dim, 1, 2, lo, hi, NULL, false                                      \
    }
#define VECTOR(name, field, dim)                                                                             \
    {                                                                                                        \
        name, wf_key_numbers, AT(field), dim, 3, 3, -HUGE_VAL, HUGE_VAL, NULL, false                         \
    }
#define TEXT(name, field)                                                                                    \
    {                                                                                                        \
        name, wf_key_text, AT(field), 0, 0, 0, 0, 0, NULL, true                                              \
    }
#define CHOICE(name, field, words)                                                                           \
    {                                                                                                        \
        name, wf_key_choice, AT(field), 0, 0, 0, 0, 0, words, false                                          \
    }
#define SPECIAL(name, reader, repeats)                                                                       \
    {                                                                                                        \
        name, reader, 0, 0, 0, 0, 0, 0, NULL, repeats                                                        \
    }
#define TINY 1e-300 /* positive */
#define VAST 1e300

const struct wf_case_key wf_case_keys[] = {
    /* what it is */
    TEXT("title", title),
    TEXT("source", source),
    TEXT("note", note),
    CHOICE("kind", kind, "closed-form|published|computed-reference|field|regression"),
    CHOICE("units", nondimensional, "si|none"),
    /* the structure */
    SPECIAL("cantilever", wf_key_cantilever, false),
    NUMBER("rows", rows, WF_DIM_NONE, 1, 100000),
    VECTOR("direction", direction, WF_DIM_NONE),
    SPECIAL("arc", wf_key_arc, false),
    SPECIAL("node", wf_key_node, true),
    SPECIAL("branch", wf_key_branch, true),
    SPECIAL("tree", wf_key_tree, false),
    /* section and material */
    PAIR("radius", radius, WF_DIM_LENGTH, TINY, VAST),
    PAIR("inner_radius", inner, WF_DIM_LENGTH, 0, VAST),
    NUMBER("taper", taper, WF_DIM_NONE, TINY, 1),
    NUMBER("youngs_modulus", youngs, WF_DIM_PRESSURE, TINY, VAST),
    NUMBER("poisson", poisson, WF_DIM_NONE, -0.999, 0.5),
    NUMBER("shear_modulus", shear, WF_DIM_PRESSURE, TINY, VAST),
    NUMBER("density", density, WF_DIM_DENSITY, 0, VAST),
    NUMBER("EA", ea, WF_DIM_FORCE, TINY, VAST),
    NUMBER("GA", ga, WF_DIM_FORCE, TINY, VAST),
    NUMBER("EI", ei, WF_DIM_BENDING_STIFFNESS, TINY, VAST),
    NUMBER("GJ", gj, WF_DIM_BENDING_STIFFNESS, TINY, VAST),
    NUMBER("mass_per_length", mass_per_length, WF_DIM_MASS_PER_LENGTH, 0, VAST),
    CHOICE("model", model, "K|EB|SR"),
    NUMBER("shear_factor", shear_factor, WF_DIM_NONE, TINY, 2),
    SPECIAL("support", wf_key_support, false),
    /* loads */
    SPECIAL("force", wf_key_point, true),
    SPECIAL("moment", wf_key_point, true),
    SPECIAL("follower", wf_key_point, true),
    SPECIAL("mass", wf_key_mass, true),
    VECTOR("line_load", line_load, WF_DIM_FORCE_PER_LENGTH),
    VECTOR("line_load_by_radius", line_by_radius, WF_DIM_FORCE_PER_LENGTH),
    VECTOR("wind", wind, WF_DIM_SPEED),
    NUMBER("air_density", air_density, WF_DIM_DENSITY, TINY, VAST),
    NUMBER("drag_coefficient", drag, WF_DIM_NONE, 0, 100),
    SPECIAL("axis_drag", wf_key_law, false),
    SPECIAL("streamlining", wf_key_law, false),
    NUMBER("crown_area", crown_area, WF_DIM_LENGTH, 0, VAST),
    NUMBER("air_viscosity", air_viscosity, WF_DIM_VISCOSITY, TINY, VAST),
    NUMBER("cauchy", cauchy, WF_DIM_NONE, 0, VAST),
    NUMBER("gravity", gravity, WF_DIM_ACCELERATION, -VAST, VAST),
    NUMBER("weight_parameter", weight_parameter, WF_DIM_NONE, -VAST, VAST),
    /* potential flow */
    SPECIAL("flow", wf_key_flow, false),
    NUMBER("speed", flow_speed, WF_DIM_SPEED, -VAST, VAST),
    NUMBER("cylinder_radius", flow_radius, WF_DIM_LENGTH, TINY, VAST),
    NUMBER("circulation", flow_circulation, WF_DIM_VISCOSITY, -VAST, VAST),
    NUMBER("strength", flow_strength, WF_DIM_NONE, -VAST, VAST),
    { "segment", wf_key_numbers, AT(flow_segment), WF_DIM_LENGTH, 2, 2, -VAST, VAST, NULL, false },
    /* calibration */
    SPECIAL("fit", wf_key_fit, false),
    SPECIAL("free", wf_key_free, false),
    NUMBER("data_sets", data_sets, WF_DIM_NONE, 1, 10000),
    NUMBER("noise", noise, WF_DIM_NONE, 0, 1),
    /* how it is run, what is wanted */
    SPECIAL("solver", wf_key_solver, false),
    SPECIAL("mesh", wf_key_mesh, false),
    NUMBER("accuracy", accuracy, WF_DIM_NONE, 1e-15, 1e-3),
    NUMBER("tolerance", tolerance, WF_DIM_NONE, 1e-15, 0.5),
    SPECIAL("order", wf_key_order, false),
    SPECIAL("want", wf_key_want, true),
    { .name = NULL },
};
_Static_assert(sizeof wf_case_keys / sizeof *wf_case_keys <= WF_CASE_KEYS_MAX,
               "room for every key in wf_case.given");

size_t wf_case_key_index(const char *name)
{
    size_t k = 0;
    while (wf_case_keys[k].name && strcmp(name, wf_case_keys[k].name) != 0) k++;
    return k;
}

void wf_case_default(struct wf_case *c)
{
    *c = (struct wf_case){
        .kind = -1, .model = WF_MODEL_EB, .shape = WF_SHAPE_NONE, .tolerance = 1e-6, .rows = 1
    };
    c->direction[2] = 1.0;
    for (const struct wf_case_key *k = wf_case_keys; k->name; k++)
        if (k->read == wf_key_numbers && k->offset != AT(rows) && k->offset != AT(direction) &&
            k->offset != AT(tolerance))
            for (size_t i = 0; i < k->count; i++) ((double *)(void *)((char *)c + k->offset))[i] = NAN;
    c->length = c->arc[0] = c->arc[1] = c->mesh_tolerance = NAN;
}

bool wf_list_add(struct wf_list *l, const void *element, size_t size, struct wf_arena *a)
{
    if (l->n >= l->room) {
        size_t room = 2 * l->n + 4;
        void *data = wf_arena_take(a, room, size);
        if (!data) return false;
        if (l->n) memcpy(data, l->data, l->n * size);
        l->data = data;
        l->room = room;
    }
    memcpy((char *)l->data + l->n++ * size, element, size);
    return true;
}
