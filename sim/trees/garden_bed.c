/* What a garden grows in: the picture on the lattice of the sheet. */
#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "garden_state.h"
#include "memory.h"
#include "noise.h"
#include "picture_resample.h"

enum { SIDES_MOST = 2 /* sheet's longer side over the picture's, in nodes */ };

static const float LEAN_MOST = 1.5f;
static const float FADE = 0.15f; /* of the picture's shorter side: over which importance goes at its borders */

static int at_least(float value, int least)
{
    int whole = (int)(value + 0.5f);
    return whole > least ? whole : least;
}

/* The lattice: the picture's longer side has `detail` nodes, unless the sheet would have too many. */
static void size_bed(const struct garden *garden, struct bed *bed)
{
    float sheet = (float)garden->def.width / (float)garden->def.height;
    float shape = (float)garden->stock_width / (float)garden->stock_height;
    float wide = shape < sheet ? shape / sheet : 1, high = shape < sheet ? 1 : sheet / shape; /* of the sheet */
    float detail = (float)garden->def.detail, most = (float)(SIDES_MOST * garden->def.detail);
    float width = shape >= 1 ? detail : detail * shape, height = shape >= 1 ? detail / shape : detail;
    float longest = width / wide > height / high ? width / wide : height / high;
    float less = longest > most ? most / longest : 1;
    bed->width = at_least(less * width / wide, GROWTH_SIZE_LEAST);
    bed->height = at_least(less * height / high, GROWTH_SIZE_LEAST);
    int own_width = at_least(less * width, GROWTH_SIZE_LEAST), own_height = at_least(less * height, GROWTH_SIZE_LEAST);
    own_width = own_width < bed->width ? own_width : bed->width;
    own_height = own_height < bed->height ? own_height : bed->height;
    bed->picture.x0 = (bed->width - own_width) / 2;
    bed->picture.x1 = bed->picture.x0 + own_width;
    bed->picture.y0 = (bed->height - own_height) / 2;
    bed->picture.y1 = bed->picture.y0 + own_height;
    bed->unit = (float)(own_width > own_height ? own_width : own_height) / GARDEN_DETAIL;
}

void garden_bed_destroy(struct bed *bed)
{
    if (bed) {
        dendrite_destroy(bed->dendrite);
        stipple_destroy(bed->stipple);
        routes_destroy(bed->routes);
        routes_destroy(bed->near);
        lattice_destroy(bed->walled);
        lattice_destroy(bed->open);
        lattice_destroy(bed->base);
        importance_destroy(bed->importance);
        importance_destroy(bed->tended);
        free(bed->full);
        free(bed->spare);
        free(bed->faded);
        free(bed->roots);
        free(bed->uneven);
        free(bed->owner);
        free(bed->birth);
        free(bed->left);
        free(bed->washed);
        free(bed);
    }
}

static struct importance *plain(int width, int height, float value)
{
    size_t nodes = (size_t)width * (size_t)height, bytes = 0;
    struct importance *importance = calloc(1, sizeof *importance);
    float *values = memory_take(nodes, sizeof *values, &bytes);
    if (!importance || !values) {
        free(importance);
        free(values);
        return NULL;
    }
    for (size_t i = 0; i < nodes; i++) {
        values[i] = value;
    }
    *importance = (struct importance){width, height, values};
    return importance;
}

static bool make_lattices(struct bed *bed)
{
    struct lattice_def def = lattice_default_def();
    bed->base = lattice_create(bed->importance, &def, NULL, NULL);
    bed->open = lattice_create(bed->importance, &def, NULL, NULL);
    bed->walled = lattice_create(bed->importance, &def, NULL, NULL);
    if (!bed->base || !bed->open || !bed->walled) {
        return false;
    }
    bed->near = routes_create(bed->open);
    bed->routes = routes_create(bed->walled);
    bed->stipple = stipple_create(bed->base);
    bed->dendrite = dendrite_create(bed->base);
    return bed->near && bed->routes && bed->stipple && bed->dendrite;
}

/* Where stems go this way rather than that, all else being equal. */
static void make_uneven(struct bed *bed)
{
    float size = 14 * bed->unit > 2 ? 14 * bed->unit : 2;
    for (int y = 0; y < bed->height; y++) {
        for (int x = 0; x < bed->width; x++) {
            float value = 0.55f * noise_smooth((float)x, (float)y, size, 62, RANDOM_SMOOTH) +
                          0.3f * random_signed(x, y, 62, RANDOM_LATTICE);
            value = value > -0.8f ? value < 0.9f ? value : 0.9f : -0.8f;
            bed->uneven[lattice_node(bed->base, x, y)] = (uint8_t)((1 + value) * GARDEN_EVEN);
        }
    }
}

static struct bed *bed_create(const struct garden *garden)
{
    struct bed *bed = calloc(1, sizeof *bed);
    if (!bed) {
        return NULL;
    }
    size_bed(garden, bed);
    bed->importance = plain(bed->width, bed->height, 0);
    bed->tended = plain(bed->width, bed->height, 0.5f);
    if (!bed->importance || !bed->tended || !make_lattices(bed)) {
        garden_bed_destroy(bed);
        return NULL;
    }
    size_t nodes = (size_t)bed->base->nodes, bytes = 0;
    bed->faded = memory_take((size_t)bed->width * (size_t)bed->height, sizeof *bed->faded, &bytes);
    bed->full = memory_take(nodes, sizeof *bed->full, &bytes);
    bed->spare = memory_take(nodes, sizeof *bed->spare, &bytes);
    bed->uneven = memory_take(nodes, sizeof *bed->uneven, &bytes);
    bed->roots = memory_take(nodes, sizeof *bed->roots, &bytes);
    bed->owner = memory_take(nodes, sizeof *bed->owner, &bytes);
    bed->birth = memory_take(nodes, sizeof *bed->birth, &bytes);
    bed->left = memory_take(nodes, sizeof *bed->left, &bytes);
    bed->washed = memory_take(nodes, sizeof *bed->washed, &bytes);
    if (!bed->faded || !bed->full || !bed->spare || !bed->roots || !bed->uneven || !bed->owner || !bed->birth ||
        !bed->left || !bed->washed) {
        garden_bed_destroy(bed);
        return NULL;
    }
    make_uneven(bed);
    for (size_t i = 0; i < nodes; i++) {
        bed->birth[i] = FLT_MAX;
        bed->left[i] = 1;
        bed->washed[i] = -FLT_MAX;
    }
    return bed;
}

struct point garden_node_place(const struct garden *garden, struct point at)
{
    return (struct point){at.x * (float)garden->bed->width - 0.5f, at.y * (float)garden->bed->height - 0.5f};
}

float garden_node_scale(const struct garden *garden)
{
    return (float)garden->bed->width / (float)garden->def.width;
}

bool garden_bed_ready(struct garden *garden)
{
    if (!garden->stock || !(garden->work & WORK_BED)) {
        return garden->stock;
    }
    struct bed *bed = bed_create(garden);
    struct bed *before = garden->bed;
    if (bed) {
        garden->bed = bed;
        if (garden_weigh(garden, WORK_IMPORTANCE)) {
            garden_bed_destroy(before);
            garden->tended = (struct rectangle){0, 0, 0, 0};
            garden->work = WORK_STIPPLE | WORK_METRIC;
            return true;
        }
        garden->bed = before;
        garden_bed_destroy(bed);
    }
    return false;
}

/* The stock, fitted to width * height; NULL when memory is short. */
static float *fit_stock(const struct garden *garden, int width, int height)
{
    int rows = garden->stock_height;
    struct resample across = {0}, down = {0};
    float *narrow = malloc((size_t)width * (size_t)rows * sizeof *narrow);
    float *fitted = malloc((size_t)width * (size_t)height * sizeof *fitted);
    float *in = malloc((size_t)rows * sizeof *in), *out = malloc((size_t)height * sizeof *out);
    bool good = narrow && fitted && in && out &&
                resample_init(&across, garden->stock_width, width, 1.0f / 3, 1.0f / 3) &&
                resample_init(&down, rows, height, 1.0f / 3, 1.0f / 3);
    for (int y = 0; y < rows && good; y++) {
        resample_row(&across, garden->stock + (size_t)y * (size_t)garden->stock_width,
                     narrow + (size_t)y * (size_t)width);
    }
    for (int x = 0; x < width && good; x++) {
        for (int y = 0; y < rows; y++) {
            in[y] = narrow[(size_t)y * (size_t)width + (size_t)x];
        }
        resample_row(&down, in, out);
        for (int y = 0; y < height; y++) {
            float grey = out[y] > 0 ? out[y] : 0; /* the kernel overshoots */
            fitted[(size_t)y * (size_t)width + (size_t)x] = grey < 1 ? grey : 1;
        }
    }
    resample_finish(&across);
    resample_finish(&down);
    free(in);
    free(out);
    free(narrow);
    if (!good) {
        free(fitted);
        fitted = NULL;
    }
    return fitted;
}

/* Where the picture ends within the sheet it ends unevenly, or its frame would be drawn. */
static float fade(const struct bed *bed, int x, int y)
{
    const struct rectangle *picture = &bed->picture;
    int width = picture->x1 - picture->x0, height = picture->y1 - picture->y0;
    int across = x - picture->x0 < picture->x1 - 1 - x ? x - picture->x0 : picture->x1 - 1 - x;
    int down = y - picture->y0 < picture->y1 - 1 - y ? y - picture->y0 : picture->y1 - 1 - y;
    float wide = FADE * (float)(width < height ? width : height), near = wide;
    if (width < bed->width) {
        near = (float)across < near ? (float)across : near;
    }
    if (height < bed->height) {
        near = (float)down < near ? (float)down : near;
    }
    if (near >= wide) {
        return 1;
    }
    float uneven = 0.35f * noise_smooth((float)x, (float)y, 40 * bed->unit, 61, RANDOM_SMOOTH);
    float t = 1.35f * near / wide - 0.35f + uneven;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    return t * t * (3 - 2 * t);
}

static bool weigh_picture(struct garden *garden)
{
    struct bed *bed = garden->bed;
    const struct growth_def *def = &garden->def.growth;
    const struct rectangle *picture = &bed->picture;
    int width = picture->x1 - picture->x0, height = picture->y1 - picture->y0;
    struct importance_def weights = {def->gradient, def->intensity, def->blur * bed->unit, def->light};
    if (weights.gradient + weights.intensity <= 0) {
        weights.intensity = 1;
    }
    float *grey = fit_stock(garden, width, height);
    struct importance *own = grey ? importance_create(grey, width, height, &weights) : NULL;
    free(grey);
    for (int y = 0; y < height && own; y++) {
        for (int x = 0; x < width; x++) {
            bed->faded[(size_t)(picture->y0 + y) * (size_t)bed->width + (size_t)(picture->x0 + x)] =
                own->values[(size_t)y * (size_t)width + (size_t)x] * fade(bed, picture->x0 + x, picture->y0 + y);
        }
    }
    bool good = own;
    importance_destroy(own);
    return good;
}

/* The picture's importance and what was added to it. */
static void sum_up(struct bed *bed, struct rectangle within)
{
    for (int y = within.y0; y < within.y1; y++) {
        for (int x = within.x0; x < within.x1; x++) {
            size_t i = (size_t)y * (size_t)bed->width + (size_t)x;
            float value = bed->faded[i] + 2 * (bed->tended->values[i] - 0.5f);
            bed->importance->values[i] = value > 0 ? value < 1 ? value : 1 : 0;
        }
    }
}

struct rectangle garden_tend(struct bed *bed, const struct point *points, int count, float radius, float amount)
{
    struct rectangle touched = importance_stroke(bed->tended, points, count, radius, 0.5f * amount);
    const struct rectangle *picture = &bed->picture;
    touched.x0 = touched.x0 > picture->x0 ? touched.x0 : picture->x0;
    touched.x1 = touched.x1 < picture->x1 ? touched.x1 : picture->x1;
    touched.y0 = touched.y0 > picture->y0 ? touched.y0 : picture->y0;
    touched.y1 = touched.y1 < picture->y1 ? touched.y1 : picture->y1;
    if (!rectangle_is_empty(touched)) {
        sum_up(bed, touched);
    }
    return touched;
}

bool garden_untend(struct bed *bed)
{
    size_t nodes = (size_t)bed->width * (size_t)bed->height;
    bool any = false;
    for (size_t i = 0; i < nodes; i++) {
        any = any || bed->tended->values[i] < 0.5f || bed->tended->values[i] > 0.5f;
        bed->tended->values[i] = 0.5f;
    }
    return any;
}

static void weigh_lattice(struct garden *garden)
{
    struct bed *bed = garden->bed;
    struct lattice *base = bed->base;
    struct growth_def growth = garden->def.growth;
    growth.upward = growth.upward < LEAN_MOST ? growth.upward : LEAN_MOST; /* also from a seed at the lower border */
    struct lattice_def def = growth_lattice_def(&growth);
    for (int y = 0; y < bed->height; y++) {
        for (int x = 0; x < bed->width; x++) {
            base->weight[lattice_node(base, x, y)] = 1; /* no wall */
        }
    }
    lattice_weigh(base, bed->importance, &def, (struct rectangle){0, bed->width, 0, bed->height});
    memcpy(bed->full, base->weight, (size_t)base->nodes * sizeof *bed->full);
    for (int y = 0; y < bed->height; y++) {
        bool within = y >= bed->picture.y0 && y < bed->picture.y1;
        for (int x = 0; x < bed->width; x++) {
            if (!within || x < bed->picture.x0 || x >= bed->picture.x1) {
                base->weight[lattice_node(base, x, y)] = 0;
            }
        }
    }
    memcpy(base->lean, def.lean, sizeof def.lean); /* the open one is even: visitors plant where they like */
    memcpy(bed->walled->lean, def.lean, sizeof def.lean);
}

bool garden_weigh(struct garden *garden, unsigned work)
{
    struct bed *bed = garden->bed;
    if ((work & WORK_IMPORTANCE) && !weigh_picture(garden)) {
        return false;
    }
    if (work & (WORK_IMPORTANCE | WORK_LATTICE)) {
        sum_up(bed, bed->picture);
        weigh_lattice(garden);
        stipple_weigh(bed->stipple, bed->importance, NULL);
    }
    return true;
}

void garden_weigh_again(struct garden *garden, struct rectangle touched)
{
    struct bed *bed = garden->bed;
    struct lattice_def def = growth_lattice_def(&garden->def.growth);
    lattice_weigh(bed->base, bed->importance, &def, touched);
    stipple_weigh(bed->stipple, bed->importance, &touched);
    for (int y = touched.y0; y < touched.y1; y++) {
        int32_t from = lattice_node(bed->base, touched.x0, y);
        memcpy(bed->full + from, bed->base->weight + from, (size_t)(touched.x1 - touched.x0) * sizeof *bed->full);
    }
}
