/* How a sheet goes where it is not washed: it is covered, another one takes its place unseen, and that is bared. */
#include <math.h>

#include "kiosk_state.h"

static const double SECOND = 1e6;
static const float COVERS_S = 3;          /* at the least */
static const double BARES = 0.8;          /* of what covering takes */
static const double HURRY_S = 0.9;        /* when somebody is there */
static const uint64_t HIDES_US = 900000;  /* the old sheet fades under it */
static const uint64_t WAITS_US = 3000000; /* for the stage; then the sheet changes as it is */

static uint64_t covers_us(const struct kiosk *kiosk)
{
    return (uint64_t)(SECOND * (double)fmaxf(kiosk->exhibit->visit.wash, COVERS_S));
}

static double passed(const struct kiosk_leave *leave, uint64_t now_us)
{
    double gone = now_us > leave->since_us ? (double)(now_us - leave->since_us) : 0;
    return leave->lasts_us > 0 ? fmin(gone / (double)leave->lasts_us, 1) : 1;
}

static double share_at(const struct kiosk_leave *leave, uint64_t now_us)
{
    return leave->from + (leave->to - leave->from) * passed(leave, now_us);
}

/* From where it is to another share. */
static void go(struct kiosk_leave *leave, enum kiosk_leaving state, double to, uint64_t lasts_us, uint64_t now_us)
{
    leave->from = share_at(leave, now_us);
    leave->to = to;
    leave->state = state;
    leave->since_us = now_us;
    leave->lasts_us = lasts_us;
}

static bool show(struct kiosk *kiosk, int kind, double share)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    return !stage->cover || stage->cover(stage->context, kind, kiosk->leave.seed, share);
}

void kiosk_leave_stop(struct kiosk *kiosk)
{
    if (kiosk->leave.state != LEAVE_NOT) {
        show(kiosk, TRANSITION_WASH, 0);
        kiosk->leave =
            (struct kiosk_leave){.seed = kiosk->leave.seed, .asked = kiosk->leave.asked, .told = kiosk->leave.told};
    }
}

bool kiosk_leave(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_leave *leave = &kiosk->leave;
    int kind = kiosk_scene(kiosk)->leave;
    if (kind == TRANSITION_WASH) {
        return false;
    }
    if (leave->state == LEAVE_NOT) {
        *leave = (struct kiosk_leave){
            .state = LEAVE_WAITS, .kind = kind, .seed = leave->seed + 1, .since_us = now_us, .lasts_us = WAITS_US};
    } else if (leave->state != LEAVE_WAITS && leave->state != LEAVE_COVERS) { /* what is there comes again */
        double way = fabs(1 - share_at(leave, now_us));
        go(leave, LEAVE_COVERS, 1, (uint64_t)(way * (double)covers_us(kiosk)), now_us);
    }
    return true;
}

/* All is covered: nobody sees what happens. */
static void cross(struct kiosk *kiosk, uint64_t now_us)
{
    go(&kiosk->leave, LEAVE_HIDES, kiosk->leave.to, HIDES_US, now_us);
    kiosk_gone(kiosk, now_us);
}

static bool is_fresh(const struct kiosk *kiosk)
{
    return kiosk->def.stage.sheet(kiosk->def.stage.context).number >= kiosk->sheet;
}

static void next_state(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_leave *leave = &kiosk->leave;
    uint64_t bares_us = (uint64_t)(BARES * (double)covers_us(kiosk));
    switch (leave->state) {
    case LEAVE_WAITS: /* in vain */
        cross(kiosk, now_us);
        kiosk_leave_stop(kiosk);
        break;
    case LEAVE_COVERS:
        cross(kiosk, now_us);
        break;
    case LEAVE_HIDES:
        if (is_fresh(kiosk)) {
            go(leave, LEAVE_BARES, 2, bares_us, now_us);
        }
        break;
    default:
        kiosk_leave_stop(kiosk);
        break;
    }
}

void kiosk_run_leave(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_leave *leave = &kiosk->leave;
    if (leave->state == LEAVE_NOT) {
        return;
    }
    bool ready = show(kiosk, leave->kind, share_at(leave, now_us));
    if (leave->state == LEAVE_WAITS && ready) {
        go(leave, LEAVE_COVERS, 1, covers_us(kiosk), now_us);
    } else if (!(passed(leave, now_us) < 1)) {
        next_state(kiosk, now_us);
    }
}

void kiosk_leave_sheet(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_leave *leave = &kiosk->leave;
    leave->asked = leave->told = false;
    if (leave->state == LEAVE_WAITS) {
        kiosk_leave_stop(kiosk);
    } else if (leave->state == LEAVE_COVERS) {
        double share = share_at(leave, now_us); /* beyond 1 when it was on its way out */
        go(leave, LEAVE_BACK, share > 1 ? 2 : 0, (uint64_t)(SECOND * HURRY_S), now_us);
    }
}

void kiosk_leave_hurry(struct kiosk *kiosk, uint64_t now_us)
{
    struct kiosk_leave *leave = &kiosk->leave;
    if (leave->state == LEAVE_HIDES || leave->state == LEAVE_BARES) {
        go(leave, LEAVE_BARES, 2, (uint64_t)(SECOND * HURRY_S), now_us);
    }
}

void kiosk_ask_scene(struct kiosk *kiosk, uint64_t now_us)
{
    const struct kiosk_stage *stage = &kiosk->def.stage;
    bool paints = visit_paints(&kiosk->visit) && kiosk->visit.state != VISIT_CLOSING;
    bool wash = kiosk_scene(kiosk)->leave == TRANSITION_WASH;
    if (!paints || (wash && (!kiosk->visit.painted || kiosk->leave.asked))) { /* nobody waits for water over nothing */
        visit_feel(&kiosk->visit, VISIT_SCENE, now_us);
        return;
    }
    kiosk_obey(kiosk, now_us); /* a visit may have begun by it */
    if (wash) {
        stage->keep(stage->context);
        kiosk_begin_wash(kiosk, now_us);
        kiosk->leave.told = true;
    } else {
        kiosk_leave(kiosk, now_us);
    }
    kiosk->leave.asked = true;
}

void kiosk_leave_touched(struct kiosk *kiosk, uint64_t now_us)
{
    if (kiosk->leave.asked) {
        kiosk->leave.asked = false;
        visit_feel(&kiosk->visit, VISIT_SCENE, now_us);
        kiosk_obey(kiosk, now_us);
    }
}
