#include "attract.h"

#include <math.h>
#include <stdlib.h>

#include "compose.h"
#include "compose_dish.h"
#include "compose_garden.h"
#include "compose_storm.h"
#include "vary.h"

enum { EVERY = 3 }; /* every third is a recorded one, where there are any */

_Static_assert((int)COMPOSE_STORM_STEPS <= (int)COMPOSE_STEPS && (int)COMPOSE_DISH_STEPS <= (int)COMPOSE_STEPS,
               "there is room for all of them");

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
        int count = exhibit->recorded[i] ? vary_steps(exhibit->recorded[i]) : 0;
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

static int rate_of(const struct attract *attract)
{
    int rate = attract->exhibit->sheet.rate;
    return rate > 0 ? rate : STUDIO_TICKS_PER_SECOND;
}

static void begin_generated(struct attract *attract, const struct script *scene, float aspect, int number)
{
    const struct exhibit *exhibit = attract->exhibit;
    struct compose_def def = {.ink_count = scene->ink_count, .rate = rate_of(attract)};
    for (int i = 0; i < scene->ink_count; i++) {
        def.inks[i] = scene->inks[i];
    }
    def.ticks = (int64_t)(exhibit->visit.attract * (float)def.rate);
    def.width = sqrtf((float)exhibit->sheet.cells * aspect);
    def.height = (float)exhibit->sheet.cells / def.width;
    def.kind = (enum arrangement_kind)in_turn(attract, attract->kinds, ARRANGED_KINDS, number);
    compose(&attract->performance, &def, &attract->dice);
}

static void begin_garden(struct attract *attract, const struct exhibit_scene *scene, float width, float height)
{
    struct compose_garden_def def = {.width = width, .height = height, .rate = rate_of(attract)};
    (void)scene;
    def.ticks = (int64_t)(attract->exhibit->visit.attract * (float)def.rate);
    compose_garden(&attract->performance, &def, &attract->dice);
}

static void begin_storm(struct attract *attract, const struct exhibit_scene *scene, float width, float height)
{
    struct compose_storm_def def = {.rate = rate_of(attract), .options = &scene->options};
    (void)width, (void)height;
    def.ticks = (int64_t)(attract->exhibit->visit.attract * (float)def.rate);
    compose_storm(&attract->performance, &def, &attract->dice);
}

static void begin_dish(struct attract *attract, const struct exhibit_scene *scene, float width, float height)
{
    struct compose_dish_def def = {
        .width = width, .height = height, .rate = rate_of(attract), .options = &scene->options};
    def.ticks = (int64_t)(attract->exhibit->visit.attract * (float)def.rate);
    compose_dish(&attract->performance, &def, &attract->dice);
}

static bool begin_recorded(struct attract *attract, const struct script *scene, int number)
{
    const struct exhibit *exhibit = attract->exhibit;
    const struct script *session =
        exhibit->recorded[in_turn(attract, attract->recorded, exhibit->session_count, number)];
    if (session) {
        struct vary_def def = {.inks = scene->ink_count, .cells = exhibit->sheet.cells, .rate = rate_of(attract)};
        def.ticks = (int64_t)(exhibit->visit.attract * (float)def.rate);
        vary(&attract->performance, session, &def, &attract->dice);
    }
    return session;
}

void attract_begin(struct attract *attract, int scene, float aspect)
{
    const struct exhibit *exhibit = attract->exhibit;
    const struct script *script = exhibit->scenes[scene].script;
    static void (*const BEGIN[SCENE_KINDS])(struct attract *, const struct exhibit_scene *, float, float) = {
        [SCENE_TREES] = begin_garden, [SCENE_LIGHTNING] = begin_storm, [SCENE_CHEMISTRY] = begin_dish};
    attract->next = 0;
    if (exhibit->scenes[scene].kind != SCENE_PAINTING) {
        float width = sqrtf((float)exhibit->sheet.cells * aspect);
        if (BEGIN[exhibit->scenes[scene].kind]) {
            BEGIN[exhibit->scenes[scene].kind](attract, &exhibit->scenes[scene], width,
                                               (float)exhibit->sheet.cells / width);
        } else { /* what its opening has begun */
            performance_clear(&attract->performance, (int64_t)(exhibit->visit.attract * (float)rate_of(attract)));
        }
        return;
    }
    int number = attract->begun++, recorded = exhibit->session_count > 0 ? number / EVERY : 0;
    if (exhibit->session_count == 0 || number % EVERY != EVERY - 1 || !begin_recorded(attract, script, recorded)) {
        begin_generated(attract, script, aspect, number - recorded);
    }
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
    return performance_hand(&attract->performance, attract->next, tick, rate_of(attract), at, pressed);
}

uint64_t attract_fingerprint(const struct attract *attract)
{
    return performance_fingerprint(&attract->performance);
}
