#include "display_canvas.h"

#include <GLES3/gl31.h>

bool display_canvas_make(struct display_canvas *canvas, int width, int height)
{
    glGenTextures(1, &canvas->colour);
    glBindTexture(GL_TEXTURE_2D, canvas->colour);
    glTexStorage2D(GL_TEXTURE_2D, 1, GL_RGBA8, width, height);
    glGenFramebuffers(1, &canvas->framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, canvas->framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, canvas->colour, 0);
    if (glCheckFramebufferStatus(GL_FRAMEBUFFER) != GL_FRAMEBUFFER_COMPLETE) {
        display_canvas_drop(canvas);
        return false;
    }
    return true;
}

void display_canvas_drop(struct display_canvas *canvas)
{
    glDeleteFramebuffers(1, &canvas->framebuffer);
    glDeleteTextures(1, &canvas->colour);
    *canvas = (struct display_canvas){0};
}
