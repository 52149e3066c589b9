#include "gallery.h"

#include <errno.h>
#include <fcntl.h>
#include <pthread.h>
#include <signal.h>
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "gallery_write.h"
#include "image.h"
#include "ink.h"

enum { LINES = 4, PATH_MOST = 4096 };

struct gallery {
    struct gallery_def def; /* its texts are owned */
    pthread_t thread;
    pthread_mutex_t lock; /* of all below */
    pthread_cond_t wake;
    bool end, working;
    struct gallery_work waiting[GALLERY_WAITING]; /* the oldest first */
    int waiting_count;
    struct gallery_shelf shelf;
    int64_t last; /* highest number that was ever given */
    bool failing; /* the last picture could not be kept */
    char lines[LINES][GALLERY_LINE];
    int line_count;
    char wanted[GALLERY_NAME]; /* "": none */
    bool got;
    uint8_t *got_rgb;
    int got_width, got_height;
};

/* The oldest lines are worth more: they say how it began. */
__attribute__((format(printf, 2, 3))) static void say(struct gallery *gallery, const char *format, ...)
{
    if (gallery->line_count < LINES) {
        va_list arguments;
        va_start(arguments, format);
        vsnprintf(gallery->lines[gallery->line_count++], GALLERY_LINE, format, arguments);
        va_end(arguments);
    }
}

static void judge(struct gallery *gallery, bool good, const struct file_error *error)
{
    if (!good && !gallery->failing) {
        say(gallery, "gallery: %.180s; pictures are not kept until that is mended", error->text);
    } else if (good && gallery->failing) {
        say(gallery, "gallery: pictures are kept again");
    }
    gallery->failing = !good;
}

static int64_t next_number(struct gallery *gallery, const struct gallery_shelf *shelf)
{
    int64_t highest = shelf->count > 0 ? shelf->entries[shelf->count - 1].number : 0;
    pthread_mutex_lock(&gallery->lock);
    gallery->last = (highest > gallery->last ? highest : gallery->last) + 1;
    gallery->last = gallery->last > GALLERY_NUMBER_MAX ? GALLERY_NUMBER_MAX : gallery->last;
    int64_t number = gallery->last;
    pthread_mutex_unlock(&gallery->lock);
    return number;
}

/* On the thread, without the lock. */
static void keep(struct gallery *gallery, struct gallery_work *work)
{
    const struct gallery_def *def = &gallery->def;
    struct gallery_shelf shelf = {0};
    struct file_error error = {""};
    char stem[GALLERY_NAME];
    bool good = file_make_folder(def->folder, &error) && gallery_scan(def->folder, &shelf, &error);
    bool seen = good;
    if (good) {
        gallery_stem(next_number(gallery, &shelf), work->picture.unix_s, stem);
        good = gallery_write(def, work, stem, &error);
        if (good) {
            good = seen = gallery_scan(def->folder, &shelf, &error);
        }
        good = good && gallery_trim(def->folder, &shelf, def->pictures, def->bytes, &error);
        if (good && shelf.count == 0) {
            good = file_fail(&error, def->folder, "one picture is more than the gallery may hold");
        }
    }
    pthread_mutex_lock(&gallery->lock);
    judge(gallery, good, &error);
    if (seen) { /* else the disk did not say what is there */
        gallery_shelf_finish(&gallery->shelf);
        gallery->shelf = shelf;
    }
    pthread_mutex_unlock(&gallery->lock);
    gallery_work_finish(work);
}

/* On the thread, without the lock. */
static void look_first(struct gallery *gallery)
{
    struct gallery_shelf shelf = {0};
    struct file_error error = {""};
    bool good = file_make_folder(gallery->def.folder, &error);
    if (good) {
        gallery_sweep(gallery->def.folder);
        good = gallery_scan(gallery->def.folder, &shelf, &error);
    }
    pthread_mutex_lock(&gallery->lock);
    judge(gallery, good, &error);
    gallery->shelf = shelf;
    pthread_mutex_unlock(&gallery->lock);
}

static uint8_t *to_bytes(const struct image *image)
{
    size_t pixels = (size_t)image->width * (size_t)image->height;
    uint8_t *rgb = malloc(3 * pixels);
    for (size_t i = 0; rgb && i < pixels; i++) {
        const float *from = image->values + i * (size_t)image->channels;
        for (int c = 0; c < 3; c++) {
            rgb[3 * i + (size_t)c] = (uint8_t)(ink_encode(from[image->channels < 3 ? 0 : c]) * 255 + 0.5f);
        }
    }
    return rgb;
}

/* Nothing where it cannot be read. */
static void read_picture(const char *path, const char *helper, uint8_t **rgb, int *width, int *height)
{
    struct image_def def = image_default_def();
    struct image image;
    def.helper = helper;
    *rgb = image_read(path, &def, &image, NULL) ? to_bytes(&image) : NULL;
    *width = *rgb ? image.width : 0;
    *height = *rgb ? image.height : 0;
    image_finish(&image);
}

/* On the thread, without the lock. */
static void show(struct gallery *gallery, const char *name)
{
    char path[PATH_MOST];
    uint8_t *rgb = NULL;
    int width = 0, height = 0;
    snprintf(path, sizeof path, "%s/%s", gallery->def.folder, name);
    read_picture(path, gallery->def.helper, &rgb, &width, &height);
    pthread_mutex_lock(&gallery->lock);
    free(gallery->got_rgb);
    gallery->got_rgb = rgb;
    gallery->got_width = width;
    gallery->got_height = height;
    gallery->got = gallery->wanted[0] == '\0'; /* nothing else is wanted meanwhile */
    pthread_mutex_unlock(&gallery->lock);
}

static void *work_on(void *data)
{
    struct gallery *gallery = data;
    look_first(gallery);
    pthread_mutex_lock(&gallery->lock);
    while (!gallery->end || gallery->waiting_count > 0) {
        gallery->working = true;
        if (gallery->waiting_count > 0) {
            struct gallery_work work = gallery->waiting[0];
            gallery->waiting_count--;
            memmove(gallery->waiting, gallery->waiting + 1, (size_t)gallery->waiting_count * sizeof *gallery->waiting);
            pthread_mutex_unlock(&gallery->lock);
            keep(gallery, &work);
            pthread_mutex_lock(&gallery->lock);
        } else if (gallery->wanted[0]) {
            char name[GALLERY_NAME];
            memcpy(name, gallery->wanted, sizeof name);
            gallery->wanted[0] = '\0';
            pthread_mutex_unlock(&gallery->lock);
            show(gallery, name);
            pthread_mutex_lock(&gallery->lock);
        } else {
            gallery->working = false;
            pthread_cond_wait(&gallery->wake, &gallery->lock);
        }
    }
    gallery->working = false;
    pthread_mutex_unlock(&gallery->lock);
    return NULL;
}

static void free_all(struct gallery *gallery)
{
    for (int i = 0; i < gallery->waiting_count; i++) {
        gallery_work_finish(&gallery->waiting[i]);
    }
    pthread_cond_destroy(&gallery->wake);
    pthread_mutex_destroy(&gallery->lock);
    gallery_shelf_finish(&gallery->shelf);
    free(gallery->got_rgb);
    free((char *)(uintptr_t)gallery->def.folder);
    free((char *)(uintptr_t)gallery->def.helper);
    free(gallery);
}

/* Signals are for the thread that has the loop. */
static bool start_thread(struct gallery *gallery)
{
    sigset_t all, before;
    sigfillset(&all);
    pthread_sigmask(SIG_SETMASK, &all, &before);
    int status = pthread_create(&gallery->thread, NULL, work_on, gallery);
    pthread_sigmask(SIG_SETMASK, &before, NULL);
    return status == 0;
}

struct gallery *gallery_create(const struct gallery_def *def)
{
    struct gallery *gallery = calloc(1, sizeof *gallery);
    if (!gallery) {
        return NULL;
    }
    pthread_mutex_init(&gallery->lock, NULL);
    pthread_cond_init(&gallery->wake, NULL);
    gallery->def = *def;
    gallery->def.folder = strdup(def->folder);
    gallery->def.helper = def->helper ? strdup(def->helper) : NULL;
    bool good = gallery->def.folder && (gallery->def.helper || !def->helper);
    if (good) {
        gallery->working = true;
        good = start_thread(gallery);
    }
    if (!good) {
        free_all(gallery);
        return NULL;
    }
    return gallery;
}

void gallery_destroy(struct gallery *gallery)
{
    if (!gallery) {
        return;
    }
    pthread_mutex_lock(&gallery->lock);
    gallery->end = true;
    pthread_cond_signal(&gallery->wake);
    pthread_mutex_unlock(&gallery->lock);
    pthread_join(gallery->thread, NULL);
    free_all(gallery);
}

bool gallery_keep(struct gallery *gallery, const struct gallery_picture *picture)
{
    struct gallery_work work = {.picture = *picture, .journal = -1};
    struct file_error error;
    work.picture.journal = NULL;
    if (picture->journal) {
        work.journal = open(picture->journal, O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY);
        if (work.journal < 0) {
            file_fail_code(&error, picture->journal, errno);
        }
    }
    pthread_mutex_lock(&gallery->lock);
    bool taken = gallery->waiting_count < GALLERY_WAITING;
    if (picture->journal && work.journal < 0) {
        say(gallery, "gallery: %.180s; a picture is kept without its journal", error.text);
    }
    if (!taken) {
        say(gallery, "gallery: %d pictures wait to be written; one more is not kept", GALLERY_WAITING);
    } else {
        gallery->waiting[gallery->waiting_count++] = work;
        pthread_cond_signal(&gallery->wake);
    }
    pthread_mutex_unlock(&gallery->lock);
    if (!taken) {
        gallery_work_finish(&work);
    }
    return taken;
}

bool gallery_log(struct gallery *gallery, char line[GALLERY_LINE])
{
    pthread_mutex_lock(&gallery->lock);
    bool have = gallery->line_count > 0;
    if (have) {
        memcpy(line, gallery->lines[0], GALLERY_LINE);
        gallery->line_count--;
        memmove(gallery->lines, gallery->lines + 1, (size_t)gallery->line_count * GALLERY_LINE);
    }
    pthread_mutex_unlock(&gallery->lock);
    return have;
}

int gallery_count(struct gallery *gallery)
{
    pthread_mutex_lock(&gallery->lock);
    int count = gallery_shelf_pictures(&gallery->shelf);
    pthread_mutex_unlock(&gallery->lock);
    return count;
}

bool gallery_busy(struct gallery *gallery)
{
    pthread_mutex_lock(&gallery->lock);
    bool busy = gallery->working || gallery->waiting_count > 0 || gallery->wanted[0];
    pthread_mutex_unlock(&gallery->lock);
    return busy;
}

int gallery_list(struct gallery *gallery, char (*names)[GALLERY_NAME], int most)
{
    int count = 0;
    pthread_mutex_lock(&gallery->lock);
    for (int i = gallery->shelf.count - 1; i >= 0 && count < most; i--) {
        const struct gallery_entry *entry = &gallery->shelf.entries[i];
        if (entry->parts & 1U << GALLERY_PNG) {
            snprintf(names[count++], GALLERY_NAME, "%.56s%s", entry->stem, gallery_endings[GALLERY_PNG]);
        }
    }
    pthread_mutex_unlock(&gallery->lock);
    return count;
}

void gallery_want(struct gallery *gallery, const char *name)
{
    struct gallery_entry entry;
    if (!gallery_parse(name, &entry)) { /* no way out of the folder */
        return;
    }
    pthread_mutex_lock(&gallery->lock);
    snprintf(gallery->wanted, sizeof gallery->wanted, "%s", name);
    gallery->got = false;
    pthread_cond_signal(&gallery->wake);
    pthread_mutex_unlock(&gallery->lock);
}

bool gallery_got(struct gallery *gallery, uint8_t **rgb, int *width, int *height)
{
    pthread_mutex_lock(&gallery->lock);
    bool got = gallery->got;
    if (got) {
        *rgb = gallery->got_rgb;
        *width = gallery->got_width;
        *height = gallery->got_height;
        gallery->got_rgb = NULL;
        gallery->got = false;
    }
    pthread_mutex_unlock(&gallery->lock);
    return got;
}
