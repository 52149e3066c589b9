/* A scene beside the studio: told as the studio tells, looked at as the display looks. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <float.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include "bench.h"
#include "clock_case.h"
#include "garden.h"
#include "journal.h"
#include "live_scene.h"
#include "patience.h"

enum { LEAST_PLANS = 2 };
enum { CELLS_X = 96, CELLS_Y = 60, WIDTH = 96, HEIGHT = 60, SIDE = 48, VISITOR = 3 };

struct place {
    struct live_scene *live;
    struct script trees, plain; /* scenes; nothing of them is read but the size */
    int64_t ticked;
    float picture[SIDE * SIDE];
};

static void nap(int ms)
{
    nanosleep(&(struct timespec){0, ms * 1000000L}, NULL);
    clock_case_pass(1e-3 * ms);
}

static void tell(struct place *place, enum studio_event_kind kind, const struct script *script,
                 const struct action *action)
{
    struct studio_event event = {.kind = kind,
                                 .ticked = place->ticked,
                                 .script = script,
                                 .def = {.width = CELLS_X, .height = CELLS_Y},
                                 .action = action};
    live_scene_tell(place->live, &event);
}

static void act(struct place *place, const struct action *action)
{
    tell(place, STUDIO_ACTION, &place->trees, action);
}

static void tick(struct place *place)
{
    place->ticked++;
    tell(place, STUDIO_TICKED, &place->trees, NULL);
}

static struct action stock_of(const struct place *place)
{
    struct action action = action_default(ACTION_STOCK);
    action.picture = (struct action_raster){place->picture, SIDE, SIDE, 1};
    return action;
}

static struct action plant_at(float x, float y)
{
    struct action action = action_default(ACTION_PLANT);
    action.visitor = VISITOR;
    action.at = (struct point){x, y};
    action.has_at = true;
    return action;
}

static struct action few_endpoints(void)
{
    struct action action = action_default(ACTION_SHAPE);
    action.option = (int)(key_find(growth_keys, "endpoints") - growth_keys);
    action.value = 200;
    return action;
}

static void open_place(struct place *place)
{
    *place = (struct place){.trees = {.width = CELLS_X, .height = CELLS_Y}, .ticked = 100};
    for (int i = 0; i < SIDE * SIDE; i++) { /* a dark ring */
        int x = i % SIDE - SIDE / 2, y = i / SIDE - SIDE / 2, square = x * x + y * y;
        place->picture[i] = square > 100 && square < 400 ? 0.1f : 0.9f;
    }
    place->live = live_scene_create(scene_types);
    assert_non_null(place->live);
    live_scene_scene(place->live, &place->trees, SCENE_TREES, "trees");
    live_scene_scene(place->live, &place->plain, SCENE_PAINTING, "plain");
}

static void close_place(struct place *place)
{
    live_scene_destroy(place->live);
}

static struct live_scene_sheet sheet_of(const struct place *place)
{
    return live_scene_sheet(place->live, bench_wall_s());
}

/* Until a plate is there in which all that was told is planned; the newest. */
static const struct live_view *settle(struct place *place)
{
    double end_s = bench_wall_s() + PATIENCE_S;
    while (!live_scene_is_calm(place->live)) {
        assert_true(bench_wall_s() < end_s);
        nap(2);
    }
    bool fresh;
    return live_scene_newest(place->live, sheet_of(place).number, &fresh);
}

static uint64_t mark_of(const struct plate *plate)
{
    size_t pixels = (size_t)plate->width * (size_t)plate->height;
    const uint8_t *births = (const uint8_t *)plate->birth;
    uint64_t mark = 14695981039346656037u; /* FNV-1a */
    for (size_t i = 0; i < pixels * 4; i++) {
        mark = (mark ^ plate->rgba[i]) * 1099511628211u;
        mark = (mark ^ births[i]) * 1099511628211u;
    }
    return mark;
}

/* Picture, shape and two seeds, before anything is planned. */
static void plant_two(struct place *place)
{
    struct action stock = stock_of(place), few = few_endpoints(), one = plant_at(0.3f, 0.9f),
                  other = plant_at(0.7f, 0.2f);
    tell(place, STUDIO_SHEET, &place->trees, NULL);
    act(place, &stock);
    act(place, &few);
    act(place, &one);
    tick(place);
    tick(place);
    act(place, &other);
    memset(place->picture, 0, sizeof place->picture); /* it was copied */
}

/* The plate that the same actions make without a thread. */
static uint64_t mark_without(const struct place *place)
{
    struct place own = *place;
    struct garden_def def = garden_default_def();
    struct plate plate;
    def.width = CELLS_X;
    def.height = CELLS_Y;
    struct garden *garden = garden_create(&def);
    struct action actions[] = {stock_of(&own), few_endpoints(), plant_at(0.3f, 0.9f), plant_at(0.7f, 0.2f)};
    for (int i = 0; i < 4; i++) {
        garden_act(garden, i == 3 ? 102 : 100, &actions[i]);
    }
    assert_true(garden_grow(garden) && plate_init(&plate, WIDTH, HEIGHT) && garden_paint(garden, &plate));
    uint64_t mark = mark_of(&plate);
    plate_finish(&plate);
    garden_destroy(garden);
    return mark;
}

static void as_the_garden_without_a_thread(void **state)
{
    (void)state;
    struct place place;
    open_place(&place);
    uint64_t want = mark_without(&place);
    plant_two(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    const struct live_view *plate = settle(&place);
    assert_true(plate->any && plate->plate.width == WIDTH && plate->plate.height == HEIGHT);
    assert_true(mark_of(&plate->plate) == want);
    assert_int_equal(plate->sheet, sheet_of(&place).number);
    assert_in_range(plate->last_tick, 100 + 100, 100 + 3 + 240 + PLATE_SOFT + 1);
    assert_int_equal(sheet_of(&place).plans, 1);
    assert_true(sheet_of(&place).kind == SCENE_TREES && sheet_of(&place).can_undo == UINT64_C(1) << VISITOR);
    close_place(&place);
}

static void what_is_shown_stays_as_it_is(void **state)
{
    (void)state;
    struct place place;
    bool fresh;
    open_place(&place);
    plant_two(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    const struct live_view *shown = settle(&place);
    uint64_t mark = mark_of(&shown->plate);
    for (int i = 0; i < 4; i++) {
        struct action plant = plant_at(0.1f + 0.2f * (float)i, 0.5f);
        int plans = sheet_of(&place).plans;
        act(&place, &plant);
        tick(&place);
        while (sheet_of(&place).plans == plans) {
            nap(1);
        }
    }
    assert_true(live_scene_has_newer(place.live));
    assert_true(mark_of(&shown->plate) == mark);
    const struct live_view *newest = live_scene_newest(place.live, sheet_of(&place).number, &fresh);
    assert_true(fresh && newest != shown && mark_of(&newest->plate) != mark && newest->sequence > shown->sequence);
    assert_false(live_scene_has_newer(place.live));
    assert_ptr_equal(live_scene_newest(place.live, sheet_of(&place).number, &fresh), newest);
    assert_false(fresh);
    close_place(&place);
}

static void dragging_plans_six_times_a_second(void **state)
{
    (void)state;
    struct place place;
    struct action tend = action_default(ACTION_TEND);
    open_place(&place);
    plant_two(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    settle(&place);
    int plans = sheet_of(&place).plans;
    double began_s = bench_wall_s();
    for (int i = 0; i < 40 || sheet_of(&place).plans - plans < LEAST_PLANS; i++) {
        float x = 0.02f * (float)(i % 40);
        struct point path[] = {{x, 0.4f}, {x + 0.02f, 0.4f}};
        assert_true(bench_wall_s() - began_s < PATIENCE_S);
        tend.path = (struct action_path){path, 2};
        if (i < 40 || live_scene_is_calm(place.live)) { /* a thread that is slow has enough to do */
            act(&place, &tend);
            tick(&place);
        }
        nap(10);
    }
    settle(&place);
    double most = 6 * (bench_wall_s() - began_s) + 1;
    assert_in_range(sheet_of(&place).plans - plans, LEAST_PLANS, (int)most);
    close_place(&place);
}

static void undo_and_redo(void **state)
{
    (void)state;
    struct place place;
    struct action undo = action_default(ACTION_UNDO), redo = action_default(ACTION_REDO);
    open_place(&place);
    plant_two(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    undo.visitor = redo.visitor = VISITOR;
    act(&place, &undo);
    act(&place, &undo);
    const struct live_view *plate = settle(&place);
    assert_false(plate->any);
    assert_int_equal(sheet_of(&place).can_undo, 0);
    assert_int_equal(sheet_of(&place).can_redo, 1 << VISITOR);
    act(&place, &redo);
    plate = settle(&place);
    assert_true(plate->any);
    assert_int_equal(sheet_of(&place).can_undo, 1 << VISITOR);
    close_place(&place);
}

static void sheets_and_scenes(void **state)
{
    (void)state;
    struct place place;
    struct action plant = plant_at(0.5f, 0.5f);
    open_place(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    tell(&place, STUDIO_SHEET, &place.plain, NULL);
    act(&place, &plant);
    assert_true(sheet_of(&place).kind == SCENE_PAINTING);
    assert_int_equal(sheet_of(&place).number, 0);
    assert_true(live_scene_is_calm(place.live)); /* nothing was taken */

    tell(&place, STUDIO_SCENE, &place.trees, NULL);
    assert_true(sheet_of(&place).kind == SCENE_TREES);
    plant_two(&place);
    const struct live_view *plate = settle(&place);
    uint64_t mark = mark_of(&plate->plate);
    int number = sheet_of(&place).number;
    assert_true(plate->any);

    tell(&place, STUDIO_SCENE, &place.trees, NULL); /* the file was edited: all stays */
    plate = settle(&place);
    assert_true(plate->any && sheet_of(&place).number == number && plate->sheet == number);

    tell(&place, STUDIO_SHEET, &place.trees, NULL); /* a fresh sheet */
    assert_int_equal(sheet_of(&place).number, number + 1);
    assert_int_equal(sheet_of(&place).can_undo, 0);
    plate = settle(&place);
    assert_true(!plate->any && plate->sheet == number + 1);

    place.ticked = 100;
    tell(&place, STUDIO_SCENE, &place.plain, NULL); /* and a painting again */
    plate = settle(&place);
    assert_true(!plate->any && sheet_of(&place).kind == SCENE_PAINTING && mark);
    close_place(&place);
}

static struct action rinse_at(float y, struct point front[2])
{
    struct action rinse = action_default(ACTION_RINSE);
    front[0] = (struct point){0, y};
    front[1] = (struct point){1, y};
    rinse.path = (struct action_path){front, 2};
    rinse.reach = 0.3f;
    return rinse;
}

static void water_runs_without_a_plan(void **state)
{
    (void)state;
    struct place place;
    struct point front[2];
    uint8_t water[LIVE_WATER_WIDTH * LIVE_WATER_HEIGHT];
    open_place(&place);
    plant_two(&place);
    live_scene_size(place.live, WIDTH, HEIGHT);
    settle(&place);
    int plans = sheet_of(&place).plans;
    for (int i = 0; i < 40; i++) { /* to the middle */
        struct action rinse = rinse_at(0.5f * (float)i / 40, front);
        act(&place, &rinse);
        tick(&place);
        nap(5);
    }
    live_scene_water(place.live, water);
    assert_true(sheet_of(&place).rinsed);
    assert_int_equal(sheet_of(&place).plans, plans);
    assert_int_equal(water[LIVE_WATER_WIDTH / 2], 255);                                            /* the top is gone */
    assert_int_equal(water[LIVE_WATER_WIDTH * (LIVE_WATER_HEIGHT - 1) + LIVE_WATER_WIDTH / 2], 0); /* the rest is dry */
    const struct live_view *plate = settle(&place); /* it has passed: planned once, with what it took */
    assert_int_equal(sheet_of(&place).plans, plans + 1);
    assert_true(plate->any && !sheet_of(&place).rinsed && plate->sequence >= sheet_of(&place).rinse);
    size_t top = 0, bottom = 0;
    for (size_t i = 0; i < WIDTH * HEIGHT; i++) {
        bool there = plate->plate.birth[i] < FLT_MAX && plate->plate.rgba[4 * i + 3] > 0;
        top += there && i < WIDTH * HEIGHT / 6;
        bottom += there && i > WIDTH * HEIGHT * 2 / 3;
    }
    assert_true(bottom > 100 && top < bottom / 50);
    struct action clear = action_default(ACTION_CLEAR);
    act(&place, &clear);
    plate = settle(&place);
    assert_false(plate->any);
    close_place(&place);
}

/* What was told live, as a journal; with another sheet before, and another scene. */
static struct bytes write_journal(struct place *place)
{
    struct journal_writer writer;
    struct journal_head head = {.version = "test", .engine = "cpu"};
    struct journal_sheet sheet = {.def = {.width = CELLS_X, .height = CELLS_Y}, .ink_count = 1};
    struct action stock = stock_of(place), few = few_endpoints(), plant = plant_at(0.5f, 0.5f);
    journal_begin(&writer, &head);
    snprintf(sheet.scene, sizeof sheet.scene, "paint");
    sheet.def.coefficients = coefficients_default();
    journal_sheet(&writer, 0, &sheet);
    journal_action(&writer, 50, &plant);
    snprintf(sheet.scene, sizeof sheet.scene, "trees");
    journal_scene(&writer, 80, &sheet);
    journal_action(&writer, 100, &stock);
    journal_action(&writer, 100, &few);
    plant = plant_at(0.3f, 0.9f);
    journal_action(&writer, 100, &plant);
    journal_scene(&writer, 101, &sheet); /* its file was edited */
    plant = plant_at(0.7f, 0.2f);
    journal_action(&writer, 102, &plant);
    journal_mark(&writer, 120);
    return writer.out;
}

static void it_comes_back_from_the_journal(void **state)
{
    (void)state;
    struct place place;
    open_place(&place);
    uint64_t want = mark_without(&place);
    struct bytes journal = write_journal(&place);
    assert_true(live_scene_resume(place.live, &place.trees, SCENE_TREES, "trees", journal.data, journal.size));
    live_scene_size(place.live, WIDTH, HEIGHT);
    const struct live_view *plate = settle(&place);
    assert_true(plate->any && mark_of(&plate->plate) == want);
    assert_int_equal((int)sheet_of(&place).tick, 120);
    assert_true(sheet_of(&place).kind == SCENE_TREES && sheet_of(&place).can_undo == UINT64_C(1) << VISITOR);
    place.ticked = 120;
    tell(&place, STUDIO_RESTORED, &place.trees, NULL); /* the studio has taken up the painting */
    assert_true(live_scene_is_calm(place.live));
    close_place(&place);

    open_place(&place);
    assert_true(
        live_scene_resume(place.live, &place.trees, SCENE_TREES, "trees", journal.data, journal.size - 3)); /* torn */
    live_scene_size(place.live, WIDTH, HEIGHT);
    plate = settle(&place);
    assert_true(plate->any && mark_of(&plate->plate) == want);
    close_place(&place);

    open_place(&place);
    assert_false(
        live_scene_resume(place.live, &place.trees, SCENE_TREES, "trees", NULL, 0)); /* none: an empty garden */
    live_scene_size(place.live, WIDTH, HEIGHT);
    plate = settle(&place);
    assert_true(!plate->any && sheet_of(&place).kind == SCENE_TREES);
    close_place(&place);
    bytes_finish(&journal);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(as_the_garden_without_a_thread),
        cmocka_unit_test(what_is_shown_stays_as_it_is),
        cmocka_unit_test(dragging_plans_six_times_a_second),
        cmocka_unit_test(undo_and_redo),
        cmocka_unit_test(sheets_and_scenes),
        cmocka_unit_test(water_runs_without_a_plan),
        cmocka_unit_test(it_comes_back_from_the_journal),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
