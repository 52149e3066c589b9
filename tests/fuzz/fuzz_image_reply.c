/* The parser of what the picture helper answers. An input is a byte of choices, the seven numbers of the header, some
 * text and the values; the rest of the reply is filled in here, so that inputs stay small. */
#include <math.h>
#include <stddef.h>
#include <stdlib.h>
#include <string.h>

#include "image_reply.h"

enum {
    NUMBERS = 7,     /* from magic to orientation */
    TEXT = 80,       /* longer than a name */
    SMALL = 1,       /* choice: numbers of one signed byte instead of four */
    MAGIC = 2,       /* choice: with the magic, which would be hard to guess */
    FITTING = 4,     /* choice: as many values as the numbers ask for */
    SHORT = 8,       /* choice: a reply too short for its header */
    VALUES = 1 << 17 /* bytes of values at most */
};

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size);

static void require(bool truth)
{
    if (!truth) {
        abort();
    }
}

static void check_text(const char *text, size_t size)
{
    size_t length = strnlen(text, size);
    require(length < size);
    for (size_t i = 0; i < length; i++) {
        require((unsigned char)text[i] >= 0x20 && (unsigned char)text[i] <= 0x7e);
    }
}

static void check_image(const struct image *image, const struct image_def *def)
{
    require(image->width >= 1 && image->height >= 1 && image->channels >= 1 && image->channels <= def->channels);
    require((image->width <= def->width && image->height <= def->height) ||
            (image->width <= def->height && image->height <= def->width));
    require(image->alpha >= -1 && image->alpha < image->channels);
    for (int i = 0; i < image->width * image->height * image->channels; i++) {
        require(isfinite(image->values[i]));
    }
    for (int c = 0; c < IMAGE_CHANNELS_MAX; c++) {
        check_text(image->names[c], IMAGE_NAME);
    }
}

/* Takes up to `most` bytes of the input. */
static size_t take(void *to, size_t most, const uint8_t **data, size_t *size)
{
    size_t taken = *size < most ? *size : most;
    memcpy(to, *data, taken);
    *data += taken;
    *size -= taken;
    return taken;
}

static void make_head(struct image_reply *head, int choices, const uint8_t **data, size_t *size)
{
    uint32_t numbers[NUMBERS] = {0};
    if (choices & SMALL) {
        int8_t bytes[NUMBERS] = {0};
        take(bytes, sizeof bytes, data, size);
        for (int i = 0; i < NUMBERS; i++) {
            numbers[i] = (uint32_t)(int32_t)bytes[i];
        }
    } else {
        take(numbers, sizeof numbers, data, size);
    }
    if (choices & MAGIC) {
        numbers[0] = IMAGE_REPLY_MAGIC;
    }
    memcpy(head, numbers, sizeof numbers);
    size_t text = take(head->names, TEXT, data, size);
    memcpy(head->message, head->names, text);
}

int LLVMFuzzerTestOneInput(const uint8_t *data, size_t size)
{
    const struct image_def def = {.width = 64, .height = 32, .channels = 8, .megabytes = 1};
    uint8_t choices = 0;
    struct image_reply head = {0};
    take(&choices, 1, &data, &size);
    make_head(&head, choices, &data, &size);
    size_t values = size < VALUES ? size : VALUES;
    uint64_t asked = (uint64_t)head.width * head.height;
    if (choices & FITTING && asked <= VALUES && asked * head.channels * sizeof(float) <= VALUES) {
        values = (size_t)(asked * head.channels * sizeof(float));
    }
    size_t whole = size == 0 && choices & SHORT ? choices : IMAGE_REPLY_VALUES + values;
    uint8_t *reply = malloc(whole);
    uint8_t *page = calloc(1, IMAGE_REPLY_VALUES);
    if (reply && page) {
        memcpy(page, &head, sizeof head);
        memcpy(reply, page, whole < IMAGE_REPLY_VALUES ? whole : IMAGE_REPLY_VALUES);
        for (size_t i = IMAGE_REPLY_VALUES; i < whole; i++) {
            reply[i] = size > 0 ? data[i % size] : 0;
        }
        struct image image;
        struct file_error error = {""};
        if (image_reply_parse(reply, whole, &def, "fuzz", &image, &error)) {
            check_image(&image, &def);
        } else {
            require(!image.values && strncmp(error.text, "fuzz: ", 6) == 0);
            check_text(error.text, sizeof error.text);
        }
        image_finish(&image);
    }
    free(page);
    free(reply);
    return 0;
}
