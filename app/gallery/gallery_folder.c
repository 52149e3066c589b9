#include "gallery_folder.h"

#include <dirent.h>
#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>
#include <time.h>
#include <unistd.h>

enum { PATH_MOST = 4096, DIGITS_LEAST = 6, DIGITS_MOST = 9 };

const char *const gallery_endings[GALLERY_PARTS] = {
    [GALLERY_PNG] = ".png", [GALLERY_SVG] = ".svg", [GALLERY_JOURNAL] = ".journal"};

static const char PREFIX[] = "frond-", DIGITS[] = "0123456789";

/* "-20260115-143005" */
static size_t time_length(const char *at)
{
    bool there = at[0] == '-' && strspn(at + 1, DIGITS) == 8 && at[9] == '-' && strspn(at + 10, DIGITS) == 6;
    return there ? 16 : 0;
}

bool gallery_parse(const char *name, struct gallery_entry *entry)
{
    size_t prefix = strlen(PREFIX);
    if (strncmp(name, PREFIX, prefix) != 0) {
        return false;
    }
    size_t digits = strspn(name + prefix, DIGITS);
    if (digits < DIGITS_LEAST || digits > DIGITS_MOST) {
        return false;
    }
    size_t stem = prefix + digits + time_length(name + prefix + digits);
    for (int part = 0; part < GALLERY_PARTS; part++) {
        if (strcmp(name + stem, gallery_endings[part]) == 0) {
            *entry = (struct gallery_entry){.number = strtol(name + prefix, NULL, 10), .parts = 1U << (unsigned)part};
            memcpy(entry->stem, name, stem);
            return true;
        }
    }
    return false;
}

void gallery_stem(int64_t number, int64_t unix_s, char stem[GALLERY_NAME])
{
    time_t seconds = (time_t)unix_s;
    struct tm local;
    int length = snprintf(stem, GALLERY_NAME, "%s%06" PRId64, PREFIX, number);
    if (unix_s >= GALLERY_CLOCK_LEAST && localtime_r(&seconds, &local) && local.tm_year < 8100) {
        strftime(stem + length, (size_t)(GALLERY_NAME - length), "-%Y%m%d-%H%M%S", &local);
    }
}

void gallery_shelf_finish(struct gallery_shelf *shelf)
{
    free(shelf->entries);
    *shelf = (struct gallery_shelf){0};
}

int gallery_shelf_pictures(const struct gallery_shelf *shelf)
{
    int count = 0;
    for (int i = 0; i < shelf->count; i++) {
        count += (shelf->entries[i].parts & 1U << GALLERY_PNG) != 0;
    }
    return count;
}

static bool add(struct gallery_shelf *shelf, const struct gallery_entry *entry)
{
    if (shelf->count == shelf->size) {
        int size = shelf->size ? 2 * shelf->size : 64;
        struct gallery_entry *larger = realloc(shelf->entries, (size_t)size * sizeof *larger);
        if (!larger) {
            return false;
        }
        shelf->entries = larger;
        shelf->size = size;
    }
    shelf->entries[shelf->count++] = *entry;
    shelf->bytes += entry->bytes;
    return true;
}

static int by_number(const void *a, const void *b)
{
    const struct gallery_entry *one = a, *other = b;
    int order = (one->number > other->number) - (one->number < other->number);
    return order ? order : strcmp(one->stem, other->stem);
}

/* Files of one stem become one entry. */
static void join(struct gallery_shelf *shelf)
{
    int count = 0;
    if (shelf->count > 0) {
        qsort(shelf->entries, (size_t)shelf->count, sizeof *shelf->entries, by_number);
    }
    for (int i = 0; i < shelf->count; i++) {
        struct gallery_entry *last = count > 0 ? &shelf->entries[count - 1] : NULL;
        if (last && strcmp(last->stem, shelf->entries[i].stem) == 0) {
            last->parts |= shelf->entries[i].parts;
            last->bytes += shelf->entries[i].bytes;
        } else {
            shelf->entries[count++] = shelf->entries[i];
        }
    }
    shelf->count = count;
}

bool gallery_scan(const char *folder, struct gallery_shelf *shelf, struct file_error *error)
{
    gallery_shelf_finish(shelf);
    DIR *all = opendir(folder);
    if (!all) {
        return file_fail_code(error, folder, errno);
    }
    bool good = true;
    errno = 0;
    for (struct dirent *item; good && (item = readdir(all)); errno = 0) {
        struct gallery_entry entry;
        struct stat status;
        if (gallery_parse(item->d_name, &entry) &&
            fstatat(dirfd(all), item->d_name, &status, AT_SYMLINK_NOFOLLOW) == 0 && S_ISREG(status.st_mode)) {
            entry.bytes = status.st_size;
            good = add(shelf, &entry) || file_fail_code(error, folder, ENOMEM);
        }
    }
    if (good && errno != 0) {
        good = file_fail_code(error, folder, errno);
    }
    closedir(all);
    join(shelf);
    if (!good) {
        gallery_shelf_finish(shelf);
    }
    return good;
}

bool gallery_remove(const char *folder, const char *stem, struct file_error *error)
{
    char path[PATH_MOST];
    bool good = true;
    for (int part = 0; part < GALLERY_PARTS; part++) {
        snprintf(path, sizeof path, "%s/%s%s", folder, stem, gallery_endings[part]);
        if (unlink(path) != 0 && errno != ENOENT && good) {
            good = file_fail_code(error, path, errno);
        }
    }
    return good;
}

bool gallery_trim(const char *folder, struct gallery_shelf *shelf, int entries, int64_t bytes, struct file_error *error)
{
    int gone = 0;
    bool good = true;
    while (gone < shelf->count && (shelf->count - gone > entries || shelf->bytes > bytes)) {
        good = gallery_remove(folder, shelf->entries[gone].stem, error);
        if (!good) {
            break;
        }
        shelf->bytes -= shelf->entries[gone++].bytes;
    }
    if (gone > 0) {
        shelf->count -= gone;
        memmove(shelf->entries, shelf->entries + gone, (size_t)shelf->count * sizeof *shelf->entries);
    }
    return good;
}

void gallery_sweep(const char *folder)
{
    DIR *all = opendir(folder);
    for (struct dirent *item; all && (item = readdir(all));) {
        if (file_is_temporary(item->d_name)) {
            unlinkat(dirfd(all), item->d_name, 0);
        }
    }
    if (all) {
        closedir(all);
    }
}
