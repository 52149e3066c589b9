/* What one scene becomes to another: a fracture as every port of a painting, and pictures, outlines and chemistry made
 * of a painting (app/graph). */
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "feeder.h"
#include "figure.h"
#include "running.h"
#include "script_sheet.h"
#include "sheet.h"

enum { SIDE = 300, CELLS = SIDE * SIDE, TICKS = 500 };

static const char EXHIBIT[] = "exhibit: 1\nsheet: {cells: 90000}\nscenes:\n"
                              "  - {id: cracks, kind: lightning, lightning: {kind: fracture, thickness: 2}, opening: "
                              "[{strike: {at: [0.4, 0.4]}}, "
                              "{strike: {at: [0.75, 0.7]}}]}\n"
#define PAINTING(id, input)                                                                                            \
    "  - {id: " id ", inks: [carbon, ochre], inputs: [{from: cracks, tick: 150, " input "}], opening: [{drop: {at: "   \
    "[0.4, 0.4], ink: carbon, solvent: 120}}]}\n"
    PAINTING("guide", "of: along, as: guide, strength: 1") PAINTING("mask", "as: mask")
        PAINTING("obstacles", "as: mask, invert: true")
            PAINTING("coefficient", "as: coefficient, coefficient: s_max, value: 1, to: 0.15")
                PAINTING("ink", "as: ink, ink: ochre") PAINTING("relief", "as: relief, strength: 1")
                    PAINTING("background",
                             "as: background") "  - {id: trees, kind: trees, trees: {endpoints: 1500}, inputs: [{from: "
                                               "obstacles, as: picture, tick: 500}], opening: "
                                               "[{plant: {at: [0.4, 0.4]}}]}\n"
                                               "  - {id: outline, kind: lightning, lightning: {kind: coral}, inputs: "
                                               "[{from: guide, as: outline, tick: 300}]}\n"
                                               "  - {id: seeds, kind: chemistry, chemistry: {preset: worms_and_spots, "
                                               "start: nothing}, inputs: [{from: cracks, as: "
                                               "seeds, tick: 150}]}\n"
                                               "  - {id: style, kind: chemistry, chemistry: {preset: fingerprint}, "
                                               "inputs: [{from: guide, as: style, tick: 500}, "
                                               "{from: cracks, of: along, as: orientation, tick: 150}]}\n";

struct composition {
    struct figure *figure;
    struct sheet *sheet;
    struct feeder *feeder;
    const float *cracks; /* dark */
};

/* Of what is dark in a scene, the share that lies where the source has grown. */
static double share_on(const struct composition *composition, const struct outcome *outcome, int *dark)
{
    int on = 0;
    *dark = 0;
    for (int i = 0; i < outcome->width * outcome->height; i++) {
        bool is = outcome->fields[FIELD_DARK][i] < 0.5f;
        *dark += is;
        on += is && composition->cracks[i] < 0.5f;
    }
    return *dark > 0 ? (double)on / *dark : 0;
}

static void draw_scene(struct composition *composition, int index, const char *id)
{
    struct feeder_session *session = calloc(1, sizeof *session);
    struct file_error error;
    struct running running = {.script = NULL};
    struct easel_picture picture = {.picture = NULL};
    struct easel_def def = {.engine = ENGINE_CPU};
    if (!session || !feeder_open(composition->feeder, index, TICKS, session, &error) ||
        !running_open(&running, &session->script, &def, &error)) {
        figure_stop("composition", session ? error.text : "no memory");
    }
    for (int64_t tick = 0; tick <= TICKS; tick++) {
        running_act(&running, tick, NULL, NULL);
        if (!running_plot(&running, tick, &error)) {
            figure_stop("composition", error.text);
        }
        if (tick < TICKS) {
            running_tick(&running);
        }
    }
    struct picture_def shown = script_picture(&session->script, SIDE, SIDE);
    struct easel_scene scene = {running.engine, running.plot, TICKS};
    struct outcome outcome;
    int dark = 0;
    if (!easel_frame(&running.easel, &picture, &shown, session->script.ink_count) ||
        !easel_draw(&picture, &scene, &error) ||
        !outcome_take(&outcome, running.engine, running.plot, session->script.ink_count)) {
        figure_stop("composition", "no memory");
    }
    double on = share_on(composition, &outcome, &dark);
    sheet_add(composition->sheet, picture.rgb, "%s: %d cells dark, %.0f %% of them on the cracks", id, dark, 100 * on);
    figure_check(composition->figure, dark > 200, "%s: something has grown", id);
    if (strcmp(id, "mask") == 0) {
        figure_check(composition->figure, on > 0.95, "mask: growth keeps to the cracks");
    } else if (strcmp(id, "obstacles") == 0) {
        figure_check(composition->figure, on < 0.05, "obstacles: growth keeps off the cracks");
    } else if (strcmp(id, "ink") == 0) {
        figure_check(composition->figure, on > 0.2, "ink: the cracks are drawn");
    }
    outcome_finish(&outcome);
    easel_unframe(&picture);
    running_close(&running);
    feeder_close(session);
    free(session);
}

void figure_composition(struct figure *figure)
{
    struct script_def def = script_default_def();
    struct report report;
    struct file_error error;
    report_init(&report, "composition.yaml");
    struct exhibit *exhibit = exhibit_parse(EXHIBIT, strlen(EXHIBIT), ".", &def, &report);
    if (!exhibit) {
        figure_stop("composition", report_text(&report));
    }
    for (int i = 0; i < exhibit->scene_count; i++) {
        script_fit(exhibit->scenes[i].script, SIDE, SIDE);
    }
    struct composition composition = {figure, sheet_create(figure, "One scene becomes another's", 4, 3, SIDE),
                                      feeder_create(&(struct feeder_def){exhibit, def, 0, NULL}), NULL};
    const struct outcome *cracks = composition.feeder ? feeder_outcome(composition.feeder, 0, 150, &error) : NULL;
    if (!cracks) {
        figure_stop("composition", composition.feeder ? error.text : "no memory");
    }
    composition.cracks = cracks->fields[FIELD_DARK];
    for (int i = 0; i < exhibit->scene_count; i++) {
        draw_scene(&composition, i, exhibit->scenes[i].id);
    }
    sheet_finish(composition.sheet);
    feeder_destroy(composition.feeder);
    exhibit_destroy(exhibit);
    report_finish(&report);
}
