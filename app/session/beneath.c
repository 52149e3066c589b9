#include "beneath.h"

#include <errno.h>
#include <fcntl.h>
#include <stdbool.h>
#include <stdint.h>
#include <stdio.h>
#include <string.h>
#include <sys/syscall.h>
#include <unistd.h>

#include "session.h"

enum {
    FLAGS = O_RDONLY | O_CLOEXEC | O_NONBLOCK | O_NOCTTY,
    RESOLVE_NO_MAGIC = 0x02, /* openat2(2): RESOLVE_NO_MAGICLINKS */
    RESOLVE_INSIDE = 0x08,   /* RESOLVE_BENEATH */
};

struct how { /* struct open_how of openat2(2), which libc does not declare */
    uint64_t flags, mode, resolve;
};

static bool climbs(const char *path)
{
    for (const char *part = path; part; part = strchr(part, '/')) {
        part += *part == '/';
        if (strncmp(part, "..", 2) == 0 && (part[2] == '/' || part[2] == '\0')) {
            return true;
        }
    }
    return false;
}

/* Part by part, following no symbolic link at all. Takes `folder`. */
static int walk(int folder, const char *path)
{
    char part[256];
    while (folder >= 0) {
        path += strspn(path, "/");
        size_t length = strcspn(path, "/");
        if (length >= sizeof part) {
            close(folder);
            errno = ENAMETOOLONG;
            return -1;
        }
        memcpy(part, path, length);
        part[length] = '\0';
        path += length;
        bool last = path[strspn(path, "/")] == '\0';
        int next = openat(folder, part, last ? FLAGS | O_NOFOLLOW : O_RDONLY | O_DIRECTORY | O_NOFOLLOW | O_CLOEXEC);
        int code = errno;
        close(folder);
        errno = code;
        if (last) {
            return next;
        }
        folder = next;
    }
    return -1;
}

/* Sets errno. */
static int open_inside(const char *folder, const char *path)
{
    int fd = -1;
    int at = open(folder, O_RDONLY | O_DIRECTORY | O_CLOEXEC);
    if (at >= 0) {
#ifdef SYS_openat2
        struct how how = {.flags = FLAGS, .resolve = RESOLVE_INSIDE | RESOLVE_NO_MAGIC};
        fd = (int)syscall(SYS_openat2, at, path, &how, sizeof how);
        if (fd < 0 && (errno == ENOSYS || errno == EPERM)) { /* an old kernel, or a filter that knows it not */
            fd = walk(at, path);
        } else {
            int code = errno;
            close(at);
            errno = code;
        }
#else
        fd = walk(at, path);
#endif
    }
    return fd;
}

static int open_stock(const char *path)
{
    char stock[1200];
    const char *inside = path + strspn(path, "./");
    size_t word = strcspn(inside, "/");
    if (word != strlen("stock") || strncmp(inside, "stock", word) != 0 || !stock_find(stock, sizeof stock)) {
        errno = ENOENT;
        return -1;
    }
    inside += word + strspn(inside + word, "/");
    return open_inside(stock, *inside ? inside : ".");
}

int beneath_open(const char *folder, const char *path, const char *what, struct file_error *error)
{
    int fd = -1;
    if (*path == '\0' || *path == '/' || climbs(path)) {
        errno = EXDEV;
    } else if ((fd = open_inside(folder, path)) < 0 && errno == ENOENT) {
        fd = open_stock(path);
    }
    if (fd < 0 && (errno == EXDEV || errno == ELOOP)) {
        snprintf(error->text, sizeof error->text, "'%.100s' leads out of this file's folder; %s lies in it or below",
                 path, what);
    } else if (fd < 0 && (errno == ENOENT || errno == ENOTDIR)) {
        snprintf(error->text, sizeof error->text, "'%.100s' is not there; %s in this file's folder or below", path,
                 what);
    } else if (fd < 0) {
        snprintf(error->text, sizeof error->text, "'%.100s' cannot be read (%s); %s that Frond may read", path,
                 strerror(errno), what);
    }
    return fd;
}
