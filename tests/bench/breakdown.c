#include "breakdown.h"

#include <math.h>
#include <stdlib.h>

#include "random.h"

static const double TOLERANCE = 1e-4, MODIFIED = 0.97;
enum { FACTOR_EVERY = 32, ITERATIONS_MAX = 2000 };

struct breakdown {
    int dimensions, side, count, room;
    double eta, reach;
    uint32_t seed, draws;
    size_t cells;
    ptrdiff_t step[3];
    uint8_t *open;                     /* 1: the potential is not given there */
    float *x, *r, *z, *s, *q, *factor; /* of conjugate gradients; factor: 1 / sqrt(E) */
    int *order;                        /* cells of the aggregate */
    double *weights;
    int *sites, site_count, site_room;
    bool full;
};

static double unit(struct breakdown *breakdown)
{
    uint32_t high = random_mix(breakdown->seed * 0x9e3779b9u + 2 * breakdown->draws);
    uint32_t low = random_mix(high ^ (2 * breakdown->draws + 1));
    breakdown->draws++;
    return ((double)high + (double)low * 0x1p-32) * 0x1p-32;
}

void breakdown_cell(const struct breakdown *breakdown, int index, int cell[3])
{
    int at = breakdown->order[index];
    for (int d = 0; d < 3; d++) {
        cell[d] = d < breakdown->dimensions ? at % breakdown->side : 0;
        at /= breakdown->side;
    }
}

/* The inverse roots of the pivots of the modified incomplete factorisation. */
static void factorise(struct breakdown *breakdown)
{
    for (size_t i = 0; i < breakdown->cells; i++) {
        if (!breakdown->open[i]) {
            continue;
        }
        double pivot = 2 * breakdown->dimensions;
        for (int d = 0; d < breakdown->dimensions; d++) {
            size_t below = i - (size_t)breakdown->step[d];
            if (breakdown->open[below]) {
                double part = (double)breakdown->factor[below] * (double)breakdown->factor[below];
                int others = -1;
                for (int e = 0; e < breakdown->dimensions; e++) {
                    others += breakdown->open[below + (size_t)breakdown->step[e]];
                }
                pivot -= part * (1 + MODIFIED * others);
            }
        }
        pivot = pivot < 0.25 * 2 * breakdown->dimensions ? 2 * breakdown->dimensions : pivot;
        breakdown->factor[i] = (float)(1 / sqrt(pivot));
    }
}

/* z from r by two substitutions. Cells that have joined since the factorisation are kept out. */
static void precondition(struct breakdown *breakdown)
{
    const float *factor = breakdown->factor;
    float *q = breakdown->q, *z = breakdown->z;
    int dimensions = breakdown->dimensions;
    for (size_t i = 0; i < breakdown->cells; i++) {
        if (breakdown->open[i]) {
            float sum = breakdown->r[i];
            for (int d = 0; d < dimensions; d++) {
                size_t below = i - (size_t)breakdown->step[d];
                sum += factor[below] * q[below]; /* q is 0 where the potential is given */
            }
            q[i] = sum * factor[i];
        }
    }
    for (size_t i = breakdown->cells; i-- > 0;) {
        if (breakdown->open[i]) {
            float sum = q[i];
            for (int d = 0; d < dimensions; d++) {
                sum += factor[i] * z[i + (size_t)breakdown->step[d]];
            }
            z[i] = sum * factor[i];
        }
    }
}

/* q = A s; returns s q. Cells whose potential is given have s = 0. */
static double multiply(struct breakdown *breakdown)
{
    const float *s = breakdown->s;
    double product = 0;
    int dimensions = breakdown->dimensions;
    for (size_t i = 0; i < breakdown->cells; i++) {
        if (breakdown->open[i]) {
            float sum = (float)(2 * dimensions) * s[i];
            for (int d = 0; d < dimensions; d++) {
                sum -= s[i - (size_t)breakdown->step[d]] + s[i + (size_t)breakdown->step[d]];
            }
            breakdown->q[i] = sum;
            product += (double)(s[i] * sum);
        }
    }
    return product;
}

static double find_residual(struct breakdown *breakdown)
{
    double most = 0;
    for (size_t i = 0; i < breakdown->cells; i++) {
        if (breakdown->open[i]) {
            float sum = -(float)(2 * breakdown->dimensions) * breakdown->x[i];
            for (int d = 0; d < breakdown->dimensions; d++) {
                sum += breakdown->x[i - (size_t)breakdown->step[d]] + breakdown->x[i + (size_t)breakdown->step[d]];
            }
            breakdown->r[i] = sum;
            most = fmax(most, (double)fabsf(sum));
        }
    }
    return most;
}

static double product_of(const struct breakdown *breakdown)
{
    double sum = 0;
    for (size_t i = 0; i < breakdown->cells; i++) {
        sum += (double)(breakdown->r[i] * breakdown->z[i]);
    }
    return sum;
}

static void solve(struct breakdown *breakdown)
{
    if (find_residual(breakdown) <= TOLERANCE) {
        return;
    }
    precondition(breakdown);
    double old = product_of(breakdown), most = 1;
    for (size_t i = 0; i < breakdown->cells; i++) {
        breakdown->s[i] = breakdown->z[i];
    }
    for (int iteration = 0; iteration < ITERATIONS_MAX && most > TOLERANCE; iteration++) {
        float alpha = (float)(old / multiply(breakdown));
        most = 0;
        for (size_t i = 0; i < breakdown->cells; i++) {
            breakdown->x[i] += alpha * breakdown->s[i];
            breakdown->r[i] -= alpha * breakdown->q[i];
            most = fmax(most, (double)fabsf(breakdown->r[i]));
        }
        if (most > TOLERANCE) {
            precondition(breakdown);
            double now = product_of(breakdown);
            float beta = (float)(now / old);
            old = now;
            for (size_t i = 0; i < breakdown->cells; i++) {
                breakdown->s[i] = breakdown->z[i] + beta * breakdown->s[i];
            }
        }
    }
}

double breakdown_settle(struct breakdown *breakdown)
{
    factorise(breakdown);
    solve(breakdown);
    return find_residual(breakdown);
}

static void add_site(struct breakdown *breakdown, size_t cell)
{
    if (breakdown->open[cell] != 1) {
        return;
    }
    if (breakdown->site_count == breakdown->site_room) {
        int room = 2 * breakdown->site_room + 256;
        int *sites = realloc(breakdown->sites, (size_t)room * sizeof *sites);
        double *weights = realloc(breakdown->weights, (size_t)room * sizeof *weights);
        breakdown->sites = sites ? sites : breakdown->sites;
        breakdown->weights = weights ? weights : breakdown->weights;
        breakdown->full = breakdown->full || !sites || !weights;
        breakdown->site_room = breakdown->full ? breakdown->site_room : room;
    }
    for (int i = 0; i < breakdown->site_count; i++) {
        if (breakdown->sites[i] == (int)cell) {
            return;
        }
    }
    if (!breakdown->full) {
        breakdown->sites[breakdown->site_count++] = (int)cell;
    }
}

static void join(struct breakdown *breakdown, size_t cell)
{
    int where[3];
    double squared = 0;
    breakdown->order[breakdown->count++] = (int)cell;
    breakdown->open[cell] = 0;
    /* All that conjugate gradients know of the cell goes: else it would leak back by the substitutions. */
    breakdown->x[cell] = breakdown->r[cell] = breakdown->z[cell] = breakdown->s[cell] = breakdown->q[cell] = 0;
    for (int d = 0; d < breakdown->dimensions; d++) {
        add_site(breakdown, cell - (size_t)breakdown->step[d]);
        add_site(breakdown, cell + (size_t)breakdown->step[d]);
    }
    breakdown_cell(breakdown, breakdown->count - 1, where);
    for (int d = 0; d < breakdown->dimensions; d++) {
        double by = where[d] - breakdown->side / 2;
        squared += by * by;
    }
    breakdown->full =
        breakdown->full || breakdown->count == breakdown->room || squared > breakdown->reach * breakdown->reach;
}

struct breakdown *breakdown_create(int dimensions, int side, double eta, uint32_t seed)
{
    struct breakdown *b = calloc(1, sizeof *b);
    if (!b) {
        return NULL;
    }
    *b = (struct breakdown){.dimensions = dimensions, .side = side, .eta = eta, .seed = seed, .reach = 0.4 * side};
    b->cells = 1;
    for (int d = 0; d < dimensions; d++) {
        b->step[d] = (ptrdiff_t)b->cells;
        b->cells *= (size_t)side;
    }
    b->room = (int)b->cells;
    float **planes[] = {&b->x, &b->r, &b->z, &b->s, &b->q, &b->factor};
    bool good = (b->open = calloc(b->cells, 1)) && (b->order = malloc((size_t)b->room * sizeof *b->order));
    for (size_t i = 0; i < sizeof planes / sizeof planes[0] && good; i++) {
        *planes[i] = calloc(b->cells, sizeof(float));
        good = *planes[i];
    }
    if (!good) {
        breakdown_destroy(b);
        return NULL;
    }
    double radius = 0.5 * side - 1;
    for (size_t i = 0; i < b->cells; i++) {
        double squared = 0;
        size_t rest = i;
        for (int d = 0; d < dimensions; d++) {
            double by = (double)(rest % (size_t)side) - side / 2;
            squared += by * by;
            rest /= (size_t)side;
        }
        b->open[i] = squared < radius * radius;
        b->x[i] = 1;
    }
    size_t middle = 0;
    for (int d = 0; d < dimensions; d++) {
        middle += (size_t)(side / 2) * (size_t)b->step[d];
    }
    join(b, middle);
    return b;
}

void breakdown_destroy(struct breakdown *breakdown)
{
    if (breakdown) {
        free(breakdown->open);
        free(breakdown->x);
        free(breakdown->r);
        free(breakdown->z);
        free(breakdown->s);
        free(breakdown->q);
        free(breakdown->factor);
        free(breakdown->order);
        free(breakdown->sites);
        free(breakdown->weights);
        free(breakdown);
    }
}

bool breakdown_step(struct breakdown *breakdown)
{
    if (breakdown->full) {
        return false;
    }
    if ((breakdown->count - 1) % FACTOR_EVERY == 0) {
        factorise(breakdown);
    }
    solve(breakdown);
    double total = 0;
    for (int i = 0; i < breakdown->site_count; i++) {
        double potential = (double)breakdown->x[breakdown->sites[i]];
        breakdown->weights[i] = pow(potential > 0 ? potential : 0, breakdown->eta);
        total += breakdown->weights[i];
    }
    double left = unit(breakdown) * total;
    int chosen = 0;
    while (chosen + 1 < breakdown->site_count && left >= breakdown->weights[chosen]) {
        left -= breakdown->weights[chosen++];
    }
    size_t cell = (size_t)breakdown->sites[chosen];
    breakdown->sites[chosen] = breakdown->sites[--breakdown->site_count];
    join(breakdown, cell);
    return true;
}

int breakdown_count(const struct breakdown *breakdown)
{
    return breakdown->count;
}

size_t breakdown_bytes(const struct breakdown *breakdown)
{
    return breakdown->cells * (6 * sizeof(float) + 1);
}
