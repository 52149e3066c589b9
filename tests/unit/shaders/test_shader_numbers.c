/* Numbers that C and GLSL both must write down are the same in both. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "deposit.h"
#include "painting_gpu_state.h"
#include "plate.h"
#include "rinse.h"

static const struct {
    const char *source, *name;
    double value;
} NUMBERS[] = {
    {"planes.glsl", "TILE", GPU_TILE},
    {"planes.glsl", "APRON", GPU_APRON},
    {"planes.glsl", "SOLVENT", GPU_SOLVENT},
    {"planes.glsl", "INK", GPU_INK},
    {"planes.glsl", "WET", GPU_WET},
    {"planes.glsl", "ACTIVE", GPU_ACTIVE},
    {"planes.glsl", "CATALYST", GPU_CATALYST},
    {"planes.glsl", "CARVED", GPU_CARVED},
    {"planes.glsl", "ALPHA_A_XI", GPU_ALPHA_A_XI},
    {"planes.glsl", "BETA_A_S_MAX", GPU_BETA_A_S_MAX},
    {"planes.glsl", "ALPHA_Y_REST", GPU_ALPHA_Y_REST},
    {"planes.glsl", "GUIDE", GPU_GUIDE},
    {"planes.glsl", "DENSITY", GPU_DENSITY},
    {"planes.glsl", "OPEN_SOLVENT", GPU_OPEN_SOLVENT},
    {"planes.glsl", "OPEN_INK", GPU_OPEN_INK},
    {"planes.glsl", "DRY", GPU_DRY},
    {"planes.glsl", "CLOSED", (double)CLOSED},
    {"tiles.glsl", "BIT_FLOWS", BIT_FLOWS},
    {"tiles.glsl", "BIT_WET", BIT_WET},
    {"tiles.glsl", "BIT_OPENED", BIT_OPENED},
    {"tiles.glsl", "BIT_GROWS", BIT_GROWS},
    {"tiles.glsl", "BIT_FED", BIT_FED},
    {"tiles.glsl", "BIT_ALIVE", BIT_ALIVE},
    {"tiles.glsl", "BIT_SPECIAL", BIT_SPECIAL},
    {"tiles.glsl", "BIT_CARVED", BIT_CARVED},
    {"tiles.glsl", "BIT_DAMP", BIT_DAMP},
    {"tiles.glsl", "BIT_CHANGED", BIT_CHANGED},
    {"tiles.glsl", "LIST_FLUID", LIST_FLUID},
    {"tiles.glsl", "LIST_FREE", LIST_FREE},
    {"tiles.glsl", "LIST_SPECIAL", LIST_SPECIAL},
    {"tiles.glsl", "LIST_COUNT", LIST_COUNT},
    {"tiles.glsl", "LIST_CHUNK", GPU_LIST_CHUNK},
    {"tiles.glsl", "CHUNKS_MOST", GPU_CHUNKS_MOST},
    {"tiles.glsl", "HEAD_COUNT", GPU_HEAD_COUNT},
    {"tiles.glsl", "HEAD_QUIET", GPU_HEAD_QUIET},
    {"tiles.glsl", "HEAD_CARVED", GPU_HEAD_CARVED},
    {"tiles.glsl", "HEAD_DISPATCH", GPU_HEAD_DISPATCH},
    {"tiles.glsl", "CALM_PERIODS", CALM_PERIODS},
    {"deposit.comp", "LAW_DROP", DEPOSIT_DROP},
    {"deposit.comp", "LAW_SOLVENT", DEPOSIT_SOLVENT},
    {"deposit.comp", "LAW_INK", DEPOSIT_INK},
    {"deposit.comp", "LAW_LINE", DEPOSIT_LINE},
    {"deposit.comp", "LAW_FRESH", DEPOSIT_FRESH},
    {"deposit.comp", "LAW_DRIES", DEPOSIT_DRIES},
    {"deposit.comp", "LAW_WETS", DEPOSIT_WETS},
    {"deposit.comp", "LAW_RINSE", DEPOSIT_RINSE},
    {"deposit.comp", "INKS", PAINTING_INKS},
    {"deposit.comp", "RINSE_OVER", (double)RINSE_OVER},
    {"deposit.comp", "RINSE_FILM", (double)RINSE_FILM},
    {"deposit.comp", "RINSE_WATER", (double)RINSE_WATER},
    {"deposit.comp", "RINSE_SPEED", (double)RINSE_SPEED},
    {"upkeep_pigment.comp", "INKS", PAINTING_INKS},
    {"planes.glsl", "UNIT_XI", (double)UNIT_XI},
    {"planes.glsl", "UNIT_S_MAX", (double)UNIT_S_MAX},
    {"planes.glsl", "UNIT_WEIGHT", (double)UNIT_WEIGHT},
    {"planes.glsl", "UNIT_GUIDE", (double)UNIT_GUIDE},
    {"plate.frag", "SOFT", PLATE_SOFT},
};

static const char *text_of(const char *name)
{
    const struct shader_source *source = shader_sources;
    while (source->name && strcmp(source->name, name) != 0) {
        source++;
    }
    return source->name ? source->text : "";
}

/* `const TYPE NAME = NUMBER;` or `= NUMBER / NUMBER;` NaN where there is none. */
static double number_in(const char *text, const char *name)
{
    size_t length = strlen(name);
    for (const char *at = text; (at = strstr(at, name)); at += length) {
        const char *before = at;
        while (before > text && before[-1] != '\n') {
            before--;
        }
        if (strncmp(before, "const ", 6) == 0 && strncmp(at + length, " = ", 3) == 0 && at[-1] == ' ') {
            char *end;
            double value = strtod(at + length + 3, &end);
            return strncmp(end, " / ", 3) == 0 ? value / strtod(end + 3, NULL) : value;
        }
    }
    return (double)NAN;
}

static void c_and_glsl_agree(void **state)
{
    (void)state;
    for (size_t i = 0; i < sizeof NUMBERS / sizeof NUMBERS[0]; i++) {
        double found = number_in(text_of(NUMBERS[i].source), NUMBERS[i].name);
        if (!(fabs(found - NUMBERS[i].value) <= 1e-6 * fabs(NUMBERS[i].value))) {
            fail_msg("%s: %s is %g, in C %g", NUMBERS[i].source, NUMBERS[i].name, found, NUMBERS[i].value);
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {cmocka_unit_test(c_and_glsl_agree)};
    return cmocka_run_group_tests(tests, NULL, NULL);
}
