/* Rows of the tables of verbs (verb.h): parameters over `struct action` that more than one verb has. */
#ifndef FROND_VERB_KEYS_H
#define FROND_VERB_KEYS_H

#include "action.h"
#include "key_fields.h"

#define KEY_AT(field)      offsetof(struct action, field)
#define VALUE(field, text) NUMBER(field, "as the coefficient", -100, 1000, 0, text)
#define INVERT             FLAG(invert, "Swap inside and outside.")
#define AT(need, text)                                                                                                 \
    {                                                                                                                  \
        "at", KEY_POINT, "0..1 of the sheet", 0, 1, 0, NULL, KEY_AT(at), need, text                                    \
    }
#define PATH(need)                                                                                                     \
    {                                                                                                                  \
        "path", KEY_PATH, "0..1 of the sheet", 0, 1, 0, NULL, KEY_AT(path), need, "The stroke, point by point."        \
    }
#define FORMULA(text)                                                                                                  \
    {                                                                                                                  \
        "formula", KEY_RASTER, "", 0, 0, 0, NULL, KEY_AT(formula), false, text                                         \
    }
#define PICTURE(text)                                                                                                  \
    {                                                                                                                  \
        "picture", KEY_PICTURE, "", 0, 0, 0, NULL, KEY_AT(picture), false, text                                        \
    }
#define INK                                                                                                            \
    {                                                                                                                  \
        "ink", KEY_INK, "", 0, 0, 0, NULL, KEY_AT(ink), false,                                                         \
            "One of the inks of the session; the first if left out."                                                   \
    }
#define BRUSH                                                                                                          \
    {                                                                                                                  \
        "brush", KEY_BRUSH, "", 0, 0, -1, NULL, KEY_AT(brush), false,                                                  \
            "A named way of growing, stamped around the drop."                                                         \
    }
#define RADIUS(def, text) NUMBER(radius, "cells", 0.5, 512, def, text)

/* Value of a verb that sets an option of a scene. */
#define OPTION_VALUE(min, max)                                                                                         \
    NUMBER(value, "as that", min, max, 0, "Its value; of a choice its name or its number from 0, of a flag 0 or 1.")
#define OPTION(name, kind, text)                                                                                       \
    {                                                                                                                  \
        name, KEY_OPTION, "", kind, kind, 0, NULL, KEY_AT(option), true, text                                          \
    }

#endif
