/* Pictures and figures of what has grown. */
#include <stdio.h>
#include <stdlib.h>

#include <json.h>

#include "bolt_order.h"
#include "image.h"
#include "json_number.h"
#include "laplacian_figures.h"
#include "progress.h"

/* The view of a film of so many ticks; 0: of all at once. Its segments are the caller's. */
static bool view_of(const struct bolt_result *result, int ticks, struct bolt_view *view)
{
    const struct bolt_order *order = result->order;
    float pace = ticks > 0 ? (float)result->shape.count / (float)ticks : 0;
    int count = 0;
    *view = (struct bolt_view){.segments = bolt_shape_segments(&result->shape, &order->bolt.look, pace, &count),
                               .width = order->width,
                               .height = order->height,
                               .look = order->bolt.look};
    view->count = count;
    view->look.life = 0; /* what is written stays */
    return view->segments;
}

static void end_view(struct bolt_view *view)
{
    free((void *)(uintptr_t)view->segments);
}

bool bolt_write_png(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    struct bolt_view view;
    if (!view_of(result, 0, &view)) {
        return file_fail(error, path, "nothing has grown but a single seed");
    }
    uint8_t *rgb = calloc((size_t)order->width * (size_t)order->height, 3);
    bool good = rgb && bolt_light_lay(&view, 1e6, order->width, order->height, rgb);
    if (!good) {
        file_fail(error, path, "memory is short");
    }
    good = good && image_write_png(path, rgb, order->width, order->height, NULL, error);
    end_view(&view);
    free(rgb);
    return good;
}

bool bolt_write_frames(const struct bolt_result *result, const char *folder, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    struct bolt_view view;
    if (!view_of(result, order->film, &view)) {
        return file_fail(error, folder, "nothing has grown but a single seed");
    }
    uint8_t *rgb = calloc((size_t)order->width * (size_t)order->height, 3);
    bool good = rgb;
    if (!good) {
        file_fail(error, folder, "memory is short");
    }
    struct progress progress = progress_start("writing the film", stderr);
    for (int i = 0; i < order->film && good; i++) {
        char path[4096];
        snprintf(path, sizeof path, "%s/%06d.png", folder, i);
        good = bolt_light_lay(&view, (double)i + 1, order->width, order->height, rgb) ||
               file_fail(error, path, "memory is short");
        good = good && image_write_png(path, rgb, order->width, order->height, NULL, error);
        progress_step(&progress, i, order->film);
    }
    progress_end(&progress);
    end_view(&view);
    free(rgb);
    return good;
}

static void add_number(struct json_object *object, const char *name, double value)
{
    json_object_object_add(object, name, json_number(value, 9));
}

static void add_keys(struct json_object *object, const struct key *keys, const void *values)
{
    for (const struct key *key = keys; key->name; key++) {
        const char *at = (const char *)values + key->offset;
        float number = key_value(key, values);
        switch (key->type) {
        case KEY_FLAG:
            json_object_object_add(object, key->name, json_object_new_boolean(number > 0));
            break;
        case KEY_CHOICE:
            json_object_object_add(object, key->name, json_object_new_string(key->choices[(int)number]));
            break;
        case KEY_INTEGER: {
            int whole = *(const int *)(const void *)at;
            json_object_object_add(object, key->name, json_object_new_int(whole));
            break;
        }
        case KEY_NUMBER:
            add_number(object, key->name, (double)number);
            break;
        default:
            break;
        }
    }
}

static struct json_object *place_of(const float *at, int dimensions)
{
    struct json_object *place = json_object_new_array();
    for (int d = 0; d < dimensions; d++) {
        json_object_array_add(place, json_number((double)at[d], 9));
    }
    return place;
}

static void add_charges(struct json_object *object, const struct laplacian_def *growth)
{
    struct json_object *charges = json_object_new_array(), *seeds = json_object_new_array();
    for (int i = 0; i < growth->charge_count; i++) {
        const struct laplacian_charge *charge = &growth->charges[i];
        struct json_object *entry = json_object_new_object();
        json_object_object_add(entry, "shape", json_object_new_string(laplacian_shape_names[charge->shape]));
        add_number(entry, "charge", (double)charge->charge);
        json_object_object_add(entry, "ends", json_object_new_boolean(charge->ends));
        if (charge->shape == LAPLACIAN_STROKE) {
            struct json_object *path = json_object_new_array();
            for (int k = 0; k < charge->path_count; k++) {
                json_object_array_add(
                    path, place_of(charge->path + (size_t)k * (size_t)growth->dimensions, growth->dimensions));
            }
            json_object_object_add(entry, "path", path);
        } else {
            json_object_object_add(entry, "at", place_of(charge->at, growth->dimensions));
            json_object_object_add(entry, "along", place_of(charge->along, growth->dimensions));
            add_number(entry, "radius", (double)charge->radius);
        }
        json_object_array_add(charges, entry);
    }
    for (int i = 0; i < growth->seed_count; i++) {
        struct json_object *seed = json_object_new_array();
        json_object_array_add(seed, place_of(growth->seeds[i].from, growth->dimensions));
        json_object_array_add(seed, place_of(growth->seeds[i].to, growth->dimensions));
        json_object_array_add(seeds, seed);
    }
    json_object_object_add(object, "charges", charges);
    json_object_object_add(object, "seeds", seeds);
}

bool bolt_write_stats(const struct bolt_result *result, const char *path, struct file_error *error)
{
    const struct bolt_order *order = result->order;
    struct laplacian_figures figures;
    if (!laplacian_measure(result->laplacian, &figures)) {
        return file_fail(error, path, "memory is short");
    }
    struct json_object *object = json_object_new_object(), *parameters = json_object_new_object();
    const char *kind = result->plant ? lsystem_kind_names[order->lsystem - 1] : bolt_kind_names[order->kind];
    const char *status = result->plant ? lsystem_status_names[lsystem_status(result->plant)]
                                       : laplacian_status_names[laplacian_status(result->laplacian)];
    json_object_object_add(object, "kind", json_object_new_string(kind));
    json_object_object_add(object, "status", json_object_new_string(status));
    json_object_object_add(object, "particles", json_object_new_int(result->shape.count));
    add_number(object, "seconds", result->seconds);
    add_number(object, "bytes", (double)laplacian_bytes(result->laplacian));
    add_number(object, "radius_of_gyration", figures.gyration);
    add_number(object, "box_dimension", figures.box_dimension);
    add_number(object, "mass_dimension", figures.mass_dimension);
    json_object_object_add(object, "branches", json_object_new_int(result->shape.branches));
    json_object_object_add(object, "longest_way", json_object_new_int(result->shape.longest));
    json_object_object_add(object, "width", json_object_new_int(order->width));
    json_object_object_add(object, "height", json_object_new_int(order->height));
    if (result->plant) {
        add_keys(parameters, lsystem_keys, &order->plant.growth);
    } else {
        add_keys(parameters, laplacian_keys, &order->bolt.growth);
    }
    add_keys(parameters, bolt_look_keys, &order->bolt.look);
    for (int i = 0; i < BOLT_PICTURES; i++) {
        if (order->pictures[i]) {
            json_object_object_add(parameters, bolt_picture_names[i], json_object_new_string(order->pictures[i]));
        }
    }
    add_charges(parameters, &order->bolt.growth);
    json_object_object_add(object, "parameters", parameters);
    size_t size = 0;
    const char *text = json_object_to_json_string_length(object, JSON_C_TO_STRING_PRETTY, &size);
    bool good = text ? file_write_atomic(path, text, size, error) : file_fail(error, path, "memory is short");
    json_object_put(object);
    return good;
}
