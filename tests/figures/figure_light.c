/* What grows as light, as lines and as bodies. */
#include <stdlib.h>
#include <string.h>

#include "figure.h"
#include "light_case.h"
#include "sheet.h"

enum { SIDE = 480, BYTES = 3 * SIDE * SIDE };

/* Share of the pixels that are brighter than so much of 255. */
static double brighter(const uint8_t *rgb, int than)
{
    int count = 0;
    for (int i = 0; i < BYTES; i += 3) {
        count += rgb[i] + rgb[i + 1] + rgb[i + 2] > 3 * than;
    }
    return (double)count / (SIDE * SIDE);
}

/* Share of the pixels that are not those of the corner. */
static double covered(const uint8_t *rgb)
{
    int count = 0;
    for (int i = 0; i < BYTES; i += 3) {
        count += abs(rgb[i] - rgb[0]) + abs(rgb[i + 1] - rgb[1]) + abs(rgb[i + 2] - rgb[2]) > 24;
    }
    return (double)count / (SIDE * SIDE);
}

static void lay(const struct bolt_view *view, double tick, uint8_t *rgb)
{
    if (!bolt_light_lay(view, tick, SIDE, SIDE, rgb)) {
        figure_stop("light", "no memory");
    }
}

static void check(struct figure *figure, const struct bolt_view *view, const char *name, const uint8_t *rgb)
{
    double share = covered(rgb);
    if (view->look.style == BOLT_GLOW) {
        double white = brighter(rgb, 235);
        figure_check(figure, white > 0.0005 && white < 0.15 && share > 3 * white,
                     "%s: white in %.2f %%, light in %.0f %%", name, 100 * white, 100 * share);
    } else {
        figure_check(figure, share > 0.02 && share < 0.7, "%s: covers %.0f %%", name, 100 * share);
    }
}

/* A strike fades, and a coral turns. */
static void later(struct figure *figure, struct sheet *sheet, enum light_case which, struct bolt_view *view,
                  struct bolt_segment *segments, uint8_t *rgb)
{
    if (which == LIGHT_STRIKE) {
        double before = brighter(rgb, 128);
        for (int i = 0; i < view->count; i++) {
            segments[i].birth = 0;
            segments[i].death = 90;
        }
        view->look.life = 90;
        lay(view, 45, rgb);
        sheet_add(sheet, rgb, "half of its life later");
        figure_check(figure, brighter(rgb, 128) < 0.8 * before, "the strike fades: %.2f of what was bright",
                     brighter(rgb, 128) / before);
    } else if (which == LIGHT_CORAL) {
        static uint8_t before[BYTES];
        memcpy(before, rgb, BYTES);
        view->turn = 0.2f;
        lay(view, 1e7, rgb);
        sheet_add(sheet, rgb, "a fifth of a turn on");
        figure_check(figure, memcmp(before, rgb, BYTES) != 0, "the coral turns");
    }
}

void figure_light(struct figure *figure)
{
    static uint8_t rgb[BYTES];
    struct sheet *sheet = sheet_create(figure, "Light, lines and bodies", 4, 3, SIDE);
    for (enum light_case which = 0; which < LIGHT_CASES; which++) {
        struct bolt_view view;
        struct bolt_segment *segments;
        const char *wrong = light_case_grow(which, SIDE, SIDE, &view, &segments);
        if (wrong) {
            figure_stop(light_case_names[which], wrong);
        }
        lay(&view, 1e7, rgb);
        sheet_add(sheet, rgb, "%s, %d segments", light_case_names[which], view.count);
        check(figure, &view, light_case_names[which], rgb);
        later(figure, sheet, which, &view, segments, rgb);
        free(segments);
    }
    sheet_finish(sheet);
}
