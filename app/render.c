#include "render.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "image.h"
#include "painting.h"
#include "picture.h"
#include "stats.h"

/* Everything a session needs while it runs. */
struct studio {
    const struct script *script;
    const struct render_def *def;
    struct painting *painting;
    struct picture *picture;
    float *planes; /* depth, solvent, mask, inks, and one to spare */
    uint8_t *rgb;
    int width, height; /* pixels */
    size_t cells;
};

enum { PLANE_DEPTH, PLANE_SOLVENT, PLANE_MASK, PLANE_INKS, PLANE_SPARE = PLANE_INKS + PAINTING_INKS, PLANES };

struct render_def render_default_def(void)
{
    return (struct render_def){.every = RENDER_EVERY};
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

static bool open_painting(struct studio *studio)
{
    struct painting_def def = painting_default_def();
    def.width = studio->script->width;
    def.height = studio->script->height;
    def.margin = studio->script->margin;
    def.seed = (uint32_t)studio->script->seed;
    def.threads = studio->def->threads;
    def.dense = studio->def->dense;
    def.coefficients = studio->script->coefficients;
    studio->painting = painting_create(&def);
    return studio->painting;
}

static bool open_picture(struct studio *studio)
{
    if (!studio->def->picture && !studio->def->frames) {
        return true;
    }
    struct picture_def def = picture_default_def();
    long processors = sysconf(_SC_NPROCESSORS_ONLN);
    long threads = studio->def->threads ? studio->def->threads : processors;
    def.width = studio->width;
    def.height = studio->height;
    def.cells_x = studio->script->width;
    def.cells_y = studio->script->height;
    def.mixing = (enum ink_mixing)studio->script->mode;
    def.seed = (uint32_t)studio->script->seed;
    def.threads = threads < 1 ? 1 : threads > PICTURE_THREADS_MAX ? PICTURE_THREADS_MAX : (int)threads;
    for (int i = 0; i < INK_PALETTE; i++) {
        def.ink[i] = studio->script->inks[i < studio->script->ink_count ? i : 0];
    }
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
    painting_read(studio->painting, a, sum);
    painting_read(studio->painting, b, spare);
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
    painting_read(studio->painting, PAINTING_SOLVENT, plane(studio, PLANE_SOLVENT));
    painting_read(studio->painting, PAINTING_MASK, plane(studio, PLANE_MASK));
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
        painting_read(studio->painting, (enum painting_field)field, at);
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

static bool write_frame(struct studio *studio, struct file_error *error)
{
    const char *folder = studio->def->frames;
    int64_t tick = painting_ticks(studio->painting);
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
            painting_act(studio->painting, &script->actions[next]);
        }
        if (tick < script->ticks) {
            painting_tick(studio->painting);
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
           (!def->stats || stats_write(def->stats, studio->script, studio->painting, error)) &&
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
        !make_folder(def->frames, error)) {
        return false;
    }
    bool good = open_painting(&studio) && open_picture(&studio);
    if (!good) {
        file_fail(error, "the painting", "memory is short for %dx%d cells and %dx%d pixels", script->width,
                  script->height, studio.width, studio.height);
    }
    good = good && run_session(&studio, progress, error) && write_end(&studio, error);
    if (progress) {
        progress_end(progress);
    }
    free(studio.planes);
    free(studio.rgb);
    picture_destroy(studio.picture);
    painting_destroy(studio.painting);
    return good;
}
