/* Plants that feel the potential beside plants that do not: what bends to the light, keeps clear of a wall, climbs a
 * pole, fans out; branches that avoid each other. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "lsystem_plant.h"
#include "sheet.h"

enum { SHOWN = 480, FINE = 2 * SHOWN, ROOM = 512 };

struct canvas {
    float colour[FINE * FINE][3], near[FINE * FINE];
};

static void clear(struct canvas *canvas)
{
    for (int i = 0; i < FINE * FINE; i++) {
        canvas->near[i] = -1e9f;
        canvas->colour[i][0] = 0.86f;
        canvas->colour[i][1] = 0.88f;
        canvas->colour[i][2] = 0.86f;
    }
}

static float clamp(float value)
{
    return value < 0 ? 0 : value > 1 ? 1 : value;
}

/* A lit tube, or a ball; cells of the room, the origin in its middle, z away. */
static void tube(struct canvas *canvas, const float a[3], const float b[3], float ra, float rb, const float colour[3])
{
    const float zoom = (float)FINE / ROOM, half = FINE / 2.0f;
    float ax = a[0] * zoom + half, ay = a[1] * zoom + half, bx = b[0] * zoom + half, by = b[1] * zoom + half;
    float most = fmaxf(fmaxf(ra, rb) * zoom, 0.7f) + 1, dx = bx - ax, dy = by - ay, long_2 = dx * dx + dy * dy;
    int left = (int)fmaxf(0, fminf(ax, bx) - most), right = (int)fminf(FINE - 1, fmaxf(ax, bx) + most);
    int top = (int)fmaxf(0, fminf(ay, by) - most), bottom = (int)fminf(FINE - 1, fmaxf(ay, by) + most);
    for (int y = top; y <= bottom; y++) {
        for (int x = left; x <= right; x++) {
            float px = (float)x - ax, py = (float)y - ay;
            float part = long_2 > 0 ? clamp((px * dx + py * dy) / long_2) : 0;
            float radius = fmaxf((ra + part * (rb - ra)) * zoom, 0.7f);
            float nx = (px - part * dx) / radius, ny = (py - part * dy) / radius, off = nx * nx + ny * ny;
            float nz = sqrtf(fmaxf(0, 1 - off)), near = nz * radius - (a[2] + part * (b[2] - a[2])) * zoom;
            int at = y * FINE + x;
            if (off <= 1 && near > canvas->near[at]) {
                float light = 0.42f + 0.58f * clamp(0.5f * nx - 0.55f * ny + 0.67f * nz);
                float fade = clamp(0.5f - near / (1.6f * FINE)) * 0.5f; /* what is far fades */
                canvas->near[at] = near;
                for (int c = 0; c < 3; c++) {
                    canvas->colour[at][c] = light * colour[c] * (1 - fade) + 0.86f * fade;
                }
            }
        }
    }
}

static void show_around(struct canvas *canvas, const struct lsystem_def *def)
{
    static const float STONE[3] = {0.66f, 0.64f, 0.62f}, LIGHT[3] = {1, 0.82f, 0.3f};
    if (def->environment.values) {
        const float sun[3] = {215, -225, 100};
        tube(canvas, sun, sun, 14, 14, LIGHT);
    }
    for (int i = 0; i < def->charge_count; i++) {
        const struct laplacian_charge *charge = &def->charges[i];
        const float *at = charge->at;
        if (charge->shape == LAPLACIAN_PLANE && charge->charge < 0) {
            tube(canvas, (const float[3]){-260, at[1], 200}, (const float[3]){260, at[1], 200}, 2, 2, STONE);
        } else if (charge->shape == LAPLACIAN_CYLINDER) {
            tube(canvas, (const float[3]){at[0], -300, at[2]}, (const float[3]){at[0], 236, at[2]}, charge->radius,
                 charge->radius, STONE);
        } else if (charge->shape == LAPLACIAN_POINT) {
            tube(canvas, at, at, 9, 9, charge->charge > 0 ? LIGHT : STONE);
        }
    }
}

static void show_leaf(struct canvas *canvas, const struct lsystem_node *node, const float from[3], float green)
{
    float tip[3], by = 0;
    for (int d = 0; d < 3; d++) {
        by += (node->at[d] - from[d]) * (node->at[d] - from[d]);
    }
    by = by > 0 ? 7 / sqrtf(by) : 0;
    for (int d = 0; d < 3; d++) {
        tip[d] = node->at[d] + by * (node->at[d] - from[d]);
    }
    const float colour[3] = {0.22f + 0.25f * green, 0.42f + 0.2f * green, 0.16f};
    tube(canvas, node->at, tip, 2.4f, 0.6f, colour);
}

static void show(struct canvas *canvas, const struct lsystem *plant, const struct lsystem_plant *kind, uint8_t *rgb)
{
    int32_t count = lsystem_count(plant);
    bool *forks = calloc((size_t)count, sizeof *forks);
    if (!forks) {
        figure_stop("lsystem", "no memory");
    }
    clear(canvas);
    show_around(canvas, &kind->growth);
    for (int32_t i = 0; i < count; i++) {
        struct lsystem_node node = lsystem_node(plant, i);
        if (node.parent >= 0) {
            struct lsystem_node parent = lsystem_node(plant, node.parent);
            float part = clamp(1 - node.radius / 6), colour[3];
            for (int c = 0; c < 3; c++) {
                float from = sqrtf(kind->look.colour[c]), to = sqrtf(kind->look.core[c]);
                colour[c] = from + part * (to - from);
            }
            forks[node.parent] = true;
            tube(canvas, parent.at, node.at, fminf(parent.radius, 1.4f * node.radius + 0.2f), node.radius, colour);
        }
    }
    for (int32_t i = 0; i < count && kind->look.leaves > 0; i++) {
        struct lsystem_node node = lsystem_node(plant, i);
        if (node.parent >= 0 && (!forks[i] || (node.order > 0 && i % (int)kind->look.leaves == 0))) {
            show_leaf(canvas, &node, lsystem_node(plant, node.parent).at, node.potential);
        }
    }
    for (int i = 0; i < SHOWN * SHOWN; i++) {
        int at = i / SHOWN * 2 * FINE + i % SHOWN * 2;
        for (int c = 0; c < 3; c++) {
            float sum = canvas->colour[at][c] + canvas->colour[at + 1][c] + canvas->colour[at + FINE][c] +
                        canvas->colour[at + FINE + 1][c];
            rgb[3 * i + c] = (uint8_t)(255 * clamp(sum / 4) + 0.5f);
        }
    }
    free(forks);
}

/* A plant for a picture, grown to its end. */
static struct lsystem *grown(const struct lsystem_def *def)
{
    enum lsystem_status status;
    struct lsystem *plant = lsystem_create(def, &status);
    if (!plant) {
        figure_stop("lsystem", lsystem_status_names[status]);
    }
    lsystem_step(plant, def->steps);
    return plant;
}

struct measure {
    float x, lowest, highest; /* mean of x; least and greatest y */
    float around;             /* turns about the upright axis of the first axis, from first to last */
    int nodes;
};

static struct measure measure(const struct lsystem *plant)
{
    struct measure m = {.lowest = 1e9f, .highest = -1e9f, .nodes = lsystem_count(plant)};
    float before = 0;
    for (int32_t i = 0; i < m.nodes; i++) {
        struct lsystem_node node = lsystem_node(plant, i);
        m.x += node.at[0] / (float)m.nodes;
        m.lowest = fminf(m.lowest, node.at[1]);
        m.highest = fmaxf(m.highest, node.at[1]);
        if (node.order == 0) {
            float angle = atan2f(node.at[2], node.at[0]) / 6.2831853f;
            float by = i > 0 ? angle - before : 0;
            m.around += by - floorf(by + 0.5f);
            before = angle;
        }
    }
    return m;
}

static struct measure add(struct sheet *sheet, struct canvas *canvas, uint8_t *rgb, const struct lsystem_plant *kind,
                          const char *label)
{
    struct lsystem *plant = grown(&kind->growth);
    struct measure m = measure(plant);
    show(canvas, plant, kind, rgb);
    sheet_add(sheet, rgb, "%s: %d nodes, %s", label, m.nodes, lsystem_status_names[lsystem_status(plant)]);
    lsystem_destroy(plant);
    return m;
}

/* Without its surroundings: no attractors, repulsors, light, nor feeling for itself, and every bud breaks. */
static void leave_alone(struct lsystem_plant *plant)
{
    plant->growth.charge_count = 0;
    plant->growth.environment.values = NULL;
    plant->growth.tropism = 0;
    plant->growth.shyness = 0;
    plant->growth.clearance = 0;
    plant->growth.eta = 0;
}

static void show_kinds(struct figure *figure, struct sheet *sheet, struct canvas *canvas, uint8_t *rgb)
{
    static const char *const LABELS[LSYSTEM_KINDS][2] = {{"tree, light from the upper right", "the same rules, alone"},
                                                         {"vine round a pole", "alone"},
                                                         {"bush under a wall", "alone"},
                                                         {"coral that fans out", "alone"}};
    struct measure m[LSYSTEM_KINDS][2];
    struct lsystem_plant *kind = calloc(1, sizeof *kind);
    if (!kind) {
        figure_stop("lsystem", "no memory");
    }
    for (int i = 0; i < LSYSTEM_KINDS; i++) {
        lsystem_plant_preset(kind, (enum lsystem_kind)i, ROOM, ROOM);
        m[i][0] = add(sheet, canvas, rgb, kind, LABELS[i][0]);
        leave_alone(kind);
        kind->growth.nodes = 40000;
        m[i][1] = add(sheet, canvas, rgb, kind, LABELS[i][1]);
    }
    figure_check(figure, m[LSYSTEM_TREE][0].x > m[LSYSTEM_TREE][1].x + 20,
                 "the tree leans to the light: mean of x %.1f, alone %.1f", (double)m[LSYSTEM_TREE][0].x,
                 (double)m[LSYSTEM_TREE][1].x);
    figure_check(figure, fabsf(m[LSYSTEM_VINE][0].around) > 2, "the vine goes %.1f times round its pole",
                 (double)m[LSYSTEM_VINE][0].around);
    figure_check(figure, m[LSYSTEM_BUSH][0].lowest > -52 && m[LSYSTEM_BUSH][1].lowest < -72,
                 "the bush keeps clear of the wall at -61: it comes to %.1f, alone to %.1f",
                 (double)m[LSYSTEM_BUSH][0].lowest, (double)m[LSYSTEM_BUSH][1].lowest);
    free(kind);
}

void figure_lsystem(struct figure *figure)
{
    uint8_t *rgb = malloc((size_t)3 * SHOWN * SHOWN);
    struct canvas *canvas = malloc(sizeof *canvas);
    struct sheet *sheet = sheet_create(figure, "Plants that feel the potential", 4, 2, SHOWN);
    if (!rgb || !canvas) {
        figure_stop("lsystem", "no memory");
    }
    show_kinds(figure, sheet, canvas, rgb);
    sheet_finish(sheet);
    free(canvas);
    free(rgb);
}
