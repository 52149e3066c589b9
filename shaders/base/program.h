/* Programs of the GPU: GLSL ES 3.10 sources, embedded at build or read from a folder while one works on them, put
 * together and compiled in the current GL context.
 *
 * A source is a file of a folder of shaders/, known by its name alone: NAME.comp, NAME.vert, NAME.frag are stages,
 * NAME.glsl are included by `#include "NAME.glsl"` (a line of its own, in any source, each file once a program). The
 * first line, `#version 310 es`, and the precisions are put in front of every stage by the library: a source begins
 * without them. The sets of #defines that a stage is compiled with stand in it as `#variant` lines (variant.h); no
 * others are taken. */
#ifndef FROND_PROGRAM_H
#define FROND_PROGRAM_H

#include <stdbool.h>
#include <stddef.h>

#include "variant.h"

enum {
    PROGRAM_INVOCATIONS = 128,    /* a group: all that GLES 3.1 promises (GL_MAX_COMPUTE_WORK_GROUP_INVOCATIONS) */
    PROGRAM_SHARED_BYTES = 16384, /* GL_MAX_COMPUTE_SHARED_MEMORY_SIZE */
    PROGRAM_BLOCKS = 4,           /* GL_MAX_COMPUTE_SHADER_STORAGE_BLOCKS */
    PROGRAM_IMAGES = 4,           /* GL_MAX_COMPUTE_IMAGE_UNIFORMS */
};

struct shader_error {
    char text[1000]; /* file, line and what the compiler says */
};

bool shader_fail(struct shader_error *error, const char *format, ...) __attribute__((format(printf, 2, 3)));

struct shader_source {
    const char *name; /* "pattern.comp" */
    const char *text;
};
/* What was embedded; ends with a source whose name is NULL. */
extern const struct shader_source shader_sources[];

/* Where sources come from: a folder that has them, or has folders that do, as shaders/ has. NULL stands for the
 * embedded ones everywhere below. */
struct shader_folder {
    const char *path;
};
/* Changes whenever a source of the folder does: the newest time of modification in it, ns. 0 for the embedded. */
long long shader_folder_stamp(const struct shader_folder *folder);

/* The whole text of a stage: version, precisions, `defines` (lines of #define that are one of its variants, or NULL),
 * includes in place, before each `// NUMBER: NAME` of the file whose number `#line` gives. Owned by the caller (free).
 * NULL with the reason in `error`. */
char *shader_text(const struct shader_folder *folder, const char *name, const char *defines,
                  struct shader_error *error);

/* variant_defines of a stage, wherever it comes from; false also when there is no such source. */
bool shader_variant(const struct shader_folder *folder, const char *name, int index, char defines[VARIANT_TEXT]);

/* GL names of linked programs; 0 with the reason in `error`. Delete with glDeleteProgram. The vertex stage of a drawing
 * takes the defines where they are a variant of it, and none otherwise. */
unsigned program_compute(const struct shader_folder *folder, const char *name, const char *defines,
                         struct shader_error *error);
unsigned program_draw(const struct shader_folder *folder, const char *vertex, const char *fragment, const char *defines,
                      struct shader_error *error);

#endif
