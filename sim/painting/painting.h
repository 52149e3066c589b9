/* A dendritic painting: catalyst, active and carved pattern; solvent; ink; pigment.
 * Source: "Simulation of Dendritic Painting" (Canabal et al. 2020). This is the CPU engine: plain C, threads, vectors,
 * the same bits for any number of threads, any vector width and any compiler, tiles asleep or awake.
 *
 *     struct painting_def def = painting_default_def();
 *     def.width = 720, def.height = 720;
 *     struct painting *painting = painting_create(&def);
 *     struct action drop = action_default(ACTION_DROP);
 *     drop.at = (struct point){0.5f, 0.5f};
 *     painting_act(painting, &drop);
 *     for (int tick = 0; tick < 700; tick++) {
 *         painting_tick(painting);
 *     }
 *     painting_read(painting, PAINTING_CARVED, plane);
 *     painting_destroy(painting);
 *
 * Cells are counted over the visible sheet, row by row from the top left. All memory is taken by painting_create. */
#ifndef FROND_PAINTING_H
#define FROND_PAINTING_H

#include <stdbool.h>
#include <stddef.h>
#include <stdint.h>

#include "action.h"
#include "canvas.h"
#include "coefficients.h"
#include "vectors.h"

enum {
    PAINTING_INKS = 4, /* inks that a painting carries */
};

struct painting_def {
    int width, height; /* cells of the visible sheet, CANVAS_SIZE_MIN..CANVAS_SIZE_MAX */
    int margin;    /* cells simulated beyond each side, 0..CANVAS_MARGIN_MAX, so that growth does not turn square there
                    */
    uint32_t seed; /* of the static noise and of everything random */
    int threads;   /* 0: one for each processor */
    bool dense;    /* keep every tile awake: for tests and measurements, the bits are the same */
    enum vectors vectors; /* wider than the machine has: the widest it has */
    struct coefficients coefficients;
};

struct painting_def painting_default_def(void); /* 720x720, no margin, seed 1, best vectors, default coefficients */

static inline struct canvas painting_canvas(const struct painting_def *def)
{
    return (struct canvas){def->width, def->height, def->margin, def->seed};
}

struct painting;

/* NULL when memory is short or a size is out of range. */
struct painting *painting_create(const struct painting_def *def);
void painting_destroy(struct painting *painting); /* takes NULL */

/* Does an action now. Values out of range are clamped to the range of their key; an action that lacks what it needs
 * does nothing. */
void painting_act(struct painting *painting, const struct action *action);
/* The two halves of a tick, for those who measure them; a tick is the first, the second, and now and then upkeep. */
void painting_flow(struct painting *painting);
void painting_grow(struct painting *painting);
/* One tick: fluid_steps steps of solvent, ink and pigment; pattern_steps steps of the pattern; now and then drying. */
void painting_tick(struct painting *painting);

int64_t painting_ticks(const struct painting *painting);               /* since creation */
struct painting_def painting_get_def(const struct painting *painting); /* with the coefficients of now */

enum painting_field {
    PAINTING_CATALYST,  /* rho_y, 0..1 */
    PAINTING_ACTIVE,    /* rho_a, 0..1, a little more in a drop */
    PAINTING_CARVED,    /* rho_p, 0..1.3 */
    PAINTING_SOLVENT,   /* density per cell */
    PAINTING_SOLVENT_U, /* momentum over mean density 1, cells per fluid step (eq. 7, 9); x right */
    PAINTING_SOLVENT_V, /* y down */
    PAINTING_INK,       /* density per cell */
    PAINTING_INK_U,
    PAINTING_INK_V,
    PAINTING_WET,                                    /* + ink 0..3: wet pigment, optical thickness */
    PAINTING_DRY = PAINTING_WET + PAINTING_INKS,     /* + ink 0..3: dry pigment, optical thickness */
    PAINTING_GUIDE_U = PAINTING_DRY + PAINTING_INKS, /* guidance field v of eq. 16; x right */
    PAINTING_GUIDE_V,                                /* y down */
    PAINTING_MASK,                                   /* 1 where an obstacle is, else 0 */
    PAINTING_ALPHA_A,                                /* the coefficients that vary over the sheet */
    PAINTING_ALPHA_Y,
    PAINTING_BETA_A,
    PAINTING_S_MAX,
    PAINTING_XI, /* 1 + xi0 rand(x), eq. 6 */
    PAINTING_FIELDS,
};

/* The name of a field as files show it: "pattern.catalyst", "solvent.density", "ink.wet.0", ... */
const char *painting_field_name(enum painting_field field);
/* Copies a field of the visible sheet into width * height floats. */
void painting_read(const struct painting *painting, enum painting_field field, float *plane);

/* The visible sheet as a picture wants it: texels of four floats, row by row from the top left, width * height of them.
 * Those that are NULL are left out. Costs about what a copy does; shared among the painting's threads. */
struct painting_texels {
    float *ground;  /* depth (active + carved), solvent density, 1 where an obstacle is, catalyst */
    float *ink;     /* inks 0..3, wet + dry, optical thickness */
    float *pattern; /* active, carved, ink density, 0 */
    float *vectors; /* solvent momentum x, y; guidance field x, y */
};
void painting_publish(struct painting *painting, const struct painting_texels *texels);

struct painting_totals {       /* over the whole sheet, margin included */
    double solvent, ink;       /* liquid now, density summed over cells */
    double solvent_evaporated; /* has left since the last clear, by evaporation and by `dry` */
    double ink_dried;          /* ink that `dry` has taken out of the liquid */
    double catalyst, active, carved;
    double wet[PAINTING_INKS], dry[PAINTING_INKS];
};
struct painting_totals painting_totals(const struct painting *painting);

struct painting_effort { /* of the last tick */
    int tiles;           /* all tiles */
    int fluid_awake;     /* of which the fluids were computed */
    int pattern_awake;
};
struct painting_effort painting_effort(const struct painting *painting);

/* The whole state into a checkpoint that checkpoint_init has made for the same size of sheet, and back; false for
 * another size. Threads, vectors and `dense` stay as they are; everything else, the seed too, is the checkpoint's. */
struct checkpoint;
bool painting_save(const struct painting *painting, struct checkpoint *checkpoint);
bool painting_load(struct painting *painting, const struct checkpoint *checkpoint);

/* A rectangle of it (patch.h), and back: what is put back wakes. False for one that is not on the sheet or larger than
 * its room. */
struct patch;
bool painting_save_patch(const struct painting *painting, struct patch *patch);
bool painting_load_patch(struct painting *painting, const struct patch *patch);
/* Sets the bytes of those tiles (tiles.h, row by row) that may have changed since the last call; leaves the others. */
void painting_changed(struct painting *painting, uint8_t *changed);

/* A hash of all state (-0 counted as 0): equal hashes, equal paintings, to the bit. */
uint64_t painting_hash(const struct painting *painting);
/* Bytes taken by painting_create. */
size_t painting_bytes(const struct painting *painting);

#endif
