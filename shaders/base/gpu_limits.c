#include "gpu_limits.h"

#include <stdio.h>
#include <string.h>

#include <GLES3/gl31.h>

#define LEAST(name, least)                                                                                             \
    {                                                                                                                  \
#name, GL_##name, -1, least, false                                                                             \
    }
#define LEAST_AT(name, index, least)                                                                                   \
    {                                                                                                                  \
#name, GL_##name, index, least, false                                                                          \
    }
#define MOST(name, most)                                                                                               \
    {                                                                                                                  \
#name, GL_##name, -1, most, true                                                                               \
    }

const struct gpu_limit gpu_limits[] = {
    LEAST(MAX_COMPUTE_WORK_GROUP_INVOCATIONS, PROGRAM_INVOCATIONS),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_SIZE, 0, 128),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_SIZE, 1, 128),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_SIZE, 2, 64),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_COUNT, 0, 65535),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_COUNT, 1, 65535),
    LEAST_AT(MAX_COMPUTE_WORK_GROUP_COUNT, 2, 65535),
    LEAST(MAX_COMPUTE_SHARED_MEMORY_SIZE, PROGRAM_SHARED_BYTES),
    LEAST(MAX_COMPUTE_SHADER_STORAGE_BLOCKS, PROGRAM_BLOCKS),
    LEAST(MAX_SHADER_STORAGE_BUFFER_BINDINGS, PROGRAM_BLOCKS),
    LEAST(MAX_SHADER_STORAGE_BLOCK_SIZE, 1 << 27),
    MOST(SHADER_STORAGE_BUFFER_OFFSET_ALIGNMENT, 256),
    LEAST(MAX_COMPUTE_IMAGE_UNIFORMS, PROGRAM_IMAGES),
    LEAST(MAX_IMAGE_UNITS, PROGRAM_IMAGES),
    LEAST(MAX_COMBINED_SHADER_OUTPUT_RESOURCES, 4),
    LEAST(MAX_COMPUTE_TEXTURE_IMAGE_UNITS, 16),
    LEAST(MAX_TEXTURE_IMAGE_UNITS, 16),
    LEAST(MAX_COMPUTE_UNIFORM_BLOCKS, 12),
    LEAST(MAX_FRAGMENT_UNIFORM_BLOCKS, 12),
    LEAST(MAX_UNIFORM_BUFFER_BINDINGS, 36),
    LEAST(MAX_UNIFORM_BLOCK_SIZE, 16384),
    MOST(UNIFORM_BUFFER_OFFSET_ALIGNMENT, 256),
    LEAST(MAX_COMPUTE_UNIFORM_COMPONENTS, 512),
    LEAST(MAX_FRAGMENT_UNIFORM_VECTORS, 224),
    LEAST(MAX_VERTEX_UNIFORM_VECTORS, 256),
    LEAST(MAX_TEXTURE_SIZE, 2048),
    LEAST(MAX_ARRAY_TEXTURE_LAYERS, 256),
    LEAST(MAX_DRAW_BUFFERS, 4),
    {.name = NULL},
};

static bool read_limit(void *context, const struct gpu_limit *limit, long long *value)
{
    GLint indexed = 0;
    GLint64 single = 0;
    (void)context;
    while (glGetError() != GL_NO_ERROR) { /* somebody else's */
    }
    if (limit->index >= 0) {
        glGetIntegeri_v(limit->pname, (GLuint)limit->index, &indexed);
    } else {
        glGetInteger64v(limit->pname, &single);
    }
    *value = limit->index >= 0 ? indexed : single;
    return glGetError() == GL_NO_ERROR;
}

bool gpu_limits_check_with(gpu_limit_reader *reader, void *context, struct shader_error *error)
{
    char text[sizeof error->text] = "";
    size_t length = 0;
    for (const struct gpu_limit *limit = gpu_limits; limit->name && length < sizeof text; limit++) {
        char index[16] = "";
        long long value = 0;
        bool known = reader(context, limit, &value);
        if (known && (limit->alignment ? value <= limit->promised : value >= limit->promised)) {
            continue;
        }
        if (limit->index >= 0) {
            snprintf(index, sizeof index, "[%d]", limit->index);
        }
        const char *between = length ? "; " : "";
        int added = known ? snprintf(text + length, sizeof text - length, "%s%s%s is %lld, promised %lld", between,
                                     limit->name, index, value, limit->promised)
                          : snprintf(text + length, sizeof text - length, "%s%s%s is unknown, promised %lld", between,
                                     limit->name, index, limit->promised);
        length += (size_t)added;
    }
    return length == 0 || shader_fail(error, "this GPU offers less than GLES 3.1 promises: %s", text);
}

bool gpu_limits_check(struct shader_error *error)
{
    GLint major = 0, minor = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    if (major * 10 + minor < 31) {
        return shader_fail(error, "this GPU offers OpenGL ES %d.%d, needed is 3.1", major, minor);
    }
    return gpu_limits_check_with(read_limit, NULL, error);
}

const char *gpu_limits_renderer(void)
{
    return (const char *)glGetString(GL_RENDERER);
}

bool gpu_limits_is_processor(const char *renderer)
{
    return renderer &&
           (strstr(renderer, "llvmpipe") || strstr(renderer, "softpipe") || strstr(renderer, "SwiftShader"));
}
