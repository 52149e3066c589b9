/* What is on the screen, as it is looked at (display.h). */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "display_rotation.h"
#include "display_source.h"

/* Where in the framebuffer, counted from GL's lower left, the pixel of the sheet lies. */
static size_t framebuffer_index(const struct display *display, int x, int y)
{
    struct display_size panel = display->panel;
    rotation_pixel(display->def.rotation, panel.width, panel.height, &x, &y);
    int row = display->flipped ? y : panel.height - 1 - y;
    return (size_t)row * (size_t)panel.width + (size_t)x;
}

bool display_capture(struct display *display, uint8_t *rgb)
{
    struct display_size panel = display->panel, sheet = display_sheet(display);
    if (!display->drawn || display->lost || !display_egl_enter(&display->egl)) {
        return false;
    }
    uint8_t *pixels = malloc((size_t)panel.width * (size_t)panel.height * 4);
    if (!pixels) {
        return false;
    }
    glBindFramebuffer(GL_FRAMEBUFFER, display->last);
    glBindBuffer(GL_PIXEL_PACK_BUFFER, 0);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glPixelStorei(GL_PACK_ROW_LENGTH, 0);
    glPixelStorei(GL_PACK_SKIP_PIXELS, 0);
    glPixelStorei(GL_PACK_SKIP_ROWS, 0);
    glReadPixels(0, 0, panel.width, panel.height, GL_RGBA, GL_UNSIGNED_BYTE, pixels);
    for (int y = 0; y < sheet.height; y++) {
        for (int x = 0; x < sheet.width; x++) {
            const uint8_t *pixel = pixels + 4 * framebuffer_index(display, x, y);
            *rgb++ = pixel[0];
            *rgb++ = pixel[1];
            *rgb++ = pixel[2];
        }
    }
    free(pixels);
    return true;
}
