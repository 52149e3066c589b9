#include "render.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "display.h"
#include "image.h"
#include "limits.h"
#include "painting_gpu.h"
#include "plan.h"
#include "script_sheet.h"
#include "stats.h"

/* Everything a session needs while it runs. */
struct studio {
    const struct script *script;
    const struct render_def *def;
    struct display *display; /* a GL context without a screen, for the engine of the GPU; NULL: none */
    struct engine *engine;
    struct picture *picture;
    float *planes; /* depth, solvent, mask, inks, and one to spare */
    uint8_t *rgb;
    int width, height; /* pixels */
    size_t cells;
};

enum { PLANE_DEPTH, PLANE_SOLVENT, PLANE_MASK, PLANE_INKS, PLANE_SPARE = PLANE_INKS + PAINTING_INKS, PLANES };

struct render_def render_default_def(void)
{
    return (struct render_def){.every = RENDER_EVERY, .engine = ENGINE_CPU};
}

/* Whether a file of that name can be made: its folder is there, and it is no folder itself. */
static bool check_file(const char *path, struct file_error *error)
{
    struct stat status;
    if (!path) {
        return true;
    }
    if (stat(path, &status) == 0 && S_ISDIR(status.st_mode)) {
        return file_fail(error, path, "is a folder; the name of a file is needed");
    }
    char *folder = strdup(path);
    char *slash = folder ? strrchr(folder, '/') : NULL;
    if (slash) {
        slash[slash == folder] = '\0';
    }
    const char *name = slash ? folder : ".";
    bool good = true;
    if (stat(name, &status) != 0 || !S_ISDIR(status.st_mode)) {
        good = file_fail(error, path, "its folder is not there");
    } else if (access(name, W_OK) != 0) {
        good = file_fail(error, path, "its folder may not be written to");
    }
    free(folder);
    return good;
}

static bool make_folder(const char *path, struct file_error *error)
{
    struct stat status;
    if (!path) {
        return true;
    }
    if (mkdir(path, 0777) == 0 || (errno == EEXIST && stat(path, &status) == 0 && S_ISDIR(status.st_mode))) {
        return true;
    }
    return file_fail(error, path, "the folder cannot be made: %s", strerror(errno));
}

/* A GL context, which the engine of the GPU lives in. */
static bool open_display(struct studio *studio, struct file_error *error)
{
    struct display_def def = display_default_def();
    struct display_error reason;
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16; /* nothing is shown */
    studio->display = display_create(&def, &reason);
    return studio->display || file_fail(error, "the GPU", "%s", reason.text);
}

static bool open_gpu(struct studio *studio, const struct painting_def *def, const struct shader_folder *folder,
                     struct file_error *error)
{
    struct shader_error reason;
    studio->engine = engine_gpu_create(def, folder, &reason);
    return studio->engine || file_fail(error, "the GPU", "%s", reason.text);
}

static bool short_of_memory(const struct studio *studio, struct file_error *error)
{
    return file_fail(error, "the painting", "memory is short for %dx%d cells and %dx%d pixels", studio->script->width,
                     studio->script->height, studio->width, studio->height);
}

static bool open_engine(struct studio *studio, struct file_error *error)
{
    const struct script *script = studio->script;
    struct painting_def def = script_painting(script);
    const struct shader_folder shaders = {studio->def->shaders}, *folder = shaders.path ? &shaders : NULL;
    enum engine_kind kind = studio->def->engine;
    def.threads = studio->def->threads;
    def.dense = studio->def->dense;
    if (kind == ENGINE_AUTO) {
        char path[1200];
        bool have = open_display(studio, error);
        kind = engine_choose(kind, &def, have ? gpu_limits_renderer() : NULL, folder,
                             engine_choice_path(path, sizeof path) ? path : NULL)
                   .kind;
    } else if (kind == ENGINE_GPU && !open_display(studio, error)) {
        return false;
    }
    if (kind == ENGINE_GPU) {
        return open_gpu(studio, &def, folder, error);
    }
    studio->engine = engine_cpu_create(&def);
    return studio->engine || short_of_memory(studio, error);
}

static bool open_picture(struct studio *studio)
{
    if (!studio->def->picture && !studio->def->frames) {
        return true;
    }
    struct picture_def def = script_picture(studio->script, studio->width, studio->height);
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    long threads = studio->def->threads ? studio->def->threads : processors;
    def.threads = threads < 1 ? 1 : threads > PICTURE_THREADS_MAX ? PICTURE_THREADS_MAX : (int)threads;
    studio->picture = picture_create(&def);
    studio->rgb = malloc((size_t)def.width * (size_t)def.height * 3);
    studio->planes = malloc(PLANES * studio->cells * sizeof *studio->planes);
    return studio->picture && studio->rgb && studio->planes;
}

static float *plane(struct studio *studio, int index)
{
    return studio->planes + (size_t)index * studio->cells;
}

static void read_sum(struct studio *studio, enum painting_field a, enum painting_field b, float *sum)
{
    float *spare = plane(studio, PLANE_SPARE);
    studio->engine->ops->read(studio->engine, a, sum);
    studio->engine->ops->read(studio->engine, b, spare);
    for (size_t i = 0; i < studio->cells; i++) {
        sum[i] += spare[i];
    }
}

static bool write_picture(struct studio *studio, const char *path, struct file_error *error)
{
    struct picture_planes planes = {.depth = plane(studio, PLANE_DEPTH),
                                    .solvent = plane(studio, PLANE_SOLVENT),
                                    .mask = plane(studio, PLANE_MASK)};
    read_sum(studio, PAINTING_ACTIVE, PAINTING_CARVED, plane(studio, PLANE_DEPTH));
    studio->engine->ops->read(studio->engine, PAINTING_SOLVENT, plane(studio, PLANE_SOLVENT));
    studio->engine->ops->read(studio->engine, PAINTING_MASK, plane(studio, PLANE_MASK));
    for (int i = 0; i < studio->script->ink_count; i++) {
        float *ink = plane(studio, PLANE_INKS + i);
        read_sum(studio, (enum painting_field)(PAINTING_WET + i), (enum painting_field)(PAINTING_DRY + i), ink);
        planes.ink[i] = ink;
    }
    picture_draw(studio->picture, &planes, studio->rgb);
    return image_write_png(path, studio->rgb, studio->width, studio->height, NULL, error);
}

static bool write_fields(struct studio *studio, const char *path, struct file_error *error)
{
    const char *names[PAINTING_FIELDS];
    const float *planes[PAINTING_FIELDS];
    float *values = malloc(PAINTING_FIELDS * studio->cells * sizeof *values);
    if (!values) {
        return file_fail(error, path, "memory is short for the fields");
    }
    for (int field = 0; field < PAINTING_FIELDS; field++) {
        float *at = values + (size_t)field * studio->cells;
        studio->engine->ops->read(studio->engine, (enum painting_field)field, at);
        names[field] = painting_field_name((enum painting_field)field);
        planes[field] = at;
    }
    struct image_def def = image_default_def();
    def.megabytes = 4096; /* our own planes, not a stranger's file */
    bool good = image_write_exr(path, names, planes, PAINTING_FIELDS, studio->script->width, studio->script->height,
                                &def, error);
    free(values);
    return good;
}

static bool write_plan(struct studio *studio, const char *path, struct file_error *error)
{
    const struct engine_ops *ops = studio->engine->ops;
    double paper = studio->def->paper_mm > 0 ? studio->def->paper_mm : PLAN_PAPER_MM;
    float *depth = malloc(2 * studio->cells * sizeof *depth);
    char *text = NULL;
    size_t size;
    if (depth) {
        ops->read(studio->engine, PAINTING_ACTIVE, depth);
        ops->read(studio->engine, PAINTING_CARVED, depth + studio->cells);
        for (size_t i = 0; i < studio->cells; i++) {
            depth[i] += depth[studio->cells + i];
        }
        text = plan_svg(depth, studio->script->width, studio->script->height, paper, &size);
    }
    bool good =
        text ? file_write_atomic(path, text, size, error) : file_fail(error, path, "memory is short for the plan");
    free(text);
    free(depth);
    return good;
}

static bool write_frame(struct studio *studio, struct file_error *error)
{
    const char *folder = studio->def->frames;
    int64_t tick = studio->engine->ops->ticks(studio->engine);
    if (!folder || tick % studio->def->every != 0) {
        return true;
    }
    size_t size = strlen(folder) + 32;
    char *path = malloc(size);
    if (!path) {
        return file_fail(error, folder, "memory is short for a frame");
    }
    snprintf(path, size, "%s/%06lld.png", folder, (long long)tick);
    bool good = write_picture(studio, path, error);
    free(path);
    return good;
}

/* The actions of a tick, then the tick; those of the very last tick too, so that a session can end with one. */
static bool run_session(struct studio *studio, struct progress *progress, struct file_error *error)
{
    const struct script *script = studio->script;
    int next = 0;
    bool good = true;
    for (int64_t tick = 0; good && tick <= script->ticks; tick++) {
        for (; next < script->action_count && script->actions[next].tick <= tick; next++) {
            studio->engine->ops->act(studio->engine, &script->actions[next]);
        }
        if (tick < script->ticks) {
            studio->engine->ops->tick(studio->engine);
            good = write_frame(studio, error);
        }
        if (progress) {
            progress_step(progress, tick, script->ticks);
        }
    }
    return good;
}

static bool write_end(struct studio *studio, struct file_error *error)
{
    const struct render_def *def = studio->def;
    return (!def->fields || write_fields(studio, def->fields, error)) &&
           (!def->stats || stats_write(def->stats, studio->script, studio->engine, error)) &&
           (!def->svg || write_plan(studio, def->svg, error)) &&
           (!def->picture || write_picture(studio, def->picture, error));
}

bool render(const struct script *script, const struct render_def *def, struct progress *progress,
            struct file_error *error)
{
    struct studio studio = {.script = script, .def = def};
    studio.width = def->width ? def->width : script->width;
    studio.height = def->height ? def->height : script->height;
    studio.cells = (size_t)script->width * (size_t)script->height;
    if (!check_file(def->picture, error) || !check_file(def->fields, error) || !check_file(def->stats, error) ||
        !check_file(def->svg, error) || !make_folder(def->frames, error)) {
        return false;
    }
    bool good = open_engine(&studio, error) && (open_picture(&studio) || short_of_memory(&studio, error));
    good = good && run_session(&studio, progress, error) && write_end(&studio, error);
    if (progress) {
        progress_end(progress);
    }
    free(studio.planes);
    free(studio.rgb);
    picture_destroy(studio.picture);
    engine_destroy(studio.engine);
    display_destroy(studio.display);
    return good;
}
