#include "pattern.h"

#include <stdio.h>
#include <stdlib.h>

#include <GLES3/gl31.h>

/* Red and green above, blue and grey below, and a white mark in the upper left corner, wider than high. */
static const char VERTEX[] = "#version 310 es\n"
                             "uniform mat2 turn;\n"
                             "out highp vec2 at;\n"
                             "void main() {\n"
                             "    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);\n"
                             "    at = vec2(corner.x, 1. - corner.y);\n"
                             "    gl_Position = vec4(turn * (corner * 2. - 1.), 0., 1.);\n"
                             "}\n";
static const char FRAGMENT[] = "#version 310 es\n"
                               "precision highp float;\n"
                               "in highp vec2 at;\n"
                               "out vec4 colour;\n"
                               "void main() {\n"
                               "    colour = at.y < .5 ? (at.x < .5 ? vec4(1, 0, 0, 1) : vec4(0, 1, 0, 1))\n"
                               "                       : (at.x < .5 ? vec4(0, 0, 1, 1) : vec4(.5, .5, .5, 1));\n"
                               "    if (at.x < .25 && at.y < .125) colour = vec4(1);\n"
                               "}\n";

static bool attach(GLuint program, GLenum type, const char *source)
{
    GLuint shader = glCreateShader(type);
    GLint done = 0;
    glShaderSource(shader, 1, &source, NULL);
    glCompileShader(shader);
    glGetShaderiv(shader, GL_COMPILE_STATUS, &done);
    glAttachShader(program, shader);
    glDeleteShader(shader);
    return done;
}

bool pattern_make(struct pattern *pattern)
{
    GLint done = 0;
    pattern->program = glCreateProgram();
    if (attach(pattern->program, GL_VERTEX_SHADER, VERTEX) && attach(pattern->program, GL_FRAGMENT_SHADER, FRAGMENT)) {
        glLinkProgram(pattern->program);
        glGetProgramiv(pattern->program, GL_LINK_STATUS, &done);
    }
    return done;
}

void pattern_drop(struct pattern *pattern)
{
    glDeleteProgram(pattern->program);
    pattern->program = 0;
}

void pattern_draw(const struct pattern *pattern, const struct display *display)
{
    struct display_size panel = display_panel(display);
    float turn[4];
    display_turn(display, turn);
    glViewport(0, 0, panel.width, panel.height);
    glUseProgram(pattern->program);
    glUniformMatrix2fv(glGetUniformLocation(pattern->program, "turn"), 1, GL_FALSE, turn);
    glDrawArrays(GL_TRIANGLE_STRIP, 0, 4);
}

void pattern_pixel(struct display_size sheet, int x, int y, uint8_t rgb[3])
{
    static const uint8_t QUARTERS[2][2][3] = {{{255, 0, 0}, {0, 255, 0}}, {{0, 0, 255}, {128, 128, 128}}};
    int across = 2 * x + 1, down = 2 * y + 1; /* of 2 width, 2 height: the pixel's middle */
    const uint8_t *quarter = QUARTERS[down >= sheet.height][across >= sheet.width];
    bool mark = 4 * across < 2 * sheet.width && 8 * down < 2 * sheet.height;
    for (int i = 0; i < 3; i++) {
        rgb[i] = mark ? 255 : quarter[i];
    }
}

long pattern_wrong(struct display_size sheet, const uint8_t *rgb)
{
    long wrong = 0;
    for (int y = 0; y < sheet.height; y++) {
        for (int x = 0; x < sheet.width; x++, rgb += 3) {
            uint8_t right[3];
            pattern_pixel(sheet, x, y, right);
            wrong += abs(rgb[0] - right[0]) > 1 || abs(rgb[1] - right[1]) > 1 || abs(rgb[2] - right[2]) > 1;
        }
    }
    return wrong;
}
