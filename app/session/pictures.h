/* The pictures of a script, through the image helper. */
#ifndef FROND_PICTURES_H
#define FROND_PICTURES_H

#include "script.h"

/* A loader for struct script_def. `data` is not used. */
bool pictures_load(void *data, const char *folder, const char *path, struct script_picture *picture, char *error,
                   size_t size);

#endif
