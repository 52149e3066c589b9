
#include <GLES3/gl31.h>

#include "painting_gpu_state.h"

enum { PROGRAMS_MOST = 8 };

bool gpu_make_programs(const struct painting_gpu *gpu, const struct gpu_program_part *parts, int count,
                       unsigned *programs, struct shader_error *error)
{
    unsigned made[PROGRAMS_MOST] = {0};
    bool whole = count <= PROGRAMS_MOST;
    for (int i = 0; i < count && whole; i++) {
        made[i] = program_compute(&gpu->folder, parts[i].name, parts[i].defines, error);
        whole = made[i] != 0;
    }
    for (int i = 0; i < count; i++) {
        glDeleteProgram(whole ? programs[i] : made[i]);
        programs[i] = whole ? made[i] : programs[i];
        if (whole) {
            gpu_set_planes(gpu, programs[i]);
        }
    }
    return whole;
}
