/* The inside of the GPU engine, shared by the files that make it up; nobody else includes this.
 *   painting_gpu.c         life, engine_ops, programs
 *   painting_gpu_steps.c   a tick: tile lists, openness, fluid steps, pattern steps
 *   painting_gpu_act.c     actions: what the CPU plans (deposit.h) brought to the cells; changed ground uploaded
 *   painting_gpu_upkeep.c  drying, re-wetting, settling, evaporation
 *   painting_gpu_read.c    reading, totals, checkpoints, publishing
 * Few large buffers of planes. A plane is [rows][stride] words, stride and rows the sheet rounded up to whole tiles;
 * cell (x, y) is word y * stride + x. Cells beyond the sheet are closed and stay 0. */
#ifndef FROND_PAINTING_GPU_STATE_H
#define FROND_PAINTING_GPU_STATE_H

#include "painting_gpu.h"

enum { GPU_TILE = 32 }; /* cells a side of what sleeps and wakes together */

/* Bindings of storage blocks, the same in every shader. */
enum gpu_block { BLOCK_IN, BLOCK_OUT, BLOCK_SHEET, BLOCK_TILES };

/* Planes of a fluid buffer: 9 populations of solvent, 9 of ink, 4 wet pigments, in the order of sim/kernel.h. */
enum { GPU_SOLVENT = 0, GPU_INK = 9, GPU_WET = 18, GPU_FLUID_PLANES = 22 };
/* Planes of a pattern buffer. */
enum { GPU_ACTIVE, GPU_CATALYST, GPU_CARVED, GPU_PATTERN_PLANES };
/* Planes of the sheet, words: packed ground (units of sim/kernel.h), then floats. */
enum {
    GPU_ALPHA_A_XI,   /* alpha_a | xi << 16 */
    GPU_BETA_A_S_MAX, /* beta_a | s_max << 16 */
    GPU_ALPHA_Y_REST, /* alpha_y | weight << 16 | obstacle << 24 */
    GPU_GUIDE,        /* guide x | guide y << 16, signed */
    GPU_DENSITY,      /* solvent density after the last fluid step */
    GPU_OPEN_SOLVENT, /* openness for this tick; CLOSED (-4) at obstacles */
    GPU_OPEN_INK,
    GPU_DRY, /* + ink 0..3 */
    GPU_SHEET_PLANES = GPU_DRY + PAINTING_INKS,
};

struct painting_gpu {
    struct engine engine;
    struct painting_def def;
    int width, height;  /* cells, margin included */
    int stride, rows;   /* of a plane */
    int columns, lines; /* tiles */
    int64_t tick;
    struct ground *ground; /* what actions alone change, kept on the CPU, changed parts uploaded */
    struct shader_folder folder;
    unsigned fluid[2], pattern[2], sheet, tiles; /* GL buffers */
    int fluid_now, pattern_now;                  /* which of the two holds the state */
    struct gpu_steps *steps;                     /* programs and scratch of painting_gpu_steps.c, and so on */
    struct gpu_act *act;
    struct gpu_upkeep *upkeep;
    struct gpu_read *read;
};

#endif
