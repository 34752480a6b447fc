#include "out/results.h"
#include "base/file.h"
#include "out/parts.h"
#include "out/tables.h"
#include "out/tree_picture.h"
#include <errno.h>
#include <inttypes.h>
#include <locale.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>
#include <unistd.h>

enum wf_status wf_input_file_note(const char *role, const char *path, struct wf_arena *a,
                                  struct wf_input_file *out, struct wf_err *e)
{
    out->role = wf_arena_text(a, role);
    out->path = wf_arena_text(a, path);
    if (!out->role || !out->path) return wf_fail(e, WF_ENOMEM, "%s: no room for its name", path);
    return wf_sha256_file(path, out->sha256, e);
}

const char *wf_run_date(struct wf_arena *a)
{
    char text[32], *end;
    time_t now = time(NULL);
    const char *given = getenv("SOURCE_DATE_EPOCH");
    long long epoch = given ? strtoll(given, &end, 10) : 0;
    if (given && *given && !*end) now = (time_t)epoch;
    struct tm utc;
    if (!gmtime_r(&now, &utc) || !strftime(text, sizeof text, "%Y-%m-%dT%H:%M:%SZ", &utc)) return NULL;
    return wf_arena_text(a, text);
}

static json_t *provenance(struct wf_doc *d, const struct wf_run *run)
{
    char seed[24];
    json_t *o = wf_doc_object(d);
    wf_doc_text(d, o, "program", "windfirm");
    wf_doc_text(d, o, "version", run->version);
    wf_doc_text(d, o, "date", run->date);
    wf_doc_text(d, o, "command", run->command);
    /* Text, because a 64-bit number does not survive readers that keep numbers as doubles. */
    snprintf(seed, sizeof seed, "%" PRIu64, run->seed);
    wf_doc_text(d, o, "seed", run->random ? seed : NULL);
    json_t *files = wf_doc_put(d, o, "files", wf_doc_array(d));
    for (size_t i = 0; i < run->inputs; i++) {
        json_t *file = wf_doc_add(d, files, wf_doc_object(d));
        wf_doc_text(d, file, "role", run->input[i].role);
        wf_doc_text(d, file, "path", run->input[i].path);
        wf_doc_text(d, file, "sha256", run->input[i].sha256);
    }
    return o;
}

/* A list of findings that several trees share belongs to the run, not to one tree. */
static bool shared(const struct wf_run *run, size_t tree)
{
    for (size_t i = 0; i < run->n; i++)
        if (i != tree && run->analysis[i].diag == run->analysis[tree].diag) return true;
    return false;
}

static json_t *tree(struct wf_doc *d, const struct wf_run *run, size_t index)
{
    const struct wf_analysis *a = &run->analysis[index];
    json_t *o = wf_doc_object(d);
    wf_doc_put(d, o, "species", wf_part_species(d, a));
    wf_doc_put(d, o, "model", wf_part_model(d, a->model));
    wf_doc_put(d, o, "scenario", wf_part_scenario(d, a));
    wf_doc_put(d, o, "method", wf_part_method(d, a));
    wf_doc_quantity(d, o, "height", a->tallness, "m", NULL);
    wf_doc_count(d, o, "segments", a->tree.n);
    json_t *winds = wf_doc_put(d, o, "winds", wf_doc_array(d));
    for (size_t k = 0; k < a->n; k++) wf_doc_add(d, winds, wf_part_wind(d, a, &a->at[k]));
    wf_doc_put(d, o, "critical", wf_part_critical(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_TREE]));
    wf_doc_put(d, o, "critical_stem", wf_part_critical(d, a, &a->breaks[WF_BREAKAGE][WF_SCOPE_STEM]));
    wf_doc_put(d, o, "criteria", wf_part_criteria(d, a, a->breaks, a->at));
    double last = a->sweep_n ? a->sweep[a->sweep_n - 1].speed : NAN;
    wf_doc_put(d, o, "directions", wf_part_directions(d, a));
    wf_doc_quantity(d, o, "sweep_speed_high", last, "m/s", "no sweep was made");
    wf_doc_put(d, o, "warnings", shared(run, index) ? wf_doc_array(d) : wf_part_warnings(d, a->diag));
    return o;
}

static bool has(const struct wf_run *run, size_t table)
{
    return !wf_tables[table].made || wf_tables[table].made(run);
}

static json_t *document(struct wf_doc *d, const struct wf_run *run, const size_t rows[WF_TABLES])
{
    json_t *o = wf_doc_object(d);
    json_t *schema = wf_doc_put(d, o, "schema", wf_doc_object(d));
    wf_doc_text(d, schema, "name", WF_RESULTS_SCHEMA);
    wf_doc_count(d, schema, "version", WF_RESULTS_VERSION);
    wf_doc_text(d, o, "title", run->title);
    wf_doc_put(d, o, "provenance", provenance(d, run));
    json_t *trees = wf_doc_put(d, o, "trees", wf_doc_array(d));
    for (size_t i = 0; i < run->n; i++) wf_doc_add(d, trees, tree(d, run, i));
    wf_doc_put(d, o, "warnings",
               shared(run, 0) ? wf_part_warnings(d, run->analysis[0].diag) : wf_doc_array(d));
    json_t *tables = wf_doc_put(d, o, "tables", wf_doc_array(d));
    for (size_t i = 0; i < WF_TABLES; i++) {
        if (!has(run, i)) continue;
        json_t *table = wf_doc_add(d, tables, wf_doc_object(d));
        wf_doc_text(d, table, "file", wf_tables[i].name);
        wf_doc_text(d, table, "meaning", wf_tables[i].meaning);
        wf_doc_count(d, table, "rows", rows[i]);
    }
    return o;
}

static enum wf_status check(const struct wf_run *run, struct wf_err *e)
{
    if (run->n == 0) return wf_fail(e, WF_EUSAGE, "a run without analyses has no results");
    for (size_t i = 0; i < run->n; i++) {
        const struct wf_analysis *a = &run->analysis[i], *first = run->analysis;
        bool same = a->n == first->n && a->n > 0;
        for (size_t k = 0; same && k < a->n; k++) same = a->at[k].speed == first->at[k].speed;
        if (!same) return wf_fail(e, WF_EUSAGE, "the trees of a run must share one list of wind speeds");
    }
    return WF_OK;
}

static enum wf_status write_document(const struct wf_run *run, const size_t rows[WF_TABLES],
                                     struct wf_file *f, struct wf_err *e)
{
    struct wf_doc d = { 0 };
    json_t *o = document(&d, run, rows);
    enum wf_status code = WF_OK;
    bool dumped = !d.failed && !json_dumpf(o, f->stream, JSON_INDENT(1) | JSON_REAL_PRECISION(17));
    if (dumped)
        putc('\n', f->stream);
    else if (!ferror(f->stream)) /* a write that failed is told by the caller, for all files alike */
        code = wf_fail(e, WF_ENOMEM, "%s: no memory for the document", f->path);
    json_decref(o);
    return code;
}

enum { DOCUMENT = WF_TABLES, FILES }; /* the document comes last: it names the tables */

static enum wf_status write_all(const struct wf_run *run, const char *folder, struct wf_file f[FILES],
                                struct wf_err *e)
{
    size_t rows[WF_TABLES];
    char path[WF_PATH_MAX];
    enum wf_status code;
    for (size_t i = 0; i < FILES; i++) {
        int n =
            snprintf(path, sizeof path, "%s/%s", folder, i == DOCUMENT ? "results.json" : wf_tables[i].name);
        if (n < 0 || (size_t)n >= sizeof path)
            return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
        if (i < WF_TABLES && !has(run, i)) {
            memcpy(f[i].path, path, sizeof path);
            continue;
        }
        if ((code = wf_file_begin(&f[i], path, e))) return code;
        errno = 0;
        if (i < WF_TABLES)
            rows[i] = wf_tables[i].write(run, f[i].stream);
        else if ((code = write_document(run, rows, &f[i], e)))
            return code;
        if (fflush(f[i].stream) || ferror(f[i].stream)) /* a full disk shows before any file is replaced */
            return wf_fail(e, WF_EOUTPUT, "%s: cannot be written: %s", path,
                           errno ? strerror(errno) : "write error");
    }
    for (size_t i = 0; i < FILES; i++)
        if (!f[i].stream)
            unlink(f[i].path); /* an earlier run's would be taken for this one's */
        else if ((code = wf_file_commit(&f[i], e)))
            return code;
    return WF_OK;
}

/* A branched tree is shown; a bare stem is seen in every other figure. */
static enum wf_status picture(const struct wf_run *run, const char *folder, struct wf_err *e)
{
    const struct wf_analysis *a = &run->analysis[0];
    const struct wf_tree_picture p = { &a->tree, a->model, a->species };
    char plots[WF_PATH_MAX];
    if (a->model->generator == WF_GENERATOR_STEM) {
        wf_tree_picture_remove(folder);
        return WF_OK;
    }
    int n = snprintf(plots, sizeof plots, "%s/plots", folder);
    if (n < 0 || (size_t)n >= sizeof plots)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    enum wf_status code = wf_mkdirs(plots, e);
    return code ? code : wf_tree_picture_write(&p, folder, e);
}

enum wf_status wf_results_write(const struct wf_run *run, const char *folder, struct wf_err *e)
{
    char tables[WF_PATH_MAX];
    enum wf_status code = check(run, e);
    if (code) return code;
    int n = snprintf(tables, sizeof tables, "%s/tables", folder);
    if (n < 0 || (size_t)n >= sizeof tables)
        return wf_fail(e, WF_EOUTPUT, "%.200s...: the name is too long", folder);
    if ((code = wf_mkdirs(tables, e))) return code;
    /* A caller may have set a locale with a decimal comma; a table has points. */
    locale_t plain = newlocale(LC_NUMERIC_MASK, "C", (locale_t)0);
    if (!plain) return wf_fail(e, WF_ENOMEM, "no memory for the locale of the tables");
    locale_t before = uselocale(plain);
    struct wf_file f[FILES] = { 0 };
    code = write_all(run, folder, f, e);
    if (!code) code = picture(run, folder, e);
    for (size_t i = 0; i < FILES; i++) wf_file_abandon(&f[i]);
    uselocale(before);
    freelocale(plain);
    return code;
}
