#include "hid_report.h"

#include <stdlib.h>
#include <string.h>

#include "hid_class.h"
#include "hid_decoder.h"
#include "hid_usage.h"

int64_t hid_bits(const uint8_t *data, uint32_t bit, uint32_t bits, bool is_signed)
{
    uint64_t value = 0;
    uint32_t first = bit / 8, shift = bit % 8, bytes = (shift + bits + 7) / 8;
    for (uint32_t i = 0; i < bytes; i++) {
        value |= (uint64_t)data[first + i] << (8 * i);
    }
    value = value >> shift & ((UINT64_C(1) << bits) - 1);
    if (is_signed && value >> (bits - 1)) {
        return (int64_t)value - (INT64_C(1) << bits);
    }
    return (int64_t)value;
}

void hid_set_bits(uint8_t *data, uint32_t bit, uint32_t bits, uint32_t value)
{
    for (uint32_t i = 0; i < bits; i++) {
        uint8_t mask = (uint8_t)(1u << ((bit + i) % 8));
        uint8_t *byte = &data[(bit + i) / 8];
        *byte = (uint8_t)(value >> i & 1 ? *byte | mask : *byte & ~mask);
    }
}

/* The number of turns clockwise from up. A hat says in degrees what its positions are; some say nothing, and count
 * them clockwise from up. */
static float hat_turns(const struct hid_slot *slot, int64_t value)
{
    double along = (double)(value - slot->control.min);
    double turns = slot->turns_first + along * slot->turns_step;
    turns -= (double)(int64_t)turns;
    return (float)(turns < 0 ? turns + 1 : turns);
}

static float axis_value(const struct hid_control *control, int64_t value)
{
    int64_t low = control->min, high = control->max, clamped = value;
    bool turned = low > high;
    if (turned) {
        low = control->max;
        high = control->min;
    }
    clamped = clamped < low ? low : clamped > high ? high : clamped;
    double answer;
    if (control->centred) { /* of an even number of values the two in the middle are both 0 */
        int64_t sum = low + high;
        int64_t below = sum >= 0 ? sum / 2 : -((1 - sum) / 2), above = sum - below;
        answer = clamped < below   ? (double)(clamped - below) / (double)(below - low)
                 : clamped > above ? (double)(clamped - above) / (double)(high - above)
                                   : 0;
        answer = turned ? -answer : answer;
    } else {
        answer = (double)(clamped - low) / (double)(high - low);
        answer = turned ? 1 - answer : answer;
    }
    return (float)answer;
}

static void say(const struct hid_slot *slot, bool null, float value, hid_emit *emit, void *user)
{
    const struct hid_control *control = &slot->control;
    const struct hid_value said = {.usage = control->usage,
                                   .index = control->index,
                                   .kind = control->kind,
                                   .centred = control->centred,
                                   .null = null,
                                   .value = value};
    emit(user, &said);
}

static void decode_steps(struct hid_slot *slot, int64_t value, hid_emit *emit, void *user)
{
    int64_t steps = value;
    if (slot->counter) {
        int64_t span = INT64_C(1) << slot->control.bits;
        steps = slot->seen ? value - slot->last : 0;
        steps = steps >= span / 2 ? steps - span : steps < -span / 2 ? steps + span : steps;
        slot->last = value;
    }
    slot->seen = true;
    if (steps != 0) {
        say(slot, false, (float)(slot->control.min > slot->control.max ? -steps : steps), emit, user);
    }
}

static void decode_variable(struct hid_slot *slot, const uint8_t *data, hid_emit *emit, void *user)
{
    const struct hid_control *control = &slot->control;
    int64_t value = hid_bits(data, control->bit, control->bits, control->is_signed);
    int64_t low = control->min < control->max ? control->min : control->max;
    int64_t high = control->min < control->max ? control->max : control->min;
    bool outside = value < low || value > high;
    if (control->kind == HID_STEPS) {
        if (!outside || slot->counter) {
            decode_steps(slot, value, emit, user);
        }
        return;
    }
    if (outside && control->kind != HID_HAT && slot->null_state) {
        return; /* "not now" */
    }
    bool first = !slot->seen;
    if (!first && value == slot->last) {
        return;
    }
    slot->seen = true;
    slot->last = value;
    if (control->kind == HID_BUTTON) {
        bool down = control->min < control->max ? value > control->min : value < control->min;
        if (down != slot->down) {
            slot->down = down;
            say(slot, false, down ? 1 : 0, emit, user);
        }
    } else if (control->kind == HID_HAT) {
        if (slot->down || !outside) {
            say(slot, outside, outside ? 0 : hat_turns(slot, value), emit, user);
        }
        slot->down = !outside;
    } else {
        float now = axis_value(control, value);
        if (first || now != slot->value) {
            slot->value = now;
            say(slot, false, now, emit, user);
        }
    }
}

static bool holds(const uint32_t *usages, int count, uint32_t usage)
{
    for (int i = 0; i < count; i++) {
        if (usages[i] == usage) {
            return true;
        }
    }
    return false;
}

static void say_member(const struct hid_slot *slot, uint32_t usage, float value, hid_emit *emit, void *user)
{
    const struct hid_value said = {.usage = usage, .index = slot->control.index, .kind = HID_BUTTON, .value = value};
    emit(user, &said);
}

static uint32_t member(const struct hid_decoder *decoder, const struct hid_slot *slot, int64_t value)
{
    const struct hid_control *control = &slot->control;
    if (value < control->min || value > control->max) {
        return 0;
    }
    uint64_t left = (uint64_t)(value - control->min);
    for (int i = 0; i < slot->range_count; i++) {
        const struct hid_usages *range = &decoder->ranges[slot->range + i];
        uint64_t length = range->last - range->first + 1;
        if (left < length) {
            uint32_t usage = range->first + (uint32_t)left;
            return usage & 0xffffu ? usage : 0;
        }
        left -= length;
    }
    return 0;
}

/* Of an array each element holds the number of a usage that is on (6.2.2.5). */
static void decode_array(struct hid_decoder *decoder, struct hid_slot *slot, const uint8_t *data, hid_emit *emit,
                         void *user)
{
    const struct hid_control *control = &slot->control;
    uint32_t *pressed = decoder->pressed + (size_t)slot->pressed * HID_PRESSED_MAX;
    uint32_t now[HID_PRESSED_MAX];
    int count = 0;
    for (uint32_t i = 0; i < control->count; i++) {
        int64_t value = hid_bits(data, control->bit + i * control->bits, control->bits, control->is_signed);
        uint32_t usage = member(decoder, slot, value);
        if (usage >= HID_USAGE(HID_PAGE_KEYBOARD, 1) && usage <= HID_USAGE(HID_PAGE_KEYBOARD, 3)) {
            return; /* too many keys to tell which: what was down stays down */
        }
        if (usage && !holds(now, count, usage)) {
            now[count++] = usage;
        }
    }
    for (int i = 0; i < slot->pressed_count; i++) {
        if (!holds(now, count, pressed[i])) {
            say_member(slot, pressed[i], 0, emit, user);
        }
    }
    for (int i = 0; i < count; i++) {
        if (!holds(pressed, slot->pressed_count, now[i])) {
            say_member(slot, now[i], 1, emit, user);
        }
    }
    memcpy(pressed, now, (size_t)count * sizeof *now);
    slot->pressed_count = count;
}

bool hid_decoder_decode(struct hid_decoder *decoder, const uint8_t *bytes, size_t size, hid_emit *emit, void *user)
{
    size_t head = decoder->numbered ? 1 : 0;
    if (size <= head) {
        return false;
    }
    uint8_t id = decoder->numbered ? bytes[0] : 0;
    size_t length = size - head < HID_REPORT_BYTES ? size - head : HID_REPORT_BYTES;
    uint64_t bits = 8 * (uint64_t)length;
    bool known = decoder->known[id];
    for (int i = 0; known && i < decoder->count; i++) {
        struct hid_slot *slot = &decoder->slots[i];
        const struct hid_control *control = &slot->control;
        if (control->report != id || control->bit + (uint64_t)control->bits * control->count > bits) {
            continue;
        }
        if (control->kind == HID_ARRAY) {
            decode_array(decoder, slot, bytes + head, emit, user);
        } else {
            decode_variable(slot, bytes + head, emit, user);
        }
    }
    return known;
}

void hid_decoder_release(struct hid_decoder *decoder, hid_emit *emit, void *user)
{
    for (int i = 0; i < decoder->count; i++) {
        struct hid_slot *slot = &decoder->slots[i];
        const struct hid_control *control = &slot->control;
        for (int p = 0; p < slot->pressed_count; p++) {
            say_member(slot, decoder->pressed[slot->pressed * HID_PRESSED_MAX + p], 0, emit, user);
        }
        if (slot->down) {
            say(slot, control->kind == HID_HAT, 0, emit, user);
        } else if (control->kind == HID_AXIS && !control->stays && slot->seen && slot->value != 0) {
            say(slot, false, 0, emit, user);
        }
        slot->pressed_count = 0;
        slot->down = slot->seen = false;
        slot->value = 0;
    }
}
