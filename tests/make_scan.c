/* SPDX-License-Identifier: GPL-3.0-or-later */
/* A made-up scan for measurements of speed: a bare broadleaved tree as a table of cylinders, as TreeQSM's
 * are.
 *
 *     make_scan SEGMENTS [SEED] >scan.csv
 *
 * Thickest branches first, so that any number of segments is a whole tree with more or less of its twigs.
 * Lengths go with the 2/3 power of radii (McMahon & Kronauer 1976, Tree structures: deducing the principle of
 * mechanical design), so that the wood bears its weight with some MPa, as in a real tree. */
#include <math.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static const double trunk_radius = 0.22, trunk_height = 22.0, slenderness = 40.0; /* [m], [m], [m^(1/3)] */
static const double twig = 0.002;                                                 /* [m] */
enum { SEGMENTS_MAX = 1000000, ORDERS = 7 };

/* A branch that is still to be made. */
struct bud {
    double radius, length; /* at its base; [m] */
    double at[3], along[3];
    size_t parent, order;
};

struct maker {
    uint64_t seed;
    struct bud *bud; /* a heap, the thickest first */
    size_t buds, rows, most, branches;
};

/* In 0..1. */
static double chance(struct maker *m)
{
    m->seed = m->seed * 6364136223846793005u + 1442695040888963407u;
    return (double)(m->seed >> 11) * 0x1p-53;
}

static void unit(double v[3])
{
    double size = sqrt(v[0] * v[0] + v[1] * v[1] + v[2] * v[2]);
    for (int k = 0; k < 3; k++) v[k] /= size;
}

static void push(struct maker *m, const struct bud *b)
{
    size_t i = m->buds++;
    for (; i && m->bud[(i - 1) / 2].radius < b->radius; i = (i - 1) / 2) m->bud[i] = m->bud[(i - 1) / 2];
    m->bud[i] = *b;
}

static struct bud pop(struct maker *m)
{
    struct bud top = m->bud[0], last = m->bud[--m->buds];
    size_t i = 0;
    for (size_t k; (k = 2 * i + 1) < m->buds; i = k) {
        if (k + 1 < m->buds && m->bud[k + 1].radius > m->bud[k].radius) k++;
        if (m->bud[k].radius <= last.radius) break;
        m->bud[i] = m->bud[k];
    }
    m->bud[i] = last;
    return top;
}

/* A branch that leaves another one at a place, where that is `radius` thick. */
static void fork_at(struct maker *m, const struct bud *of, const double at[3], const double along[3],
                    double radius)
{
    struct bud b = { .radius = radius * (0.3 + 0.3 * chance(m)), .parent = m->rows, .order = of->order + 1 };
    double turn = 2 * M_PI * chance(m), side[3] = { cos(turn), sin(turn), 0 }, size = 0;
    if (b.radius < twig || b.order >= ORDERS || m->buds + 1 >= m->most) return;
    for (int k = 0; k < 3; k++) size += side[k] * along[k];
    for (int k = 0; k < 3; k++) side[k] -= size * along[k];
    unit(side);
    double open = 0.7 + 0.5 * chance(m);
    for (int k = 0; k < 3; k++) {
        b.at[k] = at[k];
        b.along[k] = cos(open) * along[k] + sin(open) * side[k];
    }
    b.length = slenderness * pow(b.radius, 2.0 / 3.0) * (0.8 + 0.4 * chance(m));
    push(m, &b);
}

/* Print the cylinders of a branch; what leaves it is made later. */
static void grow(struct maker *m, const struct bud *b)
{
    size_t n = (size_t)fmax(2, b->length / fmax(0.1, 4 * b->radius)), parent = b->parent;
    double at[3] = { b->at[0], b->at[1], b->at[2] }, along[3] = { b->along[0], b->along[1], b->along[2] };
    m->branches++;
    for (size_t i = 0; i < n && m->rows < m->most; i++) {
        double s = ((double)i + 0.5) / (double)n, radius = b->radius * (1 - 0.75 * s),
               length = b->length / (double)n;
        printf("%zu,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%.6f,%zu,%zu,%zu,%zu,%zu,0\n", m->rows + 1, radius,
               length, at[0], at[1], at[2], along[0], along[1], along[2], parent,
               i + 1 < n && m->rows + 1 < m->most ? m->rows + 2 : (size_t)0, m->branches, b->order, i + 1);
        parent = ++m->rows;
        for (int k = 0; k < 3; k++) at[k] += length * along[k];
        if (s > (b->order ? 0.2 : 0.3)) fork_at(m, b, at, along, radius);
        for (int k = 0; k < 3; k++) along[k] += (b->order ? 0.25 : 0.05) * (chance(m) - 0.5);
        along[2] += b->order ? 0.03 : 0.1; /* branches rise */
        unit(along);
    }
}

int main(int argc, char **argv)
{
    long rows = argc > 1 ? strtol(argv[1], NULL, 10) : 0;
    struct maker m = { .seed = argc > 2 ? strtoull(argv[2], NULL, 10) : 1 };
    if (rows < 1 || rows > SEGMENTS_MAX || !(m.bud = calloc((size_t)rows + 1, sizeof *m.bud))) {
        fprintf(stderr, "usage: make_scan SEGMENTS [SEED]\n");
        return 2;
    }
    m.most = (size_t)rows;
    puts("id,radius_m,length_m,start_x,start_y,start_z,axis_x,axis_y,axis_z,parent,extension,branch,branch_"
         "order,"
         "pos_in_branch,added");
    push(&m, &(struct bud){ trunk_radius, trunk_height, { 0, 0, 0 }, { 0, 0, 1 }, 0, 0 });
    while (m.buds && m.rows < m.most) {
        struct bud b = pop(&m);
        grow(&m, &b);
    }
    free(m.bud);
    return m.rows == m.most ? 0 : 1;
}
