/* The GPU engine grows what the CPU engine grows: not the same bits, but the same dendrite. */
#include <math.h>

#include "band.h"
#include "display.h"
#include "figure.h"
#include "painting_gpu.h"
#include "subject.h"

enum { SIDE = 256, TICKS = 700 };

/* What the GPU has grown after so many ticks, in the place of what the subject has. */
static void grow_on_gpu(struct subject *subject, const struct painting_def *def)
{
    struct display_def display_def = display_default_def();
    struct device_error device_error;
    struct shader_error error;
    struct checkpoint checkpoint;
    display_def.kind = DISPLAY_HEADLESS;
    display_def.width = display_def.height = 16;
    struct display *display = display_create(&display_def, &device_error);
    if (!display || !display_begin(display)) {
        figure_stop("display", display ? "not to be drawn to" : device_error.text);
    }
    struct engine *engine = engine_gpu_create(def, NULL, &error);
    if (!engine || !checkpoint_init(&checkpoint, def)) {
        figure_stop("GPU engine", engine ? "no memory" : error.text);
    }
    struct action drop = subject_drop(0.5f, 0.5f);
    engine->ops->act(engine, &drop);
    for (int tick = 0; tick < TICKS; tick++) {
        engine->ops->tick(engine);
    }
    if (!engine->ops->save(engine, &checkpoint) || !painting_load(subject->painting, &checkpoint)) {
        figure_stop("checkpoint", "the GPU does not answer");
    }
    checkpoint_finish(&checkpoint);
    engine_destroy(engine);
    display_destroy(display);
}

static void show(struct subject *subject, struct sheet *sheet, const char *name, const struct shape_figures *shape)
{
    subject_show_depth(subject, sheet, "%s\nR %.0f, %.3f edge, %.1f junctions\n%.1f tips, %.2f hull, %.1f wide", name,
                       shape->radius, shape->perimeter_per_cell, shape->junctions_per_1000, shape->tips_per_1000,
                       shape->hull_share, shape->mean_width);
    subject_show_ink(subject, sheet, SUBJECT_LIT, "%s", name);
}

static void check_near(struct figure *figure, const char *what, double gpu, double cpu, double share)
{
    figure_check(figure, fabs(gpu / cpu - 1) <= share, "%s: %.4g on the GPU, %.4g on the CPU, within %.2g %%", what,
                 gpu, cpu, 100 * share);
}

void figure_gpu(struct figure *figure)
{
    static const char *const NAMES[2] = {"CPU engine", "GPU engine"};
    struct sheet *sheet = sheet_create(figure, "One drop, 700 ticks, on either engine", 2, 2, SIDE);
    struct shape_figures shapes[2];
    struct painting_totals totals[2];
    for (int engine = 0; engine < 2; engine++) {
        struct painting_def def = subject_def(SIDE);
        struct subject subject = subject_create(&def);
        struct action drop = subject_drop(0.5f, 0.5f);
        if (engine == 0) {
            painting_act(subject.painting, &drop);
            subject_run(&subject, TICKS);
        } else {
            grow_on_gpu(&subject, &def);
        }
        shapes[engine] = subject_measure(&subject);
        totals[engine] = painting_totals(subject.painting);
        show(&subject, sheet, NAMES[engine], &shapes[engine]);
        subject_finish(&subject);
    }
    sheet_finish(sheet);
    char outside[256];
    int count = band_outside(&shapes[1], outside, sizeof outside);
    figure_check(figure, shapes[1].radius >= 70 && shapes[1].radius <= 110, "radius %.1f in 70 to 110",
                 shapes[1].radius);
    figure_check(figure, count == 0, "outside the bands of a dendrite: %s", outside);
    check_near(figure, "radius", shapes[1].radius, shapes[0].radius, 0.05);
    check_near(figure, "area", (double)shapes[1].area, (double)shapes[0].area, 0.05);
    check_near(figure, "carved", totals[1].carved, totals[0].carved, 0.05);
    check_near(figure, "catalyst", totals[1].catalyst, totals[0].catalyst, 0.02);
    check_near(figure, "solvent", totals[1].solvent, totals[0].solvent, 1e-4);
    check_near(figure, "ink", totals[1].ink, totals[0].ink, 1e-4);
    check_near(figure, "pigment", totals[1].wet[0] + totals[1].dry[0], totals[0].wet[0] + totals[0].dry[0], 0.05);
}
