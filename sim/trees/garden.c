#include "garden.h"

#include <float.h>
#include <stdlib.h>
#include <string.h>

#include "garden_state.h"
#include "rinse.h"

enum { SPAN_MOST = 1 << 21 }; /* ticks since the origin that floats hold well */

struct garden_def garden_default_def(void)
{
    return (struct garden_def){.detail = GARDEN_DETAIL, .ticks = 240, .growth = growth_preset(METAPHOR_INK, false)};
}

static int bound(int value, int least, int most)
{
    return value < least ? least : value > most ? most : value;
}

struct garden *garden_create(const struct garden_def *def)
{
    struct garden *garden = calloc(1, sizeof *garden);
    if (garden) {
        garden->def = *def;
        garden->def.detail = bound(def->detail, GARDEN_DETAIL_LEAST, GARDEN_DETAIL_MOST);
        garden->def.ticks = def->ticks >= 1 ? def->ticks : 1;
        garden->def.growth.plants = (struct action_path){NULL, 0};
        garden->work = WORK_ALL;
    }
    return garden;
}

void garden_destroy(struct garden *garden)
{
    if (garden) {
        garden_bed_destroy(garden->bed);
        strokes_finish(&garden->strokes);
        free(garden->growth.endpoints);
        free(garden->stock);
        free(garden);
    }
}

struct garden_def garden_get_def(const struct garden *garden)
{
    return garden->def;
}

void garden_resize(struct garden *garden, int width, int height)
{
    struct garden_def *def = &garden->def;
    bool same = (int64_t)def->width * height == (int64_t)def->height * width;
    garden->work |= same ? WORK_ROUTES : WORK_ALL; /* radii are in cells */
    def->width = width;
    def->height = height;
}

static void take_stock(struct garden *garden, const struct action_raster *picture)
{
    size_t count = (size_t)picture->width * (size_t)picture->height;
    float *grey = picture->values && count > 0 ? malloc(count * sizeof *grey) : NULL;
    if (picture->values && !grey) {
        return;
    }
    if (grey) {
        importance_grey(picture->values, picture->width, picture->height, 1, -1, grey);
    }
    free(garden->stock);
    garden->stock = grey;
    garden->stock_width = grey ? picture->width : 0;
    garden->stock_height = grey ? picture->height : 0;
    for (int i = 0; i < garden->seed_count; i++) {
        garden->seeds[i].tick = garden->now;
    }
    garden->work |= WORK_ALL;
}

/* What another value of a key makes to be done again. */
static unsigned work_of(const char *name)
{
    static const struct {
        const char *name;
        unsigned work;
    } WORKS[] = {
        {"metric", WORK_METRIC},
        {"emphasis", WORK_METRIC},
        {"endpoints", WORK_STIPPLE},
        {"seed", WORK_LATTICE},
        {"gradient", WORK_ALL & ~(unsigned)WORK_BED},
        {"intensity", WORK_ALL & ~(unsigned)WORK_BED},
        {"blur", WORK_ALL & ~(unsigned)WORK_BED},
        {"light", WORK_ALL & ~(unsigned)WORK_BED},
        {"base", WORK_LATTICE},
        {"picture", WORK_LATTICE},
        {"random", WORK_LATTICE},
        {"upward", WORK_LATTICE},
        {"sideways", WORK_LATTICE},
    };
    for (size_t i = 0; i < sizeof WORKS / sizeof *WORKS; i++) {
        if (strcmp(WORKS[i].name, name) == 0) {
            return WORKS[i].work;
        }
    }
    return WORK_STYLE;
}

static void take_shape(struct garden *garden, const struct action *action)
{
    const struct key *key = &growth_keys[action->option];
    if (key->type == KEY_PATH || key->type == KEY_POINT) {
        return; /* where it is planted, and where trees fork, are not values */
    }
    growth_take(&garden->def.growth, action->option, action->value);
    if (strcmp(key->name, "metaphor") == 0 || strcmp(key->name, "tree") == 0) {
        garden->work |= WORK_ALL & ~(unsigned)WORK_BED;
        return;
    }
    garden->work |= work_of(key->name);
}

static void drop_seed(struct garden *garden, int index)
{
    garden->seed_count--;
    memmove(&garden->seeds[index], &garden->seeds[index + 1],
            (size_t)(garden->seed_count - index) * sizeof garden->seeds[0]);
}

int garden_seeds(const struct garden *garden)
{
    int live = 0;
    for (int i = 0; i < garden->seed_count; i++) {
        live += garden->seeds[i].undone == 0;
    }
    return live;
}

/* The first seed that grows, or that was taken back. */
static int first_seed(const struct garden *garden, bool undone)
{
    int i = 0;
    while (i < garden->seed_count && (garden->seeds[i].undone > 0) != undone) {
        i++;
    }
    return i;
}

static void take_plant(struct garden *garden, const struct action *action)
{
    for (int i = garden->seed_count - 1; i >= 0; i--) { /* what was taken back before is lost */
        if (garden->seeds[i].undone > 0 && garden->seeds[i].visitor == action->visitor) {
            drop_seed(garden, i);
        }
    }
    if (garden_seeds(garden) == GARDEN_SEEDS) {
        drop_seed(garden, first_seed(garden, false));
    } else if (garden->seed_count == GARDEN_KEPT) {
        drop_seed(garden, first_seed(garden, true));
    }
    garden->seeds[garden->seed_count++] =
        (struct seed){.at = action->at, .tick = garden->now, .visitor = action->visitor};
    garden->work |= WORK_ROUTES;
}

static void take_undo(struct garden *garden, int visitor)
{
    for (int i = garden->seed_count - 1; i >= 0; i--) {
        struct seed *seed = &garden->seeds[i];
        if (seed->undone == 0 && (visitor == 0 || seed->visitor == visitor)) {
            seed->undone = ++garden->undone;
            garden->work |= WORK_ROUTES;
            return;
        }
    }
}

static void take_redo(struct garden *garden, int visitor)
{
    struct seed *last = NULL;
    for (int i = 0; i < garden->seed_count; i++) {
        struct seed *seed = &garden->seeds[i];
        if (seed->undone > (last ? last->undone : 0) && (visitor == 0 || seed->visitor == visitor)) {
            last = seed;
        }
    }
    if (last && garden_seeds(garden) < GARDEN_SEEDS) {
        last->undone = 0;
        last->tick = garden->now;
        garden->work |= WORK_ROUTES;
    }
}

static void take_hold(struct garden *garden, const struct action *action)
{
    struct hold *hold = NULL;
    for (int i = 0; i < GARDEN_HOLDS; i++) {
        if (garden->holds[i].lies && garden->holds[i].visitor == action->visitor) {
            hold = &garden->holds[i];
        }
    }
    for (int i = 0; i < GARDEN_HOLDS && !hold && action->has_at; i++) {
        hold = garden->holds[i].lies ? NULL : &garden->holds[i];
    }
    if (!hold) {
        return;
    }
    *hold = (struct hold){action->at, action->radius, action->visitor, action->has_at};
    garden->work |= WORK_ROUTES;
}

static void take_tend(struct garden *garden, const struct action *action)
{
    int count = action->path.count;
    struct point *points = count > 0 && garden_bed_ready(garden) ? malloc((size_t)count * sizeof *points) : NULL;
    if (!points) {
        return;
    }
    for (int i = 0; i < count; i++) {
        points[i] = garden_node_place(garden, action->path.points[i]);
    }
    float radius = action->radius * garden_node_scale(garden);
    radius = radius > 1 ? radius : 1;
    struct rectangle touched = garden_tend(garden->bed, points, count, radius, action->amount);
    free(points);
    if (!rectangle_is_empty(touched)) {
        garden->tended = rectangle_is_empty(garden->tended) ? touched : rectangle_join(garden->tended, touched);
        garden->work |= WORK_ROUTES;
    }
}

static void take_clear(struct garden *garden)
{
    struct bed *bed = garden->bed;
    garden->seed_count = 0;
    memset(garden->holds, 0, sizeof garden->holds);
    garden->work |= WORK_ROUTES;
    if (bed) {
        garden->work |= garden_untend(bed) ? WORK_LATTICE | WORK_STIPPLE : 0;
        for (int32_t i = 0; i < bed->base->nodes; i++) {
            bed->birth[i] = FLT_MAX;
            bed->left[i] = 1;
            bed->washed[i] = -FLT_MAX;
        }
    }
    garden->origin = garden->now;
}

static void take_rinse(struct garden *garden, const struct action *action)
{
    struct bed *bed = garden->bed;
    const struct canvas canvas = {.width = garden->def.width, .height = garden->def.height};
    struct rinse rinse;
    if (!bed || (!action->has_at && action->path.count == 0)) {
        return;
    }
    rinse_begin(&rinse, &canvas, action);
    float tick = (float)(garden->now - garden->origin);
    for (int y = 0; y < bed->height; y++) {
        int row = (int)(((float)y + 0.5f) * (float)canvas.height / (float)bed->height);
        for (int x = 0; x < bed->width; x++) {
            int column = (int)(((float)x + 0.5f) * (float)canvas.width / (float)bed->width);
            int32_t node = lattice_node(bed->base, x, y);
            if (bed->birth[node] >= FLT_MAX || column < rinse.cells.x0 || column >= rinse.cells.x1 ||
                row < rinse.cells.y0 || row >= rinse.cells.y1) {
                continue;
            }
            float turn, phase = rinse_phase(&rinse, column, row, &turn);
            if (phase > 0) {
                bed->left[node] *= 1 - rinse_takes(phase, action->strength);
                bed->washed[node] = tick;
                garden->work |= WORK_STYLE;
            }
        }
    }
}

/* Births count from now on. */
static void move_origin(struct garden *garden)
{
    struct bed *bed = garden->bed;
    float later = (float)(garden->now - garden->origin);
    for (int32_t i = 0; bed && i < bed->base->nodes; i++) {
        bed->birth[i] = bed->birth[i] < FLT_MAX ? bed->birth[i] - later : FLT_MAX;
        bed->washed[i] = bed->washed[i] > -FLT_MAX ? bed->washed[i] - later : -FLT_MAX;
    }
    garden->origin = garden->now;
    garden->work |= WORK_STYLE;
}

void garden_act(struct garden *garden, int64_t tick, const struct action *action)
{
    struct action legal = action_legal(action);
    garden->origin = garden->begun ? garden->origin : tick;
    garden->now = garden->begun && tick < garden->now ? garden->now : tick;
    garden->begun = true;
    if (garden->now - garden->origin > SPAN_MOST) {
        move_origin(garden);
    }
    switch (legal.verb) {
    case ACTION_STOCK:
        take_stock(garden, &legal.picture);
        break;
    case ACTION_SHAPE:
        take_shape(garden, &legal);
        break;
    case ACTION_PLANT:
        take_plant(garden, &legal);
        break;
    case ACTION_TEND:
        take_tend(garden, &legal);
        break;
    case ACTION_HOLD:
        take_hold(garden, &legal);
        break;
    case ACTION_UNDO:
        take_undo(garden, legal.visitor);
        break;
    case ACTION_REDO:
        take_redo(garden, legal.visitor);
        break;
    case ACTION_CLEAR:
        take_clear(garden);
        break;
    case ACTION_RINSE:
        take_rinse(garden, &legal);
        break;
    default:
        break;
    }
}

bool garden_due(const struct garden *garden)
{
    return garden->work != 0;
}

static uint64_t visitors(const struct garden *garden, bool undone)
{
    uint64_t bits = 0;
    for (int i = 0; i < garden->seed_count; i++) {
        const struct seed *seed = &garden->seeds[i];
        bool known = seed->visitor >= 0 && seed->visitor < GARDEN_VISITORS;
        bits |= known && (seed->undone > 0) == undone ? UINT64_C(1) << seed->visitor : 0;
    }
    return bits;
}

uint64_t garden_can_undo(const struct garden *garden)
{
    return visitors(garden, false);
}

uint64_t garden_can_redo(const struct garden *garden)
{
    return visitors(garden, true);
}

bool garden_has_stock(const struct garden *garden)
{
    return garden->stock;
}

bool garden_get_plan(const struct garden *garden, struct garden_plan *plan)
{
    const struct bed *bed = garden->bed;
    *plan = (struct garden_plan){.tick = garden->origin};
    if (!bed || !garden->stock) {
        return false;
    }
    plan->lattice = bed->base;
    plan->importance = bed->importance;
    plan->dendrite = bed->dendrite;
    plan->picture = bed->picture;
    plan->unit = bed->unit;
    return true;
}
