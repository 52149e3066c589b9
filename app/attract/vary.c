#include "vary.h"

#include <math.h>
#include <stddef.h>

enum { PIECE = STUDIO_PATH - 1 }; /* segments of a piece of a path */

struct variation {
    bool mirror_x, mirror_y;
    float shift_x, shift_y; /* of the sheet */
    float larger;           /* lengths are multiplied by it, amounts by its square */
    float slower;           /* ticks are multiplied by it */
    int turn, inks;
};

static int pieces_of(const struct action *action)
{
    int segments = action->path.count - 1;
    return segments > PIECE ? (segments + PIECE - 1) / PIECE : 1;
}

int vary_steps(const struct script *session)
{
    int steps = 0;
    for (int i = 0; i < session->action_count; i++) {
        steps += pieces_of(&session->actions[i]);
    }
    return steps;
}

static float unit(float value)
{
    return fminf(fmaxf(value, 0.0f), 1.0f);
}

static struct point varied(const struct variation *variation, struct point at)
{
    float x = variation->mirror_x ? 1 - at.x : at.x, y = variation->mirror_y ? 1 - at.y : at.y;
    return (struct point){unit(x + variation->shift_x), unit(y + variation->shift_y)};
}

static bool has_raster(const struct script *session)
{
    for (int i = 0; i < session->action_count; i++) {
        if (session->actions[i].formula.values || session->actions[i].picture.values) {
            return true;
        }
    }
    return false;
}

static struct variation choose(const struct script *session, const struct vary_def *def, struct dice *dice)
{
    struct variation variation = {.inks = def->inks, .larger = 1};
    if (!has_raster(session)) {
        variation.mirror_x = dice_chance(dice, 0.5f);
        variation.mirror_y = dice_chance(dice, 0.5f);
        variation.shift_x = dice_between(dice, -0.03f, 0.03f);
        variation.shift_y = dice_between(dice, -0.03f, 0.03f);
    }
    if (session->width > 0 && session->height > 0) {
        variation.larger = sqrtf((float)def->cells / ((float)session->width * (float)session->height));
    }
    variation.turn = dice_of(dice, def->inks);
    /* Fronts come on as fast on every sheet: the way is longer on a larger one. */
    float most = session->ticks > 0 ? (float)def->ticks / (float)session->ticks : variation.larger;
    float least = 0.9f * variation.larger, longest = fminf(fmaxf(most, least), 1.35f * variation.larger);
    variation.slower = dice_between(dice, least, longest);
    return variation;
}

static void resize(struct action *action, const struct variation *variation)
{
    float larger = variation->larger, area = larger * larger;
    if (action->verb == ACTION_DROP) { /* the drop stays, what it grows to does not */
        action->reach *= larger;
        action->solvent *= area;
        action->amount *= area;
    } else {
        action->radius *= larger;
        action->size *= larger;
    }
    *action = action_legal(action);
}

/* A step for each piece of its path, one movement of the hand together. */
static void add(struct performance *performance, const struct action *action, const struct variation *variation)
{
    int gesture = performance->count, pieces = pieces_of(action);
    for (int i = 0; i < pieces; i++) {
        struct action piece = *action;
        struct point points[STUDIO_PATH];
        int left = action->path.count - i * PIECE, count = left < STUDIO_PATH ? left : STUDIO_PATH;
        for (int j = 0; j < count; j++) {
            points[j] = varied(variation, action->path.points[i * PIECE + j]);
        }
        piece.path = (struct action_path){points, count};
        int press = count > 1 ? 4 * count : 8;
        piece.tick += (int64_t)i * 4 * STUDIO_PATH;
        struct performance_step *step = performance_add(performance, &piece, piece.has_at || count > 0 ? press : -1);
        if (step) {
            step->gesture = gesture;
        }
    }
}

void vary(struct performance *performance, const struct script *session, const struct vary_def *def, struct dice *dice)
{
    struct variation variation = choose(session, def, dice);
    performance_clear(performance, def->ticks);
    for (int i = 0; i < session->action_count; i++) {
        struct action action = session->actions[i];
        if (action.verb == ACTION_CLEAR) { /* a sheet is one session */
            continue;
        }
        action.at = action.has_at ? varied(&variation, action.at) : action.at;
        action.ink = (action.ink + variation.turn) % variation.inks;
        action.tick = (int64_t)((float)action.tick * variation.slower);
        resize(&action, &variation);
        add(performance, &action, &variation);
    }
    performance_space(performance, def->rate / 3);
    performance_sort(performance);
    int64_t last = performance->count > 0 ? performance->steps[performance->count - 1].action.tick : 0;
    int64_t whole = (int64_t)((float)session->ticks * variation.slower);
    whole = whole < last + 4 * (int64_t)def->rate ? last + 4 * (int64_t)def->rate : whole;
    performance->ticks = whole < def->ticks ? whole : def->ticks;
}
