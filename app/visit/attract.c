#include "attract.h"

#include <math.h>
#include <stdlib.h>

#include "compose.h"
#include "vary.h"

struct attract {
    const struct exhibit *exhibit;
    struct dice dice;
    struct performance performance;
    int next;                                              /* step */
    int begun;                                             /* performances */
    int kinds[ARRANGED_KINDS], recorded[EXHIBIT_SESSIONS]; /* in turn, in an order that is shuffled anew each time */
};

static void shuffle(struct dice *dice, int *list, int count)
{
    for (int i = count - 1; i > 0; i--) {
        int other = dice_of(dice, i + 1), was = list[i];
        list[i] = list[other];
        list[other] = was;
    }
}

struct attract *attract_create(const struct exhibit *exhibit, uint64_t seed)
{
    struct attract *attract = calloc(1, sizeof *attract);
    if (!attract) {
        return NULL;
    }
    attract->exhibit = exhibit;
    attract->dice.state = seed;
    int room = COMPOSE_STEPS;
    for (int i = 0; i < exhibit->session_count; i++) {
        int count = exhibit->recorded[i] ? exhibit->recorded[i]->action_count : 0;
        room = count > room ? count : room;
        attract->recorded[i] = i;
    }
    for (int i = 0; i < ARRANGED_KINDS; i++) {
        attract->kinds[i] = i;
    }
    if (!performance_init(&attract->performance, room)) {
        free(attract);
        return NULL;
    }
    return attract;
}

void attract_destroy(struct attract *attract)
{
    if (attract) {
        performance_finish(&attract->performance);
        free(attract);
    }
}

/* The list's next, in turn. */
static int in_turn(struct attract *attract, int *list, int count, int number)
{
    if (number % count == 0) {
        int last = list[count - 1];
        shuffle(&attract->dice, list, count);
        if (number > 0 && count > 1 && list[0] == last) { /* not the same twice running */
            list[0] = list[count - 1];
            list[count - 1] = last;
        }
    }
    return list[number % count];
}

void attract_begin(struct attract *attract, int scene, float aspect)
{
    const struct exhibit *exhibit = attract->exhibit;
    const struct script *script = exhibit->scenes[scene].script;
    int number = attract->begun++;
    /* Every third is a recorded one, where there are any. */
    bool recorded = exhibit->session_count > 0 && number % 3 == 2;
    attract->next = 0;
    int rate = exhibit->sheet.rate > 0 ? exhibit->sheet.rate : STUDIO_TICKS_PER_SECOND;
    int64_t ticks = (int64_t)(exhibit->visit.attract * (float)rate);
    if (recorded) {
        const struct script *session =
            exhibit->recorded[in_turn(attract, attract->recorded, exhibit->session_count, number / 3)];
        vary(&attract->performance, session, script->ink_count, ticks, &attract->dice);
        return;
    }
    struct compose_def def = {.ink_count = script->ink_count, .ticks = ticks, .rate = rate};
    for (int i = 0; i < script->ink_count; i++) {
        def.inks[i] = script->inks[i];
    }
    def.width = sqrtf((float)exhibit->sheet.cells * aspect);
    def.height = (float)exhibit->sheet.cells / def.width;
    int generated = exhibit->session_count > 0 ? number - number / 3 : number;
    def.kind = (enum arrangement_kind)in_turn(attract, attract->kinds, ARRANGED_KINDS, generated);
    compose(&attract->performance, &def, &attract->dice);
}

bool attract_action(struct attract *attract, int64_t tick, struct action *action)
{
    const struct performance *performance = &attract->performance;
    if (attract->next == performance->count || performance->steps[attract->next].action.tick > tick) {
        return false;
    }
    *action = performance->steps[attract->next++].action;
    return true;
}

bool attract_over(const struct attract *attract, int64_t tick)
{
    return tick >= attract->performance.ticks;
}

bool attract_hand(const struct attract *attract, int64_t tick, struct point *at, float *pressed)
{
    int rate = attract->exhibit->sheet.rate > 0 ? attract->exhibit->sheet.rate : STUDIO_TICKS_PER_SECOND;
    return performance_hand(&attract->performance, attract->next, tick, rate, at, pressed);
}

uint64_t attract_fingerprint(const struct attract *attract)
{
    return performance_fingerprint(&attract->performance);
}
