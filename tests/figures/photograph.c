#include "photograph.h"

#include <stdio.h>
#include <stdlib.h>
#include <unistd.h>

#include "fit.h"

#define ASTRONAUT "/usr/lib/python3/dist-packages/imageio/resources/images/astronaut.png"
#define ADMIRAL   "/usr/share/matplotlib/mpl-data/sample_data/grace_hopper.jpg"

static const struct source {
    const char *package, *path;
    int x, y, side; /* of the square, pixels */
} SOURCES[PHOTOGRAPHS] = {
    [PHOTOGRAPH_ASTRONAUT] = {"python3-imageio", ASTRONAUT, 0, 0, 512},
    [PHOTOGRAPH_FACE] = {"python3-imageio", ASTRONAUT, 95, 0, 256},
    [PHOTOGRAPH_CLOSE] = {"python3-imageio", ASTRONAUT, 115, 0, 220},
    [PHOTOGRAPH_FROWN] = {"python-matplotlib-data", ADMIRAL, 70, 20, 400},
    [PHOTOGRAPH_ADMIRAL] = {"python-matplotlib-data", ADMIRAL, 0, 20, 512},
    [PHOTOGRAPH_CAT] = {"python3-imageio", "/usr/lib/python3/dist-packages/imageio/resources/images/chelsea.png", 60, 0,
                        300},
};

bool photographs_are_there(void)
{
    for (int i = 0; i < PHOTOGRAPHS; i++) {
        if (access(SOURCES[i].path, R_OK) != 0) {
            printf("SKIPPED: no photograph: apt-get install %s\n", SOURCES[i].package);
            return false;
        }
    }
    return true;
}

struct sitter *photograph_sit(enum photograph photograph)
{
    const struct source *source = &SOURCES[photograph];
    struct image_def def = image_default_def();
    struct image image, square = {0};
    struct file_error error;
    def.helper = FIGURES_HELPER;
    if (!image_read(source->path, &def, &image, &error)) {
        figure_stop("photograph", error.text);
    }
    square = image;
    square.width = square.height = source->side;
    square.values = malloc((size_t)source->side * (size_t)source->side * (size_t)image.channels * sizeof(float));
    struct sitter *sitter = calloc(1, sizeof *sitter);
    if (!sitter || !square.values || source->x + source->side > image.width ||
        source->y + source->side > image.height) {
        figure_stop("photograph", "no memory, or another picture");
    }
    size_t row = (size_t)source->side * (size_t)image.channels;
    for (int y = 0; y < source->side; y++) {
        const float *from =
            image.values + ((size_t)(source->y + y) * (size_t)image.width + (size_t)source->x) * (size_t)image.channels;
        for (size_t i = 0; i < row; i++) {
            square.values[(size_t)y * row + i] = from[i];
        }
    }
    float *linear = fit_linear(&square, SITTER_SIDE, SITTER_SIDE);
    if (!linear) {
        figure_stop("photograph", "no memory");
    }
    for (int i = 0; i < SITTER_SIDE * SITTER_SIDE; i++) {
        for (int c = 0; c < 3; c++) {
            sitter->linear[3 * i + c] = linear[4 * i + c];
        }
    }
    importance_grey(sitter->linear, SITTER_SIDE, SITTER_SIDE, 3, -1, sitter->grey);
    free(linear);
    free(square.values);
    image_finish(&image);
    return sitter;
}
