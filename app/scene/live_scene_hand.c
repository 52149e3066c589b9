#include "hand.h"
#include "live_scene_state.h"

bool live_scene_hand(struct live_scene *live, int number)
{
    pthread_mutex_lock(&live->lock);
    bool any = live->sheet.kind != SCENE_PAINTING && live->epoch == live->taken_epoch;
    if (any) {
        live->hands = true;
        live->hand_number = number;
        pthread_cond_broadcast(&live->changed);
    }
    pthread_mutex_unlock(&live->lock);
    return any;
}

bool live_scene_handed(struct live_scene *live, int *number, struct outcome *outcome)
{
    pthread_mutex_lock(&live->lock);
    bool any = live->has_handed;
    if (any) {
        *number = live->handed_of;
        *outcome = live->handed;
        live->handed = (struct outcome){.width = 0};
        live->has_handed = false;
    }
    pthread_mutex_unlock(&live->lock);
    return any;
}

void live_scene_make_hand(struct live_scene *live)
{
    struct outcome outcome = {.width = 0};
    int number = live->hand_number, wide = live->scene_width, high = live->scene_height;
    int longer = wide > high ? wide : high, side = longer < HAND_SIDE ? longer : HAND_SIDE;
    bool good = live->scene && longer > 0;
    live->hands = false;
    live->works = true;
    pthread_mutex_unlock(&live->lock);
    if (good) {
        int width = (int)((int64_t)wide * side / longer), height = (int)((int64_t)high * side / longer);
        good = outcome_of_scene(&outcome, live->types[live->kind], live->scene, width > 0 ? width : 1,
                                height > 0 ? height : 1);
    }
    pthread_mutex_lock(&live->lock);
    live->works = false;
    if (good) {
        outcome_finish(&live->handed);
        live->handed = outcome;
        live->handed_of = number;
        live->has_handed = true;
    }
}
