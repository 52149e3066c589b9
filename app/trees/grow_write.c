#include <float.h>
#include <stdio.h>
#include <stdlib.h>

#include <json.h>

#include "grow.h"
#include "growth_paint.h"
#include "image.h"
#include "json_number.h"

bool grow_write_png(const struct grown *grown, const char *path, struct file_error *error)
{
    size_t values = (size_t)grown->width * (size_t)grown->height * 3;
    struct growth_paint_def def = {grown->width, grown->height, grown->scale,     grown->left,
                                   grown->top,   FLT_MAX,       grown->background};
    float *rgb = malloc(values * sizeof *rgb);
    uint8_t *bytes = malloc(values);
    bool good = rgb && bytes && growth_paint(grown->growth, &grown->strokes, &def, rgb);
    if (good) {
        for (size_t i = 0; i < values; i++) {
            float value = 255 * rgb[i] + 0.5f;
            bytes[i] = (uint8_t)(value < 0 ? 0 : value > 255 ? 255 : value);
        }
        good = image_write_png(path, bytes, grown->width, grown->height, NULL, error);
    } else {
        file_fail(error, path, "memory is short");
    }
    free(rgb);
    free(bytes);
    return good;
}

enum { EXR_PLANES = 5 };

bool grow_write_exr(const struct grown *grown, const char *path, struct file_error *error)
{
    static const char *const NAMES[EXR_PLANES] = {"cover", "radius", "reach", "level", "tone"};
    char text[GROWTH_LAYERS_MAX * EXR_PLANES][IMAGE_NAME];
    const char *names[GROWTH_LAYERS_MAX * EXR_PLANES];
    const float *planes[GROWTH_LAYERS_MAX * EXR_PLANES];
    struct stroke_raster rasters[GROWTH_LAYERS_MAX] = {{0}};
    int count = 0;
    bool good = true;
    for (int layer = 0; layer < grown->growth->layer_count && good; layer++) {
        struct stroke_raster *raster = &rasters[layer];
        good = stroke_raster_init(raster, grown->width, grown->height, grown->scale, grown->left, grown->top) ||
               file_fail(error, path, "memory is short");
        for (int kind = 0; kind < STROKE_KINDS && good; kind++) {
            stroke_raster_draw(raster, &grown->strokes, layer, (enum stroke_kind)kind, FLT_MAX);
        }
        const float *const own[EXR_PLANES] = {raster->cover, raster->radius, raster->reach, raster->level,
                                              raster->tone};
        for (int plane = 0; plane < EXR_PLANES && good; plane++, count++) {
            snprintf(text[count], sizeof text[count], "layer%d.%s", layer, NAMES[plane]);
            names[count] = text[count];
            planes[count] = own[plane];
        }
    }
    good = good && image_write_exr(path, names, planes, count, grown->width, grown->height, NULL, error);
    for (int layer = 0; layer < grown->growth->layer_count; layer++) {
        stroke_raster_finish(&rasters[layer]);
    }
    return good;
}

static void add_number(struct json_object *object, const char *name, double value)
{
    json_object_object_add(object, name, json_number(value, 9));
}

static bool add_layer(struct json_object *array, const struct growth *growth, int layer)
{
    struct dendrite_figures figures;
    if (!dendrite_measure(growth->layers[layer], growth->importance, &figures)) {
        return false;
    }
    struct json_object *entry = json_object_new_object();
    json_object_object_add(entry, "endpoints", json_object_new_int(figures.endpoints));
    json_object_object_add(entry, "branches", json_object_new_int(figures.branches));
    json_object_object_add(entry, "nodes", json_object_new_int(figures.nodes));
    json_object_object_add(entry, "levels", json_object_new_int(figures.levels));
    json_object_object_add(entry, "components", json_object_new_int(figures.components));
    json_object_object_add(entry, "cycles", json_object_new_int(figures.cycles));
    add_number(entry, "length", figures.length);
    add_number(entry, "coverage", figures.coverage);
    json_object_array_add(array, entry);
    return true;
}

bool grow_write_stats(const struct grown *grown, const char *path, struct file_error *error)
{
    const struct growth *growth = grown->growth;
    struct json_object *object = json_object_new_object(), *layers = json_object_new_array();
    json_object_object_add(object, "metaphor", json_object_new_string(metaphor_names[growth->def.metaphor]));
    json_object_object_add(object, "metric", json_object_new_string(metric_names[growth->def.metric]));
    json_object_object_add(object, "tree", json_object_new_boolean(growth->def.tree));
    json_object_object_add(object, "width", json_object_new_int(growth->importance->width));
    json_object_object_add(object, "height", json_object_new_int(growth->importance->height));
    json_object_object_add(object, "seeds", json_object_new_int(growth->seed_count));
    json_object_object_add(object, "layers", layers);
    bool good = true;
    for (int layer = 0; layer < growth->layer_count && good; layer++) {
        good = add_layer(layers, growth, layer) || file_fail(error, path, "memory is short");
    }
    size_t size = 0;
    const char *text = json_object_to_json_string_length(object, JSON_C_TO_STRING_PRETTY, &size);
    good = good && file_write_atomic(path, text, size, error);
    json_object_put(object);
    return good;
}
