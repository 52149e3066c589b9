#include "live_pictures.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "pictures.h"
#include "raster.h"

enum { FIELD = 384 }; /* values a side: edges are soft anyway */

struct live_pictures {
    struct exhibit_pictures list;
    char *folder;
    int next;
    float *kept[LIVE_PICTURES_KEPT]; /* a ring of fields given out */
    int given;

    bool reading; /* the thread is, or has, and was not joined */
    pthread_t thread;
    atomic_bool done;
    char *path;    /* what it reads */
    float *values; /* what it leaves; NULL: it could not */
    char error[300];
    bool has_line;
    char line[400];
};

static void *read_picture(void *context)
{
    struct live_pictures *pictures = context;
    struct script_picture picture = {0};
    pictures->values = NULL;
    if (pictures_load(NULL, pictures->folder, pictures->path, &picture, pictures->error, sizeof pictures->error)) {
        float *values = malloc((size_t)raster_channels(RASTER_ALONG_EDGES) * FIELD * FIELD * sizeof *values);
        if (values && raster_from_picture(&picture, RASTER_ALONG_EDGES, FIELD, FIELD, values)) {
            pictures->values = values;
        } else {
            free(values);
            snprintf(pictures->error, sizeof pictures->error, "memory is short for '%.100s'", pictures->path);
        }
        free(picture.values);
    }
    atomic_store(&pictures->done, true);
    return NULL;
}

static void begin(struct live_pictures *pictures)
{
    if (pictures->reading || pictures->list.count == 0 || !pictures->folder) {
        return;
    }
    free(pictures->path);
    pictures->path = strdup(pictures->list.paths[pictures->next % pictures->list.count]);
    pictures->next = (pictures->next + 1) % pictures->list.count;
    atomic_store(&pictures->done, false);
    pictures->reading = pictures->path && pthread_create(&pictures->thread, NULL, read_picture, pictures) == 0;
}

/* Takes what the thread has left; with a line where it is nothing. */
static float *end(struct live_pictures *pictures)
{
    pthread_join(pictures->thread, NULL);
    pictures->reading = false;
    if (!pictures->values) {
        snprintf(pictures->line, sizeof pictures->line, "picture left out: %s", pictures->error);
        pictures->has_line = true;
    }
    return pictures->values;
}

struct live_pictures *live_pictures_create(const struct exhibit *exhibit)
{
    struct live_pictures *pictures = calloc(1, sizeof *pictures);
    if (pictures) {
        live_pictures_set(pictures, exhibit);
    }
    return pictures;
}

void live_pictures_destroy(struct live_pictures *pictures)
{
    if (!pictures) {
        return;
    }
    if (pictures->reading) {
        free(end(pictures));
    }
    for (int i = 0; i < LIVE_PICTURES_KEPT; i++) {
        free(pictures->kept[i]);
    }
    exhibit_pictures_finish(&pictures->list);
    free(pictures->folder);
    free(pictures->path);
    free(pictures);
}

void live_pictures_set(struct live_pictures *pictures, const struct exhibit *exhibit)
{
    if (pictures->reading) { /* it may be gone: the list begins again */
        free(end(pictures));
    }
    exhibit_pictures_finish(&pictures->list);
    free(pictures->folder);
    pictures->list = exhibit_pictures(exhibit);
    pictures->folder = strdup(exhibit->folder);
    pictures->next = 0;
    begin(pictures);
}

bool live_pictures_next(struct live_pictures *pictures, struct action *guide)
{
    if (!pictures->reading || !atomic_load(&pictures->done)) {
        begin(pictures);
        return false;
    }
    float *values = end(pictures);
    begin(pictures);
    if (!values) {
        return false;
    }
    float **place = &pictures->kept[pictures->given++ % LIVE_PICTURES_KEPT];
    free(*place);
    *place = values;
    *guide = action_default(ACTION_GUIDE);
    guide->picture = (struct action_raster){values, FIELD, FIELD, raster_channels(RASTER_ALONG_EDGES)};
    guide->reading = READ_ALONG_EDGES;
    return true;
}

bool live_pictures_log(struct live_pictures *pictures, char *line, int size)
{
    bool any = pictures->has_line;
    if (any) {
        snprintf(line, (size_t)size, "%s", pictures->line);
        pictures->has_line = false;
    }
    return any;
}
