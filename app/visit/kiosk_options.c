/* What is set in a scene that is no painting: by its file, by dials, by the palette and its map. */
#include <math.h>

#include "hud_map.h"
#include "hud_told.h"
#include "kiosk_state.h"

enum scene_kind kiosk_kind(const struct kiosk *kiosk)
{
    return (enum scene_kind)kiosk_scene(kiosk)->kind;
}

static void post_options(struct kiosk *kiosk)
{
    struct action actions[SCENE_OPTIONS_ACTIONS];
    int count = kiosk_kind(kiosk) == SCENE_PAINTING ? 0 : scene_options_actions(&kiosk->options, actions);
    for (int i = 0; i < count; i++) {
        kiosk_post(kiosk, &actions[i], 0);
    }
}

void kiosk_stand_dials(struct kiosk *kiosk)
{
    hud_map_stand(&kiosk->hud, &kiosk->options);
    if (kiosk->controls) {
        controls_options(kiosk->controls, kiosk_kind(kiosk) == SCENE_PAINTING ? NULL : &kiosk->options);
    }
}

void kiosk_lay_options(struct kiosk *kiosk)
{
    kiosk->options = kiosk_scene(kiosk)->options;
    kiosk_stand_dials(kiosk);
    post_options(kiosk);
}

static const struct key *options_of(const struct kiosk *kiosk)
{
    return scene_options_keys(kiosk_kind(kiosk));
}

static bool sets_option(const struct kiosk *kiosk, const struct action *action)
{
    enum scene_kind kind = kiosk_kind(kiosk);
    return kind != SCENE_PAINTING && action->verb == scene_types[kind]->sets;
}

void kiosk_take_option(struct kiosk *kiosk, const struct action *action, uint64_t now_us)
{
    if (sets_option(kiosk, action)) {
        const struct key *key = &options_of(kiosk)[action->option];
        scene_option_take(&kiosk->options, action->option, action->value);
        if (scene_option_brings(kiosk_kind(kiosk), key)) {
            kiosk_stand_dials(kiosk);
        }
        hud_map_stand(&kiosk->hud, &kiosk->options);
        hud_tell(&kiosk->hud, key, scene_option_value(&kiosk->options, action->option), now_us);
    } else if (action->verb == ACTION_SET && !action->formula.values && !action->picture.values) {
        hud_tell(&kiosk->hud, &coefficient_keys[action->coefficient], action->value, now_us);
    }
}

void kiosk_tell_dials(struct kiosk *kiosk, uint64_t now_us)
{
    const struct key *key;
    float value;
    while (kiosk->controls && controls_dialled(kiosk->controls, &key, &value)) {
        visit_feel(&kiosk->visit, VISIT_HOLD, now_us);
        if (visit_paints(&kiosk->visit)) {
            hud_tell(&kiosk->hud, key, value, now_us);
        }
    }
}

void kiosk_change_options(struct kiosk *kiosk, const struct scene_options *before)
{
    const struct scene_options *options = &kiosk_scene(kiosk)->options;
    const struct key *keys = options_of(kiosk);
    bool other = false;
    for (int i = 0; keys[i].name; i++) {
        other = other || (scene_option_is_value(&keys[i]) &&
                          fabsf(scene_option_value(before, i) - scene_option_value(options, i)) > 0);
    }
    if (other) {
        kiosk->options = *options;
        post_options(kiosk);
    }
    kiosk_stand_dials(kiosk);
}

/* How many values a key has that is a choice or a flag; 0 of others. */
static int count_values(const struct key *key)
{
    int count = key->type == KEY_FLAG ? 2 : 0;
    while (key->type == KEY_CHOICE && key->choices[count]) {
        count++;
    }
    return count;
}

static void post_option(struct kiosk *kiosk, int option, float value, uint64_t now_us)
{
    struct action action = action_default(scene_types[kiosk_kind(kiosk)]->sets);
    action.option = option;
    action.value = value;
    kiosk_post(kiosk, &action, 0);
    kiosk_take_option(kiosk, &action, now_us);
}

void kiosk_next_kind(struct kiosk *kiosk, uint64_t now_us)
{
    const struct key *keys = options_of(kiosk);
    for (int i = 0; keys[i].name && visit_paints(&kiosk->visit); i++) {
        int count = count_values(&keys[i]);
        if (count > 0 && scene_option_brings(kiosk_kind(kiosk), &keys[i])) {
            int now = (int)scene_option_value(&kiosk->options, i);
            post_option(kiosk, i, (float)((now + 1) % count), now_us);
            return;
        }
    }
}

void kiosk_run_maps(struct kiosk *kiosk, uint64_t now_us)
{
    float place[2];
    int options[2];
    for (int seat = 0; seat < kiosk->hud.count; seat++) {
        if (!hud_map_picked(&kiosk->hud, seat, options, place) || !visit_paints(&kiosk->visit)) {
            continue;
        }
        visit_feel(&kiosk->visit, VISIT_PAINT, now_us);
        for (int i = 0; i < 2; i++) {
            if (options[i] >= 0) {
                post_option(kiosk, options[i], place[i], now_us);
            }
        }
        kiosk_stand_dials(kiosk);
    }
}
