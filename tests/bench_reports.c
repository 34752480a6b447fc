/* SPDX-License-Identifier: GPL-3.0-or-later */
/* Speed of pages: HTML of a report, PDF by the page, and the reports of a table of trees. Processor time of
 * the program and of gnuplot and WeasyPrint, which it starts. */
#include "bench_run.h"
#include <stdbool.h>
#include <string.h>

/* The program with the rest of its command line. */
static struct spent run_program(const char *rest)
{
    char command[2200];
    snprintf(command, sizeof command, "%s %s >/dev/null 2>&1", program, rest);
    return run(command);
}

/* Pages of all PDFs below the folder. */
static size_t count_pages(const char *below)
{
    char command[600];
    size_t n = 0, k;
    snprintf(command, sizeof command,
             "for f in '%s'/*/*.pdf; do pdfinfo \"$f\" | awk '/^Pages/ { print $2 }'; done", below);
    FILE *f = popen(command, "r");
    while (f && fscanf(f, "%zu", &k) == 1) n += k;
    if (f) pclose(f);
    return n;
}

static struct spent best_of(const char *rest, int times)
{
    struct spent best = { 1e9, 1e9 };
    for (int i = 0; i < times; i++) {
        struct spent t = run_program(rest);
        best.wall = t.wall < best.wall ? t.wall : best.wall;
        best.processor = t.processor < best.processor ? t.processor : best.processor;
    }
    return best;
}

static void one_page(void)
{
    char rest[900];
    snprintf(rest, sizeof rest,
             "analyze oak --model oak_20m --soil mineral --wind 10,15,20 --directions 8 --samples 0 --no-pdf "
             "-o '%s/one'",
             folder);
    (void)run_program(rest);
    snprintf(rest, sizeof rest, "report '%s/one' --no-pdf", folder);
    struct spent t = best_of(rest, 5);
    printf(
        "pages: HTML of a report with 6 figures: %.2f s of processor time, wall %.2f s (bar 0.5 with 12)\n",
        t.processor, t.wall);
    snprintf(rest, sizeof rest,
             "compare moso_bamboo weeping_willow --model culm --wind 10,15,25 --no-pdf -o '%s/two'", folder);
    (void)run_program(rest);
    snprintf(rest, sizeof rest, "report '%s/two' --no-pdf", folder);
    t = best_of(rest, 5);
    printf("pages: figures and HTML of a comparison: %.2f s of processor time, wall %.2f s (bar 0.35)\n",
           t.processor, t.wall);
}

/* One PDF by a process that starts, and what it takes without the PDF. */
static void one_pdf(void)
{
    char rest[900];
    snprintf(rest, sizeof rest, "report '%s/two' --no-pdf", folder);
    struct spent html = best_of(rest, 3);
    snprintf(rest, sizeof rest, "report '%s/two'", folder);
    struct spent pdf = best_of(rest, 3);
    size_t pages = count_pages(folder);
    printf(
        "pages: the PDF of %zu pages of a comparison, WeasyPrint's start included: %.2f s of processor time, "
        "wall %.2f s (bar 0.2 s a page and the start, some 0.5: %.2f)\n",
        pages, pdf.processor - html.processor, pdf.wall - html.wall, 0.5 + 0.2 * (double)pages);
}

enum { TREES = 32 }; /* of the hundred of the bars: the rest takes as long each */

/* A table of trees of many sizes. */
static void write_table(void)
{
    char path[400];
    snprintf(path, sizeof path, "%s/trees.csv", folder);
    FILE *to = fopen(path, "w");
    if (!to) exit(1);
    fputs("id,species,height_m,girth_cm,crown_width_m,crown_base_m\n", to);
    static const char *const species[] = { "oak", "beech", "ash", "sycamore", "lime" };
    for (size_t n = 0; n < TREES; n++)
        fprintf(to, "%zu,%s,%zu,%zu,%zu,%zu\n", n + 1, species[n % 5], 16 + n % 9, 150 + 2 * (n % 50),
                8 + n % 5, 3 + n % 3);
    fclose(to);
}

static void table(bool pdf)
{
    char rest[1600], below[400];
    const double all = 100.0 / TREES;
    write_table();
    snprintf(below, sizeof below, "%s/%s", folder, pdf ? "pdf" : "html");
    snprintf(rest, sizeof rest,
             "assess '%s/trees.csv' -o '%s.csv' --reports '%s' --wind 'gust:33 m/s' --soil mineral --samples "
             "0 -q%s",
             folder, below, below, pdf ? "" : " --no-pdf");
    struct spent t = run_program(rest);
    size_t pages = pdf ? count_pages(below) : 0;
    if (!pdf) {
        printf(
            "pages: %d reports of a table, HTML: a hundred in %.0f s, %.0f s of processor time (bar 25 s)\n",
            TREES, all * t.wall, all * t.processor);
        return;
    }
    printf("pages: %d reports of a table, HTML and PDF, %zu pages: a hundred in %.0f s, %.0f s of processor "
           "time, %.2f s "
           "a page (bars: 60 s on 2 processors, 0.2 s a page)\n",
           TREES, pages, all * t.wall, all * t.processor, t.processor / (double)(pages ? pages : 1));
}

int main(void)
{
    open_folder("bench");
    one_page();
    table(false);
    if (system("command -v weasyprint >/dev/null && command -v pdfinfo >/dev/null"))
        printf("pages: no weasyprint or pdfinfo: PDFs were not measured\n");
    else
        one_pdf(), table(true);
    drop_folder();
    return 0;
}
