/* The governor on boards that are made up here: too slow by so much, with noise and spikes, hot, throttling. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "governor.h"
#include "random.h"

enum { WANTED = 60, FRAMES = 128 /* more than there are in a second */ };

/* A board: a tick of level 0 takes `tick_ms`. Lowering saves as much of it as the governor thinks, to the power of
 * `saved`: 1 as much, less less. */
struct board {
    float tick_ms, saved;
    float noise;     /* of each tick, a share */
    float spike_ms;  /* of one frame every ten seconds */
    float picture;   /* ms of a frame that does not depend on the level */
    bool shared;     /* a GPU: ticks delay frames as well */
    float ambient;   /* C; NAN: no thermometer */
    float heating;   /* C above ambient at full work, after long */
    float sink_s;    /* how long that takes */
    float throttles; /* C above which all takes twice as long */
};

static const struct board CALM = {
    .tick_ms = 5, .saved = 1, .picture = 5, .ambient = NAN, .sink_s = 1, .throttles = 1000};

struct run {
    struct governor governor;
    const struct board *board;
    int64_t now_us;
    int frame;
    float celsius;                        /* of the board now */
    float frames_s[FRAMES], done[FRAMES]; /* how long the last frames took, and the ticks done in them */
    int first;                            /* of those in the last second */
    double seconds, ticks;                /* of them all */
    int changes, lines;
    char line[GOVERNOR_LINE];
};

static struct run start(const struct board *board)
{
    struct governor_def def = governor_default_def();
    struct coefficients c = coefficients_default();
    return (struct run){governor_start(&def, &c), board, 0, 0, board->ambient, {0}, {0}, 0, 0, 0, 0, 0, ""};
}

static float uniform(const struct run *run, int stream)
{
    return 2 * random_unit(run->frame, stream, 7, RANDOM_GRAIN) - 1;
}

/* Ticks a second over the last second, once this frame has taken so long. */
static float reached(struct run *run, float seconds, float ticks)
{
    run->frames_s[run->frame % FRAMES] = seconds;
    run->done[run->frame % FRAMES] = ticks;
    run->seconds += (double)seconds;
    run->ticks += (double)ticks;
    for (; run->first < run->frame && run->seconds - (double)run->frames_s[run->first % FRAMES] >= 1; run->first++) {
        run->seconds -= (double)run->frames_s[run->first % FRAMES];
        run->ticks -= (double)run->done[run->first % FRAMES];
    }
    run->frame++;
    return (float)(run->ticks / run->seconds);
}

/* What this board does in the next frame. In a spike it stands still. */
static struct governor_sample sample_board(struct run *run)
{
    const struct board *board = run->board;
    struct governor_level level = governor_level(&run->governor);
    bool throttled = run->celsius > board->throttles;
    float tick = board->tick_ms * powf(level.cost, board->saved) * (1 + board->noise * uniform(run, 1));
    tick *= throttled ? 2 : 1;
    bool spike = board->spike_ms > 0 && run->frame % 600 == 300;
    float frame = board->picture * (1 + board->noise * uniform(run, 2));
    float now = fminf(WANTED, 1000 / tick);
    frame += board->shared ? tick * now / WANTED : 0;
    frame = fmaxf(ceilf(frame / 16.667f), 1) * 16.667f;
    float done = now * frame / 1000;
    frame += spike ? board->spike_ms : 0;
    float work = fminf(now * tick / 1000, 1);
    run->celsius += (board->ambient + board->heating * work - run->celsius) * frame / 1000 / board->sink_s;
    run->now_us += (int64_t)(frame * 1000);
    return (struct governor_sample){run->now_us, frame,        tick,      reached(run, frame / 1000, done),
                                    WANTED,      run->celsius, throttled, run->governor.wanted};
}

static void run_for(struct run *run, float seconds)
{
    int64_t end = run->now_us + (int64_t)(seconds * 1e6f);
    while (run->now_us < end) {
        struct governor_sample sample = sample_board(run);
        int before = run->governor.wanted;
        const char *line = governor_step(&run->governor, &sample);
        if (line) {
            snprintf(run->line, sizeof run->line, "%s", line);
            run->lines++;
        }
        if (run->governor.wanted != before) {
            assert_non_null(line);
            assert_in_range(run->governor.wanted, before > 0 ? before - 1 : 0, before + 1); /* one at a time */
            run->changes++;
        }
    }
}

/* Until the level changes; the seconds that took, or `most`. */
static float run_to_change(struct run *run, float most)
{
    int changes = run->changes;
    int64_t since = run->now_us;
    while (run->changes == changes && (float)(run->now_us - since) < most * 1e6f) {
        run_for(run, 1e-3f);
    }
    return (float)(run->now_us - since) / 1e6f;
}

static void assert_level(const struct governor *governor, int i, int fluid, int pattern, double dt, double scale)
{
    const struct governor_level *level = &governor->levels[i];
    assert_int_equal(level->fluid_steps, fluid);
    assert_int_equal(level->pattern_steps, pattern);
    assert_true(fabs((double)level->dt - dt) < 1e-6);
    assert_true(fabs((double)level->scale - scale) < 1e-6);
}

static void the_ladder_goes_by_how_little_shows(void **state)
{
    (void)state;
    struct run run = start(&CALM);
    assert_int_equal(run.governor.count, 6);
    assert_level(&run.governor, 0, 4, 8, .1, 1);
    assert_level(&run.governor, 1, 3, 8, .1, 1);
    assert_level(&run.governor, 2, 2, 8, .1, 1);
    assert_level(&run.governor, 3, 2, 4, .2, 1);
    assert_level(&run.governor, 4, 2, 4, .2, .75);
    assert_level(&run.governor, 5, 2, 4, .2, .5);
    for (int i = 1; i < 6; i++) {
        assert_true(run.governor.levels[i].cost < run.governor.levels[i - 1].cost);
    }
    assert_true(fabs((double)run.governor.levels[0].cost - 1) < 1e-6);
    assert_true(fabs((double)run.governor.levels[2].cost - .6) < 1e-6);
    assert_true(fabs((double)run.governor.levels[4].cost - .5 * .75 * .75) < 1e-6);
}

static void coefficients_limit_the_ladder(void **state)
{
    (void)state;
    struct governor_def def = governor_default_def();
    struct coefficients c = coefficients_default();
    for (const struct brush *brush = brushes; brush->name; brush++) {
        governor_admit_brush(&def, brush);
    }
    struct governor governor = governor_start(&def, &c); /* a brush with alpha_y 2 wants dt .1 */
    assert_int_equal(governor.count, 5);
    assert_level(&governor, 3, 2, 8, .1, .75);
    def = governor_default_def();
    c.alpha_y = 1.3f; /* 6 steps of .133 */
    governor = governor_start(&def, &c);
    assert_level(&governor, 3, 2, 6, .8 / 6, 1);
    c = coefficients_default();
    c.beta_a = 8; /* followed at .125 at most: too little is saved */
    c.fluid_steps = 1;
    def.scales[0] = 0;
    governor = governor_start(&def, &c);
    assert_int_equal(governor.count, 2);
    assert_level(&governor, 1, 1, 8, .1, .5);
    governor.wanted = 1;
    def.scales[1] = 0;
    governor.def = def;
    governor_rebase(&governor, &c);
    assert_int_equal(governor.count, 1);
    assert_int_equal(governor.wanted, 0);
    c.dt = .01f; /* nothing but the step of the pattern */
    governor_rebase(&governor, &c);
    assert_int_equal(governor.count, 2);
    assert_level(&governor, 1, 1, 1, .08, 1);
}

static void lasting_overload_is_answered_within_two_seconds(void **state)
{
    (void)state;
    static const struct {
        float tick_ms, picture;
        bool shared;
    } loads[] = {{20, 5, false}, {30, 5, false}, {200, 5, false}, {10, 45, true}, {10, 700, true}, {60, 10, true}};
    for (size_t i = 0; i < sizeof loads / sizeof loads[0]; i++) {
        struct board board = CALM;
        struct run run = start(&board);
        run_for(&run, 30);
        assert_int_equal(run.changes, 0);
        board.tick_ms = loads[i].tick_ms;
        board.picture = loads[i].picture;
        board.shared = loads[i].shared;
        float waited = run_to_change(&run, 10);
        assert_int_equal(run.governor.wanted, 1);
        assert_true(waited <= 2 + loads[i].picture / 1000);
    }
}

static void single_spikes_are_ignored(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    for (float spike = 20; spike < 3000; spike *= 2) {
        board.spike_ms = spike;
        run_for(&run, 120);
        assert_int_equal(run.changes, 0);
    }
}

static void a_noisy_frame_at_its_target_is_no_overload(void **state)
{
    (void)state;
    struct board board = CALM;
    board.picture = 30; /* frames of 33, one in three of 50 */
    board.noise = .2f;
    struct run run = start(&board);
    run_for(&run, 3600);
    assert_int_equal(run.changes, 0);
}

static void calm_raises_what_was_lowered_in_reverse_order(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    board.tick_ms = 400;
    run_for(&run, 30);
    assert_int_equal(run.governor.wanted, 5);
    assert_string_equal(strchr(run.line, ':'), ": nothing is left to lower");
    assert_int_equal(run.lines, 6); /* said once */
    board.tick_ms = 5;
    static const char *const expected[] = {
        "grid 0.5 -> 0.75",     "grid 0.75 -> 1",       "pattern 4 x 0.2 -> 8 x 0.1",
        "solvent steps 2 -> 3", "solvent steps 3 -> 4",
    };
    for (int i = 0; i < 5; i++) {
        float waited = run_to_change(&run, 100);
        assert_true(waited > 59 && waited < 66); /* longer than it takes to lower */
        assert_int_equal(run.governor.wanted, 4 - i);
        assert_non_null(strstr(run.line, expected[i]));
    }
    run_for(&run, 3600);
    assert_int_equal(run.changes, 10);
}

static void nothing_is_raised_into_what_cannot_fit(void **state)
{
    (void)state;
    struct board board = CALM;
    board.tick_ms = 20; /* 50 ticks at level 0, 62 at level 1, which is 97 % of their time */
    struct run run = start(&board);
    run_for(&run, 8 * 3600);
    assert_int_equal(run.governor.wanted, 1);
    assert_int_equal(run.changes, 1);
}

/* Boards of every speed, whatever lowering saves on them, settle: hardly a change after the first hour. */
static void every_board_settles(void **state)
{
    (void)state;
    for (float tick = 6; tick < 120; tick *= 1.4f) {
        for (int kind = 0; kind < 6; kind++) {
            struct board board = CALM;
            board.tick_ms = tick;
            board.saved = kind % 3 == 0 ? .5f : kind % 3 == 1 ? 1 : 1.5f;
            board.noise = .1f;
            board.spike_ms = 300;
            board.shared = kind >= 3;
            struct run run = start(&board);
            run_for(&run, 60);
            int settled = run.governor.wanted;
            run_for(&run, 3540);
            assert_in_range(run.changes, 0, 14);
            run.changes = 0;
            run_for(&run, 2 * 3600);
            assert_in_range(run.changes, 0, 4);
            assert_in_range(run.governor.wanted, settled > 0 ? settled - 1 : 0, settled + 1);
            struct governor_level level = governor_level(&run.governor);
            assert_true(powf(level.cost, board.saved) * tick < 20 || run.governor.wanted == 5);
        }
    }
}

/* Much work for some minutes and little for more, all day: it learns that little work is no reason to do more. */
static void coming_and_going_does_not_flicker(void **state)
{
    (void)state;
    static const float much[] = {120, 300}, little[] = {180, 500};
    for (int rhythm = 0; rhythm < 2; rhythm++) {
        struct board board = CALM;
        struct run run = start(&board);
        for (int i = 0; i < 36; i++) {
            board.tick_ms = 27;
            run_for(&run, much[rhythm]);
            board.tick_ms = 4;
            run_for(&run, little[rhythm]);
            run.changes = i < 12 ? 0 : run.changes;
        }
        assert_in_range(run.changes, 0, 4);
        assert_int_equal(run.governor.wanted, 2);
        run_for(&run, 3 * 3600); /* nobody comes any more */
        assert_int_equal(run.governor.wanted, 0);
        assert_in_range(run.changes, 2, 6);
        assert_true(run.governor.calm_s <= governor_default_def().calm_s); /* and is trusted again */
    }
}

/* Full work would heat it to 45 + 45 C: it is held below throttling, and changes little in a day. */
static void a_hot_board_settles_below_throttling(void **state)
{
    (void)state;
    for (float heating = 20; heating <= 60; heating += 10) {
        struct board board = CALM;
        board.tick_ms = 15;
        board.ambient = 45;
        board.heating = heating;
        board.sink_s = 90;
        board.throttles = 80;
        struct run run = start(&board);
        run_for(&run, 3600);
        run.changes = 0;
        float hottest = 0;
        for (int minute = 0; minute < 3 * 60; minute++) {
            run_for(&run, 60);
            hottest = fmaxf(hottest, run.celsius);
        }
        assert_in_range(run.changes, 0, 6);
        assert_true(hottest < 78);
    }
}

static void heat_and_throttling_are_told(void **state)
{
    (void)state;
    struct board board = CALM;
    board.sink_s = 1;
    board.ambient = 76.2f;
    struct run run = start(&board);
    run_for(&run, 40);
    assert_int_equal(run.changes, 0);
    run_for(&run, 10);
    assert_int_equal(run.changes, 1);
    assert_string_equal(run.line, "76.2 C over 75 for 45 s: solvent steps 4 -> 3");
    board.ambient = 78.5f; /* quicker */
    run_for(&run, 20);
    assert_int_equal(run.changes, 2);
    assert_string_equal(run.line, "78.5 C over 78 for 15 s: solvent steps 3 -> 2");
    board.ambient = 72; /* neither warm nor cool: as it is */
    run_for(&run, 3600);
    assert_int_equal(run.changes, 2);
    board.ambient = 69;
    run_for(&run, 70);
    assert_int_equal(run.changes, 3);
    assert_non_null(strstr(run.line, "solvent steps 2 -> 3"));
    board.ambient = 60;
    board.throttles = 50; /* by under-voltage, say */
    run_for(&run, 20);
    assert_int_equal(run.changes, 4);
    assert_string_equal(run.line, "the board throttles for 15 s: solvent steps 3 -> 2");
}

static void a_board_that_throttles_or_misses_ticks_is_not_calm(void **state)
{
    (void)state;
    struct board board = CALM;
    board.throttles = 50;
    board.ambient = 60;
    board.sink_s = 1;
    struct run run = start(&board);
    run_for(&run, 1000);
    assert_int_equal(run.governor.wanted, 5);
    assert_int_equal(run.changes, 5);
    board.throttles = 1000;
    for (int i = 0; i < 60 * 300; i++) {
        struct governor_sample sample = sample_board(&run);
        sample.ticks_per_second = 56;
        assert_null(governor_step(&run.governor, &sample));
    }
}

static void warmth_that_comes_and_goes_is_warmth(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    for (int i = 0; i < 120; i++) {
        run.celsius = board.ambient = i % 4 ? 75.5f : 74.5f;
        run_for(&run, 1);
    }
    assert_int_equal(run.changes, 1);
    for (int i = 0; i < 120; i++) {
        run.celsius = board.ambient = i % 4 ? 74.5f : 75.5f;
        run_for(&run, 1);
    }
    assert_int_equal(run.changes, 1);
}

static void lines_say_the_numbers(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    run_for(&run, 10);
    board.picture = 45;
    run_to_change(&run, 10);
    assert_string_equal(run.line, "frame 50 ms over 33 for 1.4 s: solvent steps 4 -> 3");
    board.picture = 5;
    board.tick_ms = 400;
    run_to_change(&run, 10);
    assert_string_equal(run.line, "3 ticks a second of 60 for 1.4 s: solvent steps 3 -> 2");
    board.tick_ms = 5;
    run_to_change(&run, 100);
    assert_string_equal(run.line, "calm for 60 s, 24 % of the time of a tick expected: solvent steps 2 -> 3");
}

static void it_waits_until_its_level_is_applied(void **state)
{
    (void)state;
    struct board board = CALM;
    board.tick_ms = 400;
    struct run run = start(&board);
    run_to_change(&run, 10);
    for (int i = 0; i < 6000; i++) { /* somebody touches: the grid cannot change yet */
        struct governor_sample sample = sample_board(&run);
        sample.applied = 0;
        assert_null(governor_step(&run.governor, &sample));
    }
    assert_int_equal(run.governor.wanted, 1);
    run_for(&run, 4);
    assert_int_equal(run.governor.wanted, 2);
}

static void rest_is_neither_overload_nor_calm(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    board.tick_ms = 22;
    run_for(&run, 10);
    assert_int_equal(run.governor.wanted, 1);
    for (int i = 0; i < 36000; i++) {
        struct governor_sample sample = sample_board(&run);
        sample.ticks_wanted = sample.ticks_per_second = sample.tick_ms = 0;
        sample.applied = 1;
        assert_null(governor_step(&run.governor, &sample));
    }
    assert_int_equal(run.governor.wanted, 1);
}

static void a_pause_begins_a_new_warm_up(void **state)
{
    (void)state;
    struct board board = CALM;
    struct run run = start(&board);
    board.tick_ms = 100;
    run_for(&run, 2.9f);
    assert_int_equal(run.changes, 0); /* the first seconds compile shaders */
    run.now_us += 3600 * INT64_C(1000000);
    run_for(&run, 2.9f);
    assert_int_equal(run.changes, 0);
    run_for(&run, 2);
    assert_int_equal(run.changes, 1);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(the_ladder_goes_by_how_little_shows),
        cmocka_unit_test(coefficients_limit_the_ladder),
        cmocka_unit_test(lasting_overload_is_answered_within_two_seconds),
        cmocka_unit_test(single_spikes_are_ignored),
        cmocka_unit_test(a_noisy_frame_at_its_target_is_no_overload),
        cmocka_unit_test(calm_raises_what_was_lowered_in_reverse_order),
        cmocka_unit_test(nothing_is_raised_into_what_cannot_fit),
        cmocka_unit_test(every_board_settles),
        cmocka_unit_test(coming_and_going_does_not_flicker),
        cmocka_unit_test(a_hot_board_settles_below_throttling),
        cmocka_unit_test(heat_and_throttling_are_told),
        cmocka_unit_test(a_board_that_throttles_or_misses_ticks_is_not_calm),
        cmocka_unit_test(warmth_that_comes_and_goes_is_warmth),
        cmocka_unit_test(lines_say_the_numbers),
        cmocka_unit_test(it_waits_until_its_level_is_applied),
        cmocka_unit_test(rest_is_neither_overload_nor_calm),
        cmocka_unit_test(a_pause_begins_a_new_warm_up),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
