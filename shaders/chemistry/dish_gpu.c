#include "dish_gpu.h"

#include <math.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "gray_scott_picture.h"
#include "show.h"
#include "texture.h"

enum { SIDE_MOST = 2048, PATTERNS = 2 }; /* patterns: one comes while the other may still be read */

struct dish_gpu {
    const struct shader_folder *folder;
    struct gray_scott_picture *picture; /* NULL: none is drawn yet */
    int width, height;                  /* of it */
    bool clear;
    struct gray_scott_shade_def shade;
    bool other_shade;
    unsigned show, pattern[PATTERNS]; /* program; textures, 0: none */
    int newest;
    int cells_x, cells_y; /* of the textures */
};

struct dish_gpu *dish_gpu_create(const struct shader_folder *folder, struct shader_error *error)
{
    struct dish_gpu *dish = calloc(1, sizeof *dish);
    if (!dish) {
        shader_fail(error, "memory is short for the dish");
        return NULL;
    }
    dish->folder = folder;
    dish->shade = gray_scott_shade_default_def();
    dish->show = show_program(folder, error);
    if (!dish->show) {
        dish_gpu_destroy(dish);
        return NULL;
    }
    return dish;
}

static void delete_patterns(struct dish_gpu *dish)
{
    for (int i = 0; i < PATTERNS; i++) {
        texture_delete(&dish->pattern[i]);
    }
}

void dish_gpu_destroy(struct dish_gpu *dish)
{
    if (!dish) {
        return;
    }
    gray_scott_picture_destroy(dish->picture);
    delete_patterns(dish);
    glDeleteProgram(dish->show);
    free(dish);
}

void dish_gpu_look(struct dish_gpu *dish, const struct gray_scott_shade_def *shade)
{
    dish->shade = *shade;
    dish->other_shade = true;
}

bool dish_gpu_set(struct dish_gpu *dish, const struct pattern_plane *plane)
{
    const struct texture_def def = {
        .format = TEXTURE_R32F, .width = plane->width, .height = plane->height, .spread = true};
    glActiveTexture(GL_TEXTURE0);
    if (plane->width != dish->cells_x || plane->height != dish->cells_y) {
        delete_patterns(dish);
        dish->cells_x = plane->width;
        dish->cells_y = plane->height;
    }
    int next = (dish->newest + 1) % PATTERNS;
    if (!dish->pattern[next]) {
        dish->pattern[next] = texture_create(&def);
    }
    if (!dish->pattern[next]) {
        return false;
    }
    texture_upload(dish->pattern[next], &def, 0, 0, 0, plane->width, plane->height, plane->v);
    dish->newest = next;
    return true;
}

/* A picture of this size. */
static bool fit(struct dish_gpu *dish, int width, int height, struct shader_error *error)
{
    float scale = fminf(1, (float)SIDE_MOST / (float)(width > height ? width : height));
    int across = (int)lroundf((float)width * scale), down = (int)lroundf((float)height * scale);
    if (dish->picture && dish->width == across && dish->height == down) {
        return true;
    }
    gray_scott_picture_destroy(dish->picture);
    dish->picture = gray_scott_picture_create(across, down, dish->folder, error);
    dish->width = across;
    dish->height = down;
    dish->other_shade = true;
    return dish->picture;
}

bool dish_gpu_draw(struct dish_gpu *dish, const struct torus_def *torus, bool clear, int width, int height,
                   struct shader_error *error)
{
    unsigned pattern = dish->pattern[dish->newest];
    if (!pattern || width < 1 || height < 1) {
        return true;
    }
    glActiveTexture(GL_TEXTURE0);
    if (!fit(dish, width, height, error)) {
        return false;
    }
    if (dish->other_shade) {
        gray_scott_picture_set(dish->picture, &dish->shade);
        dish->other_shade = false;
    }
    dish->clear = clear;
    gray_scott_picture_clear(dish->picture, clear);
    if (torus) {
        gray_scott_picture_torus(dish->picture, pattern, torus);
    } else {
        gray_scott_picture_shade(dish->picture, pattern, dish->cells_x, dish->cells_y);
    }
    return true;
}

void dish_gpu_present(const struct dish_gpu *dish, float opacity, unsigned framebuffer, int panel_width,
                      int panel_height, const float turn[4])
{
    if (dish->picture && opacity > 0) {
        const struct show show = {.program = dish->show,
                                  .texture = gray_scott_picture_texture(dish->picture),
                                  .width = dish->width,
                                  .height = dish->height,
                                  .opacity = fminf(opacity, 1),
                                  .clear = dish->clear};
        show_sheet(&show, framebuffer, panel_width, panel_height, turn);
    }
}
