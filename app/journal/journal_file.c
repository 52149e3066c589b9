#include "journal_file.h"

#include <errno.h>
#include <fcntl.h>
#include <stdint.h>
#include <sys/stat.h>
#include <unistd.h>

static bool read_whole(int fd, struct bytes *bytes, size_t size)
{
    uint8_t *to = bytes_room(bytes, size + 1);
    while (to && bytes->size < size) {
        ssize_t got = read(fd, to + bytes->size, size - bytes->size);
        if (got < 0 && errno == EINTR) {
            continue;
        }
        if (got <= 0) {
            return got == 0; /* it has become shorter */
        }
        bytes->size += (size_t)got;
    }
    if (!to) {
        errno = ENOMEM;
    }
    return to;
}

bool journal_file_read(const char *path, size_t most, struct bytes *bytes, struct file_error *error)
{
    struct stat status;
    *bytes = (struct bytes){.data = NULL};
    int fd = open(path, O_RDONLY | O_CLOEXEC);
    if (fd < 0) {
        return file_fail_code(error, path, errno);
    }
    bool good = fstat(fd, &status) == 0;
    int code = errno;
    if (good && !S_ISREG(status.st_mode)) {
        good = false;
        code = S_ISDIR(status.st_mode) ? EISDIR : EINVAL;
    } else if (good && (uintmax_t)status.st_size > most) {
        close(fd);
        return file_fail(error, path, "is larger than %zu MiB", most >> 20);
    } else if (good) {
        good = read_whole(fd, bytes, (size_t)status.st_size);
        code = errno;
    }
    close(fd);
    if (!good) {
        bytes_finish(bytes);
    }
    return good || file_fail_code(error, path, code);
}
