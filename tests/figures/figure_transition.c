/* From one scene to the next: frost that grows over a painting and thaws on another, a sheet that dries and is wetted
 * again. */
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "figure.h"
#include "subject.h"
#include "transition.h"

enum { SIDE = 420, PIXELS = SIDE * SIDE, GROWN = 600, DROPS = 5, APART = 24 };

struct stage {
    uint8_t *first, *next; /* the paintings */
    uint8_t *shown;
};

/* As it is after GROWN ticks. */
static uint8_t *paint(const int ink[DROPS])
{
    static const struct {
        float x, y;
        const char *brush;
        float solvent;
    } AT[DROPS] = {{0.32f, 0.34f, "fern", 330},
                   {0.72f, 0.3f, "coral", 200},
                   {0.7f, 0.72f, "lichen", 200},
                   {0.27f, 0.78f, "mocha", 180},
                   {0.5f, 0.55f, "moss", 60}};
    struct painting_def def = subject_def(SIDE);
    def.margin = 24;
    struct subject subject = subject_create(&def);
    for (int i = 0; i < DROPS; i++) {
        bool turned = ink[0] > 0; /* the second one */
        struct action drop = subject_drop(turned ? 1 - AT[i].y : AT[i].x, turned ? AT[i].x : AT[i].y);
        drop.ink = ink[i];
        drop.brush = brush_find(AT[i].brush);
        drop.edge = EDGE_RAGGED;
        drop.solvent = AT[i].solvent;
        drop.amount = 0.4f * AT[i].solvent;
        painting_act(subject.painting, &drop);
    }
    subject_run(&subject, GROWN);
    uint8_t *rgb = subject_picture(&subject, SIDE, SUBJECT_LIT);
    subject_finish(&subject);
    return rgb;
}

static void show(struct stage *stage, const struct transition *transition, double share)
{
    memcpy(stage->shown, share < 1 ? stage->first : stage->next, (size_t)PIXELS * 3);
    if (!transition_reveal(transition, share, stage->shown)) {
        figure_stop("transition", "memory is short");
    }
}

/* Pixels that are others than those of the painting below. */
static bool is_covered(const struct stage *stage, double share, int pixel)
{
    const uint8_t *below = share < 1 ? stage->first : stage->next;
    int apart = 0;
    for (int c = 0; c < 3; c++) {
        apart += abs(below[3 * pixel + c] - stage->shown[3 * pixel + c]);
    }
    return apart > 0;
}

struct extent {
    double share; /* of the sheet that is covered */
    double edge;  /* length of its outline, sides of the sheet */
};

static struct extent measure(const struct stage *stage, double share)
{
    int covered = 0, edges = 0;
    for (int i = 0; i < PIXELS; i++) {
        bool own = is_covered(stage, share, i);
        covered += own;
        edges += i % SIDE > 0 && own != is_covered(stage, share, i - 1);
        edges += i >= SIDE && own != is_covered(stage, share, i - SIDE);
    }
    return (struct extent){(double)covered / PIXELS, (double)edges / SIDE};
}

static double mean_apart(const uint8_t *a, const uint8_t *b)
{
    double sum = 0;
    for (int i = 0; i < 3 * PIXELS; i++) {
        sum += abs(a[i] - b[i]);
    }
    return sum / (3.0 * PIXELS);
}

static void film(struct figure *figure, struct sheet *sheet, struct stage *stage, enum transition_kind kind)
{
    static const double SHARES[] = {0.12, 0.25, 0.42, 0.62, 0.8, 1, 1.35, 1.7};
    const char *name = transition_names[kind];
    struct transition transition;
    struct extent half = {0, 0};
    if (!transition_init(&transition, kind, 12, SIDE, SIDE)) {
        figure_stop("transition", "memory is short");
    }
    for (size_t i = 0; i < sizeof SHARES / sizeof *SHARES; i++) {
        show(stage, &transition, SHARES[i]);
        struct extent extent = measure(stage, SHARES[i]);
        half = i == 2 ? extent : half;
        sheet_add(sheet, stage->shown, "%s, %.2f of 2\n%.0f %% is covered", name, SHARES[i], 100 * extent.share);
    }
    figure_check(figure, half.share > 0.35 && half.share < 0.7, "%s: half way %.0f %% is covered", name,
                 100 * half.share);
    if (kind == TRANSITION_FREEZE) {
        figure_check(figure, half.edge > 14, "frost is feathered: its outline is %.1f sides of the sheet", half.edge);
    } else {
        figure_check(figure, half.edge < 9, "what dries has one front: its outline is %.1f sides", half.edge);
    }
    memcpy(stage->shown, stage->first, (size_t)PIXELS * 3);
    (void)transition_reveal(&transition, 1, stage->shown);
    uint8_t *other = malloc((size_t)PIXELS * 3);
    if (!other) {
        figure_stop("transition", "memory is short");
    }
    memcpy(other, stage->next, (size_t)PIXELS * 3);
    (void)transition_reveal(&transition, 1, other);
    figure_check(figure, mean_apart(stage->shown, other) <= 0, "%s: nothing of either painting is seen through it",
                 name);
    free(other);
    show(stage, &transition, 2);
    figure_check(figure, mean_apart(stage->shown, stage->next) <= 0, "%s: at the end the next painting is bare", name);
    transition_finish(&transition);
}

void figure_transition(struct figure *figure)
{
    static const int FIRST[DROPS] = {0, 1, 2, 3, 1}, NEXT[DROPS] = {2, 3, 1, 0, 2};
    struct stage stage = {paint(FIRST), paint(NEXT), malloc((size_t)PIXELS * 3)};
    if (!stage.shown) {
        figure_stop("transition", "memory is short");
    }
    figure_check(figure, mean_apart(stage.first, stage.next) > APART, "the paintings are %.0f of 255 apart",
                 mean_apart(stage.first, stage.next));
    struct sheet *sheet =
        sheet_create(figure, "A painting freezes over and thaws on the next; another one dries", 4, 4, SIDE);
    film(figure, sheet, &stage, TRANSITION_FREEZE);
    film(figure, sheet, &stage, TRANSITION_DRY);
    sheet_finish(sheet);
    free(stage.first);
    free(stage.next);
    free(stage.shown);
}
