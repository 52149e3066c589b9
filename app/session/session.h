/* Where the sessions, exhibits and pictures that come with Frond are. */
#ifndef FROND_SESSION_H
#define FROND_SESSION_H

#include <stdbool.h>
#include <stddef.h>

/* The path of sessions/NAME.yaml: in config/ of the source tree that the program was built in, else in share/frond
 * beside the program, else where Frond was installed. False when there is none. */
bool session_find(const char *name, char *path, size_t size);
/* The same for exhibits/NAME.yaml. */
bool exhibit_find(const char *name, char *path, size_t size);

/* The folder `stock` of the pictures that come with Frond: beside the program as it was built, in share/frond beside
 * it, or where Frond was installed. False when it is not there. */
bool stock_find(char *path, size_t size);

#endif
