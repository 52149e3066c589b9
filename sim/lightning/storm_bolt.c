/* Bolts: how they begin, grow, come, fade and are forgotten. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "storm_state.h"

enum {
    SEEDS = 4096,      /* of an outline */
    PUSHED_OUT = 45,   /* ticks */
    FLASH_GAP = 24,    /* ticks from one flash to the next: at 60 a second never more than three in any second */
    TICK_COST = 10000, /* of growth: 1000 particles in the plane, with nothing about them */
    COST_PLANE = 10,
    COST_SPACE = 40,
    CHARGES_FREE = 120, /* charges that make a particle cost twice as much */
    FEELS_EACH = 8,     /* ticks between which others are felt */
    FELT_FROM = 500,    /* particles of a bolt from which charges of visitors count as shares of it */
    SWELLS_EACH = 3,
    SHAPED_EACH = 6,   /* ticks between which radii are made anew, at least */
    LEADER_MOST = 400, /* particles a tick that a strike may grow by when its time is short */
};
static const float FLASH = 0.2f, FLICKER = 0.08f;

float storm_felt(const struct storm_bolt *bolt)
{
    return 1 + (float)bolt->count / FELT_FROM;
}

bool storm_bolt_grows(const struct storm_bolt *bolt)
{
    return bolt->lives && !bolt->complete && !bolt->leaves && bolt->undone == 0;
}

void storm_bolt_free(struct storm_bolt *bolt)
{
    laplacian_destroy(bolt->laplacian);
    free(bolt->nodes);
    free(bolt->potential);
    free(bolt->background[0]);
    free(bolt->background[1]);
    *bolt = (struct storm_bolt){0};
}

int64_t storm_particles(const struct storm *storm)
{
    int64_t sum = 0;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        sum += storm->bolts[slot].lives ? storm->bolts[slot].count : 0;
    }
    return sum;
}

static void forget(struct storm *storm, int slot)
{
    if (storm->bolts[slot].undone == 0) {
        storm_scar_keep(storm, slot);
    }
    storm_hide(storm, slot);
    storm_bolt_free(&storm->bolts[slot]);
    storm->changed++;
}

void storm_dismiss(struct storm *storm, struct storm_bolt *bolt, int ticks)
{
    bolt->leaves = true;
    bolt->gone = storm->now + ticks < bolt->gone ? storm->now + ticks : bolt->gone;
    storm->changed++;
    storm_dress(storm, (int)(bolt - storm->bolts));
}

/* The oldest that is none of those; NULL: none. */
static struct storm_bolt *oldest(struct storm *storm, bool leaving, bool undone, const struct storm_bolt *but)
{
    struct storm_bolt *found = NULL;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        struct storm_bolt *bolt = &storm->bolts[slot];
        if (bolt->lives && bolt != but && bolt->leaves == leaving && (bolt->undone > 0) == undone &&
            (!found || bolt->serial < found->serial)) {
            found = bolt;
        }
    }
    return found;
}

/* A free slot: of those that fade, else of what was taken back, the oldest gives way. */
static struct storm_bolt *make_room(struct storm *storm)
{
    int live = 0;
    struct storm_bolt *room = NULL;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        const struct storm_bolt *bolt = &storm->bolts[slot];
        live += bolt->lives && !bolt->leaves && bolt->undone == 0;
        room = !bolt->lives && !room ? &storm->bolts[slot] : room;
    }
    if (live >= STORM_BOLTS) {
        storm_dismiss(storm, oldest(storm, false, false, NULL), PUSHED_OUT);
    }
    if (!room) {
        room = oldest(storm, true, false, NULL);
        room = room ? room : oldest(storm, false, true, NULL);
        room = room ? room : oldest(storm, true, true, NULL);
        forget(storm, (int)(room - storm->bolts));
    }
    return room;
}

/* New nodes of the growth. False when memory is short. */
static bool take_nodes(struct storm_bolt *bolt)
{
    int32_t count = laplacian_count(bolt->laplacian);
    if (count > bolt->room || !bolt->nodes) {
        int32_t wide = count + count / 2 + 256;
        struct storm_node *nodes = realloc(bolt->nodes, (size_t)wide * sizeof *nodes);
        if (!nodes) {
            return false;
        }
        memset(nodes + bolt->room, 0, (size_t)(wide - bolt->room) * sizeof *nodes);
        bolt->nodes = nodes;
        bolt->room = wide;
    }
    for (int32_t i = bolt->count; i < count; i++) {
        struct laplacian_node from = laplacian_node(bolt->laplacian, i);
        int32_t parent = from.parent >= 0 ? from.parent : bolt_shape_seed_before(bolt->laplacian, i);
        const struct storm_node *before = parent >= 0 ? &bolt->nodes[parent] : NULL;
        struct storm_node *node = &bolt->nodes[i];
        *node = (struct storm_node){.left = !before || before->left > 0 ? 1 : 0, /* nothing is seen to hang on water */
                                    .radius = bolt->look.tip,
                                    .parent = parent,
                                    .heaviest = -1,
                                    .tips = 1,
                                    .segment = -1};
        memcpy(node->at, from.at, sizeof node->at);
        memcpy(node->even, from.at, sizeof node->even);
    }
    bolt->count = count;
    return true;
}

static bool lies_far(const struct storm_bolt *bolt, int32_t first)
{
    for (int32_t i = first; i < bolt->count && bolt->extent > 0; i++) {
        float squared = 0;
        for (int d = 0; d < 3; d++) {
            float by = bolt->nodes[i].at[d] - bolt->from[d];
            squared += by * by;
        }
        if (squared >= bolt->extent * bolt->extent) {
            return true;
        }
    }
    return false;
}

static void fill_bolt(const struct storm *storm, struct storm_bolt *bolt, const struct action *action,
                      const struct bolt *preset)
{
    *bolt = (struct storm_bolt){.lives = true,
                                .serial = storm->serial,
                                .visitor = action->visitor,
                                .kind = storm->def.kind,
                                .dimensions = storm->def.dimensions,
                                .look = preset->look,
                                .width = (float)storm->width,
                                .height = (float)storm->height,
                                .scale = bolt_scale(preset, storm->width),
                                .extent = preset->growth.extent,
                                .life = storm->def.life,
                                .gone = STORM_AGES,
                                .hit = -1,
                                .felt = -1,
                                .heard = -1};
    for (int i = 0; i < STORM_RESTRIKES; i++) {
        bolt->again[i] = STORM_AGES;
    }
}

/* False: there is nothing, for want of memory or of a place to begin. */
static bool begin(struct storm *storm, struct storm_bolt *bolt, const struct action *action)
{
    size_t places = (size_t)storm->columns * (size_t)storm->rows;
    struct bolt *preset = malloc(sizeof *preset);
    struct laplacian_seed *seeds = malloc(SEEDS * sizeof *seeds);
    bool good = false;
    if (preset && seeds) {
        bolt_preset(preset, (enum bolt_kind)storm->def.kind, storm->width, storm->height);
        fill_bolt(storm, bolt, action, preset);
        good = storm_place(storm, action, bolt, preset, seeds, SEEDS);
    }
    if (good) {
        struct laplacian_def *growth = &preset->growth;
        enum laplacian_status status;
        growth->dimensions = bolt->dimensions;
        growth->eta = storm->def.eta;
        growth->eta_end = -1;
        growth->extent = 0; /* from where it begins: looked after here */
        bolt->limit = storm->def.particles < storm->most ? storm->def.particles : (int)storm->most;
        growth->particles = bolt->limit;
        growth->seed = (int)(random_bits((int)storm->bolts_begun, 0, (uint32_t)storm->def.seed, RANDOM_PLACE) >> 1);
        growth->mask = (struct action_raster){storm->mask, storm->mask_columns, storm->mask_rows, 1};
        growth->charges = bolt->pulls;
        growth->charge_count = bolt->pull_count;
        bolt->laplacian = laplacian_create(growth, &status);
        bolt->potential = calloc(places, sizeof(float));
        bolt->background[0] = calloc(places, sizeof(float));
        bolt->background[1] = calloc(places, sizeof(float));
        good = bolt->laplacian && bolt->potential && bolt->background[0] && bolt->background[1] && take_nodes(bolt);
        storm->failed = storm->failed || (!good && (bolt->laplacian || status == LAPLACIAN_NO_MEMORY));
    }
    free(preset);
    free(seeds);
    return good;
}

void storm_strike(struct storm *storm, const struct action *action)
{
    storm_forget_undone(storm, action->visitor);
    struct storm_bolt *bolt = make_room(storm);
    int slot = (int)(bolt - storm->bolts);
    storm->serial++;
    storm->bolts_begun++;
    if (!begin(storm, bolt, action)) {
        storm_bolt_free(bolt);
        return;
    }
    storm_pull(storm, bolt);
    storm_shape(storm, bolt);
    storm->failed = !storm_show(storm, slot, 0) || storm->failed;
}

static bool may_flash(const struct storm *storm)
{
    return storm->flash == 0 || storm->now - storm->flashed >= FLASH_GAP;
}

static void flash(struct storm *storm, float how)
{
    storm->flash = how;
    storm->flashed = storm->now;
}

/* The channel is bright, what branches off it is less, and all has its time. */
static void strike_home(struct storm *storm, struct storm_bolt *bolt)
{
    for (int32_t i = bolt->hit; i >= 0; i = bolt->nodes[i].parent) {
        bolt->nodes[i].channel = true;
    }
    if (may_flash(storm)) {
        flash(storm, FLASH);
    } else {
        bolt->dim = storm->def.thickness > STORM_BROAD;
    }
    uint32_t chance = random_bits((int)bolt->serial, 1, (uint32_t)storm->def.seed, RANDOM_PLACE);
    int64_t at = storm->now;
    bolt->agains = bolt->life > 0 ? 2 + (int)(chance & 1) : 0;
    for (int i = 0; i < bolt->agains; i++) {
        at += FLASH_GAP + (int64_t)(chance >> (4 * i + 1) & 15);
        bolt->again[i] = at;
    }
}

static void finish(struct storm *storm, struct storm_bolt *bolt)
{
    bool hit = laplacian_status(bolt->laplacian) == LAPLACIAN_HIT;
    bolt->complete = true;
    bolt->struck = storm->now;
    laplacian_destroy(bolt->laplacian);
    bolt->laplacian = NULL;
    bolt->swells = bolt->aims || bolt->count >= bolt->limit ? storm->now : storm->now + STORM_SWELL;
    if (hit && bolt->aims) {
        bolt->hit = bolt->count - 1;
        strike_home(storm, bolt);
    }
    if (bolt->life > 0) {
        float last =
            bolt->agains > 0 ? (float)(bolt->again[bolt->agains - 1] - storm->now) + STORM_ECHO * bolt->life : 0;
        bolt->gone = storm->now + 1 + (int64_t)(last > bolt->life ? last : bolt->life);
    }
    storm_deposit(storm, bolt);
}

static int cost_of(const struct storm *storm, const struct storm_bolt *bolt)
{
    int charges = bolt->pull_count, cost = bolt->dimensions == 3 ? COST_SPACE : COST_PLANE;
    for (int i = 0; i < STORM_HANDS; i++) {
        charges += storm->hands[i].lies;
    }
    return cost + cost * charges / CHARGES_FREE;
}

static bool has_grown(const struct storm_bolt *bolt, int32_t since)
{
    return bolt->count > since + since / 10 + 20;
}

static bool is_touched(const struct storm *storm)
{
    for (int i = 0; i < STORM_HANDS; i++) {
        if (storm->hands[i].lies) {
            return true;
        }
    }
    return false;
}

static bool is_painted(const struct storm *storm)
{
    for (int i = 0; i < STORM_STROKES; i++) {
        if (storm->strokes[i].lives && storm->strokes[i].undone == 0) {
            return true;
        }
    }
    return false;
}

/* What is around has changed: heard at once while that is quick, else now and then. */
static void listen(struct storm *storm, struct storm_bolt *bolt)
{
    int64_t candidates = laplacian_candidates(bolt->laplacian), each = 1 + candidates * (bolt->pull_count + 4) / 60000;
    int slot = (int)(bolt - storm->bolts);
    bool heard = bolt->heard == storm->hands_changed && !(has_grown(bolt, bolt->charged_count) && is_touched(storm));
    bool felt = bolt->felt == storm->changed && !(has_grown(bolt, bolt->felt_count) && is_painted(storm));
    if ((bolt->aims || !heard) && storm->now - bolt->charged >= each) {
        storm_pull(storm, bolt);
    }
    if (!felt && (bolt->felt < 0 || (storm->now + slot) % FEELS_EACH == 0)) {
        storm_feel(storm, bolt);
    }
}

static void step(struct storm *storm, struct storm_bolt *bolt, int most)
{
    int slot = (int)(bolt - storm->bolts);
    int32_t first = bolt->count;
    listen(storm, bolt);
    float pace = bolt->aims && storm->def.pace > LEADER_MOST ? LEADER_MOST : storm->def.pace;
    bolt->due = fminf(bolt->due + pace, pace + 1);
    int wanted = (int)bolt->due;
    wanted = wanted < most ? wanted : most;
    bolt->due -= (float)wanted;
    (void)laplacian_step(bolt->laplacian, wanted);
    bool good = take_nodes(bolt);
    enum laplacian_status status = laplacian_status(bolt->laplacian);
    storm->failed = storm->failed || !good || status == LAPLACIAN_NO_MEMORY;
    if (status != LAPLACIAN_GROWING || lies_far(bolt, first)) {
        finish(storm, bolt);
    }
    storm->failed = !storm_show(storm, slot, first) || storm->failed;
    bool pause = storm->now - bolt->shaped < SHAPED_EACH + bolt->count / 8000;
    if (bolt->complete || !pause) {
        storm_shape(storm, bolt);
        storm_dress(storm, slot);
    }
    if ((storm->now + slot) % FEELS_EACH == 0) {
        storm_deposit(storm, bolt);
    }
}

/* Particles that all may have more, once what is old and at rest has been asked to go. */
static int64_t room_for_particles(struct storm *storm, int wanted)
{
    int64_t free = storm->most - storm_particles(storm);
    if (free >= wanted) {
        return free;
    }
    struct storm_bolt *gives = oldest(storm, false, true, NULL);
    if (gives) {
        forget(storm, (int)(gives - storm->bolts));
    } else if (!oldest(storm, true, false, NULL)) { /* none is on its way out yet */
        struct storm_bolt *newest = NULL;
        for (int slot = 0; slot < STORM_SLOTS; slot++) {
            struct storm_bolt *bolt = &storm->bolts[slot];
            newest = bolt->lives && (!newest || bolt->serial > newest->serial) ? bolt : newest;
        }
        gives = oldest(storm, false, false, newest);
        if (gives) {
            storm_dismiss(storm, gives, PUSHED_OUT);
        }
    }
    free = storm->most - storm_particles(storm);
    return free > 0 ? free : 0;
}

static void grow_all(struct storm *storm)
{
    int growing = 0, left = TICK_COST;
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        growing += storm_bolt_grows(&storm->bolts[slot]);
    }
    int64_t room = growing > 0 ? room_for_particles(storm, TICK_COST / COST_PLANE) : 0;
    for (int slot = 0; slot < STORM_SLOTS && growing > 0; slot++) {
        struct storm_bolt *bolt = &storm->bolts[slot];
        if (storm_bolt_grows(bolt)) {
            int cost = cost_of(storm, bolt), most = left / growing / cost;
            int32_t before = bolt->count;
            step(storm, bolt, most < room ? most : (int)room);
            room -= bolt->count - before;
            left -= (bolt->count - before) * cost;
            growing--;
        }
    }
}

static void age(struct storm *storm, int slot)
{
    struct storm_bolt *bolt = &storm->bolts[slot];
    if (bolt->gone <= storm->now) {
        if (bolt->undone > 0 && !bolt->leaves) {
            storm_hide(storm, slot); /* it may come back */
            bolt->gone = STORM_AGES;
            return;
        }
        forget(storm, slot);
        return;
    }
    if (bolt->complete && storm->now <= bolt->swells && (bolt->swells - storm->now) % SWELLS_EACH == 0) {
        storm_shape(storm, bolt);
        storm_dress(storm, slot);
    }
    for (int i = 0; i < bolt->agains; i++) {
        if (bolt->again[i] == storm->now && bolt->undone == 0 && !bolt->leaves) {
            bool may = may_flash(storm);
            if (may || !(storm->def.thickness > STORM_BROAD)) {
                storm->failed = !storm_show_again(storm, slot) || storm->failed;
            }
            if (may) {
                flash(storm, FLICKER);
            }
        }
    }
}

void storm_grow(struct storm *storm)
{
    if (storm->strokes_changed) {
        storm_strokes_sum(storm);
    }
    for (int slot = 0; slot < STORM_SLOTS; slot++) {
        if (storm->bolts[slot].lives) {
            age(storm, slot);
        }
    }
    grow_all(storm);
}
