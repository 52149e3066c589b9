/* What GLES 3.1 promises of every device, and whether this one keeps it. A driver that offers less is broken for us: it
 * is better told so at start than by a shader that does not link, or a sheet that stays white.
 * Source: the OpenGL ES 3.1 specification, implementation-dependent values, tables 20.40 to 20.47. */
#ifndef FROND_GPU_LIMITS_H
#define FROND_GPU_LIMITS_H

#include <stdbool.h>

#include "program.h"

struct gpu_limit {
    const char *name;   /* without GL_; "MAX_COMPUTE_WORK_GROUP_SIZE" */
    unsigned pname;     /* of glGetInteger64v */
    int index;          /* of glGetIntegeri_v; -1: not indexed */
    long long promised; /* at least so much; an alignment: at most so much */
    bool alignment;
};
/* Those that our shaders and buffers lean on; ends with a limit whose name is NULL. */
extern const struct gpu_limit gpu_limits[];

/* Reads one limit: false when GL does not know it. */
typedef bool gpu_limit_reader(void *context, const struct gpu_limit *limit, long long *value);

/* Checks the current GL context. False with every limit that is not kept in `error`: "this GPU offers less than
 * GLES 3.1 promises: MAX_COMPUTE_IMAGE_UNIFORMS is 0, promised 4". */
bool gpu_limits_check(struct shader_error *error);
/* The same with any reader, for tests. */
bool gpu_limits_check_with(gpu_limit_reader *reader, void *context, struct shader_error *error);

/* The name of the GPU of the current context, as its driver gives it; NULL without one. */
const char *gpu_limits_renderer(void);
/* Whether a GPU of this name (NULL: no) is the processor itself, by Mesa or SwiftShader. */
bool gpu_limits_is_processor(const char *renderer);

#endif
