/* The hidden margin: growth that leaves the sheet goes on beyond it, instead of turning square at its edge. */
#include <string.h>

#include "figure.h"
#include "subject.h"

enum { SIDE = 256, MARGIN = 96, WHOLE = SIDE + MARGIN, TICKS = 600, X = SIDE - 20, Y = SIDE / 2 };

/* A drop in cell (X, Y). Cells are counted from the corner of the sheet, so all three have the same noise; nothing
 * comes near the left and upper edges. */
static struct subject grow(int side, int margin)
{
    struct painting_def def = subject_def(side);
    def.margin = margin;
    struct subject subject = subject_create(&def);
    struct action drop = subject_drop((X + 0.5f) / (float)side, (Y + 0.5f) / (float)side);
    painting_act(subject.painting, &drop);
    subject_run(&subject, TICKS);
    return subject;
}

/* Cells of the upper left SIDE x SIDE that differ in a field. */
static int differing(struct subject *one, struct subject *other, enum painting_field field)
{
    const float *first = subject_read(one, field), *second = subject_read(other, field);
    int count = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = 0; x < SIDE; x++) {
            count += memcmp(&first[(size_t)y * (size_t)one->width + (size_t)x],
                            &second[(size_t)y * (size_t)other->width + (size_t)x], sizeof *first) != 0;
        }
    }
    return count;
}

/* The share of carved cells in the last two columns of the sheet, 50 cells up and down from the drop. A front that has
 * turned square keeps clear of the wall. */
static double cut_share(struct subject *subject)
{
    const float *depth = subject_depth(subject);
    int carved = 0, cells = 0;
    for (int y = Y - 50; y <= Y + 50; y++) {
        for (int x = SIDE - 2; x < SIDE; x++) {
            cells++;
            carved += depth[(size_t)y * (size_t)subject->width + (size_t)x] > 0.1f;
        }
    }
    return (double)carved / cells;
}

void figure_margin(struct figure *figure)
{
    struct subject with = grow(SIDE, MARGIN), without = grow(SIDE, 0), larger = grow(WHOLE, 0);
    struct sheet *sheet = sheet_create(figure, "A drop near the right edge of the sheet", 3, 1, 3 * SIDE / 2);
    subject_show_depth(&with, sheet, "with a margin of %d cells", MARGIN);
    subject_show_depth(&without, sheet, "without");
    subject_show_depth(&larger, sheet, "the same drop on a sheet of %d cells a side", WHOLE);
    sheet_finish(sheet);
    static const enum painting_field FIELDS[] = {PAINTING_CATALYST, PAINTING_ACTIVE, PAINTING_CARVED, PAINTING_SOLVENT,
                                                 PAINTING_INK,      PAINTING_WET,    PAINTING_DRY};
    for (size_t i = 0; i < sizeof FIELDS / sizeof FIELDS[0]; i++) {
        int count = differing(&with, &larger, FIELDS[i]), bare = differing(&without, &larger, FIELDS[i]);
        figure_check(figure, count == 0 && bare > 0,
                     "%s is that of a larger sheet to the bit: %d cells differ; without a margin %d",
                     painting_field_name(FIELDS[i]), count, bare);
    }
    double cut = cut_share(&with), square = cut_share(&without);
    figure_check(figure, cut > 0.5 && square < 0.25,
                 "carved cells of the last two columns: %.0f %% with a margin, %.0f %% without", 100 * cut,
                 100 * square);
    subject_finish(&with);
    subject_finish(&without);
    subject_finish(&larger);
}
