#include "easel.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "display.h"
#include "gpu_limits.h"
#include "image.h"
#include "painting_gpu.h"
#include "plan.h"

enum { PLANE_DEPTH, PLANE_SOLVENT, PLANE_MASK, PLANE_INKS, PLANE_SPARE = PLANE_INKS + PAINTING_INKS, PLANES };

bool easel_check_file(const char *path, struct file_error *error)
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

/* A GL context, which the engine of the GPU lives in. */
static bool open_display(struct easel *easel, struct file_error *error)
{
    struct display_def def = display_default_def();
    struct device_error reason;
    def.kind = DISPLAY_HEADLESS;
    def.width = def.height = 16; /* nothing is shown */
    easel->display = easel->display ? easel->display : display_create(&def, &reason);
    return easel->display || file_fail(error, "the GPU", "%s", reason.text);
}

struct engine *easel_engine(struct easel *easel, const struct painting_def *painting, struct file_error *error)
{
    struct painting_def def = *painting;
    const struct shader_folder shaders = {easel->def.shaders}, *folder = shaders.path ? &shaders : NULL;
    def.threads = easel->def.threads;
    def.dense = easel->def.dense;
    if (easel->def.engine == ENGINE_AUTO) {
        char path[1200];
        bool have = open_display(easel, error);
        easel->def.engine = engine_choose(ENGINE_AUTO, &def, have ? gpu_limits_renderer() : NULL, folder,
                                          engine_choice_path(path, sizeof path) ? path : NULL)
                                .kind;
    } else if (easel->def.engine == ENGINE_GPU && !open_display(easel, error)) {
        return NULL;
    }
    struct shader_error reason;
    bool gpu = easel->def.engine == ENGINE_GPU;
    struct engine *engine = gpu ? engine_gpu_create(&def, folder, &reason) : engine_cpu_create(&def);
    if (!engine && gpu) {
        file_fail(error, "the GPU", "%s", reason.text);
    } else if (!engine) {
        file_fail(error, "the painting", "memory is short for %dx%d cells", def.width, def.height);
    }
    return engine;
}

struct engine *easel_make(void *easel, const struct painting_def *painting, struct file_error *error)
{
    return easel_engine(easel, painting, error);
}

void easel_close(struct easel *easel)
{
    display_destroy(easel->display);
    easel->display = NULL;
}

void easel_unframe(struct easel_picture *picture)
{
    picture_destroy(picture->picture);
    free(picture->planes);
    free(picture->rgb);
    *picture = (struct easel_picture){.picture = NULL};
}

bool easel_frame(const struct easel *easel, struct easel_picture *picture, const struct picture_def *def, int ink_count)
{
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    long threads = easel->def.threads ? easel->def.threads : processors;
    size_t cells = (size_t)def->cells_x * (size_t)def->cells_y;
    easel_unframe(picture);
    picture->def = *def;
    picture->def.threads = threads < 1 ? 1 : threads > PICTURE_THREADS_MAX ? PICTURE_THREADS_MAX : (int)threads;
    picture->ink_count = ink_count;
    picture->picture = picture_create(&picture->def);
    picture->rgb = malloc((size_t)def->width * (size_t)def->height * 3);
    picture->planes = malloc(PLANES * cells * sizeof *picture->planes);
    bool good = picture->picture && picture->rgb && picture->planes;
    if (!good) {
        easel_unframe(picture);
    }
    return good;
}

static float *plane(const struct easel_picture *picture, int index)
{
    return picture->planes + (size_t)index * (size_t)picture->def.cells_x * (size_t)picture->def.cells_y;
}

static void read_sum(const struct easel_picture *picture, struct engine *engine, enum painting_field a,
                     enum painting_field b, float *sum)
{
    float *spare = plane(picture, PLANE_SPARE);
    size_t cells = (size_t)picture->def.cells_x * (size_t)picture->def.cells_y;
    engine->ops->read(engine, a, sum);
    engine->ops->read(engine, b, spare);
    for (size_t i = 0; i < cells; i++) {
        sum[i] += spare[i];
    }
}

bool easel_draw(struct easel_picture *picture, const struct easel_scene *scene, struct file_error *error)
{
    struct engine *engine = scene->engine;
    struct picture_planes planes = {.depth = plane(picture, PLANE_DEPTH),
                                    .solvent = plane(picture, PLANE_SOLVENT),
                                    .mask = plane(picture, PLANE_MASK)};
    read_sum(picture, engine, PAINTING_ACTIVE, PAINTING_CARVED, plane(picture, PLANE_DEPTH));
    engine->ops->read(engine, PAINTING_SOLVENT, plane(picture, PLANE_SOLVENT));
    engine->ops->read(engine, PAINTING_MASK, plane(picture, PLANE_MASK));
    for (int i = 0; i < picture->ink_count; i++) {
        float *ink = plane(picture, PLANE_INKS + i);
        read_sum(picture, engine, (enum painting_field)(PAINTING_WET + i), (enum painting_field)(PAINTING_DRY + i),
                 ink);
        planes.ink[i] = ink;
    }
    picture_draw(picture->picture, &planes, picture->rgb);
    return !scene->plot ||
           plot_lay(scene->plot, scene->ticked, picture->def.width, picture->def.height, picture->rgb) ||
           file_fail(error, "the picture", "memory is short for what has grown over it");
}

bool easel_write(struct easel_picture *picture, const struct easel_scene *scene, const char *path,
                 struct file_error *error)
{
    return easel_draw(picture, scene, error) &&
           image_write_png(path, picture->rgb, picture->def.width, picture->def.height, NULL, error);
}

bool easel_write_frame(struct easel_picture *picture, const struct easel_scene *scene, const char *folder,
                       struct file_error *error)
{
    size_t size = strlen(folder) + 32;
    char *path = malloc(size);
    if (!path) {
        return file_fail(error, folder, "memory is short for a frame");
    }
    snprintf(path, size, "%s/%06lld.png", folder, (long long)scene->ticked);
    bool good = easel_write(picture, scene, path, error);
    free(path);
    return good;
}

bool easel_write_plan(struct engine *engine, double paper_mm, const char *path, struct file_error *error)
{
    const struct engine_ops *ops = engine->ops;
    struct painting_def def = ops->get_def(engine);
    size_t cells = (size_t)def.width * (size_t)def.height, size;
    float *depth = malloc(2 * cells * sizeof *depth);
    char *text = NULL;
    if (depth) {
        ops->read(engine, PAINTING_ACTIVE, depth);
        ops->read(engine, PAINTING_CARVED, depth + cells);
        for (size_t i = 0; i < cells; i++) {
            depth[i] += depth[cells + i];
        }
        text = plan_svg(depth, def.width, def.height, paper_mm > 0 ? paper_mm : PLAN_PAPER_MM, &size);
    }
    bool good =
        text ? file_write_atomic(path, text, size, error) : file_fail(error, path, "memory is short for the plan");
    free(text);
    free(depth);
    return good;
}
