/* Rows of tables of keys (key.h) as files have them, exhibits and inputs: over several structs, some keys required;
 * what a model sets has rows in one order alone (sim/base/key_rows.h). Private to files that define such tables. */
#ifndef FROND_FILE_ROWS_H
#define FROND_FILE_ROWS_H

#include <stddef.h>

#include "key.h"

/* A list or a mapping with a reader of its own (key_is_section). */
#define SECTION(name, text)                                                                                            \
    {                                                                                                                  \
        name, KEY_CHOICE, "section", 0, 0, 0, NULL, 0, false, text                                                     \
    }
#define TEXT(name, type, field, unit, most, need, text)                                                                \
    {                                                                                                                  \
        name, KEY_TEXT, unit, 1, most, 0, NULL, offsetof(type, field), need, text                                      \
    }
#define FLAG(name, type, field, def, text)                                                                             \
    {                                                                                                                  \
        name, KEY_FLAG, "", 0, 1, def, NULL, offsetof(type, field), false, text                                        \
    }
#define WHOLE(name, type, field, unit, min, max, def, need, text)                                                      \
    {                                                                                                                  \
        name, KEY_INTEGER, unit, min, max, def, NULL, offsetof(type, field), need, text                                \
    }
#define NUMBER(name, type, field, unit, min, max, def, need, text)                                                     \
    {                                                                                                                  \
        name, KEY_NUMBER, unit, min, max, def, NULL, offsetof(type, field), need, text                                 \
    }
#define CHOICE(name, type, field, list, def, need, text)                                                               \
    {                                                                                                                  \
        name, KEY_CHOICE, "", 0, 0, def, list, offsetof(type, field), need, text                                       \
    }
#define END                                                                                                            \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

#endif
