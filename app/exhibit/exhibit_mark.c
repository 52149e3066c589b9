#include "exhibit_mark.h"

#include <dirent.h>
#include <fcntl.h>
#include <string.h>
#include <sys/stat.h>
#include <unistd.h>

#include "hash.h"

/* Of a file: its time and its size; of one that is not there, that. */
static uint64_t mark_file(uint64_t mark, int folder, const char *name)
{
    struct stat status;
    mark = hash_bytes(mark, name, strlen(name) + 1);
    if (fstatat(folder, name, &status, 0) != 0) {
        return hash_bytes(mark, "-", 1);
    }
    mark = hash_bytes(mark, &status.st_mtim.tv_sec, sizeof status.st_mtim.tv_sec);
    mark = hash_bytes(mark, &status.st_mtim.tv_nsec, sizeof status.st_mtim.tv_nsec);
    return hash_bytes(mark, &status.st_size, sizeof status.st_size);
}

/* Of all the files of a folder, in whatever order. */
static uint64_t mark_folder(uint64_t mark, int at, const char *path)
{
    int fd = openat(at, path, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    DIR *folder = fd >= 0 ? fdopendir(fd) : NULL;
    uint64_t sum = 0;
    for (struct dirent *entry; folder && (entry = readdir(folder));) {
        sum += entry->d_name[0] == '.' ? 0 : mark_file(mark, fd, entry->d_name);
    }
    if (folder) {
        closedir(folder);
    } else if (fd >= 0) {
        close(fd);
    }
    return hash_bytes(mark, &sum, sizeof sum);
}

uint64_t exhibit_mark(const char *path, const struct exhibit *exhibit)
{
    uint64_t mark = mark_file(HASH_START, AT_FDCWD, path);
    int folder = open(exhibit->folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (folder < 0) {
        return mark;
    }
    if (exhibit->pictures) {
        mark = mark_folder(mark, folder, exhibit->pictures);
    }
    for (int i = 0; i < exhibit->session_count; i++) {
        mark = mark_file(mark, folder, exhibit->sessions[i]);
    }
    for (int i = 0; i < exhibit->scene_count; i++) {
        const struct exhibit_scene *scene = &exhibit->scenes[i];
        mark = scene->guide ? mark_file(mark, folder, scene->guide) : mark;
        mark = scene->picture ? mark_file(mark, folder, scene->picture) : mark;
        mark = scene->mask ? mark_file(mark, folder, scene->mask) : mark;
    }
    for (int i = 0; i < exhibit->file_count; i++) {
        int within = open(exhibit->files[i].folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
        mark = within >= 0 ? mark_file(mark, within, exhibit->files[i].path) : hash_bytes(mark, "-", 1);
        if (within >= 0) {
            close(within);
        }
    }
    close(folder);
    return mark;
}
