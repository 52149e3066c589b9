#include "grow.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit.h"
#include "ink.h"
#include "key_fields.h"

enum { DETAIL = 512, DETAIL_TREE = 640, SIZE_OVER = 3, SIZE_MOST = 8192 };

#define KEY_AT(field) offsetof(struct grow_def, field)

const struct key grow_keys[] = {
    WHOLE(detail, "nodes", 0, IMPORTANCE_SIZE_MAX, 0,
          "Nodes of the lattice along the longer side; 0: 512, of trees 640."),
    WHOLE(size, "pixels", 0, SIZE_MOST, 0,
          "Longer side of what is written; 0: three times the nodes, or as the background is."),
    NUMBER(height, "of the background", 0.05, 2, 0.72, "How high it stands in the background."),
    POINT(at, "Where in the background the middle of its foot is, x,y in 0..1."),
    END,
};

struct grow_def grow_default_def(void)
{
    struct grow_def def = {.growth = growth_preset(METAPHOR_INK, false)};
    key_defaults(grow_keys, &def);
    def.at = (struct point){0.5f, 0.93f};
    return def;
}

static bool read_background(struct grown *grown, struct file_error *error)
{
    struct image image;
    float *linear = NULL;
    bool good = fit_read(grown->def->background, &image, error);
    if (good) {
        int longer = image.width > image.height ? image.width : image.height;
        int side = grown->def->size > 0 ? grown->def->size : longer < SIZE_MOST ? longer : SIZE_MOST;
        fit_size(&image, side, &grown->width, &grown->height);
        linear = fit_linear(&image, grown->width, grown->height);
        size_t pixels = (size_t)grown->width * (size_t)grown->height;
        grown->background = malloc(3 * pixels * sizeof *grown->background);
        good = linear && grown->background;
        for (size_t i = 0; i < pixels && good; i++) {
            for (size_t c = 0; c < 3; c++) {
                float value = ink_encode(linear[4 * i + c]);
                grown->background[3 * i + c] = value < 0 ? 0 : value > 1 ? 1 : value;
            }
        }
        if (!good) {
            file_fail(error, grown->def->background, "memory is short");
        }
    }
    free(linear);
    image_finish(&image);
    return good;
}

struct growth *grow_over(const struct image *image, int side, const struct growth_def *def)
{
    int width, height;
    fit_size(image, side, &width, &height);
    width = width < GROWTH_SIZE_LEAST ? GROWTH_SIZE_LEAST : width;
    height = height < GROWTH_SIZE_LEAST ? GROWTH_SIZE_LEAST : height;
    struct growth *growth = NULL;
    float *linear = fit_linear(image, width, height);
    float *grey = malloc((size_t)width * (size_t)height * sizeof *grey);
    if (linear && grey) {
        importance_grey(linear, width, height, 4, 3, grey);
        growth = growth_create(grey, width, height, def);
    }
    free(linear);
    free(grey);
    return growth;
}

static bool read_picture(struct grown *grown, struct file_error *error)
{
    const struct grow_def *def = grown->def;
    struct image image;
    bool good = fit_read(def->picture, &image, error);
    if (good) {
        int side = def->detail >= GROWTH_SIZE_LEAST ? def->detail : def->growth.tree ? DETAIL_TREE : DETAIL;
        grown->growth = grow_over(&image, side, &def->growth);
        good = grown->growth || file_fail(error, def->picture, "memory is short");
    }
    image_finish(&image);
    return good;
}

/* Where the picture that it was grown over lies in the output. */
static void place(struct grown *grown)
{
    const struct grow_def *def = grown->def;
    float wide = (float)grown->growth->importance->width, high = (float)grown->growth->importance->height;
    if (grown->background) {
        grown->scale = def->height * (float)grown->height / high;
        grown->left = def->at.x * (float)grown->width - 0.5f * wide * grown->scale;
        grown->top = def->at.y * (float)grown->height - 0.965f * high * grown->scale;
        return;
    }
    float longer = wide > high ? wide : high;
    grown->scale = def->size > 0 ? (float)def->size / longer : SIZE_OVER;
    grown->width = (int)(wide * grown->scale + 0.5f);
    grown->height = (int)(high * grown->scale + 0.5f);
    grown->width = grown->width > 0 ? grown->width : 1;
    grown->height = grown->height > 0 ? grown->height : 1;
}

static bool write_one(const struct grown *grown, const char *path, struct file_error *error)
{
    const char *end = strrchr(path, '.');
    if (end && strcmp(end, ".svg") == 0) {
        return grow_write_svg(grown, path, error);
    }
    if (end && strcmp(end, ".exr") == 0) {
        return grow_write_exr(grown, path, error);
    }
    return grow_write_png(grown, path, error);
}

bool grow(const struct grow_def *def, struct file_error *error)
{
    struct grown grown = {.def = def};
    bool good = (!def->background || read_background(&grown, error)) && read_picture(&grown, error);
    if (good && !growth_strokes(grown.growth, &grown.strokes)) {
        good = file_fail(error, def->picture, "memory is short");
    }
    if (good) {
        place(&grown);
    }
    for (int i = 0; i < def->output_count && good; i++) {
        good = write_one(&grown, def->outputs[i], error);
    }
    good = good && (!def->stats || grow_write_stats(&grown, def->stats, error));
    growth_destroy(grown.growth);
    strokes_finish(&grown.strokes);
    free(grown.background);
    return good;
}
