/* State to and from the GPU: checkpoints at once and rolling, the loss of the context, textures for the picture. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>
#include <time.h>

#include <GLES3/gl31.h>

#include "busy.h"
#include "gpu_case.h"
#include "patience.h"

static void act_on(void *engine, const struct action *action)
{
    ((struct engine *)engine)->ops->act(engine, action);
}

/* The CPU's, after `ticks` of the session. */
static void grow(struct engine *cpu, int ticks, struct checkpoint *checkpoint)
{
    struct busy busy;
    busy_init(&busy);
    for (int tick = 0; tick < ticks; tick++) {
        busy_act(&busy, tick, act_on, cpu);
        cpu->ops->tick(cpu);
    }
    assert_true(cpu->ops->save(cpu, checkpoint));
}

static void assert_same(const struct checkpoint *one, const struct checkpoint *other)
{
    size_t values = CHECKPOINT_PLANES * (size_t)one->width * (size_t)one->height;
    for (size_t i = 0; i < values; i++) {
        assert_true(one->planes[i] == other->planes[i]);
    }
    size_t cells = (size_t)one->ground->stride * (size_t)one->ground->height;
    assert_memory_equal(one->ground->maps, other->ground->maps, MAPS * cells * sizeof *one->ground->maps);
    assert_memory_equal(one->ground->stamped, other->ground->stamped, cells * sizeof *one->ground->stamped);
    assert_memory_equal(one->ground->obstacle, other->ground->obstacle, cells);
    assert_memory_equal(one->ground->guide, other->ground->guide, 2 * cells * sizeof *one->ground->guide);
    assert_int_equal(one->tick, other->tick);
    assert_int_equal(one->quiet_periods, other->quiet_periods);
    assert_int_equal(one->carved, other->carved);
    assert_true(fabs(one->evaporated - other->evaporated) <= 1e-6 * (1 + fabs(one->evaporated)));
    assert_true(fabs(one->ink_dried - other->ink_dried) <= 1e-6 * (1 + fabs(one->ink_dried)));
    assert_true(one->def.coefficients.flood == other->def.coefficients.flood);
}

static void goes_to_the_gpu_and_back(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct gpu_case both;
    struct checkpoint kept;
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&kept, &def));
    grow(both.cpu, 310, &kept);
    assert_true(kept.evaporated > 0 && kept.carved > 0);
    assert_true(both.gpu->ops->load(both.gpu, &kept));
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_same(&kept, &both.gpu_state);
    struct painting_totals gpu = both.gpu->ops->totals(both.gpu), cpu = both.cpu->ops->totals(both.cpu);
    assert_true(fabs(gpu.solvent / cpu.solvent - 1) < 1e-6 && fabs(gpu.carved / cpu.carved - 1) < 1e-6);
    assert_true(fabs(gpu.wet[2] / cpu.wet[2] - 1) < 1e-6 && fabs(gpu.dry[2] / cpu.dry[2] - 1) < 1e-6);
    for (int field = 0; field < PAINTING_FIELDS; field++) {
        static float planes[2][203 * 117];
        both.gpu->ops->read(both.gpu, (enum painting_field)field, planes[0]);
        both.cpu->ops->read(both.cpu, (enum painting_field)field, planes[1]);
        for (int i = 0; i < 203 * 117; i++) {
            assert_true(fabsf(planes[0][i] - planes[1][i]) <= 1e-5f);
        }
    }
    assert_int_equal(both.gpu->ops->ticks(both.gpu), 310);
    assert_true(both.gpu->ops->bytes(both.gpu) > (size_t)(221 * 135 * 200));
    def.margin++;
    struct checkpoint other;
    assert_true(checkpoint_init(&other, &def));
    assert_false(both.gpu->ops->load(both.gpu, &other));
    assert_false(both.gpu->ops->save(both.gpu, &other));
    checkpoint_finish(&other);
    checkpoint_finish(&kept);
    gpu_case_finish(&both);
}

/* The same values to the bit after as many ticks: nothing of the state is missing from a checkpoint. */
static void goes_on_from_what_it_saved(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct gpu_case both;
    struct checkpoint kept;
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&kept, &def));
    grow(both.cpu, 230, &kept);
    assert_true(both.gpu->ops->load(both.gpu, &kept));
    struct engine *second = gpu_engine(&def);
    for (int tick = 0; tick < 7; tick++) {
        both.gpu->ops->tick(both.gpu);
    }
    assert_true(both.gpu->ops->save(both.gpu, &kept));
    assert_true(second->ops->load(second, &kept));
    for (int tick = 0; tick < 30; tick++) { /* beyond an upkeep */
        both.gpu->ops->tick(both.gpu);
        second->ops->tick(second);
    }
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_true(second->ops->save(second, &both.cpu_state));
    assert_same(&both.gpu_state, &both.cpu_state);
    engine_destroy(second);
    checkpoint_finish(&kept);
    gpu_case_finish(&both);
}

/* While it comes to memory the painting goes on, and is acted upon; what arrives is what was. */
static void a_rolling_checkpoint_is_of_one_moment(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct gpu_case both;
    struct checkpoint rolling;
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&rolling, &def));
    assert_false(engine_gpu_checkpoint_step(both.gpu, &rolling)); /* none was begun */
    grow(both.cpu, 220, &both.cpu_state);
    assert_true(both.gpu->ops->load(both.gpu, &both.cpu_state));
    struct action act = action_default(ACTION_POUR);
    act.at = (struct point){0.4f, 0.4f};
    act.has_at = true;
    for (int round = 0; round < 3; round++) {
        both.gpu->ops->tick(both.gpu);
        assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
        assert_true(engine_gpu_checkpoint_begin(both.gpu));
        act.radius = (float)(8 + round);
        both.gpu->ops->act(both.gpu, &act);
        struct action mask = act;
        mask.verb = ACTION_MASK;
        mask.at.x = 0.2f * (float)round;
        both.gpu->ops->act(both.gpu, &mask);
        int steps = 0;
        while (!engine_gpu_checkpoint_step(both.gpu, &rolling)) {
            both.gpu->ops->tick(both.gpu);
            assert_true(++steps < 1000);
        }
        assert_true(steps > 0);
        assert_same(&both.gpu_state, &rolling);
        assert_false(engine_gpu_checkpoint_step(both.gpu, &rolling));
    }
    checkpoint_finish(&rolling);
    gpu_case_finish(&both);
}

/* Of all threads: what others do on the machine does not count. */
static double processor_s(void)
{
    struct timespec time;
    clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &time);
    return (double)time.tv_sec + (double)time.tv_nsec * 1e-9;
}

/* From the loss to a painting that ticks again. */
static void survives_the_loss_of_its_context(void **state)
{
    (void)state;
    struct painting_def def = painting_default_def();
    def.width = def.height = 512;
    def.threads = 1;
    struct gpu_case both;
    struct checkpoint rolling;
    struct device_error error;
    gpu_case_init(&both, &def);
    assert_true(checkpoint_init(&rolling, &def));
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){0.5f, 0.5f};
    drop.brush = 1;
    gpu_case_act(&both, &drop);
    for (int tick = 0; tick < 40; tick++) {
        both.gpu->ops->tick(both.gpu);
    }
    assert_true(engine_gpu_checkpoint_begin(both.gpu));
    for (int steps = 0; !engine_gpu_checkpoint_step(both.gpu, &rolling);) {
        both.gpu->ops->tick(both.gpu);
        assert_true(++steps < 1000);
    }
    display_inject_reset(both.display);
    assert_true(display_lost(both.display));
    double start = processor_s();
    engine_destroy(both.gpu);
    assert_true(display_renew(both.display, &error));
    assert_true(display_begin(both.display));
    both.gpu = gpu_engine(&def);
    assert_true(both.gpu->ops->load(both.gpu, &rolling));
    both.gpu->ops->finish(both.gpu);
    double took = processor_s() - start;
    print_message("rebuilt in %.2f s of a processor\n", took);
    assert_true(took < 3.0 * SLOWER); /* .3 s; a second is promised */
    assert_true(both.gpu->ops->save(both.gpu, &both.gpu_state));
    assert_same(&rolling, &both.gpu_state);
    assert_true(both.gpu_state.tick >= 40);
    assert_true(both.cpu->ops->load(both.cpu, &rolling));
    gpu_case_tick(&both, 3);
    gpu_case_compare(&both, 2e-3, 10);
    checkpoint_finish(&rolling);
    gpu_case_finish(&both);
}

static void read_texture(unsigned texture, int width, int height, float *texels)
{
    GLuint framebuffer;
    glGenFramebuffers(1, &framebuffer);
    glBindFramebuffer(GL_FRAMEBUFFER, framebuffer);
    glFramebufferTexture2D(GL_FRAMEBUFFER, GL_COLOR_ATTACHMENT0, GL_TEXTURE_2D, texture, 0);
    assert_int_equal(glCheckFramebufferStatus(GL_FRAMEBUFFER), GL_FRAMEBUFFER_COMPLETE); /* llvmpipe draws to them */
    glReadPixels(0, 0, width, height, GL_RGBA, GL_FLOAT, texels);
    glDeleteFramebuffers(1, &framebuffer);
}

/* What the CPU publishes and what the GPU does; also by way of an upload. */
static void publishes_what_the_cpu_does(void **state)
{
    (void)state;
    struct painting_def def = busy_def();
    struct gpu_case both;
    struct fields fields;
    gpu_case_init(&both, &def);
    grow(both.cpu, 150, &both.cpu_state);
    assert_true(both.gpu->ops->load(both.gpu, &both.cpu_state));
    size_t values = 4 * (size_t)def.width * (size_t)def.height;
    float *cpu = calloc(FIELDS_COUNT * values, sizeof *cpu), *gpu = calloc(values, sizeof *gpu);
    assert_true(cpu && gpu);
    struct painting_texels texels = {cpu, cpu + values, cpu + 2 * values, cpu + 3 * values};
    painting_publish(engine_cpu_painting(both.cpu), &texels);
    assert_true(fields_create(&fields, def.width, def.height, true));
    read_texture(fields.texture[FIELDS_VECTORS], def.width, def.height, gpu);
    for (size_t i = 0; i < values; i++) {
        assert_true(gpu[i] == 0.0f);
    }
    engine_gpu_publish(both.gpu, &fields);
    for (int texture = 0; texture < FIELDS_COUNT; texture++) {
        const float *want = cpu + (size_t)texture * values;
        float most = 0.0f;
        read_texture(fields.texture[texture], def.width, def.height, gpu);
        for (size_t i = 0; i < values; i++) {
            most = want[i] > most ? want[i] : most;
            assert_true(fabsf(gpu[i] - want[i]) <= 1e-5f * (1.0f + fabsf(want[i])));
        }
        assert_true(most > 0.0f);
    }
    for (size_t i = 0; i < values; i++) {
        cpu[i] = (float)i;
    }
    fields_upload(&fields, (const float *const[FIELDS_COUNT]){[FIELDS_INK] = cpu});
    read_texture(fields.texture[FIELDS_INK], def.width, def.height, gpu);
    assert_memory_equal(gpu, cpu, values * sizeof *cpu);
    read_texture(fields.texture[FIELDS_GROUND], def.width, def.height, gpu);
    assert_true(gpu[3] > 0.5f); /* catalyst: as it was */
    fields_finish(&fields);
    fields_finish(&fields);
    assert_true(fields_create(&fields, 32, 16, false));
    assert_true(fields.texture[FIELDS_INK] && !fields.texture[FIELDS_PATTERN]);
    fields_finish(&fields);
    free(cpu);
    free(gpu);
    gpu_case_finish(&both);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(goes_to_the_gpu_and_back),
        cmocka_unit_test(goes_on_from_what_it_saved),
        cmocka_unit_test(a_rolling_checkpoint_is_of_one_moment),
        cmocka_unit_test(survives_the_loss_of_its_context),
        cmocka_unit_test(publishes_what_the_cpu_does),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
