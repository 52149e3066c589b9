/* What is on the screen, as it is looked at (display.h). */
#include <stdlib.h>

#include <GLES3/gl31.h>

#include "display_source.h"

/* Where in the framebuffer, counted from GL's lower left, the pixel of the sheet lies. */
static size_t framebuffer_index(const struct display *display, int x, int y)
{
    struct display_size panel = display->panel;
    int across = x, down = y;
    switch (display->def.rotation) {
    case 90:
        across = panel.width - 1 - y;
        down = x;
        break;
    case 180:
        across = panel.width - 1 - x;
        down = panel.height - 1 - y;
        break;
    case 270:
        across = y;
        down = panel.height - 1 - x;
        break;
    default:
        break;
    }
    int row = display->flipped ? down : panel.height - 1 - down;
    return (size_t)row * (size_t)panel.width + (size_t)across;
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
    glBindFramebuffer(GL_FRAMEBUFFER, display->framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
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
