/* The scene of trees: its picture, how it grows, and what of both visitors change. */
#include <math.h>
#include <string.h>

#include "kiosk_state.h"

bool kiosk_has_trees(const struct kiosk *kiosk)
{
    return kiosk_scene(kiosk)->kind == SCENE_TREES;
}

bool kiosk_takes(const struct kiosk *kiosk, enum action_verb verb)
{
    bool both = verb == ACTION_UNDO || verb == ACTION_REDO || verb == ACTION_CLEAR || verb == ACTION_RINSE;
    return both || (verb >= ACTION_STOCK) == kiosk_has_trees(kiosk);
}

static int growth_key(const char *name)
{
    return (int)(key_find(growth_keys, name) - growth_keys);
}

static void post_shape(struct kiosk *kiosk, int key, float value)
{
    struct action action = action_default(ACTION_SHAPE);
    action.option = key;
    action.value = value;
    kiosk_post(kiosk, &action, 0);
}

static bool is_shape(const struct key *key)
{
    return key->type != KEY_PATH && key->type != KEY_POINT;
}

static bool differ(const struct growth_def *a, const struct growth_def *b, int key)
{
    return fabsf(growth_value(a, key) - growth_value(b, key)) > 0;
}

/* Metaphor and tree bring values of their own; after them comes what is not as they have it. */
static void post_shapes(struct kiosk *kiosk)
{
    const struct growth_def *def = &kiosk->growth;
    struct growth_def preset = growth_preset((enum metaphor)def->metaphor, def->tree);
    int metaphor = growth_key("metaphor"), tree = growth_key("tree");
    post_shape(kiosk, metaphor, (float)def->metaphor);
    post_shape(kiosk, tree, (float)def->tree);
    for (int i = 0; growth_keys[i].name; i++) {
        if (i != metaphor && i != tree && is_shape(&growth_keys[i]) && differ(def, &preset, i)) {
            post_shape(kiosk, i, growth_value(def, i));
        }
    }
}

void kiosk_stand_dials(struct kiosk *kiosk)
{
    kiosk->hud.metaphor = kiosk->growth.metaphor;
    if (kiosk->controls) {
        controls_growth(kiosk->controls, kiosk_has_trees(kiosk) ? &kiosk->growth : NULL);
    }
}

static void set_growth(struct kiosk *kiosk, const struct growth_def *growth)
{
    kiosk->growth = *growth;
    kiosk_stand_dials(kiosk);
}

static bool post_stock(struct kiosk *kiosk, bool next)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    struct action action;
    if (!stage->stock || !stage->stock(stage->context, next, &action)) {
        return false;
    }
    hud_show_picture(&kiosk->hud, &action.picture);
    return kiosk_post(kiosk, &action, 0);
}

void kiosk_lay_garden(struct kiosk *kiosk)
{
    bool next = kiosk->visit.state == VISIT_ATTRACT && kiosk->gardens > 0;
    set_growth(kiosk, &kiosk_scene(kiosk)->growth);
    kiosk->wants_picture = false;
    kiosk->stocked = (next && post_stock(kiosk, true)) || post_stock(kiosk, false);
    kiosk->gardens++;
    post_shapes(kiosk);
}

void kiosk_run_garden(struct kiosk *kiosk)
{
    if (!kiosk_has_trees(kiosk)) {
        return;
    }
    if (kiosk->wants_picture && post_stock(kiosk, true)) {
        kiosk->wants_picture = false;
        kiosk->stocked = true;
    } else if (!kiosk->stocked) {
        kiosk->stocked = post_stock(kiosk, false);
    }
}

void kiosk_take_shape(struct kiosk *kiosk, const struct action *action)
{
    const char *name = growth_keys[action->option].name;
    bool all = strcmp(name, "metaphor") == 0 || strcmp(name, "tree") == 0;
    growth_take(&kiosk->growth, action->option, action->value);
    if (all) {
        kiosk_stand_dials(kiosk);
    }
}

void kiosk_change_garden(struct kiosk *kiosk, const struct growth_def *before)
{
    const struct growth_def *growth = &kiosk_scene(kiosk)->growth;
    bool other = false;
    for (int i = 0; growth_keys[i].name; i++) {
        other = other || (is_shape(&growth_keys[i]) && differ(before, growth, i));
    }
    if (other) {
        set_growth(kiosk, growth);
        post_shapes(kiosk);
    } else {
        kiosk_stand_dials(kiosk);
    }
}

void kiosk_next_picture(struct kiosk *kiosk)
{
    kiosk->wants_picture = kiosk_has_trees(kiosk) && visit_paints(&kiosk->visit);
    kiosk_run_garden(kiosk);
}

void kiosk_next_metaphor(struct kiosk *kiosk)
{
    struct action action = action_default(ACTION_SHAPE);
    action.option = growth_key("metaphor");
    action.value = (float)((kiosk->growth.metaphor + 1) % METAPHORS);
    if (kiosk_has_trees(kiosk) && visit_paints(&kiosk->visit)) {
        kiosk_post(kiosk, &action, 0);
        kiosk_take_shape(kiosk, &action);
    }
}
