/* The decoder of HID reports and the encoder of lamps. An input is a byte of choices, a descriptor after its length, a
 * few entries of a map, and reports, each after its length. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "hid_report.h"
#include "hid_usage.h"

enum {
    EVERYTHING = 1, /* choices */
    VENDOR = 2,
    NO_DESCRIPTOR = 4,
    ENTRIES_SHIFT = 4, /* how many entries of a map, 0..15 */
    ENTRY = 8,         /* bytes of each */
};

struct input {
    const uint8_t *at;
    size_t left;
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool truth)
{
    if (!truth) {
        abort();
    }
}

static uint8_t byte(struct input *input)
{
    if (input->left == 0) {
        return 0;
    }
    input->left--;
    return *input->at++;
}

static void check(void *user, const struct hid_value *value)
{
    int64_t *down = user;
    require(value->index >= 0 && value->index < 2 * HID_CONTROLS_MAX && isfinite(value->value));
    require(value->usage & 0xffffu || value->usage == 0x90000); /* a map may name what it likes */
    switch (value->kind) {
    case HID_BUTTON:
        require(value->value == 0 || value->value == 1);
        *down += value->value > 0 ? 1 : -1;
        require(*down >= 0);
        break;
    case HID_AXIS:
        require(value->value <= 1 && value->value >= (value->centred ? -1 : 0));
        break;
    case HID_HAT:
        require(value->value >= 0 && value->value <= 1);
        break;
    case HID_STEPS:
        require(value->value != 0 && fabsf(value->value) <= 4294967296.0f);
        break;
    case HID_ARRAY:
        require(false);
    }
}

static int take_map(struct input *input, int count, struct hid_map_entry *map)
{
    for (int i = 0; i < count; i++) {
        uint8_t bytes[ENTRY];
        for (int b = 0; b < ENTRY; b++) {
            bytes[b] = byte(input);
        }
        map[i] = (struct hid_map_entry){
            .report = bytes[0] & 3,
            .bit = bytes[1] * (bytes[7] & 0x80 ? 1000u : 1u),
            .bits = bytes[2] % 34,
            .is_signed = bytes[3] & 1,
            .centred = bytes[3] & 2,
            .mode = (enum hid_map_mode)((bytes[3] >> 2) % 3),
            .min = (int8_t)bytes[4],
            .max = bytes[5],
            .usage = HID_USAGE(bytes[6] & 1 ? HID_PAGE_DESKTOP : HID_PAGE_BUTTON, 1 + (bytes[7] & 0x7fu)),
        };
    }
    return count;
}

static void check_lamps(const struct hid_descriptor *descriptor, struct input *input)
{
    uint8_t report[HID_REPORT_BYTES];
    struct hid_outputs *outputs = hid_outputs_create(descriptor);
    if (!outputs) {
        return;
    }
    for (int i = 0; i < 8; i++) {
        uint32_t usage = HID_USAGE(HID_PAGE_LED, byte(input));
        float level = (float)byte(input) / 200;
        bool set = i & 1 ? hid_outputs_set(outputs, usage, byte(input) & 3, level)
                         : hid_outputs_set_bits(outputs, byte(input), byte(input) * 3u, byte(input) % 34, 0, level);
        size_t size = hid_outputs_take(outputs, report, sizeof report);
        require(set || size == 0);
        require(hid_outputs_take(outputs, report, sizeof report) == 0);
    }
    hid_outputs_destroy(outputs);
}

static void run(struct hid_decoder *decoder, struct input *input)
{
    int64_t down = 0;
    while (input->left > 0) {
        size_t length = byte(input);
        length = length < input->left ? length : input->left;
        uint8_t *report = malloc(length + 1); /* of its own size: a byte too far is seen */
        require(report != NULL);
        uint8_t *exact = realloc(report, length > 0 ? length : 1);
        report = exact ? exact : report;
        memcpy(report, input->at, length);
        hid_decoder_decode(decoder, report, length, check, &down);
        free(report);
        input->at += length;
        input->left -= length;
    }
    hid_decoder_release(decoder, check, &down);
    require(down == 0);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    struct input input = {data, size};
    struct hid_map_entry map[16];
    struct hid_error error;
    struct hid_descriptor *descriptor = NULL;
    int choices = byte(&input);
    int count = take_map(&input, choices >> ENTRIES_SHIFT, map);
    if (!(choices & NO_DESCRIPTOR)) {
        size_t length = byte(&input);
        length = length < input.left ? length : input.left;
        descriptor = hid_descriptor_create(input.at, length, &error);
        input.at += length;
        input.left -= length;
        if (!descriptor) {
            return -1; /* no use to keep */
        }
        check_lamps(descriptor, &input);
    }
    const struct hid_decoder_def def = {.descriptor = descriptor,
                                        .map = map,
                                        .map_count = count,
                                        .everything = choices & EVERYTHING,
                                        .vendor = choices & VENDOR};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    hid_descriptor_destroy(descriptor);
    require(decoder != NULL);
    run(decoder, &input);
    hid_decoder_destroy(decoder);
    return 0;
}
