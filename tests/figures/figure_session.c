/* Figures 1 and 13: a painting session, frame by frame: coefficients that vary over the sheet, neighbours, patterns on
 * patterns, strokes, droplets. */
#include "figure.h"
#include "subject.h"

enum { SIDE = 512 };

struct touch {
    int tick;
    float x, y;
    int ink;
    float radius, solvent, amount;
};

static void act(struct subject *subject, const struct touch *touch)
{
    struct action drop = subject_drop(touch->x, touch->y);
    drop.ink = touch->ink;
    drop.radius = touch->radius;
    drop.solvent = touch->solvent;
    drop.amount = touch->amount;
    drop.edge = touch->radius > 4 ? EDGE_RAGGED : EDGE_HARD;
    painting_act(subject->painting, &drop);
}

static void vary(struct subject *subject, const char *coefficient, float value, float share, float size)
{
    struct action set = action_default(ACTION_SET);
    while (&coefficient_keys[set.coefficient] != key_find(coefficient_keys, coefficient)) {
        set.coefficient++;
    }
    set.value = value;
    set.vary = share;
    set.size = size;
    painting_act(subject->painting, &set);
}

void figure_session(struct figure *figure)
{
    static const struct touch TOUCHES[] = {
        {0, 0.60f, 0.43f, 0, 10, 190, 100}, {150, 0.20f, 0.26f, 2, 8, 60, 40},
        {250, 0.27f, 0.72f, 1, 9, 80, 50},  {500, 0.82f, 0.85f, 2, 7, 50, 30},
        {700, 0.60f, 0.43f, 1, 8, 60, 80},  {900, 0.20f, 0.26f, 1, 6, 20, 30},
        {1000, 0.27f, 0.72f, 2, 6, 20, 30}, {1050, 0.88f, 0.16f, 1, 2, 16, 26},
        {1100, 0.50f, 0.90f, 0, 2, 16, 26}, {1120, 0.08f, 0.50f, 0, 1.5f, 16, 26},
        {1150, 0.94f, 0.62f, 0, 2, 16, 26}, {1200, 0.40f, 0.07f, 2, 1.5f, 16, 26},
    };
    enum { TOUCHES_COUNT = sizeof TOUCHES / sizeof TOUCHES[0], FRAMES = 4, TICKS = 1600 };
    struct painting_def def = subject_def(SIDE);
    def.margin = 64;
    struct subject subject = subject_create(&def);
    vary(&subject, "alpha_a", 0.25f, 0.35f, 90);
    vary(&subject, "s_max", 0.29f, 0.13f, 70);
    struct sheet *sheet = sheet_create(figure, "Figures 1 and 13: a session", 2, 2, 2 * SIDE);
    int next = 0;
    int64_t areas[FRAMES];
    for (int tick = 0; tick < TICKS; tick++) {
        for (; next < TOUCHES_COUNT && TOUCHES[next].tick <= tick; next++) {
            act(&subject, &TOUCHES[next]);
        }
        painting_tick(subject.painting);
        if ((tick + 1) % (TICKS / FRAMES) == 0) {
            subject_show_ink(&subject, sheet, SUBJECT_LIT, "tick %d", tick + 1);
            areas[(tick + 1) / (TICKS / FRAMES) - 1] = subject_area(&subject);
        }
    }
    sheet_finish(sheet);
    struct shape_figures shape = subject_measure(&subject);
    const float *alpha_a = subject_read(&subject, PAINTING_ALPHA_A);
    float least = alpha_a[0], most = alpha_a[0];
    for (size_t i = 0; i < subject.cells; i++) {
        least = alpha_a[i] < least ? alpha_a[i] : least;
        most = alpha_a[i] > most ? alpha_a[i] : most;
    }
    subject_finish(&subject);
    figure_check(figure, (double)least < 0.2 && (double)most > 0.3, "alpha_a varies over the sheet: %.2f to %.2f",
                 (double)least, (double)most);
    figure_check(figure, areas[0] < areas[1] && areas[1] < areas[2] && areas[2] < areas[3],
                 "the painting grows: %lld, %lld, %lld, %lld cells", (long long)areas[0], (long long)areas[1],
                 (long long)areas[2], (long long)areas[3]);
    figure_check(figure, shape.components == 9, "nine paintings side by side: %d components", shape.components);
}
