/* Which engine paints: asked for, or the faster of the two on this machine, by timing both on the real grid. What was
 * measured is remembered in the state folder, so that a kiosk starts quickly the next time. */
#ifndef FROND_ENGINE_CHOICE_H
#define FROND_ENGINE_CHOICE_H

#include <stdbool.h>
#include <stddef.h>

#include "painting.h"
#include "program.h"

enum engine_kind { ENGINE_AUTO, ENGINE_CPU, ENGINE_GPU, ENGINE_KINDS };

/* "auto", "cpu", "gpu". */
const char *engine_kind_name(enum engine_kind kind);
/* ENGINE_KINDS when there is none of that name. */
enum engine_kind engine_kind_find(const char *name);

struct engine_choice {
    enum engine_kind kind; /* CPU or GPU */
    double cpu_ms, gpu_ms; /* of a busy tick; 0: not measured, or not to be had */
    bool remembered;
    char why[300]; /* one line for the log */
};

/* With ENGINE_AUTO measures both, in under two seconds, in the current GL context (`renderer`: its name; NULL: there is
 * none, and the CPU it is; the same where GL draws with the processor), or takes what `path` (a file of this module's
 * making; NULL: none) remembers of the same renderer, processor, grid and version, and writes it there when it had to
 * measure. Never fails: what cannot be measured loses. */
struct engine_choice engine_choose(enum engine_kind wanted, const struct painting_def *def, const char *renderer,
                                   const struct shader_folder *folder, const char *path);

/* The file "engines.json" in $STATE_DIRECTORY, $XDG_STATE_HOME/frond or ~/.local/state/frond, the folder made if it
 * is not there. False when there is no such place. */
bool engine_choice_path(char *path, size_t size);

#endif
