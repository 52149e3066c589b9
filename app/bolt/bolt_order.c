#include "bolt_order.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bolt_mesh.h"
#include "bolt_plant.h"
#include "key_fields.h"
#include "progress.h"

enum { SIZE = 1024, SIDES = 6, FILM = 120, RASTER_SIDE = 1024, PANORAMA_SIDE = 256, STEP = 256 };

#define KEY_AT(field) offsetof(struct bolt_order, field)

const char *const bolt_picture_names[BOLT_PICTURES] = {"mask", "eta_map", "outline", "environment"};
static const char *const PLANTS[LSYSTEM_KINDS + 2] = {"none", "tree", "vine", "bush", "fan", NULL};

const struct key bolt_order_keys[] = {
    CHOICE(kind, bolt_kind_names, BOLT_LIGHTNING,
           "Brings its own values of all that follows, its own seeds and charges."),
    CHOICE(lsystem, PLANTS, 0, "A plant that feels the potential, of this kind, in the place of an aggregate."),
    FLAG(bare, "Without the seeds and charges of the kind: it begins in the middle."),
    NUMBER(turn, "turns", -1000, 1000, 0, "Turned about the upright axis, to be seen from another side."),
    WHOLE(sides, "", 3, 64, SIDES, "Of the tubes of a mesh."),
    FLAG(lines, "OBJ and PLY hold lines with radii, no tubes."),
    WHOLE(film, "pictures", 2, 100000, FILM, "How many --frames writes."),
    END,
};

struct bolt_order bolt_order_default(void)
{
    struct bolt_order order = {.width = SIZE, .height = SIZE, .axes = {0, 1, 2}};
    key_defaults(bolt_order_keys, &order);
    return order;
}

static void strip(struct bolt_order *order)
{
    if (order->bare) {
        order->bolt.growth.charge_count = order->bolt.growth.seed_count = 0;
    }
}

void bolt_order_preset(struct bolt_order *order)
{
    bolt_preset(&order->bolt, (enum bolt_kind)order->kind, order->width, order->height);
    if (order->lsystem > 0) {
        bolt_plant_preset(order, (float)order->width); /* a cell is a pixel */
    }
    strip(order);
}

void bolt_order_respan(struct bolt_order *order, float span)
{
    if (order->lsystem > 0) {
        int dimensions = order->plant.growth.dimensions;
        bolt_plant_preset(order, span);
        order->plant.growth.dimensions = dimensions;
        strip(order);
    } else {
        bolt_respan(&order->bolt, span);
    }
}

void bolt_order_finish(struct bolt_order *order)
{
    for (int i = 0; i < order->path_count; i++) {
        free(order->paths[i]);
    }
    order->path_count = 0;
}

/* Brightness, linear; what is transparent is dark. The values are the caller's. */
static bool read_raster(const char *path, int side, struct action_raster *raster, struct file_error *error)
{
    struct image image;
    float *linear = NULL, *values = NULL;
    bool good = fit_read(path, &image, error);
    if (good) {
        int longer = image.width > image.height ? image.width : image.height, width, height;
        fit_size(&image, longer < side ? longer : side, &width, &height);
        linear = fit_linear(&image, width, height);
        values = malloc((size_t)width * (size_t)height * sizeof *values);
        good = linear && values;
        if (!good) {
            file_fail(error, path, "memory is short");
        }
        for (size_t i = 0; i < (size_t)width * (size_t)height && good; i++) {
            const float *pixel = linear + 4 * i;
            values[i] = pixel[3] * (0.2126f * pixel[0] + 0.7152f * pixel[1] + 0.0722f * pixel[2]);
        }
        *raster =
            (struct action_raster){.values = good ? values : NULL, .width = width, .height = height, .channels = 1};
    }
    if (!good) {
        free(values);
    }
    free(linear);
    image_finish(&image);
    return good;
}

static struct action_raster *raster_of(struct laplacian_def *growth, enum bolt_picture picture)
{
    struct action_raster *const rasters[BOLT_PICTURES] = {
        [BOLT_MASK] = &growth->mask,
        [BOLT_ETA_MAP] = &growth->eta_map,
        [BOLT_OUTLINE] = &growth->outline,
        [BOLT_ENVIRONMENT] = &growth->environment,
    };
    return rasters[picture];
}

static bool read_pictures(struct bolt_order *order, struct file_error *error)
{
    struct laplacian_def *growth = &order->bolt.growth;
    if (order->pictures[BOLT_ENVIRONMENT] && growth->dimensions > 3) {
        return file_fail(error, "--environment", "is for 2 and 3 dimensions, these are %d", growth->dimensions);
    }
    for (int i = 0; i < BOLT_PICTURES; i++) {
        int side = i == BOLT_ENVIRONMENT ? PANORAMA_SIDE : RASTER_SIDE;
        if (order->pictures[i] &&
            !read_raster(order->pictures[i], side, raster_of(growth, (enum bolt_picture)i), error)) {
            return false;
        }
    }
    return true;
}

static double clock_now(void)
{
    struct timespec now;
    clock_gettime(CLOCK_MONOTONIC, &now);
    return (double)now.tv_sec + 1e-9 * (double)now.tv_nsec;
}

/* Why nothing could begin. */
static bool explain_start(const struct bolt_order *order, enum laplacian_status status, struct file_error *error)
{
    const char *mask = order->pictures[BOLT_MASK], *outline = order->pictures[BOLT_OUTLINE];
    if (status == LAPLACIAN_NO_SEED && mask) {
        return file_fail(error, mask, "no seed lies where this mask is light; --seed-at X,Y says where to begin");
    }
    if (status == LAPLACIAN_NO_SEED && outline) {
        return file_fail(error, outline, "no light meets dark in it: there is no outline to begin at");
    }
    if (status == LAPLACIAN_NO_SEED) {
        return file_fail(error, "--seed-at", "all lie too far out: within 131000 cells of the middle");
    }
    return file_fail(error, bolt_kind_names[order->kind], "cannot grow: %s", laplacian_status_names[status]);
}

static bool grow_aggregate(struct bolt_result *result, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    const struct laplacian_def *growth = &order->bolt.growth;
    enum laplacian_status status;
    result->laplacian = laplacian_create(growth, &status);
    if (!result->laplacian) {
        return explain_start(order, status, error);
    }
    int32_t seeds = laplacian_count(result->laplacian);
    char what[48];
    snprintf(what, sizeof what, "growing %s", bolt_kind_names[order->kind]);
    struct progress progress = progress_start(what, stderr);
    while (laplacian_step(result->laplacian, STEP) > 0) {
        progress_step(&progress, laplacian_count(result->laplacian), growth->particles);
    }
    progress_end(&progress);
    status = laplacian_status(result->laplacian);
    if (status == LAPLACIAN_NO_MEMORY) {
        return file_fail(error, bolt_kind_names[order->kind], "memory is short, after %d particles",
                         laplacian_count(result->laplacian));
    }
    if (status == LAPLACIAN_NO_CANDIDATES && laplacian_count(result->laplacian) == seeds) {
        const char *mask = order->pictures[BOLT_MASK];
        return file_fail(error, mask ? mask : "--seed-at", "there is nowhere to grow around the seeds");
    }
    return true;
}

static bool grow(struct bolt_result *result, struct file_error *error)
{
    double start = clock_now();
    bool good = result->order->lsystem > 0 ? bolt_plant_grow(result, error) : grow_aggregate(result, error);
    result->seconds = clock_now() - start;
    return good;
}

static bool has_ending(const char *path, const char *ending)
{
    const char *end = strrchr(path, '.');
    return end && strcmp(end, ending) == 0;
}

static bool write_one(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    const struct bolt_mesh_def mesh = {.shape = &result->shape,
                                       .look = &order->bolt.look,
                                       .width = order->width,
                                       .height = order->height,
                                       .sides = order->sides,
                                       .lines = order->lines};
    return has_ending(path, ".svg")   ? bolt_write_svg(result, path, error)
           : has_ending(path, ".obj") ? bolt_write_obj(&mesh, path, error)
           : has_ending(path, ".ply") ? bolt_write_ply(&mesh, path, error)
                                      : bolt_write_png(result, path, error);
}

static bool make_shape(struct bolt_result *result, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    struct bolt_sight sight = bolt_sight_of(&order->bolt, order->width, order->height);
    float angle = 6.2831853f * order->turn;
    sight.turn[0] = cosf(angle);
    sight.turn[1] = sinf(angle);
    memcpy(sight.axes, order->axes, sizeof sight.axes);
    return (result->plant ? bolt_plant_shape(result, &sight)
                          : bolt_shape_make(&result->shape, result->laplacian, &order->bolt.look, &sight)) ||
           file_fail(error, bolt_kind_names[order->kind], "memory is short");
}

bool bolt_order_run(struct bolt_order *order, struct file_error *error)
{
    struct bolt_result result = {.order = order};
    order->bolt.growth.charges = order->bolt.charges;
    order->bolt.growth.seeds = order->bolt.seeds;
    bool good = read_pictures(order, error) && grow(&result, error) && make_shape(&result, error);
    for (int i = 0; i < order->output_count && good; i++) {
        good = write_one(&result, order->outputs[i], error);
    }
    good = good && (!order->potential || bolt_write_potential(&result, order->potential, error)) &&
           (!order->height_field || bolt_write_height(&result, order->height_field, error)) &&
           (!order->frames || bolt_write_frames(&result, order->frames, error)) &&
           (!order->stats || bolt_write_stats(&result, order->stats, error));
    bolt_shape_finish(&result.shape);
    laplacian_destroy(result.laplacian);
    lsystem_destroy(result.plant);
    for (int i = 0; i < BOLT_PICTURES; i++) {
        struct action_raster *raster = raster_of(&order->bolt.growth, (enum bolt_picture)i);
        free((void *)(uintptr_t)raster->values);
        *raster = (struct action_raster){0};
    }
    return good;
}
