#include "engine_choice.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <json.h>

#include "bench.h"
#include "file.h"
#include "gpu_limits.h"
#include "painting_gpu.h"
#include "state.h"

enum {
    WARM_TICKS = 4,
    TIMED_TICKS_MOST = 60,
    REMEMBERED_MOST = 32, /* machines and grids; older ones are forgotten */
    DROP_APART = 96,      /* cells: as busy as a sheet that many visitors paint on */
};

static const double TIMED_S = 0.6; /* an engine; making it comes on top */

static const char *const KINDS[ENGINE_KINDS] = {"auto", "cpu", "gpu"};

const char *engine_kind_name(enum engine_kind kind)
{
    return KINDS[kind];
}

enum engine_kind engine_kind_find(const char *name)
{
    enum engine_kind kind = ENGINE_AUTO;
    while (kind < ENGINE_KINDS && strcmp(KINDS[kind], name) != 0) {
        kind++;
    }
    return kind;
}

static void scatter_drops(struct engine *engine, const struct painting_def *def)
{
    for (int y = DROP_APART / 2; y < def->height; y += DROP_APART) {
        for (int x = DROP_APART / 2; x < def->width; x += DROP_APART) {
            struct action drop = action_default(ACTION_DROP);
            drop.at = (struct point){(float)x / (float)def->width, (float)y / (float)def->height};
            drop.has_at = true;
            drop.ink = (x / DROP_APART + y / DROP_APART) % PAINTING_INKS;
            engine->ops->act(engine, &drop);
        }
    }
}

/* Milliseconds of a busy tick; takes the engine. 0 when there is none. */
static double time_engine(struct engine *engine, const struct painting_def *def)
{
    if (!engine) {
        return 0;
    }
    double start = 0, now = 0;
    int ticks = -WARM_TICKS;
    scatter_drops(engine, def);
    for (; ticks < TIMED_TICKS_MOST; ticks++) {
        if (ticks <= 0) {
            start = bench_wall_s();
        }
        engine->ops->tick(engine);
        engine->ops->finish(engine);
        now = bench_wall_s();
        if (ticks >= 0 && now - start > TIMED_S) {
            ticks++;
            break;
        }
    }
    engine_destroy(engine);
    return ticks > 0 ? 1000 * (now - start) / ticks : 0;
}

static void name_processor(char *name, size_t size)
{
    char line[256];
    FILE *file = fopen("/proc/device-tree/model", "re"); /* a board says what it is */
    snprintf(name, size, "unknown processor");
    if (file && fgets(line, sizeof line, file)) {
        snprintf(name, size, "%.*s", (int)size - 1, line);
    }
    if (file) {
        fclose(file);
        return;
    }
    file = fopen("/proc/cpuinfo", "re");
    while (file && fgets(line, sizeof line, file)) {
        char *colon = strchr(line, ':');
        if (colon && strncmp(line, "model name", 10) == 0) {
            colon[strcspn(colon, "\n")] = '\0';
            snprintf(name, size, "%.*s", (int)size - 1, colon + 2);
            break;
        }
    }
    if (file) {
        fclose(file);
    }
}

static void make_key(char *key, size_t size, const struct painting_def *def, const char *renderer)
{
    char processor[200];
    name_processor(processor, sizeof processor);
    snprintf(key, size, "%s | %ld x %s | %dx%d+%d | %s", renderer, sysconf(_SC_NPROCESSORS_ONLN), processor, def->width,
             def->height, def->margin, FROND_VERSION);
}

/* The list of what was measured, made empty when the file is not there or is not one of ours. */
static struct json_object *load(const char *path)
{
    struct json_object *object = path && access(path, R_OK) == 0 ? json_object_from_file(path) : NULL;
    struct json_object *list = NULL;
    if (!json_object_is_type(object, json_type_object) || !json_object_object_get_ex(object, "measured", &list) ||
        !json_object_is_type(list, json_type_array)) {
        json_object_put(object);
        object = json_object_new_object();
        json_object_object_add(object, "measured", json_object_new_array());
    }
    return object;
}

static double number(struct json_object *entry, const char *name)
{
    struct json_object *value;
    double found = json_object_object_get_ex(entry, name, &value) ? json_object_get_double(value) : 0;
    return isfinite(found) && found > 0 ? found : 0;
}

static bool recall(struct json_object *object, const char *key, struct engine_choice *choice)
{
    struct json_object *list = json_object_object_get(object, "measured"), *name;
    for (size_t i = 0; i < json_object_array_length(list); i++) {
        struct json_object *entry = json_object_array_get_idx(list, i);
        if (json_object_is_type(entry, json_type_object) && json_object_object_get_ex(entry, "on", &name) &&
            strcmp(json_object_get_string(name), key) == 0 && number(entry, "cpu_ms") > 0) {
            choice->cpu_ms = number(entry, "cpu_ms");
            choice->gpu_ms = number(entry, "gpu_ms");
            choice->remembered = true;
            return true;
        }
    }
    return false;
}

static void remember(struct json_object *object, const char *key, const struct engine_choice *choice, const char *path)
{
    struct json_object *list = json_object_object_get(object, "measured"), *entry = json_object_new_object();
    json_object_object_add(entry, "on", json_object_new_string(key));
    json_object_object_add(entry, "cpu_ms", json_object_new_double(choice->cpu_ms));
    json_object_object_add(entry, "gpu_ms", json_object_new_double(choice->gpu_ms));
    json_object_array_add(list, entry);
    size_t count = json_object_array_length(list);
    if (count > REMEMBERED_MOST) {
        json_object_array_del_idx(list, 0, count - REMEMBERED_MOST);
    }
    const char *text = json_object_to_json_string_ext(object, JSON_C_TO_STRING_PRETTY);
    struct file_error error;
    (void)file_write_atomic(path, text, strlen(text), &error); /* it is measured again the next time */
}

static void measure(struct engine_choice *choice, const struct painting_def *def, const struct shader_folder *folder,
                    char *trouble, size_t size)
{
    struct shader_error error;
    struct engine *gpu = engine_gpu_create(def, folder, &error);
    if (!gpu) {
        snprintf(trouble, size, "%.*s", (int)strcspn(error.text, "\n"), error.text);
    }
    choice->gpu_ms = time_engine(gpu, def);
    choice->cpu_ms = time_engine(engine_cpu_create(def), def);
}

static void explain(struct engine_choice *choice, const char *trouble)
{
    if (choice->gpu_ms > 0) {
        snprintf(choice->why, sizeof choice->why,
                 "engine %s: a busy tick takes %.1f ms on the CPU, %.1f ms on the GPU%s", KINDS[choice->kind],
                 choice->cpu_ms, choice->gpu_ms, choice->remembered ? " (remembered)" : "");
    } else {
        snprintf(choice->why, sizeof choice->why, "engine cpu: the GPU has none%s%.150s", *trouble ? ": " : "",
                 trouble);
    }
}

struct engine_choice engine_choose(enum engine_kind wanted, const struct painting_def *def, const char *renderer,
                                   const struct shader_folder *folder, const char *path)
{
    struct engine_choice choice = {.kind = wanted};
    char key[600], trouble[200] = "";
    if (wanted != ENGINE_AUTO) {
        snprintf(choice.why, sizeof choice.why, "engine %s: asked for", KINDS[wanted]);
        return choice;
    }
    if (!renderer) {
        choice.kind = ENGINE_CPU;
        explain(&choice, "no GLES 3.1");
        return choice;
    }
    /* GL on the processor: it has nothing that the engine of the CPU has not, and would only be slow to say so. */
    if (gpu_limits_is_processor(renderer)) {
        choice.kind = ENGINE_CPU;
        snprintf(choice.why, sizeof choice.why, "engine cpu: %.100s draws with the processor, too", renderer);
        return choice;
    }
    make_key(key, sizeof key, def, renderer);
    struct json_object *memory = load(path);
    if (!recall(memory, key, &choice)) {
        measure(&choice, def, folder, trouble, sizeof trouble);
        if (path && choice.cpu_ms > 0) {
            remember(memory, key, &choice, path);
        }
    }
    json_object_put(memory);
    choice.kind = choice.gpu_ms > 0 && choice.gpu_ms < choice.cpu_ms ? ENGINE_GPU : ENGINE_CPU;
    explain(&choice, trouble);
    return choice;
}

bool engine_choice_path(char *path, size_t size)
{
    return state_path("engines.json", path, size);
}
