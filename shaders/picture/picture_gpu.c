#include "picture_gpu.h"

#include <stdlib.h>

#include <GLES3/gl31.h>

#include "picture_gpu_state.h"
#include "show.h"

/* A histogram of 1024 bins, a word for the mask, the tone that is followed. */
enum { TONE_BYTES = 1026 * 4 };

static bool compile(const struct picture_gpu *picture, unsigned program[PASSES], struct shader_error *error)
{
    const struct shader_folder *folder = &picture->folder;
    const char *flat = picture->def.plain ? "#define PLAIN 1\n" : "#define PLAIN 0\n";
    const char *shade[2][2] = {{"#define PLAIN 0\n#define CMY 0\n", "#define PLAIN 0\n#define CMY 1\n"},
                               {"#define PLAIN 1\n#define CMY 0\n", "#define PLAIN 1\n#define CMY 1\n"}};
    const char *names[PASSES] = {
        [PASS_TONE] = "picture_tone.comp", [PASS_DEPTH] = "picture_depth.comp", [PASS_ACROSS] = "picture_across.comp",
        [PASS_DOWN] = "picture_down.comp", [PASS_TALL] = "picture_tall.comp",   [PASS_SHADE] = "picture_shade.frag"};
    for (int pass = 0; pass < PASS_SHOW; pass++) {
        const char *defines = pass == PASS_DOWN ? flat : NULL;
        if (pass == PASS_SHADE) {
            defines = shade[picture->def.plain][picture->def.mixing == INK_CMY];
        }
        program[pass] = pass < PASS_SHADE ? program_compute(folder, names[pass], defines, error)
                                          : program_draw(folder, "cover.vert", names[pass], defines, error);
        if (!program[pass]) {
            return false;
        }
    }
    program[PASS_SHOW] = show_program(folder, error);
    return program[PASS_SHOW];
}

static void delete_programs(unsigned program[PASSES])
{
    for (int pass = 0; pass < PASSES; pass++) {
        glDeleteProgram(program[pass]);
        program[pass] = 0;
    }
}

bool picture_gpu_reload(struct picture_gpu *picture, struct shader_error *error)
{
    unsigned program[PASSES] = {0};
    if (!compile(picture, program, error)) {
        delete_programs(program);
        return false;
    }
    delete_programs(picture->program);
    for (int pass = 0; pass < PASSES; pass++) {
        picture->program[pass] = program[pass];
    }
    return true;
}

void picture_gpu_restart(struct picture_gpu *picture)
{
    static const unsigned zeros[TONE_BYTES / 4];
    glBindBuffer(GL_SHADER_STORAGE_BUFFER, picture->tone);
    glBufferData(GL_SHADER_STORAGE_BUFFER, TONE_BYTES, zeros, GL_DYNAMIC_COPY);
}

static bool make_buffers(struct picture_gpu *picture, struct shader_error *error)
{
    glGenBuffers(1, &picture->tone);
    picture_gpu_restart(picture);
    picture->framebuffer = texture_framebuffer(picture->texture[PICTURE_SHEET]);
    return picture->framebuffer != 0 ||
           shader_fail(error, "no framebuffer for a picture of %dx%d", picture->def.width, picture->def.height);
}

struct picture_gpu *picture_gpu_create(const struct picture_def *def, const struct shader_folder *folder,
                                       struct shader_error *error)
{
    if (!picture_valid(def)) {
        shader_fail(error, "a picture of %dx%d pixels, %dx%d cells is out of range", def->width, def->height,
                    def->cells_x, def->cells_y);
        return NULL;
    }
    struct picture_gpu *picture = calloc(1, sizeof *picture);
    if (!picture) {
        shader_fail(error, "memory is short for the picture");
        return NULL;
    }
    picture->def = *def;
    picture->folder.path = folder ? folder->path : NULL;
    if (!compile(picture, picture->program, error) || !picture_gpu_textures(picture, error) ||
        !make_buffers(picture, error)) {
        picture_gpu_destroy(picture);
        return NULL;
    }
    return picture;
}

void picture_gpu_destroy(struct picture_gpu *picture)
{
    if (!picture) {
        return;
    }
    delete_programs(picture->program);
    for (int i = 0; i < PICTURE_TEXTURES; i++) {
        texture_delete(&picture->texture[i]);
    }
    glDeleteFramebuffers(1, &picture->framebuffer);
    glDeleteBuffers(1, &picture->tone);
    free(picture);
}

size_t picture_gpu_bytes(const struct picture_gpu *picture)
{
    return picture->bytes;
}
