#include "governor.h"

#include <math.h>
#include <stdio.h>

/* What a reason may say is within a frame of these. */
static const float SPARE = 1.1f;        /* of the frame time that noise may take */
static const float REACHED = .9f;       /* of the ticks wanted: fewer is overload */
static const float CALM_REACHED = .97f; /* fewer is no calm */
static const float GAP_S = .5f;         /* one frame counts for no more: a spike is no overload */
static const float SETTLE_S = 1;        /* after a change: until figures that are means of a second speak of it */
static const float STALL = 4;     /* frame times in one: the ticks of the next second tell of it, not of the load */
static const float PAUSE_S = 5;   /* between two samples: the machine slept, or nobody looked */
static const float TRIAL_S = 600; /* a level that was raised has held after so long: heat takes minutes */
static const float PATIENCE = 4;  /* times longer is waited after a level that did not hold */

struct governor_def governor_default_def(void)
{
    return (struct governor_def){
        .frame_ms = 1000.0f / 30,
        .warm_up_s = 3,
        .over_s = 1.4f,
        .calm_s = 60,
        .calm_most_s = 1800,
        .warm_c = 75,
        .hot_c = 78,
        .cool_c = 70,
        .warm_s = 45,
        .hot_s = 15,
        .load_most = .8f,
        .fluid_cost = 8,
        .fluid_least = 2,
        .scales = {.75f, .5f},
    };
}

void governor_admit_brush(struct governor_def *def, const struct brush *brush)
{
    def->alpha_y_most = fmaxf(def->alpha_y_most, brush->alpha_y);
    def->beta_a_most = fmaxf(def->beta_a_most, brush->beta_a * (1 + brush->reaction_noise));
}

/* The longest time step with which the pattern stays as it is: .2 is within 4 % of .1 as measured, with the front
 * stable for every alpha_a; explicit diffusion and consumption of the catalyst are stable for dt (8 alpha_y + beta_y) <
 * 2 with five points, of which a tenth is kept clear; growth is still followed at beta_a dt <= 1. */
static float longest_step(const struct governor_def *def, const struct coefficients *c)
{
    float longest = .2f;
    longest = fminf(longest, 1.8f / (8 * fmaxf(c->alpha_y, def->alpha_y_most) + c->beta_y));
    return fminf(longest, 1 / fmaxf(fmaxf(c->beta_a, def->beta_a_most), 1));
}

/* Steps that cover the same time with the longest step; worth it where a quarter is saved, else as many as before. */
static int fewer_steps(const struct governor_def *def, const struct coefficients *c)
{
    float time = (float)c->pattern_steps * c->dt;
    int steps = (int)ceilf(time / longest_step(def, c) - 1e-3f);
    steps = steps < 1 ? 1 : steps;
    return 4 * steps <= 3 * c->pattern_steps ? steps : c->pattern_steps;
}

static void add_level(struct governor *governor, const struct coefficients *c, struct governor_level level)
{
    float whole = governor->def.fluid_cost * (float)c->fluid_steps + (float)c->pattern_steps;
    level.cost = governor->def.fluid_cost * (float)level.fluid_steps + (float)level.pattern_steps;
    level.cost *= level.scale * level.scale / whole;
    governor->levels[governor->count++] = level;
}

void governor_rebase(struct governor *governor, const struct coefficients *c)
{
    struct governor_level level = {c->fluid_steps, c->pattern_steps, c->dt, 1, 1};
    int steps = fewer_steps(&governor->def, c);
    governor->count = 0;
    add_level(governor, c, level);
    while (level.fluid_steps > governor->def.fluid_least && governor->count < GOVERNOR_LEVELS - 3) {
        level.fluid_steps--;
        add_level(governor, c, level);
    }
    if (steps < level.pattern_steps) {
        level.dt *= (float)level.pattern_steps / (float)steps;
        level.pattern_steps = steps;
        add_level(governor, c, level);
    }
    for (int i = 0; i < 2; i++) {
        if (governor->def.scales[i] > 0) {
            level.scale = governor->def.scales[i];
            add_level(governor, c, level);
        }
    }
    if (governor->wanted >= governor->count) {
        governor->wanted = governor->count - 1;
    }
}

struct governor governor_start(const struct governor_def *def, const struct coefficients *coefficients)
{
    struct governor governor = {.def = *def, .last_us = -1, .warm_up = def->warm_up_s, .calm_s = def->calm_s};
    governor_rebase(&governor, coefficients);
    return governor;
}

struct governor_level governor_level(const struct governor *governor)
{
    return governor->levels[governor->wanted];
}

/* "solvent steps 4 -> 3", whatever differs between two levels. */
static void describe(const struct governor_level *from, const struct governor_level *to, char *text, size_t size)
{
    if (from->fluid_steps != to->fluid_steps) {
        snprintf(text, size, "solvent steps %d -> %d", from->fluid_steps, to->fluid_steps);
    } else if (from->pattern_steps != to->pattern_steps) {
        snprintf(text, size, "pattern %d x %.3g -> %d x %.3g", from->pattern_steps, (double)from->dt, to->pattern_steps,
                 (double)to->dt);
    } else {
        snprintf(text, size, "grid %.3g -> %.3g", (double)from->scale, (double)to->scale);
    }
}

static const char *change(struct governor *governor, int by, const char *reason)
{
    char what[80];
    describe(&governor->levels[governor->wanted], &governor->levels[governor->wanted + by], what, sizeof what);
    snprintf(governor->line, sizeof governor->line, "%s: %s", reason, what);
    governor->wanted += by;
    governor->over = governor->heat = governor->calm = governor->held = 0;
    governor->raised = governor->on_trial = by < 0;
    governor->bottom = false;
    governor->warm_up = SETTLE_S;
    return governor->line;
}

static const char *lower(struct governor *governor, const char *reason)
{
    if (governor->wanted + 1 < governor->count) {
        if (governor->on_trial) {
            governor->calm_s = fminf(governor->calm_s * PATIENCE, governor->def.calm_most_s);
        }
        return change(governor, 1, reason);
    }
    governor->over = governor->heat = 0;
    if (governor->bottom) {
        return NULL;
    }
    governor->bottom = true;
    snprintf(governor->line, sizeof governor->line, "%s: nothing is left to lower", reason);
    return governor->line;
}

static bool slow_frame(const struct governor *governor, const struct governor_sample *sample)
{
    return sample->frame_ms > governor->def.frame_ms * SPARE;
}

static bool few_ticks(const struct governor *governor, const struct governor_sample *sample, float share)
{
    return governor->stale <= 0 && sample->ticks_wanted > 0 && sample->ticks_per_second < share * sample->ticks_wanted;
}

/* Overload grows with the time that is over and shrinks twice as fast, so that it takes more than two frames of three.
 */
static const char *attend_load(struct governor *governor, const struct governor_sample *sample, float passed)
{
    char reason[100];
    bool slow = slow_frame(governor, sample);
    governor->stale = sample->frame_ms > STALL * governor->def.frame_ms ? SETTLE_S : governor->stale - passed;
    if (!slow && !few_ticks(governor, sample, REACHED)) {
        governor->over = fmaxf(governor->over - 2 * passed, 0);
        return NULL;
    }
    governor->over += passed;
    if (governor->over < governor->def.over_s) {
        return NULL;
    }
    if (slow) {
        snprintf(reason, sizeof reason, "frame %.0f ms over %.0f for %.1f s", (double)sample->frame_ms,
                 (double)governor->def.frame_ms, (double)governor->over);
    } else {
        snprintf(reason, sizeof reason, "%.0f ticks a second of %.0f for %.1f s", (double)sample->ticks_per_second,
                 (double)sample->ticks_wanted, (double)governor->over);
    }
    return lower(governor, reason);
}

static const char *attend_heat(struct governor *governor, const struct governor_sample *sample, float passed)
{
    const struct governor_def *def = &governor->def;
    char reason[100];
    bool hot = sample->celsius >= def->hot_c || sample->throttled;
    if (!hot && !(sample->celsius >= def->warm_c)) { /* NAN is not warm */
        governor->heat = fmaxf(governor->heat - passed, 0);
        return NULL;
    }
    governor->heat += passed;
    float patience = hot ? def->hot_s : def->warm_s;
    if (governor->heat < patience) {
        return NULL;
    }
    if (sample->celsius >= def->warm_c) {
        snprintf(reason, sizeof reason, "%.1f C over %.0f for %.0f s", (double)sample->celsius,
                 (double)(sample->celsius >= def->hot_c ? def->hot_c : def->warm_c), (double)governor->heat);
    } else {
        snprintf(reason, sizeof reason, "the board throttles for %.0f s", (double)governor->heat);
    }
    return lower(governor, reason);
}

/* Share of its time that a tick takes at the level above, as far as can be told. */
static float load_above(const struct governor *governor, const struct governor_sample *sample)
{
    const struct governor_level *now = &governor->levels[governor->wanted], *above = now - 1;
    return sample->tick_ms / 1000 * sample->ticks_wanted * above->cost / now->cost;
}

static const char *attend_calm(struct governor *governor, const struct governor_sample *sample, float passed)
{
    const struct governor_def *def = &governor->def;
    char reason[100];
    if (governor->wanted == 0) {
        return NULL;
    }
    float load = load_above(governor, sample);
    bool calm = sample->ticks_wanted > 0 && governor->over == 0 && !slow_frame(governor, sample) &&
                !few_ticks(governor, sample, CALM_REACHED) && load <= def->load_most && !sample->throttled &&
                !(sample->celsius >= def->cool_c);
    governor->calm = fmaxf(governor->calm + (calm ? passed : -5 * passed), 0);
    if (!calm || governor->calm < governor->calm_s) {
        return NULL;
    }
    snprintf(reason, sizeof reason, "calm for %.0f s, %.0f %% of the time of a tick expected", (double)governor->calm,
             (double)(100 * load));
    return change(governor, -1, reason);
}

/* A level that has held long enough after it was raised gives back the patience that those before it took. */
static void attend_trial(struct governor *governor, float passed)
{
    governor->held += passed;
    if (!governor->raised || governor->held < fmaxf(TRIAL_S, 2 * governor->calm_s)) {
        return;
    }
    governor->held = 0;
    governor->on_trial = false;
    governor->calm_s = fmaxf(governor->calm_s / PATIENCE, governor->def.calm_s);
}

const char *governor_step(struct governor *governor, const struct governor_sample *sample)
{
    float passed = governor->last_us < 0 ? 0 : (float)(sample->now_us - governor->last_us) / 1e6f;
    governor->last_us = sample->now_us;
    if (passed > PAUSE_S) {
        governor->over = governor->heat = governor->calm = 0;
        governor->warm_up = governor->def.warm_up_s;
        return NULL;
    }
    if (sample->applied != governor->wanted) {
        return NULL;
    }
    if (governor->warm_up > 0) {
        governor->warm_up -= passed;
        return NULL;
    }
    float counted = fminf(passed, GAP_S);
    const char *line = attend_load(governor, sample, counted);
    line = line ? line : attend_heat(governor, sample, counted);
    line = line ? line : attend_calm(governor, sample, counted);
    attend_trial(governor, counted);
    return line;
}
