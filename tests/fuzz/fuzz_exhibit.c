/* Any bytes as an exhibit: a report or an exhibit, and nothing in an accepted one that a kiosk could fall over. */
#include <assert.h>
#include <math.h>
#include <stdint.h>
#include <stdlib.h>
#include <string.h>

#include "coefficients.h"
#include "exhibit.h"
#include "exhibit_read.h"
#include "ink.h"

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);
const char *__lsan_default_suppressions(void);

/* libfyaml 0.7.12 loses up to 4 KiB where the syntax of a long scalar is wrong; leaks of our own still count. */
const char *__lsan_default_suppressions(void)
{
    return "leak:libfyaml.so";
}

/* Every picture is there, and four pixels large. */
static bool load(void *data, const char *folder, const char *path, struct script_picture *picture,
                 struct file_error *error)
{
    static const float VALUES[4] = {0, 1, 0.5f, 0.25f};
    (void)data;
    (void)folder;
    (void)error;
    assert(path && *path);
    *picture = (struct script_picture){2, 2, 1, malloc(sizeof VALUES)};
    assert(picture->values);
    memcpy(picture->values, VALUES, sizeof VALUES);
    return true;
}

static void check_range(const struct key *keys, const void *object)
{
    for (const struct key *key = keys; key->name; key++) {
        float value = 0;
        if (key->type == KEY_NUMBER) {
            memcpy(&value, (const char *)object + key->offset, sizeof value);
            assert(value >= (float)key->min && value <= (float)key->max);
        }
    }
}

static const struct key *table(const char *name)
{
    const struct inputs_table *tables = exhibit_tables;
    while (strcmp(tables->name, name) != 0) {
        tables++;
    }
    return tables->keys;
}

/* What pictures and the opening do to a fresh sheet: the pictures have come, and actions are within their keys. */
static void check_ground(const struct exhibit_scene *scene)
{
    int guides = 0, masks = 0;
    assert(scene->ground_count >= 0 && scene->ground_count <= 2 + EXHIBIT_STRUCTURES + EXHIBIT_OPENING);
    for (int k = 0; k < scene->ground_count; k++) {
        const struct action *action = &scene->ground[k];
        const struct action_raster *raster = &action->picture;
        assert(action->verb < ACTION_VERBS);
        assert(k < scene->opening || scene_takes((enum scene_kind)scene->kind, action->verb));
        check_range(action_keys(action->verb), action);
        assert(!raster->values || (raster->width > 0 && raster->height > 0 && isfinite(raster->values[0])));
        guides += action->verb == ACTION_GUIDE && raster->values && raster->width == scene->script->width;
        masks += action->verb == ACTION_MASK && raster->values && raster->width == scene->script->width;
    }
    assert(guides >= (scene->guide != NULL) && masks >= (scene->mask != NULL));
}

static void check_scenes(const struct exhibit *exhibit)
{
    assert(exhibit->scene_count >= 1 && exhibit->scene_count <= EXHIBIT_SCENES);
    for (int i = 0; i < exhibit->scene_count; i++) {
        const struct exhibit_scene *scene = &exhibit->scenes[i];
        const struct script *script = scene->script;
        assert(scene->id && *scene->id && script);
        assert(script->width >= CANVAS_SIZE_MIN && script->width <= CANVAS_SIZE_MAX);
        assert(script->height >= CANVAS_SIZE_MIN && script->height <= CANVAS_SIZE_MAX);
        assert(script->ink_count >= 1 && script->ink_count <= PAINTING_INKS && script->action_count == 0);
        for (int k = 0; k < script->ink_count; k++) {
            assert(script->inks[k] >= 0 && inks[script->inks[k]].name);
        }
        check_range(coefficient_keys, &script->coefficients);
        check_ground(scene);
    }
}

static void check_zone(const float zone[4])
{
    assert(zone[0] >= 0 && zone[0] < zone[2] && zone[2] <= 1);
    assert(zone[1] >= 0 && zone[1] < zone[3] && zone[3] <= 1);
}

static void check_seats(const struct exhibit *exhibit)
{
    assert(exhibit->seat_count >= 1 && exhibit->seat_count <= EXHIBIT_SEATS);
    for (int i = 0; i < exhibit->seat_count; i++) {
        const struct exhibit_seat *seat = &exhibit->seats[i];
        check_zone(seat->zone);
        assert(seat->side >= SIDE_OF_LEFT && seat->side <= SIDE_OF_NONE);
        for (int k = 0; k < exhibit->scene_count && seat->ink >= 0; k++) {
            const struct script *script = exhibit->scenes[k].script, *first = exhibit->scenes[0].script;
            assert(seat->ink < script->ink_count && script->inks[seat->ink] == first->inks[seat->ink]);
        }
        for (int k = 0; k < i; k++) {
            const float *a = exhibit->seats[k].zone, *b = seat->zone;
            assert(!(a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3]));
        }
    }
}

static void check_words(const struct exhibit *exhibit)
{
    assert(exhibit->language_count >= 1 && exhibit->language_count <= WORDS_LANGUAGES);
    for (int i = 0; i < exhibit->language_count; i++) {
        int language = exhibit->languages[i];
        assert(language >= 0 && language < WORDS_LANGUAGES && words_languages[language].tag);
        for (int k = 0; k < TEXTS; k++) {
            assert(*words_of(exhibit->texts, (enum exhibit_text)k, language));
        }
        assert(strstr(words_of(exhibit->texts, TEXT_COUNTDOWN, language), "{seconds}"));
    }
}

static void check_rest(const struct exhibit *exhibit)
{
    check_range(table("display"), &exhibit->display);
    check_range(table("palette"), &exhibit->palette);
    check_range(table("visit"), &exhibit->visit);
    check_range(table("access"), &exhibit->access);
    check_range(table("staff"), &exhibit->staff);
    check_zone(exhibit->access.zone);
    assert(exhibit->display.rotation % 90 == 0 && exhibit->display.rotation >= 0 && exhibit->display.rotation < 360);
    assert(exhibit->sheet.rate > 0 && exhibit->engine >= 0 && exhibit->engine < ENGINE_KINDS);
    assert(exhibit->palette.tools[TOOL_DROP]);
    assert(exhibit->staff.tap_count >= 3 && exhibit->staff.tap_count <= EXHIBIT_TAPS);
    assert(exhibit->hours_count >= 0 && exhibit->hours_count <= EXHIBIT_HOURS);
    for (int i = 0; i < exhibit->hours_count; i++) {
        const struct exhibit_hours *hours = &exhibit->hours[i];
        assert(hours->from >= 0 && hours->from <= 1440 && hours->to >= 0 && hours->to <= 1440);
        assert(memchr(hours->days, true, sizeof hours->days));
    }
    assert(!exhibit->gallery.folder || !strchr(exhibit->gallery.folder, '/'));
    /* There are no files but the pictures that come with Frond. */
    assert((!exhibit->pictures || strstr(exhibit->pictures, "stock")) && exhibit->session_count == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct script_def def = script_default_def();
    struct report report;
    def.load = load;
    def.raster_values_max = 1 << 17;
    report_init(&report, "e.yaml");
    struct exhibit *exhibit = exhibit_parse((const char *)data, size, "/nowhere", &def, &report);
    assert(!exhibit == !report_empty(&report));
    if (exhibit) {
        check_scenes(exhibit);
        check_seats(exhibit);
        check_words(exhibit);
        check_rest(exhibit);
    }
    char *text = report_text(&report);
    assert(text);
    free(text);
    exhibit_destroy(exhibit);
    report_finish(&report);
    return 0;
}
