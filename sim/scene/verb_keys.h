/* Rows of the tables of verbs (verb.h): parameters over `struct action` that more than one verb has. */
#ifndef FROND_VERB_KEYS_H
#define FROND_VERB_KEYS_H

#include "action.h"

#define FIELD(field) offsetof(struct action, field)
#define NUMBER(field, unit, min, max, def, text)                                                                       \
    {                                                                                                                  \
#field, KEY_NUMBER, unit, min, max, def, NULL, FIELD(field), false, text                                       \
    }
#define VALUE(field, text)                                                                                             \
    {                                                                                                                  \
#field, KEY_NUMBER, "as the coefficient", -100, 1000, 0, NULL, FIELD(field), false, text                       \
    }
#define CHOICE(field, list, def, text)                                                                                 \
    {                                                                                                                  \
#field, KEY_CHOICE, "", 0, 0, def, list, FIELD(field), false, text                                             \
    }
#define AT(need, text)                                                                                                 \
    {                                                                                                                  \
        "at", KEY_POINT, "0..1 of the sheet", 0, 1, 0, NULL, FIELD(at), need, text                                     \
    }
#define PATH(need)                                                                                                     \
    {                                                                                                                  \
        "path", KEY_PATH, "0..1 of the sheet", 0, 1, 0, NULL, FIELD(path), need, "The stroke, point by point."         \
    }
#define FORMULA(text)                                                                                                  \
    {                                                                                                                  \
        "formula", KEY_RASTER, "", 0, 0, 0, NULL, FIELD(formula), false, text                                          \
    }
#define PICTURE(text)                                                                                                  \
    {                                                                                                                  \
        "picture", KEY_PICTURE, "", 0, 0, 0, NULL, FIELD(picture), false, text                                         \
    }
#define INK                                                                                                            \
    {                                                                                                                  \
        "ink", KEY_INK, "", 0, 0, 0, NULL, FIELD(ink), false, "One of the inks of the session; the first if left out." \
    }
#define BRUSH                                                                                                          \
    {                                                                                                                  \
        "brush", KEY_BRUSH, "", 0, 0, -1, NULL, FIELD(brush), false,                                                   \
            "A named way of growing, stamped around the drop."                                                         \
    }
#define INVERT                                                                                                         \
    {                                                                                                                  \
        "invert", KEY_FLAG, "", 0, 1, 0, NULL, FIELD(invert), false, "Swap inside and outside."                        \
    }
#define RADIUS(def, text) NUMBER(radius, "cells", 0.5, 512, def, text)
#define END                                                                                                            \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

/* Value of a verb that sets an option of a scene. */
#define OPTION_VALUE(min, max)                                                                                         \
    NUMBER(value, "as that", min, max, 0, "Its value; of a choice its name or its number from 0, of a flag 0 or 1.")
#define OPTION(name, type, text)                                                                                       \
    {                                                                                                                  \
        name, type, "", 0, 0, 0, NULL, FIELD(option), true, text                                                       \
    }

#endif
