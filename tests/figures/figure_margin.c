/* The hidden margin: growth that leaves the sheet goes on beyond it, instead of turning square at its edge. */
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 192, MARGIN = 64, WHOLE = SIDE + 2 * MARGIN, TICKS = 800, AWAY = 20 };

static struct subject grow(int side, int margin, uint32_t x, uint32_t y)
{
    struct painting_def def = subject_def(side);
    def.margin = margin;
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop(((float)x + 0.5f) / (float)side, ((float)y + 0.5f) / (float)side);
    painting_act(subject.painting, &drop);
    subject_run(&subject, TICKS);
    return subject;
}

/* How much farther along the edge than away from it a drop near the left edge has grown: its front up and down the
 * sheet over its front to the right. Square growth creeps along the edge. */
static double creep(struct subject *subject, int x, int y)
{
    const float *depth = subject_depth(subject);
    int along = 0, across = 0;
    for (int row = 0; row < subject->height; row++) {
        for (int column = 0; column < subject->width; column++) {
            if (depth[(size_t)row * (size_t)subject->width + (size_t)column] > 0.1f) {
                int up = abs(row - y), right = column - x;
                along = column < 4 && up > along ? up : along;
                across = right > across ? right : across;
            }
        }
    }
    return (double)along / across;
}

void figure_margin(struct figure *figure)
{
    struct subject with = grow(SIDE, MARGIN, AWAY, SIDE / 2);
    struct subject without = grow(SIDE, 0, AWAY, SIDE / 2);
    struct subject larger = grow(WHOLE, 0, AWAY + MARGIN, SIDE / 2 + MARGIN);
    struct sheet *sheet = sheet_create(figure, "A drop near the edge of the sheet", 3, 1, 2 * SIDE);
    subject_show_depth(&with, sheet, "with a margin of %d cells", MARGIN);
    subject_show_depth(&without, sheet, "without");
    subject_show_depth(&larger, sheet, "on a larger sheet");
    sheet_finish(sheet);
    double round = creep(&with, AWAY, SIDE / 2), square = creep(&without, AWAY, SIDE / 2);
    figure_check(figure, round < 1.0 && square > 1.1 * round,
                 "growth along the edge over growth away from it: %.2f with a margin, %.2f without", round, square);
    figure_note(figure, "noise is counted from the corner of the visible sheet: the larger sheet has other noise");
    subject_finish(&with);
    subject_finish(&without);
    subject_finish(&larger);
}
