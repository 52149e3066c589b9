/* The picture of the GPU is the picture of the CPU, within 2 of 255 a channel (shaders/picture_gpu.h). */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include <GLES3/gl31.h>

#include "display.h"
#include "painting.h"
#include "picture_gpu.h"

enum { CELLS_X = 150, CELLS_Y = 131, MOST = 2 };

/* A painting with everything on it that a picture shows, in planes for the CPU and in textures for the GPU. */
struct sheet {
    struct display *display;
    struct painting_texels texels;
    float *planes[3 + PAINTING_INKS]; /* depth, solvent, mask, inks */
    struct fields fields;
};

static struct action at(enum action_verb verb, float x, float y)
{
    struct action action = action_default(verb);
    action.at = (struct point){x, y};
    action.has_at = true;
    return action;
}

static void paint(struct painting *painting)
{
    static const struct point LINE[] = {{0.05f, 0.1f}, {0.4f, 0.06f}, {0.3f, 0.2f}};
    struct action first = at(ACTION_DROP, 0.45f, 0.55f), second = at(ACTION_DROP, 0.85f, 0.75f);
    second.ink = 2;
    second.solvent = 150;
    painting_act(painting, &first);
    painting_act(painting, &second);
    for (int tick = 0; tick < 260; tick++) {
        struct action more = action_default(ACTION_BRUSH_INK);
        more.path = (struct action_path){&first.at, 1};
        more.ink = tick < 100 ? 1 : 3;
        more.amount = 40;
        if (tick == 60 || tick == 150) {
            painting_act(painting, &more);
        }
        painting_tick(painting);
    }
    struct action line = action_default(ACTION_DRAW), mask = at(ACTION_MASK, 0.1f, 0.85f),
                  wet = at(ACTION_DRY, 0.85f, 0.75f);
    line.path = (struct action_path){LINE, 3};
    line.ink = 1;
    mask.radius = 9;
    painting_act(painting, &line);
    painting_act(painting, &mask);
    painting_act(painting, &wet);
}

static bool take_planes(struct sheet *sheet)
{
    size_t cells = (size_t)CELLS_X * CELLS_Y;
    for (int i = 0; i < 3 + PAINTING_INKS; i++) {
        sheet->planes[i] = malloc(cells * sizeof(float));
        if (!sheet->planes[i]) {
            return false;
        }
        for (size_t cell = 0; cell < cells; cell++) {
            sheet->planes[i][cell] =
                i < 3 ? sheet->texels.ground[4 * cell + (size_t)i] : sheet->texels.ink[4 * cell + (size_t)i - 3];
        }
    }
    return true;
}

static int set_up(void **state)
{
    struct sheet *sheet = calloc(1, sizeof *sheet);
    struct display_def display = display_default_def();
    struct painting_def def = painting_default_def();
    struct display_error error;
    *state = sheet;
    display.kind = DISPLAY_HEADLESS;
    display.width = display.height = 16;
    sheet->display = display_create(&display, &error);
    def.width = CELLS_X;
    def.height = CELLS_Y;
    struct painting *painting = painting_create(&def);
    size_t floats = (size_t)CELLS_X * CELLS_Y * 4;
    sheet->texels.ground = malloc(floats * sizeof(float));
    sheet->texels.ink = malloc(floats * sizeof(float));
    if (!sheet->display || !painting || !sheet->texels.ground || !sheet->texels.ink ||
        !fields_create(&sheet->fields, CELLS_X, CELLS_Y, false)) {
        return -1;
    }
    paint(painting);
    painting_publish(painting, &sheet->texels);
    painting_destroy(painting);
    const float *texels[FIELDS_COUNT] = {[FIELDS_GROUND] = sheet->texels.ground, [FIELDS_INK] = sheet->texels.ink};
    fields_upload(&sheet->fields, texels);
    return take_planes(sheet) ? 0 : -1;
}

static int tear_down(void **state)
{
    struct sheet *sheet = *state;
    fields_finish(&sheet->fields);
    for (int i = 0; i < 3 + PAINTING_INKS; i++) {
        free(sheet->planes[i]);
    }
    free(sheet->texels.ground);
    free(sheet->texels.ink);
    display_destroy(sheet->display);
    free(sheet);
    return 0;
}

static struct picture_def def_of(int width, int height)
{
    struct picture_def def = picture_default_def();
    def.width = width;
    def.height = height;
    def.cells_x = CELLS_X;
    def.cells_y = CELLS_Y;
    def.seed = 7;
    return def;
}

static uint8_t *draw_cpu(const struct sheet *sheet, const struct picture_def *def)
{
    struct picture *picture = picture_create(def);
    uint8_t *rgb = malloc((size_t)def->width * (size_t)def->height * 3);
    struct picture_planes planes = {.depth = sheet->planes[0], .solvent = sheet->planes[1], .mask = sheet->planes[2]};
    for (int i = 0; i < PAINTING_INKS; i++) {
        planes.ink[i] = sheet->planes[3 + i];
    }
    assert_non_null(picture);
    assert_non_null(rgb);
    picture_draw(picture, &planes, rgb);
    picture_destroy(picture);
    return rgb;
}

/* The pixels of a framebuffer's lower left, rows from the top. */
static uint8_t *read_back(unsigned framebuffer, int width, int height, bool top_first)
{
    uint8_t *rgba = malloc((size_t)width * (size_t)height * 4), *rgb = malloc((size_t)width * (size_t)height * 3);
    assert_non_null(rgba);
    assert_non_null(rgb);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, width, height, GL_RGBA, GL_UNSIGNED_BYTE, rgba);
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            int row = top_first ? y : height - 1 - y;
            memcpy(rgb + 3 * (y * width + x), rgba + 4 * (row * width + x), 3);
        }
    }
    free(rgba);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    return rgb;
}

static uint8_t *draw_gpu(const struct sheet *sheet, const struct picture_def *def)
{
    struct shader_error error;
    struct picture_gpu *picture = picture_gpu_create(def, NULL, &error);
    if (!picture) {
        fail_msg("%s", error.text);
    }
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    picture_gpu_shade(picture, &sheet->fields, PICTURE_AT_ONCE);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_gpu_texture(picture), 0);
    uint8_t *rgb = read_back(framebuffer, def->width, def->height, true);
    picture_gpu_shade(picture, &sheet->fields, PICTURE_AT_ONCE); /* the same again */
    uint8_t *again = read_back(framebuffer, def->width, def->height, true);
    assert_memory_equal(rgb, again, (size_t)def->width * (size_t)def->height * 3);
    free(again);
    glDeleteFramebuffers(1, &framebuffer);
    picture_gpu_destroy(picture, false);
    return rgb;
}

/* Differences by size are printed; none may be over MOST. */
static void same_picture(const struct sheet *sheet, const struct picture_def *def)
{
    uint8_t *expected = draw_cpu(sheet, def), *found = draw_gpu(sheet, def);
    size_t count = (size_t)def->width * (size_t)def->height * 3, counts[256] = {0}, worst = 0;
    uint8_t least = 255, most = 0;
    for (size_t i = 0; i < count; i++) {
        int difference = abs((int)expected[i] - (int)found[i]);
        worst = counts[difference] == 0 || difference == 0 ? worst : worst;
        worst = (size_t)difference > worst ? (size_t)difference : worst;
        counts[difference]++;
        least = expected[i] < least ? expected[i] : least;
        most = expected[i] > most ? expected[i] : most;
    }
    print_message("%dx%d%s%s: of %zu channels differ by 1: %zu, by 2: %zu, by more: %zu (worst %zu)\n", def->width,
                  def->height, def->plain ? " plain" : "", def->mixing == INK_CMY ? " cmy" : "", count, counts[1],
                  counts[2], count - counts[0] - counts[1] - counts[2], worst);
    assert_true(most - least > 150); /* there is something to see */
    assert_true(worst <= MOST);
    free(expected);
    free(found);
}

static void every_scale_is_the_same(void **state)
{
    static const int SIZES[][2] = {{CELLS_X, CELLS_Y}, {225, 197}, {300, 262}, {600, 524},
                                   {105, 92},          {53, 40},   {301, 131}};
    for (size_t i = 0; i < sizeof SIZES / sizeof SIZES[0]; i++) {
        struct picture_def def = def_of(SIZES[i][0], SIZES[i][1]);
        same_picture(*state, &def);
    }
}

static void every_mode_is_the_same(void **state)
{
    for (int mode = 1; mode < 4; mode++) {
        struct picture_def def = def_of(257, 201);
        def.plain = mode & 1;
        def.mixing = mode & 2 ? INK_CMY : INK_KUBELKA_MUNK;
        same_picture(*state, &def);
    }
}

static void every_palette_is_the_same(void **state)
{
    for (int palette = 0; palettes[palette].name; palette++) {
        struct picture_def def = def_of(200, 170);
        for (int i = 0; i < INK_PALETTE; i++) {
            def.ink[i] = ink_find(palettes[palette].inks[i]);
        }
        same_picture(*state, &def);
    }
}

static void a_fixed_tone_is_the_same(void **state)
{
    struct picture_def def = def_of(200, 170);
    def.depth_ref = 0.9f;
    same_picture(*state, &def);
}

static void an_empty_sheet_is_the_same(void **state)
{
    struct sheet empty = *(struct sheet *)*state;
    float *zeros = calloc((size_t)CELLS_X * CELLS_Y * 4, sizeof *zeros);
    assert_non_null(zeros);
    assert_true(fields_create(&empty.fields, CELLS_X, CELLS_Y, false));
    const float *texels[FIELDS_COUNT] = {[FIELDS_GROUND] = zeros, [FIELDS_INK] = zeros};
    fields_upload(&empty.fields, texels);
    for (int i = 0; i < 3 + PAINTING_INKS; i++) {
        empty.planes[i] = zeros;
    }
    struct picture_def def = def_of(190, 160);
    uint8_t *expected = draw_cpu(&empty, &def), *found = draw_gpu(&empty, &def);
    for (int i = 0; i < def.width * def.height * 3; i++) {
        assert_true(abs((int)expected[i] - (int)found[i]) <= MOST);
    }
    free(expected);
    free(found);
    fields_finish(&empty.fields);
    free(zeros);
}

/* What is up on the sheet is up, right, down and left on a panel turned by 0, 90, 180 and 270 degrees. */
static void the_panel_shows_it_turned(void **state)
{
    const struct sheet *sheet = *state;
    struct picture_def def = def_of(120, 90);
    struct shader_error error;
    struct picture_gpu *picture = picture_gpu_create(&def, NULL, &error);
    assert_non_null(picture);
    picture_gpu_shade(picture, &sheet->fields, PICTURE_AT_ONCE);
    uint8_t *expected = draw_gpu(sheet, &def);
    uint8_t *found = malloc((size_t)def.width * (size_t)def.height * 3);
    for (int rotation = 0; rotation < 360; rotation += 90) {
        struct display_def display_def = display_default_def();
        struct display_error display_error;
        float turn[4];
        display_def.kind = DISPLAY_HEADLESS;
        display_def.rotation = rotation;
        display_def.width = rotation % 180 == 0 ? def.width : def.height;
        display_def.height = rotation % 180 == 0 ? def.height : def.width;
        struct display *display = display_create(&display_def, &display_error);
        assert_non_null(display);
        assert_true(display_begin(display)); /* a context of its own: make the picture there */
        struct picture_gpu *here = picture_gpu_create(&def, NULL, &error);
        struct fields fields = {0};
        assert_non_null(here);
        assert_true(fields_create(&fields, CELLS_X, CELLS_Y, false));
        const float *texels[FIELDS_COUNT] = {[FIELDS_GROUND] = sheet->texels.ground, [FIELDS_INK] = sheet->texels.ink};
        fields_upload(&fields, texels);
        display_turn(display, turn);
        picture_gpu_shade(here, &fields, PICTURE_AT_ONCE);
        picture_gpu_present(here, display_framebuffer(display), display_def.width, display_def.height, turn);
        assert_int_equal(glGetError(), GL_NO_ERROR);
        display_end(display);
        assert_true(display_capture(display, found)); /* as it is looked at: turned back */
        assert_memory_equal(found, expected, (size_t)def.width * (size_t)def.height * 3);
        fields_finish(&fields);
        picture_gpu_destroy(here, false);
        display_destroy(display);
        assert_true(display_begin(sheet->display));
    }
    free(found);
    free(expected);
    picture_gpu_destroy(picture, false);
}

/* The mean brightness of the picture, 0..255. */
static double mean_of(struct picture_gpu *picture, const struct picture_def *def)
{
    GLuint framebuffer;
    double sum = 0;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, picture_gpu_texture(picture), 0);
    uint8_t *rgb = read_back(framebuffer, def->width, def->height, true);
    for (int i = 0; i < def->width * def->height * 3; i++) {
        sum += rgb[i];
    }
    free(rgb);
    glDeleteFramebuffers(1, &framebuffer);
    return sum / (def->width * def->height * 3);
}

/* A painting whose depth jumps: the tone that follows slowly moves by less in a picture than an eye sees, and arrives.
 */
static void the_tone_follows_slowly(void **state)
{
    const struct sheet *sheet = *state;
    struct picture_def def = def_of(150, 131);
    struct shader_error error;
    struct fields deeper = {0};
    size_t floats = (size_t)CELLS_X * CELLS_Y * 4;
    float *ground = malloc(floats * sizeof *ground);
    assert_non_null(ground);
    for (size_t i = 0; i < floats; i++) {
        ground[i] = i % 4 == 0 ? 1.5f * sheet->texels.ground[i] : sheet->texels.ground[i];
    }
    assert_true(fields_create(&deeper, CELLS_X, CELLS_Y, false));
    const float *texels[FIELDS_COUNT] = {[FIELDS_GROUND] = ground, [FIELDS_INK] = sheet->texels.ink};
    fields_upload(&deeper, texels);
    struct picture_gpu *picture = picture_gpu_create(&def, NULL, &error);
    assert_non_null(picture);
    picture_gpu_shade(picture, &deeper, PICTURE_AT_ONCE);
    double end = mean_of(picture, &def), last, largest = 0;
    picture_gpu_shade(picture, &sheet->fields, PICTURE_AT_ONCE);
    picture_gpu_shade(picture, &deeper, PICTURE_SLOWLY); /* the depth has jumped, the tone has not yet */
    double start = last = mean_of(picture, &def);
    for (int i = 0; i < 600; i++) {
        picture_gpu_shade(picture, &deeper, PICTURE_SLOWLY);
        if (i % 20 == 19) {
            double now = mean_of(picture, &def);
            largest = fabs(now - last) > largest ? fabs(now - last) : largest;
            last = now;
        }
    }
    print_message("mean of the picture: %.2f at first, %.2f at last, %.2f at once; most in 20 pictures %.2f\n", start,
                  last, end, largest);
    assert_true(fabs(start - end) > 0.5);
    assert_true(largest < 0.6 * fabs(start - end));
    assert_true(fabs(last - end) < 0.1);
    picture_gpu_destroy(picture, false);
    fields_finish(&deeper);
    free(ground);
}

static void sizes_out_of_range_are_refused(void **state)
{
    (void)state;
    struct shader_error error;
    struct picture_def def = def_of(0, 10);
    assert_null(picture_gpu_create(&def, NULL, &error));
    assert_string_equal(error.text, "a picture of 0x10 pixels of 150x131 cells: out of range");
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(every_scale_is_the_same),    cmocka_unit_test(every_mode_is_the_same),
        cmocka_unit_test(every_palette_is_the_same),  cmocka_unit_test(a_fixed_tone_is_the_same),
        cmocka_unit_test(an_empty_sheet_is_the_same), cmocka_unit_test(the_panel_shows_it_turned),
        cmocka_unit_test(the_tone_follows_slowly),    cmocka_unit_test(sizes_out_of_range_are_refused),
    };
    return cmocka_run_group_tests(tests, set_up, tear_down);
}
