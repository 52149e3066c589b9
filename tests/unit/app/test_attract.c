/* Attract: what it does to the sheet, without a painting. What is to be seen of it is in the figures. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include <math.h>

#include "attract.h"
#include "brush.h"
#include "ink.h"
#include "near.h"
#include "studio.h"

enum { SCENES = 3, RATE = 60, STEPS = 400 };

struct stage {
    struct exhibit exhibit;
    struct script scenes[SCENES], recorded;
    struct action actions[4];
    struct point path[20];
};

/* Three scenes of four, two inks and one; no recorded session, unless told. */
static struct stage *a_stage(float seconds, int cells)
{
    static const char *const inked[SCENES][PAINTING_INKS] = {
        {"turquoise", "quinacridone", "ochre", "hansa"}, {"carbon black", "cobalt blue"}, {"carbon black"}};
    struct stage *stage = calloc(1, sizeof *stage);
    assert_non_null(stage);
    stage->exhibit = (struct exhibit){.sheet = {.cells = cells, .rate = RATE}, .scene_count = SCENES};
    stage->exhibit.visit.attract = seconds;
    for (int i = 0; i < SCENES; i++) {
        while (stage->scenes[i].ink_count < PAINTING_INKS && inked[i][stage->scenes[i].ink_count]) {
            int ink = stage->scenes[i].ink_count++;
            stage->scenes[i].inks[ink] = ink_find(inked[i][ink]);
        }
        stage->exhibit.scenes[i].script = &stage->scenes[i];
    }
    return stage;
}

/* A recorded one: a drop, a stroke of twenty points, a wiped sheet, and a drop that comes late. */
static void record(struct stage *stage)
{
    for (int i = 0; i < 20; i++) {
        stage->path[i] = (struct point){0.2f + 0.02f * (float)i, 0.3f};
    }
    stage->actions[0] = action_default(ACTION_DROP);
    stage->actions[0].at = (struct point){0.2f, 0.3f};
    stage->actions[0].has_at = true;
    stage->actions[1] = action_default(ACTION_BRUSH_INK);
    stage->actions[1].tick = 300;
    stage->actions[1].ink = 1;
    stage->actions[1].path = (struct action_path){stage->path, 20};
    stage->actions[2] = action_default(ACTION_CLEAR);
    stage->actions[2].tick = 400;
    stage->actions[3] = stage->actions[0];
    stage->actions[3].tick = 900;
    stage->recorded = (struct script){
        .width = 400, .height = 250, .ticks = 1000, .ink_count = 2, .actions = stage->actions, .action_count = 4};
    stage->exhibit.recorded[0] = &stage->recorded;
    stage->exhibit.session_count = 1;
}

struct played {
    struct action actions[STEPS];
    struct point points[STEPS][STUDIO_PATH];
    int count;
    int64_t ticks;
};

/* Tick by tick, as a kiosk does. */
static void play(struct attract *attract, int scene, float aspect, struct played *played)
{
    played->count = 0;
    attract_begin(attract, scene, aspect);
    int64_t tick = 0;
    for (; !attract_over(attract, tick); tick++) {
        struct action *action = &played->actions[played->count];
        while (attract_action(attract, tick, action)) {
            assert_true(action->tick <= tick && action->tick > tick - 1);
            assert_in_range(action->path.count, 0, STUDIO_PATH);
            for (int i = 0; i < action->path.count; i++) {
                played->points[played->count][i] = action->path.points[i];
            }
            assert_true(played->count < STEPS - 1);
            action = &played->actions[++played->count];
        }
    }
    struct action late;
    assert_false(attract_action(attract, INT64_MAX, &late)); /* nothing comes when it is over */
    played->ticks = tick;
}

static bool on_sheet(struct point at)
{
    return at.x >= 0 && at.x <= 1 && at.y >= 0 && at.y <= 1;
}

/* Nothing that a script would not be allowed. */
static void check_legal(const struct played *played, int ink_count)
{
    for (int i = 0; i < played->count; i++) {
        const struct action *action = &played->actions[i];
        struct action legal = action_legal(action);
        assert_memory_equal(&legal.radius, &action->radius, sizeof legal.radius);
        assert_memory_equal(&legal.solvent, &action->solvent, sizeof legal.solvent);
        assert_memory_equal(&legal.amount, &action->amount, sizeof legal.amount);
        assert_memory_equal(&legal.reach, &action->reach, sizeof legal.reach);
        assert_memory_equal(&legal.strength, &action->strength, sizeof legal.strength);
        assert_int_equal(legal.brush, action->brush);
        assert_in_range(action->ink, 0, ink_count - 1);
        assert_true(!action->has_at || on_sheet(action->at));
        for (int j = 0; j < action->path.count; j++) {
            assert_true(on_sheet(played->points[i][j]));
        }
        assert_true(action->has_at || action->path.count > 0); /* nothing that would outlive the sheet */
        assert_true(action->verb != ACTION_CLEAR);
        assert_true(i == 0 || action->tick >= played->actions[i - 1].tick);
    }
}

static void sessions_are_legal_on_every_sheet(void **state)
{
    (void)state;
    static const float aspects[] = {0.4f, 0.5625f, 1, 1.6f, 1.7778f, 3.2f};
    static const int cells[] = {16384, 40000, 345600, 4000000};
    static const float seconds[] = {20, 60, 120, 1800};
    struct played *played = calloc(1, sizeof *played);
    assert_non_null(played);
    for (size_t i = 0; i < sizeof cells / sizeof cells[0]; i++) {
        for (size_t j = 0; j < sizeof seconds / sizeof seconds[0]; j++) {
            struct stage *stage = a_stage(seconds[j], cells[i]);
            struct attract *attract = attract_create(&stage->exhibit, i * 10 + j);
            for (int k = 0; k < 6 * SCENES; k++) {
                play(attract, k % SCENES, aspects[k / SCENES], played);
                check_legal(played, stage->scenes[k % SCENES].ink_count);
                assert_true((float)played->ticks <= seconds[j] * RATE && played->ticks >= 5 * (int64_t)RATE);
                assert_true(played->count >= 4 && played->actions[0].verb == ACTION_DROP);
                assert_true(played->actions[0].tick < RATE);
            }
            attract_destroy(attract);
            free(stage);
        }
    }
    free(played);
    attract_destroy(NULL);
}

/* What a bloom was meant to reach, by the reach of its brush. */
static float size_of(const struct action *drop)
{
    return (drop->reach - 30) / 2.2f;
}

/* Beads are none. */
static bool is_bloom(const struct action *action)
{
    return action->verb == ACTION_DROP && size_of(action) > 10;
}

static void sessions_are_composed(void **state)
{
    (void)state;
    enum { SESSIONS = 300, ACROSS = 8, DOWN = 5 };
    const float width = 784, height = 441, aspect = width / height;
    struct stage *stage = a_stage(120, 345744);
    struct attract *attract = attract_create(&stage->exhibit, 3);
    struct played *played = calloc(1, sizeof *played);
    assert_non_null(played);
    int used[ACROSS * DOWN] = {0}, brushed[6] = {0}, verbs[ACTION_VERBS] = {0}, balanced = 0;
    for (int i = 0; i < SESSIONS; i++) {
        play(attract, 0, aspect, played);
        int blooms = 0;
        float mean_x = 0, area = 0;
        int64_t grows = 0;
        for (int j = 0; j < played->count; j++) {
            const struct action *one = &played->actions[j];
            verbs[one->verb]++;
            if (!is_bloom(one)) {
                continue;
            }
            float r = size_of(one);
            blooms++;
            brushed[one->brush]++;
            mean_x += one->at.x * r * r;
            area += r * r;
            int block_x = (int)fminf(one->at.x * ACROSS, ACROSS - 1), block_y = (int)fminf(one->at.y * DOWN, DOWN - 1);
            used[block_y * ACROSS + block_x]++;
            /* Something grows at any time, or ink still runs: the slowest brush comes on by .068 cells a tick. */
            assert_true(j == 0 || one->tick <= grows + 2 * RATE);
            int64_t until = one->tick + (int64_t)((r - 11) / 0.068f);
            grows = until > grows ? until : grows;
            for (int k = 0; k < j; k++) { /* no piles */
                const struct action *other = &played->actions[k];
                bool bloom = is_bloom(other);
                float apart = hypotf((one->at.x - other->at.x) * width, (one->at.y - other->at.y) * height);
                assert_true(!bloom || apart > 0.6f * (r + size_of(other)));
                assert_true(!bloom || one->tick - other->tick >= RATE); /* and no bursts */
            }
        }
        assert_in_range(blooms, 3, 20);
        balanced += fabsf(mean_x / area - 0.5f) < 0.02f;
    }
    for (int i = 0; i < ACROSS * DOWN; i++) {
        assert_true(used[i] >= 5); /* every part of the sheet, sometimes */
    }
    for (int i = 0; i < 6; i++) {
        assert_true(brushed[i] > SESSIONS / 10);
    }
    assert_true(verbs[ACTION_GUIDE] > SESSIONS && verbs[ACTION_BRUSH_SOLVENT] > SESSIONS);
    assert_true(verbs[ACTION_BRUSH_INK] > 4 * SESSIONS);
    assert_true(balanced < SESSIONS / 4); /* hardly any is symmetric */
    attract_destroy(attract);
    free(played);
    free(stage);
}

static int by_value(const void *a, const void *b)
{
    const uint64_t *one = a, *other = b;
    return (*one > *other) - (*one < *other);
}

static void no_two_of_a_day_are_the_same(void **state)
{
    (void)state;
    enum { DAYS = 4, A_DAY = 2500, ALL = DAYS * A_DAY };
    struct stage *stage = a_stage(60, 100000);
    record(stage);
    uint64_t *prints = calloc(ALL, sizeof *prints);
    assert_non_null(prints);
    for (int day = 0; day < DAYS; day++) {
        struct attract *attract = attract_create(&stage->exhibit, 1763800000u + 86400u * (uint64_t)day);
        for (int i = 0; i < A_DAY; i++) {
            attract_begin(attract, i % SCENES, 1.6f);
            prints[day * A_DAY + i] = attract_fingerprint(attract);
        }
        attract_destroy(attract);
    }
    qsort(prints, ALL, sizeof *prints, by_value);
    for (int i = 1; i < ALL; i++) {
        assert_true(prints[i] != prints[i - 1]);
    }
    /* The same seed is the same day, to the last session. */
    struct attract *one = attract_create(&stage->exhibit, 5), *other = attract_create(&stage->exhibit, 5);
    for (int i = 0; i < 100; i++) {
        attract_begin(one, i % SCENES, 1.6f);
        attract_begin(other, i % SCENES, 1.6f);
        assert_true(attract_fingerprint(one) == attract_fingerprint(other));
    }
    attract_destroy(one);
    attract_destroy(other);
    free(prints);
    free(stage);
}

/* Storms and dishes: legal, in good time, never the same; what is held is let go; nothing but what is for them. */
static void storms_and_dishes_are_performed(void **state)
{
    (void)state;
    static const float seconds[] = {20, 60, 120, 1800};
    struct played *played = calloc(1, sizeof *played);
    assert_non_null(played);
    for (int i = 0; i < 4 * 2 * 4; i++) {
        enum scene_kind kind = i / 4 % 2 ? SCENE_CHEMISTRY : SCENE_LIGHTNING;
        struct stage *stage = a_stage(seconds[i / 8], 345600);
        stage->exhibit.scenes[0].kind = (int)kind;
        stage->exhibit.scenes[0].options = scene_options_default(kind);
        stage->exhibit.scenes[0].options.lightning = storm_preset(i % 4 < 2 ? BOLT_LIGHTNING : BOLT_CORAL);
        struct attract *attract = attract_create(&stage->exhibit, (uint64_t)i);
        play(attract, 0, 1.7778f, played);
        uint64_t print = attract_fingerprint(attract);
        int hands = 0, deeds = 0;
        for (int k = 0; k < played->count; k++) {
            const struct action *action = &played->actions[k];
            assert_int_equal(scene_kind_of(action->verb), kind);
            assert_true(!action->has_at || on_sheet(action->at));
            hands += action->verb == ACTION_ATTRACT ? action->has_at ? 1 : -1 : 0;
            deeds += action->verb == ACTION_STRIKE || action->verb == ACTION_DOSE;
            assert_true(hands == 0 || hands == 1);
            struct action legal = action_legal(action);
            assert_memory_equal(&legal.radius, &action->radius, sizeof legal.radius);
        }
        assert_int_equal(hands, 0);
        assert_true(deeds >= 1 && played->actions[0].tick <= 3 * RATE);
        assert_true((float)played->ticks <= seconds[i / 8] * RATE);
        attract_begin(attract, 0, 1.7778f);
        assert_true(attract_fingerprint(attract) != print);
        attract_destroy(attract);
        free(stage);
    }
    free(played);
}

/* The recorded ones among `count` sessions, by `each`. */
static int play_recorded(struct stage *stage, int count, void (*each)(const struct played *, int *), int *tally)
{
    struct attract *attract = attract_create(&stage->exhibit, 9);
    struct played *played = calloc(1, sizeof *played);
    assert_non_null(played);
    int found = 0;
    for (int i = 0; i < count; i++) {
        play(attract, 1, 1.6f, played);
        check_legal(played, 2);
        if (i % 3 == 2) {
            each(played, tally);
            found++;
        }
    }
    attract_destroy(attract);
    free(played);
    return found;
}

enum { LEFT, TOP, FIRST_INK, SLOW, TALLIES };

static void look_at_variation(const struct played *played, int *tally)
{
    assert_int_equal(played->count, 5); /* drop, the stroke in three pieces, drop; its sheet is not wiped */
    const struct action *drop = &played->actions[0], *late = &played->actions[4];
    assert_true(drop->verb == ACTION_DROP && late->verb == ACTION_DROP);
    tally[LEFT] += drop->at.x < 0.5f;
    tally[TOP] += drop->at.y < 0.5f;
    tally[FIRST_INK] += drop->ink == 0;
    tally[SLOW] += played->ticks > 1150;
    /* The stroke goes on from the drop as it did, whichever way round, with all of its points. */
    struct point last = drop->at;
    int points = 1;
    for (int i = 1; i < 4; i++) {
        const struct action *piece = &played->actions[i];
        assert_true(piece->verb == ACTION_BRUSH_INK && piece->ink == 1 - drop->ink);
        assert_near(played->points[i][0].x, last.x, 1e-5);
        last = played->points[i][piece->path.count - 1];
        points += piece->path.count - 1;
    }
    assert_int_equal(points, 20);
    assert_near(fabsf(last.x - drop->at.x), 0.38, 1e-5);
    assert_near(last.y, drop->at.y, 1e-5);
    assert_near((double)played->actions[1].tick / 300, (double)late->tick / 900, 0.05);
    assert_true(played->ticks > 890 && played->ticks < 1500);
    assert_near(drop->reach, 160, 1e-3);
}

static void look_at_size(const struct played *played, int *tally)
{
    const struct action *drop = &played->actions[0], *piece = &played->actions[1];
    (*tally)++;
    assert_near(drop->reach, 320, 1e-3);
    assert_near(drop->radius, 8, 1e-3);
    assert_near(drop->solvent, 240, 1e-3);
    assert_near(piece->radius, 12, 1e-3);
    assert_true((double)played->actions[4].tick > 900 * 2 * 0.88);
}

static void look_at_place(const struct played *played, int *tally)
{
    (*tally)++;
    assert_true(played->actions[0].at.x == 0.2f && played->actions[0].at.y == 0.3f);
}

static void recorded_sessions_are_varied(void **state)
{
    (void)state;
    struct stage *stage = a_stage(60, 100000);
    record(stage);
    int tally[TALLIES] = {0}, other = 0;
    assert_int_equal(play_recorded(stage, 300, look_at_variation, tally), 100);
    for (int i = 0; i < TALLIES; i++) {
        assert_in_range(tally[i], 20, 80);
    }
    stage->exhibit.sheet.cells = 400000; /* as large as the sheet is */
    play_recorded(stage, 30, look_at_size, &other);
    /* On a field that stays where it is, places stay as well. */
    static const float field[] = {1, 1, 1, 1};
    stage->actions[1].formula = (struct action_raster){.values = field, .width = 2, .height = 2, .channels = 1};
    play_recorded(stage, 30, look_at_place, &other);
    assert_int_equal(other, 20);
    free(stage);
}

/* The hand is where it paints, presses when it does, and never leaps. */
static void a_hand_paints(void **state)
{
    (void)state;
    struct stage *stage = a_stage(120, 345600);
    struct attract *attract = attract_create(&stage->exhibit, 12);
    for (int i = 0; i < 40; i++) {
        attract_begin(attract, 0, 1.6f);
        struct point before = {0};
        float pressed_before = 0;
        bool shown_before = false;
        int shown = 0, pressed_ticks = 0;
        int64_t tick = 0;
        for (; !attract_over(attract, tick); tick++) {
            struct point at;
            float pressed;
            bool is = attract_hand(attract, tick, &at, &pressed);
            if (is && shown_before) {
                assert_true(hypotf(at.x - before.x, at.y - before.y) < 0.12f);
                assert_true(fabsf(pressed - pressed_before) < 0.2f);
            }
            assert_true(is || shown_before == false || pressed_before < 0.2f);
            assert_true(!is || (pressed >= 0 && pressed <= 1 && isfinite(at.x) && isfinite(at.y)));
            struct action action;
            while (attract_action(attract, tick, &action)) {
                struct point place = action.path.count ? action.path.points[action.path.count - 1] : action.at;
                assert_true(is);
                assert_near(at.x, place.x, 0.02);
                assert_near(at.y, place.y, 0.03);
                assert_true(pressed > 0.9f);
            }
            before = at;
            pressed_before = is ? pressed : 0;
            shown_before = is;
            shown += is;
            pressed_ticks += is && pressed > 0.9f;
        }
        assert_true(shown > tick / 20 && pressed_ticks > 60 && pressed_ticks < tick / 2);
    }
    attract_destroy(attract);
    free(stage);
}

/* One to three seeds, each in a part of its own, then strokes; a rest at the end in which nothing is done. */
static void scenes_of_trees_are_planted_and_tended(void **state)
{
    (void)state;
    struct played *played = calloc(1, sizeof *played);
    struct stage *stage = a_stage(60, 345600);
    uint64_t prints[20];
    int counts[4] = {0};
    assert_non_null(played);
    stage->exhibit.scenes[1].kind = SCENE_TREES;
    struct attract *attract = attract_create(&stage->exhibit, 5);
    for (int k = 0; k < 20; k++) {
        play(attract, 1, k % 2 ? 1.6f : 0.6f, played);
        check_legal(played, 1);
        int seeds = 0;
        for (int i = 0; i < played->count; i++) {
            const struct action *action = &played->actions[i];
            assert_true(action->verb == ACTION_PLANT || (action->verb == ACTION_TEND && seeds > 0));
            for (int j = 0; j < i && action->verb == ACTION_PLANT; j++) {
                const struct action *other = &played->actions[j];
                assert_true(other->verb != ACTION_PLANT || fabsf(other->at.x - action->at.x) > 0.15f);
            }
            seeds += action->verb == ACTION_PLANT;
        }
        assert_in_range(seeds, 1, 3);
        counts[seeds]++;
        assert_true(played->count > seeds && played->actions[0].tick < 5 * RATE);
        assert_true(played->actions[played->count - 1].tick < played->ticks - 8 * RATE);
        assert_int_equal(played->ticks, 60 * RATE);
        prints[k] = attract_fingerprint(attract);
        for (int i = 0; i < k; i++) {
            assert_true(prints[i] != prints[k]);
        }
    }
    assert_true(counts[1] > 0 && counts[2] > 0 && counts[3] > 0);
    attract_destroy(attract);
    stage->exhibit.visit.attract = 20; /* the least there is */
    attract = attract_create(&stage->exhibit, 5);
    play(attract, 1, 1.6f, played);
    assert_true(played->count > 0);
    attract_destroy(attract);
    free(stage);
    free(played);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(sessions_are_legal_on_every_sheet),      cmocka_unit_test(sessions_are_composed),
        cmocka_unit_test(storms_and_dishes_are_performed),        cmocka_unit_test(no_two_of_a_day_are_the_same),
        cmocka_unit_test(recorded_sessions_are_varied),           cmocka_unit_test(a_hand_paints),
        cmocka_unit_test(scenes_of_trees_are_planted_and_tended),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
