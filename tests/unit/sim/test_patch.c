/* What a history stands on: rectangles of a painting, tiles in 16 bits, which tiles have changed, the store. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <string.h>

#include "history_case.h"
#include "past.h"

static void a_patch_goes_out_and_back(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct patch patch;
    drop(&sheet, 1, 0.4f, 0.5f);
    run(&sheet, 60);
    uint64_t hash = hash_of(&sheet);
    assert_true(patch_init(&patch, 100 * 40));
    patch.cells = (struct rectangle){20, 97, 40, 77};
    assert_true(sheet.engine->ops->save_patch(sheet.engine, &patch));
    struct action dry = action_default(ACTION_DRY), mask = action_default(ACTION_MASK);
    dry.at = mask.at = (struct point){0.4f, 0.5f};
    dry.has_at = mask.has_at = true;
    dry.radius = mask.radius = 8;
    sheet.engine->ops->act(sheet.engine, &dry);
    sheet.engine->ops->act(sheet.engine, &mask);
    assert_true(hash_of(&sheet) != hash);
    assert_true(sheet.engine->ops->load_patch(sheet.engine, &patch));
    assert_true(hash_of(&sheet) == hash);
    patch.cells.x1 = WIDTH + 2 * MARGIN + 1;
    assert_false(sheet.engine->ops->save_patch(sheet.engine, &patch));
    assert_false(sheet.engine->ops->load_patch(sheet.engine, &patch));
    patch_finish(&patch);
    sheet_drop(&sheet);
}

/* What a tile is coded to comes back as dense, as deep and as coloured to a part in a thousand. */
static void a_tile_comes_back_nearly_as_it_was(void **state)
{
    (void)state;
    struct sheet sheet = sheet_make();
    struct patch patch, back;
    struct tile_code code;
    struct tile_values values;
    float share[TILE_CELLS];
    uint8_t all[TILE_CELLS];
    drop(&sheet, 1, 0.5f, 0.5f);
    run(&sheet, 80);
    assert_true(patch_init(&patch, TILE_CELLS) && patch_init(&back, TILE_CELLS));
    patch.cells = back.cells = (struct rectangle){80, 96, 48, 64};
    assert_true(sheet.engine->ops->save_patch(sheet.engine, &patch));
    tile_code_take(&code, &patch, 80, 48);
    tile_code_values(&code, &values);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        share[cell] = 1;
        all[cell] = 1;
    }
    tile_values_blend(&values, share, &back, 80, 48);
    tile_code_give_ground(&code, all, &back, 80, 48);
    assert_memory_equal(patch.ground, back.ground, TILE_CELLS * PATCH_GROUND * sizeof *patch.ground);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        float was = 0, is = 0;
        for (int i = 0; i < 9; i++) {
            was += patch_plane(&patch, CHECKPOINT_SOLVENT + i)[cell];
            is += patch_plane(&back, CHECKPOINT_SOLVENT + i)[cell];
        }
        assert_true(fabsf(was - is) <= 1e-3f * was + 1e-9f);
        assert_true(fabsf(patch_plane(&back, CHECKPOINT_DENSITY)[cell] - is) <= 1e-6f * is);
        for (int plane = CHECKPOINT_WET; plane < CHECKPOINT_DENSITY; plane++) {
            float a = patch_plane(&patch, plane)[cell], b = patch_plane(&back, plane)[cell];
            assert_true(fabsf(a - b) <= 5e-4f * a + 1e-9f);
        }
    }
    patch_finish(&patch);
    patch_finish(&back);
    sheet_drop(&sheet);
}

enum { COLUMNS = (WIDTH + 2 * MARGIN + TILE - 1) / TILE, ROWS = (HEIGHT + 2 * MARGIN + TILE - 1) / TILE };

/* Whatever changes in so many ticks lies in a tile that is said to have changed. Returns the tiles that are. */
static int assert_told(struct sheet *sheet, int ticks)
{
    uint8_t changed[COLUMNS * ROWS] = {0};
    int said = 0;
    look(sheet, &sheet->before);
    for (int tick = 0; tick < ticks; tick++) {
        sheet->engine->ops->tick(sheet->engine);
    }
    look(sheet, &sheet->after);
    assert_true(sheet->engine->ops->changed(sheet->engine, changed));
    for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
        const float *a = checkpoint_plane(&sheet->before, plane), *b = checkpoint_plane(&sheet->after, plane);
        for (int y = 0; y < sheet->before.height; y++) {
            for (int x = 0; x < sheet->before.width; x++) {
                int at = y * sheet->before.width + x;
                assert_true(changed[y / TILE * COLUMNS + x / TILE] || memcmp(&a[at], &b[at], sizeof *a) == 0);
            }
        }
    }
    for (int tile = 0; tile < COLUMNS * ROWS; tile++) {
        said += changed[tile];
    }
    return said;
}

/* What grows, what only dries, what only flows. */
static void tells_which_tiles_have_changed(void **state)
{
    (void)state;
    uint8_t changed[COLUMNS * ROWS] = {0};
    struct sheet sheet = sheet_make();
    struct action faint = action_default(ACTION_DROP), ink = action_default(ACTION_BRUSH_INK);
    struct point stroke[2] = {{0.4f, 0.45f}, {0.4f, 0.55f}};
    faint.at = (struct point){0.4f, 0.5f};
    faint.solvent = 6;
    act(&sheet, &faint);
    assert_true(sheet.engine->ops->changed(sheet.engine, changed));
    for (int i = 0; i < 4; i++) {
        int said = assert_told(&sheet, 1 + 20 * i);
        assert_true(said > 0 && said < COLUMNS * ROWS);
    }
    run(&sheet, 900);
    assert_true(sheet.engine->ops->changed(sheet.engine, changed));
    for (int i = 0; i < 60; i++) {
        assert_told(&sheet, 64);
    }
    ink.path = (struct action_path){stroke, 2};
    act(&sheet, &ink);
    assert_true(sheet.engine->ops->changed(sheet.engine, changed));
    for (int i = 0; i < 40; i++) {
        int said = assert_told(&sheet, 1);
        assert_true(said < COLUMNS * ROWS / 2);
    }
    sheet_drop(&sheet);
}

/* ---- the store */

/* A tile whose planes are even, but for two: one that is always the same, one that tells `what`. */
static void fill(struct tile_code *code, uint16_t what)
{
    memset(code, 0, sizeof *code);
    for (int cell = 0; cell < TILE_CELLS; cell++) {
        code->planes[CODE_CARVED][cell] = (uint16_t)(what + cell);
        code->planes[CODE_GROUND][cell] = (uint16_t)cell;
        code->planes[CODE_INK][cell] = what;
    }
}

static void assert_version(const struct past *past, uint32_t version, uint16_t what)
{
    struct tile_code code, wanted;
    fill(&wanted, what);
    past_read(past, version, &code);
    assert_memory_equal(&code, &wanted, sizeof code);
}

static void the_past_is_found_by_its_moment(void **state)
{
    (void)state;
    struct past *past = past_create(1 << 20, 4);
    struct tile_code code;
    uint16_t extra[TILE_CELLS] = {7, 8};
    assert_non_null(past);
    for (uint16_t i = 1; i <= 5; i++) {
        fill(&code, (uint16_t)(100 * i));
        assert_true(past_keep(past, 2, &code, 10u * i, i == 3 ? 77 : 0));
        size_t used = past_used(past);
        assert_true(past_keep(past, 2, &code, 10u * i + 5, 0)); /* nothing has changed */
        assert_int_equal(past_used(past), used);
    }
    assert_version(past, past_find(past, 2, 39), 300);
    assert_version(past, past_find(past, 2, 40), 400);
    assert_version(past, past_find(past, 2, 4000), 500);
    assert_version(past, past_find(past, 2, 1), 100); /* the first stands for all before */
    assert_version(past, past_find_of(past, 2, 77), 300);
    assert_int_equal(past_find_of(past, 2, 78), PAST_NONE);
    assert_int_equal(past_find(past, 1, 4000), PAST_NONE);
    assert_int_equal(past_horizon(past), 0);
    uint32_t copy = past_copy(past, past_find(past, 2, 20), extra);
    past_age(past, 41); /* those succeeded before */
    assert_int_equal(past_find(past, 2, 39), PAST_NONE);
    assert_version(past, past_find(past, 2, 40), 400);
    assert_int_equal(past_horizon(past), 40);
    assert_version(past, copy, 200); /* a copy stays */
    uint16_t back[TILE_CELLS];
    past_read_extra(past, copy, back);
    assert_memory_equal(back, extra, sizeof back);
    past_release(past, copy);
    past_clear(past);
    assert_int_equal(past_used(past), 0);
    past_destroy(past);
}

static void a_full_store_lets_the_oldest_go(void **state)
{
    (void)state;
    enum { TILES = 6 };
    struct past *past = past_create(100000, TILES);
    struct tile_code code;
    uint32_t copies[64];
    int copied = 0;
    uint16_t extra[TILE_CELLS] = {1};
    assert_non_null(past);
    for (uint16_t i = 1; i <= 3000; i++) {
        int tile = i % TILES;
        fill(&code, i);
        assert_true(past_keep(past, tile, &code, i, 0));
        assert_version(past, past_newest(past, tile), i);
        assert_true(past_used(past) <= 100000);
    }
    assert_true(past_horizon(past) > 2500 && past_horizon(past) < 3000);
    assert_version(past, past_find(past, 2999 % TILES, past_horizon(past) + TILES),
                   (uint16_t)past_moment(past, past_find(past, 2999 % TILES, past_horizon(past) + TILES)));
    while (copied < 64 && past_newest(past, copied % TILES) != PAST_NONE &&
           (copies[copied] = past_copy(past, past_newest(past, copied % TILES), extra)) != PAST_NONE) {
        copied++;
        fill(&code, (uint16_t)(5000 + copied));
        past_keep(past, copied % TILES, &code, (uint32_t)(5000 + copied), 0);
    }
    for (uint16_t i = 0; i < 200; i++) { /* full of what cannot go, or not: never beyond its bytes */
        fill(&code, (uint16_t)(9000 + i));
        past_keep(past, i % TILES, &code, 9000u + i, 0);
        assert_true(past_used(past) <= 100000);
    }
    for (int i = 0; i < copied; i++) {
        past_release(past, copies[i]);
    }
    for (int i = 0; i < TILES; i++) {
        fill(&code, (uint16_t)(20000 + i));
        assert_true(past_keep(past, i, &code, (uint32_t)(20000 + i), 0));
        assert_version(past, past_newest(past, i), (uint16_t)(20000 + i));
    }
    past_destroy(past);
    assert_null(past_create(1000, TILES));
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_patch_goes_out_and_back),       cmocka_unit_test(a_tile_comes_back_nearly_as_it_was),
        cmocka_unit_test(tells_which_tiles_have_changed),  cmocka_unit_test(the_past_is_found_by_its_moment),
        cmocka_unit_test(a_full_store_lets_the_oldest_go),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
