/* Random legal actions over all verbs: whatever visitors do, the fields stay sound. */
#include <math.h>
#include <string.h>

#include "brush.h"
#include "figure.h"
#include "random.h"
#include "subject.h"

enum { SIDE = 96, TICKS = 20000, EVERY_ACTION = 40, EVERY_CHECK = 50, PATH = 6, RASTER = 12, SHOWN = 5 };

/* What crosses a link is rounded to multiples of 2^-13 (kernel.c), so that each of the eight links of a cell that is
 * nearly empty may take more than there is: by half of that, and once the painting is quiet and the band wide, more.
 * Six other seeds have come to 5 of them; nothing goes on from there. */
static const float UNDERSHOOT = 8 / 8192.0f;

struct chance {
    uint32_t seed;
    int drawn;
    struct point path[PATH];
    float values[2 * RASTER * RASTER];
};

/* Uniform in [0, 1): the same for every machine. */
static float draw(struct chance *chance)
{
    return random_unit(chance->drawn++, 0, chance->seed, RANDOM_SEED);
}

static int draw_below(struct chance *chance, int count)
{
    return (int)(draw(chance) * (float)count);
}

/* Small values are as likely as large ones: the square of a uniform number, spread over the range. */
static double draw_between(struct chance *chance, double least, double most)
{
    double t = (double)draw(chance);
    return least + (most - least) * (draw(chance) < 0.5f ? t : t * t);
}

static struct action_raster draw_raster(struct chance *chance, int channels, bool picture)
{
    float bias = draw(chance);
    for (int i = 0; i < channels * RASTER * RASTER; i++) {
        float value = draw(chance);
        chance->values[i] = channels == 2 ? 2 * value - 1 : picture ? value : value < bias ? 0.0f : 1.0f;
    }
    return (struct action_raster){.values = chance->values, .width = RASTER, .height = RASTER, .channels = channels};
}

static int count_of(const struct key *key)
{
    int count = 0;
    if (key->type == KEY_CHOICE) {
        while (key->choices[count]) {
            count++;
        }
    } else if (key->type == KEY_BRUSH) {
        while (brushes[count].name) {
            count++;
        }
    }
    if (key->type == KEY_OPTION) {
        return key_count(action_options(key));
    }
    return key->type == KEY_COEFFICIENT ? key_count(coefficient_keys) : key->type == KEY_INK ? PAINTING_INKS : count;
}

static void fill(struct chance *chance, struct action *action, const struct key *key)
{
    char *at = (char *)action + key->offset;
    if (!key->required && draw(chance) < 0.4f) {
        return; /* its default */
    }
    if (key->type == KEY_NUMBER) {
        float value = (float)draw_between(chance, key->min, key->max);
        memcpy(at, &value, sizeof value);
    } else if (key->type == KEY_FLAG) {
        bool value = draw(chance) < 0.5f;
        memcpy(at, &value, sizeof value);
    } else if (key->type == KEY_POINT) {
        struct point value = {draw(chance), draw(chance)};
        memcpy(at, &value, sizeof value);
        action->has_at = true;
    } else if (key->type == KEY_PATH) {
        struct action_path value = {chance->path, 1 + draw_below(chance, PATH)};
        for (int i = 0; i < value.count; i++) {
            chance->path[i] = (struct point){draw(chance), draw(chance)};
        }
        memcpy(at, &value, sizeof value);
    } else if (key->type == KEY_RASTER || key->type == KEY_PICTURE) {
        struct action_raster value =
            draw_raster(chance, action->verb == ACTION_GUIDE ? 2 : 1, key->type == KEY_PICTURE);
        memcpy(at, &value, sizeof value);
    } else {
        int value = draw_below(chance, count_of(key));
        memcpy(at, &value, sizeof value);
    }
}

/* Any verb; drops more often than the rest, and coefficients inside their own range. */
static struct action draw_action(struct chance *chance)
{
    int verb = draw_below(chance, ACTION_VERBS + 4);
    struct action action = action_default(verb < ACTION_VERBS ? (enum action_verb)verb : ACTION_DROP);
    if (action.verb == ACTION_CLEAR && draw(chance) < 0.7f) {
        action = action_default(ACTION_UNMASK); /* or hardly anything would grow old */
    }
    for (const struct key *key = action_keys(action.verb); key->name; key++) {
        fill(chance, &action, key);
    }
    if (action.verb == ACTION_SET) {
        const struct key *key = &coefficient_keys[action.coefficient];
        double most = key->type == KEY_CHOICE ? count_of(key) - 1 : key->max;
        bool back = draw(chance) < 0.5f; /* the default again: else the sheet is soon a desert */
        action.value = (float)(back ? key->initial : draw_between(chance, key->min, most));
        action.to = (float)(back ? key->initial : draw_between(chance, key->min, most));
        if (key->type != KEY_NUMBER) {
            action.value = floorf(action.value);
        }
    }
    return action;
}

struct unsound {
    int64_t strange, negative, high; /* not a number or infinite; below 0 by more than UNDERSHOOT; catalyst
                                           above its start */
    const char *field;               /* the first one found */
    int64_t tick;
    float value;
};

static void look(struct subject *subject, struct unsound *unsound)
{
    for (int field = 0; field < PAINTING_FIELDS; field++) {
        const float *plane = subject_read(subject, (enum painting_field)field);
        bool density = field <= PAINTING_SOLVENT || field == PAINTING_INK ||
                       (field >= PAINTING_WET && field < PAINTING_DRY + PAINTING_INKS);
        for (size_t i = 0; i < subject->cells; i++) {
            bool strange = !isfinite(plane[i]), negative = density && plane[i] < -UNDERSHOOT;
            bool high = field == PAINTING_CATALYST && plane[i] > 1.0f + 1e-6f;
            if ((strange || negative || high) && !unsound->field) {
                unsound->field = painting_field_name((enum painting_field)field);
                unsound->tick = painting_ticks(subject->painting);
                unsound->value = plane[i];
            }
            unsound->strange += strange;
            unsound->negative += negative;
            unsound->high += high;
        }
    }
}

void figure_random(struct figure *figure)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    struct chance chance = {.seed = 20200504};
    struct unsound unsound = {0};
    int64_t acted[ACTION_VERBS] = {0}, most = 0;
    struct sheet *sheet = sheet_create(figure, "Random actions over all verbs", SHOWN, 1, 2 * SIDE);
    for (int tick = 0; tick < TICKS; tick++) {
        if (tick % EVERY_ACTION == 0) {
            struct action action = draw_action(&chance);
            painting_act(subject.painting, &action);
            acted[action.verb]++;
        }
        painting_tick(subject.painting);
        if ((tick + 1) % EVERY_CHECK == 0) {
            look(&subject, &unsound);
            int64_t area = subject_area(&subject);
            most = area > most ? area : most;
        }
        if ((tick + 1) % (TICKS / SHOWN) == 0) {
            subject_show_ink(&subject, sheet, SUBJECT_LIT, "tick %d", tick + 1);
        }
    }
    sheet_finish(sheet);
    subject_finish(&subject);
    for (int verb = 0; verb < ACTION_VERBS; verb++) {
        figure_check(figure, acted[verb] >= 5, "%s done %lld times", action_name((enum action_verb)verb),
                     (long long)acted[verb]);
    }
    figure_check(figure, most > SIDE * SIDE / 3, "at most %lld of %d cells carved", (long long)most, SIDE * SIDE);
    if (unsound.field) {
        figure_note(figure, "first: %s is %g at tick %lld", unsound.field, (double)unsound.value,
                    (long long)unsound.tick);
    }
    figure_check(figure, unsound.strange == 0, "not a number or infinite: %lld", (long long)unsound.strange);
    figure_check(figure, unsound.negative == 0, "densities below 0 by more than links are rounded: %lld",
                 (long long)unsound.negative);
    figure_check(figure, unsound.high == 0, "catalyst above its start by over 1e-6: %lld", (long long)unsound.high);
}
