/* `turn` of a binding: a coefficient of the painting, or an option of what grows in scenes of trees. */
#include <math.h>

#include "coefficients.h"
#include "growth.h"
#include "inputs_read.h"

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

/* What a `turn` sets; NULL, and in the report, where it is not one thing that can be turned. */
static const struct key *turned(struct reader *reader, const struct yaml_node *node, struct binding *binding)
{
    const struct yaml_node *coefficient = yaml_get(node, "coefficient"), *growth = yaml_get(node, "growth");
    const struct key *key = growth ? &growth_keys[binding->growth] : &coefficient_keys[binding->coefficient];
    char text[160];
    binding->coefficient = growth ? -1 : binding->coefficient;
    binding->growth = growth ? binding->growth : -1;
    if (growth && coefficient) {
        complain(reader, "growth", growth, "a coefficient is given too; one of the two");
    } else if (!growth && !coefficient) {
        complain(reader, "coefficient", node, "missing; the name of a coefficient, or growth: an option of frond grow");
    } else if (growth && (key->type == KEY_PATH || key->type == KEY_POINT)) {
        snprintf(text, sizeof text, "%s is no single value; another option of frond grow", key->name);
        complain(reader, "growth", growth, text);
    } else if (!growth && key->type == KEY_CHOICE) {
        snprintf(text, sizeof text, "%s is no number; set chooses it", key->name);
        complain(reader, "coefficient", coefficient, text);
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
