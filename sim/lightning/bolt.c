#include "bolt.h"

#include <math.h>

#include "key_fields.h"
#include "random.h"

const char *const bolt_kind_names[BOLT_KINDS + 1] = {"lightning",   "tesla", "tree",     "lichen",  "coral",
                                                     "river",       "snow",  "fracture", "vessels", "city",
                                                     "lichtenberg", "frost", NULL};

const char *const bolt_kind_meanings[BOLT_KINDS] = {
    "A strike from the clouds to the ground: it ends where it hits.",
    "Streamers from an electrode in all directions; they keep clear of each other.",
    "A tree in three dimensions, away from the ground, with a leaf at every fifth particle of its twigs.",
    "A crust with lobes, from a few places, as on stone.",
    "Thick branches from the ground, in three dimensions.",
    "A delta: a river that divides on its way to the sea.",
    "Six arms of ice, none like another.",
    "Cracks in glass, from where it was hit.",
    "Blood vessels, from where they enter to all places that want to be reached.",
    "Streets of a town that grows on a grid.",
    "A discharge in a disc, from its middle.",
    "Ice on a pane, from its edge.",
};

const char *const bolt_style_names[BOLT_STYLES + 1] = {"glow", "line", "body", NULL};

#define KEY_AT(field) offsetof(struct bolt_look, field)

const struct key bolt_look_keys[] = {
    CHOICE(style, bolt_style_names, BOLT_GLOW, "Light that glows, lines on a ground, or lit bodies."),
    NUMBER(trunk, "pixels", 0, 1000, 0, "Radius where it is widest."),
    NUMBER(tip, "pixels", 0, 200, 0, "Radius at the tips."),
    NUMBER(pipe, "", 0.5, 10, 0, "Radius to this power adds up where branches meet: 2 as trees do, 3 as vessels do."),
    NUMBER(leaves, "particles", 0, 1000, 0, "A leaf at every so many particles of the twigs; 0: none."),
    WHOLE(smooth, "times", 0, 100, 0, "How often branches are evened out along themselves."),
    END,
};

/* How a kind grows, in a line. */
struct growing {
    int dimensions, particles;
    float side;                 /* cells along the room's shorter side */
    float eta, eta_end, jitter; /* as of laplacian_keys */
    float extent;               /* a share of the shorter side; 0: none */
    bool off_grid;
};

static const struct growing GROWINGS[BOLT_KINDS] = {
    [BOLT_LIGHTNING] = {2, 14000, 380, 7, -1, 0.9f, 0, true},
    [BOLT_TESLA] = {2, 16000, 420, 5.5f, -1, 0.9f, 0.5f, true},
    [BOLT_TREE] = {3, 13000, 80, 6.5f, -1, 0.9f, 0, true},
    [BOLT_LICHEN] = {2, 22000, 230, 2, -1, 0.9f, 0, true},
    [BOLT_CORAL] = {3, 2400, 46, 9, -1, 0.9f, 0, true},
    [BOLT_RIVER] = {2, 13000, 230, 4.5f, -1, 0.9f, 0, true},
    [BOLT_SNOW] = {2, 16000, 360, 2, -1, 0.9f, 0, true},
    [BOLT_FRACTURE] = {2, 2200, 190, 5, -1, 0.9f, 0, true},
    [BOLT_VESSELS] = {2, 20000, 300, 4, -1, 0.9f, 0, true},
    [BOLT_CITY] = {2, 7000, 110, 1.2f, -1, 0, 0, false},
    [BOLT_LICHTENBERG] = {2, 40000, 420, 3.5f, -1, 0.9f, 0.48f, true},
    [BOLT_FROST] = {2, 26000, 330, 1, -1, 0.9f, 0, true},
};

/* Its look: lengths are shares of the room's shorter side. */
static const struct bolt_look LOOKS[BOLT_KINDS] = {
    [BOLT_LIGHTNING] =
        {BOLT_GLOW, 0.0042f, 0.0005f, 2.6f, {0.28f, 0.36f, 1}, {1, 0.97f, 1}, {0.004f, 0.005f, 0.016f}, 0, 45, 0},
    [BOLT_TESLA] = {BOLT_GLOW, 0.004f, 0.0005f, 3, {0.42f, 0.2f, 1}, {1, 0.94f, 1}, {0.005f, 0.003f, 0.012f}, 0, 20, 0},
    [BOLT_TREE] =
        {BOLT_BODY, 0.02f, 0.0007f, 2.1f, {0.07f, 0.04f, 0.024f}, {0.13f, 0.26f, 0.03f}, {0.6f, 0.7f, 0.78f}, 5, 0, 3},
    [BOLT_LICHEN] =
        {BOLT_BODY, 0.0075f, 0.0042f, 3, {0.3f, 0.33f, 0.1f}, {0.6f, 0.6f, 0.27f}, {0.075f, 0.066f, 0.06f}, 0, 0, 1},
    [BOLT_CORAL] =
        {BOLT_BODY, 0.022f, 0.0075f, 3, {0.8f, 0.1f, 0.06f}, {1, 0.36f, 0.22f}, {0.004f, 0.035f, 0.06f}, 0, 0, 4},
    [BOLT_RIVER] = {BOLT_LINE,
                    0.018f,
                    0.0011f,
                    2.2f,
                    {0.035f, 0.12f, 0.13f},
                    {0.07f, 0.22f, 0.22f},
                    {0.3f, 0.26f, 0.13f},
                    0,
                    0,
                    9},
    [BOLT_SNOW] = {BOLT_LINE, 0.0085f, 0.0017f, 3.5f, {0.6f, 0.8f, 0.97f}, {1, 1, 1}, {0.012f, 0.035f, 0.1f}, 0, 0, 2},
    [BOLT_FRACTURE] =
        {BOLT_LINE, 0.0032f, 0.0007f, 3, {0.62f, 0.78f, 0.82f}, {1, 1, 1}, {0.018f, 0.03f, 0.036f}, 0, 0, 0},
    [BOLT_VESSELS] =
        {BOLT_LINE, 0.009f, 0.0009f, 3, {0.3f, 0.012f, 0.008f}, {0.55f, 0.05f, 0.02f}, {0.66f, 0.2f, 0.07f}, 0, 0, 5},
    [BOLT_CITY] =
        {BOLT_LINE, 0.0055f, 0.0011f, 2.5f, {0.8f, 0.42f, 0.13f}, {1, 0.83f, 0.5f}, {0.006f, 0.008f, 0.014f}, 0, 0, 0},
    [BOLT_LICHTENBERG] =
        {BOLT_GLOW, 0.005f, 0.0006f, 2.6f, {0.2f, 0.45f, 1}, {0.95f, 1, 1}, {0.003f, 0.005f, 0.012f}, 0, 0, 0},
    [BOLT_FROST] = {BOLT_LINE, 0.004f, 0.001f, 3, {0.62f, 0.8f, 0.92f}, {1, 1, 1}, {0.012f, 0.035f, 0.07f}, 0, 0, 1},
};

static const float HALF_ROOT_3 = 0.8660254f;

/* Cells of the growth from the middle of the room to its sides. */
struct room {
    float x, y, side;
};

static struct laplacian_charge *add_charge(struct bolt *bolt, enum laplacian_shape shape, float charge, float x,
                                           float y)
{
    struct laplacian_charge *added = &bolt->charges[bolt->growth.charge_count++];
    *added = (struct laplacian_charge){.shape = shape, .charge = charge, .at = {x, y}, .along = {0, 1}};
    return added;
}

static void add_seed(struct bolt *bolt, float x, float y, float to_x, float to_y)
{
    bolt->seeds[bolt->growth.seed_count++] = (struct laplacian_seed){{x, y}, {to_x, to_y}};
}

static void add_point(struct bolt *bolt, float x, float y)
{
    add_seed(bolt, x, y, x, y);
}

/* Uniform in 0..1. */
static float chance(int index, int which)
{
    return random_unit(index, which, 0x626f6c74u, RANDOM_PLACE);
}

/* Cosine and sine of a share of a turn: by series, the same on every machine. */
static void circle(float part, float *x, float *y)
{
    double whole = (double)part - floor((double)part), angle = 6.283185307179586 * (whole - 0.5);
    double square = angle * angle, odd = angle, sine = angle, even = 1, cosine = 1;
    for (int k = 1; k < 16; k++) {
        even *= -square / ((2 * k - 1) * (2 * k));
        cosine += even;
        odd *= -square / ((2 * k) * (2 * k + 1));
        sine += odd;
    }
    *x = (float)-cosine;
    *y = (float)-sine;
}

/* Repulsors around: an arm that is ahead waits for the others. */
static void add_ring(struct bolt *bolt, int count, float charge, float wide, float high)
{
    for (int i = 0; i < count; i++) {
        float x, y;
        circle((float)i / (float)count, &x, &y);
        add_charge(bolt, LAPLACIAN_POINT, charge, wide * x, high * y);
    }
}

static void set_lightning(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, -0.08f * room->x, -0.98f * room->y);
    add_charge(bolt, LAPLACIAN_POINT, 22000, 0.1f * room->x, 2.5f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, 100, 0, 0.97f * room->y)->ends = true;
}

static void set_tesla(struct bolt *bolt, const struct room *room)
{
    enum { STREAMERS = 13 };
    for (int i = 0; i < STREAMERS; i++) {
        float x, y, far = (0.06f + 0.03f * chance(i, 5)) * room->side;
        circle(((float)i + 0.6f * chance(i, 6)) / STREAMERS, &x, &y);
        add_seed(bolt, 0, 0, far * x, far * y);
    }
    add_ring(bolt, 48, -700, 0.53f * room->side, 0.53f * room->side);
}

/* `far` cells from a place: away from the axis by `out`, up by `up`, by a share of a turn about it. */
static void add_bough(struct bolt *bolt, const float from[3], float far, float out, float up, float part)
{
    float x, z;
    circle(part, &x, &z);
    bolt->seeds[bolt->growth.seed_count++] = (struct laplacian_seed){
        {from[0], from[1], from[2]}, {from[0] + far * out * x, from[1] - far * up, from[2] + far * out * z}};
}

static void set_tree(struct bolt *bolt, const struct room *room)
{
    enum { BOUGHS = 9 };
    float foot = 0.94f * room->y, fork = 0.3f * room->y, top = -0.1f * room->y, lean = 0.05f * room->side;
    add_seed(bolt, -0.3f * lean, foot, 0.3f * lean, 0.5f * (foot + fork));
    add_seed(bolt, 0.3f * lean, 0.5f * (foot + fork), 0, fork);
    add_seed(bolt, 0, fork, -0.4f * lean, top);
    for (int i = 0; i < BOUGHS; i++) {
        float share = (float)i / BOUGHS, from[3] = {-0.4f * lean * share, fork + share * (top - fork), 0};
        add_bough(bolt, from, (0.27f - 0.1f * share) * room->side, 1.0f - 0.4f * share, 0.4f + 0.6f * share,
                  0.382f * (float)i + 0.05f * chance(i, 4));
    }
    add_charge(bolt, LAPLACIAN_PLANE, -9000, 0, 0.97f * room->y);
    for (int i = 0; i < 8; i++) {
        add_charge(bolt, LAPLACIAN_POINT, -1500, 0, foot + (fork - foot) * (float)i / 8);
    }
}

static void set_lichen(struct bolt *bolt, const struct room *room)
{
    for (int i = 0; i < 8; i++) {
        float x = (1.3f * chance(i, 0) - 0.65f) * room->x, y = (1.3f * chance(i, 1) - 0.65f) * room->y;
        add_point(bolt, x, y);
    }
}

static void set_coral(struct bolt *bolt, const struct room *room)
{
    enum { BOUGHS = 7 };
    const float from[3] = {0, 0.84f * room->y, 0};
    for (int i = 0; i < BOUGHS; i++) {
        add_bough(bolt, from, (0.2f + 0.16f * chance(i, 5)) * room->side, i == 0 ? 0.1f : 0.75f,
                  0.7f + 0.4f * chance(i, 6), 0.1667f * (float)i + 0.1f * chance(i, 4));
    }
    add_charge(bolt, LAPLACIAN_PLANE, -1500, 0, 0.95f * room->y);
}

static void set_river(struct bolt *bolt, const struct room *room)
{
    static const float BENDS[7] = {0.16f, 0.02f, -0.08f, -0.09f, 0.0f, 0.06f, 0.02f};
    for (int i = 0; i < 6; i++) {
        float y = (-1.1f + 0.1f * (float)i) * room->y, next = (-1.1f + 0.1f * (float)(i + 1)) * room->y;
        add_seed(bolt, BENDS[i] * room->x, y, BENDS[i + 1] * room->x, next);
        add_charge(bolt, LAPLACIAN_POINT, -900, (BENDS[i] - 0.15f) * room->x, y);
        add_charge(bolt, LAPLACIAN_POINT, -900, (BENDS[i] + 0.15f) * room->x, y);
    }
    enum { SHORE = 24 }; /* an arm that is ahead waits there for the others */
    for (int i = 0; i < SHORE; i++) {
        float x = 2.2f * ((float)i + 0.5f) / SHORE - 1.1f;
        add_charge(bolt, LAPLACIAN_POINT, -700, x * room->x, (1.05f - 0.3f * x * x) * room->y);
    }
    add_charge(bolt, LAPLACIAN_POINT, 30000, 0, 3 * room->y);
}

/* Arms with twigs at 60 degrees, of no two the same length; the growth does the rest. */
static void set_snow(struct bolt *bolt, const struct room *room)
{
    static const float WAYS[6][2] = {{0, -1}, {HALF_ROOT_3, -0.5f}, {HALF_ROOT_3, 0.5f},
                                     {0, 1},  {-HALF_ROOT_3, 0.5f}, {-HALF_ROOT_3, -0.5f}};
    enum { TWIGS = 3 };
    float far = 0.5f * room->side;
    for (int i = 0; i < 6; i++) {
        const float *way = WAYS[i], *left = WAYS[(i + 5) % 6], *right = WAYS[(i + 1) % 6];
        float arm = (0.74f + 0.06f * chance(i, 14)) * far;
        add_seed(bolt, 0, 0, arm * way[0], arm * way[1]);
        for (int k = 0; k < 2 * TWIGS; k++) {
            const float *aside = k < TWIGS ? left : right;
            float at = (0.2f + 0.17f * (float)(k % TWIGS) + 0.05f * chance(6 * i + k, 15)) * far;
            float twig = (0.26f - 0.05f * (float)(k % TWIGS) + 0.08f * chance(6 * i + k, 16)) * far;
            add_seed(bolt, at * way[0], at * way[1], at * way[0] + twig * aside[0], at * way[1] + twig * aside[1]);
        }
        add_charge(bolt, LAPLACIAN_POINT, -1200, 1.15f * far * way[0], 1.15f * far * way[1]);
        add_charge(bolt, LAPLACIAN_POINT, -300, far * (way[0] + right[0]) * 0.6f, far * (way[1] + right[1]) * 0.6f);
    }
}

/* Rays of an impact, each with two kinks, and arcs between some of them. */
static void set_fracture(struct bolt *bolt, const struct room *room)
{
    enum { RAYS = 12 };
    float at_x = 0.1f * room->x, at_y = -0.08f * room->y, knots[RAYS + 1][4][2];
    for (int i = 0; i < RAYS; i++) {
        float part = ((float)i + 0.8f * chance(i, 10)) / RAYS, far = 0;
        for (int k = 0; k < 4; k++) {
            float x, y;
            circle(part + (k > 0 ? 0.024f * (chance(i, 11 + k) - 0.5f) : 0), &x, &y);
            knots[i][k][0] = at_x + far * x;
            knots[i][k][1] = at_y + far * y;
            if (k > 0) {
                add_seed(bolt, knots[i][k - 1][0], knots[i][k - 1][1], knots[i][k][0], knots[i][k][1]);
            }
            far += (k == 0 ? 0.07f : 0.15f) * room->side * (0.7f + 0.6f * chance(i, 30 + k));
        }
    }
    for (int i = 0; i < RAYS; i++) {
        float(*next)[2] = knots[(i + 1) % RAYS];
        for (int k = 1; k < 3; k++) {
            if (chance(i, 40 + k) < (k == 1 ? 0.9f : 0.4f)) {
                add_seed(bolt, knots[i][k][0], knots[i][k][1], next[k][0], next[k][1]);
            }
        }
    }
    add_ring(bolt, 4, -60, 1.3f * room->x, 1.3f * room->y);
}

static void set_vessels(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, -0.45f * room->x, 0);
    add_ring(bolt, 48, -350, 1.05f * room->x, 1.05f * room->y);
}

static void set_city(struct bolt *bolt, const struct room *room)
{
    (void)room;
    add_point(bolt, 0, 0);
}

/* Fronds from a corner, with barbs; the growth feathers them. */
static void set_frost(struct bolt *bolt, const struct room *room)
{
    enum { FRONDS = 4, BARBS = 6 };
    static const float WAYS[FRONDS] = {0.985f, 0.905f, 0.835f, 0.765f}, LENGTHS[FRONDS] = {0.9f, 1.15f, 0.85f, 1};
    for (int i = 0; i < FRONDS; i++) {
        float x = -room->x, y = room->y, bend = 0.006f * (chance(i, 11) - 0.5f), far = LENGTHS[i] * room->side;
        for (int k = 0; k < BARBS; k++) {
            float part = WAYS[i] + bend * (float)k, way[2], barb[2], left = 1 - ((float)k + 0.5f) / BARBS;
            circle(part, &way[0], &way[1]);
            float next_x = x + far / BARBS * way[0], next_y = y + far / BARBS * way[1];
            add_seed(bolt, x, y, next_x, next_y);
            for (int side = -1; side <= 1 && k > 0; side += 2) {
                float length = (0.05f + 0.2f * left * (0.7f + 0.6f * chance(i, 20 + k))) * far;
                circle(part + 0.14f * (float)side, &barb[0], &barb[1]);
                add_seed(bolt, x, y, x + length * barb[0], y + length * barb[1]);
            }
            x = next_x;
            y = next_y;
        }
    }
    add_ring(bolt, 40, -400, 1.5f * room->x, 1.5f * room->y);
}

static void set_lichtenberg(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, 0, 0);
    add_ring(bolt, 48, -600, 0.53f * room->side, 0.53f * room->side);
}

static void (*const SETS[BOLT_KINDS])(struct bolt *bolt, const struct room *room) = {
    [BOLT_LIGHTNING] = set_lightning,
    [BOLT_TESLA] = set_tesla,
    [BOLT_TREE] = set_tree,
    [BOLT_LICHEN] = set_lichen,
    [BOLT_CORAL] = set_coral,
    [BOLT_RIVER] = set_river,
    [BOLT_SNOW] = set_snow,
    [BOLT_FRACTURE] = set_fracture,
    [BOLT_VESSELS] = set_vessels,
    [BOLT_CITY] = set_city,
    [BOLT_LICHTENBERG] = set_lichtenberg,
    [BOLT_FROST] = set_frost,
};

void bolt_preset(struct bolt *bolt, enum bolt_kind kind, int width, int height)
{
    kind = (int)kind >= 0 && kind < BOLT_KINDS ? kind : BOLT_LIGHTNING;
    const struct growing *growing = &GROWINGS[kind];
    float shorter = (float)(width < height ? width : height);
    *bolt = (struct bolt){.growth = laplacian_default_def(), .look = LOOKS[kind]};
    bolt->look.trunk *= shorter;
    bolt->look.tip *= shorter;
    struct laplacian_def *growth = &bolt->growth;
    growth->dimensions = growing->dimensions;
    growth->particles = growing->particles;
    growth->eta = growing->eta;
    growth->eta_end = growing->eta_end;
    growth->jitter = growing->jitter;
    growth->extent = growing->extent * growing->side;
    growth->off_grid = growing->off_grid;
    growth->span = growing->side * (float)width / shorter;
    growth->environment_radius = growth->span;
    growth->charges = bolt->charges;
    growth->seeds = bolt->seeds;
    struct room room = {0.5f * growth->span, 0.5f * growing->side * (float)height / shorter, growing->side};
    SETS[kind](bolt, &room);
}

float bolt_scale(const struct bolt *bolt, int width)
{
    return (float)width / bolt->growth.span;
}

static void stretch(float *at, float by)
{
    for (int d = 0; d < LAPLACIAN_DIMENSIONS_MAX; d++) {
        at[d] *= by;
    }
}

void bolt_respan(struct bolt *bolt, float span)
{
    struct laplacian_def *growth = &bolt->growth;
    float by = span / growth->span;
    growth->span = span;
    growth->extent *= by;
    growth->environment_radius *= by;
    for (int i = 0; i < growth->charge_count; i++) {
        stretch(bolt->charges[i].at, by);
        bolt->charges[i].radius *= by;
    }
    for (int i = 0; i < growth->seed_count; i++) {
        stretch(bolt->seeds[i].from, by);
        stretch(bolt->seeds[i].to, by);
    }
}
