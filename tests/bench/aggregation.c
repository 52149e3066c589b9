#include "aggregation.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"

static const double PI = 3.14159265358979323846, TOUCH = 1.02, LAUNCH = 3;
enum { LEVELS = 7 /* of cells of 2, 4, 8 ... */ };

struct aggregation {
    int dimensions, count, room, side; /* side: cells of 2 along a side of the grid, a power of two */
    uint32_t seed;
    uint64_t draws;
    double radius; /* of the aggregate */
    double (*places)[3];
    int *first, *next;      /* particles of a cell */
    uint8_t *taken[LEVELS]; /* of cells of 2 << level */
};

static double unit(struct aggregation *aggregation)
{
    uint64_t draw = aggregation->draws++;
    uint32_t high = random_mix((uint32_t)draw * 0x9e3779b9u + aggregation->seed + (uint32_t)(draw >> 32));
    uint32_t low = random_mix(high ^ (uint32_t)draw);
    return ((double)high + (double)low * 0x1p-32) * 0x1p-32;
}

struct aggregation *aggregation_create(int dimensions, int particles, uint32_t seed)
{
    struct aggregation *a = calloc(1, sizeof *a);
    if (!a) {
        return NULL;
    }
    double reach = pow((double)particles, dimensions == 2 ? 1 / 1.71 : 1 / 2.5) * 1.6 + 16;
    a->dimensions = dimensions;
    a->room = particles;
    a->seed = seed;
    for (a->side = 1 << LEVELS; a->side < (int)reach; a->side *= 2) {
    }
    size_t cells = (size_t)a->side * (size_t)a->side * (dimensions == 3 ? (size_t)a->side : 1);
    a->places = malloc((size_t)particles * sizeof *a->places);
    a->next = malloc((size_t)particles * sizeof *a->next);
    a->first = malloc(cells * sizeof *a->first);
    bool good = a->places && a->next && a->first;
    for (int level = 0; level < LEVELS && good; level++) {
        a->taken[level] = calloc(cells >> level * dimensions, 1);
        good = a->taken[level];
    }
    if (!good) {
        aggregation_destroy(a);
        return NULL;
    }
    memset(a->first, -1, cells * sizeof *a->first);
    return a;
}

void aggregation_destroy(struct aggregation *aggregation)
{
    if (aggregation) {
        for (int level = 0; level < LEVELS; level++) {
            free(aggregation->taken[level]);
        }
        free(aggregation->places);
        free(aggregation->next);
        free(aggregation->first);
        free(aggregation);
    }
}

static void cell_of(const struct aggregation *aggregation, const double *at, int level, int cell[3])
{
    for (int d = 0; d < 3; d++) {
        cell[d] = d < aggregation->dimensions ? ((int)floor(at[d] / 2) + aggregation->side / 2) >> level : 0;
    }
}

static size_t index_of(const struct aggregation *aggregation, const int cell[3], int level)
{
    size_t side = (size_t)(aggregation->side >> level);
    return ((size_t)cell[2] * side + (size_t)cell[1]) * side + (size_t)cell[0];
}

static void put(struct aggregation *aggregation, const double *at)
{
    int cell[3], particle = aggregation->count++;
    memcpy(aggregation->places[particle], at, sizeof aggregation->places[particle]);
    for (int level = 0; level < LEVELS; level++) {
        cell_of(aggregation, at, level, cell);
        aggregation->taken[level][index_of(aggregation, cell, level)] = 1;
    }
    cell_of(aggregation, at, 0, cell);
    size_t index = index_of(aggregation, cell, 0);
    aggregation->next[particle] = aggregation->first[index];
    aggregation->first[index] = particle;
    double far = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]);
    aggregation->radius = far > aggregation->radius ? far : aggregation->radius;
}

/* Whether something is in a cell of a level or beside it; the nearest particle, of level 0. */
static bool look(const struct aggregation *aggregation, const double *at, int level, double *nearest)
{
    int middle[3], cell[3], side = aggregation->side >> level, flat = aggregation->dimensions == 2;
    bool found = false;
    cell_of(aggregation, at, level, middle);
    for (int k = flat ? 0 : -1; k <= !flat; k++) {
        for (int j = -1; j <= 1; j++) {
            for (int i = -1; i <= 1; i++) {
                cell[0] = middle[0] + i;
                cell[1] = middle[1] + j;
                cell[2] = middle[2] + k;
                if (cell[0] < 0 || cell[1] < 0 || cell[2] < 0 || cell[0] >= side || cell[1] >= side ||
                    cell[2] >= side || !aggregation->taken[level][index_of(aggregation, cell, level)]) {
                    continue;
                }
                found = true;
                for (int p = level > 0 ? -1 : aggregation->first[index_of(aggregation, cell, 0)]; p >= 0;
                     p = aggregation->next[p]) {
                    const double *place = aggregation->places[p];
                    double x = place[0] - at[0], y = place[1] - at[1], z = place[2] - at[2];
                    *nearest = fmin(*nearest, sqrt(x * x + y * y + z * z));
                }
            }
        }
    }
    return found;
}

/* How far a walker may go without touching, and 0 where it touches. */
static double room_around(const struct aggregation *aggregation, const double *at)
{
    double nearest = 3; /* all that is nearer lies in a cell beside this one, or the two are a diameter apart */
    if (look(aggregation, at, 0, &nearest)) {
        nearest = nearest < 2 ? nearest : 2;
        return nearest <= TOUCH ? 0 : nearest - 1;
    }
    int level = 1;
    while (level < LEVELS && !look(aggregation, at, level, &nearest)) {
        level++;
    }
    return (double)(2 << (level - 1)) - 1;
}

static void direction(struct aggregation *aggregation, double way[3])
{
    double angle = 2 * PI * unit(aggregation), height = aggregation->dimensions == 3 ? 2 * unit(aggregation) - 1 : 0;
    double wide = sqrt(1 - height * height);
    way[0] = wide * cos(angle);
    way[1] = wide * sin(angle);
    way[2] = height;
}

/* From outside to where it first comes to the sphere of launch: the Poisson kernel. False where it never does. */
static bool come_back(struct aggregation *aggregation, double at[3], double far, double launch)
{
    double ratio = launch / far, way[3], cosine, u = unit(aggregation);
    if (aggregation->dimensions == 3 && unit(aggregation) > ratio) {
        return false;
    }
    for (int d = 0; d < 3; d++) {
        at[d] /= far;
    }
    if (aggregation->dimensions == 2) {
        double angle = 2 * atan((1 - ratio) / (1 + ratio) * tan(PI * (u - 0.5)));
        double x = at[0] * cos(angle) - at[1] * sin(angle), y = at[0] * sin(angle) + at[1] * cos(angle);
        at[0] = launch * x;
        at[1] = launch * y;
        return true;
    }
    double part = (1 - ratio * ratio) / (1 - ratio + 2 * ratio * u);
    cosine = (1 + ratio * ratio - part * part) / (2 * ratio);
    double length = 0;
    while (length < 1e-6) { /* any direction across */
        direction(aggregation, way);
        double along = way[0] * at[0] + way[1] * at[1] + way[2] * at[2];
        for (int d = 0; d < 3; d++) {
            way[d] -= along * at[d];
        }
        length = sqrt(way[0] * way[0] + way[1] * way[1] + way[2] * way[2]);
    }
    double sine = sqrt(fmax(0, 1 - cosine * cosine));
    for (int d = 0; d < 3; d++) {
        at[d] = launch * (cosine * at[d] + sine * way[d] / length);
    }
    return true;
}

bool aggregation_step(struct aggregation *aggregation)
{
    double at[3] = {0}, way[3], launch = aggregation->radius + LAUNCH;
    if (aggregation->count == 0) {
        put(aggregation, at);
        return true;
    }
    if (aggregation->count == aggregation->room || launch + 2 > aggregation->side) {
        return false;
    }
    bool launched = false;
    for (;;) {
        if (!launched) {
            direction(aggregation, at);
            for (int d = 0; d < 3; d++) {
                at[d] *= launch;
            }
            launched = true;
        }
        double far = sqrt(at[0] * at[0] + at[1] * at[1] + at[2] * at[2]), jump;
        if (far > launch * 1.0001) {
            launched = come_back(aggregation, at, far, launch);
            continue;
        }
        jump = room_around(aggregation, at);
        if (jump == 0) {
            put(aggregation, at);
            return true;
        }
        direction(aggregation, way);
        for (int d = 0; d < 3; d++) {
            at[d] += jump * way[d];
        }
    }
}

int aggregation_count(const struct aggregation *aggregation)
{
    return aggregation->count;
}

const double *aggregation_place(const struct aggregation *aggregation, int index)
{
    return aggregation->places[index];
}
