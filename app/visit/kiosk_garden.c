/* The pictures of scenes of trees, and when they come. */
#include "kiosk_state.h"

bool kiosk_has_trees(const struct kiosk *kiosk)
{
    return kiosk_scene(kiosk)->kind == SCENE_TREES;
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
    if (!kiosk_has_trees(kiosk)) {
        return;
    }
    kiosk->wants_picture = false;
    kiosk->stocked = (next && post_stock(kiosk, true)) || post_stock(kiosk, false);
    kiosk->gardens++;
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

void kiosk_next_picture(struct kiosk *kiosk)
{
    kiosk->wants_picture = kiosk_has_trees(kiosk) && visit_paints(&kiosk->visit);
    kiosk_run_garden(kiosk);
}
