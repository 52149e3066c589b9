/* `turn` of a binding: a coefficient of the painting, or an option of another kind of scene. */
#include <math.h>

#include "coefficients.h"
#include "inputs_read.h"
#include "scene_options.h"

static void check_range(struct reader *reader, const struct yaml_node *node, const char *name, const struct key *key)
{
    const struct yaml_node *value = yaml_get(node, name);
    double number = 0;
    size_t length = reader_enter(reader, name);
    if (value) {
        value_number(reader, key, value, &number);
    }
    reader_leave(reader, length);
}

void inputs_check_ends(struct reader *reader, const struct yaml_node *node, const struct key *of)
{
    struct key key = *of;
    key.type = KEY_NUMBER; /* a whole coefficient may have ends between */
    check_range(reader, node, "from", &key);
    check_range(reader, node, "to", &key);
}

static void complain(struct reader *reader, const char *name, const struct yaml_node *at, const char *text)
{
    size_t length = reader_enter(reader, name);
    reader_problem(reader, at, "%s", text);
    reader_leave(reader, length);
}

/* One thing is set: its key of `turn`, and what is given for it; NULL, and in the report, where it is none or several.
 */
static const struct key *find_turned(struct reader *reader, const struct yaml_node *node,
                                     const struct yaml_node **value)
{
    const struct key *first = NULL;
    char text[160];
    for (const struct key *key = turn_keys; key->name; key++) {
        const struct yaml_node *given = action_options(key) ? yaml_get(node, key->name) : NULL;
        if (given && first) {
            snprintf(text, sizeof text, "%s %s is given too; one of the two",
                     first->type == KEY_COEFFICIENT ? "a" : "an option:", first->name);
            complain(reader, key->name, given, text);
            return NULL;
        }
        if (given) {
            first = key;
            *value = given;
        }
    }
    if (!first) {
        complain(reader, "coefficient", node,
                 "missing; the name of a coefficient, or of an option: growth, lightning or chemistry");
    }
    return first;
}

/* What a `turn` sets; NULL, and in the report, where it is not one thing that can be turned. */
static const struct key *turned(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    const struct yaml_node *value = NULL;
    const struct key *turns = find_turned(reader, node, &value);
    char text[160];
    if (!turns) {
        binding->coefficient = 0;
        binding->option = -1;
        return NULL;
    }
    binding->scene = turns->type == KEY_OPTION ? (int)turns->min : SCENE_PAINTING;
    const struct key *key = binding->scene == SCENE_PAINTING
                                ? &coefficient_keys[binding->coefficient]
                                : &scene_options_keys((enum scene_kind)binding->scene)[binding->option];
    binding->coefficient = binding->scene == SCENE_PAINTING ? binding->coefficient : -1;
    binding->option = binding->scene == SCENE_PAINTING ? -1 : binding->option;
    if (binding->scene != SCENE_PAINTING && !scene_option_is_value(key)) {
        snprintf(text, sizeof text, "%s is no single value; another option of %s", key->name,
                 scene_kind_names[binding->scene]);
        complain(reader, turns->name, value, text);
    } else if (binding->scene == SCENE_PAINTING && key->type == KEY_CHOICE) {
        snprintf(text, sizeof text, "%s is no number; set chooses it", key->name);
        complain(reader, turns->name, value, text);
    } else {
        return key;
    }
    return NULL;
}

static void check_missing(struct reader *reader, const struct yaml_node *node, const char *name, const struct key *of)
{
    struct key key = *of;
    char allowed[128], text[160];
    key.type = KEY_NUMBER;
    if (!yaml_get(node, name)) {
        snprintf(text, sizeof text, "missing; %s", value_allowed(&key, allowed, sizeof allowed));
        complain(reader, name, node, text);
    }
}

/* A detent for each, and nothing between two of them. */
static void turn_choices(const struct yaml_node *node, const struct key *key, struct axis_def *axis)
{
    int last = 1;
    for (; key->type == KEY_CHOICE && key->choices[last + 1]; last++) {
    }
    axis->from = yaml_get(node, "from") ? fminf(fmaxf(roundf(axis->from), 0), (float)last) : 0;
    axis->to = yaml_get(node, "to") ? fminf(fmaxf(roundf(axis->to), 0), (float)last) : (float)last;
    axis->steps = yaml_get(node, "steps") ? axis->steps : fmaxf(fabsf(axis->to - axis->from), 1);
    axis->smooth_ms = 0;
}

void inputs_read_turn(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    int before = reader->report->count + reader->report->dropped;
    binding->what = DO_TURN;
    key_defaults(turn_keys, binding);
    mapping_read(reader, turn_keys, node, binding, NULL);
    const struct key *key = turned(reader, node, binding);
    if (reader->report->count + reader->report->dropped > before || !key) {
        return;
    }
    if (key->type == KEY_CHOICE || key->type == KEY_FLAG) {
        turn_choices(node, key, &binding->axis);
    } else {
        check_missing(reader, node, "from", key);
        check_missing(reader, node, "to", key);
        inputs_check_ends(reader, node, key);
    }
}
