/* Figures 10, 11, 12 and 14: drawings, guidance, masks, pouring. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 256 };

static float *take_plane(size_t count)
{
    float *plane = calloc(count, sizeof *plane);
    if (!plane) {
        figure_stop("plane", "no memory");
    }
    return plane;
}

/* A garland of petals around the middle, drawn in one stroke. */
static void draw_garland(struct subject *subject, int over)
{
    enum { POINTS = 241 };
    struct point points[POINTS];
    for (int i = 0; i < POINTS; i++) {
        double turn = 2 * acos(-1.0) * i / (POINTS - 1), away = 0.27 + 0.06 * sin(6 * turn);
        points[i] = (struct point){(float)(0.5 + away * cos(turn)), (float)(0.5 + away * sin(turn))};
    }
    struct action draw = action_default(ACTION_DRAW);
    draw.path = (struct action_path){points, POINTS};
    draw.ink = 3;
    draw.over = over;
    painting_act(subject->painting, &draw);
}

struct drawn {
    int64_t line, covered; /* cells of the line; of which growth has taken */
    int64_t outside;       /* carved cells beyond the garland */
    double ink;            /* dry ink of the line that is still there, share */
};

static struct drawn draw_and_grow(int over, struct sheet *sheet, const char *label)
{
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    draw_garland(&subject, over);
    float *line = take_plane(subject.cells);
    painting_read(subject.painting, PAINTING_DRY + 3, line);
    struct action drop = subject_drop(0.5f, 0.5f);
    painting_act(subject.painting, &drop);
    subject_run(&subject, 900);
    struct drawn found = {0};
    const float *depth = subject_depth(&subject), *dry = subject_read(&subject, PAINTING_DRY + 3);
    double before = 0, after = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            size_t i = (size_t)y * SIDE + (size_t)x;
            found.line += line[i] > 0.6f;
            found.covered += line[i] > 0.6f && depth[i] > 0.1f;
            found.outside += depth[i] > 0.1f && hypot(x - 128, y - 128) > 0.34 * SIDE;
            before += (double)line[i];
            after += (double)dry[i];
        }
    }
    const float *wet = subject_read(&subject, PAINTING_WET + 3);
    for (size_t i = 0; i < subject.cells; i++) {
        after += (double)wet[i];
    }
    found.ink = after / before;
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "%s", label);
    free(line);
    subject_finish(&subject);
    return found;
}

void figure_drawing(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "Figure 10: a drawing and a dendrite", 2, 1, 2 * SIDE);
    struct drawn respect = draw_and_grow(OVER_RESPECT, sheet, "growth respects the line");
    struct drawn run = draw_and_grow(OVER_RUN, sheet, "growth runs over it");
    sheet_finish(sheet);
    figure_check(figure, respect.covered == 0, "respect: growth on %lld of %lld cells of the line",
                 (long long)respect.covered, (long long)respect.line);
    figure_check(figure, respect.outside == 0, "respect: %lld carved cells beyond the closed line",
                 (long long)respect.outside);
    figure_check(figure, fabs(respect.ink - 1) < 1e-3, "respect: %.1f %% of the line's ink is still there",
                 100 * respect.ink);
    figure_check(figure, run.covered > run.line / 2, "run: growth on %lld of %lld cells of the line",
                 (long long)run.covered, (long long)run.line);
    figure_check(figure, run.outside > 1000, "run: %lld carved cells beyond the line", (long long)run.outside);
}

static void guide(struct subject *subject, const float *vectors, float strength)
{
    struct action guide = action_default(ACTION_GUIDE);
    guide.formula = (struct action_raster){.values = vectors, .width = SIDE, .height = SIDE, .channels = 2};
    guide.strength = strength;
    painting_act(subject->painting, &guide);
}

struct led {
    double lean;        /* centroid of the shape from the drop, cells along x */
    double right, left; /* radius to the right and to the left */
};

static struct led lead(const float *vectors, float strength, float beta_v, struct sheet *sheet, const char *label)
{
    struct painting_def def = subject_def(SIDE);
    def.coefficients.beta_v = beta_v;
    struct subject subject = subject_create(&def);
    guide(&subject, vectors, strength);
    struct action drop = subject_drop(0.5f, 0.5f);
    painting_act(subject.painting, &drop);
    subject_run(&subject, 450);
    const float *depth = subject_depth(&subject);
    struct led led = {0};
    double area = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            if (depth[(size_t)y * SIDE + (size_t)x] > 0.1f) {
                double along = x - SIDE / 2;
                led.lean += along;
                area++;
                led.right = along > led.right ? along : led.right;
                led.left = -along > led.left ? -along : led.left;
            }
        }
    }
    led.lean /= area;
    subject_show_depth(&subject, sheet, "%s\ncentroid %+.1f cells, right %.0f, left %.0f", label, led.lean, led.right,
                       led.left);
    subject_finish(&subject);
    return led;
}

/* The slope of the sinusoidal field at a column. */
static double slope_at(int x)
{
    const double turn = 2 * acos(-1.0) / 128;
    return 24 * turn * cos(turn * x);
}

/* How well branches lie along the field: mean of cos 2(angle between the two), weighted by how clearly they are
 * branches; 1 along it, -1 across. The field is turned upside down by `sign` -1. */
static double alignment(const float *depth, int start, double sign)
{
    double sum = 0, weight = 0;
    for (int y = 1; y < SIDE - 1; y++) {
        for (int x = start + 20; x < SIDE - 1; x++) {
            const float *here = depth + (size_t)y * SIDE + (size_t)x;
            double gx = (double)here[1] - (double)here[-1], gy = (double)here[SIDE] - (double)here[-SIDE];
            double rise = sign * slope_at(x), across = (gy - rise * gx) * (gy - rise * gx) / (1 + rise * rise);
            sum += 2 * across - (gx * gx + gy * gy);
            weight += gx * gx + gy * gy;
        }
    }
    return sum / weight;
}

static void check_sine(struct figure *figure, struct sheet *sheet, float *vectors)
{
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            size_t i = (size_t)y * SIDE + (size_t)x;
            double rise = slope_at(x), unit = 1 / sqrt(1 + rise * rise);
            vectors[i] = (float)unit;
            vectors[(size_t)SIDE * SIDE + i] = (float)(unit * rise);
        }
    }
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    guide(&subject, vectors, 2);
    for (int i = 0; i < 3; i++) {
        struct action drop = subject_drop(0.06f, 0.2f + 0.3f * (float)i);
        painting_act(subject.painting, &drop);
    }
    subject_run(&subject, 850);
    const float *depth = subject_depth(&subject);
    int start = (int)(0.06f * SIDE), farthest = start;
    for (size_t i = 0; i < subject.cells; i++) {
        int x = (int)(i % SIDE);
        farthest = depth[i] > 0.1f && x > farthest ? x : farthest;
    }
    double along = alignment(depth, start, 1), mirrored = alignment(depth, start, -1);
    subject_show_depth(&subject, sheet,
                       "a sinusoidal field, three drops\nbranches along it %.2f, along its mirror %.2f", along,
                       mirrored);
    subject_finish(&subject);
    figure_check(figure, along > 0.3 && along > mirrored + 0.2,
                 "branches lie along the sine: %.2f; along its mirror image %.2f", along, mirrored);
    figure_check(figure, farthest - start > 128, "for a whole period: %d cells", farthest - start);
}

void figure_guidance(struct figure *figure)
{
    float *vectors = take_plane((size_t)2 * SIDE * SIDE);
    for (size_t i = 0; i < (size_t)SIDE * SIDE; i++) {
        vectors[i] = 1;
    }
    struct sheet *sheet = sheet_create(figure, "Figure 11: a guidance field", 4, 1, SIDE);
    struct led still = lead(vectors, 0, 1.9f, sheet, "no field");
    struct led along = lead(vectors, 1, 1.9f, sheet, "field to the right, beta_v 1.9");
    struct led against = lead(vectors, 1, -1.9f, sheet, "field to the right, beta_v -1.9");
    check_sine(figure, sheet, vectors);
    sheet_finish(sheet);
    free(vectors);
    figure_check(figure, fabs(still.lean) < 3, "no field, no lean: %+.1f cells", still.lean);
    figure_check(figure, along.lean > 5 && along.right > 1.3 * along.left,
                 "grows along the field: lean %+.1f, right %.0f, left %.0f", along.lean, along.right, along.left);
    figure_check(figure, along.right > still.right, "faster than without: %.0f over %.0f", along.right, still.right);
    figure_check(figure, against.lean < -5 && against.left > 1.3 * against.right,
                 "negative beta_v flees it: lean %+.1f, right %.0f, left %.0f", against.lean, against.right,
                 against.left);
}
