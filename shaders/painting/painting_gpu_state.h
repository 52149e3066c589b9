/* The inside of the GPU engine, shared by the files that make it up; nobody else includes this.
 *   painting_gpu.c             life: buffers, planes by rectangles
 *   painting_gpu_engine.c      the whole as engine.h wants it
 *   painting_gpu_programs.c    every compute program of it
 *   painting_gpu_steps.c       a tick: tile lists, openness, fluid steps, pattern steps
 *   painting_gpu_act.c         actions: what the CPU plans (deposit.h) brought to the cells; changed ground uploaded
 *   painting_gpu_upkeep.c      drying, re-wetting, settling, evaporation
 *   painting_gpu_read.c        reading, totals, publishing
 *   painting_gpu_checkpoint.c  checkpoints, at once and rolling
 *   painting_gpu_patch.c       rectangles for a history
 *
 * Few large buffers of planes. A plane is [rows][stride] words: the sheet rounded up to whole tiles, and around it an
 * apron of GPU_APRON cells, which no shader writes; cell (x, y) is word gpu_word(gpu, x, y). Beyond the sheet all is
 * closed in the openness and there is never any liquid, so that neighbours are read without looking where the sheet
 * ends; what the pattern holds there means nothing. planes.glsl says the same to the shaders.
 *
 * Fluids and pattern are held twice: a pass reads the one and writes the other, tiles that sleep are not written, and
 * so hold the same values in both, to the bit. Whoever changes a plane between ticks
 *   - changes the buffer of now, and touches the tiles (gpu_steps_touch), which wakes them: the next tick writes the
 *     other buffer; or
 *   - changes both buffers alike, where tiles are to go on sleeping (drying pigment). */
#ifndef FROND_PAINTING_GPU_STATE_H
#define FROND_PAINTING_GPU_STATE_H

#include "ground.h"
#include "painting_gpu.h"
#include "patch.h"
#include "rectangle.h"
#include "upkeep.h"

enum {
    GPU_TILE = 32, /* cells a side of what sleeps and wakes together */
    GPU_APRON = 4, /* cells around the tiles */
};

/* Bindings of storage blocks, the same in every shader. */
enum gpu_block { BLOCK_IN, BLOCK_OUT, BLOCK_SHEET, BLOCK_TILES };

/* Planes of a fluid buffer, as sim/painting/kernel.h has them: populations of solvent and of ink, wet pigments. */
enum { GPU_SOLVENT = FLUID_SOLVENT, GPU_INK = FLUID_INK, GPU_WET = FLUID_WET, GPU_FLUID_PLANES = FLUID_FIELDS };
/* Planes of a pattern buffer. */
enum { GPU_ACTIVE, GPU_CATALYST, GPU_CARVED, GPU_PATTERN_PLANES };
/* Planes of the sheet, words: packed ground (units of sim/painting/kernel.h), then floats. */
enum {
    GPU_ALPHA_A_XI,   /* alpha_a | xi << 16 */
    GPU_BETA_A_S_MAX, /* beta_a | s_max << 16 */
    GPU_ALPHA_Y_REST, /* alpha_y | weight << 16 | obstacle << 24 */
    GPU_GUIDE,        /* guide x | guide y << 16, signed */
    GPU_DENSITY,      /* solvent density after the last fluid step */
    GPU_OPEN_SOLVENT, /* openness as of the last tick that the tile flowed; CLOSED at obstacles and beyond the sheet */
    GPU_OPEN_INK,
    GPU_DRY, /* + ink 0..3 */
    GPU_SHEET_PLANES = GPU_DRY + PAINTING_INKS,
};

/* The buffer of tiles, words: a head, then arrays of a word a tile. The order is also that of tiles.glsl. */
enum gpu_tile_list {
    LIST_FLUID,   /* tiles whose fluids the last tick computed */
    LIST_FREE,    /* tiles whose pattern it computed, by the program for free ground */
    LIST_SPECIAL, /* and by the whole one */
    LIST_COUNT,
};
enum {
    GPU_LIST_CHUNK = 128, /* tiles of one dispatch: see painting_gpu_steps.c */
    GPU_CHUNKS_MOST = 168,
    GPU_HEAD_COUNT = 0, /* + enum gpu_tile_list: tiles in it */
    GPU_HEAD_QUIET =
        3, /* quiet periods, as in sim/painting/painting_state.h: upkeep counts them, the dead band follows */
    GPU_HEAD_CARVED = 4, /* carved cells when last counted; words up to 20 are free */
    /* + (list * GPU_CHUNKS_MOST + chunk) * 3: arguments of an indirect dispatch */
    GPU_HEAD_DISPATCH = 20,
    GPU_HEAD_WORDS = GPU_HEAD_DISPATCH + LIST_COUNT * GPU_CHUNKS_MOST * 3,
};
enum gpu_tile_array {
    TILES_FLAGS,                             /* enum gpu_tile_bit: what has been noted since it was last looked at */
    TILES_SEEN,                              /* scratch: the flags while lists are made */
    TILES_LIST,                              /* + enum gpu_tile_list: numbers of tiles */
    TILES_COUNTED = TILES_LIST + LIST_COUNT, /* carved cells of the tile when last counted */
    TILES_EVAPORATED, /* float: solvent that has left the tile since the sums began (painting_gpu.evaporated) */
    TILES_DRIED,      /* float: ink that has dried out of its liquid */
    TILES_ARRAYS,
};
/* Bits of a tile's flags: those of sim/painting/tiles.h, which says what each means. */
enum gpu_tile_bit {
    BIT_FLOWS = 1,
    BIT_WET = 2,
    BIT_OPENED = 4,
    BIT_GROWS = 8,
    BIT_FED = 16,
    BIT_ALIVE = 32,
    BIT_SPECIAL = 64,
    BIT_CARVED = 128,
    BIT_DAMP = 256,
    BIT_CHANGED = 512, /* anything may have changed since a history last asked; no layer heeds it */
};

enum gpu_buffer { BUFFER_FLUID, BUFFER_PATTERN, BUFFER_SHEET };

/* The planes of a checkpoint that lie together in one buffer (painting_gpu_checkpoint.c). */
struct gpu_stretch {
    enum gpu_buffer kind;
    int first, count, plane;
};
enum { GPU_STRETCHES = 4 };
extern const struct gpu_stretch gpu_stretches[GPU_STRETCHES];

enum gpu_program {
    PROGRAM_FILL,
    PROGRAM_RECTANGLE,
    PROGRAM_WAKE,
    PROGRAM_MARK,
    PROGRAM_STIR,
    PROGRAM_OPENNESS,
    PROGRAM_FLUID,
    PROGRAM_FLUID_STRIP,
    PROGRAM_PLAIN,
    PROGRAM_PLAIN_WHOLE,
    PROGRAM_PATCH,
    PROGRAM_PATCH_WHOLE,
    PROGRAM_STRIP,
    PROGRAM_DEPOSIT,
    PROGRAM_GROUND,
    PROGRAM_COUNT,
    PROGRAM_PIGMENT,
    PROGRAM_SETTLE,
    PROGRAM_PUBLISH, /* + enum fields_texture */
    GPU_PROGRAMS = PROGRAM_PUBLISH + FIELDS_COUNT,
};

struct gpu_act;
struct gpu_rolling;

struct painting_gpu {
    struct engine engine;
    struct painting_def def;
    int width, height;  /* cells, margin included */
    int stride, rows;   /* words and rows of a plane, apron included */
    int columns, lines; /* tiles */
    int64_t tick;
    struct ground *ground; /* what actions alone change, kept on the CPU, changed parts uploaded */
    struct shader_folder folder;
    char *folder_path;                           /* what `folder` points to */
    unsigned fluid[2], pattern[2], sheet, tiles; /* GL buffers */
    unsigned stage;                              /* GL buffer: a rectangle on its way to or from memory */
    size_t stage_bytes;
    int fluid_now, pattern_now;   /* which of the two holds the state */
    double evaporated, ink_dried; /* before the sums of the tiles began: what a checkpoint brought */
    enum gpu_way way;
    unsigned programs[GPU_PROGRAMS]; /* GL names */
    struct gpu_act *act;             /* room of painting_gpu_act.c */
    struct gpu_rolling *rolling;     /* of painting_gpu_checkpoint.c: a checkpoint on its way to memory */
};

static inline size_t gpu_word(const struct painting_gpu *gpu, int x, int y)
{
    return (size_t)(y + GPU_APRON) * (size_t)gpu->stride + (size_t)(x + GPU_APRON);
}

static inline size_t gpu_plane_words(const struct painting_gpu *gpu)
{
    return (size_t)gpu->rows * (size_t)gpu->stride;
}

/* Buffers and programs, an empty painting whose ground is all 0; what engine_gpu_create builds upon. */
struct painting_gpu *gpu_create(const struct painting_def *def, const struct shader_folder *folder,
                                struct shader_error *error);
void gpu_destroy(struct painting_gpu *gpu);       /* takes NULL */
size_t gpu_bytes(const struct painting_gpu *gpu); /* of all buffers */

/* The buffer of now that holds a kind of planes. */
unsigned gpu_buffer_now(const struct painting_gpu *gpu, enum gpu_buffer kind);
/* Planes first..first + count - 1 of a rectangle within the sheet, from and to memory: words[count][y1 - y0][x1 - x0].
 * Reading waits for the GPU. Writing changes the buffer of now alone and wakes nothing. False when the GPU does not
 * answer. */
bool gpu_write_planes(struct painting_gpu *gpu, enum gpu_buffer kind, int first, int count, struct rectangle at,
                      const void *words);
bool gpu_read_planes(struct painting_gpu *gpu, enum gpu_buffer kind, int first, int count, struct rectangle at,
                     void *words);
/* Bytes [from, from + bytes) of a buffer as they are. */
bool gpu_read_bytes(unsigned buffer, size_t from, size_t bytes, void *to);
/* Everything 0 and asleep, catalyst 1, as painting_clear; the ground is left as it is. Touches the whole sheet. */
void gpu_empty(struct painting_gpu *gpu);

/* Binds the blocks of the fluid or the pattern, `from` now; the sheet; the tiles. */
void gpu_bind(const struct painting_gpu *gpu, enum gpu_buffer kind);

/* All programs anew, from gpu->folder, with the uniforms of planes.glsl and tiles.glsl set; with an error all stay as
 * they were. */
bool gpu_programs_make(struct painting_gpu *gpu, struct shader_error *error);
void gpu_programs_delete(struct painting_gpu *gpu); /* takes one that has none */
void gpu_use(const struct painting_gpu *gpu, enum gpu_program program);

/* Word of the buffer of tiles where an array begins. */
static inline size_t gpu_tiles_word(const struct painting_gpu *gpu, int array)
{
    return GPU_HEAD_WORDS + (size_t)array * (size_t)gpu->columns * (size_t)gpu->lines;
}

/* The way that is likely best where GL runs. */
enum gpu_way gpu_steps_way(void);
/* fluid_steps and pattern_steps of now, no upkeep; gpu->tick goes on by one. Waits for nothing. */
void gpu_steps_tick(struct painting_gpu *gpu);
/* The two halves of it, and what comes first in the first of them (the list of tiles and their openness), for those who
 * measure them. */
void gpu_steps_open(struct painting_gpu *gpu);
void gpu_steps_flow(struct painting_gpu *gpu);
void gpu_steps_grow(struct painting_gpu *gpu);
/* As painting_touch: everything in the tiles of these cells wakes, the painting is no longer quiet, and calm liquid is
 * looked at again. Also finds which of these tiles have obstacles or guidance: wants the ground uploaded. */
void gpu_steps_touch(struct painting_gpu *gpu, struct rectangle cells);
/* Sets bits of the tiles that these cells touch, clipped to the sheet: BIT_WET after liquid was added. */
void gpu_steps_mark(struct painting_gpu *gpu, struct rectangle cells, unsigned bits);
/* Reads back: of the last tick. */
struct painting_effort gpu_steps_effort(const struct painting_gpu *gpu);

bool gpu_act_create(struct painting_gpu *gpu, struct shader_error *error);
void gpu_act_destroy(struct painting_gpu *gpu); /* takes one that has none, or half */
/* As painting_act. */
void gpu_act(struct painting_gpu *gpu, const struct action *action);
/* The ground of some cells, of all of them, from the CPU's copy. */
void gpu_act_upload(struct painting_gpu *gpu, struct rectangle cells);
void gpu_act_upload_ground(struct painting_gpu *gpu);

/* As painting_upkeep: every UPKEEP_TICKS ticks, at the end of one. Waits for nothing. */
void gpu_upkeep_run(struct painting_gpu *gpu);

bool gpu_rolling_create(struct painting_gpu *gpu, struct shader_error *error);
void gpu_rolling_destroy(struct painting_gpu *gpu); /* takes one that has none */
size_t gpu_rolling_bytes(const struct painting_gpu *gpu);
/* Rows of the ground have changed: the rolling checkpoint keeps a copy of it. */
void gpu_rolling_note_ground(struct painting_gpu *gpu, struct rectangle cells);

/* The sum over all tiles of an array of floats (enum gpu_tile_array). Reads back. */
double gpu_read_tile_sum(const struct painting_gpu *gpu, int array);
/* As the functions of engine_ops of these names. */
void gpu_read_field(struct painting_gpu *gpu, enum painting_field field, float *plane);
struct painting_totals gpu_read_totals(struct painting_gpu *gpu);
size_t gpu_read_bytes_taken(const struct painting_gpu *gpu);
bool gpu_save(struct painting_gpu *gpu, struct checkpoint *checkpoint);
bool gpu_load(struct painting_gpu *gpu, const struct checkpoint *checkpoint);
bool gpu_save_patch(struct painting_gpu *gpu, struct patch *patch);
bool gpu_load_patch(struct painting_gpu *gpu, const struct patch *patch);
bool gpu_find_changed(struct painting_gpu *gpu, uint8_t *changed);

#endif
