#include "first_passage.h"

#include <float.h>
#include <stdlib.h>

#define DIAGONAL 1.41421356f

struct visit {
    float time;
    int cell;
};

/* A binary heap of cells to come; the earliest on top, of equals the lower cell. */
struct heap {
    struct visit *visits;
    size_t count, room;
};

static bool is_before(const struct visit *a, const struct visit *b)
{
    return a->time < b->time || (!(b->time < a->time) && a->cell < b->cell);
}

static bool push(struct heap *heap, struct visit visit)
{
    if (heap->count == heap->room) {
        size_t room = 2 * heap->room + 1024;
        struct visit *visits = realloc(heap->visits, room * sizeof *visits);
        if (!visits) {
            return false;
        }
        heap->visits = visits;
        heap->room = room;
    }
    size_t at = heap->count++;
    while (at > 0 && is_before(&visit, &heap->visits[(at - 1) / 2])) {
        heap->visits[at] = heap->visits[(at - 1) / 2];
        at = (at - 1) / 2;
    }
    heap->visits[at] = visit;
    return true;
}

static struct visit pop(struct heap *heap)
{
    struct visit top = heap->visits[0], last = heap->visits[--heap->count];
    size_t at = 0, child;
    while ((child = 2 * at + 1) < heap->count) {
        child += child + 1 < heap->count && is_before(&heap->visits[child + 1], &heap->visits[child]);
        if (!is_before(&heap->visits[child], &last)) {
            break;
        }
        heap->visits[at] = heap->visits[child];
        at = child;
    }
    heap->visits[at] = last;
    return top;
}

struct front {
    int width, height;
    const float *slowness;
    float *time;
    struct heap heap;
};

static bool spread(struct front *front, struct visit from)
{
    int x = from.cell % front->width, y = from.cell / front->width;
    for (int k = 0; k < 9; k++) {
        int dx = k % 3 - 1, dy = k / 3 - 1, to = from.cell + dy * front->width + dx;
        if (k == 4 || x + dx < 0 || x + dx >= front->width || y + dy < 0 || y + dy >= front->height) {
            continue;
        }
        float step = 0.5f * (front->slowness[from.cell] + front->slowness[to]) * (dx && dy ? DIAGONAL : 1.0f);
        if (from.time + step < front->time[to]) {
            front->time[to] = from.time + step;
            if (!push(&front->heap, (struct visit){front->time[to], to})) {
                return false;
            }
        }
    }
    return true;
}

bool first_passage(int width, int height, const float *slowness, float *arrival)
{
    size_t cells = (size_t)width * (size_t)height;
    struct front front = {.width = width, .height = height, .slowness = slowness};
    bool good = (front.time = malloc(cells * sizeof *front.time));
    for (size_t i = 0; i < cells && good; i++) {
        front.time[i] = arrival[i];
        good = !(arrival[i] < FLT_MAX) || push(&front.heap, (struct visit){arrival[i], (int)i});
    }
    while (good && front.heap.count > 0) {
        struct visit visit = pop(&front.heap);
        good = visit.time > front.time[visit.cell] || spread(&front, visit);
    }
    for (size_t i = 0; i < cells && good; i++) {
        arrival[i] = front.time[i];
    }
    free(front.heap.visits);
    free(front.time);
    return good;
}
