#include "keep_files.h"

#include <dirent.h>
#include <inttypes.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Reads exactly ten digits. */
static const char *read_number(const char *text, uint64_t *number)
{
    char digits[11] = "";
    if (strnlen(text, 10) < 10 || strspn(text, "0123456789") != 10) {
        return NULL;
    }
    memcpy(digits, text, 10);
    *number = strtoull(digits, NULL, 10);
    return text + 10;
}

static bool read_name(const char *name, struct keep_file *file)
{
    *file = (struct keep_file){.journal = strncmp(name, "journal-", 8) == 0};
    if (!file->journal && strncmp(name, "sheet-", 6) != 0) {
        return false;
    }
    name = read_number(name + (file->journal ? 8 : 6), &file->generation);
    if (name && !file->journal) {
        name = *name == '-' ? read_number(name + 1, &file->number) : NULL;
    }
    return name && strcmp(name, ".frond") == 0;
}

static int newest_first(const void *a, const void *b)
{
    const struct keep_file *left = a, *right = b;
    if (left->generation != right->generation) {
        return left->generation < right->generation ? 1 : -1;
    }
    return left->number < right->number ? 1 : left->number > right->number ? -1 : 0;
}

struct keep_files keep_files_list(const char *folder)
{
    struct keep_files files = {.count = 0};
    struct dirent *entry;
    DIR *all = opendir(folder);
    while (all && files.count < KEEP_FILES && (entry = readdir(all))) {
        files.count += read_name(entry->d_name, &files.files[files.count]);
    }
    if (all) {
        closedir(all);
    }
    qsort(files.files, (size_t)files.count, sizeof files.files[0], newest_first);
    return files;
}

bool keep_files_path(const char *folder, const struct keep_file *file, char path[KEEP_PATH])
{
    int length = file->journal ? snprintf(path, KEEP_PATH, "%s/journal-%010" PRIu64 ".frond", folder, file->generation)
                               : snprintf(path, KEEP_PATH, "%s/sheet-%010" PRIu64 "-%010" PRIu64 ".frond", folder,
                                          file->generation, file->number);
    return length > 0 && length < KEEP_PATH;
}

void keep_files_remove(const struct file_calls *calls, const char *folder, uint64_t generation, uint64_t least)
{
    struct dirent *entry;
    DIR *all = opendir(folder);
    while (all && (entry = readdir(all))) {
        struct keep_file file;
        bool old = read_name(entry->d_name, &file) &&
                   (file.generation != generation || (!file.journal && file.number < least));
        if (old || file_is_temporary(entry->d_name)) {
            calls->unlinkat(dirfd(all), entry->d_name, 0);
        }
    }
    if (all) {
        closedir(all);
    }
}
