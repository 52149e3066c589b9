#include "state.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>

#include "file.h"

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
    if (length <= 0 || (size_t)length >= size) {
        return false;
    }
    char *slash = strrchr(path, '/');
    *slash = '\0';
    bool made = file_make_folder(path, NULL);
    *slash = '/';
    return made;
}
