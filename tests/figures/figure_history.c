/* Undo of one of two growths that touch, redo, and the time brush: what goes, what stays, what grows on. */
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "figure.h"
#include "history.h"
#include "subject.h"

enum { SIDE = 288, MEET = 720, LATER = 200 };

struct scene {
    struct engine *engine;
    struct history *history;
    struct subject subject; /* looks at the engine's painting */
    float *depth;           /* as it was when kept */
};

static struct scene scene_create(void)
{
    struct painting_def def = subject_def(SIDE);
    struct history_def history = history_default_def();
    struct scene scene = {.engine = engine_cpu_create(&def),
                          .history = history_create(&history, &def),
                          .subject = subject_create(&def),
                          .depth = malloc((size_t)SIDE * SIDE * sizeof(float))};
    if (!scene.engine || !scene.history || !scene.depth) {
        figure_stop("history", "memory is short");
    }
    painting_destroy(scene.subject.painting);
    scene.subject.painting = engine_cpu_painting(scene.engine);
    return scene;
}

static void scene_finish(struct scene *scene)
{
    scene->subject.painting = NULL; /* the engine's */
    subject_finish(&scene->subject);
    history_destroy(scene->history);
    engine_destroy(scene->engine);
    free(scene->depth);
}

static void run(struct scene *scene, int ticks)
{
    for (int tick = 0; tick < ticks; tick++) {
        history_tick(scene->history, scene->engine);
        scene->engine->ops->tick(scene->engine);
    }
}

static void act(struct scene *scene, enum action_verb verb, int visitor)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    history_act(scene->history, scene->engine, &action);
}

static void drop(struct scene *scene, int visitor, float x, const char *brush, int ink)
{
    struct action action = action_default(ACTION_DROP);
    action.visitor = visitor;
    action.at = (struct point){x, 0.5f};
    action.brush = brush_find(brush);
    action.ink = ink;
    action.solvent = 160;
    action.amount = 70;
    history_act(scene->history, scene->engine, &action);
}

static void keep(struct scene *scene)
{
    memcpy(scene->depth, subject_depth(&scene->subject), (size_t)SIDE * SIDE * sizeof(float));
}

struct change {
    int64_t lost, won, differ; /* cells that are carved no more, newly carved; of another depth, to the bit */
};

/* Since it was kept, in columns [x0, x1). */
static struct change change_in(struct scene *scene, int x0, int x1)
{
    const float *now = subject_depth(&scene->subject);
    struct change change = {0, 0, 0};
    for (int y = 0; y < SIDE; y++) {
        for (int x = x0; x < x1; x++) {
            size_t at = (size_t)y * SIDE + (size_t)x;
            change.lost += scene->depth[at] > 0.1f && now[at] <= 0.1f;
            change.won += scene->depth[at] <= 0.1f && now[at] > 0.1f;
            change.differ += memcmp(&scene->depth[at], &now[at], sizeof *now) != 0;
        }
    }
    return change;
}

static int64_t area_of(struct scene *scene, int x0, int x1)
{
    const float *depth = subject_depth(&scene->subject);
    int64_t area = 0;
    for (int y = 0; y < SIDE; y++) {
        for (int x = x0; x < x1; x++) {
            area += depth[(size_t)y * SIDE + (size_t)x] > 0.1f;
        }
    }
    return area;
}

static void check_undo(struct figure *figure, struct scene *scene, struct sheet *sheet)
{
    enum { LEFT = 5 * SIDE / 12, RIGHT = 7 * SIDE / 12 }; /* between them the two meet */
    keep(scene);
    int64_t area = area_of(scene, RIGHT, SIDE), other = area_of(scene, 0, LEFT);
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "two visitors, %d ticks", MEET);
    double solvent = painting_totals(scene->subject.painting).solvent, fell = 160.0 * 197;
    act(scene, ACTION_UNDO, 2);
    struct change near = change_in(scene, 0, LEFT), far = change_in(scene, RIGHT, SIDE);
    double went = solvent - painting_totals(scene->subject.painting).solvent;
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "the second undoes: that moment");
    figure_check(figure, near.differ == 0, "undo leaves the other growth as it is, to the bit: %lld cells differ",
                 (long long)near.differ);
    figure_check(figure, far.lost == area, "it takes %lld of the visitor's %lld cells", (long long)far.lost,
                 (long long)area);
    figure_check(figure, went < 1.001 * fell && went > 0.85 * fell,
                 "%.0f of solvent go with it, of %.0f that fell with its drop; some has crossed to the other", went,
                 fell);
    keep(scene);
    run(scene, LATER);
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "%d ticks later: the other grows into it", LATER);
    near = change_in(scene, 0, LEFT);
    struct change middle = change_in(scene, LEFT, SIDE);
    figure_check(figure, near.won > other / 20 && middle.won > 100,
                 "growth goes on: %lld cells where it was, %lld where the other had been", (long long)near.won,
                 (long long)middle.won);
    keep(scene);
    act(scene, ACTION_REDO, 2);
    struct change again = change_in(scene, RIGHT, SIDE);
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "redo");
    figure_check(figure, again.won > 95 * area / 100, "redo brings %lld of them back", (long long)again.won);
    figure_check(figure, change_in(scene, 0, LEFT).differ == 0, "and leaves the other growth as it is");
}

static void rewind_middle(struct scene *scene)
{
    static const struct point STROKE[] = {{0.5f, 0.06f}, {0.5f, 0.94f}};
    struct action action = action_default(ACTION_REWIND);
    action.path = (struct action_path){STROKE, 2};
    action.visitor = 1;
    action.radius = SIDE / 9;
    history_act(scene->history, scene->engine, &action);
}

static void check_rewind(struct figure *figure, struct scene *scene, struct sheet *sheet)
{
    enum { LEFT = SIDE / 2 - SIDE / 9 - 1, RIGHT = SIDE / 2 + SIDE / 9 + 1 };
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "%d ticks; the time brush goes down the middle", MEET);
    int64_t before = area_of(scene, LEFT, RIGHT), least = before;
    for (int pass = 0; pass < 4; pass++) {
        keep(scene);
        rewind_middle(scene);
        int64_t area = area_of(scene, LEFT, RIGHT);
        figure_check(figure, area < least, "pass %d takes the middle further back: %lld cells of %lld", pass + 1,
                     (long long)area, (long long)before);
        int64_t beside = change_in(scene, 0, LEFT).differ + change_in(scene, RIGHT, SIDE).differ;
        figure_check(figure, beside == 0, "and nothing beside it: %lld cells differ", (long long)beside);
        least = area;
        if (pass == 0 || pass == 3) {
            subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "pass %d: %lld cells of %lld there", pass + 1,
                             (long long)area, (long long)before);
        }
        run(scene, 15);
    }
    run(scene, LATER);
    int64_t area = area_of(scene, LEFT, RIGHT);
    subject_show_ink(&scene->subject, sheet, SUBJECT_LIT, "%d ticks later, %lld cells", LATER, (long long)area);
    figure_check(figure, area > least + (before - least) / 3, "growth goes on from there: %lld cells", (long long)area);
}

static struct scene two_growths(void)
{
    struct scene scene = scene_create();
    drop(&scene, 1, 0.36f, "fern", 1);
    run(&scene, 40);
    drop(&scene, 2, 0.64f, "coral", 3);
    run(&scene, MEET - 40);
    return scene;
}

void figure_history(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "Undo, redo, and the time brush", 4, 2, SIDE);
    struct scene undone = two_growths();
    check_undo(figure, &undone, sheet);
    scene_finish(&undone);
    struct scene rewound = two_growths();
    check_rewind(figure, &rewound, sheet);
    scene_finish(&rewound);
    sheet_finish(sheet);
}
