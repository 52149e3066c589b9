#include "fit.h"

#include <math.h>
#include <stdlib.h>

enum { PICTURE_MEGABYTES = 2400, PICTURE_SECONDS = 60 };

struct image_def fit_def(void)
{
    struct image_def def = image_default_def();
    def.width = def.height = IMAGE_SIZE_MAX;
    def.shrink = FIT_SIDE;
    def.megabytes = PICTURE_MEGABYTES;
    def.seconds = PICTURE_SECONDS;
    return def;
}

bool fit_read(const char *path, struct image *image, struct file_error *error)
{
    struct image_def def = fit_def();
    return image_read(path, &def, image, error);
}

void fit_size(const struct image *image, int side, int *width, int *height)
{
    double longer = image->width > image->height ? image->width : image->height;
    *width = (int)(side * (double)image->width / longer + 0.5);
    *height = (int)(side * (double)image->height / longer + 0.5);
    *width = *width > 0 ? *width : 1;
    *height = *height > 0 ? *height : 1;
}

struct channels {
    int from[4]; /* red, green, blue, alpha; -1: none */
};

static struct channels find_channels(const struct image *image)
{
    struct channels channels = {
        {image_channel(image, "R"), image_channel(image, "G"), image_channel(image, "B"), image->alpha}};
    if (channels.from[0] < 0 || channels.from[1] < 0 || channels.from[2] < 0) {
        int grey = image_channel(image, "Y");
        channels.from[0] = channels.from[1] = channels.from[2] = grey >= 0 ? grey : 0;
    }
    return channels;
}

static void add(const struct image *image, const struct channels *channels, int x, int y, float weight, float sum[4])
{
    x = x < 0 ? 0 : x < image->width ? x : image->width - 1;
    y = y < 0 ? 0 : y < image->height ? y : image->height - 1;
    const float *pixel = image->values + ((size_t)y * (size_t)image->width + (size_t)x) * (size_t)image->channels;
    for (int c = 0; c < 4; c++) {
        sum[c] += weight * (channels->from[c] < 0 ? 1 : pixel[channels->from[c]]);
    }
}

/* How much of the pixel `at` lies between `from` and `to`. */
static float share(int at, float from, float to)
{
    float left = from > (float)at ? from : (float)at, right = to < (float)(at + 1) ? to : (float)(at + 1);
    return right > left ? right - left : 0;
}

float *fit_linear(const struct image *image, int width, int height)
{
    struct channels channels = find_channels(image);
    float *out = calloc((size_t)width * (size_t)height, 4 * sizeof *out);
    float step_x = (float)image->width / (float)width, step_y = (float)image->height / (float)height;
    float wide = step_x > 1 ? step_x : 1, high = step_y > 1 ? step_y : 1;
    for (int y = 0; y < height && out; y++) {
        for (int x = 0; x < width; x++) {
            float *sum = out + 4 * ((size_t)y * (size_t)width + (size_t)x), whole = 0;
            float left = ((float)x + 0.5f) * step_x - 0.5f * wide, top = ((float)y + 0.5f) * step_y - 0.5f * high;
            for (int v = (int)floorf(top); (float)v < top + high; v++) {
                for (int u = (int)floorf(left); (float)u < left + wide; u++) {
                    float weight = share(v, top, top + high) * share(u, left, left + wide);
                    add(image, &channels, u, v, weight, sum);
                    whole += weight;
                }
            }
            for (int c = 0; c < 4; c++) {
                sum[c] /= whole > 0 ? whole : 1;
            }
        }
    }
    return out;
}
