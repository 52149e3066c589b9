#include "stats.h"

#include <inttypes.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <json.h>

#include "json_number.h"
#include "shape.h"

static void add_number(struct json_object *object, const char *name, double value)
{
    json_object_object_add(object, name, json_number(value, 12));
}

static void add_whole(struct json_object *object, const char *name, int64_t value)
{
    json_object_object_add(object, name, json_object_new_int64(value));
}

static struct json_object *inks_array(const double *values)
{
    struct json_object *array = json_object_new_array_ext(PAINTING_INKS);
    for (int i = 0; i < PAINTING_INKS; i++) {
        json_object_array_add(array, json_number(values[i], 12));
    }
    return array;
}

static struct json_object *totals_object(struct engine *engine)
{
    struct painting_totals totals = engine->ops->totals(engine);
    struct json_object *object = json_object_new_object();
    add_number(object, "solvent", totals.solvent);
    add_number(object, "ink", totals.ink);
    add_number(object, "solvent_evaporated", totals.solvent_evaporated);
    add_number(object, "ink_dried", totals.ink_dried);
    add_number(object, "catalyst", totals.catalyst);
    add_number(object, "active", totals.active);
    add_number(object, "carved", totals.carved);
    json_object_object_add(object, "wet", inks_array(totals.wet));
    json_object_object_add(object, "dry", inks_array(totals.dry));
    return object;
}

static struct json_object *fields_object(struct engine *engine, size_t cells, float *plane)
{
    struct json_object *object = json_object_new_object();
    for (int field = 0; field < PAINTING_FIELDS; field++) {
        engine->ops->read(engine, (enum painting_field)field, plane);
        double least = plane[0], most = plane[0], sum = 0;
        for (size_t i = 0; i < cells; i++) {
            least = plane[i] < least ? plane[i] : least;
            most = plane[i] > most ? plane[i] : most;
            sum += plane[i];
        }
        struct json_object *extremes = json_object_new_object();
        add_number(extremes, "min", least);
        add_number(extremes, "max", most);
        add_number(extremes, "sum", sum);
        json_object_object_add(object, painting_field_name((enum painting_field)field), extremes);
    }
    return object;
}

static struct json_object *shape_object(const struct shape_figures *figures)
{
    struct json_object *object = json_object_new_object();
    add_number(object, "centre_x", figures->centre_x);
    add_number(object, "centre_y", figures->centre_y);
    add_whole(object, "area", figures->area);
    add_whole(object, "components", figures->components);
    add_whole(object, "specks", figures->specks);
    add_whole(object, "perimeter", figures->perimeter);
    add_number(object, "perimeter_per_cell", figures->perimeter_per_cell);
    add_whole(object, "junctions", figures->junctions);
    add_whole(object, "tips", figures->tips);
    add_number(object, "junctions_per_1000", figures->junctions_per_1000);
    add_number(object, "tips_per_1000", figures->tips_per_1000);
    add_number(object, "hull_area", figures->hull_area);
    add_number(object, "hull_share", figures->hull_share);
    add_number(object, "largest_width", figures->largest_width);
    add_number(object, "mean_width", figures->mean_width);
    add_number(object, "radius", figures->radius);
    add_number(object, "front_mean", figures->front_mean);
    add_number(object, "c4", figures->c4);
    add_number(object, "c8", figures->c8);
    add_number(object, "diagonals_over_axes", figures->diagonals_over_axes);
    return object;
}

static bool measure(const struct script *script, struct engine *engine, float *plane, float *depth,
                    struct shape_figures *figures)
{
    struct shape_def def = shape_default_def();
    size_t cells = (size_t)script->width * (size_t)script->height;
    int drops = 0;
    def.width = script->width;
    def.height = script->height;
    for (int i = 0; i < script->action_count; i++) {
        const struct action *action = &script->actions[i];
        if (action->verb == ACTION_DROP) {
            drops++;
            def.centre_x = (double)action->at.x * script->width;
            def.centre_y = (double)action->at.y * script->height;
        }
    }
    def.has_centre = drops == 1;
    engine->ops->read(engine, PAINTING_CARVED, plane);
    engine->ops->read(engine, PAINTING_ACTIVE, depth);
    for (size_t i = 0; i < cells; i++) {
        depth[i] += plane[i];
    }
    return shape_measure(&def, depth, figures);
}

static struct json_object *canvas_object(const struct script *script)
{
    struct json_object *object = json_object_new_object();
    add_whole(object, "width", script->width);
    add_whole(object, "height", script->height);
    add_whole(object, "margin", script->margin);
    return object;
}

static struct json_object *scenes_object(struct plot *plot)
{
    struct json_object *object = json_object_new_object();
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        const struct scene_type *type = scene_types[kind];
        const void *scene = plot_scene(plot, (enum scene_kind)kind);
        if (!type || !scene) {
            continue;
        }
        struct scene_figure figures[SCENE_FIGURES];
        struct json_object *own = json_object_new_object();
        char hash[17];
        snprintf(hash, sizeof hash, "%016" PRIx64, type->hash(scene));
        json_object_object_add(own, "hash", json_object_new_string(hash));
        int count = type->figures ? type->figures(scene, figures) : 0;
        for (int i = 0; i < count; i++) {
            if (figures[i].word) {
                json_object_object_add(own, figures[i].name, json_object_new_string(figures[i].word));
            } else {
                add_number(own, figures[i].name, figures[i].number);
            }
        }
        json_object_object_add(object, scene_kind_names[kind], own);
    }
    return object;
}

bool stats_write(const char *path, const struct script *script, struct engine *engine, struct plot *plot,
                 struct file_error *error)
{
    size_t cells = (size_t)script->width * (size_t)script->height;
    float *planes = malloc(2 * cells * sizeof *planes);
    struct shape_figures figures;
    if (!planes || !measure(script, engine, planes, planes + cells, &figures)) {
        free(planes);
        return file_fail(error, path, "memory is short for the figures");
    }
    char hash[17] = "";
    if (engine_cpu_painting(engine)) {
        snprintf(hash, sizeof hash, "%016" PRIx64, painting_hash(engine_cpu_painting(engine)));
    }
    struct json_object *root = json_object_new_object();
    json_object_object_add(root, "frond", json_object_new_string(FROND_VERSION));
    json_object_object_add(root, "engine", json_object_new_string(engine->ops->name));
    add_whole(root, "seed", (int64_t)engine->ops->get_def(engine).seed);
    add_whole(root, "ticks", engine->ops->ticks(engine));
    json_object_object_add(root, "hash", hash[0] ? json_object_new_string(hash) : NULL);
    json_object_object_add(root, "canvas", canvas_object(script));
    json_object_object_add(root, "totals", totals_object(engine));
    json_object_object_add(root, "fields", fields_object(engine, cells, planes));
    json_object_object_add(root, "shape", shape_object(&figures));
    if (plot) {
        json_object_object_add(root, "scenes", scenes_object(plot));
    }
    free(planes);

    const char *text = json_object_to_json_string_ext(root, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_SPACED |
                                                                JSON_C_TO_STRING_NOSLASHESCAPE);
    size_t length = text ? strlen(text) : 0;
    char *file = text ? malloc(length + 2) : NULL;
    bool good = false;
    if (file) {
        snprintf(file, length + 2, "%s\n", text);
        good = file_write_atomic(path, file, length + 1, error);
    } else {
        file_fail(error, path, "memory is short for the figures");
    }
    free(file);
    json_object_put(root);
    return good;
}
