/* The dendritic painting on the GPU: the model of painting.h as GLES 3.1 compute, inside what every GLES 3.1 device
 * promises (program.h). Same equations, same order of work, other rounding: engine.h says what that means.
 * Lives in the GL context that is current when it is made; every call wants that context, or one that shares with it.
 *
 * When the context is lost: engine_destroy while it still is the current one (or none is), before another takes its
 * place, whose names would be meant; then engine_gpu_create in the new context, and load of the last checkpoint. */
#ifndef FROND_PAINTING_GPU_H
#define FROND_PAINTING_GPU_H

#include "engine.h"
#include "fields.h"
#include "program.h"

/* NULL with the reason in `error`: no memory, a shader that does not compile (file and line), a sheet larger than the
 * storage blocks of this GPU. `folder` NULL: embedded sources. The threads and vectors of `def` mean nothing here. */
struct engine *engine_gpu_create(const struct painting_def *def, const struct shader_folder *folder,
                                 struct shader_error *error);
/* Compiles the sources of the folder again; with an error all the old programs stay. */
bool engine_gpu_reload(struct engine *engine, struct shader_error *error);
/* How the layers are swept: the same equations, other programs. Each is best somewhere; timing tells where. */
enum gpu_way {
    GPU_PLAIN,   /* a cell an invocation, a step a pass: few registers, most memory traffic */
    GPU_PATCHES, /* four pattern steps a pass, patches of 4 x 4 cells that share their rims: least memory traffic */
    GPU_STRIPS,  /* strips in registers, no shared memory; for processors, chosen at creation where GL runs on one */
    GPU_WAYS,
};
/* At any time; the engine begins with patches or strips. */
void engine_gpu_set_way(struct engine *engine, enum gpu_way way);
enum gpu_way engine_gpu_way(const struct engine *engine);
/* Writes the visible sheet into the textures; those whose name is 0 are left out. Reads nothing back. */
void engine_gpu_publish(struct engine *engine, const struct fields *fields);

/* A rolling checkpoint, for the way of a frame: `begin` copies the state inside the GPU (120 bytes a cell, some
 * milliseconds of its time, and as much of its memory from the first time on), `step` brings 4 MB of the copy to memory
 * once the GPU has made it, and never waits. True when the checkpoint is whole: as of `begin`, whatever has happened
 * since. Until then it is neither the old nor the new: keep the last whole one beside it. `checkpoint` is the same from
 * step to step. `begin` again drops what was under way; false when memory is short or the GPU is lost. */
bool engine_gpu_checkpoint_begin(struct engine *engine);
bool engine_gpu_checkpoint_step(struct engine *engine, struct checkpoint *checkpoint);

#endif
