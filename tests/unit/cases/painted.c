#include "painted.h"

#include <setjmp.h>
#include <stdarg.h>

#include <cmocka.h>
#include <stdlib.h>

enum { DEPTH, SOLVENT, INK, MASK = INK + PAINTING_INKS, SPARE, PLANES };

struct painted painted_create(const struct painting_def *def, int width, int height)
{
    struct painted painted = {.width = width, .height = height};
    struct painting_def alone = *def;
    alone.threads = 1; /* CTest runs several tests at once */
    painted.painting = painting_create(&alone);
    assert_non_null(painted.painting);
    struct picture_def look = picture_default_def();
    look.width = width;
    look.height = height;
    look.cells_x = def->width;
    look.cells_y = def->height;
    look.follow = 20;
    painted.picture = picture_create(&look);
    painted.cells = (size_t)def->width * (size_t)def->height;
    painted.planes = calloc(PLANES * painted.cells, sizeof *painted.planes);
    painted.rgb = calloc((size_t)width * (size_t)height, 3);
    assert_non_null(painted.picture);
    assert_non_null(painted.planes);
    assert_non_null(painted.rgb);
    return painted;
}

void painted_destroy(struct painted *painted)
{
    painting_destroy(painted->painting);
    picture_destroy(painted->picture);
    free(painted->planes);
    free(painted->rgb);
}

static float *plane(const struct painted *painted, int number)
{
    return painted->planes + (size_t)number * painted->cells;
}

/* Two fields, added. */
static void read_sum(struct painted *painted, enum painting_field one, enum painting_field other, float *out)
{
    float *spare = plane(painted, SPARE);
    painting_read(painted->painting, one, out);
    painting_read(painted->painting, other, spare);
    for (size_t i = 0; i < painted->cells; i++) {
        out[i] += spare[i];
    }
}

void painted_draw(struct painted *painted)
{
    struct picture_planes planes = {
        .depth = plane(painted, DEPTH), .solvent = plane(painted, SOLVENT), .mask = plane(painted, MASK)};
    read_sum(painted, PAINTING_ACTIVE, PAINTING_CARVED, plane(painted, DEPTH));
    painting_read(painted->painting, PAINTING_SOLVENT, plane(painted, SOLVENT));
    painting_read(painted->painting, PAINTING_MASK, plane(painted, MASK));
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        read_sum(painted, (enum painting_field)(PAINTING_WET + ink), (enum painting_field)(PAINTING_DRY + ink),
                 plane(painted, INK + ink));
        planes.ink[ink] = plane(painted, INK + ink);
    }
    picture_draw(painted->picture, &planes, painted->rgb);
}

static void drop(struct painted *painted, float x, float y, int ink)
{
    struct action drop = action_default(ACTION_DROP);
    drop.at = (struct point){x, y};
    drop.ink = ink;
    drop.brush = ink;
    drop.edge = ink % 3;
    drop.amount = 60;
    drop.solvent = 120;
    drop.radius = 6;
    painting_act(painted->painting, &drop);
}

void painted_paint(struct painted *painted, int ticks)
{
    static const struct point LINE[] = {{0.1f, 0.15f}, {0.5f, 0.3f}, {0.9f, 0.2f}};
    struct action act = action_default(ACTION_MASK);
    act.at = (struct point){0.55f, 0.55f};
    act.has_at = true;
    act.radius = 8;
    painting_act(painted->painting, &act);
    act = action_default(ACTION_GUIDE);
    act.path = (struct action_path){LINE, 3};
    painting_act(painted->painting, &act);
    for (int ink = 0; ink < PAINTING_INKS; ink++) {
        drop(painted, 0.2f + 0.2f * (float)ink, ink % 2 ? 0.3f : 0.7f, ink);
    }
    drop(painted, 0.99f, 0.97f, 1);
    for (int tick = 0; tick < ticks; tick++) {
        painting_tick(painted->painting);
    }
    act = action_default(ACTION_DRAW);
    act.path = (struct action_path){LINE, 3};
    act.ink = 3;
    painting_act(painted->painting, &act);
    act = action_default(ACTION_BRUSH_INK);
    act.path = (struct action_path){LINE, 3};
    act.ink = 2;
    painting_act(painted->painting, &act);
}
