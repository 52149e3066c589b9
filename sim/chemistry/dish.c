#include "dish.h"

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "dish_state.h"
#include "gray_scott_classes.h"
#include "hash.h"

#define COMBED_BY 0.5f   /* anisotropy of v that a comb brings */
#define STYLED_BY 0.006f /* kill rate that the light places of a style have more, if nothing is said */

static int cells(int side, float scale)
{
    int count = (int)((float)side / scale + 0.5f);
    return count < 4 ? 4 : count > GRAY_SCOTT_SIZE_MAX ? GRAY_SCOTT_SIZE_MAX : count;
}

static int cells_x(const struct dish *dish)
{
    return cells(dish->width, dish->def.scale);
}

static int cells_y(const struct dish *dish)
{
    return cells(dish->height, dish->def.scale);
}

struct dish *dish_create(int width, int height)
{
    struct dish *dish = calloc(1, sizeof *dish);
    if (!dish) {
        return NULL;
    }
    dish->def = dish_default_def();
    dish->width = width;
    dish->height = height;
    dish->fresh = true;
    dish->chemistry = gray_scott_create(cells_x(dish), cells_y(dish), &dish->def.reaction, 1, VECTORS_BEST);
    dish->seen = dish->chemistry ? calloc(dish_cells(dish), sizeof *dish->seen) : NULL;
    if (!dish->seen) {
        dish_destroy(dish);
        return NULL;
    }
    dish_make_stops(dish);
    return dish;
}

void dish_destroy(struct dish *dish)
{
    if (dish) {
        gray_scott_destroy(dish->chemistry);
        free(dish->style);
        free(dish->along);
        free(dish->dry);
        free(dish->seen);
        free(dish->before);
        free(dish);
    }
}

const struct gray_scott *dish_chemistry(const struct dish *dish)
{
    return dish->chemistry;
}

void dish_set(struct dish *dish)
{
    struct gray_scott_def def = dish->def.reaction;
    bool plain = !(fabsf(def.anisotropy_u) > 0 || fabsf(def.anisotropy_v) > 0);
    bool bare = !(fabsf(def.style_feed) > 0 || fabsf(def.style_kill) > 0 || def.style_rate > 0);
    def.anisotropy_v = plain && dish->along ? COMBED_BY : def.anisotropy_v;
    def.style_kill = bare && dish->map.values ? STYLED_BY : def.style_kill;
    dish->failed = !gray_scott_set(dish->chemistry, &def) || dish->failed;
}

static void see(struct dish *dish)
{
    size_t width = (size_t)gray_scott_width(dish->chemistry);
    for (int y = 0; y < gray_scott_height(dish->chemistry); y++) {
        memcpy(dish->seen + (size_t)y * width, gray_scott_v(dish->chemistry, y), width * sizeof *dish->seen);
    }
}

/* Values of so many cells, bilinear between those of others; `channels` of them. NULL for none, and when memory is
 * short. */
static float *refitted(const float *values, int channels, int columns, int rows, int width, int height)
{
    size_t count = (size_t)width * (size_t)height;
    float *other = values ? malloc((size_t)channels * count * sizeof *other) : NULL;
    for (int channel = 0; channel < channels && other; channel++) {
        const float *plane = values + (size_t)channel * (size_t)columns * (size_t)rows;
        dish_sample(plane, columns, rows, width, height, other + (size_t)channel * count);
    }
    return other;
}

/* The chemistry on the grid that sheet and scale ask for. */
static void regrid(struct dish *dish)
{
    int columns = gray_scott_width(dish->chemistry), rows = gray_scott_height(dish->chemistry);
    int width = cells_x(dish), height = cells_y(dish);
    if (columns == width && rows == height) {
        return;
    }
    struct gray_scott *other = gray_scott_resampled(dish->chemistry, width, height);
    float *seen = other ? calloc((size_t)width * (size_t)height, sizeof *seen) : NULL;
    float *along = refitted(dish->along, 2, columns, rows, width, height);
    float *dry = refitted(dish->dry, 1, columns, rows, width, height);
    if (!seen || (dish->along && !along) || (dish->dry && !dry)) {
        gray_scott_destroy(other);
        free(seen);
        free(along);
        free(dry);
        dish->failed = true;
        return;
    }
    gray_scott_destroy(dish->chemistry);
    free(dish->seen);
    free(dish->before);
    free(dish->along);
    free(dish->dry);
    dish->along = along;
    dish->dry = dry;
    dish->chemistry = other;
    dish->seen = seen;
    dish->before = NULL;
    dish->combed = dish->along != NULL;
    if (dish->map.values) {
        dish->failed = !gray_scott_style(other, &dish->map) || dish->failed;
    }
    see(dish);
}

void dish_resize(struct dish *dish, int width, int height)
{
    dish->width = width;
    dish->height = height;
    regrid(dish);
}

static void take_react(struct dish *dish, const struct action *action)
{
    dish_take(&dish->def, action->option, action->value);
    if (dish_keys[action->option].offset == offsetof(struct dish_def, preset)) {
        dish->starts = dish->fresh;
        dish->sows = 0;
    }
    dish_set(dish);
    regrid(dish);
    dish_make_stops(dish);
}

void dish_act(struct dish *dish, int64_t tick, const struct action *action)
{
    struct action legal = action_legal(action);
    (void)tick;
    switch (legal.verb) {
    case ACTION_DOSE:
        dish_dose(dish, &legal);
        break;
    case ACTION_REACT:
        take_react(dish, &legal);
        break;
    case ACTION_STYLE:
        dish_style(dish, &legal);
        break;
    case ACTION_GUIDE:
        dish_comb(dish, &legal);
        break;
    case ACTION_RINSE:
        dish_rinse(dish, &legal);
        break;
    case ACTION_DRY:
        dish_dry(dish, &legal, false);
        break;
    case ACTION_WET:
        dish_dry(dish, &legal, true);
        break;
    case ACTION_CLEAR:
        dish_clear(dish);
        break;
    default:
        break;
    }
}

static void begin(struct dish *dish)
{
    struct gray_scott_preset preset = gray_scott_presets[dish->def.preset];
    dish->starts = false;
    dish->sows = 0;
    if (dish->def.start == DISH_START_NOTHING) {
        return;
    }
    preset.start = dish->def.start == DISH_START_SPOTS   ? START_SPOTS
                   : dish->def.start == DISH_START_NOISE ? START_NOISE
                                                         : preset.start;
    preset.radius *= dish->def.reaction.size;
    gray_scott_preset_start(dish->chemistry, &preset, (uint32_t)dish->def.reaction.seed + (uint32_t)dish->sowings);
    dish->sowings++;
    dish->sown = true;
    dish->fresh = false;
}

/* Whether so little is left that nothing comes of it. */
static bool is_spent(const struct dish *dish)
{
    float least = 1, most = 0;
    for (int y = 0; y < gray_scott_height(dish->chemistry); y++) {
        const float *u = gray_scott_u(dish->chemistry, y), *v = gray_scott_v(dish->chemistry, y);
        for (int x = 0; x < gray_scott_width(dish->chemistry); x++) {
            least = u[x] < least ? u[x] : least;
            most = v[x] > most ? v[x] : most;
        }
    }
    return most < 1e-4f && least > 0.99f;
}

/* Nothing is left. What was to live for hours is sown anew. */
static void run_out(struct dish *dish, int64_t tick)
{
    const struct gray_scott_preset *preset = &gray_scott_presets[dish->def.preset];
    const struct gray_scott_def *reaction = &dish->def.reaction;
    bool own = !(fabsf(reaction->feed - preset->feed) > 0) && !(fabsf(reaction->kill - preset->kill) > 0);
    gray_scott_fill(dish->chemistry, 1, 0);
    dish->fresh = true;
    dish->sows = dish->sown && own && preset->is != CLASS_UNIFORM ? tick + DISH_BARE : 0;
}

/* The steps of a tick; where something is dry the cell keeps a share of what it was. */
static bool step(struct dish *dish, int steps)
{
    size_t count = dish_cells(dish);
    if (!dish->dry) {
        gray_scott_step(dish->chemistry, steps);
        return true;
    }
    dish->before = dish->before ? dish->before : malloc(4 * count * sizeof *dish->before);
    if (!dish->before) {
        return false;
    }
    float *was[2] = {dish->before, dish->before + count}, *is[2] = {was[1] + count, was[1] + 2 * count};
    gray_scott_save(dish->chemistry, was[0], was[1]);
    gray_scott_step(dish->chemistry, steps);
    gray_scott_save(dish->chemistry, is[0], is[1]);
    for (int chemical = 0; chemical < 2; chemical++) {
        for (size_t i = 0; i < count; i++) {
            is[chemical][i] += dish->dry[i] * (was[chemical][i] - is[chemical][i]);
        }
    }
    gray_scott_load(dish->chemistry, is[0], is[1]);
    return true;
}

/* Steps of this tick: fewer the drier the sheet is. */
static int steps_now(struct dish *dish)
{
    dish->owed += (float)dish->def.steps * (1 - dish->all_dry);
    int steps = (int)dish->owed;
    dish->owed -= (float)steps;
    return steps;
}

bool dish_tick(struct dish *dish, int64_t tick)
{
    if (dish->starts || (dish->sows > 0 && tick >= dish->sows)) {
        begin(dish);
    }
    if (dish->combed) {
        const struct action_raster field = {dish->along, gray_scott_width(dish->chemistry),
                                            gray_scott_height(dish->chemistry), 2};
        dish->failed = !gray_scott_orient(dish->chemistry, dish->along ? &field : NULL) || dish->failed;
        dish->combed = false;
        dish_set(dish);
    }
    if (dish->fresh) {
        dish->owed = 0;
        return !dish->failed;
    }
    int steps = steps_now(dish);
    if (steps > 0) {
        dish->failed = !step(dish, steps) || dish->failed;
    }
    if (tick % DISH_LOOKED == 0 && is_spent(dish)) {
        run_out(dish, tick);
    }
    see(dish);
    return !dish->failed;
}

bool dish_is_calm(const struct dish *dish)
{
    bool turns = dish->def.torus && fabsf(dish->def.turn) > 0;
    return !turns && !dish->starts && dish->sows == 0 && !dish->combed && (dish->fresh || dish->all_dry >= 1);
}

static uint64_t hash_of(const void *scene)
{
    const struct dish *dish = scene;
    uint64_t hash = HASH_START;
    size_t width = (size_t)gray_scott_width(dish->chemistry);
    for (const struct key *key = dish_keys; key->name; key++) {
        float value = key_value(key, &dish->def);
        hash = hash_bytes(hash, &value, sizeof value);
    }
    for (int y = 0; y < gray_scott_height(dish->chemistry); y++) {
        hash = hash_bytes(hash, gray_scott_u(dish->chemistry, y), width * sizeof(float));
        hash = hash_bytes(hash, gray_scott_v(dish->chemistry, y), width * sizeof(float));
    }
    if (dish->map.values) {
        size_t count = (size_t)dish->map.width * (size_t)dish->map.height * (size_t)dish->map.channels;
        hash = hash_bytes(hash, dish->map.values, count * sizeof(float));
    }
    if (dish->along) {
        hash = hash_bytes(hash, dish->along, 2 * dish_cells(dish) * sizeof(float));
    }
    if (dish->dry) {
        hash = hash_bytes(hash, dish->dry, dish_cells(dish) * sizeof(float));
    }
    if (dish->sows > 0) {
        hash = hash_bytes(hash, &dish->sows, sizeof dish->sows);
    }
    if (dish->sowings > 0) { /* what comes when all has died out */
        hash = hash_number(hash, 2 * dish->sowings + dish->sown);
    }
    hash = hash_bytes(hash, &dish->all_dry, sizeof dish->all_dry);
    return hash_bytes(hash, &dish->owed, sizeof dish->owed);
}

static void *create(int width, int height)
{
    return dish_create(width, height);
}

static void destroy(void *scene)
{
    dish_destroy(scene);
}

static void resize(void *scene, int width, int height)
{
    dish_resize(scene, width, height);
}

static void act(void *scene, int64_t tick, const struct action *action)
{
    dish_act(scene, tick, action);
}

static bool tick(void *scene, int64_t now)
{
    return dish_tick(scene, now);
}

static uint64_t nobody(const void *scene)
{
    (void)scene;
    return 0;
}

static const char *const PLANES[] = {"u", "v", NULL};

static void initial_options(void *options)
{
    *(struct dish_def *)options = dish_default_def();
}

static void take_option(void *options, int key, float value)
{
    dish_take(options, key, value);
}

static const char *const BRINGS[] = {"preset", NULL};

static bool is_calm(const void *scene, int64_t now)
{
    (void)now;
    return dish_is_calm(scene);
}

const struct scene_type dish_type = {
    .shows = SHOW_PATTERN,
    .options = dish_keys,
    .brings = BRINGS,
    .sets = ACTION_REACT,
    .begins = ACTION_DOSE,
    .initial = initial_options,
    .take = take_option,
    .create = create,
    .destroy = destroy,
    .resize = resize,
    .act = act,
    .tick = tick,
    .can_undo = nobody,
    .can_redo = nobody,
    .lay = dish_lay,
    .field = dish_field,
    .hash = hash_of,
    .is_calm = is_calm,
    .planes = PLANES,
    .plane = dish_plane,
    .figures = dish_figures,
};
