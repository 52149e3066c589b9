/* Where the palette's buttons are (app/hud/hud_layout.h): every screen, side, hand, language, number of seats and
 * tools. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <string.h>

#include "hud_case.h"
#include "hud_layout.h"
#include "hud_map.h"

static bool touching(const struct hud_button *a, const struct hud_button *b, float gap)
{
    return a->x < b->x + b->width + gap && b->x < a->x + a->width + gap && a->y < b->y + b->height + gap &&
           b->y < a->y + a->height + gap;
}

/* Sizes in mm against what a hand needs; places against the zone and what is within reach. */
static void check_panel(const struct hud *hud, const struct hud_screen *screen, int panel)
{
    const struct hud_panel *of = &hud->panels[panel];
    const struct exhibit *exhibit = hud->def.exhibit;
    const float *zone = exhibit->seats[panel].zone;
    float mm = (float)screen->columns / screen->width, wide = (float)screen->columns, high = (float)screen->rows;
    float few = 0.01f;
    assert_true(of->count > 0);
    assert_true(of->x >= zone[0] * wide && of->x + of->width <= zone[2] * wide + few);
    assert_true(of->y >= zone[1] * high && of->y + of->height <= zone[3] * high + few);
    assert_true(of->width * of->height <= 0.25f * (zone[2] - zone[0]) * wide * (zone[3] - zone[1]) * high);
    for (int i = 0; i < of->count; i++) {
        const struct hud_button *button = &of->buttons[i];
        assert_true(button->width >= exhibit->palette.target * mm && button->height >= exhibit->palette.target * mm);
        assert_true(button->x >= of->x && button->x + button->width <= of->x + of->width);
        assert_true(button->y >= of->y && button->y + button->height <= of->y + of->height);
        for (int k = 0; k < i; k++) {
            assert_false(touching(button, &of->buttons[k], 3 * mm - few));
        }
        /* By the rows of pixels that a screen of that height has. */
        float low = (high - button->y - button->height) / mm, top = (high - button->y) / mm;
        if (screen->lying) {
            assert_true(top <= 600 + few);
        } else {
            assert_true(exhibit->display.floor + low >= 380 - few && exhibit->display.floor + top <= 1220 + few);
        }
    }
}

static struct event finger(enum event_kind kind, const struct hud *hud, float x, float y)
{
    return (struct event){.kind = kind,
                          .source = SOURCE_TOUCH,
                          .time_us = 5000000,
                          .x = x / (float)hud->def.width,
                          .y = y / (float)hud->def.height};
}

/* A press in the middle of each button is that button's; places beside the strip are nobody's. */
static void touch_all(const struct hud *hud, int panel)
{
    struct hud_press press;
    bool pressed;
    const struct hud_panel *of = &hud->panels[panel];
    for (int i = 0; i < of->count; i++) {
        const struct hud_button *button = &of->buttons[i];
        struct hud copy = *hud;
        copy.panels[panel].can_undo = copy.panels[panel].can_redo = true;
        float x = button->x + 0.5f * button->width, y = button->y + 0.5f * button->height;
        struct event down = finger(EVENT_DOWN, hud, x, y), up = finger(EVENT_UP, hud, x, y);
        assert_true(hud_feel(&copy, &down, &press, &pressed));
        assert_false(pressed);
        assert_true(hud_pressed(&copy, panel, i));
        assert_true(hud_feel(&copy, &up, &press, &pressed));
        if (button->folded) {
            assert_false(pressed);
            assert_int_equal(copy.panels[panel].open, button->kind);
        } else if (button->kind == HUD_MORE) {
            assert_true(!pressed && copy.panels[panel].open == -1);
        } else {
            assert_true(pressed && press.seat == panel && press.kind == button->kind);
        }
    }
    const float beside[][2] = {{of->x - 2, of->y + 5},
                               {of->x + of->width + 2, of->y + 5},
                               {of->x + 5, of->y - 2},
                               {of->x + 5, of->y + of->height + 2}};
    for (int i = 0; i < 4; i++) {
        struct hud copy = *hud;
        struct event down = finger(EVENT_DOWN, hud, beside[i][0], beside[i][1]);
        assert_false(hud_feel(&copy, &down, &press, &pressed) || pressed);
    }
}

/* Whether every choice of a kind is on the panel, or in the group behind a folded button. */
static void find_kind(const struct hud *hud, int panel, enum hud_kind kind, int value, enum hud_kind group)
{
    const struct hud_panel *of = &hud->panels[panel];
    for (int i = 0; i < of->count; i++) {
        if (of->buttons[i].folded && of->buttons[i].kind == group) {
            struct hud copy = *hud;
            struct hud_press press;
            assert_false(hud_press(&copy, panel, i, 0, &press));
            assert_int_equal(copy.panels[panel].open, group);
            of = &copy.panels[panel];
            for (int k = 0; k < of->count; k++) {
                if (of->buttons[k].kind == kind && (kind == HUD_LANGUAGE || of->buttons[k].value == value)) {
                    return;
                }
            }
            fail_msg("kind %d value %d is not behind its group", kind, value);
        }
        if (of->buttons[i].kind == kind && (kind == HUD_LANGUAGE || of->buttons[i].value == value)) {
            return;
        }
    }
    fail_msg("kind %d value %d is nowhere", kind, value);
}

static void find_all(const struct hud *hud, int panel)
{
    const struct exhibit_palette *palette = &hud->def.exhibit->palette;
    for (int i = 0; i < hud_inks(hud); i++) {
        find_kind(hud, panel, HUD_INK, i, HUD_INK);
    }
    int kind = hud_kind_of_scene(hud), first = (int)tool_first(kind);
    for (int i = 0; i < TOOLS && palette->tools[first + 1]; i++) {
        if (palette->tools[i] && tool_fits(i, kind)) {
            find_kind(hud, panel, HUD_TOOL, i, HUD_TOOL);
        }
    }
    if (kind == SCENE_TREES) {
        find_kind(hud, panel, HUD_PICTURE, 0, HUD_PICTURE);
    }
    if (kind != SCENE_PAINTING) {
        find_kind(hud, panel, HUD_METAPHOR, 0, HUD_PICTURE);
    }
    find_kind(hud, panel, HUD_UNDO, 0, HUD_KINDS);
    find_kind(hud, panel, HUD_REDO, 0, HUD_KINDS);
    find_kind(hud, panel, HUD_FINISH, 0, HUD_KINDS);
    find_kind(hud, panel, HUD_HAND, 0, HUD_MORE);
    find_kind(hud, panel, HUD_SEATED, 0, HUD_MORE);
    find_kind(hud, panel, HUD_LANGUAGE, 0, HUD_MORE);
}

static void check_hud(struct hud *hud, const struct hud_screen *screen)
{
    hud_show(hud, true, 0);
    for (int panel = 0; panel < hud->count; panel++) {
        check_panel(hud, screen, panel);
        find_all(hud, panel);
        touch_all(hud, panel);
        for (int i = 0; i < hud->panels[panel].count; i++) {
            if (hud->panels[panel].buttons[i].folded) {
                struct hud copy = *hud;
                struct hud_press press;
                hud_press(&copy, panel, i, 0, &press);
                check_panel(&copy, screen, panel);
                touch_all(&copy, panel);
            }
        }
    }
}

static void check_language(struct hud *hud, const struct hud_screen *screen, int language)
{
    for (int hand = 0; hand < 2; hand++) {
        hud->language = language;
        for (int panel = 0; panel < hud->count; panel++) {
            hud->panels[panel].swapped = hand == 1;
        }
        hud_layout(hud);
        check_hud(hud, screen);
    }
}

static void everything_fits_on_every_screen(void **state)
{
    (void)state;
    for (int s = 0; s < HUD_SCREENS; s++) {
        for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
            for (int tools = 1; tools <= TOOLS; tools++) { /* in a scene of the last one's kind */
                struct hud_case place;
                struct hud hud;
                hud_case_init(&place, &hud_screens[s], (enum exhibit_side)side);
                for (int i = tools; i < TOOLS; i++) {
                    place.exhibit.palette.tools[i] = false;
                }
                place.exhibit.scenes[0].kind = (int)exhibit_tool_kinds[tools - 1];
                place.exhibit.pictures = "pictures";
                place.exhibit.palette.target = tools % 2 ? 15 : 18;
                struct hud_def def = hud_case_def(&place, &hud_screens[s]);
                hud_init(&hud, &def);
                for (int language = 0; language < 4; language++) {
                    check_language(&hud, &hud_screens[s], language);
                }
            }
        }
    }
}

static void seats_have_palettes_of_their_own(void **state)
{
    static const struct {
        int screen, seats;
        bool rows;
    } CASES[] = {{3, 2, false}, {3, 3, false}, {4, 2, false}, {4, 4, false}, {4, 4, true},
                 {4, 8, true},  {5, 4, true},  {5, 6, true},  {2, 2, true},  {1, 2, false}};
    (void)state;
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
            const struct hud_screen *screen = &hud_screens[CASES[i].screen];
            struct hud_case place;
            struct hud hud;
            hud_case_init(&place, screen, (enum exhibit_side)side);
            hud_case_seats(&place, CASES[i].seats, CASES[i].rows, (enum exhibit_side)side);
            struct hud_def def = hud_case_def(&place, screen);
            hud_init(&hud, &def);
            assert_int_equal(hud.count, CASES[i].seats);
            for (int language = 0; language < 4; language += 2) {
                check_language(&hud, screen, language);
            }
        }
    }
}

static unsigned next_chance(unsigned *seed)
{
    *seed = *seed * 1664525 + 1013904223;
    return *seed >> 8;
}

/* Zones and wishes of all kinds: what the curator wants gives way to 15 mm, and nothing is lost where a child would
 * still paint. */
static void any_exhibit_has_room(void **state)
{
    (void)state;
    unsigned seed = 5;
    for (int i = 0; i < 3000; i++) {
        struct hud_screen screen = {"any", 0, 0, 0, 0, next_chance(&seed) % 2 == 0};
        screen.width = 100 + (float)(next_chance(&seed) % 900);
        screen.height = 86 + (float)(next_chance(&seed) % 500);
        float density = 1.5f + 0.01f * (float)(next_chance(&seed) % 800);
        screen.columns = (int)(screen.width * density);
        screen.rows = (int)(screen.height * density);
        struct hud_case place;
        struct hud hud;
        hud_case_init(&place, &screen, (enum exhibit_side)(next_chance(&seed) % 3));
        place.exhibit.palette.target = 15 + (float)(next_chance(&seed) % 46);
        place.exhibit.display.floor = (float)(next_chance(&seed) % 900);
        for (int k = 1; k < TOOLS; k++) {
            place.exhibit.palette.tools[k] = next_chance(&seed) % 3 > 0;
        }
        place.exhibit.palette.undo = next_chance(&seed) % 4 > 0;
        place.exhibit.palette.hand = next_chance(&seed) % 2 > 0;
        place.exhibit.palette.language = next_chance(&seed) % 2 > 0;
        struct hud_def def = hud_case_def(&place, &screen);
        hud_init(&hud, &def);
        hud_show(&hud, true, 0);
        place.exhibit.palette.target = 15; /* of what is checked */
        float mm = hud.mm;
        const struct hud_panel *panel = &hud.panels[0];
        assert_true(panel->count >= 3);
        for (int k = 0; k < panel->count; k++) {
            assert_true(panel->buttons[k].width >= 15 * mm && panel->buttons[k].height >= 15 * mm);
            assert_true(panel->buttons[k].x >= 0 && panel->buttons[k].y >= 0);
            for (int j = 0; j < k; j++) {
                assert_false(touching(&panel->buttons[k], &panel->buttons[j], 3 * mm - 0.01f));
            }
        }
        assert_true(panel->x >= 0 && panel->x + panel->width <= (float)screen.columns);
        assert_true(panel->y >= 0 && panel->y + panel->height <= (float)screen.rows);
        find_kind(&hud, 0, HUD_FINISH, 0, HUD_KINDS);
        find_kind(&hud, 0, HUD_SEATED, 0, HUD_MORE);
        touch_all(&hud, 0);
    }
}

static void it_is_at_its_side_and_changes_hands(void **state)
{
    (void)state;
    const struct hud_screen *screen = &hud_screens[3];
    struct hud_case place;
    struct hud hud;
    hud_case_init(&place, screen, SIDE_OF_LEFT);
    struct hud_def def = hud_case_def(&place, screen);
    hud_init(&hud, &def);
    const struct hud_panel *panel = &hud.panels[0];
    float mm = hud.mm;
    assert_true(panel->side == SIDE_OF_LEFT && panel->x <= 3 * mm && panel->labels);
    hud.panels[0].swapped = true;
    hud_layout(&hud);
    assert_true(panel->side == SIDE_OF_RIGHT && panel->x + panel->width >= 1920 - 3 * mm);
    place.exhibit.seats[0].side = SIDE_OF_BOTTOM;
    hud_layout(&hud);
    assert_true(panel->side == SIDE_OF_BOTTOM && panel->y + panel->height >= 1080 - 3 * mm);
    float swapped = panel->buttons[0].x;
    hud.panels[0].swapped = false;
    hud_layout(&hud);
    assert_true(panel->buttons[0].x < panel->x + 0.5f * panel->width && swapped > panel->x + 0.5f * panel->width);
    place.exhibit.seats[0].side = SIDE_OF_NONE;
    hud_layout(&hud);
    assert_int_equal(panel->count, 0);
}

static void arabic_begins_at_the_right(void **state)
{
    (void)state;
    for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
        struct hud_case place;
        struct hud hud;
        hud_case_init(&place, &hud_screens[1], (enum exhibit_side)side);
        struct hud_def def = hud_case_def(&place, &hud_screens[1]);
        hud_init(&hud, &def);
        const struct hud_panel *panel = &hud.panels[0];
        assert_true(panel->lines == 2);
        int next = side == SIDE_OF_BOTTOM ? 2 : 1;
        assert_true(panel->buttons[0].x < panel->buttons[next].x);
        hud.language = words_find("ar");
        hud_layout(&hud);
        assert_true(panel->buttons[0].kind == HUD_INK && panel->buttons[0].value == 0);
        assert_true(panel->buttons[0].x > panel->buttons[next].x);
    }
}

static void it_hangs_where_a_wheelchair_reaches(void **state)
{
    (void)state;
    static const float FLOORS[] = {0, 200, 350, 600, 800, 1000, 1120};
    for (size_t i = 0; i < sizeof FLOORS / sizeof FLOORS[0]; i++) {
        for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
            struct hud_case place;
            struct hud hud;
            hud_case_init(&place, &hud_screens[2], (enum exhibit_side)side);
            place.exhibit.display.floor = FLOORS[i];
            struct hud_def def = hud_case_def(&place, &hud_screens[2]);
            hud_init(&hud, &def);
            check_hud(&hud, &hud_screens[2]);
        }
    }
    /* Beyond all reach: as low as it can be. */
    struct hud_case place;
    struct hud hud;
    hud_case_init(&place, &hud_screens[2], SIDE_OF_LEFT);
    place.exhibit.display.floor = 1500;
    struct hud_def def = hud_case_def(&place, &hud_screens[2]);
    hud_init(&hud, &def);
    assert_true(hud.panels[0].count > 0 && hud.panels[0].y > 0.8f * 1920);
}

static void a_table_has_its_palette_near_its_visitor(void **state)
{
    (void)state;
    const struct hud_screen deep = {"deep table", 1000, 1800, 1080, 1944, true};
    struct hud_case place;
    struct hud hud;
    hud_case_init(&place, &deep, SIDE_OF_LEFT);
    struct hud_def def = hud_case_def(&place, &deep);
    hud_init(&hud, &def);
    check_hud(&hud, &deep);
    hud_case_seats(&place, 2, true, SIDE_OF_RIGHT); /* one opposite the other: zones above each other */
    hud_init(&hud, &def);
    for (int i = 0; i < hud.panels[0].count; i++) {
        const struct hud_button *button = &hud.panels[0].buttons[i];
        assert_true((button->y + button->height) / hud.mm <= 600);
    }
}

static void seated_it_is_in_their_zone(void **state)
{
    (void)state;
    for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
        struct hud_case place;
        struct hud hud;
        hud_case_init(&place, &hud_screens[3], (enum exhibit_side)side);
        place.exhibit.access.zone[0] = 0.2f;
        place.exhibit.access.zone[2] = 0.8f;
        struct hud_def def = hud_case_def(&place, &hud_screens[3]);
        hud_init(&hud, &def);
        hud.seated = true;
        hud_layout(&hud);
        check_hud(&hud, &hud_screens[3]);
        const struct hud_panel *panel = &hud.panels[0];
        assert_true(panel->x >= 0.2f * 1920 && panel->x + panel->width <= 0.8f * 1920);
        assert_true(panel->y >= 0.5f * 1080 && panel->y + panel->height <= 1080);
    }
}

static void what_is_not_offered_is_not_there(void **state)
{
    (void)state;
    struct hud_case place;
    struct hud hud;
    hud_case_init(&place, &hud_screens[3], SIDE_OF_LEFT);
    struct exhibit_palette *palette = &place.exhibit.palette;
    memset(palette->tools, 0, sizeof palette->tools);
    palette->undo = palette->hand = palette->seated = palette->language = false;
    place.exhibit.seats[0].ink = 2;
    struct hud_def def = hud_case_def(&place, &hud_screens[3]);
    hud_init(&hud, &def);
    assert_int_equal(hud.panels[0].count, 1);
    assert_int_equal(hud.panels[0].buttons[0].kind, HUD_FINISH);
    assert_int_equal(hud.panels[0].ink, 2);
    palette->language = true;
    place.exhibit.language_count = 1;
    palette->finish = false;
    hud_layout(&hud);
    assert_int_equal(hud.panels[0].count, 0);
    /* A scene of fewer inks, a tool that is no longer there: the first. */
    hud_case_init(&place, &hud_screens[3], SIDE_OF_LEFT);
    hud_init(&hud, &def);
    hud.panels[0].ink = 3;
    hud.panels[0].tool = TOOL_MASK;
    hud_layout(&hud);
    assert_true(hud.panels[0].ink == 3 && hud.panels[0].tool == TOOL_MASK);
    place.script.ink_count = 2;
    palette->tools[TOOL_MASK] = false;
    hud_layout(&hud);
    assert_true(hud.panels[0].ink == 0 && hud.panels[0].tool == TOOL_DROP);
}

static void the_staff_have_two_large_buttons(void **state)
{
    (void)state;
    for (int i = 0; i < HUD_SCREENS; i++) {
        struct hud_case place;
        struct hud hud;
        hud_case_init(&place, &hud_screens[i], SIDE_OF_LEFT);
        struct hud_def def = hud_case_def(&place, &hud_screens[i]);
        hud_init(&hud, &def);
        assert_true(hud.staff[0].kind == HUD_BACK && hud.staff[1].kind == HUD_EXIT);
        assert_false(touching(&hud.staff[0], &hud.staff[1], 3 * hud.mm));
        for (int k = 0; k < 2; k++) {
            const struct hud_button *button = &hud.staff[k];
            assert_true(button->width >= 30 * hud.mm && button->height >= 15 * hud.mm && button->x >= 0);
            assert_true(button->y >= 0 && button->x + button->width <= (float)hud_screens[i].columns);
            assert_true(button->y + button->height <= (float)hud_screens[i].rows);
        }
    }
}

/* Beside its palette, on its seat's part of the sheet, large enough for a fingertip to tell patterns apart. */
static void check_map(const struct hud *hud, const struct hud_screen *screen, int panel)
{
    const struct hud_panel *of = &hud->panels[panel];
    const float *zone = hud->def.exhibit->seats[panel].zone;
    float place[4], mm = (float)screen->columns / screen->width, few = 1.5f;
    assert_true(hud_map_place(hud, panel, place));
    assert_true(place[2] >= 40 * mm && place[2] <= 150 * mm + few);
    assert_true(place[0] >= zone[0] * (float)screen->columns - few);
    assert_true(place[0] + place[2] <= zone[2] * (float)screen->columns + few);
    assert_true(place[1] >= zone[1] * (float)screen->rows - few);
    assert_true(place[1] + place[3] <= zone[3] * (float)screen->rows + few);
    bool across = place[0] < of->x + of->width && of->x < place[0] + place[2];
    bool down = place[1] < of->y + of->height && of->y < place[1] + place[3];
    assert_false(across && down);
    struct hud copy = *hud;
    struct hud_press press;
    bool pressed;
    int options[2];
    float rates[2];
    float x = place[0] + 0.5f * place[2], y = place[1] + 0.4f * place[3];
    struct event down_there = finger(EVENT_DOWN, hud, x, y), up = finger(EVENT_UP, hud, x, y);
    assert_true(hud_feel(&copy, &down_there, &press, &pressed) && !pressed);
    assert_true(hud_map_picked(&copy, panel, options, rates) && rates[0] > 0.01f && rates[1] > 0.03f);
    assert_true(hud_feel(&copy, &up, &press, &pressed) && !pressed);
    assert_false(hud_map_picked(&copy, panel, options, rates));
}

static void the_map_lies_beside_its_palette(void **state)
{
    (void)state;
    for (int s = 0; s < HUD_SCREENS; s++) {
        for (int side = SIDE_OF_LEFT; side <= SIDE_OF_BOTTOM; side++) {
            struct hud_case place;
            struct hud hud;
            hud_case_init(&place, &hud_screens[s], (enum exhibit_side)side);
            place.exhibit.scenes[0].kind = SCENE_CHEMISTRY;
            hud_case_seats(&place, hud_screens[s].width > 500 ? 2 : 1, false, (enum exhibit_side)side);
            struct hud_def def = hud_case_def(&place, &hud_screens[s]);
            hud_init(&hud, &def);
            hud_show(&hud, true, 0);
            for (int panel = 0; panel < hud.count; panel++) {
                float none[4];
                assert_false(hud_map_place(&hud, panel, none));
                hud_choose(&hud, panel, TOOL_MAP, -1);
                check_map(&hud, &hud_screens[s], panel);
            }
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(everything_fits_on_every_screen),
        cmocka_unit_test(seats_have_palettes_of_their_own),
        cmocka_unit_test(any_exhibit_has_room),
        cmocka_unit_test(it_is_at_its_side_and_changes_hands),
        cmocka_unit_test(arabic_begins_at_the_right),
        cmocka_unit_test(it_hangs_where_a_wheelchair_reaches),
        cmocka_unit_test(a_table_has_its_palette_near_its_visitor),
        cmocka_unit_test(seated_it_is_in_their_zone),
        cmocka_unit_test(what_is_not_offered_is_not_there),
        cmocka_unit_test(the_staff_have_two_large_buttons),
        cmocka_unit_test(the_map_lies_beside_its_palette),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
