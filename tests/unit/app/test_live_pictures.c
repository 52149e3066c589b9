/* Stock pictures, one after the other, read in a thread (app/live/live_pictures.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>

#include "folder_case.h"
#include "live_pictures.h"
#include "patience.h"

enum { FILES = 4 };

static const char *const NAMES[FILES] = {"a.png", "b.png", "broken.png", "c.png"};

struct shelf {
    char folder[FOLDER_CASE_PATH];
    atomic_int loads;
    struct exhibit exhibit;
    struct exhibit_scene painting, trees, own;
    struct live_pictures *pictures;
};

/* Grey as its letter, 0.1 for a; "wide" is larger than what is given. */
static bool load(void *data, const char *folder, const char *path, struct script_picture *picture,
                 struct file_error *error)
{
    struct shelf *shelf = data;
    const char *slash = strrchr(path, '/'), *name = slash ? slash + 1 : path;
    bool wide = strcmp(name, "wide.png") == 0;
    (void)folder;
    atomic_fetch_add(&shelf->loads, 1);
    if (strcmp(name, "broken.png") == 0) {
        snprintf(error->text, sizeof error->text, "'%s' is broken", path);
        return false;
    }
    *picture = (struct script_picture){wide ? 3000 : 30, wide ? 1500 : 20, 1, NULL};
    size_t count = (size_t)picture->width * (size_t)picture->height;
    picture->values = malloc(count * sizeof *picture->values);
    for (size_t i = 0; picture->values && i < count; i++) {
        picture->values[i] = wide ? 0.9f : 0.1f * (float)(name[0] - 'a' + 1);
    }
    return picture->values;
}

static struct shelf *open_shelf(bool folder, const struct exhibit_scene *scene)
{
    struct shelf *shelf = calloc(1, sizeof *shelf);
    char path[128];
    assert_non_null(shelf);
    assert_true(folder_case_make(shelf->folder));
    snprintf(path, sizeof path, "%s/in", shelf->folder);
    assert_int_equal(mkdir(path, 0700), 0);
    for (int i = 0; i < FILES; i++) {
        snprintf(path, sizeof path, "%s/in/%s", shelf->folder, NAMES[i]);
        assert_true(folder_case_put(path, ""));
    }
    shelf->exhibit.folder = shelf->folder;
    shelf->exhibit.pictures = folder ? "in" : NULL;
    shelf->trees.kind = shelf->own.kind = SCENE_TREES;
    shelf->own.picture = "wide.png";
    struct script_def def = script_default_def();
    def.load = load;
    def.data = shelf;
    shelf->pictures = live_pictures_create(&shelf->exhibit, scene ? scene : &shelf->trees, &def);
    assert_non_null(shelf->pictures);
    return shelf;
}

static void close_shelf(struct shelf *shelf)
{
    live_pictures_destroy(shelf->pictures);
    assert_true(folder_case_remove(shelf->folder));
    free(shelf);
}

static void nap(void)
{
    nanosleep(&(struct timespec){.tv_nsec = 1000000}, NULL);
}

/* Asks as often as a kiosk does; the brightness of what comes, -1 when nothing does. */
static float ask(struct shelf *shelf, bool next, struct action *stock)
{
    for (int i = 0; i < PATIENCE_MS; i++) {
        if (live_pictures_stock(shelf->pictures, next, stock)) {
            assert_int_equal(stock->verb, ACTION_STOCK);
            assert_int_equal(stock->picture.channels, 1);
            return stock->picture.values[0];
        }
        nap();
    }
    return -1;
}

static void each_comes_in_turn_and_a_broken_one_is_a_line(void **state)
{
    (void)state;
    static const float TURN[] = {0.2f, 0.3f, 0.1f, 0.2f};
    struct shelf *shelf = open_shelf(true, NULL);
    struct action stock;
    char line[400];
    int lines = 0;
    assert_float_equal(ask(shelf, false, &stock), 0.1, 1e-4);
    const float *first = stock.picture.values;
    assert_float_equal(ask(shelf, false, &stock), 0.1, 1e-4); /* the same, and at once */
    assert_ptr_equal(stock.picture.values, first);
    assert_true(stock.picture.width == 30 && stock.picture.height == 20);
    for (size_t i = 0; i < sizeof TURN / sizeof *TURN; i++) {
        assert_float_equal(ask(shelf, true, &stock), TURN[i], 1e-4);
        assert_true(i > 2 || fabsf(*first - 0.1f) < 1e-4f); /* it stays good for a while */
        while (live_pictures_log(shelf->pictures, line, sizeof line)) {
            assert_string_equal(line, "picture left out: 'in/broken.png' is broken");
            lines++;
        }
    }
    assert_int_equal(lines, 1);
    close_shelf(shelf);
}

static void a_scene_has_its_own_first(void **state)
{
    (void)state;
    struct shelf *shelf = open_shelf(true, NULL);
    struct action stock;
    assert_float_equal(ask(shelf, false, &stock), 0.1, 1e-4);
    live_pictures_scene(shelf->pictures, &shelf->own);
    assert_float_equal(ask(shelf, false, &stock), 0.9, 1e-3);
    assert_true(stock.picture.width == 1024 && stock.picture.height == 512);
    live_pictures_scene(shelf->pictures, &shelf->own); /* an edit of something else */
    assert_true(live_pictures_stock(shelf->pictures, false, &stock));
    float next = ask(shelf, true, &stock);
    assert_true(next > 0.05f && next < 0.35f); /* then those of the folder */
    close_shelf(shelf);
}

static void without_a_folder_there_is_the_one(void **state)
{
    (void)state;
    struct shelf *shelf = open_shelf(false, &(struct exhibit_scene){.kind = SCENE_TREES, .picture = "b.png"});
    struct action stock;
    assert_float_equal(ask(shelf, false, &stock), 0.2, 1e-4);
    for (int i = 0; i < 20; i++) {
        assert_false(live_pictures_stock(shelf->pictures, true, &stock));
        nap();
    }
    assert_int_equal(atomic_load(&shelf->loads), 1);
    assert_true(live_pictures_stock(shelf->pictures, false, &stock));
    close_shelf(shelf);
}

static void where_all_are_broken_it_gives_up(void **state)
{
    (void)state;
    struct shelf *shelf = open_shelf(false, &(struct exhibit_scene){.kind = SCENE_TREES, .picture = "broken.png"});
    struct action stock;
    for (int i = 0; i < 50; i++) {
        assert_false(live_pictures_stock(shelf->pictures, i % 2, &stock));
        nap();
    }
    assert_int_equal(atomic_load(&shelf->loads), 1);
    close_shelf(shelf);
}

static void a_painting_grows_along_their_edges(void **state)
{
    (void)state;
    struct shelf *shelf = open_shelf(true, &(struct exhibit_scene){.kind = SCENE_PAINTING});
    struct action guide;
    int i = 0;
    while (i < PATIENCE_MS && !live_pictures_next(shelf->pictures, &guide)) {
        nap();
        i++;
    }
    assert_true(i < PATIENCE_MS && guide.verb == ACTION_GUIDE && guide.picture.channels == 2);
    close_shelf(shelf);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(each_comes_in_turn_and_a_broken_one_is_a_line),
        cmocka_unit_test(a_scene_has_its_own_first),
        cmocka_unit_test(without_a_folder_there_is_the_one),
        cmocka_unit_test(where_all_are_broken_it_gives_up),
        cmocka_unit_test(a_painting_grows_along_their_edges),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
