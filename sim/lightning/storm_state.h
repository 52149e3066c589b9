/* What a storm is made of; for storm*.c alone. */
#ifndef FROND_STORM_STATE_H
#define FROND_STORM_STATE_H

#include "bolt_shape.h"
#include "laplacian.h"
#include "region.h"
#include "storm.h"

enum {
    STORM_SLOTS = 40,    /* bolts that grow, stay or fade, or were taken back */
    STORM_LATTICE = 96,  /* places along the longer side where charges are summed */
    STORM_MASK = 512,    /* values of the mask along the longer side */
    STORM_RESTRIKES = 3, /* at most, of a strike that has come */
    STORM_POINTS = 256,  /* of a painted charge */
    STORM_SWELL = 60,    /* ticks in which a bolt that is complete before its time becomes as thick as it is to be */
    STORM_FLASH = 14,    /* ticks that a flash lasts */
};
#define STORM_BROAD 2.0f      /* thickness above which light fills a place: it comes with flashes, or dimmed */
#define STORM_ECHO  0.6f      /* of a strike's life: each restrike */
#define STORM_AGES  INT64_MAX /* a tick that never comes */

struct storm_node {
    float at[3];   /* cells of its growth, about the middle of the sheet */
    float even[3]; /* where it is drawn: evened out along branches */
    float left;    /* 0..1 that water has left of it */
    float radius;  /* as it is drawn but for thickness and water, cells of the sheet that the bolt began on */
    int32_t parent, heaviest, tips; /* as of bolt_shape.h */
    int32_t segment;                /* -1: none */
    bool channel;                   /* on the way that struck */
};

struct storm_bolt {
    bool lives;     /* the slot is taken */
    bool complete;  /* it grows no more */
    bool leaves;    /* it has been pushed out, and fades */
    bool dim;       /* it has struck where it might not flash, and is broad */
    int64_t serial; /* of what visitors have done */
    int64_t undone; /* when it was taken back, above 0 */
    int visitor;
    int kind, dimensions;
    struct bolt_look look; /* lengths in cells of the sheet that it began on */
    float width, height;   /* of that sheet, cells */
    float scale;           /* cells of that sheet to a cell of its growth */
    float extent;          /* cells of the growth from where it began, 0: none */
    float from[3];         /* where it began, cells of the growth */
    float life;            /* ticks; 0: it stays */
    int64_t swells;        /* till that tick its branches become thicker */
    int64_t struck;        /* tick at which it was complete */
    int64_t gone;          /* tick at which it is forgotten, or STORM_AGES */
    int64_t again[STORM_RESTRIKES];
    int agains;
    int32_t hit;  /* the node, or -1 */
    float due;    /* particles that it may grow by */
    float whole;  /* of radii: what the trunk carries, by the pipe model */
    int32_t most; /* tips that one of its seeds carries */
    int64_t shaped;

    struct laplacian *laplacian; /* NULL once it is complete */
    int limit;                   /* particles */
    struct laplacian_charge pulls[BOLT_CHARGES];
    int pull_count;
    bool aims;                         /* at `target`: pulls[0] is beyond it, pulls[1] there */
    struct point target;               /* 0..1 of the sheet */
    int64_t heard;                     /* hands as of this change */
    int64_t charged;                   /* tick */
    int32_t charged_count, felt_count; /* particles when hands, and when strokes, were weighed */
    int64_t felt;                      /* others as of this change */

    struct storm_node *nodes;
    int32_t count, room;
    int32_t deposited;                /* nodes that `potential` has */
    float *potential, *background[2]; /* on the storm's lattice: of this one; of the others, in turns */
    int turn;
};

struct storm_hand {
    bool lies;
    int visitor;
    struct point at;
    float charge;
};

struct storm_stroke {
    bool lives;
    int64_t serial, undone;
    int visitor;
    float charge; /* a cell */
    int count;
    struct point points[STORM_POINTS];
};

/* Whose a segment is. */
struct storm_owner {
    int32_t slot, node;
    bool again; /* a restrike's */
};

struct storm {
    struct storm_def def;
    int width, height;
    bool begun, failed; /* memory was short */
    int64_t now, origin;
    int64_t serial, undone, bolts_begun;
    int64_t most; /* particles of all: STORM_PARTICLES, but in tests */
    struct storm_bolt bolts[STORM_SLOTS];
    struct storm_hand hands[STORM_HANDS];
    int64_t hands_changed;
    struct storm_stroke strokes[STORM_STROKES];
    bool strokes_changed;

    int columns, rows; /* of the lattice */
    float *kernel;     /* rows of 2 * columns - 1: 1 / distance in places of the lattice */
    float *painted;    /* potential of all strokes, for cells of the lattice */
    float *sources;    /* scratch */
    int64_t changed;   /* potentials */
    int mask_columns, mask_rows;
    float *mask;   /* 1 where growth may go */
    uint8_t *scar; /* on the mask's grid: how far bolts that are forgotten, but were not taken back, had covered it */

    struct bolt_segment *segments;
    struct storm_owner *owners;
    int count, room, since;
    int64_t flashed; /* tick */
    float flash;     /* how bright it was then */
};

/* storm_bolt.c */
void storm_strike(struct storm *storm, const struct action *action);
void storm_bolt_free(struct storm_bolt *bolt);
/* It fades from now on, for so many ticks. */
void storm_dismiss(struct storm *storm, struct storm_bolt *bolt, int ticks);
/* By one tick: growth, hits, what has had its time. */
void storm_grow(struct storm *storm);
/* How many times a hand's charge counts: as much for a large bolt as for a small one. */
float storm_felt(const struct storm_bolt *bolt);
bool storm_bolt_grows(const struct storm_bolt *bolt);
/* Particles of all. */
int64_t storm_particles(const struct storm *storm);

/* storm_figures.c: of a storm, as struct scene_type has it. */
int storm_figures(const void *scene, struct scene_figure *figures);

/* storm_aim.c: where bolts begin and what pulls them. */
/* Fills what it needs of the bolt, and its seeds: at most `most`. False: nowhere to begin. */
bool storm_place(struct storm *storm, const struct action *action, struct storm_bolt *bolt, struct bolt *preset,
                 struct laplacian_seed *seeds, int most);
/* What is to be heard by now: hands, and the place that a strike goes to. */
void storm_pull(struct storm *storm, struct storm_bolt *bolt);

/* storm_charge.c: what bolts and strokes do to one another, summed on a lattice. */
bool storm_lattice_init(struct storm *storm);
void storm_lattice_finish(struct storm *storm);
void storm_attract(struct storm *storm, const struct action *action);
void storm_deposit(struct storm *storm, struct storm_bolt *bolt);
void storm_feel(struct storm *storm, struct storm_bolt *bolt);
void storm_strokes_sum(struct storm *storm);
/* The sum of 1 / distance, in places of the lattice, of all that is to be seen; columns * rows. False when memory is
 * short. */
bool storm_potential(const struct storm *storm, float *potential);
/* Bilinear; 0..1 of the sheet. */
float storm_sample(const struct storm *storm, const float *lattice, float x, float y);

/* storm_segments.c */
/* Nodes from `first` on are to be seen. False when memory is short. */
bool storm_show(struct storm *storm, int slot, int32_t first);
/* The channel once more. */
bool storm_show_again(struct storm *storm, int slot);
void storm_hide(struct storm *storm, int slot);
/* Tips, radii and places as of now. */
void storm_shape(struct storm *storm, struct storm_bolt *bolt);
/* All that segments say, from what the bolt is now. */
void storm_dress(struct storm *storm, int slot);
void storm_touch(struct storm *storm, int segment);
void storm_rebase(struct storm *storm);

/* storm_wash.c */
void storm_rinse(struct storm *storm, const struct action *action);
void storm_mask(struct storm *storm, const struct action *action);
void storm_undo(struct storm *storm, int visitor);
void storm_redo(struct storm *storm, int visitor);
/* What was taken back before by this visitor is lost. */
void storm_forget_undone(struct storm *storm, int visitor);
uint64_t storm_visitors(const struct storm *storm, bool undone);

/* storm_scar.c. A bolt is about to be forgotten: it stays what has grown. */
void storm_scar_keep(struct storm *storm, int slot);
void storm_scar_wash(struct storm *storm, const float *phases, float strength); /* phases: on the mask's grid */
void storm_scar_clear(struct storm *storm);
/* Darkens what is 1 where nothing has grown. */
void storm_scar_lay(const struct storm *storm, int width, int height, float *values);

/* storm_field.c. The slot's bolt, or all that have grown and were not taken back, faded or not (-1): 1 becomes 0. */
void storm_field_draw(const struct storm *storm, int slot, int width, int height, float *values);
/* Of a storm, as struct scene_type has them. */
bool storm_field(void *scene, enum scene_field which, int width, int height, float *values);
uint64_t storm_hash(const void *scene);

#endif
