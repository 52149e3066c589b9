/* The six brushes, each as its own meaning wants it, and what tells each from the default and from the others. */
#include <math.h>
#include <stdio.h>
#include <string.h>

#include "brush.h"
#include "figure.h"
#include "subject.h"

enum { SIDE = 400, PIXELS = 800, BRUSHES = 6, KINDS = BRUSHES + 1, REACH = 190, RADIUS = 165, MOST = 3600 };

/* Grown until a tip has come RADIUS cells; at 45 % of it a second drop, of the second ink. `brush` BRUSH_NONE: default.
 */
static struct shape_figures grow(int brush, uint32_t seed, struct sheet *sheet)
{
    struct painting_def def = subject_def(SIDE);
    def.seed = seed;
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(0.5f, 0.5f);
    const char *name = "default";
    drop.edge = EDGE_RAGGED;
    drop.solvent = 200;
    drop.amount = 110;
    drop.radius = 10;
    if (brush != BRUSH_NONE) {
        const struct brush *like = &brushes[brush];
        name = like->name;
        drop.brush = brush;
        drop.reach = REACH;
        drop.solvent = like->solvent;
        drop.amount = like->amount;
        drop.radius = like->radius;
        subject.inks[0] = ink_find(like->inks[0]);
        subject.inks[1] = ink_find(like->inks[1]);
    }
    painting_act(subject.painting, &drop);
    struct shape_figures shape = {0};
    bool second = false;
    int ticks = 0;
    for (; ticks < MOST && shape.radius < RADIUS; ticks += 50) {
        subject_run(&subject, 50);
        shape = subject_measure(&subject);
        if (!second && shape.radius > 0.45 * RADIUS) {
            drop.ink = 1;
            drop.brush = BRUSH_NONE;
            drop.solvent = 60;
            painting_act(subject.painting, &drop);
            second = true;
        }
    }
    subject_show_ink(
        &subject, sheet, SUBJECT_LIT,
        "%s, seed %u: %d ticks, R %.0f\n%.3f edge, %.1f junctions, %.1f tips, %.2f hull, %.1f and %.0f wide", name,
        seed, ticks, shape.radius, shape.perimeter_per_cell, shape.junctions_per_1000, shape.tips_per_1000,
        shape.hull_share, shape.mean_width, shape.largest_width);
    subject_finish(&subject);
    return shape;
}

/* The figure in which two shapes differ most, as a share of the smaller value. */
static double difference(const struct shape_figures *one, const struct shape_figures *other, const char **name)
{
    const struct {
        const char *name;
        double one, other;
    } figures[] = {
        {"perimeter per cell", one->perimeter_per_cell, other->perimeter_per_cell},
        {"junctions", one->junctions_per_1000, other->junctions_per_1000},
        {"tips", one->tips_per_1000, other->tips_per_1000},
        {"mean width", one->mean_width, other->mean_width},
    };
    double most = 0;
    for (size_t i = 0; i < sizeof figures / sizeof figures[0]; i++) {
        double share = fabs(log(figures[i].one / figures[i].other));
        if (share > most) {
            most = share;
            *name = figures[i].name;
        }
    }
    return exp(most) - 1;
}

void figure_brushes(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "The brushes", 4, 2, PIXELS);
    struct shape_figures shapes[KINDS];
    for (int kind = 0; kind < KINDS; kind++) {
        shapes[kind] = grow(kind < BRUSHES ? kind : BRUSH_NONE, 1, sheet);
    }
    /* The brush that varies most over the sheet, once more. */
    struct shape_figures fern = grow(brush_find("fern"), 2, sheet);
    sheet_finish(sheet);
    const char *by = "nothing";
    double same = difference(&shapes[brush_find("fern")], &fern, &by);
    figure_check(figure, same < 0.5, "fern is fern with another seed: at most %.0f %% apart, by %s", 100 * same, by);
    for (int one = 0; one < KINDS; one++) {
        for (int other = one + 1; other < KINDS; other++) {
            const char *name = "nothing";
            double most = difference(&shapes[one], &shapes[other], &name);
            figure_check(figure, most > 0.2, "%s and %s are told apart by %s: %.0f %%, over 20 %%", brushes[one].name,
                         other < BRUSHES ? brushes[other].name : "default", name, 100 * most);
        }
    }
}
