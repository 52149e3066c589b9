#include "lsystem_plant.h"

#include "lsystem_turtle.h"

const char *const lsystem_kind_names[LSYSTEM_KINDS + 1] = {"tree", "vine", "bush", "fan", NULL};
const char *const lsystem_kind_meanings[LSYSTEM_KINDS] = {
    "A tree on the ground that turns to the light at the upper right.",
    "A vine that climbs round a pole.",
    "A bush under a wall that it keeps clear of.",
    "A coral that forks in a plane, towards the light above.",
};

/* How bright the sky is: 1 in one direction, 0 at right angles to it and beyond. */
static void shine(struct lsystem_plant *plant, float x, float y, float z)
{
    for (int row = 0; row < LSYSTEM_SKY_HIGH; row++) {
        for (int column = 0; column < LSYSTEM_SKY_WIDE; column++) {
            float around = ((float)column + 0.5f) / LSYSTEM_SKY_WIDE * 360;
            float down = ((float)row + 0.5f) / LSYSTEM_SKY_HIGH * 180;
            float sine, cosine, polar_sine, polar_cosine;
            lsystem_turn(around, &sine, &cosine);
            lsystem_turn(down, &polar_sine, &polar_cosine);
            float light = polar_sine * cosine * x - polar_cosine * y + polar_sine * sine * z;
            plant->sky[row * LSYSTEM_SKY_WIDE + column] = light > 0 ? light * light : 0;
        }
    }
    plant->growth.environment = (struct action_raster){plant->sky, LSYSTEM_SKY_WIDE, LSYSTEM_SKY_HIGH, 1};
}

static struct laplacian_charge *add(struct lsystem_plant *plant, enum laplacian_shape shape, float charge, float x,
                                    float y)
{
    struct laplacian_charge *added = &plant->charges[plant->growth.charge_count++];
    *added = (struct laplacian_charge){.shape = shape, .charge = charge, .at = {x, y}, .along = {0, 1}};
    return added;
}

static void sow(struct lsystem_plant *plant, float x, float y, float z)
{
    plant->seeds[plant->growth.seed_count++] = (struct lsystem_seed){.at = {x, y, z}, .heading = {0, -1, 0}};
}

static void make_tree(struct lsystem_plant *plant, float width, float height, float scale)
{
    struct lsystem_def *growth = &plant->growth;
    growth->dimensions = 3;
    growth->steps = 34;
    growth->length = 12.5f * scale;
    growth->ratio = 0.9f;
    growth->run = 34;
    growth->decline = 0.5f;
    growth->angle = 48;
    growth->spacing = 2;
    growth->whorl = 2;
    growth->pipe = 2.7f;
    growth->eta = 0.8f;
    growth->tropism = 24;
    growth->upward = 2;
    growth->wobble = 6;
    growth->environment_radius = 0.8f * height;
    growth->environment_strength = 150;
    shine(plant, 0.78f, -0.62f, 0);
    add(plant, LAPLACIAN_PLANE, -20 * scale, 0, 0.46f * height);
    sow(plant, -0.12f * width, 0.45f * height, 0);
    plant->look.leaves = 5;
}

static void make_vine(struct lsystem_plant *plant, float height, float scale)
{
    struct lsystem_def *growth = &plant->growth;
    growth->dimensions = 3;
    growth->steps = 170;
    growth->length = 9 * scale;
    growth->run = 170;
    growth->decline = 0.12f;
    growth->ratio = 0.7f;
    growth->orders = 2;
    growth->spacing = 3;
    growth->angle = 55;
    growth->wobble = 5;
    growth->upward = 12;
    growth->setpoint = 58;
    growth->twine = 14;
    growth->tropism = 30;
    growth->eta = 0.6f;
    growth->shyness = 0.03f;
    growth->keep = 4 * scale;
    growth->clearance = 1;
    struct laplacian_charge *pole = add(plant, LAPLACIAN_CYLINDER, 12, 0, 0);
    pole->radius = 32 * scale;
    sow(plant, -60 * scale, 0.46f * height, 0);
    plant->look.leaves = 3;
}

static void make_bush(struct lsystem_plant *plant, float height, float scale)
{
    struct lsystem_def *growth = &plant->growth;
    growth->dimensions = 2;
    growth->steps = 44;
    growth->length = 11 * scale;
    growth->ratio = 0.9f;
    growth->run = 44;
    growth->decline = 0.7f;
    growth->angle = 38;
    growth->orders = 3;
    growth->tropism = 18;
    growth->eta = 0.35f;
    growth->wobble = 7;
    growth->clearance = 3;
    growth->keep = 10 * scale;
    growth->shyness = 0.15f;
    add(plant, LAPLACIAN_PLANE, -150 * scale, 0, -0.12f * height);
    add(plant, LAPLACIAN_PLANE, -6 * scale, 0, 0.46f * height);
    for (int i = -1; i <= 1; i++) {
        sow(plant, 40 * scale * (float)i, 0.45f * height, 0);
        plant->seeds[i + 1].heading[0] = 0.5f * (float)i;
    }
    plant->look.leaves = 4;
}

static void make_fan(struct lsystem_plant *plant, float height, float scale)
{
    struct lsystem_def *growth = &plant->growth;
    growth->dimensions = 3;
    growth->steps = 60;
    growth->length = 8 * scale;
    growth->ratio = 0.97f;
    growth->run = 20;
    growth->decline = 1;
    growth->spacing = 4;
    growth->whorl = 2;
    growth->divergence = 0;
    growth->orders = 8;
    growth->dominance = 0;
    growth->angle = 28;
    growth->wobble = 5;
    growth->upward = 0;
    growth->tropism = 16;
    growth->eta = 0.25f;
    growth->shyness = 0.2f;
    growth->clearance = 3;
    growth->tip = 1.4f * scale;
    add(plant, LAPLACIAN_PLANE, 3000 * scale, 0, -0.8f * height);
    add(plant, LAPLACIAN_PLANE, -60 * scale, 0, 0.46f * height);
    sow(plant, 0, 0.45f * height, 0);
}

void lsystem_plant_preset(struct lsystem_plant *plant, enum lsystem_kind kind, int width, int height)
{
    static const float COLOURS[LSYSTEM_KINDS][2][3] = {{{0.16f, 0.08f, 0.04f}, {0.07f, 0.22f, 0.03f}},
                                                       {{0.08f, 0.12f, 0.03f}, {0.05f, 0.25f, 0.05f}},
                                                       {{0.14f, 0.10f, 0.05f}, {0.10f, 0.26f, 0.06f}},
                                                       {{0.55f, 0.07f, 0.10f}, {0.90f, 0.35f, 0.25f}}};
    float scale = (float)(width < height ? width : height) / 512;
    *plant = (struct lsystem_plant){.growth = lsystem_default_def()};
    plant->growth.tip = 0.8f * scale;
    switch (kind) {
    case LSYSTEM_TREE:
        make_tree(plant, (float)width, (float)height, scale);
        break;
    case LSYSTEM_VINE:
        make_vine(plant, (float)height, scale);
        break;
    case LSYSTEM_BUSH:
        make_bush(plant, (float)height, scale);
        break;
    default:
        make_fan(plant, (float)height, scale);
    }
    plant->growth.response /= scale;
    plant->growth.clearance *= scale;
    keys_make_legal(lsystem_keys, &plant->growth);
    plant->growth.charges = plant->charges;
    plant->growth.seeds = plant->seeds;
    plant->look.style = BOLT_BODY;
    plant->look.tip = plant->growth.tip;
    plant->look.trunk = (kind == LSYSTEM_VINE ? 5.5f : 9) * scale;
    plant->look.smooth = 1;
    plant->look.pipe = plant->growth.pipe;
    for (int c = 0; c < 3; c++) {
        plant->look.colour[c] = COLOURS[kind][0][c];
        plant->look.core[c] = COLOURS[kind][1][c];
        plant->look.ground[c] = 0.88f;
    }
}
