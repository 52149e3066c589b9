/* The pictures of a script, through the image helper. */
#ifndef FROND_PICTURES_H
#define FROND_PICTURES_H

#include "image.h"
#include "script.h"

/* A loader for struct script_def. `data` is not used. */
bool pictures_load(void *data, const char *folder, const char *path, struct script_picture *picture,
                   struct file_error *error);
/* A script's picture as an image, whose values stay the picture's. */
struct image pictures_image(const struct script_picture *picture);

#endif
