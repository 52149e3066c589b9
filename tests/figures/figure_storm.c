/* A storm over time: a strike, a coral between two hands, two rivers that keep clear of each other. */
#include <math.h>
#include <string.h>

#include "bolt_light.h"
#include "figure.h"
#include "sheet.h"
#include "storm.h"

enum { SHOWN = 480 };

static struct storm *storm_of(enum bolt_kind kind)
{
    struct storm *storm = storm_create(SHOWN, SHOWN);
    if (!storm) {
        figure_stop("storm", "no memory");
    }
    struct action action = action_default(ACTION_CONDUCT); /* the first key is the kind */
    action.value = (float)kind;
    storm_act(storm, 0, &action);
    return storm;
}

static void conduct(struct storm *storm, int64_t tick, const char *key, float value)
{
    struct action action = action_default(ACTION_CONDUCT);
    while (strcmp(storm_keys[action.option].name, key) != 0) {
        action.option++;
    }
    action.value = value;
    storm_act(storm, tick, &action);
}

static void lay_hand(struct storm *storm, int64_t tick, enum action_verb verb, int visitor, float x, float y,
                     float amount)
{
    struct action action = action_default(verb);
    action.visitor = visitor;
    action.has_at = true;
    action.at = (struct point){x, y};
    action.amount = amount;
    storm_act(storm, tick, &action);
}

static void ticks(struct storm *storm, int64_t *tick, int64_t to)
{
    for (; *tick < to; ++*tick) {
        if (!storm_tick(storm, *tick)) {
            figure_stop("storm", "no memory");
        }
    }
}

static void show(struct sheet *sheet, struct storm *storm, int64_t tick, const char *label)
{
    static uint8_t rgb[SHOWN * SHOWN * 3];
    if (!storm_type.lay(storm, tick, SHOWN, SHOWN, rgb)) {
        figure_stop("storm", "no memory");
    }
    int since;
    sheet_add(sheet, rgb, "%s\ntick %d, %d segments", label, (int)tick, storm_view(storm, tick, &since).count);
}

/* The sum of heat that is there: how bright it is. */
static double heat_of(struct storm *storm, int64_t tick)
{
    int since;
    struct bolt_view view = storm_view(storm, tick, &since);
    double sum = 0;
    for (int i = 0; i < view.count; i++) {
        float left = view.segments[i].death - (float)(tick - view.tick);
        sum += left > 0 ? (double)(view.segments[i].heat * fminf(left / 45, 1)) : 0;
    }
    return sum;
}

static int64_t until_struck(struct storm *storm, int64_t tick)
{
    int since;
    float flash = 0;
    for (; !(flash > 0) && tick < 400; tick++) {
        ticks(storm, &tick, tick + 1);
        tick--;
        flash = storm_view(storm, tick, &since).flash;
    }
    return tick;
}

static void draw_strike(struct figure *figure, struct sheet *sheet)
{
    struct storm *storm = storm_of(BOLT_LIGHTNING);
    conduct(storm, 0, "seed", 5);
    lay_hand(storm, 0, ACTION_STRIKE, 1, 0.62f, 0.88f, 0);
    int64_t tick = 0;
    ticks(storm, &tick, 14);
    show(sheet, storm, tick - 1, "the leader");
    ticks(storm, &tick, 30);
    show(sheet, storm, tick - 1, "nearer");
    tick = until_struck(storm, tick);
    show(sheet, storm, tick - 1, "it has come");
    ticks(storm, &tick, tick + 8);
    show(sheet, storm, tick - 1, "it glows");
    double before = heat_of(storm, tick - 1), most = 0;
    int64_t from = tick;
    for (int i = 0; i < 60 && most < 1.2; i++) {
        ticks(storm, &tick, tick + 1);
        double now = heat_of(storm, tick - 1);
        most = now / before;
        before = now;
    }
    figure_check(figure, most >= 1.2, "the channel lights up again after %d ticks, %.1f times as bright",
                 (int)(tick - from), most);
    ticks(storm, &tick, tick + 4);
    show(sheet, storm, tick - 1, "once more");
    ticks(storm, &tick, tick + 18);
    show(sheet, storm, tick - 1, "fading");
    ticks(storm, &tick, tick + 200);
    figure_check(figure, storm_is_calm(storm, tick), "then it is forgotten");
    storm_destroy(storm);
}

static void draw_coral(struct figure *figure, struct sheet *sheet)
{
    double side[3];
    for (int which = 0; which < 3; which++) {
        static const char *const LABELS[3] = {"a coral, left alone", "a hand attracts on the right",
                                              "a hand repels on the right"};
        struct storm *storm = storm_of(BOLT_CORAL);
        int64_t tick = 0;
        conduct(storm, 0, "turn", 0);
        if (which > 0) {
            lay_hand(storm, 0, ACTION_ATTRACT, 2, 0.95f, 0.45f, which == 1 ? 900 : -900);
        }
        lay_hand(storm, 0, ACTION_STRIKE, 1, 0.5f, 0.9f, 0);
        ticks(storm, &tick, 420);
        show(sheet, storm, tick - 1, LABELS[which]);
        int since;
        struct bolt_view view = storm_view(storm, tick, &since);
        side[which] = 0;
        for (int i = 0; i < view.count; i++) {
            side[which] += (double)view.segments[i].to[0] / SHOWN / view.count;
        }
        storm_destroy(storm);
    }
    figure_check(figure, side[1] > side[2] + 0.03, "in the middle %.2f, attracted %.2f, repelled %.2f", side[0],
                 side[1], side[2]);
}

static void draw_rivers(struct figure *figure, struct sheet *sheet)
{
    for (int which = 0; which < 3; which++) {
        struct storm *storm = storm_of(BOLT_RIVER);
        int64_t tick = 0;
        conduct(storm, 0, "repel", which == 0 ? 0 : 3);
        conduct(storm, 0, "pace", 15);
        lay_hand(storm, 0, ACTION_STRIKE, 1, 0.4f, 0.04f, 0);
        lay_hand(storm, 0, ACTION_STRIKE, 2, 0.66f, 0.04f, 0);
        if (which == 2) {
            lay_hand(storm, 0, ACTION_ATTRACT, 3, 0.5f, 0.75f, -300);
        }
        ticks(storm, &tick, 500);
        show(sheet, storm, tick - 1,
             which == 0   ? "two rivers that do not know of each other"
             : which == 1 ? "two rivers keep clear of each other"
                          : "and of a hand between them");
        storm_destroy(storm);
    }
    (void)figure;
}

void figure_storm(struct figure *figure)
{
    struct sheet *sheet = sheet_create(figure, "A storm: a strike, a coral with hands, rivers", 6, 2, SHOWN);
    draw_strike(figure, sheet);
    draw_coral(figure, sheet);
    draw_rivers(figure, sheet);
    sheet_finish(sheet);
}
