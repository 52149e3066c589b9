#include "script_action.h"

#include <stdlib.h>
#include <string.h>

#include "formula.h"
#include "garden.h"
#include "raster.h"
#include "script_session.h"
#include "script_structure.h"
#include "script_text.h"
#include "verb.h"

/* Where the values of a raster come from. */
enum { FORMULA, PICTURE, STRUCTURE, TEXT, SESSION, RASTERS };

/* What one verb's parameters need to know of each other. */
struct parameters {
    const struct key *setting; /* what `set`, `shape`, ... sets; NULL for other verbs, or where it is wrong */
    const struct yaml_node *raster[RASTERS]; /* read last: what they become depends on the other parameters */
    bool bound;                              /* place and ink may come later */
};

bool script_take_values(struct reader *reader, const struct yaml_node *node, size_t count)
{
    if (count > reader->def->raster_values_max - reader->raster_values) {
        reader_problem(reader, node, "too much for one file; %zu values in all formulas and pictures together",
                       reader->def->raster_values_max);
        return false;
    }
    reader->raster_values += count;
    return true;
}

static void report_formula(struct reader *reader, const struct yaml_node *node, const struct formula_problem *problem)
{
    if (problem->at > 0) {
        reader_problem(reader, node, "character %d: %s", problem->at, problem->text);
    } else {
        reader_problem(reader, node, "%s", problem->text);
    }
}

static bool sample_expression(struct reader *reader, const struct yaml_node *node, float *plane)
{
    char found[128];
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where an expression should be; one in x and y",
                       yaml_found(node, found, sizeof found));
        return false;
    }
    struct formula_problem problem;
    struct formula *formula = formula_create(node->text, &problem);
    bool good = formula && formula_sample(formula, reader->script->width, reader->script->height, plane, &problem);
    if (!good) {
        report_formula(reader, node, &problem);
    }
    formula_destroy(formula);
    return good;
}

static bool read_formula(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    char found[128];
    int channels = action->verb == ACTION_GUIDE ? 2 : 1;
    size_t cells = (size_t)reader->script->width * (size_t)reader->script->height;
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (channels == 2 && (node->kind != YAML_LIST || node->count != 2)) {
        char count[48];
        snprintf(count, sizeof count, "a list of %d", node->count);
        reader_problem(reader, node, "%s where two expressions should be; [x part, y part]",
                       node->kind == YAML_LIST ? count : yaml_found(node, found, sizeof found));
        return false;
    }
    if (!script_take_values(reader, node, cells * (size_t)channels)) {
        return false;
    }
    float *values = reader_take(reader, cells * (size_t)channels * sizeof *values);
    if (!values) {
        return false;
    }
    bool good = true;
    if (channels == 1) {
        good = sample_expression(reader, node, values);
    } else {
        const struct yaml_node *item = node->first;
        for (int i = 0; i < 2; i++, item = item->next) {
            size_t length = reader_enter_index(reader, i);
            good = sample_expression(reader, item, values + (size_t)i * cells) && good;
            reader_leave(reader, length);
        }
    }
    action->formula = (struct action_raster){values, reader->script->width, reader->script->height, channels};
    return good;
}

static enum raster_kind kind_of(const struct action *action)
{
    if (action->verb != ACTION_GUIDE) {
        return RASTER_BRIGHTNESS; /* a mask is where it is below one half: the engine's rule (action.h) */
    }
    return action->reading == READ_VECTORS       ? RASTER_VECTORS
           : action->reading == READ_ALONG_EDGES ? RASTER_ALONG_EDGES
                                                 : RASTER_TOWARDS_DARK;
}

static void size_stock(const struct script_picture *picture, int *width, int *height)
{
    int longer = picture->width > picture->height ? picture->width : picture->height;
    int side = longer < GARDEN_STOCK_SIDE ? longer : GARDEN_STOCK_SIDE;
    *width = (int)((int64_t)picture->width * side / longer);
    *height = (int)((int64_t)picture->height * side / longer);
    *width = *width > 0 ? *width : 1;
    *height = *height > 0 ? *height : 1;
}

bool script_action_picture(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    char found[128];
    struct file_error error;
    if (node->kind == YAML_REFUSED) {
        return false;
    }
    if (node->kind != YAML_SCALAR || yaml_is_nothing(node)) {
        reader_problem(reader, node, "%s where a path should be; a picture in this file's folder",
                       yaml_found(node, found, sizeof found));
        return false;
    }
    if (!reader->def->load) {
        reader_problem(reader, node, "pictures cannot be read here; a formula can");
        return false;
    }
    enum raster_kind kind = kind_of(action);
    int width = reader->script->width, height = reader->script->height;
    int channels = raster_channels(kind);
    struct script_picture picture = {0};
    size_t values_of_sheet = (size_t)width * (size_t)height * (size_t)channels;
    if (action->verb != ACTION_STOCK && !script_take_values(reader, node, values_of_sheet)) {
        return false;
    }
    reader_names(reader, node->text);
    if (!reader->def->load(reader->def->data, reader->folder, node->text, &picture, &error)) {
        reader_problem(reader, node, "%s", error.text);
        return false;
    }
    if (action->verb == ACTION_STOCK) { /* its own shape, not the sheet's */
        size_stock(&picture, &width, &height);
        if (!script_take_values(reader, node, (size_t)width * (size_t)height)) {
            free(picture.values);
            return false;
        }
    }
    size_t count = (size_t)width * (size_t)height * (size_t)channels;
    float *values = reader_take(reader, count * sizeof *values);
    bool good = values && raster_from_picture(&picture, kind, width, height, values);
    free(picture.values);
    if (values && !good) {
        reader_problem(reader, node, "memory is short");
    }
    action->picture = (struct action_raster){values, width, height, channels};
    return good;
}

static bool is_number(const struct yaml_node *node)
{
    return node->kind == YAML_SCALAR &&
           (strchr("+-.", node->text[0]) || (node->text[0] >= '0' && node->text[0] <= '9'));
}

/* `value` and `to` of `set`, `value` of `shape` and its like: type and range of what they set. */
static bool read_setting(struct reader *reader, const struct key *key, const struct yaml_node *node,
                         const struct key *setting, struct action *action)
{
    float *value = (float *)(void *)((char *)action + key->offset);
    double number = 0;
    bool good, flag = false;
    if (setting->type == KEY_POINT || setting->type == KEY_PATH) {
        reader_problem(reader, node, "'%s' is no value to set; plant says where it grows from", setting->name);
        return false;
    }
    if (setting->type == KEY_CHOICE && !(action->verb != ACTION_SET && is_number(node))) {
        struct names names = names_of_choices(setting->choices);
        int choice = 0;
        good = value_choice(reader, &names, "choice", node, &choice);
        number = choice;
    } else if (setting->type == KEY_FLAG && !is_number(node)) {
        struct key own = {.name = "value", .type = KEY_FLAG};
        good = value_read(reader, &own, node, &flag);
        number = flag;
    } else {
        struct key own = *setting;
        if (own.type == KEY_CHOICE || own.type == KEY_FLAG) {
            own.max = own.type == KEY_FLAG ? 1 : names_of_choices(own.choices).count - 1;
            own.type = KEY_INTEGER;
        }
        good = value_number(reader, &own, node, &number);
    }
    *value = (float)number;
    return good;
}

static bool read_structure(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    return script_structure_read(reader, node, action, NULL, NULL);
}

static const struct {
    const char *name;
    bool (*read)(struct reader *reader, const struct yaml_node *node, struct action *action);
} SOURCES[RASTERS] = {[FORMULA] = {"formula", read_formula},
                      [PICTURE] = {"picture", script_action_picture},
                      [STRUCTURE] = {"structure", read_structure},
                      [TEXT] = {"text", script_text_read},
                      [SESSION] = {"session", script_session_read}};

static bool read_parameter(struct reader *reader, const struct key *key, const struct yaml_node *node, void *object,
                           void *context)
{
    struct action *action = object;
    struct parameters *parameters = context;
    if (key->type == KEY_RASTER || key->type == KEY_PICTURE) {
        for (int i = 0; i < RASTERS; i++) {
            if (strcmp(key->name, SOURCES[i].name) == 0) {
                parameters->raster[i] = node;
            }
        }
        return true;
    }
    if (parameters->setting && (strcmp(key->name, "value") == 0 || strcmp(key->name, "to") == 0)) {
        return read_setting(reader, key, node, parameters->setting, action);
    }
    bool good = value_read(reader, key, node, object);
    if (key->type == KEY_POINT && strcmp(key->name, "at") == 0) {
        action->has_at = good;
    }
    return good;
}

static void missing(struct reader *reader, const struct yaml_node *node, const char *name, const struct key *allowed)
{
    char text[1200];
    size_t length = reader_enter(reader, name);
    reader_problem(reader, node, "missing; %s", value_allowed(allowed, text, sizeof text));
    reader_leave(reader, length);
}

/* At most one of them; whether there is any. */
static bool check_rasters(struct reader *reader, const struct yaml_node *node, const struct parameters *parameters)
{
    const char *found[RASTERS];
    int count = 0;
    for (int i = 0; i < RASTERS; i++) {
        if (parameters->raster[i]) {
            found[count++] = SOURCES[i].name;
        }
    }
    if (count > 1) {
        reader_problem(reader, node, "both a %s and a %s; one of them", found[0], found[1]);
    }
    return count > 0;
}

/* "at, a path, a formula or a picture": those that the verb has. */
static void missing_place(struct reader *reader, const struct yaml_node *node, enum action_verb verb)
{
    static const char *const PLACES[][2] = {
        {"at", "at"}, {"path", "a path"}, {"formula", "a formula"}, {"picture", "a picture"}};
    const char *have[4] = {NULL};
    char text[80] = "";
    int count = 0;
    for (int i = 0; i < 4; i++) {
        have[count] = PLACES[i][1];
        count += key_find(action_keys(verb), PLACES[i][0]) != NULL;
    }
    if (count == 1) {
        reader_problem(reader, node, "no picture is given; the path of one in this file's folder");
        return;
    }
    for (int i = 0; i < count; i++) {
        size_t length = strlen(text);
        snprintf(text + length, sizeof text - length, "%s%s", i == 0 ? "" : i + 1 < count ? ", " : " or ", have[i]);
    }
    reader_problem(reader, node, "no place is given; %s", text);
}

/* What no single row of a table can ask for. */
static void check_together(struct reader *reader, const struct yaml_node *node, enum action_verb verb,
                           const struct parameters *parameters)
{
    bool at = yaml_get(node, "at"), path = yaml_get(node, "path");
    bool raster = check_rasters(reader, node, parameters);
    if (verbs[verb]->needs_place && !at && !path && !raster && !parameters->bound) {
        missing_place(reader, node, verb);
    }
    if (verbs[verb]->one_place && at && path) {
        reader_problem(reader, node, "both at and a path; one of them");
    }
    if (parameters->setting) {
        if (!yaml_get(node, "value")) {
            missing(reader, node, "value", parameters->setting);
        }
        if (raster && !yaml_get(node, "to")) {
            missing(reader, node, "to", parameters->setting);
        }
    }
}

enum { PARAMETERS_MAX = 16 };

/* The parameters of a verb as scripts write them: where a picture may stand, so may a structure, words or a session. */
static int parameter_keys(enum action_verb verb, struct key keys[PARAMETERS_MAX + 1])
{
    int count = key_count(action_keys(verb));
    memcpy(keys, action_keys(verb), (size_t)count * sizeof *keys);
    const struct key *picture = key_find(action_keys(verb), "picture");
    const bool taken[RASTERS] = {
        [STRUCTURE] = verb != ACTION_STOCK, [TEXT] = script_text_is_for(verb), [SESSION] = true};
    for (int i = STRUCTURE; picture && i < RASTERS; i++) {
        if (taken[i]) {
            keys[count] = *picture;
            keys[count++].name = SOURCES[i].name;
        }
    }
    return count;
}

static void read_parameters(struct reader *reader, const struct yaml_node *node, struct action *action, bool bound)
{
    struct key keys[PARAMETERS_MAX + 1] = {{0}};
    int count = parameter_keys(action->verb, keys);
    for (int i = 0; bound && i < count; i++) {
        keys[i].required = keys[i].required && keys[i].type != KEY_POINT && keys[i].type != KEY_PATH;
    }
    char found[128];
    struct yaml_node none = {.kind = YAML_MAPPING, .line = node->line, .column = node->column};
    if (node->kind == YAML_REFUSED) {
        return;
    }
    if (yaml_is_nothing(node)) {
        node = &none; /* `dry:` is `dry: {}` */
    }
    if (node->kind != YAML_MAPPING) {
        struct names names = names_of_keys(keys);
        char allowed[512];
        reader_problem(reader, node, "%s where a mapping should be; %s", yaml_found(node, found, sizeof found),
                       names.count ? names_allowed(&names, "", allowed, sizeof allowed) : "{}");
        return;
    }
    struct parameters parameters = {.bound = bound};
    for (const struct key *key = keys; key->name; key++) {
        const struct key *options = action_options(key);
        const struct yaml_node *setting = options ? yaml_get(node, key->name) : NULL;
        if (setting && setting->kind == YAML_SCALAR) {
            parameters.setting = key_find(options, setting->text);
        }
    }
    struct value_reading reading = {read_parameter, &parameters};
    mapping_read(reader, keys, node, action, &reading);
    check_together(reader, node, action->verb, &parameters);
    for (int i = 0; i < RASTERS; i++) {
        if (parameters.raster[i]) {
            size_t length = reader_enter(reader, SOURCES[i].name);
            SOURCES[i].read(reader, parameters.raster[i], action);
            reader_leave(reader, length);
        }
    }
}

/* What stands beside the verb. */
struct beside {
    int tick, visitor;
};

static void read_beside(struct reader *reader, const struct key *key, const struct yaml_node *node,
                        struct beside *beside)
{
    size_t length = reader_enter(reader, key->name);
    value_read(reader, key, node, beside);
    reader_leave(reader, length);
}

static void report_verb(struct reader *reader, const struct yaml_node *at)
{
    char allowed[512];
    struct names names = names_of_verbs();
    size_t length = reader_enter(reader, at->text);
    names_allowed(&names, at->text, allowed, sizeof allowed);
    reader_problem(reader, at, "unknown verb; %s", allowed);
    reader_leave(reader, length);
}

static void report_second(struct reader *reader, const struct yaml_node *at, const char *first)
{
    size_t length = reader_enter(reader, at->text);
    if (strcmp(at->text, first) == 0) {
        reader_problem(reader, at, "given twice; once is enough");
    } else {
        reader_problem(reader, at, "a second verb, after %s; an action has one", first);
    }
    reader_leave(reader, length);
}

bool script_action_bound(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    int before = reader->report->count + reader->report->dropped;
    action->ink = -1;
    read_parameters(reader, node, action, true);
    return reader->report->count + reader->report->dropped == before;
}

/* The keys of an action: its verb, and what stands beside it; NULL where there is none. */
struct pairs {
    const struct yaml_node *tick, *visitor, *verb;
};

static void note_beside(struct reader *reader, const struct yaml_node *k, const struct yaml_node **first)
{
    if (*first) {
        report_second(reader, k, k->text);
    }
    *first = k;
}

static struct pairs find_pairs(struct reader *reader, const struct yaml_node *node)
{
    struct pairs pairs = {NULL, NULL, NULL};
    char allowed[512];
    bool any = false;
    for (const struct yaml_node *k = node->first; k && k->next; k = k->next->next) {
        bool word = k->kind == YAML_SCALAR;
        if (word && strcmp(k->text, "tick") == 0) {
            note_beside(reader, k, &pairs.tick);
            continue;
        }
        if (word && strcmp(k->text, "visitor") == 0) {
            note_beside(reader, k, &pairs.visitor);
            continue;
        }
        any = true;
        if (word && action_find(k->text) == ACTION_VERBS) {
            report_verb(reader, k);
        } else if (word && pairs.verb) {
            report_second(reader, k, pairs.verb->text);
        } else if (word) {
            pairs.verb = k;
        }
    }
    if (!any) {
        struct names names = names_of_verbs();
        reader_problem(reader, node, "no verb; %s", names_allowed(&names, "", allowed, sizeof allowed));
    }
    return pairs;
}

static bool read_action(struct reader *reader, const struct yaml_node *node, bool timed, struct action *action)
{
    char found[128];
    int before = reader->report->count + reader->report->dropped;
    if (node->kind != YAML_MAPPING) {
        if (node->kind != YAML_REFUSED) {
            reader_problem(reader, node, "%s where an action should be; {%sverb: {...}}",
                           yaml_found(node, found, sizeof found), timed ? "tick: N, " : "");
        }
        return false;
    }
    struct pairs pairs = find_pairs(reader, node);
    const struct yaml_node *tick = pairs.tick, *visitor = pairs.visitor, *verb = pairs.verb;
    struct beside beside = {0};
    if (verb) {
        *action = action_default(action_find(verb->text));
        size_t length = reader_enter(reader, verb->text);
        read_parameters(reader, verb->next, action, false);
        reader_leave(reader, length);
    }
    if (tick && !timed) {
        size_t length = reader_enter(reader, "tick");
        reader_problem(reader, tick, "it is done at once on a fresh sheet; an action without a tick");
        reader_leave(reader, length);
    } else if (tick) {
        read_beside(reader, &action_tick_keys[0], tick->next, &beside);
    } else if (timed) {
        missing(reader, node, "tick", &action_tick_keys[0]);
    }
    if (visitor) {
        read_beside(reader, &action_tick_keys[1], visitor->next, &beside);
    }
    action->tick = beside.tick;
    action->visitor = beside.visitor;
    return reader->report->count + reader->report->dropped == before && verb;
}

bool script_action_read(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    return read_action(reader, node, true, action);
}

bool script_action_at_once(struct reader *reader, const struct yaml_node *node, struct action *action)
{
    return read_action(reader, node, false, action);
}
