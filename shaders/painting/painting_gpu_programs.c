/* Every compute program of the engine. */
#include <string.h>

#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

static const struct {
    const char *source, *defines; /* as program_compute takes them */
} SOURCES[GPU_PROGRAMS] = {
    [PROGRAM_FILL] = {"fill.comp", NULL},
    [PROGRAM_RECTANGLE] = {"rectangle.comp", NULL},
    [PROGRAM_WAKE] = {"wake.comp", NULL},
    [PROGRAM_MARK] = {"mark.comp", NULL},
    [PROGRAM_STIR] = {"stir.comp", NULL},
    [PROGRAM_OPENNESS] = {"openness.comp", NULL},
    [PROGRAM_FLUID] = {"fluid.comp", NULL},
    [PROGRAM_FLUID_STRIP] = {"fluid_strip.comp", NULL},
    [PROGRAM_PLAIN] = {"pattern_plain.comp", NULL},
    [PROGRAM_PLAIN_WHOLE] = {"pattern_plain.comp", "#define WHOLE"},
    [PROGRAM_PATCH] = {"pattern.comp", NULL},
    [PROGRAM_PATCH_WHOLE] = {"pattern.comp", "#define WHOLE"},
    [PROGRAM_STRIP] = {"pattern_strip.comp", NULL},
    [PROGRAM_DEPOSIT] = {"deposit.comp", NULL},
    [PROGRAM_GROUND] = {"ground.comp", NULL},
    [PROGRAM_COUNT] = {"upkeep_count.comp", NULL},
    [PROGRAM_PIGMENT] = {"upkeep_pigment.comp", NULL},
    [PROGRAM_SETTLE] = {"upkeep_settle.comp", NULL},
    [PROGRAM_PUBLISH + (int) FIELDS_GROUND] = {"publish.comp", "#define GROUND"},
    [PROGRAM_PUBLISH + (int) FIELDS_INK] = {"publish.comp", "#define INKS"},
    [PROGRAM_PUBLISH + (int) FIELDS_PATTERN] = {"publish.comp", "#define PATTERNS"},
    [PROGRAM_PUBLISH + (int) FIELDS_VECTORS] = {"publish.comp", "#define VECTORS"},
};

/* The uniforms of planes.glsl and tiles.glsl, where a program has them. */
static void set_layout(const struct painting_gpu *gpu, unsigned program)
{
    glUseProgram(program);
    glUniform4i(glGetUniformLocation(program, "planes"), gpu->width, gpu->height, gpu->stride,
                (GLint)gpu_plane_words(gpu));
    glUniform2i(glGetUniformLocation(program, "tile_counts"), gpu->columns, gpu->lines);
}

static void delete_all(const unsigned programs[GPU_PROGRAMS])
{
    for (int i = 0; i < GPU_PROGRAMS; i++) {
        glDeleteProgram(programs[i]);
    }
}

bool gpu_programs_make(struct painting_gpu *gpu, struct shader_error *error)
{
    unsigned made[GPU_PROGRAMS] = {0};
    for (int i = 0; i < GPU_PROGRAMS; i++) {
        made[i] = program_compute(&gpu->folder, SOURCES[i].source, SOURCES[i].defines, error);
        if (!made[i]) {
            delete_all(made);
            return false;
        }
        set_layout(gpu, made[i]);
    }
    delete_all(gpu->programs);
    memcpy(gpu->programs, made, sizeof made);
    return true;
}

void gpu_programs_delete(struct painting_gpu *gpu)
{
    glUseProgram(0); /* a program in use outlives its deletion */
    delete_all(gpu->programs);
    memset(gpu->programs, 0, sizeof gpu->programs);
}

void gpu_use(const struct painting_gpu *gpu, enum gpu_program program)
{
    glUseProgram(gpu->programs[program]);
}
