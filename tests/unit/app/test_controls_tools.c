/* Controls (app/hands/controls.h): what fingers do with each tool, where a file says nothing of it. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <string.h>

#include "controls_case.h"
#include "near.h"

static struct place open_default(void)
{
    return open_place(strchr(inputs_default_text(), '\n') + 1);
}

/* What the default does, tool by tool: what a press makes, what a drag makes. */
static const struct {
    enum exhibit_tool tool;
    int press, drag; /* actions */
    enum action_verb pressed[2], dragged[2];
} TOOLS_DO[] = {
    {TOOL_DROP, 1, 2, {ACTION_DROP}, {ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK}},
    {TOOL_BRUSH, 2, 2, {ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK}, {ACTION_BRUSH_SOLVENT, ACTION_BRUSH_INK}},
    {TOOL_GUIDE, 0, 1, {0}, {ACTION_GUIDE}},
    {TOOL_POUR, 1, 1, {ACTION_POUR}, {ACTION_POUR}},
    {TOOL_MASK, 1, 1, {ACTION_MASK}, {ACTION_MASK}},
    {TOOL_REWIND, 1, 1, {ACTION_REWIND}, {ACTION_REWIND}},
    {TOOL_PLANT, 1, 1, {ACTION_PLANT}, {ACTION_HOLD}},
    {TOOL_TEND, 1, 1, {ACTION_TEND}, {ACTION_TEND}},
    {TOOL_THIN, 1, 1, {ACTION_TEND}, {ACTION_TEND}},
    {TOOL_STRIKE, 1, 1, {ACTION_STRIKE}, {ACTION_ATTRACT}},
    {TOOL_REPEL, 1, 1, {ACTION_ATTRACT}, {ACTION_ATTRACT}},
    {TOOL_STROKE, 0, 1, {0}, {ACTION_ATTRACT}},
    {TOOL_DOSE, 1, 1, {ACTION_DOSE}, {ACTION_DOSE}},
    {TOOL_ERASE, 1, 1, {ACTION_DOSE}, {ACTION_DOSE}},
    {TOOL_MAP, 1, 1, {ACTION_DOSE}, {ACTION_DOSE}},
};

/* Whether what a tool does is a hand, which is lifted when the finger goes. */
static bool is_hand(enum exhibit_tool tool, enum action_verb verb)
{
    return verb == ACTION_HOLD || (verb == ACTION_ATTRACT && tool != TOOL_STROKE);
}

static void assert_tools(struct place *place)
{
    assert_int_equal(sizeof TOOLS_DO / sizeof *TOOLS_DO, TOOLS);
    for (size_t i = 0; i < TOOLS; i++) {
        struct scene_options options = scene_options_default(exhibit_tool_kinds[TOOLS_DO[i].tool]);
        controls_options(place->controls, &options);
        controls_set_tool(place->controls, 0, TOOLS_DO[i].tool);
        assert_int_equal(controls_tool(place->controls, 0), TOOLS_DO[i].tool);
        finger(place, EVENT_DOWN, 0, 0.5f, 0.5f);
        for (int k = 0; k < TOOLS_DO[i].press; k++) {
            bool hand = is_hand(TOOLS_DO[i].tool, TOOLS_DO[i].pressed[k]);
            assert_true(take(place) && place->action.visitor == (hand ? CONTROLS_HANDS : 1));
            assert_int_equal(place->action.verb, TOOLS_DO[i].pressed[k]);
            assert_true(place->action.invert == (TOOLS_DO[i].tool == TOOL_ERASE));
        }
        assert_false(take(place));
        controls_set_tool(place->controls, 0, TOOL_DROP); /* a finger goes on with what it has begun */
        finger(place, EVENT_MOVE, 0, 0.6f, 0.5f);
        finger(place, EVENT_MOVE, 0, 0.7f, 0.5f);
        wait_ms(place, 80);
        for (int k = 0; k < TOOLS_DO[i].drag; k++) {
            bool hand = is_hand(TOOLS_DO[i].tool, TOOLS_DO[i].dragged[k]);
            assert_true(take(place) && place->action.visitor == (hand ? CONTROLS_HANDS : 1));
            assert_int_equal(place->action.verb, TOOLS_DO[i].dragged[k]);
            bool along = place->action.verb != ACTION_POUR && !hand;
            struct point end = along ? place->action.path.points[place->action.path.count - 1] : place->action.at;
            assert_near(end.x, 0.7, 1e-6);
            assert_int_equal(place->action.path.count, along ? 3 : 0);
        }
        assert_false(take(place));
        finger(place, EVENT_UP, 0, 0.7f, 0.5f);
        enum action_verb last = TOOLS_DO[i].dragged[0];
        if (is_hand(TOOLS_DO[i].tool, last)) { /* it is lifted */
            assert_true(take(place) && place->action.verb == last && !place->action.has_at);
            assert_int_equal(place->action.path.count, 0);
        }
        assert_false(take(place));
    }
}

static void each_tool_does_what_it_is_for(void **state)
{
    (void)state;
    struct place place = open_default();
    assert_tools(&place);
    close_place(&place);
    /* Where a file says nothing of tools, or of fingers, they do the same. */
    place = open_place("bindings: [{touch: press, drop: {}}, {touch: drag, brush_solvent: {}}, {touch: drag, "
                       "brush_ink: {}}, {usage: Button 1, clear: {}}]\n");
    assert_tools(&place);
    close_place(&place);
    place = open_place("bindings: [{usage: Button 1, clear: {}}]\n");
    assert_tools(&place);
    close_place(&place);
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(each_tool_does_what_it_is_for)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
