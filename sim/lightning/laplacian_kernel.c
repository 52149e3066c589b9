#include "laplacian_kernel.h"

#include <string.h>

#include "exponential.h"

#if defined(__AVX512F__)
#define KERNELS laplacian_kernels_avx512
#elif defined(__AVX2__)
#define KERNELS laplacian_kernels_avx2
#else
#define KERNELS laplacian_kernels_narrow
#endif

#define ALWAYS static inline __attribute__((always_inline))

enum { LANES = 8, STACK = 512, LEAVES = 256, LINE = 16 /* floats of a line of the cache */ };
static const float RADIUS_SQUARED = 0.25f; /* of a charge, R1 = h / 2 (section III.A) */

typedef float lanes __attribute__((vector_size(32)));
typedef int32_t marks __attribute__((vector_size(32)));

ALWAYS lanes load(const float *from)
{
    lanes value;
    memcpy(&value, from, sizeof value);
    return value;
}

ALWAYS void store(float *to, lanes value)
{
    memcpy(to, &value, sizeof value);
}

ALWAYS lanes all(float value)
{
    return (lanes){value, value, value, value, value, value, value, value};
}

ALWAYS lanes choose(marks mark, lanes yes, lanes no)
{
    return (lanes)((mark & (marks)yes) | (~mark & (marks)no));
}

/* 1 / sqrt(x) by Newton's method, relative error below 2e-7: additions and multiplications alone, the same on every
 * machine. */
ALWAYS lanes inverse_root(lanes x)
{
    marks bits = (marks)x;
    lanes y = (lanes)(0x5f375a86 - (bits >> 1)), half = x * 0.5f;
    y = y * (1.5f - half * y * y);
    y = y * (1.5f - half * y * y);
    return y * (1.5f - half * y * y);
}

ALWAYS float reduce(lanes value)
{
    return ((value[0] + value[4]) + (value[2] + value[6])) + ((value[1] + value[5]) + (value[3] + value[7]));
}

/* Bit i of the result is lane i. */
ALWAYS unsigned bits_of(marks mark)
{
    const marks powers = {1, 2, 4, 8, 16, 32, 64, 128};
    marks bits = mark & powers;
    bits |= __builtin_shufflevector(bits, bits, 4, 5, 6, 7, 0, 1, 2, 3);
    bits |= __builtin_shufflevector(bits, bits, 2, 3, 0, 1, 6, 7, 4, 5);
    bits |= __builtin_shufflevector(bits, bits, 1, 0, 3, 2, 5, 4, 7, 6);
    return (unsigned)bits[0];
}

ALWAYS lanes green_of(const float *const *places, int32_t i, int dimensions, const float *at)
{
    lanes squared = all(0);
    for (int d = 0; d < dimensions; d++) {
        lanes away = load(places[d] + i) - at[d];
        squared += away * away;
    }
    squared = choose(squared > RADIUS_SQUARED, squared, all(RADIUS_SQUARED));
    lanes inverse = inverse_root(squared), green = inverse;
    for (int d = 3; d < dimensions; d++) {
        green *= inverse;
    }
    return green;
}

ALWAYS void add_in(float *loads, const float *const *places, int32_t count, int dimensions, const float *at)
{
    for (int32_t i = 0; i < count; i += LANES) {
        store(loads + i, load(loads + i) + green_of(places, i, dimensions, at));
    }
}

static void add(float *loads, const float *const *places, int32_t count, int dimensions, const float *at)
{
    if (dimensions == 2) {
        add_in(loads, places, count, 2, at);
    } else if (dimensions == 3) {
        add_in(loads, places, count, 3, at);
    } else {
        add_in(loads, places, count, dimensions, at);
    }
}

ALWAYS marks first(int32_t count)
{
    const marks index = {0, 1, 2, 3, 4, 5, 6, 7};
    return index < count;
}

ALWAYS float sum_in(const float *const *places, int32_t count, int dimensions, const float *at)
{
    lanes sum = all(0);
    int32_t i = 0;
    for (; i + LANES <= count; i += LANES) {
        sum += green_of(places, i, dimensions, at);
    }
    if (i < count) {
        sum += (lanes)(first(count - i) & (marks)green_of(places, i, dimensions, at));
    }
    return reduce(sum);
}

static float sum(const float *const *places, int32_t count, int dimensions, const float *at)
{
    return dimensions == 2   ? sum_in(places, count, 2, at)
           : dimensions == 3 ? sum_in(places, count, 3, at)
                             : sum_in(places, count, dimensions, at);
}

static void rise(float *loads, const float *by, int32_t count)
{
    for (int32_t i = 0; i < count; i += LANES) {
        store(loads + i, load(loads + i) + load(by + i));
    }
}

static void range(const float *loads, int32_t count, float *least, float *most)
{
    lanes low = all(loads[0]), high = low;
    int32_t i = 0;
    for (; i + LANES <= count; i += LANES) {
        lanes value = load(loads + i);
        low = choose(value < low, value, low);
        high = choose(value > high, value, high);
    }
    *least = low[0];
    *most = high[0];
    for (int l = 1; l < LANES; l++) {
        *least = low[l] < *least ? low[l] : *least;
        *most = high[l] > *most ? high[l] : *most;
    }
    for (; i < count; i++) {
        *least = loads[i] < *least ? loads[i] : *least;
        *most = loads[i] > *most ? loads[i] : *most;
    }
}

/* exponential2 and logarithm2 of exponential.h, a lane each. */
ALWAYS lanes power_of(lanes x, float y)
{
    marks bits = (marks)choose(x < 1e-30f, all(1e-30f), x), shifted = bits - 0x3f3504f3;
    marks whole = shifted >> 23;
    lanes m = (lanes)(bits - (whole << 23));
    lanes s = (m - 1.0f) / (m + 1.0f), q = s * s;
    lanes p = ((all(0.41219859f) * q + 0.57707802f) * q + 0.96179669f) * q + 2.88539008f;
    lanes e = y * (__builtin_convertvector(whole, lanes) + s * p);
    e = choose(e < -126.0f, all(-126), e);
    e = choose(e > 126.0f, all(126), e);
    marks power = __builtin_convertvector(e + choose(e < 0.0f, all(-0.5f), all(0.5f)), marks);
    lanes f = e - __builtin_convertvector(power, lanes);
    p = all(1.54035304e-4f) * f + 1.33335581e-3f;
    p = p * f + 9.61812911e-3f;
    p = p * f + 5.55041087e-2f;
    p = p * f + 2.40226507e-1f;
    p = p * f + 6.93147181e-1f;
    p = p * f + 1.0f;
    lanes result = p * (lanes)((power + 127) << 23);
    return choose(x < 1e-30f, all(0), result);
}

static void weigh(const float *loads, int32_t count, const struct laplacian_weighing *weighing, float *weights)
{
    int32_t i = 0;
    for (; i + LANES <= count; i += LANES) {
        lanes base = (weighing->most - load(loads + i)) * weighing->scale;
        store(weights + i, weighing->eta == 0 ? all(1) : power_of(base, weighing->eta));
    }
    for (; i < count; i++) {
        float base = (weighing->most - loads[i]) * weighing->scale;
        weights[i] = weighing->eta == 0 ? 1 : power(base < 0 ? 0 : base, weighing->eta);
    }
}

/* Sums over boxes and charges, a lane a child. */
struct sums {
    lanes value, slope[3], bend[6];
};

/* Charges `w` at distance d, 0 where there is none. `squared` is not 0 where there is one. */
ALWAYS lanes add_charges(struct sums *sums, lanes w, const lanes *away, lanes squared, int dimensions, lanes *cubed)
{
    lanes inverse = inverse_root(squared), inverse_squared = inverse * inverse;
    lanes charge = w * inverse, force = charge * inverse_squared, bend = 3.0f * force * inverse_squared;
    sums->value += charge;
    int pair = 0;
    for (int a = 0; a < dimensions; a++) {
        sums->slope[a] += force * away[a];
        lanes along = bend * away[a];
        for (int b = a; b < dimensions; b++, pair++) {
            sums->bend[pair] += along * away[b];
        }
    }
    pair = 0;
    for (int a = 0; a < dimensions; pair += dimensions - a, a++) {
        sums->bend[pair] -= force;
    }
    *cubed = inverse * inverse_squared;
    return inverse_squared;
}

/* Half a branch: far children are added, the rest is told. */
ALWAYS unsigned add_children(struct sums *sums, const float *branch, int fan, int dimensions, const float *at,
                             float limit)
{
    lanes charge = load(branch), away[3], squared = all(0), cubed;
    for (int d = 0; d < dimensions; d++) {
        away[d] = load(branch + (1 + d) * fan) - at[d];
        squared += away[d] * away[d];
    }
    marks there = charge > 0.0f, far = squared > limit;
    lanes w = (lanes)((marks)charge & far);
    squared = choose(far, squared, all(1));
    lanes inverse_squared = add_charges(sums, w, away, squared, dimensions, &cubed);
    const float *moments = branch + (1 + dimensions) * fan;
    lanes turned = all(0), trace = all(0);
    for (int a = 0; a < dimensions; a++) {
        for (int b = a; b < dimensions; b++, moments += fan) {
            lanes moment = load(moments), part = moment * away[a] * away[b];
            turned += a == b ? part : part + part;
            trace += a == b ? moment : all(0);
        }
    }
    lanes quadrupole = (1.5f * turned * inverse_squared - 0.5f * trace) * cubed;
    sums->value += (lanes)((marks)quadrupole & far & there);
    return bits_of(there & ~far);
}

ALWAYS void add_leaf(struct sums *sums, const float *leaf, int32_t count, int dimensions, const float *at,
                     struct laplacian_field *field)
{
    for (int32_t begin = 0; begin < count; begin += LANES) {
        lanes away[3], squared = all(0), cubed;
        for (int d = 0; d < dimensions; d++) {
            away[d] = load(leaf + d * LAPLACIAN_LEAF + begin) - at[d];
            squared += away[d] * away[d];
        }
        marks there = first(count - begin);
        marks far = there & (squared > (float)(LAPLACIAN_NEAR * LAPLACIAN_NEAR));
        unsigned near = bits_of(there & ~far);
        if (near != (unsigned)bits_of(there)) {
            squared = choose(far, squared, all(1));
            add_charges(sums, (lanes)(far & (marks)all(1)), away, squared, dimensions, &cubed);
        }
        for (; near && field->near_count < LAPLACIAN_NEAR_MAX; near &= near - 1) {
            int lane = __builtin_ctz(near);
            for (int d = 0; d < dimensions; d++) {
                field->near[d][field->near_count] = leaf[d * LAPLACIAN_LEAF + begin + lane];
            }
            field->near_count++;
        }
    }
}

/* Leaves wait till their memory has come. */
ALWAYS void add_leaves(struct sums *sums, const struct laplacian_tree *tree, const int32_t *leaves,
                       const int32_t *counts, int count, int dimensions, const float *at, struct laplacian_field *field)
{
    for (int i = 0; i < count; i++) {
        add_leaf(sums, laplacian_tree_leaf(tree, leaves[i]), counts[i], dimensions, at, field);
    }
}

ALWAYS void prefetch(const float *from, int floats)
{
    for (int i = 0; i < floats; i += LINE) {
        __builtin_prefetch(from + i);
    }
}

ALWAYS void walk_in(const struct laplacian_tree *tree, const float *at, struct laplacian_field *field,
                    const int dimensions, const int fan)
{
    struct sums sums;
    memset(&sums, 0, sizeof sums);
    int32_t stack[STACK];
    uint8_t levels[STACK];
    int32_t leaves[LEAVES], counts[LEAVES];
    int depth = 1, leaf_count = 0;
    const int planes = 2 + dimensions + dimensions * (dimensions + 1) / 2;
    field->near_count = 0;
    stack[0] = tree->top;
    levels[0] = (uint8_t)tree->top_level;
    while (depth > 0) {
        const float *branch = laplacian_tree_branch(tree, stack[--depth]);
        int level = levels[depth];
        const int32_t *children = (const int32_t *)(const void *)(branch + (planes - 1) * fan);
        for (int half = 0; half < fan; half += LANES) {
            unsigned open = add_children(&sums, branch + half, fan, dimensions, at, tree->limit[level]);
            for (; open; open &= open - 1) {
                int child = half + __builtin_ctz(open);
                if (children[child] < 0) {
                    if (leaf_count == LEAVES) {
                        add_leaves(&sums, tree, leaves, counts, leaf_count, dimensions, at, field);
                        leaf_count = 0;
                    }
                    leaves[leaf_count] = ~children[child];
                    counts[leaf_count++] = (int32_t)branch[child];
                    prefetch(laplacian_tree_leaf(tree, ~children[child]), dimensions * LAPLACIAN_LEAF);
                } else {
                    stack[depth] = children[child];
                    levels[depth++] = (uint8_t)(level + 1);
                    prefetch(laplacian_tree_branch(tree, children[child]), planes * fan);
                }
            }
        }
    }
    add_leaves(&sums, tree, leaves, counts, leaf_count, dimensions, at, field);
    field->value = reduce(sums.value);
    for (int d = 0; d < dimensions; d++) {
        field->at[d] = at[d];
        field->slope[d] = reduce(sums.slope[d]);
    }
    for (int pair = 0; pair < dimensions * (dimensions + 1) / 2; pair++) {
        field->bend[pair] = reduce(sums.bend[pair]);
    }
}

static void walk(const struct laplacian_tree *tree, const float *at, struct laplacian_field *field)
{
    if (tree->dimensions == 2) {
        walk_in(tree, at, field, 2, 16);
    } else {
        walk_in(tree, at, field, 3, 8);
    }
}

static float value(const struct laplacian_field *field, int dimensions, const float *at)
{
    const float *const near[3] = {field->near[0], field->near[1], field->near[2]};
    float sum_of_far = field->value;
    int pair = 0;
    for (int a = 0; a < dimensions; a++) {
        float by = at[a] - field->at[a];
        sum_of_far += by * field->slope[a];
        for (int b = a; b < dimensions; b++, pair++) {
            sum_of_far += (a == b ? 0.5f : 1) * by * (at[b] - field->at[b]) * field->bend[pair];
        }
    }
    return sum_of_far + sum(near, field->near_count, dimensions, at);
}

const struct laplacian_kernels KERNELS = {
    .add = add,
    .sum = sum,
    .rise = rise,
    .range = range,
    .weigh = weigh,
    .walk = walk,
    .value = value,
};
