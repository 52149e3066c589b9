/* `text: FROND`, or `text: {words: FROND, at: [0.5, 0.5], width: 0.8}`: words in place of a picture, dark on light. */
#ifndef FROND_SCRIPT_TEXT_H
#define FROND_SCRIPT_TEXT_H

#include "script_value.h"

struct script_text {
    const char *words;   /* UTF-8, as it stands in the file */
    struct point at;     /* middle of the block; 0, 0: of the sheet */
    float width, height; /* shares of the sheet that it fits into */
    float line;          /* cells: the letters' outlines, so wide; 0: they are filled */
};
/* Over struct script_text; ends with a key whose name is NULL. */
extern const struct key script_text_keys[];

/* Whether words may stand where the verb takes a picture. */
bool script_text_is_for(enum action_verb verb);
/* Reads it, writes it as large as it fits and makes it the picture of the action, a value a cell of the sheet. False
 * when anything is wrong, which is reported. */
bool script_text_read(struct reader *reader, const struct yaml_node *node, struct action *action);
/* Fills width * height values: 1 is the sheet, 0 the middle of a letter. False when memory is short. */
bool script_text_draw(const struct script_text *text, int width, int height, float *values);

#endif
