/* The variants of a shader: the sets of #defines with which the library may put it together. A stage names all of them,
 * each line a set, with alternatives of a value between bars:
 *
 *     #variant STEPS=1|2|4 GUIDED=0|1     six variants
 *     #variant STEPS=8 FLAT               one more, `#define STEPS 8` and `#define FLAT`
 *     #variant                            and one without any
 *
 * A stage without such lines has one variant, without defines. shader_text refuses every other set, so that what checks
 * all variants of all sources (tests/checks/limits) has checked all that ever reaches a compiler. */
#ifndef FROND_VARIANT_H
#define FROND_VARIANT_H

#include <stdbool.h>

enum {
    VARIANT_DEFINES = 16, /* of one variant */
    VARIANT_TEXT = 1024,  /* bytes, with the final NUL */
};

/* Whether this line of a source is a #variant. */
bool variant_is_line(const char *line);
/* The lines of #define of the variant of this index, 0 and up; false beyond the last. */
bool variant_defines(const char *source, int index, char defines[VARIANT_TEXT]);
/* Whether `defines`, lines of #define in any order, or NULL, are a variant of this source. */
bool variant_admits(const char *source, const char *defines);
/* `defines` as a #variant line writes them: "STEPS=4 GUIDED"; cut where it is longer. */
void variant_label(const char *defines, char label[VARIANT_TEXT]);

#endif
