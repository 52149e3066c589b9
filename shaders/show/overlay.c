#include "overlay.h"

#include <math.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "show.h"
#include "texture.h"

struct piece {
    unsigned texture; /* 0: away */
    int width, height;
    struct overlay_place place;
};

struct overlay {
    unsigned program;
    struct piece pieces[OVERLAY_PIECES];
    uint64_t uploaded;
};

struct overlay *overlay_create(const struct shader_folder *folder, struct shader_error *error)
{
    struct overlay *overlay = calloc(1, sizeof *overlay);
    if (!overlay) {
        shader_fail(error, "memory is short for the overlay");
        return NULL;
    }
    overlay->program = program_draw(folder, "overlay.vert", "overlay.frag", NULL, error);
    if (!overlay->program) {
        free(overlay);
        return NULL;
    }
    for (int i = 0; i < OVERLAY_PIECES; i++) {
        overlay->pieces[i].place.opacity = 1;
    }
    return overlay;
}

void overlay_destroy(struct overlay *overlay)
{
    if (!overlay) {
        return;
    }
    for (int i = 0; i < OVERLAY_PIECES; i++) {
        texture_delete(&overlay->pieces[i].texture);
    }
    glDeleteProgram(overlay->program);
    free(overlay);
}

static struct texture_def texture_of(const struct piece *piece)
{
    return (struct texture_def){
        .format = TEXTURE_RGBA8, .filter = TEXTURE_LINEAR, .width = piece->width, .height = piece->height};
}

bool overlay_set(struct overlay *overlay, int number, const uint8_t *rgba, int width, int height)
{
    struct piece *piece = &overlay->pieces[number];
    glActiveTexture(GL_TEXTURE0);
    if (!rgba || piece->width != width || piece->height != height) {
        texture_delete(&piece->texture);
    }
    if (!rgba) {
        return true;
    }
    piece->width = width;
    piece->height = height;
    struct texture_def def = texture_of(piece);
    if (!piece->texture) {
        piece->texture = texture_create(&def);
    }
    if (!piece->texture) {
        return false;
    }
    texture_upload(piece->texture, &def, 0, 0, 0, width, height, rgba);
    overlay->uploaded += (uint64_t)width * (uint64_t)height * 4;
    return true;
}

void overlay_place(struct overlay *overlay, int piece, const struct overlay_place *place)
{
    overlay->pieces[piece].place = *place;
}

uint64_t overlay_uploaded(const struct overlay *overlay)
{
    return overlay->uploaded;
}

struct target {
    float width, height; /* of the sheet, pixels */
    bool exact;          /* a pixel of the sheet is one of the panel */
};

static void draw_piece(const struct piece *piece, const struct target *target)
{
    struct overlay_place place = piece->place;
    place.width = place.width > 0 ? place.width : (float)piece->width;
    place.height = place.height > 0 ? place.height : (float)piece->height;
    place.opacity = fminf(place.opacity, 1);
    /* Also false of a place that is not a number. */
    bool seen = piece->texture && place.opacity > 0 && place.x < target->width && place.y < target->height &&
                place.x + place.width > 0 && place.y + place.height > 0;
    if (!seen) {
        return;
    }
    bool exact = target->exact && place.width == (float)piece->width && place.height == (float)piece->height &&
                 place.x == floorf(place.x) && place.y == floorf(place.y);
    glUniform4f(3, place.x, place.y, place.width, place.height);
    glUniform1f(4, place.opacity);
    glUniform1i(5, exact);
    glBindTexture(GL_TEXTURE_2D, piece->texture);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void overlay_present(const struct overlay *overlay, unsigned framebuffer, int panel_width, int panel_height,
                     int sheet_width, int sheet_height, const float turn[4])
{
    struct target target = {.width = (float)sheet_width,
                            .height = (float)sheet_height,
                            .exact = show_is_exact(sheet_width, sheet_height, panel_width, panel_height, turn)};
    show_target(framebuffer, panel_width, panel_height);
    show_over();
    glUseProgram(overlay->program);
    glUniform2i(0, panel_width, panel_height);
    glUniform2f(1, target.width, target.height);
    glUniformMatrix2fv(2, 1, GL_FALSE, turn);
    glActiveTexture(GL_TEXTURE0);
    for (int i = 0; i < OVERLAY_PIECES; i++) {
        draw_piece(&overlay->pieces[i], &target);
    }
    glDisable(GL_BLEND);
}
