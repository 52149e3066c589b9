#include "desktop_link.h"

#include <poll.h>

#include <SDL_syswm.h>

int desktop_link(struct SDL_Window *window)
{
    SDL_SysWMinfo info;
    SDL_VERSION(&info.version);
    bool x11 = SDL_GetWindowWMInfo(window, &info) && info.subsystem == SDL_SYSWM_X11;
    return x11 ? ConnectionNumber(info.info.x11.display) : -1;
}

bool desktop_link_is_cut(int link)
{
    struct pollfd end = {.fd = link};
    return poll(&end, 1, 0) == 1 && (end.revents & (POLLHUP | POLLERR));
}
