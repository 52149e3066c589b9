#include "action.h"

#include <string.h>

#include "brush.h"
#include "coefficients.h"
#include "kernel.h"
#include "scene.h"
#include "verb.h"

#define VERB(NAME, name) [ACTION_##NAME] = &verb_##name,
const struct verb *const verbs[ACTION_VERBS] = {ACTION_VERB_LIST(VERB)};
#undef VERB

const struct key *action_keys(enum action_verb verb)
{
    return verbs[verb]->keys;
}

const struct key *action_options(const struct key *key)
{
    return key->type == KEY_COEFFICIENT ? coefficient_keys
           : key->type == KEY_OPTION    ? scene_types[(int)key->min]->options
                                        : NULL;
}

const char *action_name(enum action_verb verb)
{
    return verbs[verb]->name;
}

const char *action_meaning(enum action_verb verb)
{
    return verbs[verb]->meaning;
}

bool action_goes_back(enum action_verb verb)
{
    return verbs[verb]->back;
}

enum action_verb action_find(const char *name)
{
    int verb = 0;
    while (verb < ACTION_VERBS && strcmp(verbs[verb]->name, name) != 0) {
        verb++;
    }
    return (enum action_verb)verb;
}

struct action action_default(enum action_verb verb)
{
    struct action action = {.verb = verb, .brush = BRUSH_NONE};
    key_defaults(verbs[verb]->keys, &action);
    return action;
}

static float legal_flow(float flow)
{
    return flow >= -1.0f && flow <= 1.0f ? flow : flow > 1.0f ? 1.0f : flow < -1.0f ? -1.0f : 0.0f;
}

static float legal_position(float position)
{
    return position >= 0.0f && position <= 1.0f ? position : position > 1.0f ? 1.0f : 0.0f;
}

static int legal_option(const struct action *action)
{
    for (const struct key *key = action_keys(action->verb); key->name; key++) {
        if (key->type == KEY_OPTION) {
            return action->option >= 0 && action->option < key_count(action_options(key)) ? action->option : 0;
        }
    }
    return 0;
}

struct action action_legal(const struct action *action)
{
    struct action legal = *action;
    for (const struct key *key = action_keys(action->verb); key->name; key++) {
        char *at = (char *)&legal + key->offset;
        if (key->type == KEY_NUMBER) {
            float value;
            memcpy(&value, at, sizeof value);
            value = key_bound(key, value);
            memcpy(at, &value, sizeof value);
        }
    }
    legal.at.x = legal_position(legal.at.x);
    legal.at.y = legal_position(legal.at.y);
    legal.flow.x = legal_flow(legal.flow.x);
    legal.flow.y = legal_flow(legal.flow.y);
    legal.option = legal_option(action);
    legal.ink = legal.ink < 0 || legal.ink >= INKS ? 0 : legal.ink;
    for (int i = 0; legal.brush != BRUSH_NONE && i <= legal.brush; i++) {
        if (legal.brush < 0 || !brushes[i].name) {
            legal.brush = BRUSH_NONE;
        }
    }
    return legal;
}
