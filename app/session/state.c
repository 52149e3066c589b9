#include "state.h"

#include <errno.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <sys/stat.h>

/* Makes the folder and those above it. */
static bool make_folders(char *path)
{
    for (char *slash = strchr(path + 1, '/'); slash; slash = strchr(slash + 1, '/')) {
        *slash = '\0';
        bool good = mkdir(path, 0777) == 0 || errno == EEXIST;
        *slash = '/';
        if (!good) {
            return false;
        }
    }
    return true;
}

bool state_path(const char *name, char *path, size_t size)
{
    const char *service = getenv("STATE_DIRECTORY"), *state = getenv("XDG_STATE_HOME"), *home = getenv("HOME");
    int length = -1;
    if (service && service[0] == '/') {
        length = snprintf(path, size, "%.*s/%s", (int)strcspn(service, ":"), service, name);
    } else if (state && state[0] == '/') {
        length = snprintf(path, size, "%s/frond/%s", state, name);
    } else if (home && home[0] == '/') {
        length = snprintf(path, size, "%s/.local/state/frond/%s", home, name);
    }
    return length > 0 && (size_t)length < size && make_folders(path);
}
