/* The dendritic painting on the GPU: the model of painting.h as GLES 3.1 compute, inside what every GLES 3.1 device
 * promises (program.h). Same equations, same order of work, other rounding: engine.h says what that means.
 * Lives in the GL context that is current when it is made; every call wants that context, or one that shares with it.
 */
#ifndef FROND_PAINTING_GPU_H
#define FROND_PAINTING_GPU_H

#include "engine.h"
#include "fields.h"
#include "program.h"

/* NULL with the reason in `error`: no memory, a shader that does not compile (file and line), a sheet larger than the
 * storage blocks of this GPU. `folder` NULL: embedded sources. The threads and vectors of `def` mean nothing here. */
struct engine *engine_gpu_create(const struct painting_def *def, const struct shader_folder *folder,
                                 struct shader_error *error);
/* Compiles the sources of the folder again; with an error the old programs stay. */
bool engine_gpu_reload(struct engine *engine, struct shader_error *error);
/* Writes the visible sheet into the textures; those whose name is 0 are left out. Reads nothing back. */
void engine_gpu_publish(struct engine *engine, const struct fields *fields);

/* A rolling checkpoint, for the way of a frame: `begin` copies the state inside the GPU, `step` brings some megabytes
 * of the copy to memory when the GPU has them ready and never waits. True when the checkpoint is whole. */
bool engine_gpu_checkpoint_begin(struct engine *engine);
bool engine_gpu_checkpoint_step(struct engine *engine, struct checkpoint *checkpoint);

#endif
