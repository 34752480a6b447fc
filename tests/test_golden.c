/* SPDX-License-Identifier: GPL-3.0-or-later */
/* The demo's tables against those kept in tests/golden/mean (steady mean wind) and
 * tests/golden/peak (the default). They guard against unintended change; what is right
 * is told by the validation cases. `make golden` writes them again. */
#include "close.h"
#include <stdbool.h>
#include <stdlib.h>
#include <string.h>

enum { COLUMNS_MAX = 64, LINE_MAX_SIZE = 4096 };
#define TOLERANCE 1e-6

static const char *program, *kept; /* kept: folder of the expected tables */

static FILE *open_table(const char *folder, const char *name)
{
    char path[1024];
    snprintf(path, sizeof path, "%s/%s.csv", folder, name);
    FILE *f = fopen(path, "r");
    if (!f) fail_msg("%s is missing", path);
    return f;
}

/* Cells of a line, in place. No cell of these tables holds a comma. */
static size_t cells(char *line, char *cell[COLUMNS_MAX])
{
    size_t n = 0;
    line[strcspn(line, "\r\n")] = '\0';
    for (char *c; n < COLUMNS_MAX && (c = strsep(&line, ","));) cell[n++] = c;
    return n;
}

static bool number(const char *cell, double *value)
{
    char *end;
    *value = strtod(cell, &end);
    return *cell && !*end;
}

/* Largest magnitude of each column: what is small beside it is compared to it, since zero has no digits. */
static void scales(const char *name, double scale[COLUMNS_MAX])
{
    char line[LINE_MAX_SIZE], *cell[COLUMNS_MAX];
    FILE *f = open_table(kept, name);
    for (size_t k = 0; k < COLUMNS_MAX; k++) scale[k] = 0;
    while (fgets(line, sizeof line, f)) {
        double v;
        size_t n = cells(line, cell);
        for (size_t k = 0; k < n; k++)
            if (number(cell[k], &v) && isfinite(v)) scale[k] = fmax(scale[k], fabs(v));
    }
    fclose(f);
}

static void compare(const char *folder, const char *name)
{
    char want_line[LINE_MAX_SIZE], got_line[LINE_MAX_SIZE], *want[COLUMNS_MAX], *got[COLUMNS_MAX];
    double scale[COLUMNS_MAX];
    size_t row = 0;
    scales(name, scale);
    FILE *golden = open_table(kept, name), *fresh = open_table(folder, name);
    for (; fgets(want_line, sizeof want_line, golden); row++) {
        if (!fgets(got_line, sizeof got_line, fresh)) fail_msg("%s.csv ends at line %zu", name, row);
        size_t n = cells(want_line, want);
        assert_int_equal(cells(got_line, got), n);
        for (size_t k = 0; k < n; k++) {
            double a, b;
            bool numbers = number(want[k], &a) && number(got[k], &b);
            bool same = numbers ? fabs(a - b) <= TOLERANCE * fmax(fabs(a), 1e-3 * scale[k])
                                : strcmp(want[k], got[k]) == 0;
            if (!same)
                fail_msg("%s.csv line %zu column %zu: %s, kept as %s", name, row + 1, k + 1, got[k], want[k]);
        }
    }
    if (fgets(got_line, sizeof got_line, fresh)) fail_msg("%s.csv has more than %zu lines", name, row);
    assert_true(row > 1);
    fclose(golden);
    fclose(fresh);
}

static void demo(const char *method)
{
    static const char *const table[] = { "summary", "segments", "shape", "sweep" };
    static char expected[64];
    char command[2048], folder[512];
    snprintf(expected, sizeof expected, "tests/golden/%s", method);
    snprintf(folder, sizeof folder, "%s.golden/tables", program);
    snprintf(command, sizeof command,
             "rm -rf %s.golden; %s compare species/moso_bamboo.yaml species/weeping_willow.yaml --model "
             "models/culm.yaml --wind 10,15,25 -o %s.golden --no-report --quiet%s",
             program, program, program, strcmp(method, "mean") ? "" : " --peak mean");
    assert_int_equal(system(command), 0);
    kept = expected;
    for (size_t k = 0; k < sizeof table / sizeof *table; k++) compare(folder, table[k]);
}

static void mean(void **state)
{
    (void)state;
    demo("mean");
}

static void peak(void **state)
{
    (void)state;
    demo("peak");
}

int main(void)
{
    program = getenv("WINDFIRM");
    if (!program) program = "build/windfirm";
    const struct CMUnitTest tests[] = { cmocka_unit_test(mean), cmocka_unit_test(peak) };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
