#include "live_pictures.h"

#include <pthread.h>
#include <stdatomic.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "raster.h"

enum {
    FIELD = 384,       /* values a side: edges are soft anyway */
    STOCK_MOST = 1024, /* pixels of the longer side of what is grown over */
};

/* What is made of a picture; all NULL: it could not be read. */
struct read {
    float *field; /* along its edges, FIELD x FIELD */
    float *grey;  /* linear brightness, width x height */
    int width, height;
};

struct live_pictures {
    struct exhibit_pictures list;
    char *folder;
    struct script_def def;
    char *wanted; /* the scene's own picture, until it is read; NULL: the next of the list */
    char *shown;  /* the path of what is grown over; NULL: nothing is yet */
    int next;
    int failures;                    /* one after the other */
    float *kept[LIVE_PICTURES_KEPT]; /* a ring of fields given out */
    int given;
    struct read stocks[LIVE_PICTURES_KEPT]; /* and of pictures, without fields */
    int stocked;

    bool reading; /* the thread is, or has, and was not joined */
    pthread_t thread;
    atomic_bool done;
    char *path;       /* what it reads */
    struct read read; /* what it leaves */
    struct file_error error;
    bool has_line;
    char line[FILE_ERROR_TEXT + 32];
};

static void read_finish(struct read *read)
{
    free(read->field);
    free(read->grey);
    *read = (struct read){.field = NULL};
}

static float *make(const struct script_picture *picture, enum raster_kind kind, int width, int height)
{
    float *values = malloc((size_t)raster_channels(kind) * (size_t)width * (size_t)height * sizeof *values);
    if (values && !raster_from_picture(picture, kind, width, height, values)) {
        free(values);
        values = NULL;
    }
    return values;
}

static void *read_picture(void *context)
{
    struct live_pictures *pictures = context;
    struct script_picture picture = {0};
    struct read *read = &pictures->read;
    *read = (struct read){.field = NULL};
    if (pictures->def.load(pictures->def.data, pictures->folder, pictures->path, &picture, &pictures->error)) {
        int longer = picture.width > picture.height ? picture.width : picture.height;
        double scale = longer > STOCK_MOST ? (double)STOCK_MOST / longer : 1;
        read->width = picture.width * scale >= 1 ? (int)(picture.width * scale) : 1;
        read->height = picture.height * scale >= 1 ? (int)(picture.height * scale) : 1;
        read->field = make(&picture, RASTER_ALONG_EDGES, FIELD, FIELD);
        read->grey = make(&picture, RASTER_BRIGHTNESS, read->width, read->height);
        if (!read->field || !read->grey) {
            read_finish(read);
            snprintf(pictures->error.text, sizeof pictures->error.text, "memory is short for '%.100s'", pictures->path);
        }
        free(picture.values);
    }
    atomic_store(&pictures->done, true);
    return NULL;
}

/* The next of the list, but what is grown over already. */
static const char *next_path(struct live_pictures *pictures)
{
    int count = pictures->list.count;
    const char *path = count > 0 ? pictures->list.paths[pictures->next % count] : NULL;
    if (count > 1 && pictures->shown && strcmp(path, pictures->shown) == 0) {
        pictures->next = (pictures->next + 1) % count;
        path = pictures->list.paths[pictures->next];
    }
    pictures->next = count > 0 ? (pictures->next + 1) % count : 0;
    return path;
}

/* Reads on, unless everything that there is has turned out not to be a picture. */
static void begin(struct live_pictures *pictures)
{
    if (pictures->reading || !pictures->folder || (!pictures->wanted && pictures->failures >= pictures->list.count)) {
        return;
    }
    const char *path = pictures->wanted ? pictures->wanted : next_path(pictures);
    free(pictures->path);
    pictures->path = path ? strdup(path) : NULL;
    atomic_store(&pictures->done, false);
    pictures->reading = pictures->path && pthread_create(&pictures->thread, NULL, read_picture, pictures) == 0;
}

/* Takes what the thread has left; with a line where it is nothing. */
static struct read end(struct live_pictures *pictures)
{
    pthread_join(pictures->thread, NULL);
    pictures->reading = false;
    if (!pictures->read.field) {
        snprintf(pictures->line, sizeof pictures->line, "picture left out: %s", pictures->error.text);
        pictures->has_line = true;
        pictures->failures++;
    } else {
        pictures->failures = 0;
    }
    if (pictures->wanted && strcmp(pictures->wanted, pictures->path) == 0) {
        free(pictures->wanted);
        pictures->wanted = NULL;
        pictures->failures = 0; /* it is not of the list */
    }
    return pictures->read;
}

static void abandon(struct live_pictures *pictures)
{
    if (pictures->reading) {
        struct read read = end(pictures);
        read_finish(&read);
    }
}

struct live_pictures *live_pictures_create(const struct exhibit *exhibit, const struct exhibit_scene *scene,
                                           const struct script_def *def)
{
    struct live_pictures *pictures = calloc(1, sizeof *pictures);
    if (pictures) {
        pictures->def = *def;
        live_pictures_set(pictures, exhibit, scene);
    }
    return pictures;
}

void live_pictures_destroy(struct live_pictures *pictures)
{
    if (!pictures) {
        return;
    }
    abandon(pictures);
    for (int i = 0; i < LIVE_PICTURES_KEPT; i++) {
        free(pictures->kept[i]);
        read_finish(&pictures->stocks[i]);
    }
    exhibit_pictures_finish(&pictures->list);
    free(pictures->folder);
    free(pictures->wanted);
    free(pictures->shown);
    free(pictures->path);
    free(pictures);
}

/* Nothing is grown over any more: what is comes. */
static void forget(struct live_pictures *pictures)
{
    free(pictures->shown);
    pictures->shown = NULL;
}

void live_pictures_set(struct live_pictures *pictures, const struct exhibit *exhibit, const struct exhibit_scene *scene)
{
    abandon(pictures); /* it may be gone: the list begins again */
    exhibit_pictures_finish(&pictures->list);
    free(pictures->folder);
    pictures->list = exhibit_pictures(exhibit);
    pictures->folder = strdup(exhibit->folder);
    pictures->next = pictures->failures = 0;
    forget(pictures);
    live_pictures_scene(pictures, scene);
}

void live_pictures_scene(struct live_pictures *pictures, const struct exhibit_scene *scene)
{
    const char *own = scene->kind == SCENE_TREES ? scene->picture : NULL;
    free(pictures->wanted);
    pictures->wanted = NULL;
    if (own && (!pictures->shown || strcmp(own, pictures->shown) != 0)) {
        pictures->wanted = strdup(own);
        forget(pictures);
    }
    begin(pictures);
}

/* Whether a picture has been read; it is then in `read`, and another one begins. */
static bool take(struct live_pictures *pictures, struct read *read)
{
    if (!pictures->reading || !atomic_load(&pictures->done)) {
        begin(pictures);
        return false;
    }
    *read = end(pictures);
    return read->field;
}

bool live_pictures_next(struct live_pictures *pictures, struct action *guide)
{
    struct read read;
    bool good = take(pictures, &read);
    begin(pictures);
    if (!good) {
        return false;
    }
    float **place = &pictures->kept[pictures->given++ % LIVE_PICTURES_KEPT];
    free(*place);
    *place = read.field;
    free(read.grey);
    *guide = action_default(ACTION_GUIDE);
    guide->picture = (struct action_raster){*place, FIELD, FIELD, raster_channels(RASTER_ALONG_EDGES)};
    guide->reading = READ_ALONG_EDGES;
    return true;
}

/* Another one is grown over. */
static bool take_stock(struct live_pictures *pictures)
{
    struct read read;
    bool wanted = pictures->wanted; /* what was read before it was wanted is not it */
    if (!take(pictures, &read)) {
        begin(pictures);
        return false;
    }
    if (wanted && pictures->wanted) {
        read_finish(&read);
        begin(pictures);
        return false;
    }
    struct read *place = &pictures->stocks[++pictures->stocked % LIVE_PICTURES_KEPT];
    read_finish(place);
    free(read.field);
    read.field = NULL;
    *place = read;
    forget(pictures);
    pictures->shown = strdup(pictures->path);
    begin(pictures);
    return true;
}

bool live_pictures_stock(struct live_pictures *pictures, bool next, struct action *stock)
{
    if ((next || !pictures->shown) && !take_stock(pictures)) {
        return false;
    }
    const struct read *read = &pictures->stocks[pictures->stocked % LIVE_PICTURES_KEPT];
    *stock = action_default(ACTION_STOCK);
    stock->picture = (struct action_raster){read->grey, read->width, read->height, 1};
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
