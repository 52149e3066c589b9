#include "vary.h"

#include <math.h>
#include <stddef.h>

struct variation {
    bool mirror_x, mirror_y;
    float shift_x, shift_y; /* of the sheet */
    float slower;           /* ticks are multiplied by it */
    int turn, inks;
};

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

/* How far the outermost places may go. */
static struct variation choose(const struct script *session, int inks, int64_t ticks, struct dice *dice)
{
    struct variation variation = {.inks = inks, .slower = 1};
    if (!has_raster(session)) { /* fields and masks stay where they are, and so does what is painted on them */
        variation.mirror_x = dice_chance(dice, 0.5f);
        variation.mirror_y = dice_chance(dice, 0.5f);
        variation.shift_x = dice_between(dice, -0.03f, 0.03f);
        variation.shift_y = dice_between(dice, -0.03f, 0.03f);
    }
    variation.turn = dice_of(dice, inks);
    float most = session->ticks > 0 ? (float)ticks / (float)session->ticks : 1;
    variation.slower = dice_between(dice, 0.9f, fminf(fmaxf(most, 1.0f), 1.35f));
    return variation;
}

void vary(struct performance *performance, const struct script *session, int inks, int64_t ticks, struct dice *dice)
{
    struct variation variation = choose(session, inks, ticks, dice);
    int64_t whole = (int64_t)((float)session->ticks * variation.slower);
    performance_clear(performance, whole < ticks ? whole : ticks);
    for (int i = 0; i < session->action_count; i++) {
        struct action action = session->actions[i];
        struct point points[STUDIO_PATH];
        int count = action.path.count < STUDIO_PATH ? action.path.count : STUDIO_PATH;
        for (int j = 0; j < count; j++) {
            int from = count > 1 ? (int)((int64_t)j * (action.path.count - 1) / (count - 1)) : 0;
            points[j] = varied(&variation, action.path.points[from]);
        }
        action.path = (struct action_path){points, count};
        action.at = action.has_at ? varied(&variation, action.at) : action.at;
        action.ink = (action.ink + variation.turn) % variation.inks;
        action.tick = (int64_t)((float)action.tick * variation.slower);
        if (action.verb == ACTION_CLEAR || action.tick >= performance->ticks) {
            continue;
        }
        performance_add(performance, &action, action.has_at || count > 0 ? 12 : -1);
    }
    performance_sort(performance);
}
