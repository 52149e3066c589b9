/* Rows of tables whose keys (key.h) are called as their fields, all in one order: field, unit, least, most, default,
 * meaning. For the file that has the table; it says where a field lies:
 *
 *     #define KEY_AT(field) offsetof(struct storm_def, field)
 *     const struct key storm_keys[] = {
 *         NUMBER(eta, "", 0, 20, 8, "How much growth prefers what stands out."),
 *         END,
 *     };
 */
#ifndef FROND_KEY_FIELDS_H
#define FROND_KEY_FIELDS_H

#include "key.h"

#define NUMBER(field, what, least, most, start, text)                                                                  \
    {                                                                                                                  \
        .name = #field, .type = KEY_NUMBER, .unit = what, .min = least, .max = most, .initial = start,                 \
        .offset = KEY_AT(field), .meaning = text                                                                       \
    }
#define WHOLE(field, what, least, most, start, text)                                                                   \
    {                                                                                                                  \
        .name = #field, .type = KEY_INTEGER, .unit = what, .min = least, .max = most, .initial = start,                \
        .offset = KEY_AT(field), .meaning = text                                                                       \
    }
#define CHOICE(field, names, start, text)                                                                              \
    {                                                                                                                  \
        .name = #field, .type = KEY_CHOICE, .unit = "", .initial = start, .choices = names, .offset = KEY_AT(field),   \
        .meaning = text                                                                                                \
    }
/* Off by default. */
#define FLAG(field, text)                                                                                              \
    {                                                                                                                  \
        .name = #field, .type = KEY_FLAG, .unit = "", .offset = KEY_AT(field), .meaning = text                         \
    }
/* In 0..1; its default is set by whoever fills the struct. */
#define POINT(field, text)                                                                                             \
    {                                                                                                                  \
        .name = #field, .type = KEY_POINT, .unit = "", .offset = KEY_AT(field), .meaning = text                        \
    }
#define RASTER(field, text)                                                                                            \
    {                                                                                                                  \
        .name = #field, .type = KEY_PICTURE, .unit = "", .offset = KEY_AT(field), .meaning = text                      \
    }
#define END                                                                                                            \
    {                                                                                                                  \
        .name = NULL                                                                                                   \
    }

#endif
