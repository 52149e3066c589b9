#include "journal_value.h"

#include <string.h>

#include "action.h"
#include "brush.h"
#include "journal.h"

const uint8_t journal_magic[JOURNAL_MAGIC] = {0x89, 'F', 'R', 'O', 'N', 'D', '\r', '\n'};

enum journal_type journal_type_of(enum key_type type)
{
    switch (type) {
    case KEY_NUMBER:
        return JOURNAL_FLOAT;
    case KEY_INTEGER:
        return JOURNAL_WHOLE;
    case KEY_FLAG:
        return JOURNAL_FLAG;
    case KEY_POINT:
        return JOURNAL_POINT;
    case KEY_CHOICE:
    case KEY_BRUSH:
    case KEY_OPTION:
    case KEY_COEFFICIENT:
        return JOURNAL_NAME;
    case KEY_INK:
        return JOURNAL_INK;
    case KEY_PATH:
        return JOURNAL_PATH;
    case KEY_RASTER:
    case KEY_PICTURE:
        return JOURNAL_RASTER_NUMBER;
    default:
        return JOURNAL_NONE;
    }
}

const char *journal_name_of(const struct key *key, int value)
{
    if (value < 0) {
        return "";
    }
    const struct key *options = action_options(key);
    return options ? options[value].name : key->type == KEY_BRUSH ? brushes[value].name : key->choices[value];
}

bool journal_value_of(const struct key *key, const char *name, int *value)
{
    int found = 0;
    if (key->type == KEY_BRUSH) {
        *value = brush_find(name);
        return *value != BRUSH_NONE || !name[0];
    }
    const struct key *options = action_options(key);
    if (options) {
        const struct key *named = key_find(options, name);
        *value = named ? (int)(named - options) : 0;
        return named;
    }
    while (key->choices[found] && strcmp(key->choices[found], name) != 0) {
        found++;
    }
    *value = key->choices[found] ? found : (int)key->initial;
    return key->choices[found];
}

const char *journal_kind_name(enum journal_kind kind)
{
    static const char *const names[JOURNAL_KINDS] = {
        [JOURNAL_HEAD] = "head",     [JOURNAL_SHEET] = "sheet",   [JOURNAL_SCENE] = "scene",
        [JOURNAL_GRID] = "grid",     [JOURNAL_RASTER] = "raster", [JOURNAL_VERB] = "verb",
        [JOURNAL_ACTION] = "action", [JOURNAL_MARK] = "mark",     [JOURNAL_RESTORED] = "restored",
        [JOURNAL_END] = "end"};
    return kind > 0 && kind < JOURNAL_KINDS ? names[kind] : "unknown";
}

struct journal_sheet journal_sheet_of(const struct script *script, const struct painting_def *def)
{
    struct journal_sheet sheet = {
        .def = *def, .mode = script->mode, .ink_count = script->ink_count, .history = history_default_def()};
    for (int i = 0; i < script->ink_count; i++) {
        sheet.inks[i] = script->inks[i];
    }
    return sheet;
}
