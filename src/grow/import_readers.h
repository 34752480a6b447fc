#ifndef WF_GROW_IMPORT_READERS_H
#define WF_GROW_IMPORT_READERS_H
/* The readers behind wf_import_read: each fills a table of cylinders with what its file says, unrepaired.
 * Rows that cannot be read are findings and counted (WF_REPAIR_BAD_ROW, WF_REPAIR_TRUNCATED). */
#include "grow/import.h"

/* The beginning of a file, enough to tell its format. */
struct wf_import_head {
    const char *path;
    char *text; /* NUL-terminated */
    size_t size;
    bool ends_open; /* the file's last line has no line end */
};

typedef enum wf_status wf_import_reader(const struct wf_import_head *h, const struct wf_import_options *o,
                                        struct wf_arena *a, struct wf_qsm *q, struct wf_diag *d,
                                        struct wf_err *e);

wf_import_reader wf_import_table; /* text with a header row                                     */
wf_import_reader wf_import_bare;  /* TreeQSM text: numbers in columns, with or without its header */
wf_import_reader wf_import_mat;   /* MATLAB                                                     */
wf_import_reader wf_import_mtg;   /* OpenAlea multi-scale tree graph                            */

/* Whether a header row speaks of a tree; *known gets the number of columns that mean something. */
bool wf_import_is_bare(const struct wf_import_head *h);

/* Coordinates of a table without any, from lengths and angles. Given: per row angle, zenith, azimuth [rad],
 * distance [m], share [-], each NAN where not measured, as rows of value[n][WF_FIELD_COUNT]. */
struct wf_hand {
    double *angle, *zenith, *azimuth, *distance, *share;
};
enum wf_status wf_import_place(struct wf_qsm *q, const struct wf_hand *hand, struct wf_arena *a,
                               struct wf_err *e);

/* A finding about an unreadable row: an error when strict, else a warning; counted in q. At most 100 are
 * listed. */
void wf_import_bad_row(struct wf_qsm *q, bool strict, size_t line, size_t column, const char *text,
                       struct wf_diag *d);
#endif
