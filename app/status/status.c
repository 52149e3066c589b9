#include "status.h"

#include <math.h>
#include <stdio.h>
#include <string.h>

#include <json.h>

#include "json_number.h"

/* A frame of 60 Hz, two, three of them; 20 and 10 a second; and what one sees as a stop. */
const double status_bucket_s[STATUS_BUCKETS] = {0.0175, 0.034, 0.051, 0.1, 0.2, 0.5, 1, 5};

void status_frame(struct status_frames *frames, double seconds)
{
    for (int i = 0; i < STATUS_BUCKETS; i++) {
        if (seconds <= status_bucket_s[i]) {
            frames->buckets[i]++;
            break;
        }
    }
    frames->count++;
    frames->sum_s += seconds;
    frames->longest_s = seconds > frames->longest_s ? seconds : frames->longest_s;
}

/* Bytes of the UTF-8 character at `text`; 0: it is none. RFC 3629. */
static size_t character(const unsigned char *text)
{
    static const struct {
        unsigned char first, last, low, high; /* of the first byte; of the second */
        size_t bytes;
    } kinds[] = {{0x20, 0x7e, 0, 0, 1},       {0xc2, 0xdf, 0x80, 0xbf, 2}, {0xe0, 0xe0, 0xa0, 0xbf, 3},
                 {0xe1, 0xec, 0x80, 0xbf, 3}, {0xed, 0xed, 0x80, 0x9f, 3}, {0xee, 0xef, 0x80, 0xbf, 3},
                 {0xf0, 0xf0, 0x90, 0xbf, 4}, {0xf1, 0xf3, 0x80, 0xbf, 4}, {0xf4, 0xf4, 0x80, 0x8f, 4}};
    for (size_t i = 0; i < sizeof kinds / sizeof kinds[0]; i++) {
        if (text[0] >= kinds[i].first && text[0] <= kinds[i].last) {
            bool good = kinds[i].bytes == 1 || (text[1] >= kinds[i].low && text[1] <= kinds[i].high);
            for (size_t j = 2; good && j < kinds[i].bytes; j++) {
                good = text[j] >= 0x80 && text[j] <= 0xbf;
            }
            return good ? kinds[i].bytes : 0;
        }
    }
    return 0;
}

void status_word(char word[STATUS_WORD], const char *text)
{
    size_t used = 0;
    while (*text) {
        size_t bytes = character((const unsigned char *)text);
        if (used + (bytes ? bytes : 1) >= STATUS_WORD) {
            break;
        }
        if (bytes == 0) {
            word[used++] = (unsigned char)*text < 0x80 ? ' ' : '?';
            text++;
            continue;
        }
        memcpy(word + used, text, bytes);
        used += bytes;
        text += bytes;
    }
    word[used] = '\0';
}

static void add_text(struct json_object *object, const char *name, const char *text)
{
    json_object_object_add(object, name, text[0] ? json_object_new_string(text) : NULL);
}

static void add_number(struct json_object *object, const char *name, double value)
{
    json_object_object_add(object, name, json_number(value, 6));
}

static void add_whole(struct json_object *object, const char *name, uint64_t value)
{
    json_object_object_add(object, name, json_object_new_int64((int64_t)value));
}

static void add_flag(struct json_object *object, const char *name, bool value)
{
    json_object_object_add(object, name, json_object_new_boolean(value));
}

static struct json_object *frames_object(const struct status *status)
{
    const struct status_frames *frames = &status->frames;
    struct json_object *object = json_object_new_object();
    add_whole(object, "presented", status->frames_presented);
    add_whole(object, "missed", status->blanks_missed);
    add_number(object, "mean_ms", frames->count ? 1000 * frames->sum_s / (double)frames->count : NAN);
    add_number(object, "longest_ms", frames->count ? 1000 * frames->longest_s : NAN);
    return object;
}

static struct json_object *painting_object(const struct status *status)
{
    struct json_object *object = json_object_new_object();
    add_text(object, "engine", status->engine);
    json_object_object_add(object, "tick", json_object_new_int64(status->ticks));
    add_number(object, "ticks_per_second", status->ticks_per_second);
    add_number(object, "tick_ms", 1000 * status->tick_s);
    add_number(object, "grid", status->grid);
    add_whole(object, "gpu_resets", status->gpu_resets);
    return object;
}

static struct json_object *board_object(const struct status *status)
{
    struct json_object *object = json_object_new_object();
    add_number(object, "celsius", status->celsius);
    add_flag(object, "throttled", status->throttled);
    add_flag(object, "under_voltage", status->under_voltage);
    return object;
}

static struct json_object *devices_array(const struct status *status)
{
    struct json_object *list = json_object_new_array();
    for (int i = 0; i < status->device_count; i++) {
        const struct status_device *device = &status->devices[i];
        struct json_object *entry = json_object_new_object();
        add_text(entry, "name", device->name);
        add_text(entry, "class", device->class);
        add_flag(entry, "admitted", device->admitted);
        add_flag(entry, "works", device->works);
        json_object_array_add(list, entry);
    }
    return list;
}

size_t status_json(const struct status *status, char *text, size_t size)
{
    struct json_object *object = json_object_new_object();
    if (!object) {
        return 0;
    }
    add_text(object, "frond", FROND_VERSION);
    json_object_object_add(object, "unix", json_object_new_int64(status->unix_s));
    add_number(object, "uptime_s", floor(status->uptime_s));
    add_text(object, "state", status->state);
    add_text(object, "scene", status->scene);
    add_whole(object, "visits", status->visits);
    add_whole(object, "drops", status->drops);
    add_whole(object, "actions_refused", status->actions_refused);
    add_text(object, "display", status->display);
    json_object_object_add(object, "frames", frames_object(status));
    json_object_object_add(object, "painting", painting_object(status));
    json_object_object_add(object, "board", board_object(status));
    json_object_object_add(object, "gallery", status->gallery >= 0 ? json_object_new_int(status->gallery) : NULL);
    add_whole(object, "exhibit_errors", status->exhibit_errors);
    add_flag(object, "exhibit_wrong", status->exhibit_wrong);
    json_object_object_add(object, "devices", devices_array(status));
    const char *json = json_object_to_json_string_ext(object, JSON_C_TO_STRING_PRETTY | JSON_C_TO_STRING_NOSLASHESCAPE);
    int length = json ? snprintf(text, size, "%s\n", json) : 0;
    json_object_put(object);
    return length > 0 && (size_t)length < size ? (size_t)length : 0;
}
