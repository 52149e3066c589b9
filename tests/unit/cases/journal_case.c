#include "journal_case.h"

#include <string.h>

#include "brush.h"
#include "ink_table.h"

struct journal_head journal_case_head(void)
{
    return (struct journal_head){
        .version = "0.1.0", .engine = "cpu", .exhibit = "table", .exhibit_hash = 0x123456789abcdefu};
}

struct journal_sheet journal_case_sheet(void)
{
    struct journal_sheet sheet = {.def = painting_default_def(),
                                  .mode = INK_CMY,
                                  .inks = {5, 2, 0},
                                  .ink_count = 3,
                                  .history = {5000000, 30, 8, 900, 4, 45}};
    sheet.def.width = 64;
    sheet.def.height = 48;
    sheet.def.margin = 7;
    sheet.def.seed = 4000000000u;
    sheet.def.coefficients.alpha_a = 0.3f;
    sheet.def.coefficients.noise = NOISE_LOGNORMAL;
    sheet.def.coefficients.fluid_steps = 3;
    strcpy(sheet.scene, "dawn");
    return sheet;
}

static void fill(const struct key *key, int seed, struct action *action, struct journal_case_values *values)
{
    char *at = (char *)action + key->offset;
    float number = (float)(key->min + (key->max - key->min) * (0.1 + 0.17 * (seed % 5)));
    int whole = seed % 2;
    bool flag = seed % 2 == 0;
    struct point point = {0.1f + 0.13f * (float)(seed % 6), 0.9f - 0.11f * (float)(seed % 7)};
    struct action_path path = {values->points, 1 + seed % 3};
    struct action_raster raster = {values->values, 4, 3, 1 + seed % 2};
    const struct key *options = action_options(key);
    switch (key->type) {
    case KEY_NUMBER:
        memcpy(at, &number, sizeof number);
        break;
    case KEY_FLAG:
        memcpy(at, &flag, sizeof flag);
        break;
    case KEY_POINT:
        memcpy(at, &point, sizeof point);
        action->has_at = flag;
        break;
    case KEY_PATH:
        memcpy(at, &path, sizeof path);
        break;
    case KEY_RASTER:
    case KEY_PICTURE:
        memcpy(at, &raster, sizeof raster);
        break;
    case KEY_BRUSH:
        whole = seed % 3 - 1;
        memcpy(at, &whole, sizeof whole);
        break;
    default:
        whole = options ? seed % key_count(options) : whole;
        memcpy(at, &whole, sizeof whole);
        break;
    }
}

struct action journal_case_action(enum action_verb verb, int seed, struct journal_case_values *values)
{
    struct action action = action_default(verb);
    action.visitor = seed % 4 - 1;
    for (int i = 0; i < 3; i++) {
        values->points[i] = (struct point){0.1f * (float)(seed % 9 + i), 0.05f * (float)(seed % 11) + 0.3f * (float)i};
    }
    for (int i = 0; i < 24; i++) {
        values->values[i] = (float)(i * (seed % 13)) / 7.0f - 1.0f;
    }
    for (const struct key *key = action_keys(verb); key->name; key++, seed++) {
        fill(key, seed, &action, values);
    }
    return action;
}

static bool same_raster(const struct action_raster *a, const struct action_raster *b)
{
    return !a->values == !b->values &&
           (!a->values || (a->width == b->width && a->height == b->height && a->channels == b->channels &&
                           memcmp(a->values, b->values,
                                  sizeof(float) * (size_t)a->width * (size_t)a->height * (size_t)a->channels) == 0));
}

static bool same_path(const struct action_path *a, const struct action_path *b)
{
    return a->count == b->count && memcmp(a->points, b->points, (size_t)a->count * sizeof *a->points) == 0;
}

bool journal_case_same(const struct action *a, const struct action *b)
{
    bool same = a->verb == b->verb && a->visitor == b->visitor && a->has_at == b->has_at;
    for (const struct key *key = action_keys(a->verb); key->name; key++) {
        const char *left = (const char *)a + key->offset, *right = (const char *)b + key->offset;
        if (key->type == KEY_PATH) {
            same = same && same_path((const struct action_path *)left, (const struct action_path *)right);
        } else if (key->type == KEY_RASTER || key->type == KEY_PICTURE) {
            same = same && same_raster((const struct action_raster *)left, (const struct action_raster *)right);
        } else {
            size_t size = key->type == KEY_POINT ? sizeof(struct point) : key->type == KEY_FLAG ? sizeof(bool) : 4;
            same = same && memcmp(left, right, size) == 0;
        }
    }
    return same;
}

bool journal_case_same_sheet(const struct journal_sheet *a, const struct journal_sheet *b)
{
    const struct painting_def *one = &a->def, *other = &b->def;
    bool same = one->width == other->width && one->height == other->height && one->margin == other->margin &&
                one->seed == other->seed && a->mode == b->mode && a->ink_count == b->ink_count &&
                strcmp(a->scene, b->scene) == 0;
    for (const struct key *key = coefficient_keys; key->name; key++) {
        const char *left = (const char *)&one->coefficients + key->offset;
        same = same && memcmp(left, (const char *)&other->coefficients + key->offset, sizeof(float)) == 0;
    }
    for (int i = 0; i < a->ink_count; i++) {
        same = same && a->inks[i] == b->inks[i];
    }
    return same && a->history.bytes == b->history.bytes && a->history.interval == b->history.interval &&
           a->history.tiles_a_tick == b->history.tiles_a_tick && a->history.age == b->history.age &&
           a->history.levels == b->history.levels && a->history.pause == b->history.pause;
}
