/* A portrait that is painted by growing ink: a structure over a picture as first ink, mask, guide and wet ground. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "fit.h"
#include "session.h"
#include "structure.h"
#include "subject.h"

enum { SIDE = 416, SHOWN = 640, TICKS = 420, GAP = 11, MOVED = 36, BLUR = 3 };

struct board {
    float dark[SIDE * SIDE], thin[SIDE * SIDE], along[2 * SIDE * SIDE]; /* rasters of the structure */
    float picture[SIDE * SIDE];                                         /* how dark the picture is */
    float inked[SIDE * SIDE], work[SIDE * SIDE];
};

static void read_picture(struct image *picture, struct board *board)
{
    char folder[1200], path[1300];
    struct image image;
    struct file_error error;
    struct image_def def = image_default_def();
    def.helper = FIGURES_HELPER;
    if (!stock_find(folder, sizeof folder)) {
        figure_stop("portrait", "the pictures that come with Frond are not built");
    }
    snprintf(path, sizeof path, "%s/portrait-girl.png", folder);
    if (!image_read(path, &def, &image, &error)) {
        figure_stop("portrait", error.text);
    }
    float *small = fit_linear(&image, SIDE, SIDE);
    for (int i = 0; small && i < SIDE * SIDE; i++) {
        board->picture[i] = 1 - ink_encode(small[4 * i + 1]);
    }
    if (!small || image.channels < 3) {
        figure_stop("portrait", "no memory, or no colours");
    }
    free(small);
    *picture = image;
}

static void grow(struct board *board)
{
    struct image picture;
    struct growth_def growth = growth_preset(METAPHOR_INK, false);
    const struct structure_def wide = {.detail = 512, .width = 1.6f, .fade = 6}, thin = {.detail = 512};
    growth.endpoints = 2600;
    growth.gradient = 4;
    read_picture(&picture, board);
    if (!structure_raster(&picture, &growth, &wide, STRUCTURE_DARK, SIDE, SIDE, board->dark) ||
        !structure_raster(&picture, &growth, &thin, STRUCTURE_DARK, SIDE, SIDE, board->thin) ||
        !structure_raster(&picture, &growth, &wide, STRUCTURE_ALONG, SIDE, SIDE, board->along)) {
        figure_stop("portrait", "no memory");
    }
    image_finish(&picture);
}

static struct action laid(enum action_verb verb, const float *raster, int channels)
{
    struct action action = action_default(verb);
    action.picture = (struct action_raster){raster, SIDE, SIDE, channels};
    return action;
}

static void lay_structure(struct subject *subject, const struct board *board)
{
    struct action mask = laid(ACTION_MASK, board->dark, 1), guide = laid(ACTION_GUIDE, board->along, 2);
    struct action solvent = laid(ACTION_BRUSH_SOLVENT, board->dark, 1), line = laid(ACTION_DRAW, board->thin, 1);
    mask.invert = true;
    guide.strength = 0.6f;
    solvent.amount = 6;
    line.ink = 1;
    line.amount = 0.2f;
    line.over = OVER_RUN;
    painting_act(subject->painting, &mask);
    painting_act(subject->painting, &guide);
    painting_act(subject->painting, &solvent);
    painting_act(subject->painting, &line);
}

/* Small drops on branches of the sitter, GAP cells apart; what is behind her stays paper. */
static int drop_on_branches(struct subject *subject, const struct board *board)
{
    static struct point at[2000];
    int count = 0;
    for (int y = 4; y < SIDE - 4; y++) {
        for (int x = 4; x < SIDE - 4; x++) {
            float u = ((float)x + 0.5f) / SIDE, v = ((float)y + 0.5f) / SIDE;
            bool sitter = (u > 0.25f && u < 0.77f && v > 0.35f && v < 0.86f) ||
                          hypotf((u - 0.51f) / 0.26f, (v - 0.36f) / 0.29f) < 1 ||
                          v > 0.79f + 1.35f * (u - 0.5f) * (u - 0.5f);
            bool free = sitter && board->dark[y * SIDE + x] < 0.3f && count < 2000;
            for (int i = 0; i < count && free; i++) {
                free = hypotf(at[i].x - u, at[i].y - v) * SIDE >= GAP;
            }
            if (free) {
                struct action drop = subject_drop(u, v);
                drop.radius = 2;
                drop.solvent = 50;
                drop.amount = 50;
                drop.ink = v > 0.8f ? 0 : board->picture[y * SIDE + x] > 0.45f ? 3 : 1;
                painting_act(subject->painting, &drop);
                at[count++] = (struct point){u, v};
            }
        }
    }
    return count;
}

static void blur(struct board *board, float *plane)
{
    for (int pass = 0; pass < 2; pass++) {
        for (int i = 0; i < SIDE * SIDE; i++) {
            float sum = 0;
            int x = i % SIDE, y = i / SIDE, count = 0;
            for (int k = -BLUR; k <= BLUR; k++) {
                int u = pass ? x : x + k, v = pass ? y + k : y;
                if (u >= 0 && v >= 0 && u < SIDE && v < SIDE) {
                    sum += plane[v * SIDE + u];
                    count++;
                }
            }
            board->work[i] = sum / (float)count;
        }
        memcpy(plane, board->work, sizeof board->work);
    }
}

static double correlate(const float *a, const float *b, int moved)
{
    double sa = 0, sb = 0, saa = 0, sbb = 0, sab = 0, n = SIDE * SIDE;
    for (int i = 0; i < SIDE * SIDE; i++) {
        double p = (double)a[i], q = (double)b[i / SIDE * SIDE + (i + moved) % SIDE];
        sa += p;
        sb += q;
        saa += p * p;
        sbb += q * q;
        sab += p * q;
    }
    return (sab - sa * sb / n) / sqrt((saa - sa * sa / n) * (sbb - sb * sb / n));
}

/* Growth keeps to the structure, fills most of what lies under her outline, and has her tones. */
static void check(struct figure *figure, struct subject *subject, struct board *board)
{
    const float *depth = subject_depth(subject);
    int outside = 0, grown = 0;
    for (int i = 0; i < SIDE * SIDE; i++) {
        bool carved = depth[i] > 0.1f;
        outside += carved && board->dark[i] >= 0.5f;
        grown += carved;
        board->inked[i] = carved;
        board->thin[i] = 1 - board->dark[i];
    }
    figure_check(figure, outside == 0 && grown > SIDE * SIDE / 12, "%d cells have grown, %d of them off the structure",
                 grown, outside);
    blur(board, board->inked);
    blur(board, board->thin);
    blur(board, board->picture);
    double branches = correlate(board->inked, board->thin, 0), there = correlate(board->inked, board->picture, 0);
    double moved = correlate(board->inked, board->picture, MOVED);
    figure_check(figure, branches > 0.6, "growth beside its structure: correlation %.2f", branches);
    figure_check(figure, there > 0.45 && there > moved + 0.1,
                 "growth beside the darks of the picture: correlation %.2f, moved by %d cells %.2f", there, MOVED,
                 moved);
}

void figure_portrait(struct figure *figure)
{
    struct board *board = calloc(1, sizeof *board);
    struct painting_def def = subject_def(SIDE);
    struct subject subject = subject_create(&def);
    static const char *const INKS[] = {"phthalo turquoise", "burnt sienna", "ochre", "carbon black"};
    struct sheet *sheet = sheet_create(figure, "A portrait as growing ink", 3, 1, SHOWN);
    if (!board) {
        figure_stop("portrait", "no memory");
    }
    for (int i = 0; i < INK_PALETTE; i++) {
        subject.inks[i] = ink_find(INKS[i]);
    }
    grow(board);
    lay_structure(&subject, board);
    int drops = drop_on_branches(&subject, board);
    subject_run(&subject, 60);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "%d drops on her structure, after 60 ticks", drops);
    subject_run(&subject, TICKS - 60);
    check(figure, &subject, board);
    struct action unmask = action_default(ACTION_UNMASK), still = action_default(ACTION_SET);
    still.coefficient = (int)(key_find(coefficient_keys, "s_max") - coefficient_keys);
    painting_act(subject.painting, &unmask);
    painting_act(subject.painting, &still);
    subject_show_ink(&subject, sheet, SUBJECT_LIT, "after %d", TICKS);
    subject_show_depth(&subject, sheet, "what has grown");
    sheet_finish(sheet);
    subject_finish(&subject);
    free(board);
}
