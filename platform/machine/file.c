#include "file.h"

#include <errno.h>
#include <fcntl.h>
#include <inttypes.h>
#include <stdarg.h>
#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/random.h>
#include <sys/stat.h>
#include <unistd.h>

enum {
    PATH_SHOWN = 200, /* bytes of a path in a message: room stays for the reason */
    TEMPORARY_NAME = 40,
    TEMPORARY_DIGITS = 16,
};

static const struct {
    int code;
    const char *reason;
} reasons[] = {
    {ENOENT, "there is no such file or folder"},
    {EACCES, "the permissions of the file or its folder forbid it"},
    {EPERM, "the permissions of the file or its folder forbid it"},
    {ENOSPC, "the disk is full"},
    {EDQUOT, "the disk is full"},
    {EROFS, "the disk is read-only"},
    {EIO, "the disk reports an error"},
    {EISDIR, "is a folder"},
    {ENOTDIR, "a part of its path is not a folder"},
    {ENAMETOOLONG, "the name is too long"},
    {ELOOP, "its symbolic links go in a circle"},
    {ENOMEM, "not enough memory"},
};

bool file_fail(struct file_error *error, const char *path, const char *reason, ...)
{
    if (!error) {
        return false;
    }
    size_t length = strlen(path);
    const char *cut = length > PATH_SHOWN ? "..." : "";
    const char *shown = length > PATH_SHOWN ? path + (length - PATH_SHOWN) : path;
    int start = snprintf(error->text, sizeof error->text, "%s%s: ", cut, shown);
    va_list arguments;
    va_start(arguments, reason);
    vsnprintf(error->text + start, sizeof error->text - (size_t)start, reason, arguments);
    va_end(arguments);
    for (char *c = error->text; *c; c++) {
        if ((unsigned char)*c < 0x20 || *c == 0x7f) {
            *c = '?';
        }
    }
    return false;
}

bool file_fail_code(struct file_error *error, const char *path, int code)
{
    for (size_t i = 0; i < sizeof reasons / sizeof reasons[0]; i++) {
        if (reasons[i].code == code) {
            return file_fail(error, path, "%s", reasons[i].reason);
        }
    }
    return file_fail(error, path, "%s", strerror(code));
}

bool file_write_whole(int fd, const void *data, size_t size)
{
    const char *at = data;
    while (size > 0) {
        ssize_t written = write(fd, at, size);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written < 0) {
            return false;
        }
        at += written;
        size -= (size_t)written;
    }
    return true;
}

bool file_make_folder(const char *path, struct file_error *error)
{
    struct stat status;
    char *whole = strdup(path);
    for (char *slash = whole && *whole ? strchr(whole + 1, '/') : NULL; slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        mkdir(whole, 0777); /* there, or told below */
        *slash = '/';
    }
    int code = !whole ? ENOMEM : mkdir(path, 0777) == 0 ? 0 : errno;
    free(whole);
    if (code == EEXIST) {
        code = stat(path, &status) != 0 ? errno : S_ISDIR(status.st_mode) ? 0 : ENOTDIR;
    }
    return code == 0 || file_fail_code(error, path, code);
}

/* Opens the folder that holds `path`; *name becomes the last part of the path. */
static int open_folder(const char *path, const char **name)
{
    const char *slash = strrchr(path, '/');
    *name = slash ? slash + 1 : path;
    if (**name == '\0') {
        errno = path[0] ? EISDIR : ENOENT;
        return -1;
    }
    if (!slash) {
        return open(".", O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    }
    char *folder = strndup(path, slash == path ? 1 : (size_t)(slash - path));
    if (!folder) {
        return -1;
    }
    int fd = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    int code = errno;
    free(folder);
    errno = code;
    return fd;
}

static int open_at(int folder, const char *path, int flags, mode_t mode)
{
    return openat(folder, path, flags, mode);
}

const struct file_calls file_calls_system = {open_at, pwrite, fdatasync, fsync, renameat, unlinkat};

bool file_pwrite_whole(const struct file_calls *calls, int fd, const void *data, size_t size, off_t at)
{
    const char *from = data;
    while (size > 0) {
        ssize_t written = calls->pwrite(fd, from, size, at);
        if (written < 0 && errno == EINTR) {
            continue;
        }
        if (written <= 0) {
            errno = written == 0 ? EIO : errno;
            return false;
        }
        from += written;
        at += written;
        size -= (size_t)written;
    }
    return true;
}

/* Some file systems (vfat over FUSE, for one) cannot sync a folder and say EINVAL: there is nothing more to do there.
 */
static bool sync_folder(const struct file_calls *calls, int folder)
{
    return calls->fsync(folder) == 0 || errno == EINVAL || errno == ENOTSUP;
}

/* Into a file that is made there; the code of errno. */
static int write_new(const struct file_calls *calls, int folder, const char *name, const void *data, size_t size)
{
    int fd = calls->openat(folder, name, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
    if (fd < 0) {
        return errno;
    }
    int code = file_pwrite_whole(calls, fd, data, size, 0) && calls->fsync(fd) == 0 ? 0 : errno;
    if (close(fd) != 0 && code == 0) {
        code = errno;
    }
    return code;
}

static const char TEMPORARY_START[] = ".frond-", TEMPORARY_END[] = ".part";

bool file_is_temporary(const char *name)
{
    size_t start = strlen(TEMPORARY_START);
    return strncmp(name, TEMPORARY_START, start) == 0 && strspn(name + start, "0123456789abcdef") == TEMPORARY_DIGITS &&
           strcmp(name + start + TEMPORARY_DIGITS, TEMPORARY_END) == 0;
}

int file_write_atomic_by(const struct file_calls *calls, const char *path, const void *data, size_t size)
{
    const char *name;
    uint64_t random = 0;
    char temporary[TEMPORARY_NAME];
    int folder = open_folder(path, &name);
    if (folder < 0) {
        return errno;
    }
    int code = getrandom(&random, sizeof random, 0) == (ssize_t)sizeof random ? 0 : errno;
    snprintf(temporary, sizeof temporary, "%s%0*" PRIx64 "%s", TEMPORARY_START, TEMPORARY_DIGITS, random,
             TEMPORARY_END);
    code = code ? code : write_new(calls, folder, temporary, data, size);
    bool named = code == 0 && calls->renameat(folder, temporary, folder, name) == 0;
    if (named) {
        code = sync_folder(calls, folder) ? 0 : errno;
    } else {
        code = code ? code : errno;
        calls->unlinkat(folder, temporary, 0);
    }
    close(folder);
    return code;
}

bool file_write_atomic(const char *path, const void *data, size_t size, struct file_error *error)
{
    int code = file_write_atomic_by(&file_calls_system, path, data, size);
    return code == 0 || file_fail_code(error, path, code);
}
