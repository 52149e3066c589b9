#include <math.h>

#include "branches_work.h"
#include "piece.h"

enum { SMOOTHINGS = 4 };

static const float TOLERANCE = 0.33f; /* cells: less than a cell's half is not the shape's but the lattice's */

/* Binomial weights, as often as the staircase needs. */
static void smooth(struct branch_point *points, int count)
{
    for (int pass = 0; pass < SMOOTHINGS; pass++) {
        struct branch_point before = points[0];
        for (int i = 1; i + 1 < count; i++) {
            struct branch_point here = points[i];
            points[i].x = 0.25f * (before.x + 2 * here.x + points[i + 1].x);
            points[i].y = 0.25f * (before.y + 2 * here.y + points[i + 1].y);
            before = here;
        }
    }
}

/* From the line a-b, or from a where the two are one. */
static float distance_to(struct branch_point a, struct branch_point b, struct branch_point point)
{
    return sqrtf(piece_square(point.x - a.x, point.y - a.y, b.x - a.x, b.y - a.y));
}

/* Marks the points that stay between two that do: Douglas and Peucker (1973), with the halves still to do kept in
 * `marks` themselves: a point that is marked is an end of the next piece. */
static void mark(const struct branch_point *points, int count, uint8_t *marks)
{
    int start = 0;
    while (start < count - 1) {
        int end = start + 1;
        while (!marks[end]) {
            end++;
        }
        int farthest = 0;
        float most = TOLERANCE;
        for (int i = start + 1; i < end; i++) {
            float distance = distance_to(points[start], points[end], points[i]);
            if (distance > most) {
                most = distance;
                farthest = i;
            }
        }
        if (farthest) {
            marks[farthest] = 1; /* and the first half of it next */
        } else {
            start = end;
        }
    }
}

int branch_simplify(struct branch_point *points, int count, uint8_t *marks)
{
    if (count < 3) {
        return count;
    }
    smooth(points, count);
    for (int i = 0; i < count; i++) {
        marks[i] = i == 0 || i == count - 1;
    }
    mark(points, count, marks);
    int kept = 0;
    for (int i = 0; i < count; i++) {
        if (marks[i]) {
            points[kept++] = points[i];
        }
    }
    return kept;
}

static void turn_around(struct branches *branches, const struct branch *branch)
{
    struct branch_point *points = branches->points + branch->first;
    for (int i = 0, j = branch->count - 1; i < j; i++, j--) {
        struct branch_point point = points[i];
        points[i] = points[j];
        points[j] = point;
    }
}

static float square_to(struct branch_point a, struct branch_point b)
{
    return (a.x - b.x) * (a.x - b.x) + (a.y - b.y) * (a.y - b.y);
}

void branches_order(struct branches *branches)
{
    struct branch_point pen = {0, 0};
    for (int i = 0; i < branches->count; i++) {
        int nearest = i;
        float least = INFINITY;
        bool around = false;
        for (int j = i; j < branches->count && least > 0; j++) {
            const struct branch *branch = &branches->list[j];
            float start = square_to(pen, branches->points[branch->first]);
            float end = square_to(pen, branches->points[branch->first + branch->count - 1]);
            if (start < least || end < least) {
                nearest = j;
                around = end < start;
                least = end < start ? end : start;
            }
        }
        struct branch next = branches->list[nearest];
        branches->list[nearest] = branches->list[i];
        branches->list[i] = next;
        if (around) {
            turn_around(branches, &next);
        }
        pen = branches->points[next.first + next.count - 1];
    }
}
