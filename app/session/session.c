#include "session.h"

#include <stdio.h>
#include <string.h>
#include <unistd.h>

enum { TREE_DEPTH = 4 }; /* folders from the program up to the root of a source tree: build/release/ is two */

static bool is_there(const char *folder, const char *file, char *path, size_t size)
{
    int length = snprintf(path, size, "%s/%s", folder, file);
    return length > 0 && (size_t)length < size && access(path, R_OK) == 0;
}

static bool find(const char *file, char *path, size_t size)
{
    char program[1024], folder[1100];
    ssize_t length = readlink("/proc/self/exe", program, sizeof program - 1);
    program[length > 0 ? length : 0] = '\0';
    char *slash = strrchr(program, '/');
    if (slash) {
        *slash = '\0';
        snprintf(folder, sizeof folder, "%s/../share/frond", program);
        if (is_there(folder, file, path, size)) {
            return true;
        }
    }
    for (int i = 0; slash && i < TREE_DEPTH; i++) {
        snprintf(folder, sizeof folder, "%s/config", program);
        if (is_there(folder, file, path, size)) {
            return true;
        }
        slash = strrchr(program, '/');
        if (slash) {
            *slash = '\0';
        }
    }
    return is_there(FROND_SHARE, file, path, size);
}

static bool find_yaml(const char *kind, const char *name, char *path, size_t size)
{
    char file[256];
    int length = snprintf(file, sizeof file, "%s/%s.yaml", kind, name);
    return length > 0 && (size_t)length < sizeof file && find(file, path, size);
}

bool session_find(const char *name, char *path, size_t size)
{
    return find_yaml("sessions", name, path, size);
}

bool exhibit_find(const char *name, char *path, size_t size)
{
    return find_yaml("exhibits", name, path, size);
}

bool stock_find(char *path, size_t size)
{
    return find("stock", path, size);
}
