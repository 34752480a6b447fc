#include "cmd/import_options.h"
#include <math.h>

const char *wf_import_word(size_t i) { return wf_import_formats[i].name; }

static double metres(const char *unit)
{
    if (!unit) return (double)NAN;
    return unit[0] == 'c' ? 0.01 : unit[1] == 'm' ? 0.001 : 1;
}

struct wf_import_options wf_import_typed(const struct wf_args *g)
{
    struct wf_import_options o = wf_import_default();
    o.format = wf_args_text(g, "--format");
    o.strict = wf_args_given(g, "--strict");
    o.length_unit = metres(wf_args_text(g, "--length-unit"));
    o.diameter_unit = metres(wf_args_text(g, "--diameter-unit"));
    return o;
}
