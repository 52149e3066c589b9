#include "bolt_light.h"

bool bolt_light_lay(const struct bolt_view *view, double tick, int width, int height, uint8_t *rgb)
{
    (void)view, (void)tick, (void)width, (void)height, (void)rgb;
    return true;
}
