#include "panel_case.h"

#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display_rotation.h"
#include "gpu_case.h"
#include "texture.h"

struct panel_case panel_case_make(int width, int height, int rotation, bool flipped)
{
    struct panel_case panel = {.width = width, .height = height, .rotation = rotation, .flipped = flipped};
    panel.panel_width = rotation % 180 ? height : width;
    panel.panel_height = rotation % 180 ? width : height;
    panel.bytes = malloc((size_t)width * (size_t)height * 4);
    assert_non_null(panel.bytes);
    rotation_matrix(rotation, flipped, panel.turn);
    panel.display = gpu_display();
    panel.texture = texture_create(
        &(struct texture_def){TEXTURE_RGBA8, TEXTURE_NEAREST, panel.panel_width, panel.panel_height, 0, false});
    panel.framebuffer = texture_framebuffer(panel.texture);
    assert_int_not_equal(panel.framebuffer, 0);
    return panel;
}

void panel_case_finish(struct panel_case *panel)
{
    glDeleteFramebuffers(1, &panel->framebuffer);
    texture_delete(&panel->texture);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    display_destroy(panel->display);
    free(panel->bytes);
}

/* Where in the framebuffer a pixel of the sheet lies. */
static uint8_t *pixel_at(const struct panel_case *panel, int i)
{
    int x = i % panel->width, y = i / panel->width;
    rotation_pixel(panel->rotation, panel->panel_width, panel->panel_height, &x, &y);
    int row = panel->flipped ? y : panel->panel_height - 1 - y;
    return panel->bytes + 4 * ((size_t)row * (size_t)panel->panel_width + (size_t)x);
}

void panel_case_lay(struct panel_case *panel, const uint8_t *rgb)
{
    for (int i = 0; i < panel->width * panel->height; i++) {
        uint8_t *pixel = pixel_at(panel, i);
        memcpy(pixel, rgb + 3 * (size_t)i, 3);
        pixel[3] = 255;
    }
    texture_upload(panel->texture, &(struct texture_def){.format = TEXTURE_RGBA8}, 0, 0, 0, panel->panel_width,
                   panel->panel_height, panel->bytes);
}

void panel_case_read(struct panel_case *panel, uint8_t *rgb)
{
    assert_false(glIsEnabled(GL_BLEND) || glIsEnabled(GL_DEPTH_TEST));
    glBindFramebuffer(GL_FRAMEBUFFER, panel->framebuffer);
    glReadPixels(0, 0, panel->panel_width, panel->panel_height, GL_RGBA, GL_UNSIGNED_BYTE, panel->bytes);
    for (int i = 0; i < panel->width * panel->height; i++) {
        const uint8_t *pixel = pixel_at(panel, i);
        memcpy(rgb + 3 * (size_t)i, pixel, 3);
        assert_int_equal(pixel[3], 255);
    }
    assert_int_equal(glGetError(), GL_NO_ERROR);
}

const char *panel_case_way(const struct panel_case *panel)
{
    static const char *const WAYS[4][2] = {{", upright", ", upright, flipped"},
                                           {", at 90 degrees", ", at 90 degrees, flipped"},
                                           {", at 180 degrees", ", at 180 degrees, flipped"},
                                           {", at 270 degrees", ", at 270 degrees, flipped"}};
    return WAYS[panel->rotation / 90 % 4][panel->flipped];
}
