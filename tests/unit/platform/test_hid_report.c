/* Raw reports of real controllers into values, and lamps into output reports. */
#include <setjmp.h>
#include <stdarg.h>
#include <stddef.h>
#include <stdint.h>

#include <cmocka.h>

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "hid_report.h"
#include "hid_samples.h"
#include "hid_usage.h"

struct heard { /* what a report said */
    struct hid_value values[64];
    int count;
};

static void hear(void *user, const struct hid_value *value)
{
    struct heard *heard = user;
    assert_true(heard->count < 64);
    heard->values[heard->count++] = *value;
}

static struct hid_decoder *decoder_for(const char *name, bool everything)
{
    const struct hid_sample *sample = hid_sample(name);
    struct hid_error error;
    struct hid_descriptor *descriptor = hid_descriptor_create(sample->bytes, sample->size, &error);
    assert_non_null(descriptor);
    const struct hid_decoder_def def = {.descriptor = descriptor, .everything = everything};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    assert_non_null(decoder);
    hid_descriptor_destroy(descriptor);
    return decoder;
}

static struct heard decode(struct hid_decoder *decoder, const uint8_t *bytes, size_t size)
{
    struct heard heard = {.count = 0};
    hid_decoder_decode(decoder, bytes, size, hear, &heard);
    return heard;
}

#define DECODE(decoder, ...) decode(decoder, (const uint8_t[]){__VA_ARGS__}, sizeof((const uint8_t[]){__VA_ARGS__}))

static const struct hid_value *find(const struct heard *heard, uint32_t usage, int index)
{
    for (int i = 0; i < heard->count; i++) {
        if (heard->values[i].usage == usage && heard->values[i].index == index) {
            return &heard->values[i];
        }
    }
    return NULL;
}

static void assert_says(const struct heard *heard, const char *name, int index, float value)
{
    const struct hid_value *found = find(heard, hid_usage_of(name), index);
    if (!found || fabsf(found->value - value) > .0005f) {
        fail_msg("%s says %g, expected %g", name, found ? (double)found->value : NAN, (double)value);
    }
}

static void assert_silent(const struct heard *heard)
{
    if (heard->count != 0) {
        char name[HID_USAGE_NAME];
        fail_msg("%s says %g", hid_usage_name(heard->values[0].usage, name, sizeof name),
                 (double)heard->values[0].value);
    }
}

static void test_gamepad(void **state)
{
    (void)state;
    struct hid_decoder *decoder = decoder_for("dualshock", false);
    uint8_t rest[64] = {1, 128, 127, 128, 128, 0x08, 0, 0, 0, 0};
    struct heard heard = decode(decoder, rest, sizeof rest);
    assert_says(&heard, "X", 0, 0);
    assert_says(&heard, "Y", 0, 0); /* 127 and 128 are both the middle */
    assert_says(&heard, "Rx", 0, 0);
    assert_true(find(&heard, hid_usage_of("Z"), 0)->centred);
    assert_false(find(&heard, hid_usage_of("Rx"), 0)->centred); /* a trigger */
    assert_int_equal(heard.count, 6);                           /* no hat, no button, nothing of the vendor's */
    heard = decode(decoder, rest, sizeof rest);
    assert_silent(&heard);

    uint8_t played[64] = {1, 0, 255, 192, 128, 0x22, 0x80, 0x01, 255, 51};
    heard = decode(decoder, played, sizeof played);
    assert_says(&heard, "X", 0, -1);
    assert_says(&heard, "Y", 0, 1);
    assert_says(&heard, "Z", 0, .5039f);
    assert_says(&heard, "Rx", 0, 1);
    assert_says(&heard, "Ry", 0, .2f);
    assert_says(&heard, "Hat switch", 0, .25f);
    assert_says(&heard, "Button 2", 0, 1); /* byte 5, bit 5 */
    assert_says(&heard, "Button 12", 0, 1);
    assert_says(&heard, "Button 13", 0, 1);
    assert_int_equal(heard.count, 9);

    heard.count = 0;
    hid_decoder_release(decoder, hear, &heard);
    assert_says(&heard, "Button 2", 0, 0);
    assert_says(&heard, "Button 12", 0, 0);
    assert_says(&heard, "Button 13", 0, 0);
    assert_says(&heard, "X", 0, 0);
    assert_says(&heard, "Rx", 0, 0);
    assert_true(find(&heard, hid_usage_of("Hat switch"), 0)->null);
    assert_int_equal(heard.count, 9);
    heard.count = 0;
    hid_decoder_release(decoder, hear, &heard);
    assert_silent(&heard);
    hid_decoder_destroy(decoder);
}

static void test_xbox(void **state)
{
    (void)state;
    struct hid_decoder *decoder = decoder_for("xbox_one_s", false);
    /* X 0, Y 65535, Z and Rz in the middle; brake 1023, accelerator 512; hat 8 = up-left; button 15, AC back */
    struct heard heard = DECODE(decoder, 1, 0, 0, 0xff, 0xff, 0xff, 0x7f, 0, 0x80, 0xff, 3, 0, 2, 8, 0, 0x40, 1);
    assert_says(&heard, "X", 0, -1);
    assert_says(&heard, "Y", 0, 1);
    assert_says(&heard, "Z", 0, 0);
    assert_says(&heard, "Simulation: Brake", 0, 1);
    assert_says(&heard, "Simulation: Accelerator", 0, .5005f);
    assert_says(&heard, "Hat switch", 0, .875f);
    assert_says(&heard, "Button 15", 0, 1);
    assert_says(&heard, "Consumer: Back", 0, 1);
    heard = DECODE(decoder, 2, 1); /* another report: the guide button */
    assert_says(&heard, "Consumer: Home", 0, 1);
    heard = DECODE(decoder, 4, 77); /* the battery is no control */
    assert_silent(&heard);
    heard = DECODE(decoder, 1, 0, 0, 0xff, 0xff, 0xff, 0x7f, 0, 0x80, 0xff, 3, 0, 2, 0, 0, 0, 0);
    assert_true(find(&heard, hid_usage_of("Hat switch"), 0)->null);
    assert_says(&heard, "Button 15", 0, 0);
    assert_says(&heard, "Consumer: Back", 0, 0);
    assert_int_equal(heard.count, 3);
    hid_decoder_destroy(decoder);
}

static void test_hats(void **state)
{
    (void)state;
    struct hid_decoder *four = decoder_for("joystick", false), *eight = decoder_for("tiny_gamepad", false);
    for (int i = 0; i < 4; i++) {
        struct heard heard = DECODE(four, 0, 0, 0, (uint8_t)i);
        assert_says(&heard, "Hat switch", 0, (float)i / 4);
    }
    struct heard heard = DECODE(four, 0, 0, 0, 15);
    assert_true(find(&heard, hid_usage_of("Hat switch"), 0)->null);
    for (int i = 0; i < 8; i++) { /* no null state is declared, and 0 lies outside: it means nothing all the same */
        heard = DECODE(eight, 0, 0, 0, 0, 0, 0, (uint8_t)(i + 1), 0, 0, 0, 0);
        assert_says(&heard, "Hat switch", 0, (float)i / 8);
    }
    heard = DECODE(eight, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0, 0);
    assert_true(find(&heard, hid_usage_of("Hat switch"), 0)->null);
    hid_decoder_destroy(four);
    hid_decoder_destroy(eight);
}

static void test_odd_sizes(void **state)
{
    (void)state;
    struct hid_decoder *stick = decoder_for("extreme_3d", false);
    /* X 1023 and Y 0 in ten bits each, hat 6, Rz 255, buttons 1 and 8, slider 51, buttons 9 and 12 */
    struct heard heard = DECODE(stick, 0xff, 0x03, 0x60, 0xff, 0x81, 51, 0x09);
    assert_says(&heard, "X", 0, 1);
    assert_says(&heard, "Y", 0, -1);
    assert_says(&heard, "Hat switch", 0, .75f);
    assert_says(&heard, "Rz", 0, 1);
    assert_says(&heard, "Slider", 0, .2f);
    assert_false(find(&heard, hid_usage_of("Slider"), 0)->centred);
    assert_says(&heard, "Button 1", 0, 1);
    assert_says(&heard, "Button 8", 0, 1);
    assert_says(&heard, "Button 9", 0, 1);
    assert_says(&heard, "Button 12", 0, 1);
    assert_int_equal(heard.count, 9);
    hid_decoder_destroy(stick);

    struct hid_decoder *mouse = decoder_for("receiver_mouse", true);
    heard = DECODE(mouse, 2, 0x01, 0x80, 0xff, 0x1f, 0x80, 1, 0xff); /* X -1, Y -2047 + 0 = 0x801 of twelve bits */
    assert_says(&heard, "X", 0, -1);
    assert_says(&heard, "Y", 0, -2047);
    assert_says(&heard, "Wheel", 0, 1);
    assert_says(&heard, "Consumer: Pan", 0, -1);
    assert_says(&heard, "Button 16", 0, 1);
    hid_decoder_destroy(mouse);
}

static void test_space_mouse(void **state)
{
    (void)state;
    struct hid_decoder *decoder = decoder_for("space_mouse", false);
    struct heard heard = DECODE(decoder, 1, 0x5e, 0x01, 0xa2, 0xfe, 0xaf, 0x00);
    assert_says(&heard, "X", 0, 1);
    assert_says(&heard, "Y", 0, -1);
    assert_says(&heard, "Z", 0, .5f);
    assert_int_equal(find(&heard, hid_usage_of("X"), 0)->kind, HID_AXIS); /* though it says "relative" */
    assert_true(find(&heard, hid_usage_of("X"), 0)->centred);
    heard = DECODE(decoder, 2, 0x5e, 0x01, 0, 0, 0, 0);
    assert_says(&heard, "Rx", 0, 1);
    heard = DECODE(decoder, 3, 2, 0);
    assert_says(&heard, "Button 2", 0, 1);
    heard = DECODE(decoder, 1, 0, 0, 0, 0, 0, 0);
    assert_says(&heard, "X", 0, 0);
    assert_int_equal(heard.count, 3);
    hid_decoder_destroy(decoder);
}

static void test_dials_and_knobs(void **state)
{
    (void)state;
    struct hid_decoder *dial = decoder_for("dial", false);
    struct heard heard = DECODE(dial, 1, 0x15, 0x00, 0, 0, 0, 0, 0, 0); /* button, and 10 tenths of a degree */
    assert_says(&heard, "Button 1", 0, 1);
    assert_says(&heard, "Dial", 0, 10);
    assert_int_equal(find(&heard, hid_usage_of("Dial"), 0)->kind, HID_STEPS);
    heard = DECODE(dial, 1, 0xed, 0xff, 0, 0, 0, 0, 0, 0);
    assert_says(&heard, "Dial", 0, -10);
    assert_int_equal(heard.count, 1);
    heard = DECODE(dial, 1, 0x01, 0x00, 0, 0, 0, 0, 0, 0); /* no step, no word */
    assert_silent(&heard);
    hid_decoder_destroy(dial);

    struct hid_decoder *knob = decoder_for("knob", false);
    for (int i = 0; i < 3; i++) { /* one-shot bits: each report is a step */
        heard = DECODE(knob, 1);
        assert_says(&heard, "Consumer: Volume increment", 0, 1);
    }
    heard = DECODE(knob, 4);
    assert_says(&heard, "Consumer: Mute", 0, 1);
    heard = DECODE(knob, 0);
    assert_says(&heard, "Consumer: Mute", 0, 0);
    assert_int_equal(heard.count, 1);
    hid_decoder_destroy(knob);
}

static void test_arrays(void **state)
{
    (void)state;
    struct hid_decoder *consumer = decoder_for("consumer", false);
    struct heard heard = DECODE(consumer, 3, 0xea, 0, 0, 0); /* the logical minimum is 1, the first usage too */
    assert_says(&heard, "Consumer: Volume decrement", 0, 1);
    heard = DECODE(consumer, 3, 0xe2, 0, 0xea, 0); /* moved to the second place: still down */
    assert_says(&heard, "Consumer: Mute", 0, 1);
    assert_int_equal(heard.count, 1);
    heard = DECODE(consumer, 3, 0, 0, 0xcd, 0);
    assert_int_equal(heard.count, 3);
    assert_true(heard.values[0].value == 0 && heard.values[1].value == 0); /* releases first */
    assert_says(&heard, "Consumer: Play/pause", 0, 1);
    heard = DECODE(consumer, 3, 0xff, 0xff, 0xcd, 0); /* out of range: nothing */
    assert_silent(&heard);
    heard.count = 0;
    hid_decoder_release(consumer, hear, &heard);
    assert_says(&heard, "Consumer: Play/pause", 0, 0);
    assert_int_equal(heard.count, 1);
    hid_decoder_destroy(consumer);

    struct hid_decoder *keyboard = decoder_for("keyboard", true);
    heard = DECODE(keyboard, 2, 0, 4, 5, 0, 0, 0, 0);
    assert_says(&heard, "Keyboard: Left shift", 0, 1);
    assert_says(&heard, "Keyboard: A", 0, 1);
    assert_says(&heard, "Keyboard: B", 0, 1);
    heard = DECODE(keyboard, 2, 0, 1, 1, 1, 1, 1, 1); /* roll-over: what is down stays down */
    assert_silent(&heard);
    heard = DECODE(keyboard, 0, 0, 5, 0, 0, 0, 0, 0);
    assert_says(&heard, "Keyboard: A", 0, 0);
    assert_says(&heard, "Keyboard: Left shift", 0, 0);
    assert_int_equal(heard.count, 2);
    hid_decoder_destroy(keyboard);

    keyboard = decoder_for("keyboard", false); /* nobody admitted it */
    heard = DECODE(keyboard, 2, 0, 4, 5, 0, 0, 0, 0);
    assert_silent(&heard);
    hid_decoder_destroy(keyboard);
}

static void test_repeated_usages(void **state)
{
    (void)state;
    struct hid_decoder *arcade = decoder_for("arcade", false);
    struct heard heard = DECODE(arcade, 127, 127, 0, 255, 127, 0x1f, 0x80, 0);
    assert_says(&heard, "Z", 0, -1);
    assert_says(&heard, "Z", 1, 1);
    assert_says(&heard, "Button 1", 0, 1);
    assert_says(&heard, "Button 12", 0, 1);
    assert_null(find(&heard, hid_usage_of("Hat switch"), 0)); /* 15 of 0..7: nowhere */
    hid_decoder_destroy(arcade);
    struct hid_decoder *pedals = decoder_for("rudder", false);
    heard = DECODE(pedals, 0xff, 0xff, 0xff, 0x03, 0x08);
    assert_says(&heard, "Simulation: Rudder", 0, 1);
    assert_says(&heard, "Simulation: Toe brake", 0, 1);
    assert_says(&heard, "Simulation: Toe brake", 1, .5005f);
    hid_decoder_destroy(pedals);
}

/* Short ones leave what they do not reach; long ones are read as far as is known; strange ones say nothing. */
static void test_wrong_lengths(void **state)
{
    (void)state;
    struct hid_decoder *decoder = decoder_for("xbox_one_s", false);
    struct heard heard = DECODE(decoder, 1, 0, 0, 0xff, 0xff, 0xff);
    assert_says(&heard, "X", 0, -1);
    assert_says(&heard, "Y", 0, 1);
    assert_int_equal(heard.count, 2); /* half of Z is no Z */
    heard = DECODE(decoder, 1);
    assert_silent(&heard);
    assert_false(hid_decoder_decode(decoder, (const uint8_t[]){1}, 0, hear, &heard));
    assert_false(hid_decoder_decode(decoder, (const uint8_t[]){99, 1, 2, 3}, 4, hear, &heard));
    assert_silent(&heard);
    struct hid_decoder *stick = decoder_for("extreme_3d", false);
    heard = DECODE(stick, 0xff); /* eight bits of ten */
    assert_silent(&heard);
    hid_decoder_destroy(stick);
    uint8_t large[2 * HID_REPORT_BYTES] = {2, 1};
    heard = decode(decoder, large, sizeof large);
    assert_says(&heard, "Consumer: Home", 0, 1);
    assert_int_equal(heard.count, 1);
    hid_decoder_destroy(decoder);
}

static void test_map(void **state)
{
    (void)state;
    static const struct hid_map_entry map[] = {
        {.bit = 0, .bits = 8, .usage = 0x10030, .min = 20, .max = 220},
        {.bit = 8, .bits = 12, .is_signed = true, .centred = true, .usage = 0x10031},
        {.bit = 20, .bits = 1, .usage = 0x90001},
        {.bit = 21, .bits = 1, .usage = 0x90002, .min = 1, .max = 0}, /* closed when it says 0 */
        {.bit = 24, .bits = 8, .mode = HID_MAP_COUNTER, .usage = 0x10037},
        {.bit = 32, .bits = 8, .is_signed = true, .mode = HID_MAP_RELATIVE, .usage = 0x10038},
        {.bit = 40, .bits = 4, .min = 1, .max = 8, .usage = 0x10039},
        {.bit = 48, .bits = 8, .min = 255, .max = 0, .usage = 0x10036}, /* turned */
        {.bit = 7, .bits = 33, .usage = 0x10032},                       /* no such thing */
    };
    const struct hid_decoder_def def = {.map = map, .map_count = sizeof map / sizeof *map};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    const struct hid_control *controls;
    assert_int_equal(hid_decoder_controls(decoder, &controls), 8);
    assert_int_equal(controls[2].kind, HID_BUTTON);
    struct heard heard = DECODE(decoder, 120, 0xff, 0x37, 250, 0xfe, 3, 51);
    assert_says(&heard, "X", 0, .5f);
    assert_says(&heard, "Y", 0, 1); /* 0x7ff of twelve bits */
    assert_says(&heard, "Button 1", 0, 1);
    assert_null(find(&heard, 0x90002, 0)); /* open */
    assert_null(find(&heard, 0x10037, 0)); /* where the counter starts is no step */
    assert_says(&heard, "Wheel", 0, -2);
    assert_says(&heard, "Hat switch", 0, .25f);
    assert_says(&heard, "Slider", 0, .8f);
    heard = DECODE(decoder, 255, 0x00, 0x08, 4, 0, 0, 51);
    assert_says(&heard, "X", 0, 1); /* beyond its range */
    assert_says(&heard, "Y", 0, -1);
    assert_says(&heard, "Dial", 0, 10); /* from 250 over 255 to 4 */
    assert_says(&heard, "Button 2", 0, 1);
    heard = DECODE(decoder, 255, 0x00, 0x08, 254, 0, 0, 51);
    assert_says(&heard, "Dial", 0, -6);
    assert_int_equal(heard.count, 1);
    hid_decoder_destroy(decoder);
}

static void test_vendor(void **state)
{
    (void)state;
    const struct hid_sample *sample = hid_sample("vendor");
    struct hid_error error;
    struct hid_descriptor *descriptor = hid_descriptor_create(sample->bytes, sample->size, &error);
    struct hid_decoder_def def = {.descriptor = descriptor};
    struct hid_decoder *decoder = hid_decoder_create(&def);
    struct heard heard = DECODE(decoder, 1, 2, 3, 4, 5, 6, 7, 8);
    assert_silent(&heard);
    hid_decoder_destroy(decoder);
    def.vendor = true; /* a technician looks at it */
    decoder = hid_decoder_create(&def);
    heard = DECODE(decoder, 255, 0, 0, 0, 0, 0, 0, 51);
    assert_int_equal(heard.count, 8);
    assert_says(&heard, "page 0xff00 usage 0x0002", 0, 1);
    assert_says(&heard, "page 0xff00 usage 0x0002", 7, .2f);
    hid_decoder_destroy(decoder);
    hid_descriptor_destroy(descriptor);
}

static struct hid_outputs *outputs_for(const char *name)
{
    const struct hid_sample *sample = hid_sample(name);
    struct hid_error error;
    struct hid_descriptor *descriptor = hid_descriptor_create(sample->bytes, sample->size, &error);
    struct hid_outputs *outputs = hid_outputs_create(descriptor);
    hid_descriptor_destroy(descriptor);
    return outputs;
}

static void test_lamps(void **state)
{
    (void)state;
    uint8_t bytes[64];
    struct hid_outputs *leds = outputs_for("keyboard");
    assert_true(hid_outputs_set(leds, hid_usage_of("LED: Caps lock"), 0, 1));
    assert_true(hid_outputs_set(leds, hid_usage_of("LED: Kana"), 0, .5f));
    assert_true(hid_outputs_set(leds, hid_usage_of("LED: Num lock"), 0, .49f));
    assert_false(hid_outputs_set(leds, hid_usage_of("LED: Play"), 0, 1));
    assert_false(hid_outputs_set(leds, hid_usage_of("LED: Kana"), 1, 1));
    assert_int_equal(hid_outputs_take(leds, bytes, sizeof bytes), 2);
    assert_memory_equal(bytes, ((uint8_t[]){0, 0x12}), 2);
    assert_int_equal(hid_outputs_take(leds, bytes, sizeof bytes), 0);
    assert_true(hid_outputs_set(leds, hid_usage_of("LED: Kana"), 0, 1)); /* it is on already */
    assert_int_equal(hid_outputs_take(leds, bytes, sizeof bytes), 0);
    hid_outputs_destroy(leds);

    struct hid_outputs *mouse = outputs_for("space_mouse");
    assert_true(hid_outputs_set(mouse, hid_usage_of("LED: Generic indicator"), 0, 1));
    assert_int_equal(hid_outputs_take(mouse, bytes, sizeof bytes), 2);
    assert_memory_equal(bytes, ((uint8_t[]){4, 1}), 2);
    hid_outputs_destroy(mouse);

    struct hid_outputs *board = outputs_for("vendor");
    assert_true(hid_outputs_set_bits(board, 0, 12, 8, 0, .5f));
    assert_true(hid_outputs_set_bits(board, 0, 56, 8, 100, 2));
    assert_false(hid_outputs_set_bits(board, 0, 57, 8, 0, 1)); /* over the end */
    assert_false(hid_outputs_set_bits(board, 1, 0, 8, 0, 1));
    assert_true(hid_outputs_set(board, 0xff000003, 5, 1));  /* its sixth byte */
    assert_int_equal(hid_outputs_take(board, bytes, 8), 0); /* does not fit */
    assert_int_equal(hid_outputs_take(board, bytes, sizeof bytes), 9);
    assert_memory_equal(bytes, ((uint8_t[]){0, 0, 0x00, 0x08, 0, 0, 255, 0, 100}), 9);
    hid_outputs_destroy(board);
    assert_null(outputs_for("mouse"));
}

static void test_bits(void **state)
{
    (void)state;
    uint8_t data[12] = {0};
    for (uint32_t bit = 0; bit < 60; bit++) {
        for (uint32_t bits = 1; bits <= 32; bits++) {
            uint32_t value = 0x9e3779b1u * (bit + 64 * bits), mask = (uint32_t)((UINT64_C(1) << bits) - 1);
            memset(data, bit & 1 ? 0xff : 0, sizeof data);
            hid_set_bits(data, bit, bits, value);
            int64_t plain = hid_bits(data, bit, bits, false), with_sign = hid_bits(data, bit, bits, true);
            assert_int_equal(plain, value & mask);
            assert_int_equal(with_sign & mask, value & mask);
            assert_true(with_sign < INT64_C(1) << (bits - 1) && with_sign >= -(INT64_C(1) << (bits - 1)));
            assert_int_equal(hid_bits(data, bit + bits, 1, false), bit & 1); /* nothing beside it */
        }
    }
}

int main(void)
{
    const struct CMUnitTest tests[] = {
        cmocka_unit_test(test_gamepad),       cmocka_unit_test(test_xbox),
        cmocka_unit_test(test_hats),          cmocka_unit_test(test_odd_sizes),
        cmocka_unit_test(test_space_mouse),   cmocka_unit_test(test_dials_and_knobs),
        cmocka_unit_test(test_arrays),        cmocka_unit_test(test_repeated_usages),
        cmocka_unit_test(test_wrong_lengths), cmocka_unit_test(test_map),
        cmocka_unit_test(test_vendor),        cmocka_unit_test(test_lamps),
        cmocka_unit_test(test_bits),
    };
    return cmocka_run_group_tests(tests, NULL, NULL);
}
