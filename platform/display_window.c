#include "display_source.h"

static bool window_create(struct display *display, struct display_error *error)
{
    (void)display;
    return display_fail(error, "window: not in this build");
}

static void window_destroy(struct display *display)
{
    (void)display;
}

const struct display_source display_window = {
    .kind = DISPLAY_WINDOW, .create = window_create, .destroy = window_destroy};
