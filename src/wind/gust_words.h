#ifndef WF_WIND_GUST_WORDS_H
#define WF_WIND_GUST_WORDS_H
/* Gust models named in words, the same in every command and run file. */
#include "wind/gust.h"

/* Set parameters of the model from "name=number,name=number"; NULL: none. WF_EUSAGE tells what is wrong and
 * what there is. */
enum wf_status wf_gust_set_words(struct wf_gust_spec *s, const char *words, struct wf_arena *a,
                                 struct wf_err *e);
/* The reverse: intensity and every parameter with its value, as "name=number;..."; NULL: no room. */
char *wf_gust_words(const struct wf_gust_spec *s, struct wf_arena *a);

/* Columns of an anemometer file as wf_record_request_default has them, in words. */
#define WF_RECORD_COLUMNS "t_s,u_ms,v_ms,w_ms"
/* Read the anemometer file of the model `record` and hang it into the specification. Given: the file, its
 * columns "time,u[,v[,w]]". Errors: WF_EUSAGE without a file or with other columns, those of wf_record_read.
 */
enum wf_status wf_gust_record_words(struct wf_gust_spec *s, const char *file, const char *columns,
                                    struct wf_arena *a, struct wf_diag *d, struct wf_err *e);
#endif
