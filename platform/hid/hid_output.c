#include <stdlib.h>
#include <string.h>

#include "hid_report.h"

struct output {
    uint8_t id;
    size_t size; /* of its data */
    uint8_t *data;
    bool changed;
};

struct lamp { /* an element of an output field */
    uint32_t usage;
    int index, output;
    uint32_t bit, bits;
    int64_t min, max;
};

struct hid_outputs {
    int output_count, lamp_count;
    struct output outputs[HID_REPORTS_MAX];
    struct lamp lamps[HID_CONTROLS_MAX];
};

static struct output *find(struct hid_outputs *outputs, uint8_t id)
{
    for (int i = 0; i < outputs->output_count; i++) {
        if (outputs->outputs[i].id == id) {
            return &outputs->outputs[i];
        }
    }
    return NULL;
}

static void add_lamps(struct hid_outputs *outputs, const struct hid_descriptor *descriptor,
                      const struct hid_field *field)
{
    const struct output *output = find(outputs, descriptor->reports[field->report].id);
    bool usable = output && field->flags & HID_VARIABLE && !(field->flags & HID_CONSTANT) && field->bits <= 32 &&
                  field->logical_min < field->logical_max && field->usage_count > 0;
    for (uint32_t e = 0; usable && e < field->count && outputs->lamp_count < HID_CONTROLS_MAX; e++) {
        uint32_t usage = hid_field_usage(descriptor, field, e);
        int index = 0;
        for (int i = 0; i < outputs->lamp_count; i++) {
            index += outputs->lamps[i].usage == usage;
        }
        outputs->lamps[outputs->lamp_count++] = (struct lamp){.usage = usage,
                                                              .index = index,
                                                              .output = (int)(output - outputs->outputs),
                                                              .bit = field->bit + e * field->bits,
                                                              .bits = field->bits,
                                                              .min = field->logical_min,
                                                              .max = field->logical_max};
    }
}

struct hid_outputs *hid_outputs_create(const struct hid_descriptor *descriptor)
{
    struct hid_outputs *outputs = calloc(1, sizeof *outputs);
    for (int i = 0; outputs && i < descriptor->report_count; i++) {
        const struct hid_report *report = &descriptor->reports[i];
        size_t size = ((size_t)report->bits + 7) / 8;
        if (report->kind != HID_OUTPUT || size == 0 || size >= HID_REPORT_BYTES) {
            continue;
        }
        struct output *output = &outputs->outputs[outputs->output_count];
        *output = (struct output){.id = report->id, .size = size, .data = calloc(1, size)};
        if (!output->data) {
            hid_outputs_destroy(outputs);
            return NULL;
        }
        outputs->output_count++;
    }
    if (outputs && outputs->output_count == 0) {
        free(outputs);
        return NULL;
    }
    for (int i = 0; outputs && i < descriptor->field_count; i++) {
        if (descriptor->reports[descriptor->fields[i].report].kind == HID_OUTPUT) {
            add_lamps(outputs, descriptor, &descriptor->fields[i]);
        }
    }
    return outputs;
}

void hid_outputs_destroy(struct hid_outputs *outputs)
{
    if (outputs) {
        for (int i = 0; i < outputs->output_count; i++) {
            free(outputs->outputs[i].data);
        }
        free(outputs);
    }
}

static void set(struct output *output, uint32_t bit, uint32_t bits, uint32_t value)
{
    uint32_t mask = (uint32_t)((UINT64_C(1) << bits) - 1);
    if ((uint32_t)hid_bits(output->data, bit, bits, false) != (value & mask)) {
        hid_set_bits(output->data, bit, bits, value);
        output->changed = true;
    }
}

static double clamp(float level)
{
    return level > 0 ? level < 1 ? (double)level : 1 : 0;
}

bool hid_outputs_set(struct hid_outputs *outputs, uint32_t usage, int index, float level)
{
    for (int i = 0; i < outputs->lamp_count; i++) {
        const struct lamp *lamp = &outputs->lamps[i];
        if (lamp->usage == usage && lamp->index == index) {
            double value = (double)lamp->min + clamp(level) * (double)(lamp->max - lamp->min) + .5;
            int64_t whole = (int64_t)value - (value < 0 && value != (double)(int64_t)value);
            set(&outputs->outputs[lamp->output], lamp->bit, lamp->bits, (uint32_t)whole);
            return true;
        }
    }
    return false;
}

bool hid_outputs_set_bits(struct hid_outputs *outputs, uint8_t report, uint32_t bit, int bits, uint32_t most,
                          float level)
{
    struct output *output = find(outputs, report);
    if (!output || bits < 1 || bits > 32 || (uint64_t)bit + (uint64_t)bits > 8 * (uint64_t)output->size) {
        return false;
    }
    double full = most ? (double)most : (double)((UINT64_C(1) << bits) - 1);
    set(output, bit, (uint32_t)bits, (uint32_t)(clamp(level) * full + .5));
    return true;
}

size_t hid_outputs_take(struct hid_outputs *outputs, uint8_t *bytes, size_t size)
{
    for (int i = 0; i < outputs->output_count; i++) {
        struct output *output = &outputs->outputs[i];
        if (output->changed && output->size < size) {
            output->changed = false;
            bytes[0] = output->id;
            memcpy(bytes + 1, output->data, output->size);
            return output->size + 1;
        }
    }
    return 0;
}
