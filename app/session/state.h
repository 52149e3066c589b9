/* The one folder that Frond writes to: that of its service ($STATE_DIRECTORY), else $XDG_STATE_HOME/frond, else
 * ~/.local/state/frond. */
#ifndef FROND_STATE_H
#define FROND_STATE_H

#include <stdbool.h>
#include <stddef.h>

/* The path of `name` in it ("" is the folder itself), which is made where it is not there. False when there is no such
 * place, or it cannot be made. */
bool state_path(const char *name, char *path, size_t size);

#endif
