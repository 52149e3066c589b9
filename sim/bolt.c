#include "bolt.h"

#include "random.h"

const char *const bolt_kind_names[BOLT_KINDS + 1] = {"lightning",   "tesla", "tree",     "lichen",  "coral",
                                                     "river",       "snow",  "fracture", "vessels", "city",
                                                     "lichtenberg", "frost", NULL};

const char *const bolt_kind_meanings[BOLT_KINDS] = {
    "A strike from the clouds to the ground: it ends where it hits.",
    "Streamers from an electrode in all directions, in three dimensions; they keep clear of each other.",
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

/* What is said of a kind in a line. Colours are linear light; lengths of the look are shares of the shorter side. */
struct row {
    int dimensions, particles;
    float side;                         /* cells of the growth along the room's shorter side */
    float eta, eta_end, jitter, extent; /* extent: a share of the shorter side */
    bool off_grid;
    int style, smooth;
    float trunk, tip, pipe, leaves, life;
    float colour[3], core[3], ground[3];
};

static const struct row ROWS[BOLT_KINDS] = {
    [BOLT_LIGHTNING] = {2,
                        40000,
                        420,
                        7,
                        -1,
                        0.9f,
                        0,
                        true,
                        BOLT_GLOW,
                        0,
                        0.0042f,
                        0.0005f,
                        2.6f,
                        0,
                        45,
                        {0.28f, 0.36f, 1},
                        {1, 0.97f, 1},
                        {0.004f, 0.005f, 0.016f}},
    [BOLT_TESLA] = {3,
                    60000,
                    520,
                    8,
                    -1,
                    0.9f,
                    0.46f,
                    true,
                    BOLT_GLOW,
                    0,
                    0.004f,
                    0.0005f,
                    3,
                    0,
                    20,
                    {0.42f, 0.2f, 1},
                    {1, 0.94f, 1},
                    {0.005f, 0.003f, 0.012f}},
    [BOLT_TREE] = {3,
                   30000,
                   260,
                   6,
                   -1,
                   0.9f,
                   0,
                   true,
                   BOLT_BODY,
                   3,
                   0.022f,
                   0.001f,
                   2.1f,
                   5,
                   0,
                   {0.1f, 0.055f, 0.03f},
                   {0.16f, 0.3f, 0.05f},
                   {0.72f, 0.8f, 0.86f}},
    [BOLT_LICHEN] = {2,
                     16000,
                     230,
                     2,
                     -1,
                     0.9f,
                     0,
                     true,
                     BOLT_BODY,
                     1,
                     0.006f,
                     0.004f,
                     3,
                     0,
                     0,
                     {0.5f, 0.52f, 0.28f},
                     {0.7f, 0.72f, 0.5f},
                     {0.12f, 0.115f, 0.11f}},
    [BOLT_CORAL] = {3,
                    6000,
                    90,
                    4,
                    -1,
                    0.9f,
                    0,
                    true,
                    BOLT_BODY,
                    3,
                    0.03f,
                    0.008f,
                    3,
                    0,
                    0,
                    {0.78f, 0.2f, 0.12f},
                    {1, 0.75f, 0.6f},
                    {0.01f, 0.07f, 0.11f}},
    [BOLT_RIVER] = {2,
                    12000,
                    300,
                    5,
                    -1,
                    0.9f,
                    0,
                    true,
                    BOLT_LINE,
                    4,
                    0.02f,
                    0.0012f,
                    2.2f,
                    0,
                    0,
                    {0.03f, 0.13f, 0.16f},
                    {0.12f, 0.3f, 0.3f},
                    {0.34f, 0.27f, 0.15f}},
    [BOLT_SNOW] = {2,
                   9000,
                   300,
                   5,
                   -1,
                   0.9f,
                   0.45f,
                   true,
                   BOLT_LINE,
                   2,
                   0.012f,
                   0.0022f,
                   4,
                   0,
                   0,
                   {0.85f, 0.93f, 1},
                   {1, 1, 1},
                   {0.02f, 0.05f, 0.12f}},
    [BOLT_FRACTURE] = {2,
                       9000,
                       420,
                       9,
                       -1,
                       0.9f,
                       0,
                       true,
                       BOLT_LINE,
                       1,
                       0.004f,
                       0.0008f,
                       3,
                       0,
                       0,
                       {0.85f, 0.92f, 0.95f},
                       {1, 1, 1},
                       {0.05f, 0.07f, 0.08f}},
    [BOLT_VESSELS] = {2,
                      14000,
                      330,
                      5,
                      -1,
                      0.9f,
                      0,
                      true,
                      BOLT_LINE,
                      5,
                      0.014f,
                      0.001f,
                      3,
                      0,
                      0,
                      {0.28f, 0.012f, 0.01f},
                      {0.9f, 0.5f, 0.25f},
                      {0.6f, 0.16f, 0.05f}},
    [BOLT_CITY] = {2,
                   5000,
                   110,
                   2.5f,
                   -1,
                   0,
                   0,
                   false,
                   BOLT_LINE,
                   0,
                   0.009f,
                   0.0016f,
                   2.5f,
                   0,
                   0,
                   {0.9f, 0.85f, 0.7f},
                   {1, 0.8f, 0.35f},
                   {0.09f, 0.1f, 0.1f}},
    [BOLT_LICHTENBERG] =
        {2,
         30000,
         420,
         5,
         -1,
         0.9f,
         0.47f,
         true,
         BOLT_GLOW,
         0,
         0.005f,
         0.0006f,
         2.6f,
         0,
         0,
         {0.2f, 0.45f, 1},
         {0.95f, 1, 1},
         {0.003f, 0.005f, 0.012f}},
    [BOLT_FROST] = {2,
                    20000,
                    330,
                    4,
                    -1,
                    0.9f,
                    0,
                    true,
                    BOLT_LINE,
                    2,
                    0.005f,
                    0.001f,
                    3,
                    0,
                    0,
                    {0.75f, 0.87f, 0.95f},
                    {1, 1, 1},
                    {0.03f, 0.07f, 0.11f}},
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

static void set_lightning(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, -0.08f * room->x, -0.98f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, -6000, 0, -1.06f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, 20000, 0, 1.1f * room->y);
    add_charge(bolt, LAPLACIAN_POINT, 4000, 0.1f * room->x, 0.97f * room->y)->ends = true;
}

static void set_tree(struct bolt *bolt, const struct room *room)
{
    add_seed(bolt, 0, 0.93f * room->y, 0, 0.6f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, -3000, 0, 0.96f * room->y);
}

static void set_lichen(struct bolt *bolt, const struct room *room)
{
    for (int i = 0; i < 5; i++) {
        float x = (1.3f * chance(i, 0) - 0.65f) * room->x, y = (1.3f * chance(i, 1) - 0.65f) * room->y;
        add_point(bolt, x, y);
    }
}

static void set_coral(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, 0, 0.85f * room->y);
    add_point(bolt, -0.2f * room->x, 0.85f * room->y);
    add_point(bolt, 0.22f * room->x, 0.85f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, -1500, 0, 0.9f * room->y);
}

static void set_river(struct bolt *bolt, const struct room *room)
{
    add_seed(bolt, 0, -1.1f * room->y, 0, -0.5f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, -4000, 0, -1.2f * room->y);
    add_charge(bolt, LAPLACIAN_PLANE, 8000, 0, 1.1f * room->y)->ends = true;
}

static void set_snow(struct bolt *bolt, const struct room *room)
{
    static const float WAYS[6][2] = {{0, -1}, {HALF_ROOT_3, -0.5f}, {HALF_ROOT_3, 0.5f},
                                     {0, 1},  {-HALF_ROOT_3, 0.5f}, {-HALF_ROOT_3, -0.5f}};
    float far = 0.5f * room->side;
    for (int i = 0; i < 6; i++) {
        add_seed(bolt, 0, 0, 0.05f * far * WAYS[i][0], 0.05f * far * WAYS[i][1]);
        add_charge(bolt, LAPLACIAN_POINT, 3000, 1.1f * far * WAYS[i][0], 1.1f * far * WAYS[i][1]);
    }
}

static void set_fracture(struct bolt *bolt, const struct room *room)
{
    float at_x = 0.1f * room->x, at_y = -0.08f * room->y;
    add_point(bolt, at_x, at_y);
}

static void set_vessels(struct bolt *bolt, const struct room *room)
{
    add_point(bolt, -0.45f * room->x, 0);
    for (int i = 0; i < 40; i++) {
        add_charge(bolt, LAPLACIAN_POINT, 300, (2 * chance(i, 2) - 1) * room->x, (2 * chance(i, 3) - 1) * room->y);
    }
}

static void set_city(struct bolt *bolt, const struct room *room)
{
    (void)room;
    add_point(bolt, 0, 0);
}

static void set_frost(struct bolt *bolt, const struct room *room)
{
    add_seed(bolt, -room->x, -0.6f * room->y, -room->x, room->y);
    add_seed(bolt, -room->x, room->y, 0.8f * room->x, room->y);
}

static void set_middle(struct bolt *bolt, const struct room *room)
{
    (void)room;
    add_point(bolt, 0, 0);
}

static void (*const SETS[BOLT_KINDS])(struct bolt *bolt, const struct room *room) = {
    [BOLT_LIGHTNING] = set_lightning, [BOLT_TESLA] = set_middle,       [BOLT_TREE] = set_tree,
    [BOLT_LICHEN] = set_lichen,       [BOLT_CORAL] = set_coral,        [BOLT_RIVER] = set_river,
    [BOLT_SNOW] = set_snow,           [BOLT_FRACTURE] = set_fracture,  [BOLT_VESSELS] = set_vessels,
    [BOLT_CITY] = set_city,           [BOLT_LICHTENBERG] = set_middle, [BOLT_FROST] = set_frost,
};

static struct bolt_look look_of(const struct row *row, float shorter)
{
    struct bolt_look look = {.style = row->style,
                             .trunk = row->trunk * shorter,
                             .tip = row->tip * shorter,
                             .pipe = row->pipe,
                             .leaves = row->leaves,
                             .life = row->life,
                             .smooth = row->smooth};
    for (int c = 0; c < 3; c++) {
        look.colour[c] = row->colour[c];
        look.core[c] = row->core[c];
        look.ground[c] = row->ground[c];
    }
    return look;
}

void bolt_preset(struct bolt *bolt, enum bolt_kind kind, int width, int height)
{
    const struct row *row = &ROWS[(int)kind >= 0 && kind < BOLT_KINDS ? kind : BOLT_LIGHTNING];
    float shorter = (float)(width < height ? width : height);
    *bolt = (struct bolt){.growth = laplacian_default_def(), .look = look_of(row, shorter)};
    struct laplacian_def *growth = &bolt->growth;
    growth->dimensions = row->dimensions;
    growth->particles = row->particles;
    growth->eta = row->eta;
    growth->eta_end = row->eta_end;
    growth->jitter = row->jitter;
    growth->extent = row->extent * row->side;
    growth->off_grid = row->off_grid;
    growth->span = row->side * (float)width / shorter;
    growth->charges = bolt->charges;
    growth->seeds = bolt->seeds;
    struct room room = {0.5f * growth->span, 0.5f * row->side * (float)height / shorter, row->side};
    SETS[row - ROWS](bolt, &room);
}

float bolt_scale(const struct bolt *bolt, int width)
{
    return (float)width / bolt->growth.span;
}
