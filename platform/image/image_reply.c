#include "image_reply.h"

#include <assert.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

static_assert(sizeof(struct image_reply) <= IMAGE_REPLY_VALUES, "the values follow the header");

/* Copies text of the helper up to its NUL or the end of `to`; what a terminal might obey becomes '?'. */
static void copy_text(char *to, const char *from, size_t size)
{
    size_t i = 0;
    for (; i + 1 < size && from[i]; i++) {
        to[i] = from[i];
        if (from[i] < 0x20 || from[i] > 0x7e) {
            to[i] = '?';
        }
    }
    to[i] = '\0';
}

static bool fail_reported(const struct image_reply *head, const struct image_def *def, const char *path,
                          struct file_error *error)
{
    char message[IMAGE_REPLY_MESSAGE];
    switch ((enum image_reply_status)head->status) {
    case IMAGE_REPLY_SIZE:
        return file_fail(error, path, "is %ux%u: at most %dx%d", head->width, head->height, def->width, def->height);
    case IMAGE_REPLY_CHANNELS:
        return file_fail(error, path, "has %u channels: at most %d", head->channels, def->channels);
    case IMAGE_REPLY_MEMORY:
        return file_fail(error, path, "needs more than %d MB", def->megabytes);
    case IMAGE_REPLY_DEEP:
        return file_fail(error, path, "is not a flat picture");
    case IMAGE_REPLY_DAMAGED:
        copy_text(message, head->message, sizeof message);
        return file_fail(error, path, "is damaged: %s", message);
    case IMAGE_REPLY_OK:
        break;
    }
    return file_fail(error, path, "is damaged: its decoder gave no answer");
}

static bool head_is_true(const struct image_reply *head, size_t size, const struct image_def *def)
{
    if (head->width < 1 || head->height < 1 || head->channels < 1 || head->width > (uint32_t)def->width ||
        head->height > (uint32_t)def->height || head->channels > (uint32_t)def->channels) {
        return false;
    }
    /* The limits keep the product below 2^14 * 2^14 * 2^6 * 2^2 = 2^36. */
    uint64_t bytes = (uint64_t)head->width * head->height * head->channels * sizeof(float);
    return bytes <= (uint64_t)def->megabytes << 20 && size - IMAGE_REPLY_VALUES == bytes && head->alpha >= -1 &&
           head->alpha < (int32_t)head->channels && head->orientation >= 1 && head->orientation <= 8;
}

/* Where a stored pixel is shown; EXIF 2.32, tag 274. */
static size_t place(uint32_t orientation, size_t x, size_t y, size_t width, size_t height)
{
    switch (orientation) {
    case 2:
        return y * width + (width - 1 - x);
    case 3:
        return (height - 1 - y) * width + (width - 1 - x);
    case 4:
        return (height - 1 - y) * width + x;
    case 5:
        return x * height + y;
    case 6:
        return x * height + (height - 1 - y);
    case 7:
        return (width - 1 - x) * height + (height - 1 - y);
    case 8:
        return (width - 1 - x) * height + y;
    default:
        return y * width + x;
    }
}

static void copy_values(const struct image_reply *head, const float *from, float *values)
{
    size_t channels = head->channels;
    for (size_t y = 0; y < head->height; y++) {
        for (size_t x = 0; x < head->width; x++) {
            float *to = values + place(head->orientation, x, y, head->width, head->height) * channels;
            for (size_t c = 0; c < channels; c++, from++) {
                to[c] = isfinite(*from) ? *from : 0.0f;
            }
        }
    }
}

bool image_reply_parse(const void *reply, size_t size, const struct image_def *def, const char *path,
                       struct image *image, struct file_error *error)
{
    memset(image, 0, sizeof *image);
    struct image_reply head;
    if (size < IMAGE_REPLY_VALUES) {
        return file_fail(error, path, "is damaged: its decoder gave no answer");
    }
    memcpy(&head, reply, sizeof head);
    if (head.magic != IMAGE_REPLY_MAGIC || head.status != IMAGE_REPLY_OK) {
        head.status = head.magic == IMAGE_REPLY_MAGIC ? head.status : 0;
        return fail_reported(&head, def, path, error);
    }
    if (!head_is_true(&head, size, def)) {
        return file_fail(error, path, "is damaged: its decoder gave an answer that cannot be true");
    }
    float *values = malloc(size - IMAGE_REPLY_VALUES);
    if (!values) {
        return file_fail(error, path, "not enough memory");
    }
    copy_values(&head, (const float *)((const char *)reply + IMAGE_REPLY_VALUES), values);
    bool turned = head.orientation >= 5;
    image->width = (int)(turned ? head.height : head.width);
    image->height = (int)(turned ? head.width : head.height);
    image->channels = (int)head.channels;
    image->alpha = head.alpha;
    image->values = values;
    for (uint32_t c = 0; c < head.channels; c++) {
        copy_text(image->names[c], head.names[c], IMAGE_NAME);
    }
    return true;
}
