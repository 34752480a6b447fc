#ifndef WF_GROW_IMPORT_MTG_H
#define WF_GROW_IMPORT_MTG_H
/* The graph of a multi-scale tree graph file (Godin & Caraglio 1998, J. Theor. Biol. 191:1-46): entities at
 * several scales, '/' decomposes an entity, '<' follows and '+' branches from one of the same scale. */
#include "grow/import_readers.h"

enum { WF_MTG_CLASSES = 64, WF_MTG_COLUMNS = 256 };

struct wf_mtg_class {
    char symbol[16];
    int scale;
};

/* One entity. Links are indices, -1 = none. */
struct wf_mtg_entity {
    int scale;
    char edge;       /* '/', '<' or '+': how it came to be; for '/' that of its complex */
    int32_t complex; /* the entity one scale up it is part of                          */
    int32_t below;   /* the entity it follows or branches from, as fine as is known     */
    int32_t fine;    /* its last part at the finest scale                               */
    bool first;      /* first part of its complex                                       */
    size_t line;
    double point[3]; /* XX YY ZZ, NAN = not given */
    double diameter; /* NAN = not given           */
};

struct wf_mtg {
    struct wf_mtg_class class[WF_MTG_CLASSES];
    size_t classes;
    size_t entity_columns; /* tab columns that may hold an entity                     */
    size_t column[4];      /* of XX, YY, ZZ and the diameter                          */
    double diameter_share; /* 1 for diameters, 2 for a radius column                  */
    struct wf_mtg_entity *entity;
    size_t n, room;
    int finest;
    int32_t last[WF_MTG_COLUMNS]; /* the newest entity of each tab column */
};

/* Classes and features, up to and with the ENTITY-CODE line. Given: text, which is advanced to the line after
 * it, and the line number. Errors: WF_EINPUT naming what is missing. */
enum wf_status wf_mtg_head(struct wf_mtg *g, const char *file, const char **at, size_t *line,
                           struct wf_err *e);

/* One line of entities. Returned: NULL, or what is wrong with it. `start`..`stop` without the line end. */
const char *wf_mtg_line(struct wf_mtg *g, const char *start, const char *stop, size_t line);
#endif
