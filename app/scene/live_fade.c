#include "live_fade.h"

#include <math.h>

#include "live_drawer.h"

void live_fade_part(struct live_fade *fade, bool shown, bool same)
{
    if (shown) {
        fade->gone = fade->come;
        fade->hold_s = LIVE_CHANGE_S;
        fade->same = same;
    }
    fade->come = 0;
}

void live_fade_go_on(struct live_fade *fade, bool shown, double now_s)
{
    double frame_s = fmin(now_s - fade->last_s, LIVE_CHANGE_S);
    bool there = fade->same && shown && fade->gone > 0;
    if (there || fade->hold_s <= 0) {
        fade->gone = fmax(fade->gone - frame_s / LIVE_SHEET_S, 0);
    }
    fade->come = there ? 1 : shown ? fmin(fade->come + frame_s / LIVE_CHANGE_S, 1) : 0;
    fade->hold_s = fmax(fade->hold_s - frame_s, 0);
    fade->last_s = now_s;
}

bool live_fade_moves(const struct live_fade *fade, bool shown)
{
    return fade->gone > 0 || (shown && fade->come < 1);
}

float live_fade_share(double share)
{
    return (float)(share * share * (3 - 2 * share));
}
