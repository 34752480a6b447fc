#include "wind/gust_words.h"
#include "base/number.h"
#include <string.h>

enum wf_status wf_gust_set_words(struct wf_gust_spec *s, const char *words, struct wf_arena *a,
                                 struct wf_err *e)
{
    char *rest = NULL, *copy = words ? wf_arena_text(a, words) : NULL;
    if (words && !copy) return wf_fail(e, WF_ENOMEM, "no room for the parameters of a gust model");
    for (char *item = copy ? strtok_r(copy, ",", &rest) : NULL; item; item = strtok_r(NULL, ",", &rest)) {
        char *equals = strchr(item, '=');
        double value;
        const char *number = equals ? equals + 1 : "",
                   *end = wf_number_read(number, number + strlen(number), '.', &value);
        while (*item == ' ') item++;
        if (!end || *end)
            return wf_fail(e, WF_EUSAGE, "parameters of %s: '%s': expected name=number", s->model->name,
                           item);
        *equals = '\0';
        enum wf_status status = wf_gust_set(s, item, value, e);
        if (status) return status;
    }
    return WF_OK;
}

char *wf_gust_words(const struct wf_gust_spec *s, struct wf_arena *a)
{
    char *text = wf_arena_print(a, "intensity=%.6g", s->intensity);
    for (size_t i = 0; text && s->model->par[i].name; i++)
        text = wf_arena_print(a, "%s;%s=%.6g", text, s->model->par[i].name, s->value[i]);
    return text;
}

enum wf_status wf_gust_record_words(struct wf_gust_spec *s, const char *file, const char *columns,
                                    struct wf_arena *a, struct wf_diag *d, struct wf_err *e)
{
    struct wf_record_request q;
    struct wf_record *r = WF_TAKE(a, 1, struct wf_record);
    char *rest = NULL, *words = wf_arena_text(a, columns);
    if (!file) return wf_fail(e, WF_EUSAGE, "the model record needs the file of an anemometer");
    if (!r || !words) return wf_fail(e, WF_ENOMEM, "no room for a record");
    wf_record_request_default(&q);
    q.time = strtok_r(words, ",", &rest);
    for (int k = 0; k < 3; k++) q.part[k] = strtok_r(NULL, ",", &rest);
    if (!q.time || !q.part[0] || strtok_r(NULL, ",", &rest))
        return wf_fail(
            e, WF_EUSAGE,
            "columns '%s': a time column and one to three components are needed, separated by commas",
            columns);
    s->record = r;
    return wf_record_read(file, &q, a, d, r, e);
}
