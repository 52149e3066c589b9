#include "hid_decoder.h"

#include <stdlib.h>
#include <string.h>

#include "hid_class.h"
#include "hid_usage.h"

#define DESKTOP(usage)    HID_USAGE(HID_PAGE_DESKTOP, usage)
#define SIMULATION(usage) HID_USAGE(HID_PAGE_SIMULATION, usage)

enum { X = 0x30, Y, Z, RX, RY, RZ, SLIDER, DIAL, WHEEL, HAT, VX = 0x40, VNO = 0x46 };

static bool page_is_heard(uint32_t page, bool vendor)
{
    switch (page) {
    case 0x01: /* Generic Desktop */
    case 0x02: /* Simulation */
    case 0x03: /* Virtual Reality */
    case 0x04: /* Sport */
    case 0x05: /* Game */
    case 0x07: /* Keyboard */
    case 0x09: /* Button */
    case 0x0a: /* Ordinal */
    case 0x0b: /* Telephony */
    case 0x0c: /* Consumer */
    case 0x0d: /* Digitizer */
    case 0x91: /* Arcade */
        return true;
    default: /* batteries, force feedback, sensors; what a vendor means by a byte nobody can say */
        return vendor && page >= HID_PAGE_VENDOR;
    }
}

static bool report_has(const struct hid_descriptor *descriptor, int report, uint32_t usage)
{
    for (int i = 0; i < descriptor->field_count; i++) {
        const struct hid_field *field = &descriptor->fields[i];
        for (int u = 0; field->report == report && u < field->usage_count; u++) {
            const struct hid_usages *usages = &descriptor->usages[field->usage + u];
            if (usages->first <= usage && usage <= usages->last) {
                return true;
            }
        }
    }
    return false;
}

/* Whether an axis rests in its middle. Its signs say so, or else custom: of gamepads, Z is with Rz the second stick,
 * and then Rx and Ry are triggers (DualShock); without the pair Rx and Ry are the second stick, and Z is a trigger. */
static bool rests_in_the_middle(const struct hid_descriptor *descriptor, const struct hid_field *field, uint32_t usage)
{
    if (field->flags & HID_NO_PREFERRED) {
        return false;
    }
    if (field->logical_min < 0 && field->logical_max > 0) {
        return true;
    }
    if (usage >> 16 == HID_PAGE_SIMULATION) {
        uint32_t number = usage & 0xffffu; /* aileron, elevator, rudder, steering */
        return number == 0xb0 || number == 0xb8 || number == 0xba || number == 0xc8;
    }
    bool pair = report_has(descriptor, field->report, DESKTOP(Z)) && report_has(descriptor, field->report, DESKTOP(RZ));
    switch (usage) {
    case DESKTOP(X):
    case DESKTOP(Y):
        return true;
    case DESKTOP(Z):
        return pair;
    case DESKTOP(RZ):
        return pair || !report_has(descriptor, field->report, DESKTOP(RX)); /* the twist of a joystick */
    case DESKTOP(RX):
    case DESKTOP(RY):
        return !pair;
    default:
        return usage >= DESKTOP(VX) && usage <= DESKTOP(VNO);
    }
}

static bool keeps_its_place(const struct hid_field *field, uint32_t usage)
{
    return field->flags & HID_NO_PREFERRED || usage == DESKTOP(SLIDER) || usage == DESKTOP(DIAL) ||
           usage == DESKTOP(WHEEL) || usage == SIMULATION(0xbb);
}

/* Space mice call their deflections relative, though a cap that is held still keeps saying the same. */
static bool is_deflection(const struct hid_descriptor *descriptor, const struct hid_field *field, uint32_t usage)
{
    return usage >= DESKTOP(X) && usage <= DESKTOP(RZ) &&
           hid_application(descriptor, field->collection) == DESKTOP(0x08);
}

static void set_hat(struct hid_slot *slot, const struct hid_field *field)
{
    enum { DEGREES = 0x14, RADIANS = 0x12 };
    int64_t positions = field->logical_max - field->logical_min + 1;
    double span = (double)(field->logical_max - field->logical_min);
    double physical = (double)(field->physical_max - field->physical_min);
    slot->turns_step = 1 / (double)positions;
    /* Degrees are only believed when they make sense: 0 to 315 in 8 positions. */
    if (field->unit == DEGREES && field->unit_exponent == 0 && span > 0 && physical > 0 && physical < 360) {
        slot->turns_first = (double)field->physical_min / 360;
        slot->turns_step = physical / span / 360;
    }
}

static int count_before(const struct hid_decoder *decoder, uint32_t first, uint32_t last)
{
    int count = 0;
    for (int i = 0; i < decoder->count; i++) {
        const struct hid_control *other = &decoder->slots[i].control;
        count += other->usage <= last && first <= other->usage_last;
    }
    return count;
}

static void add_element(struct hid_decoder *decoder, const struct hid_descriptor *descriptor,
                        const struct hid_field *field, uint32_t element)
{
    uint32_t usage = hid_field_usage(descriptor, field, element);
    bool relative = field->flags & HID_RELATIVE && !is_deflection(descriptor, field, usage);
    bool button = field->logical_max - field->logical_min == 1;
    if (decoder->count == HID_CONTROLS_MAX || !(usage & 0xffffu)) {
        return;
    }
    struct hid_slot *slot = &decoder->slots[decoder->count];
    *slot = (struct hid_slot){
        .control = {.usage = usage,
                    .usage_last = usage,
                    .index = count_before(decoder, usage, usage),
                    .report = descriptor->reports[field->report].id,
                    .bit = field->bit + element * field->bits,
                    .bits = field->bits,
                    .count = 1,
                    .min = field->logical_min,
                    .max = field->logical_max,
                    .is_signed = field->logical_min < 0},
        .null_state = field->flags & HID_NULL_STATE,
    };
    struct hid_control *control = &slot->control;
    if (relative) {
        control->kind = HID_STEPS;
    } else if (usage == DESKTOP(HAT)) {
        control->kind = HID_HAT;
        set_hat(slot, field);
    } else if (button) {
        control->kind = HID_BUTTON;
    } else {
        control->kind = HID_AXIS;
        control->centred = rests_in_the_middle(descriptor, field, usage);
        control->stays = keeps_its_place(field, usage);
    }
    decoder->count++;
}

static void add_array(struct hid_decoder *decoder, const struct hid_descriptor *descriptor,
                      const struct hid_field *field)
{
    const struct hid_usages *usages = &descriptor->usages[field->usage];
    uint32_t first = usages->first, last = usages->last;
    if (decoder->count == HID_CONTROLS_MAX) {
        return;
    }
    for (int i = 0; i < field->usage_count; i++) {
        first = usages[i].first < first ? usages[i].first : first;
        last = usages[i].last > last ? usages[i].last : last;
        decoder->ranges[decoder->range_count + i] = usages[i];
    }
    decoder->slots[decoder->count] = (struct hid_slot){
        .control = {.kind = HID_ARRAY,
                    .usage = first,
                    .usage_last = last,
                    .index = count_before(decoder, first, last),
                    .report = descriptor->reports[field->report].id,
                    .bit = field->bit,
                    .bits = field->bits,
                    .count = field->count < HID_PRESSED_MAX ? field->count : HID_PRESSED_MAX,
                    .min = field->logical_min,
                    .max = field->logical_max,
                    .is_signed = field->logical_min < 0},
        .range = decoder->range_count,
        .range_count = field->usage_count,
        .pressed = decoder->array_count++,
    };
    decoder->range_count += field->usage_count;
    decoder->count++;
}

static bool is_heard(const struct hid_decoder_def *def, const struct hid_field *field)
{
    const struct hid_descriptor *descriptor = def->descriptor;
    uint32_t application = hid_application(descriptor, field->collection);
    bool ours =
        def->everything || hid_is_controller(application) || (def->vendor && application >> 16 >= HID_PAGE_VENDOR);
    return ours && descriptor->reports[field->report].kind == HID_INPUT &&
           !(field->flags & (HID_CONSTANT | HID_BUFFERED)) && field->usage_count > 0 && field->bits <= 32 &&
           field->logical_min < field->logical_max &&
           page_is_heard(descriptor->usages[field->usage].first >> 16, def->vendor);
}

static void add_fields(struct hid_decoder *decoder, const struct hid_decoder_def *def)
{
    const struct hid_descriptor *descriptor = def->descriptor;
    decoder->numbered = descriptor->numbered;
    for (int i = 0; i < descriptor->report_count; i++) {
        const struct hid_report *report = &descriptor->reports[i];
        decoder->known[report->id] = decoder->known[report->id] || report->kind == HID_INPUT;
    }
    for (int i = 0; i < descriptor->field_count; i++) {
        const struct hid_field *field = &descriptor->fields[i];
        if (!is_heard(def, field)) {
            continue;
        }
        if (!(field->flags & HID_VARIABLE)) {
            add_array(decoder, descriptor, field);
            continue;
        }
        for (uint32_t e = 0; e < field->count && decoder->count < HID_CONTROLS_MAX; e++) {
            add_element(decoder, descriptor, field, e);
        }
    }
}

static void add_mapped(struct hid_decoder *decoder, const struct hid_map_entry *entry)
{
    bool fits = entry->bits >= 1 && entry->bits <= 32 && entry->bit <= 8 * HID_REPORT_BYTES;
    if (!fits || decoder->count == HID_CONTROLS_MAX) {
        return;
    }
    int64_t span = INT64_C(1) << entry->bits;
    bool whole = entry->min == 0 && entry->max == 0;
    struct hid_slot *slot = &decoder->slots[decoder->count];
    *slot = (struct hid_slot){
        .control = {.usage = entry->usage,
                    .usage_last = entry->usage,
                    .index = count_before(decoder, entry->usage, entry->usage),
                    .centred = entry->centred,
                    .mapped = true,
                    .report = entry->report,
                    .bit = entry->bit,
                    .bits = (uint32_t)entry->bits,
                    .count = 1,
                    .min = !whole             ? entry->min
                           : entry->is_signed ? -span / 2
                                              : 0,
                    .max = !whole             ? entry->max
                           : entry->is_signed ? span / 2 - 1
                                              : span - 1,
                    .is_signed = entry->is_signed},
        .counter = entry->mode == HID_MAP_COUNTER,
    };
    struct hid_control *control = &slot->control;
    int64_t range = control->max - control->min;
    if (range == 0) {
        return;
    }
    control->stays = !entry->centred;
    if (entry->mode != HID_MAP_ABSOLUTE) {
        control->kind = HID_STEPS;
    } else if (entry->usage == DESKTOP(HAT)) {
        control->kind = HID_HAT;
        slot->turns_step = 1 / (double)((range < 0 ? -range : range) + 1);
    } else {
        control->kind = range == 1 || range == -1 ? HID_BUTTON : HID_AXIS;
    }
    decoder->known[entry->report] = true;
    decoder->numbered = decoder->numbered || entry->report != 0;
    decoder->count++;
}

static bool keep(struct hid_decoder *decoder)
{
    size_t count = (size_t)decoder->count;
    struct hid_slot *fewer = realloc(decoder->slots, (count + 1) * sizeof *fewer);
    decoder->slots = fewer ? fewer : decoder->slots;
    decoder->controls = calloc(count + 1, sizeof *decoder->controls);
    decoder->pressed = calloc((size_t)(decoder->array_count + 1) * HID_PRESSED_MAX, sizeof *decoder->pressed);
    if (!decoder->controls || !decoder->pressed) {
        return false;
    }
    for (size_t i = 0; i < count; i++) {
        decoder->controls[i] = decoder->slots[i].control;
    }
    return true;
}

struct hid_decoder *hid_decoder_create(const struct hid_decoder_def *def)
{
    struct hid_decoder *decoder = calloc(1, sizeof *decoder);
    if (!decoder) {
        return NULL;
    }
    decoder->slots = calloc(HID_CONTROLS_MAX, sizeof *decoder->slots);
    decoder->ranges = calloc(HID_USAGES_MAX, sizeof *decoder->ranges);
    if (!decoder->slots || !decoder->ranges) {
        hid_decoder_destroy(decoder);
        return NULL;
    }
    for (int i = 0; i < def->map_count; i++) {
        add_mapped(decoder, &def->map[i]);
    }
    if (def->descriptor) {
        add_fields(decoder, def);
    }
    if (!keep(decoder)) {
        hid_decoder_destroy(decoder);
        return NULL;
    }
    return decoder;
}

void hid_decoder_destroy(struct hid_decoder *decoder)
{
    if (decoder) {
        free(decoder->slots);
        free(decoder->controls);
        free(decoder->ranges);
        free(decoder->pressed);
        free(decoder);
    }
}

int hid_decoder_controls(const struct hid_decoder *decoder, const struct hid_control **controls)
{
    *controls = decoder->controls;
    return decoder->count;
}
