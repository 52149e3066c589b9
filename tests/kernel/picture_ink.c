/* Whether there is ink at places of a screenshot:
 *     picture_ink BARE SHOWN X,Y...
 * X, Y in 0..1 of the picture, x right, y down. A pixel has ink when a channel is far from what it is in BARE, a
 * screenshot of the same size of the sheet before anybody painted; looked at is a disc around each place. Prints one
 * line for each; ends with 0 for ink at all of them, 1 for ink at none, 2 when it is neither, or a file cannot be
 * read. */
#include <math.h>
#include <stdio.h>
#include <stdlib.h>

#include "image.h"

static const float FAR = 0.08F;         /* of linear light, 0..1: paper itself is grainy by a tenth of it */
static const double AROUND = 0.03;      /* radius of the disc, of the width */
static const double MUCH = 0.3;         /* share of the disc that is ink */
static const double HARDLY_ANY = 0.005; /* share of the disc that is none */

enum { INK, NONE, UNSURE };

static bool read_picture(const char *path, struct image *image)
{
    struct image_def def = image_default_def();
    struct file_error error;
    def.helper = IMAGE_HELPER;
    return image_read(path, &def, image, &error) || (printf("%s\n", error.text), false);
}

/* Grey pictures have one channel, which stands for all three. */
static float value(const struct image *image, int x, int y, int channel)
{
    size_t pixel = (size_t)y * (size_t)image->width + (size_t)x;
    return image->values[pixel * (size_t)image->channels + (size_t)(image->channels < 3 ? 0 : channel)];
}

static bool is_ink(const struct image *bare, const struct image *shown, int x, int y)
{
    for (int channel = 0; channel < 3; channel++) {
        if (fabsf(value(bare, x, y, channel) - value(shown, x, y, channel)) > FAR) {
            return true;
        }
    }
    return false;
}

static int look(const struct image *bare, const struct image *shown, double at_x, double at_y)
{
    const double radius = AROUND * shown->width;
    int pixels = 0, ink = 0;
    for (int y = 0; y < shown->height; y++) {
        for (int x = 0; x < shown->width; x++) {
            if (hypot(x + 0.5 - at_x * shown->width, y + 0.5 - at_y * shown->height) <= radius) {
                pixels++;
                ink += is_ink(bare, shown, x, y);
            }
        }
    }
    const double share = pixels > 0 ? (double)ink / pixels : 0;
    printf("at %.2f %.2f: ink on %d of %d pixels\n", at_x, at_y, ink, pixels);
    return pixels == 0 ? UNSURE : share >= MUCH ? INK : share <= HARDLY_ANY ? NONE : UNSURE;
}

/* The same answer for all places, or UNSURE. */
static int look_at_all(const struct image *image, int count, char *places[])
{
    int result = UNSURE;
    for (int i = 0; i < count; i++) {
        char *comma, *end = places[i];
        double x = strtod(places[i], &comma), y = *comma == ',' ? strtod(comma + 1, &end) : 0;
        if (*comma != ',' || *end) {
            printf("%s: no place\n", places[i]);
            return UNSURE;
        }
        int found = look(&image[0], &image[1], x, y);
        result = i == 0 || found == result ? found : UNSURE;
        if (result == UNSURE) {
            break;
        }
    }
    return result;
}

int main(int argc, char *argv[])
{
    struct image image[2] = {{0}, {0}};
    int result = UNSURE;
    if (argc < 4) {
        fputs("picture_ink BARE SHOWN X,Y...\n", stderr);
        return UNSURE;
    }
    bool read = read_picture(argv[1], &image[0]) && read_picture(argv[2], &image[1]);
    if (read && (image[0].width != image[1].width || image[0].height != image[1].height)) {
        printf("pictures of two sizes\n");
    } else if (read) {
        result = look_at_all(image, argc - 3, argv + 3);
    }
    image_finish(&image[0]);
    image_finish(&image[1]);
    return result;
}
