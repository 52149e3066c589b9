/* A tick of the GPU engine beside that of the CPU engine, from the same state; sleeping tiles beside a dense sheet; the
 * life of the engine.
 *
 * How far the engines may be apart. Both do the same operations in the same order, so a value differs by a rounding
 * here and there (6e-8 of it). Of that grows:
 *   - liquid: what crosses a link is rounded to multiples of the dead band, 2^-13; a rounding that falls to the other
 *     side moves one band more or less. Such errors are as often up as down and diffuse away: the density of a cell is
 *     up to six bands apart at 50 ticks, at 150 and at 800. Allowed: twelve.
 *   - pattern: solvent counts up to s_max, where a band more or less is nothing; elsewhere it is 1e-4 of the growth.
 * 4e-7 after 150 ticks (4e-6 where s_max is so high that it does not bind), 2e-4 after 800, when the front has crossed
 *     the sheet. Allowed over 150 ticks: 2e-5.
 *   - pigment: moves by the flux over the density of the ink, so where ink is thin (.02) a band is a share of .6 %. It
 * is weighed by the density of its ink, which is what the eye sees: 5e-3 after 150 ticks. Allowed: 2e-2. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include <GLES3/gl31.h>

#include "bench_gpu.h"
#include "folder_case.h"
#include "gpu_case.h"
#include "painting_gpu_state.h"

#define BAND           (1.0f / 8192)
#define LIQUID_BANDS   12
#define PATTERN_WITHIN 2e-5f
#define PIGMENT_WITHIN 2e-2f

struct apart { /* greatest differences */
    float liquid, pigment, pattern;
};

static void keep_larger(float *largest, float value)
{
    *largest = *largest < value || value != value ? value : *largest;
}

static struct apart compare(struct gpu_case *both)
{
    const struct checkpoint *cpu = &both->cpu_state, *gpu = &both->gpu_state;
    assert_true(both->cpu->ops->save(both->cpu, &both->cpu_state));
    assert_true(both->gpu->ops->save(both->gpu, &both->gpu_state));
    struct apart apart = {0};
    size_t cells = (size_t)cpu->width * (size_t)cpu->height;
    for (size_t cell = 0; cell < cells; cell++) {
        float ink = 0;
        for (int plane = 0; plane < CHECKPOINT_PLANES; plane++) {
            float value = checkpoint_plane(cpu, plane)[cell];
            float difference = fabsf(value - checkpoint_plane(gpu, plane)[cell]);
            ink += plane >= CHECKPOINT_INK && plane < CHECKPOINT_WET ? value : 0;
            if (plane < CHECKPOINT_WET || plane == CHECKPOINT_DENSITY) {
                keep_larger(&apart.liquid, difference);
            } else if (plane < CHECKPOINT_ACTIVE) {
                keep_larger(&apart.pigment, difference * (ink < 1 ? ink : 1));
            } else if (plane < CHECKPOINT_DRY) {
                keep_larger(&apart.pattern, difference);
            }
        }
    }
    return apart;
}

static void assert_near(struct gpu_case *both, float bands)
{
    struct apart apart = compare(both);
    if (!(apart.liquid <= bands * BAND && apart.pigment <= PIGMENT_WITHIN && apart.pattern <= PATTERN_WITHIN)) {
        fail_msg("after %lld ticks the engines are apart: liquid %g, pigment %g, pattern %g",
                 (long long)both->cpu->ops->ticks(both->cpu), (double)apart.liquid, (double)apart.pigment,
                 (double)apart.pattern);
    }
}

static struct action drop_at(float x, float y, int ink)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.ink = ink;
    return drop;
}

static void three_drops(struct gpu_case *both)
{
    static const float AT[3][2] = {{0.3f, 0.4f}, {0.62f, 0.55f}, {0.02f, 0.98f}};
    for (int i = 0; i < 3; i++) {
        struct action drop = drop_at(AT[i][0], AT[i][1], i);
        drop.radius = 6;
        gpu_case_act(both, &drop);
    }
}

static struct painting_def sheet(int width, int height)
{
    struct painting_def def = painting_default_def();
    def.width = width;
    def.height = height;
    def.threads = 1;
    return def;
}

static void drops_grow_alike(enum gpu_way way, int ticks)
{
    struct gpu_case both;
    struct painting_def def = sheet(128, 128);
    gpu_case_init(&both, &def);
    engine_gpu_set_way(both.gpu, way);
    three_drops(&both);
    for (int done = 0; done < ticks; done += 50) {
        gpu_case_tick(&both, 50);
        assert_near(&both, LIQUID_BANDS);
    }
    struct painting_totals totals = both.cpu->ops->totals(both.cpu);
    assert_true(totals.carved > 200); /* it did grow */
    gpu_case_finish(&both);
}

static void drops_grow_alike_in_strips(void **state)
{
    (void)state;
    drops_grow_alike(GPU_STRIPS, 150);
}

static void drops_grow_alike_in_patches(void **state)
{
    (void)state;
    drops_grow_alike(GPU_PATCHES, 100);
}

static void drops_grow_alike_plainly(void **state)
{
    (void)state;
    drops_grow_alike(GPU_PLAIN, 50);
}

/* Masks that reach the border, guidance, a brush, flood: on a sheet that no tile divides. */
static void busy_ground(struct gpu_case *both)
{
    static const struct point WALL[] = {{0.0f, 0.7f}, {0.45f, 0.7f}, {0.6f, 1.0f}},
                              WAY[] = {{0.2f, 0.2f}, {0.5f, 0.5f}, {1.0f, 0.3f}};
    struct action act = action_default(ACTION_MASK);
    act.path = (struct action_path){WALL, 3};
    act.radius = 3;
    gpu_case_act(both, &act);
    act = action_default(ACTION_GUIDE);
    act.path = (struct action_path){WAY, 3};
    act.radius = 15;
    act.strength = 1.5f;
    gpu_case_act(both, &act);
    act = drop_at(0.4f, 0.5f, 3);
    act.brush = 1;
    act.edge = EDGE_RAGGED;
    gpu_case_act(both, &act);
}

static void busy_ground_is_the_same(void **state)
{
    (void)state;
    for (int way = 0; way < GPU_WAYS; way++) {
        struct gpu_case both;
        struct painting_def def = sheet(101, 67);
        def.margin = way == GPU_PATCHES ? 9 : 0;
        def.coefficients.flood = way == GPU_STRIPS ? 6.0f : 0.0f;
        gpu_case_init(&both, &def);
        engine_gpu_set_way(both.gpu, (enum gpu_way)way);
        busy_ground(&both);
        three_drops(&both);
        gpu_case_tick(&both, 60);
        assert_near(&both, LIQUID_BANDS);
        gpu_case_finish(&both);
    }
}

/* Flood opens the ink's way by its density: liquid that differs by bands opens it a little otherwise. The test above
 * allows for that; this one makes sure that it is there at all. */
static void flood_lets_ink_cross(void **state)
{
    (void)state;
    struct gpu_case both;
    struct painting_def def = sheet(64, 64);
    def.coefficients.flood = 2.0f;
    gpu_case_init(&both, &def);
    struct action drop = drop_at(0.5f, 0.5f, 0);
    gpu_case_act(&both, &drop);
    gpu_case_tick(&both, 20);
    assert_near(&both, LIQUID_BANDS);
    gpu_case_finish(&both);
}

struct variation {
    int stencil, fluid_steps, pattern_steps;
    float k;
    enum gpu_way way;
};

static void any_coefficients_are_the_same(void **state)
{
    (void)state;
    static const struct variation VARIATIONS[] = {
        {STENCIL_NINE, 4, 8, 2, GPU_STRIPS},        {STENCIL_FIVE, 3, 7, 2, GPU_PATCHES},
        {STENCIL_RAW, 2, 5, 2, GPU_STRIPS},         {STENCIL_ISOTROPIC, 1, 1, 3, GPU_PATCHES},
        {STENCIL_ISOTROPIC, 3, 7, 2, GPU_STRIPS},   {STENCIL_ISOTROPIC, 2, 6, 2, GPU_PATCHES},
        {STENCIL_ISOTROPIC, 1, 3, 1.5f, GPU_PLAIN}, {STENCIL_NINE, 1, 3, 2, GPU_PLAIN},
    };
    for (size_t i = 0; i < sizeof VARIATIONS / sizeof VARIATIONS[0]; i++) {
        struct gpu_case both;
        struct painting_def def = sheet(70, 61);
        def.coefficients.stencil = VARIATIONS[i].stencil;
        def.coefficients.fluid_steps = VARIATIONS[i].fluid_steps;
        def.coefficients.pattern_steps = VARIATIONS[i].pattern_steps;
        def.coefficients.k = VARIATIONS[i].k;
        def.coefficients.s_max = 0.6f;
        gpu_case_init(&both, &def);
        engine_gpu_set_way(both.gpu, VARIATIONS[i].way);
        three_drops(&both);
        gpu_case_tick(&both, 25);
        assert_near(&both, LIQUID_BANDS);
        gpu_case_finish(&both);
    }
}

/* Thin liquid on open ground: less crosses a link than half of the widest band, 2^-7, and more than half of 2^-13. */
static void thin_puddle(const struct checkpoint *state)
{
    for (int y = 0; y < state->height; y++) {
        for (int x = 0; x < state->width; x++) {
            size_t cell = (size_t)y * (size_t)state->width + (size_t)x;
            checkpoint_plane(state, CHECKPOINT_CATALYST)[cell] = 0;
            checkpoint_plane(state, CHECKPOINT_DENSITY)[cell] = x > 20 && x < 40 ? 0.018f : 0;
            for (int i = 0; i < 9; i++) {
                checkpoint_plane(state, CHECKPOINT_SOLVENT + i)[cell] = x > 20 && x < 40 ? 0.002f : 0;
            }
        }
    }
}

static void quiet_widens_the_dead_band(void **state)
{
    (void)state;
    static const int PERIODS[] = {0, 24, 32, 40, 900};
    struct gpu_case both;
    struct painting_def def = sheet(64, 40);
    gpu_case_init(&both, &def);
    for (size_t i = 0; i < sizeof PERIODS / sizeof PERIODS[0]; i++) {
        assert_true(both.cpu->ops->save(both.cpu, &both.cpu_state));
        both.cpu_state.quiet_periods = PERIODS[i];
        thin_puddle(&both.cpu_state);
        gpu_case_load(&both, &both.cpu_state);
        gpu_case_tick(&both, 1);
        float *solvent = malloc(64 * 40 * sizeof *solvent);
        assert_non_null(solvent);
        both.gpu->ops->read(both.gpu, PAINTING_SOLVENT, solvent);
        assert_int_equal(solvent[20 * 64 + 20] > 0, PERIODS[i] < 40); /* .002 is a step of 2^-9, none of 2^-7 */
        free(solvent);
        assert_near(&both, 2);
    }
    gpu_case_finish(&both);
}

static uint32_t bits_of(float value)
{
    uint32_t bits;
    memcpy(&bits, &value, sizeof bits);
    return bits == 0x80000000u ? 0 : bits;
}

static void assert_same_bits(const struct checkpoint *one, const struct checkpoint *other)
{
    size_t values = CHECKPOINT_PLANES * (size_t)one->width * (size_t)one->height;
    for (size_t i = 0; i < values; i++) {
        if (bits_of(one->planes[i]) != bits_of(other->planes[i])) {
            fail_msg("value %zu of plane %zu is %.9g on the dense sheet, %.9g where tiles sleep",
                     i % (values / CHECKPOINT_PLANES), i / (values / CHECKPOINT_PLANES), (double)one->planes[i],
                     (double)other->planes[i]);
        }
    }
}

/* Two engines in one context, one of which keeps all tiles awake. */
static void sleeping_changes_no_bit(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct painting_def def = sheet(200, 150);
    struct engine *sleeping = gpu_engine(&def);
    def.dense = true;
    struct engine *dense = gpu_engine(&def);
    struct checkpoint one = {0}, other = {0};
    assert_true(checkpoint_init(&one, &def) && checkpoint_init(&other, &def));
    int slept = 0;
    for (int tick = 0; tick < 130; tick++) {
        struct engine *both[2] = {sleeping, dense};
        for (int i = 0; i < 2; i++) {
            if (tick == 0 || tick == 60) { /* both with strips and with patches, in passes of 2 and 4 */
                struct action drop = drop_at(tick == 0 ? 0.2f : 0.8f, 0.3f, 1);
                drop.solvent = 100;
                both[i]->ops->act(both[i], &drop);
                engine_gpu_set_way(both[i], tick == 0 ? GPU_STRIPS : GPU_PATCHES);
            }
            if (tick == 100) {
                engine_gpu_set_way(both[i], GPU_PLAIN);
            }
            if (tick == 30) {
                struct action puddle = action_default(ACTION_MASK);
                puddle.at = (struct point){0.3f, 0.3f};
                puddle.radius = 6;
                both[i]->ops->act(both[i], &puddle);
            }
            both[i]->ops->tick(both[i]);
        }
        if (tick == 40 || tick == 100) {
            struct painting_effort effort = sleeping->ops->effort(sleeping);
            assert_int_equal(effort.tiles, 7 * 5);
            slept += effort.fluid_awake < effort.tiles && effort.pattern_awake < effort.tiles;
            effort = dense->ops->effort(dense);
            assert_true(effort.fluid_awake == effort.tiles && effort.pattern_awake == effort.tiles);
        }
        if (tick % 10 == 9) {
            assert_true(dense->ops->save(dense, &one) && sleeping->ops->save(sleeping, &other));
            assert_same_bits(&one, &other);
        }
    }
    assert_int_equal(slept, 2);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    checkpoint_finish(&one);
    checkpoint_finish(&other);
    engine_destroy(sleeping);
    engine_destroy(dense);
    display_destroy(display);
}

/* A sleeping tile holds the same in both buffers: told by looking at both. */
static void sleeping_tiles_are_held_twice(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct painting_def def = sheet(160, 160);
    struct engine *engine = gpu_engine(&def);
    struct painting_gpu *gpu = (struct painting_gpu *)engine;
    struct action drop = drop_at(0.5f, 0.5f, 0);
    engine->ops->act(engine, &drop);
    for (int tick = 0; tick < 20; tick++) {
        engine->ops->tick(engine);
    }
    struct rectangle corner = {0, 32, 0, 32}; /* grown nowhere near */
    size_t words = 32 * 32 * (size_t)GPU_FLUID_PLANES;
    float *one = malloc(words * sizeof *one), *other = malloc(words * sizeof *other);
    assert_true(one && other);
    for (int kind = BUFFER_FLUID; kind <= BUFFER_PATTERN; kind++) {
        int planes = kind == BUFFER_FLUID ? GPU_FLUID_PLANES : GPU_PATTERN_PLANES;
        int *now = kind == BUFFER_FLUID ? &gpu->fluid_now : &gpu->pattern_now;
        assert_true(gpu_read_planes(gpu, (enum gpu_buffer)kind, 0, planes, corner, one));
        *now = 1 - *now;
        assert_true(gpu_read_planes(gpu, (enum gpu_buffer)kind, 0, planes, corner, other));
        *now = 1 - *now;
        assert_memory_equal(one, other, 32 * 32 * (size_t)planes * sizeof *one);
    }
    free(one);
    free(other);
    engine_destroy(engine);
    display_destroy(display);
}

static void a_sheet_too_large_is_refused(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    GLint64 most = 0;
    glGetInteger64v(GL_MAX_SHADER_STORAGE_BLOCK_SIZE, &most);
    struct painting_def def = sheet(4096, 4096);
    def.margin = 256;
    struct shader_error error = {""};
    assert_null(engine_gpu_create(&def, NULL, &error));
    char wanted[32], offered[32];
    snprintf(wanted, sizeof wanted, " %lld ", 22LL * 4616 * 4616 * 4); /* 4608 cells in tiles, and the apron */
    snprintf(offered, sizeof offered, " %lld", (long long)most);
    assert_non_null(strstr(error.text, wanted));
    assert_non_null(strstr(error.text, offered));
    def.width = 8;
    assert_null(engine_gpu_create(&def, NULL, &error));
    assert_non_null(strstr(error.text, "8x4096"));
    assert_int_equal(glGetError(), GL_NO_ERROR);
    display_destroy(display);
}

static int count_objects(void)
{
    int count = 0;
    for (GLuint name = 1; name < 3000; name++) {
        count += glIsBuffer(name) + glIsProgram(name) + glIsShader(name) + glIsTexture(name);
    }
    return count;
}

static void nothing_is_left_behind(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct painting_def def = sheet(64, 64);
    int before = count_objects();
    for (int i = 0; i < 2; i++) {
        struct engine *engine = gpu_engine(&def);
        struct action drop = drop_at(0.5f, 0.5f, 0);
        engine->ops->act(engine, &drop);
        engine->ops->tick(engine);
        engine->ops->finish(engine);
        assert_true(count_objects() > before);
        engine_destroy(engine);
        assert_int_equal(count_objects(), before);
        assert_int_equal(glGetError(), GL_NO_ERROR);
    }
    display_destroy(display);
}

static void write_source(const char *folder, const char *name, const char *text)
{
    char path[300];
    snprintf(path, sizeof path, "%s/%s", folder, name);
    assert_true(folder_case_put(path, text));
}

/* Whether a tick loses and makes no solvent, as the fluids of the engine itself. */
static bool keeps_solvent(struct engine *engine)
{
    double before = engine->ops->totals(engine).solvent;
    engine->ops->tick(engine);
    return fabs(engine->ops->totals(engine).solvent - before) < 1e-3 * before;
}

static const char OTHER_FLUID[] =
    "layout(local_size_x = 128) in;\nlayout(std430, binding = 1) writeonly buffer To { float to[]; };\n"
    "layout(location = 2) uniform ivec4 work;\nlayout(location = 3) uniform vec4 liquid;\n"
    "void main() { to[2628u + gl_LocalInvocationIndex] = 1.0 + 1e-9 * (liquid.x + float(work.x)); }\n";

/* Programs come anew from a folder: all of them, or none. */
static void sources_are_reloaded(void **state)
{
    (void)state;
    char folder[FOLDER_CASE_PATH];
    assert_true(folder_case_make(folder));
    const char *fluid = "", *publish = "";
    for (const struct shader_source *source = shader_sources; source->name; source++) {
        write_source(folder, source->name, source->text);
        fluid = strcmp(source->name, "fluid.comp") == 0 ? source->text : fluid;
        publish = strcmp(source->name, "publish.comp") == 0 ? source->text : publish;
    }
    assert_true(fluid[0] != '\0' && publish[0] != '\0');
    struct display *display = gpu_display();
    struct painting_def def = sheet(64, 64);
    struct shader_error error = {""};
    struct shader_folder from = {folder};
    struct engine *engine = engine_gpu_create(&def, &from, &error);
    assert_non_null(engine);
    engine_gpu_set_way(engine, GPU_PATCHES); /* fluid.comp is at work */
    struct action drop = drop_at(0.5f, 0.5f, 0);
    engine->ops->act(engine, &drop);
    write_source(folder, "fluid.comp", "void main() { this is no shader }\n");
    assert_false(engine_gpu_reload(engine, &error));
    assert_non_null(strstr(error.text, "fluid.comp"));
    assert_true(keeps_solvent(engine)); /* the old program goes on */
    write_source(folder, "fluid.comp", OTHER_FLUID);
    write_source(folder, "publish.comp", "void main() { nor is this }\n");
    assert_false(engine_gpu_reload(engine, &error));
    assert_non_null(strstr(error.text, "publish.comp"));
    assert_true(keeps_solvent(engine)); /* the one that compiles has to wait */
    write_source(folder, "publish.comp", publish);
    assert_true(engine_gpu_reload(engine, &error)); /* a new one is taken */
    assert_false(keeps_solvent(engine));
    write_source(folder, "fluid.comp", fluid);
    assert_true(engine_gpu_reload(engine, &error));
    engine->ops->tick(engine);
    assert_int_equal(glGetError(), GL_NO_ERROR);
    engine_destroy(engine);
    display_destroy(display);
    assert_true(folder_case_remove(folder));
}

/* Counted figures hang together, measured ones are there. */
static void layers_are_measured(void **state)
{
    (void)state;
    struct display *display = gpu_display();
    struct bench_gpu bench[GPU_WAYS];
    struct shader_error error = {""};
    for (int way = 0; way < GPU_WAYS; way++) {
        assert_true(bench_gpu_run(&bench[way], 64, (enum gpu_way)way, &error));
        assert_int_equal(bench[way].way, way);
        for (int i = 0; i < BENCH_GPU_LAYERS; i++) {
            const struct bench_gpu_layer *layer = &bench[way].layers[i];
            assert_true(layer->wall_ms > 0 && layer->cpu_ms > 0);
            assert_true(layer->operations >= 8 * layer->steps && layer->bytes > 24);
        }
    }
    /* The more steps in a pass, the less is asked of memory; rates made once pay for rims computed in vain. */
    const struct bench_gpu_layer *plain = &bench[GPU_PLAIN].layers[BENCH_GPU_PATTERN],
                                 *strips = &bench[GPU_STRIPS].layers[BENCH_GPU_PATTERN],
                                 *patches = &bench[GPU_PATCHES].layers[BENCH_GPU_PATTERN];
    assert_true(patches->bytes < strips->bytes && strips->bytes < plain->bytes);
    assert_true(patches->operations < 1.1 * plain->operations && plain->operations < 1.1 * patches->operations);
    display_destroy(display);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(drops_grow_alike_in_strips),    cmocka_unit_test(drops_grow_alike_in_patches),
        cmocka_unit_test(drops_grow_alike_plainly),      cmocka_unit_test(busy_ground_is_the_same),
        cmocka_unit_test(flood_lets_ink_cross),          cmocka_unit_test(any_coefficients_are_the_same),
        cmocka_unit_test(quiet_widens_the_dead_band),    cmocka_unit_test(sleeping_changes_no_bit),
        cmocka_unit_test(sleeping_tiles_are_held_twice), cmocka_unit_test(a_sheet_too_large_is_refused),
        cmocka_unit_test(nothing_is_left_behind),        cmocka_unit_test(sources_are_reloaded),
        cmocka_unit_test(layers_are_measured),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
