/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed of tables of trees on one core: rows a second without an interval, and with one of 256 samples. User
 * and system time of the whole run, the fastest of some; the wall clock of two threads beside it. */
#include "bench_run.h"

enum { CARDS = 40 };

/* So many of the example's cards, from the first on and again. */
static void write_table(size_t rows)
{
    char command[1600];
    snprintf(command, sizeof command,
             "f=docs/examples/forty_trees.csv; (head -2 $f; for i in $(seq %zu); do tail -n +3 $f; done | "
             "head -%zu) "
             ">'%s/trees.csv'",
             rows / CARDS + 1, rows, folder);
    (void)run(command);
}

static void measure(size_t rows, int samples, int times, double bar)
{
    char command[1600];
    double best = 1e9, wall = 1e9;
    write_table(rows);
    for (int i = 0; i < times + 1; i++) {
        int threads = i < times ? 1 : 2;
        snprintf(
            command, sizeof command,
            "%s assess '%s/trees.csv' -o '%s/out%d.csv' --wind 'gust:33 m/s' --soil mineral --samples %d "
            "--threads %d -q",
            program, folder, folder, threads, samples, threads);
        struct spent t = run(command);
        if (threads == 1 && t.processor < best) best = t.processor;
        if (threads == 2) wall = t.wall;
    }
    snprintf(command, sizeof command, "cmp '%s/out1.csv' '%s/out2.csv'", folder, folder);
    (void)run(command); /* the bytes are the same */
    printf(
        "tables: %zu rows, %d samples: %.2f s of processor time, %.3g rows/s a core (bar %g); on two threads "
        "%.3g rows/s of the wall clock\n",
        rows, samples, best, (double)rows / best, bar, (double)rows / wall);
}

int main(void)
{
    open_folder("tables");
    measure(1000, 0, 3, 300);
    measure(CARDS, 256, 2, 5);
    drop_folder();
    return 0;
}
