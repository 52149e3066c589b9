#include "pictures.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

#include "beneath.h"
#include "fit.h"

/* Channels as a script counts them, whatever their order in the file: EXR sorts them by name. */
static bool arrange(const struct image *image, struct script_picture *picture)
{
    int from[4] = {image_channel(image, "R"), image_channel(image, "G"), image_channel(image, "B"), -1};
    int count = 3;
    if (from[0] < 0 || from[1] < 0 || from[2] < 0) {
        int grey = image_channel(image, "Y");
        from[0] = grey >= 0 ? grey : 0;
        count = 1;
    }
    if (image->alpha >= 0) {
        from[count++] = image->alpha;
    }
    size_t pixels = (size_t)image->width * (size_t)image->height;
    float *values = malloc(pixels * (size_t)count * sizeof *values);
    if (!values) {
        return false;
    }
    for (size_t i = 0; i < pixels; i++) {
        for (int c = 0; c < count; c++) {
            values[i * (size_t)count + (size_t)c] = image->values[i * (size_t)image->channels + (size_t)from[c]];
        }
    }
    *picture = (struct script_picture){image->width, image->height, count, values};
    return true;
}

bool pictures_load(void *data, const char *folder, const char *path, struct script_picture *picture,
                   struct file_error *error)
{
    (void)data;
    int fd = beneath_open(folder, path, "a picture", error);
    if (fd < 0) {
        return false;
    }
    char opened[32]; /* the very file that was checked, not what has taken its name since */
    snprintf(opened, sizeof opened, "/proc/self/fd/%d", fd);
    struct image image;
    struct file_error why;
    struct image_def def = fit_def();
    bool good = image_read(opened, &def, &image, &why);
    if (!good) {
        const char *reason = strstr(why.text, ": ");
        snprintf(error->text, sizeof error->text, "'%.100s' %.300s; a PNG, JPEG, TIFF, EXR or WebP picture", path,
                 reason ? reason + 2 : why.text);
    } else if (!(good = arrange(&image, picture))) {
        snprintf(error->text, sizeof error->text, "memory is short for '%.100s'; a smaller picture", path);
    }
    image_finish(&image);
    close(fd);
    return good;
}

struct image pictures_image(const struct script_picture *picture)
{
    static const char *const NAMES[4][4] = {{"Y"}, {"Y", "A"}, {"R", "G", "B"}, {"R", "G", "B", "A"}};
    struct image image = {.width = picture->width,
                          .height = picture->height,
                          .channels = picture->channels,
                          .alpha = picture->channels % 2 == 0 ? picture->channels - 1 : -1,
                          .values = picture->values};
    for (int c = 0; c < picture->channels; c++) {
        snprintf(image.names[c], sizeof image.names[c], "%s", NAMES[picture->channels - 1][c]);
    }
    return image;
}
