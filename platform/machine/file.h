/* Files written so that a pulled plug leaves the old one or the new one, never half of one; and what to tell a curator
 * when a file is at fault. */
#ifndef FROND_FILE_H
#define FROND_FILE_H

#include <stdbool.h>
#include <stddef.h>
#include <sys/types.h>

enum {
    FILE_ERROR_TEXT = 512, /* bytes, with the final NUL */
};

/* What went wrong with which file: "petals.png: there is no such file". One line, no control characters. */
struct file_error {
    char text[FILE_ERROR_TEXT];
};

/* Writes "PATH: REASON" into `error`, which may be NULL. A path too long to show is shown by its end. Always returns
 * false, so that a caller can `return file_fail(...)`. */
bool file_fail(struct file_error *error, const char *path, const char *reason, ...)
    __attribute__((format(printf, 3, 4)));
/* The same for a value of errno, in the words of a curator where there are any. */
bool file_fail_code(struct file_error *error, const char *path, int code);

/* Writes all of it to an open descriptor; false with errno. */
bool file_write_whole(int fd, const void *data, size_t size);

/* Makes `path` hold exactly these bytes: a temporary in the same folder, fsync, rename, fsync of the folder. A file of
 * that name is replaced (a symbolic link too, not what it points to). On failure the old file is as it was and nothing
 * is left behind. The mode is 0666 less the umask. Costs two waits for the disk; callers with a frame to show use
 * another thread. */
bool file_write_atomic(const char *path, const void *data, size_t size, struct file_error *error);

/* Whether a file of this name is a temporary of file_write_atomic: found where nobody writes, it is what a pulled plug
 * has left, and may go. */
bool file_is_temporary(const char *name);

/* Makes a folder, and those above it; one that is there already is as good. */
bool file_make_folder(const char *path, struct file_error *error);

/* What writing asks of the system, so that a test can have a disk that fails. Each as the call of its name. */
struct file_calls {
    int (*openat)(int folder, const char *path, int flags, mode_t mode);
    ssize_t (*pwrite)(int fd, const void *data, size_t size, off_t at);
    int (*fdatasync)(int fd);
    int (*fsync)(int fd);
    int (*renameat)(int from_folder, const char *from, int to_folder, const char *to);
    int (*unlinkat)(int folder, const char *path, int flags);
};

extern const struct file_calls file_calls_system;

/* Writes all of it at an offset; false with errno. */
bool file_pwrite_whole(const struct file_calls *calls, int fd, const void *data, size_t size, off_t at);
/* file_write_atomic through these calls. The code of errno; 0: done. */
int file_write_atomic_by(const struct file_calls *calls, const char *path, const void *data, size_t size);

#endif
