/* A storm: strikes come to the hand, glow, flicker and are forgotten; what is slow stays, keeps clear of others and of
 * masks, goes with water, and is taken back by who made it; the same actions make the same storm. */
#include <math.h>
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include <cmocka.h>

#include "storm_case.h"

enum { WIDTH = STORM_CASE_WIDTH, HEIGHT = STORM_CASE_HEIGHT };

/* The channel from a cloud to the hand; what flickers is it again. */
static void a_strike_comes_to_the_hand(void **state)
{
    (void)state;
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    storm_case_strike(storm, 0, 1, 0.62f, 0.8f);
    int64_t tick = 0, struck = -1;
    struct bolt_view view;
    int since, before = 0, hot = 0, again = 0;
    for (; tick < 400; tick++) {
        assert_true(storm_tick(storm, tick));
        view = storm_view(storm, tick, &since);
        hot = 0;
        for (int i = 0; i < view.count; i++) {
            hot += view.segments[i].heat >= 1;
        }
        if (struck < 0 && hot > 0) {
            struck = tick;
            const struct bolt_segment *end = &view.segments[view.count - 1];
            float highest = HEIGHT;
            for (int i = 0; i < view.count; i++) {
                highest = view.segments[i].heat >= 1 ? fminf(highest, view.segments[i].from[1]) : highest;
            }
            assert_true(hypotf(end->to[0] - 0.62f * WIDTH, end->to[1] - 0.8f * HEIGHT) < 3 && end->heat >= 1);
            assert_true(highest < 0.02f * HEIGHT);
            assert_true(view.flash > 0.05f && view.flash <= 1);
            assert_true(hot > 50 && hot < view.count / 2);
            before = hot;
        }
        again += struck >= 0 && tick > struck && hot > before;
        before = hot;
        if (struck >= 0 && view.count == 0) {
            break;
        }
    }
    print_message("struck at %d, flickered %d times, gone at %d\n", (int)struck, again, (int)tick);
    assert_in_range(struck, 15, 130);
    assert_in_range(again, 2, 3);
    assert_true(tick < struck + 250 && storm_is_calm(storm, tick));
    storm_destroy(storm);
}

static void a_strike_follows_its_hand(void **state)
{
    (void)state;
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    storm_case_set(storm, 0, "life", 0);
    storm_case_strike(storm, 0, 1, 0.3f, 0.8f);
    storm_case_ticks(storm, 0, 8);
    storm_case_attract(storm, 8, 2, 0.1f, 0.9f, 10); /* another's hand leads it nowhere */
    storm_case_attract(storm, 8, 1, 0.75f, 0.7f, 10);
    int64_t tick = storm_case_until_calm(storm, 8, 300);
    int since;
    struct bolt_view view = storm_view(storm, tick, &since);
    float near = INFINITY;
    for (int i = 0; i < view.count; i++) {
        const struct bolt_segment *segment = &view.segments[i];
        near = fminf(near, hypotf(segment->to[0] - 0.75f * WIDTH, segment->to[1] - 0.7f * HEIGHT));
    }
    assert_true(near < 3);
    assert_true(storm_is_calm(storm, tick)); /* of no life: it stays */
    storm_destroy(storm);
}

/* Mean place over the sheet, 0..1, of what is seen. */
static float mean_x(struct storm *storm)
{
    int since;
    struct bolt_view view = storm_view(storm, 0, &since);
    double sum = 0;
    for (int i = 0; i < view.count; i++) {
        sum += (double)view.segments[i].to[0];
    }
    return (float)(sum / (view.count > 0 ? view.count : 1) / WIDTH);
}

static void hands_attract_and_repel(void **state)
{
    (void)state;
    float mean[4];
    for (int which = 0; which < 4; which++) { /* none, attract, repel, lifted */
        struct storm *storm = storm_case_of(BOLT_CITY);
        storm_case_set(storm, 0, "eta", 4);
        storm_case_set(storm, 0, "particles", 1200);
        storm_case_set(storm, 0, "pace", 30);
        if (which > 0) {
            storm_case_attract(storm, 0, 2, 0.95f, 0.5f, which == 2 ? -800 : 800);
        }
        if (which == 3) {
            struct action lifted = action_default(ACTION_ATTRACT);
            lifted.visitor = 2;
            storm_act(storm, 0, &lifted);
        }
        storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
        storm_case_until_calm(storm, 0, 100);
        mean[which] = mean_x(storm);
        storm_destroy(storm);
    }
    print_message("mean x: %.3f, attracted %.3f, repelled %.3f\n", (double)mean[0], (double)mean[1], (double)mean[2]);
    assert_true(mean[1] > mean[0] + 0.02f && mean[2] < mean[0] - 0.02f);
    assert_true(fabsf(mean[3] - mean[0]) < 1e-6f);
}

static void painted_charges_stay_until_taken_back(void **state)
{
    (void)state;
    const struct point path[3] = {{0.9f, 0.1f}, {0.9f, 0.5f}, {0.9f, 0.9f}};
    float mean[3];
    for (int which = 0; which < 3; which++) {
        struct storm *storm = storm_case_of(BOLT_CITY);
        storm_case_set(storm, 0, "eta", 4);
        storm_case_set(storm, 0, "particles", 1200);
        storm_case_set(storm, 0, "pace", 30);
        struct action stroke = action_default(ACTION_ATTRACT), undo = action_default(ACTION_UNDO);
        stroke.visitor = undo.visitor = 3;
        stroke.path = (struct action_path){path, 3};
        stroke.amount = 30;
        if (which > 0) {
            storm_act(storm, 0, &stroke);
            assert_int_equal(storm_type.can_undo(storm), 1 << 3);
        }
        if (which == 2) {
            storm_act(storm, 0, &undo);
            assert_int_equal(storm_type.can_undo(storm), 0);
            assert_int_equal(storm_type.can_redo(storm), 1 << 3);
        }
        storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
        storm_case_until_calm(storm, 0, 100);
        mean[which] = mean_x(storm);
        storm_destroy(storm);
    }
    assert_true(mean[1] > mean[0] + 0.02f);
    assert_true(fabsf(mean[2] - mean[0]) < 1e-6f);
}

/* Two begin side by side: what of them has crossed the middle, with and without. */
static void bolts_keep_clear_of_each_other(void **state)
{
    (void)state;
    int crossed[2] = {0};
    for (int which = 0; which < 2; which++) {
        struct storm *storm = storm_case_of(BOLT_CITY);
        storm_case_set(storm, 0, "eta", 4);
        storm_case_set(storm, 0, "particles", 2000);
        storm_case_set(storm, 0, "pace", 25);
        storm_case_set(storm, 0, "repel", which == 0 ? 0 : 4);
        storm_case_strike(storm, 0, 1, 0.44f, 0.5f);
        storm_case_strike(storm, 0, 2, 0.56f, 0.5f);
        storm_case_until_calm(storm, 0, 120);
        const struct storm_owner *owners = storm->owners;
        for (int i = 0; i < storm->count; i++) {
            float x = storm->segments[i].to[0] / WIDTH;
            crossed[which] += owners[i].slot == 0 ? x > 0.5f : x < 0.5f;
        }
        storm_destroy(storm);
    }
    print_message("across the middle: %d, keeping clear %d\n", crossed[0], crossed[1]);
    assert_true(crossed[1] * 3 < crossed[0]);
}

static void a_kind_brings_its_values(void **state)
{
    (void)state;
    for (const struct key *key = storm_keys; key->name; key++) {
        assert_true(key->unit && key->meaning && strlen(key->meaning) > 10);
    }
    struct storm *storm = storm_case_of(BOLT_LIGHTNING);
    storm_case_set(storm, 0, "seed", 77);
    storm_case_set(storm, 0, "eta", 2);
    for (int kind = 0; kind < BOLT_KINDS; kind++) {
        storm_case_set(storm, 0, "kind", (float)kind);
        struct storm_def def = storm_get_def(storm), preset = storm_preset((enum bolt_kind)kind);
        preset.seed = 77;
        assert_memory_equal(&def, &preset, sizeof def);
        for (int key = 0; storm_keys[key].name; key++) { /* within their ranges */
            struct storm_def again = def;
            key_take(&storm_keys[key], &again, key_value(&storm_keys[key], &def));
            assert_memory_equal(&def, &again, sizeof def);
        }
    }
    storm_case_set(storm, 0, "eta", NAN);
    storm_case_set(storm, 0, "particles", INFINITY);
    assert_true(storm_get_def(storm).eta == 0 && storm_get_def(storm).particles == STORM_PARTICLES);
    storm_destroy(storm);
}

/* A dial turned while it grows. */
static void eta_is_heard_while_it_grows(void **state)
{
    (void)state;
    float far[2] = {0};
    for (int which = 0; which < 2; which++) {
        struct storm *storm = storm_case_of(BOLT_CITY);
        storm_case_set(storm, 0, "particles", 2500);
        storm_case_set(storm, 0, "pace", 25);
        storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
        storm_case_ticks(storm, 0, 20);
        storm_case_set(storm, 20, "eta", which == 0 ? 0 : 8);
        storm_case_until_calm(storm, 20, 120);
        for (int i = 0; i < storm->count; i++) {
            const struct bolt_segment *segment = &storm->segments[i];
            far[which] += hypotf(segment->to[0] - WIDTH / 2.0f, segment->to[1] - HEIGHT / 2.0f) / (float)storm->count;
        }
        storm_destroy(storm);
    }
    print_message("far off, eta 0 from the middle on: %.1f, eta 8: %.1f\n", (double)far[0], (double)far[1]);
    assert_true(far[1] > 1.2f * far[0]);
}

static void masks_keep_growth_out(void **state)
{
    (void)state;
    for (int inverted = 0; inverted < 2; inverted++) {
        struct storm *storm = storm_case_of(BOLT_LICHTENBERG);
        storm_case_set(storm, 0, "particles", 6000);
        struct action mask = action_default(ACTION_MASK);
        mask.has_at = true;
        mask.at = inverted ? (struct point){0.5f, 0.5f} : (struct point){0.7f, 0.5f};
        mask.radius = 24;
        mask.invert = inverted;
        storm_act(storm, 0, &mask);
        storm_case_strike(storm, 0, 1, 0.5f, 0.5f);
        storm_case_until_calm(storm, 0, 120);
        int inside = 0;
        for (int i = 0; i < storm->count; i++) {
            const struct bolt_segment *segment = &storm->segments[i];
            inside +=
                hypotf(segment->to[0] - mask.at.x * WIDTH, segment->to[1] - mask.at.y * HEIGHT) < (inverted ? 27 : 23);
        }
        assert_true(storm->count > 1000);
        assert_int_equal(inside, inverted ? storm->count : 0);
        int clouds = storm->count;
        storm_case_strike(storm, 120, 1, 0.01f, 0.01f); /* where a mask is, nothing begins */
        storm_case_ticks(storm, 120, 121);
        assert_true(!inverted || storm->count == clouds);
        struct action unmask = action_default(ACTION_UNMASK);
        storm_act(storm, 121, &unmask);
        storm_case_strike(storm, 121, 1, 0.7f, 0.5f);
        storm_case_ticks(storm, 121, 126);
        assert_true(storm->count > clouds + 100);
        storm_destroy(storm);
    }
}

static void it_grows_from_the_outline_of_a_picture(void **state)
{
    (void)state;
    static float values[64 * 40];
    for (int i = 0; i < 64 * 40; i++) { /* linear light: a dark disc */
        values[i] = hypotf((float)(i % 64) - 31.5f, (float)(i / 64 - 20) + 0.5f) < 10 ? 0.0f : 1.0f;
    }
    struct storm *storm = storm_case_of(BOLT_FROST);
    storm_case_set(storm, 0, "particles", 900);
    struct action strike = action_default(ACTION_STRIKE);
    strike.picture = (struct action_raster){values, 64, 40, 1};
    storm_act(storm, 0, &strike);
    memset(values, 0, sizeof values);
    storm_case_until_calm(storm, 0, 200);
    float least = INFINITY;
    int quarters[4] = {0};
    for (int i = 0; i < storm->count; i++) {
        float x = storm->segments[i].from[0] - WIDTH / 2.0f, y = storm->segments[i].from[1] - HEIGHT / 2.0f;
        least = fminf(least, hypotf(x, y));
        quarters[(x > 0) + 2 * (y > 0)]++;
    }
    float radius = 10.0f / 64 * WIDTH;
    assert_true(storm->count > 200 && least > 0.5f * radius);
    for (int i = 0; i < 4; i++) {
        assert_true(quarters[i] > storm->count / 20);
    }
    for (int i = 0; i < 64 * 40; i++) {
        values[i] = 1;
    }
    int count = storm->count;
    storm_act(storm, 300, &strike); /* nothing is dark */
    storm_case_ticks(storm, 300, 305);
    assert_int_equal(storm->count, count);
    storm_destroy(storm);
}

static void parents_carry_their_children(void **state)
{
    (void)state;
    struct storm *storm = storm_case_of(BOLT_TREE);
    storm_case_set(storm, 0, "particles", 1500);
    storm_case_strike(storm, 0, 1, 0.5f, 0.9f);
    storm_case_until_calm(storm, 0, 90);
    const struct storm_bolt *bolt = &storm->bolts[0];
    int leaves = 0, forks = 0;
    double pipe = (double)bolt->look.pipe;
    for (int i = 0; i < bolt->count; i++) {
        const struct storm_node *node = &bolt->nodes[i];
        leaves += node->segment >= 0 && storm->segments[node->segment].leaf > 0;
        if (node->parent >= 0) {
            assert_true(bolt->nodes[node->parent].radius >= node->radius);
            assert_true(node->radius >= bolt->look.tip && node->radius <= bolt->look.trunk * 1.0001f);
            forks += bolt->nodes[node->parent].tips > node->tips;
        }
    }
    /* what is above the tips' radius, to the power of `pipe`, goes as the tips carried */
    const struct storm_node *root = &bolt->nodes[0];
    assert_true(fabsf(root->radius - bolt->look.trunk) < 0.01f * bolt->look.trunk && leaves > 20 && forks > 20);
    double whole = pow((double)root->tips, 1 / pipe) - 1;
    for (int i = 0; i < bolt->count; i++) {
        double share = (pow((double)bolt->nodes[i].tips, 1 / pipe) - 1) / whole;
        double wanted = (double)bolt->look.tip + (double)(bolt->look.trunk - bolt->look.tip) * share;
        assert_true(fabs((double)bolt->nodes[i].radius / wanted - 1) < 1e-3);
    }
    assert_false(storm_is_calm(storm, 1000)); /* it turns */
    int since;
    assert_true(storm_view(storm, 900, &since).turn != storm_view(storm, 910, &since).turn);
    storm_case_set(storm, 1000, "turn", 0);
    assert_true(storm_is_calm(storm, 1000));
    storm_destroy(storm);
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(a_strike_comes_to_the_hand),
        cmocka_unit_test(a_strike_follows_its_hand),
        cmocka_unit_test(hands_attract_and_repel),
        cmocka_unit_test(painted_charges_stay_until_taken_back),
        cmocka_unit_test(bolts_keep_clear_of_each_other),
        cmocka_unit_test(a_kind_brings_its_values),
        cmocka_unit_test(eta_is_heard_while_it_grows),
        cmocka_unit_test(masks_keep_growth_out),
        cmocka_unit_test(it_grows_from_the_outline_of_a_picture),
        cmocka_unit_test(parents_carry_their_children),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
