#define _GNU_SOURCE /* memfd_create, seals */
#include "image.h"

#include <errno.h>
#include <fcntl.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/mman.h>
#include <sys/stat.h>
#include <unistd.h>

#include "image_format.h"
#include "image_process.h"
#include "image_reply.h"

enum {
    FILE_MEGABYTES = 256, /* of a file to be read */
    NUMBER = 12,          /* bytes of an int in decimal */
    SQUARE = 8,           /* pixels a side of the placeholder's checker */
};

struct image_def image_default_def(void)
{
    return (struct image_def){
        .width = 8192, .height = 8192, .channels = 4, .megabytes = 512, .seconds = 10, .write_seconds = 120};
}

static int clamp(int value, int most)
{
    return value < 1 ? 1 : value > most ? most : value;
}

static struct image_def within_range(const struct image_def *def)
{
    struct image_def own = def ? *def : image_default_def();
    own.width = clamp(own.width, IMAGE_SIZE_MAX);
    own.height = clamp(own.height, IMAGE_SIZE_MAX);
    own.shrink = own.shrink > 0 ? clamp(own.shrink, IMAGE_SIZE_MAX) : IMAGE_SIZE_MAX;
    own.channels = clamp(own.channels, IMAGE_CHANNELS_MAX);
    own.megabytes = clamp(own.megabytes, 4096);
    own.seconds = clamp(own.seconds, 600);
    own.write_seconds = clamp(own.write_seconds, 600);
    return own;
}

/* Opens a regular file without waiting for the other end of a pipe. Negative with the error filled in. */
static int open_picture(const char *path, const char **format, struct file_error *error)
{
    int fd = open(path, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
    if (fd < 0) {
        file_fail_code(error, path, errno);
        return -1;
    }
    struct stat about;
    char start[IMAGE_FORMAT_BYTES];
    bool known = fstat(fd, &about) == 0;
    ssize_t size = known && S_ISREG(about.st_mode) ? pread(fd, start, sizeof start, 0) : 0;
    if (!known || size < 0) {
        file_fail_code(error, path, errno);
    } else if (S_ISDIR(about.st_mode)) {
        file_fail_code(error, path, EISDIR);
    } else if (!S_ISREG(about.st_mode)) {
        file_fail(error, path, "is not a file but a pipe, a socket or a device");
    } else if (about.st_size == 0) {
        file_fail(error, path, "is empty");
    } else if (about.st_size > (off_t)FILE_MEGABYTES << 20) {
        file_fail(error, path, "is a file of %lld MB: at most %d MB", (long long)about.st_size >> 20, FILE_MEGABYTES);
    } else if (!(*format = image_format(start, (size_t)size))) {
        file_fail(error, path, "not a picture that Frond reads (PNG, JPEG, TIFF, EXR, WebP)");
    } else {
        return fd;
    }
    close(fd);
    return -1;
}

static int make_memory(const char *path, struct file_error *error)
{
    int fd = memfd_create("frond-image", MFD_CLOEXEC | MFD_ALLOW_SEALING);
    if (fd < 0) {
        file_fail_code(error, path, errno);
    }
    return fd;
}

/* Maps what a helper left in a memfd, sealed so that nobody can change it under our eyes. NULL with the error. */
static const void *map_sealed(int fd, size_t *size, const char *path, struct file_error *error)
{
    struct stat about;
    if (fcntl(fd, F_ADD_SEALS, F_SEAL_SHRINK | F_SEAL_GROW | F_SEAL_WRITE | F_SEAL_SEAL) != 0 ||
        fstat(fd, &about) != 0) {
        file_fail_code(error, path, errno);
        return NULL;
    }
    *size = (size_t)about.st_size;
    if (*size == 0) {
        file_fail(error, path, "the picture helper gave no answer");
        return NULL;
    }
    void *bytes = mmap(NULL, *size, PROT_READ, MAP_PRIVATE, fd, 0);
    if (bytes == MAP_FAILED) {
        file_fail_code(error, path, errno);
        return NULL;
    }
    return bytes;
}

static bool decode(const char *path, int file, const char *format, const struct image_def *def, struct image *image,
                   struct file_error *error)
{
    int reply = make_memory(path, error);
    if (reply < 0) {
        return false;
    }
    char width[NUMBER], height[NUMBER], channels[NUMBER], megabytes[NUMBER], seconds[NUMBER], shrink[NUMBER];
    snprintf(width, sizeof width, "%d", def->width);
    snprintf(height, sizeof height, "%d", def->height);
    snprintf(channels, sizeof channels, "%d", def->channels);
    snprintf(megabytes, sizeof megabytes, "%d", def->megabytes);
    snprintf(seconds, sizeof seconds, "%d", def->seconds);
    snprintf(shrink, sizeof shrink, "%d", def->shrink);
    const char *request[] = {"read", format, width, height, channels, megabytes, seconds, shrink, NULL};
    struct image_job job = {.helper = def->helper,
                            .request = request,
                            .input = file,
                            .output = reply,
                            .seconds = def->seconds + IMAGE_REPLY_WAIT,
                            .told_seconds = def->seconds,
                            .path = path};
    bool read = false;
    size_t size = 0;
    const void *bytes = NULL;
    if (image_process_run(&job, error) != IMAGE_OUTCOME_FAILED && (bytes = map_sealed(reply, &size, path, error))) {
        read = image_reply_parse(bytes, size, def, path, image, error);
        munmap((void *)(uintptr_t)bytes, size);
    }
    close(reply);
    return read;
}

/* A calm grey checker with three channels, to stand for a picture that could not be read. */
static void fill_placeholder(struct image *image)
{
    enum { SIZE = IMAGE_PLACEHOLDER_SIZE, CHANNELS = 3 };
    memset(image, 0, sizeof *image);
    image->alpha = -1;
    image->values = malloc(sizeof(float) * SIZE * SIZE * CHANNELS);
    if (!image->values) {
        return;
    }
    image->width = image->height = SIZE;
    image->channels = CHANNELS;
    for (int c = 0; c < CHANNELS; c++) {
        image->names[c][0] = "RGB"[c];
    }
    float *value = image->values;
    for (int y = 0; y < SIZE; y++) {
        for (int x = 0; x < SIZE; x++) {
            float grey = (x / SQUARE + y / SQUARE) % 2 == 0 ? 0.6f : 0.45f;
            for (int c = 0; c < CHANNELS; c++) {
                *value++ = grey;
            }
        }
    }
}

bool image_read(const char *path, const struct image_def *def, struct image *image, struct file_error *error)
{
    struct image_def own = within_range(def);
    memset(image, 0, sizeof *image);
    const char *format = NULL;
    int file = open_picture(path, &format, error);
    bool read = file >= 0 && decode(path, file, format, &own, image, error);
    if (file >= 0) {
        close(file);
    }
    if (!read) {
        fill_placeholder(image);
    }
    return read;
}

int image_channel(const struct image *image, const char *name)
{
    for (int c = 0; c < image->channels; c++) {
        if (strcmp(image->names[c], name) == 0) {
            return c;
        }
    }
    return -1;
}

void image_finish(struct image *image)
{
    if (image) {
        free(image->values);
        memset(image, 0, sizeof *image);
    }
}

static bool encode(const char *path, const char *const *request, int input, const struct image_def *def,
                   struct file_error *error)
{
    int output = make_memory(path, error);
    if (output < 0) {
        return false;
    }
    struct image_job job = {.helper = def->helper,
                            .request = request,
                            .input = input,
                            .output = output,
                            .seconds = def->write_seconds + IMAGE_REPLY_WAIT,
                            .told_seconds = def->write_seconds,
                            .path = path};
    enum image_outcome outcome = image_process_run(&job, error);
    bool written = false;
    size_t size = 0;
    const void *bytes = NULL;
    if (outcome != IMAGE_OUTCOME_FAILED && (bytes = map_sealed(output, &size, path, error))) {
        struct image none;
        const char *format = image_format(bytes, size);
        if (outcome == IMAGE_OUTCOME_DONE && format && strcmp(format, request[1]) == 0) {
            written = file_write_atomic(path, bytes, size, error);
        } else if (image_reply_parse(bytes, size, def, path, &none, error)) {
            image_finish(&none);
            file_fail(error, path, "the picture helper gave no answer");
        }
        munmap((void *)(uintptr_t)bytes, size);
    }
    close(output);
    return written;
}

static bool size_is_legal(const char *path, int width, int height, struct file_error *error)
{
    if (width < 1 || height < 1 || width > IMAGE_SIZE_MAX || height > IMAGE_SIZE_MAX) {
        return file_fail(error, path, "cannot be %dx%d: 1x1 to %dx%d", width, height, IMAGE_SIZE_MAX, IMAGE_SIZE_MAX);
    }
    return true;
}

/* Takes `count` parts of `size` bytes each to the helper; `names` has as many, or is NULL. */
static bool send(const char *path, const char *format, const char *const *names, const void *const *parts, int count,
                 size_t size, int width, int height, const struct image_def *def, struct file_error *error)
{
    struct image_def own = within_range(def);
    char numbers[3][NUMBER];
    int values[3] = {width, height, own.write_seconds};
    const char *request[5 + IMAGE_CHANNELS_MAX + 1] = {"write", format};
    for (int i = 0; i < 3; i++) {
        snprintf(numbers[i], NUMBER, "%d", values[i]);
        request[2 + i] = numbers[i];
    }
    for (int i = 0; names && i < count; i++) {
        request[5 + i] = names[i];
    }
    int input = make_memory(path, error);
    bool sent = input >= 0;
    for (int i = 0; sent && i < count; i++) {
        if (!file_write_whole(input, parts[i], size)) {
            sent = file_fail_code(error, path, errno);
        }
    }
    sent = sent && encode(path, request, input, &own, error);
    if (input >= 0) {
        close(input);
    }
    return sent;
}

bool image_write_png(const char *path, const uint8_t *rgb, int width, int height, const struct image_def *def,
                     struct file_error *error)
{
    if (!size_is_legal(path, width, height, error)) {
        return false;
    }
    const void *parts[] = {rgb};
    return send(path, "png", NULL, parts, 1, (size_t)width * (size_t)height * 3, width, height, def, error);
}

static bool names_are_legal(const char *path, const char *const names[], int channels, struct file_error *error)
{
    if (channels < 1 || channels > IMAGE_CHANNELS_MAX) {
        return file_fail(error, path, "cannot have %d channels: 1 to %d", channels, IMAGE_CHANNELS_MAX);
    }
    for (int c = 0; c < channels; c++) {
        size_t length = strlen(names[c]);
        if (length < 1 || length >= IMAGE_NAME) {
            return file_fail(error, path, "channel name \"%s\" has %zu bytes: 1 to %d", names[c], length,
                             IMAGE_NAME - 1);
        }
        for (int other = 0; other < c; other++) {
            if (strcmp(names[c], names[other]) == 0) {
                return file_fail(error, path, "two channels are called \"%s\"", names[c]);
            }
        }
    }
    return true;
}

bool image_write_exr(const char *path, const char *const names[], const float *const planes[], int channels, int width,
                     int height, const struct image_def *def, struct file_error *error)
{
    if (!size_is_legal(path, width, height, error) || !names_are_legal(path, names, channels, error)) {
        return false;
    }
    const void *parts[IMAGE_CHANNELS_MAX];
    for (int c = 0; c < channels; c++) {
        parts[c] = planes[c];
    }
    return send(path, "openexr", names, parts, channels, (size_t)width * (size_t)height * sizeof(float), width, height,
                def, error);
}
