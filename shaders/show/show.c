#include "show.h"

#include <GLES3/gl31.h>

unsigned show_program(const struct shader_folder *folder, struct shader_error *error)
{
    return program_draw(folder, "cover.vert", "show.frag", NULL, error);
}

bool show_is_turned(const float turn[4])
{
    return turn[1] * turn[1] > 0.25f;
}

bool show_is_exact(int width, int height, int panel_width, int panel_height, const float turn[4])
{
    bool turned = show_is_turned(turn);
    return panel_width == (turned ? height : width) && panel_height == (turned ? width : height);
}

void show_over(void)
{
    glEnable(GL_BLEND);
    glBlendEquation(GL_FUNC_ADD);
    glBlendFunc(GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
}

void show_target(unsigned framebuffer, int width, int height)
{
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glViewport(0, 0, width, height);
    glDisable(GL_BLEND);
    glDisable(GL_DEPTH_TEST);
    glDisable(GL_STENCIL_TEST);
    glDisable(GL_SCISSOR_TEST);
    glDisable(GL_CULL_FACE);
    glDisable(GL_DITHER);
    glColorMask(GL_TRUE, GL_TRUE, GL_TRUE, GL_TRUE);
}

void show_sheet(const struct show *show, unsigned framebuffer, int panel_width, int panel_height, const float turn[4])
{
    show_target(framebuffer, panel_width, panel_height);
    glUseProgram(show->program);
    glUniform2i(0, panel_width, panel_height);
    glUniform2i(1, show->width, show->height);
    glUniformMatrix2fv(2, 1, GL_FALSE, turn);
    glUniform1i(3, show_is_exact(show->width, show->height, panel_width, panel_height, turn));
    glUniform1f(4, show->opacity);
    glUniform1i(5, show->clear);
    if (show->clear) {
        show_over();
    } else if (show->opacity < 1) {
        glEnable(GL_BLEND);
        glBlendEquation(GL_FUNC_ADD);
        glBlendFuncSeparate(GL_SRC_ALPHA, GL_ONE_MINUS_SRC_ALPHA, GL_ONE, GL_ONE_MINUS_SRC_ALPHA);
    }
    glActiveTexture(GL_TEXTURE0);
    glBindTexture(GL_TEXTURE_2D, show->texture);
    glDrawArrays(GL_TRIANGLES, 0, 3);
    glDisable(GL_BLEND);
}
