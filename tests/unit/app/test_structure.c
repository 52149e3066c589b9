/* A structure over a picture as a raster, and what scripts make of it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "motif.h"
#include "pictures.h"
#include "structure.h"

enum { SIDE = 128, WIDE = 160, HIGH = 100, LEFT = (WIDE - HIGH) / 2 };

static struct script_picture portrait(void)
{
    struct script_picture picture = {SIDE, SIDE, 3, malloc(3 * SIDE * SIDE * sizeof(float))};
    assert_non_null(picture.values);
    motif_draw(MOTIF_PORTRAIT, SIDE, SIDE, picture.values);
    return picture;
}

static const struct structure_def DEF = {.detail = SIDE, .width = 0, .fade = 4};

static struct growth_def growth_of_it(void)
{
    struct growth_def growth = growth_preset(METAPHOR_INK, false);
    growth.endpoints = 300;
    return growth;
}

static float *make(const struct growth_def *growth, const struct structure_def *def, enum structure_kind kind)
{
    struct script_picture picture = portrait();
    const struct image image = pictures_image(&picture);
    float *values = calloc((size_t)2 * WIDE * HIGH, sizeof *values);
    assert_true(structure_raster(&image, growth, def, kind, WIDE, HIGH, values));
    free(picture.values);
    return values;
}

static double dark_of(const float *values)
{
    double sum = 0;
    for (int i = 0; i < WIDE * HIGH; i++) {
        assert_true(values[i] >= 0 && values[i] <= 1);
        assert_float_equal(values[i] * 65536, nearbyintf(values[i] * 65536), 0);
        sum += 1 - (double)values[i];
    }
    return sum;
}

static void branches_are_dark_and_lie_in_the_middle(void **state)
{
    (void)state;
    struct growth_def growth = growth_of_it();
    float *values = make(&growth, &DEF, STRUCTURE_DARK), *again = make(&growth, &DEF, STRUCTURE_DARK);
    double dark = dark_of(values);
    assert_true(dark > 0.05 * HIGH * HIGH && dark < 0.6 * HIGH * HIGH);
    assert_memory_equal(values, again, (size_t)WIDE * HIGH * sizeof *values);
    for (int y = 0; y < HIGH; y++) {
        for (int x = 0; x < WIDE; x++) {
            assert_true((x >= LEFT - 2 && x < LEFT + HIGH + 2) || values[y * WIDE + x] == 1);
        }
    }
    free(again);
    free(values);
}

static void they_can_be_wider(void **state)
{
    (void)state;
    struct growth_def growth = growth_of_it();
    struct structure_def wide = DEF;
    wide.width = 3;
    float *thin = make(&growth, &DEF, STRUCTURE_DARK), *thick = make(&growth, &wide, STRUCTURE_DARK);
    assert_true(dark_of(thick) > 1.5 * dark_of(thin));
    for (int i = 0; i < WIDE * HIGH; i++) {
        assert_true(thick[i] <= thin[i] + 1e-4f);
    }
    free(thin);
    free(thick);
}

/* Of length 1 on the branches, nothing far away; and mostly away from the seed, which is at the foot of the picture. */
static void they_tell_where_they_grow(void **state)
{
    (void)state;
    struct growth_def growth = growth_of_it();
    growth.intensity = 0;
    growth.endpoints = 60;
    float *dark = make(&growth, &DEF, STRUCTURE_DARK), *along = make(&growth, &DEF, STRUCTURE_ALONG);
    double up = 0, on = 0;
    int none = 0;
    for (int i = 0; i < WIDE * HIGH; i++) {
        double length = hypot((double)along[i], (double)along[WIDE * HIGH + i]);
        assert_true(length <= 1 + 1e-4);
        assert_true(dark[i] > 0.1f || length > 0.7);
        up -= dark[i] < 0.5f ? (double)along[WIDE * HIGH + i] : 0;
        on += dark[i] < 0.5f;
        none += length == 0;
    }
    assert_true(on > 100 && up > 0.1 * on);
    assert_true(none > 2 * (WIDE - HIGH) / 2 * HIGH / 2);
    free(dark);
    free(along);
}

/* What every script's folder has. */
static bool load(void *data, const char *folder, const char *path, struct script_picture *picture,
                 struct file_error *error)
{
    (void)data;
    (void)folder;
    if (strcmp(path, "face.png") != 0) {
        snprintf(error->text, sizeof error->text, "'%s' is not there; a picture", path);
        return false;
    }
    *picture = portrait();
    return true;
}

static struct script *parse(const char *text, struct report *report)
{
    struct script_def def = script_default_def();
    def.load = load;
    report_init(report, "s.yaml");
    return script_parse(text, strlen(text), ".", &def, report);
}

static void scripts_take_them_for_pictures(void **state)
{
    (void)state;
    static const char TEXT[] =
        "frond: 1\ncanvas: {width: 160, height: 100}\nactions:\n"
        "  - {tick: 0, mask: {structure: {over: face.png, endpoints: 300, detail: 128}, invert: true}}\n"
        "  - {tick: 0, guide: {structure: {over: face.png, metaphor: lightning, detail: 128, plant: [[0.5, 0.5]]}}}\n"
        "  - {tick: 0, draw: {structure: {over: face.png, tree: true, detail: 128}}}\n"
        "  - {tick: 0, brush_ink: {structure: {over: face.png, detail: 128}}}\n"
        "  - {tick: 0, brush_solvent: {structure: {over: face.png, detail: 128, width: 2}}}\n"
        "  - {tick: 0, set: {coefficient: xi0, value: 0.1, to: 0.5, structure: {over: face.png, detail: 128}}}\n";
    struct report report;
    struct script *script = parse(TEXT, &report);
    if (!script) {
        fail_msg("%s", report_text(&report));
    }
    assert_int_equal(script->action_count, 6);
    for (int i = 0; i < 6; i++) {
        const struct action_raster *raster = &script->actions[i].picture;
        assert_int_equal(raster->channels, i == 1 ? 2 : 1);
        assert_int_equal(raster->width, WIDE);
        assert_int_equal(raster->height, HIGH);
        assert_true(i == 1 || dark_of(raster->values) > 300);
    }
    struct growth_def growth = growth_of_it();
    struct structure_def def = DEF;
    def.width = 1;
    float *values = make(&growth, &def, STRUCTURE_DARK);
    assert_memory_equal(values, script->actions[0].picture.values, (size_t)WIDE * HIGH * sizeof *values);
    assert_true(dark_of(script->actions[2].picture.values) < dark_of(script->actions[3].picture.values)); /* a tree */
    free(values);
    report_finish(&report);
    script_destroy(script);
}

static void scripts_are_told_what_is_wrong(void **state)
{
    (void)state;
    static const struct {
        const char *verb, *told;
    } CASES[] = {
        {"mask: {structure: {}}",
         "mask.structure.over: missing; the path of a picture in this file's folder, 1 to 1000 bytes"},
        {"mask: {structure: face.png}", "mask.structure: 'face.png'; {over: PICTURE"},
        {"mask: {structure: {over: no.png}}", "mask.structure.over: 'no.png' is not there; a picture"},
        {"mask: {structure: {over: face.png, endpoint: 3}}",
         "mask.structure.endpoint: unknown key; did you mean endpoints"},
        {"mask: {structure: {over: face.png, detail: 3}}",
         "mask.structure.detail: 3 is out of range; 64 to 2048 nodes"},
        {"mask: {structure: {over: face.png, metaphor: inc}}", "mask.structure.metaphor: unknown choice 'inc'"},
        {"mask: {structure: {over: face.png}, picture: face.png}", "both a picture and a structure; one of them"},
        {"mask: {structure: {over: face.png}, formula: x}", "both a formula and a structure; one of them"},
        {"draw: {}", "draw: no place is given; a path, a formula or a picture"},
        {"pour: {at: [0, 0], structure: {over: face.png}}", "pour.structure: unknown key"},
    };
    for (size_t i = 0; i < sizeof CASES / sizeof CASES[0]; i++) {
        char text[256];
        struct report report;
        snprintf(text, sizeof text, "frond: 1\ncanvas: {width: 64, height: 64}\nactions:\n  - {tick: 0, %s}\n",
                 CASES[i].verb);
        struct script *script = parse(text, &report);
        char *told = report_text(&report);
        if (script || !told || !strstr(told, CASES[i].told)) {
            fail_msg("%s:\n%s", CASES[i].verb, told ? told : "nothing");
        }
        free(told);
        report_finish(&report);
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(branches_are_dark_and_lie_in_the_middle),
        cmocka_unit_test(they_can_be_wider),
        cmocka_unit_test(they_tell_where_they_grow),
        cmocka_unit_test(scripts_take_them_for_pictures),
        cmocka_unit_test(scripts_are_told_what_is_wrong),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
