/* Whether two pictures are the same:
 *     picture_compare [--turn 0|90|180|270] [--most N] [--share S] DRAWN SHOWN
 * DRAWN is turned clockwise first. A pixel differs when a channel is more than N of 255 off; the pictures are the same
 * when at most the share S (0..1) of the pixels differ. Prints one line; ends with 0 for the same, 1 for different, 2
 * when there is nothing to compare: a file cannot be read, or DRAWN has hardly any detail that could differ. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "image.h"

/* 8-bit PPM as kms_probe writes it, which frond-image does not read, in the linear light that it would give. */
static bool read_ppm(const char *path, struct image *image)
{
    FILE *file = fopen(path, "rb");
    char line[3][32] = {"", "", ""}, *height = NULL;
    for (int i = 0; file && i < 3; i++) {
        if (!fgets(line[i], sizeof line[i], file)) {
            break;
        }
    }
    image->width = (int)strtol(line[1], &height, 10);
    image->height = height ? (int)strtol(height, NULL, 10) : 0;
    bool done = !strcmp(line[0], "P6\n") && !strcmp(line[2], "255\n") && image->width > 0 && image->height > 0;
    const size_t count = done ? (size_t)image->width * (size_t)image->height * 3 : 0;
    image->channels = 3;
    image->values = calloc(count + 1, sizeof *image->values);
    done = done && image->values;
    for (size_t i = 0; done && i < count; i++) {
        const int byte = getc(file);
        const double value = byte / 255.0;
        done = byte != EOF;
        image->values[i] = (float)(value <= 0.04045 ? value / 12.92 : pow((value + 0.055) / 1.055, 2.4));
    }
    if (file) {
        fclose(file);
    }
    return done;
}

static bool read_picture(const char *path, struct image *image)
{
    struct image_def def = image_default_def();
    struct file_error error;
    const char *dot = strrchr(path, '.');
    def.helper = IMAGE_HELPER;
    if (dot && strcmp(dot, ".ppm") == 0) {
        return read_ppm(path, image) || (printf("%s: not a PPM\n", path), false);
    }
    return image_read(path, &def, image, &error) || (printf("%s\n", error.text), false);
}

enum {
    DETAIL = 200, /* pixels that differ from the one to the left of them, at least */
    NOTHING = 2,  /* the status that says so */
};

struct options {
    int turn;     /* degrees */
    double most;  /* of 255 */
    double share; /* 0..1 */
    const char *path[2];
};

static double encoded(float linear) /* sRGB, 0..255 */
{
    const double value = linear;
    return 255.0 * (value <= 0.0031308 ? 12.92 * value : 1.055 * pow(value, 1 / 2.4) - 0.055);
}

/* The greatest difference of a channel, of 255. Grey pictures have one channel, which stands for all three. */
static double difference(const struct image *a, int at_a, const struct image *b, int at_b)
{
    double worst = 0;
    for (int channel = 0; channel < 3; channel++) {
        const float value_a = a->values[at_a * a->channels + (a->channels < 3 ? 0 : channel)];
        const float value_b = b->values[at_b * b->channels + (b->channels < 3 ? 0 : channel)];
        worst = fmax(worst, fabs(encoded(value_a) - encoded(value_b)));
    }
    return worst;
}

/* Where the pixel of `drawn` lies that comes to x, y of the turned picture. */
static int turned(const struct image *drawn, int turn, int x, int y)
{
    const int right = drawn->width - 1, bottom = drawn->height - 1;
    switch (turn) {
    case 90:
        return (bottom - x) * drawn->width + y;
    case 180:
        return (bottom - y) * drawn->width + right - x;
    case 270:
        return x * drawn->width + right - y;
    default:
        return y * drawn->width + x;
    }
}

static int detail(const struct image *image)
{
    int count = 0;
    for (int y = 0; y < image->height; y++) {
        for (int x = 1; x < image->width; x++) {
            const int at = y * image->width + x;
            count += difference(image, at, image, at - 1) > 1;
        }
    }
    return count;
}

static int compare(const struct options *options, const struct image *drawn, const struct image *shown)
{
    const bool lies = options->turn == 90 || options->turn == 270;
    const int width = lies ? drawn->height : drawn->width, height = lies ? drawn->width : drawn->height;
    if (width != shown->width || height != shown->height) {
        printf("drawn %dx%d, shown %dx%d\n", width, height, shown->width, shown->height);
        return 1;
    }
    if (detail(drawn) < DETAIL) {
        printf("the picture drawn has no detail to compare: %d pixels\n", detail(drawn));
        return NOTHING;
    }
    double worst = 0, sum = 0;
    int beyond = 0, worst_x = 0, worst_y = 0;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            const double off = difference(drawn, turned(drawn, options->turn, x, y), shown, y * width + x);
            sum += off;
            beyond += off > options->most;
            if (off > worst) {
                worst = off;
                worst_x = x;
                worst_y = y;
            }
        }
    }
    const double share = (double)beyond / ((double)width * height);
    printf("%dx%d, mean difference %.2f of 255, worst %.0f at %d,%d; %.3f %% of the pixels more than %.0f off\n", width,
           height, sum / ((double)width * height), worst, worst_x, worst_y, 100 * share, options->most);
    return share > options->share;
}

static bool parse(int argc, char **argv, struct options *options)
{
    int paths = 0;
    for (int i = 1; i < argc; i++) {
        if (argv[i][0] != '-') {
            if (paths == 2) {
                return false;
            }
            options->path[paths++] = argv[i];
            continue;
        }
        if (i + 1 == argc) {
            return false;
        }
        char *end;
        const double value = strtod(argv[i + 1], &end);
        if (*end) {
            return false;
        }
        if (!strcmp(argv[i], "--turn")) {
            options->turn = (int)value;
        } else if (!strcmp(argv[i], "--most")) {
            options->most = value;
        } else if (!strcmp(argv[i], "--share")) {
            options->share = value;
        } else {
            return false;
        }
        i++;
    }
    return paths == 2 && options->turn % 90 == 0 && options->turn >= 0 && options->turn < 360;
}

int main(int argc, char **argv)
{
    struct options options = {.most = 2};
    if (!parse(argc, argv, &options)) {
        fputs("picture_compare [--turn 0|90|180|270] [--most N] [--share S] DRAWN SHOWN\n", stderr);
        return NOTHING;
    }
    struct image image[2] = {{0}, {0}};
    int result = 0;
    for (int i = 0; i < 2; i++) {
        if (!read_picture(options.path[i], &image[i])) {
            result = NOTHING;
        }
    }
    if (result == 0) {
        result = compare(&options, &image[0], &image[1]);
    }
    image_finish(&image[0]);
    image_finish(&image[1]);
    return result;
}
