#include "grow/qsm_joint.h"
#include <math.h>

static const double POINT = 1e-3; /* [m] */

double wf_joint_tolerance(double radius) { return fmax(POINT, 0.1 * radius); }

static double apart(const double a[3], const double b[3])
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

static void copy(double to[3], const double from[3])
{
    for (int k = 0; k < 3; k++) to[k] = from[k];
}

/* A lateral: the point of the parent's axis nearest to its start; near the parent's ends these. */
static void lateral(const struct wf_qsm *q, size_t p, const struct wf_hold_row *parent, const double start[3],
                    struct wf_hold_row *h)
{
    double end[3] = { q->x1[p], q->y1[p], q->z1[p] }, axis[3], from[3], dot = 0, length2 = 0;
    for (int k = 0; k < 3; k++) {
        axis[k] = end[k] - parent->base[k];
        from[k] = start[k] - parent->base[k];
        dot += axis[k] * from[k];
        length2 += axis[k] * axis[k];
    }
    double length = sqrt(length2), s = length > 0 ? fmin(fmax(dot / length2, 0), 1) : 1;
    h->radius = q->r0[p] + s * (q->r1[p] - q->r0[p]);
    double tolerance = wf_joint_tolerance(h->radius);
    h->at = WF_HOLD_AXIS;
    if ((1 - s) * length <= tolerance)
        h->at = WF_HOLD_END, s = 1;
    else if (s * length <= tolerance) {
        /* a branch from the very base: the ground cannot hold it, the stem just above can */
        if (parent->at != WF_HOLD_GROUND)
            h->at = WF_HOLD_BASE, s = 0;
        else
            s = tolerance / length;
    }
    h->share = s;
    double point[3];
    for (int k = 0; k < 3; k++) point[k] = parent->base[k] + s * axis[k];
    h->gap = apart(start, point);
    h->straight = h->gap <= tolerance;
    copy(h->base, h->straight ? point : start);
}

void wf_joint_find(const struct wf_qsm *q, enum wf_joint joint, struct wf_hold_row *hold)
{
    for (size_t i = 0; i < q->n; i++) {
        struct wf_hold_row *h = &hold[i];
        double start[3] = { q->x0[i], q->y0[i], q->z0[i] };
        *h = (struct wf_hold_row){ .at = WF_HOLD_GROUND, .share = 1, .straight = true };
        if (q->parent[i] < 0) {
            copy(h->base, start);
            continue;
        }
        size_t p = (size_t)q->parent[i];
        double end[3] = { q->x1[p], q->y1[p], q->z1[p] };
        bool goes_on = q->next[p] == (int32_t)i;
        lateral(q, p, &hold[p], start, h);
        if (joint == WF_JOINT_AXIS && !(goes_on && (h->at == WF_HOLD_END || apart(start, end) <= q->r1[p])))
            continue;
        h->at = WF_HOLD_END, h->share = 1, h->radius = q->r1[p];
        h->gap = apart(start, end);
        h->straight = true;
        copy(h->base, end);
    }
}
