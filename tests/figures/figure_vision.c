/* The same sheet in four palettes, as people of five kinds of vision see it. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "figure.h"
#include "picture.h"
#include "subject.h"
#include "vision.h"

enum { SIDE = 240, GROWN = 520 };

static const char *const PALETTES[] = {"harbour", "kingfisher", "lantern", "earth"};
enum { PALETTE_COUNT = sizeof PALETTES / sizeof PALETTES[0] };

struct seen {
    struct subject subject;
    float depth[SIDE * SIDE], ink[PAINTING_INKS][SIDE * SIDE];
    uint8_t rgb[SIDE * SIDE * 3], shown[SIDE * SIDE * 3];
};

static void paint(struct seen *seen)
{
    static const char *const BRUSHES[] = {"fern", "coral", "lichen", "frost", "moss"};
    static const struct point PLACES[] = {{0.27f, 0.27f}, {0.73f, 0.27f}, {0.27f, 0.73f}, {0.73f, 0.73f}};
    struct painting_def def = subject_def(SIDE);
    seen->subject = subject_create(&def);
    for (int i = 0; i < PAINTING_INKS; i++) {
        struct action drop = subject_drop(PLACES[i].x, PLACES[i].y);
        drop.ink = i;
        drop.brush = brush_find(BRUSHES[i]);
        drop.edge = EDGE_RAGGED;
        drop.solvent = 150;
        drop.amount = 60;
        painting_act(seen->subject.painting, &drop);
    }
    subject_run(&seen->subject, GROWN);
    memcpy(seen->depth, subject_depth(&seen->subject), sizeof seen->depth);
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        for (int layer = PAINTING_WET; layer <= PAINTING_DRY; layer += PAINTING_DRY - PAINTING_WET) {
            const float *plane = subject_read(&seen->subject, (enum painting_field)(layer + ink));
            for (int i = 0; i < SIDE * SIDE; i++) {
                seen->ink[ink][i] += plane[i];
            }
        }
    }
}

static void draw(struct seen *seen, const struct palette *palette)
{
    struct picture_def def = picture_default_def();
    struct picture_planes planes = {.depth = seen->depth};
    def.width = def.height = def.cells_x = def.cells_y = SIDE;
    for (int ink = 0; ink < INK_PALETTE; ink++) {
        def.ink[ink] = ink_find(palette->inks[ink]);
        planes.ink[ink] = seen->ink[ink];
    }
    struct picture *picture = picture_create(&def);
    if (!picture) {
        figure_stop("picture", "no memory");
    }
    picture_draw(picture, &planes, seen->rgb);
    picture_destroy(picture);
}

/* The picture as they see it, in seen->shown; the mean L*a*b* of what is well covered by each ink in `labs`. */
static void look(struct seen *seen, enum vision vision, float labs[INK_PALETTE][3])
{
    double sums[INK_PALETTE][3] = {{0}};
    int counts[INK_PALETTE] = {0};
    for (int i = 0; i < SIDE * SIDE; i++) {
        float colour[3];
        for (int c = 0; c < 3; c++) {
            colour[c] = ink_decode((float)seen->rgb[3 * i + c] / 255);
        }
        vision_see(vision, colour, colour);
        for (int ink = 0; ink < INK_PALETTE; ink++) {
            bool own = seen->depth[i] > 0.3f && seen->ink[ink][i] > 0.3f;
            counts[ink] += own;
            for (int c = 0; c < 3; c++) {
                sums[ink][c] += own ? (double)colour[c] : 0;
            }
        }
        for (int c = 0; c < 3; c++) {
            seen->shown[3 * i + c] = (uint8_t)(255 * ink_encode(colour[c]) + 0.5f);
        }
    }
    for (int ink = 0; ink < INK_PALETTE; ink++) {
        float mean[3];
        for (int c = 0; c < 3; c++) {
            mean[c] = counts[ink] ? (float)(sums[ink][c] / counts[ink]) : 0;
        }
        vision_lab(mean, labs[ink]);
    }
}

static double nearest(float labs[INK_PALETTE][3])
{
    double least = 1e9;
    for (int i = 0; i < INK_PALETTE; i++) {
        for (int j = 0; j < i; j++) {
            least = fmin(least, (double)vision_distance(labs[i], labs[j]));
        }
    }
    return least;
}

void figure_vision(struct figure *figure)
{
    struct seen *seen = calloc(1, sizeof *seen);
    if (!seen) {
        figure_stop("picture", "no memory");
    }
    paint(seen);
    struct sheet *sheet = sheet_create(figure, "Palettes as they are seen", VISIONS, PALETTE_COUNT, SIDE);
    for (int p = 0; p < PALETTE_COUNT; p++) {
        const struct palette *palette = &palettes[palette_find(PALETTES[p])];
        double least = 1e9, grey = 0;
        draw(seen, palette);
        for (enum vision vision = VISION_USUAL; vision < VISIONS; vision++) {
            float labs[INK_PALETTE][3];
            look(seen, vision, labs);
            double apart = nearest(labs);
            sheet_add(sheet, seen->shown, "%s, %s\nnearest two inks %.0f apart", palette->name, vision_name(vision),
                      apart);
            least = vision < VISION_GREY ? fmin(least, apart) : least;
            grey = apart;
        }
        figure_check(figure, palette->safe ? least >= (double)VISION_TINT_LEAST : least < (double)VISION_TINT_LEAST,
                     "%s as painted: the nearest two inks are %.1f apart in whichever vision: %ssafe", palette->name,
                     least, palette->safe ? "" : "not ");
        figure_check(figure, !palette->grey || grey >= (double)VISION_TINT_LEAST, "%s: %.1f apart in grey%s",
                     palette->name, grey, palette->grey ? "" : ", which it does not promise");
    }
    sheet_finish(sheet);
    subject_finish(&seen->subject);
    free(seen);
}
