/* Whether the desktop that a window stands on is still there. An X server that has gone is told by nobody: Xlib ends
 * the process at its next call, and Mesa, where it draws with the processor, never comes back from presenting a frame.
 * Wayland's end comes from SDL, as an event. Private to platform/display*.c. */
#ifndef FROND_DESKTOP_LINK_H
#define FROND_DESKTOP_LINK_H

#include <stdbool.h>

struct SDL_Window;

/* The descriptor of the connection to the X server, SDL's own; it is readable when an event has come, too. -1: it is no
 * X server. */
int desktop_link(struct SDL_Window *window);
/* Whether the other end has gone; of -1 false. From then on neither SDL nor EGL may be asked for anything of that
 * window. */
bool desktop_link_is_cut(int link);

#endif
