#include "explain.h"

#include <string.h>

#include "action.h"
#include "bolt_order.h"
#include "brush.h"
#include "exhibit.h"
#include "grow.h"
#include "ink.h"
#include "inputs.h"
#include "script.h"
#include "script_session.h"
#include "script_structure.h"
#include "script_text.h"
#include "script_value.h"
#include "vision.h"

struct explaining {
    const char *asked; /* NULL: everything */
    FILE *out;
    bool found;
    const char *heading; /* of the part that is being gone through, until something of it is printed */
    const char *about;
};

static const char *type_name(const struct key *key)
{
    static const char *const NAMES[] = {
        [KEY_NUMBER] = "number",
        [KEY_INTEGER] = "whole number",
        [KEY_FLAG] = "flag",
        [KEY_CHOICE] = "choice",
        [KEY_POINT] = "point",
        [KEY_PATH] = "path",
        [KEY_INK] = "ink",
        [KEY_BRUSH] = "brush",
        [KEY_RASTER] = "expression",
        [KEY_PICTURE] = "path",
        [KEY_OPTION] = "option",
        [KEY_TEXT] = "text",
        [KEY_COEFFICIENT] = "coefficient",
        [KEY_ZONE] = "zone",
        [KEY_SIZE] = "size",
        [KEY_TIME] = "time",
    };
    return key_is_section(key) ? "section" : NAMES[key->type];
}

static const char *initial(const struct key *key, char *buffer, size_t size)
{
    switch (key->type) {
    case KEY_NUMBER:
    case KEY_INTEGER:
        snprintf(buffer, size, "; default %.10g", key->initial);
        break;
    case KEY_FLAG:
        snprintf(buffer, size, "; default %s", key->initial != 0 ? "true" : "false");
        break;
    case KEY_CHOICE:
        snprintf(buffer, size, "; default %s", key->choices[(int)key->initial]);
        break;
    case KEY_ZONE:
        snprintf(buffer, size, "; default [0, %g, 1, 1]", key->initial);
        break;
    default:
        snprintf(buffer, size, "; may be left out");
        break;
    }
    return buffer;
}

const char *explain_range(const struct key *key, char *buffer, size_t size)
{
    char allowed[1200], start[64];
    if (key_is_section(key)) {
        snprintf(buffer, size, "section");
    } else {
        snprintf(buffer, size, "%s; %s%s", type_name(key), value_allowed(key, allowed, sizeof allowed),
                 key->required ? "; required" : initial(key, start, sizeof start));
    }
    return buffer;
}

static bool is_asked(const struct explaining *explaining, const char *place, const char *name)
{
    const char *asked = explaining->asked;
    size_t length = strlen(place);
    if (!asked || strcmp(asked, name) == 0 || strcmp(asked, place) == 0) {
        return true;
    }
    return strncmp(asked, place, length) == 0 && asked[length] == '.' && strcmp(asked + length + 1, name) == 0;
}

static void lead(struct explaining *explaining)
{
    explaining->found = true;
    if (explaining->heading) {
        fprintf(explaining->out, "%s: %s\n", explaining->heading, explaining->about);
        explaining->heading = NULL;
    }
}

static void explain_keys(struct explaining *explaining, const char *place, const char *about, const struct key *keys)
{
    char range[1400];
    explaining->heading = place;
    explaining->about = about;
    for (const struct key *key = keys; key->name; key++) {
        if (!is_asked(explaining, place, key->name)) {
            continue;
        }
        lead(explaining);
        fprintf(explaining->out, "  %s (%s)\n      %s\n", key->name, explain_range(key, range, sizeof range),
                key->meaning);
    }
    if (is_asked(explaining, place, place)) {
        lead(explaining); /* a verb without parameters */
    }
}

static void explain_name(struct explaining *explaining, const char *place, const char *about, const char *name,
                         const char *meaning)
{
    explaining->about = about;
    if (is_asked(explaining, place, name)) {
        lead(explaining);
        fprintf(explaining->out, "  %s\n      %s\n", name, meaning);
    }
}

static void describe_palette(const struct palette *palette, char *text, size_t size)
{
    int inks_of[INK_PALETTE], used = 0;
    for (int i = 0; i < INK_PALETTE; i++) {
        inks_of[i] = ink_find(palette->inks[i]);
    }
    used += snprintf(text, size, "%s (%s, %s, %s, %s)\n      ", palette->meaning, palette->inks[0], palette->inks[1],
                     palette->inks[2], palette->inks[3]);
    if (palette->safe) {
        used += snprintf(text + used, size - (size_t)used, "Safe for colour-blind eyes%s. ",
                         palette->grey ? ", and told apart in grey" : "");
    }
    used += snprintf(text + used, size - (size_t)used, "Nearest two inks, CIEDE2000:");
    for (enum vision vision = VISION_USUAL; vision < VISIONS; vision++) {
        used += snprintf(text + used, size - (size_t)used, " %s %.0f%s", vision_name(vision),
                         (double)vision_between(vision, inks_of, VISION_INKED), vision == VISION_GREY ? "." : ",");
    }
}

static void explain_names(struct explaining *explaining)
{
    explaining->heading = "brushes";
    for (int i = 0; brushes[i].name; i++) {
        explain_name(explaining, "brushes", "Named ways of growing, for the brush of a drop.", brushes[i].name,
                     brushes[i].meaning);
    }
    explaining->heading = "inks";
    for (int i = 0; inks[i].name; i++) {
        explain_name(explaining, "inks", "One to four of them make a session.", inks[i].name, inks[i].meaning);
    }
    explaining->heading = "palettes";
    for (int i = 0; palettes[i].name; i++) {
        char meaning[512];
        describe_palette(&palettes[i], meaning, sizeof meaning);
        explain_name(explaining, "palettes", "Four inks at once.", palettes[i].name, meaning);
    }
}

/* The tables of a kind of file: all of them by the name of the first, one by its name, or what a key is in them. */
static void explain_tables(struct explaining *explaining, const struct inputs_table *tables)
{
    const char *asked = explaining->asked;
    if (asked && strcmp(asked, tables->name) == 0) {
        explaining->asked = NULL;
    }
    for (const struct inputs_table *table = tables; table->name; table++) {
        explain_keys(explaining, table->name, table->about, table->keys);
    }
    explaining->asked = asked;
}

bool explain(const char *asked, FILE *out)
{
    struct key options[EXHIBIT_OPTIONS_KEYS];
    struct inputs_tables inputs;
    struct explaining explaining = {.asked = asked, .out = out};
    explain_keys(&explaining, "script", "A session script in YAML.", script_keys);
    explain_keys(&explaining, "canvas", "The sheet.", canvas_keys);
    explain_keys(&explaining, "painting", "The coefficients of the painting.", coefficient_keys);
    explain_keys(&explaining, "actions", "Beside its verb, an action has:", action_tick_keys);
    for (int i = 0; i < ACTION_VERBS; i++) {
        enum action_verb verb = (enum action_verb)i;
        explain_keys(&explaining, action_name(verb), action_meaning(verb), action_keys(verb));
    }
    struct key structure[SCRIPT_STRUCTURE_KEYS];
    script_structure_keys(structure);
    explain_keys(&explaining, "structure", "What grows over a picture, wherever a verb takes a picture.", structure);
    explain_keys(&explaining, "text", "Words in place of a picture, of dose, style and strike.", script_text_keys);
    explain_keys(&explaining, "session", "What another session comes to, wherever a verb takes a picture.",
                 script_session_keys);
    explain_tables(&explaining, exhibit_tables);
    for (int kind = SCENE_PAINTING + 1; kind < SCENE_KINDS; kind++) {
        exhibit_options_keys((enum scene_kind)kind, options);
        explain_keys(&explaining, scene_kind_names[kind], scene_kind_meanings[kind], options);
    }
    explain_tables(&explaining, inputs_tables_of(&inputs));
    explain_keys(&explaining, "grow", "Options of frond grow.", growth_keys);
    explain_keys(&explaining, "grow", "Options of frond grow.", grow_keys);
    explain_keys(&explaining, "bolt", "Options of frond bolt; defaults are those of the kind.", laplacian_keys);
    explain_keys(&explaining, "bolt", "Options of frond bolt; defaults are those of the kind.", bolt_look_keys);
    explain_keys(&explaining, "bolt", "Options of frond bolt.", bolt_order_keys);
    explain_names(&explaining);
    return explaining.found;
}
