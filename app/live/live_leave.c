#include "live_leave.h"

enum { SIDE_MOST = 2 * TRANSITION_WIDTH }; /* pixels: finer than its grid it need not be */

void live_leave_init(struct live_leave *leave, const struct shader_folder *folder)
{
    *leave = (struct live_leave){.folder = folder};
    atomic_init(&leave->made, false);
}

void live_leave_lost(struct live_leave *leave)
{
    plate_gpu_destroy(leave->gpu);
    leave->gpu = NULL;
    leave->set = false;
}

static void join(struct live_leave *leave)
{
    if (leave->running) {
        pthread_join(leave->thread, NULL);
        leave->running = false;
    }
}

/* None any more; `gpu` and its programs stay. */
static void let_go(struct live_leave *leave)
{
    join(leave);
    transition_finish(&leave->transition);
    leave->wanted = leave->set = false;
    atomic_store(&leave->made, false);
}

void live_leave_finish(struct live_leave *leave)
{
    let_go(leave);
    live_leave_lost(leave);
}

static void *make(void *context)
{
    struct live_leave *leave = context;
    (void)transition_init(&leave->transition, leave->kind, leave->seed, leave->width, leave->height);
    atomic_store(&leave->made, true);
    return NULL;
}

static void begin(struct live_leave *leave, enum transition_kind kind, uint32_t seed, int width, int height)
{
    int longer = width > height ? width : height;
    double fit = longer > SIDE_MOST ? (double)SIDE_MOST / longer : 1;
    let_go(leave);
    leave->kind = kind;
    leave->seed = seed;
    leave->width = (int)(fit * width) > 0 ? (int)(fit * width) : 1;
    leave->height = (int)(fit * height) > 0 ? (int)(fit * height) : 1;
    leave->wanted = true;
    leave->running = pthread_create(&leave->thread, NULL, make, leave) == 0;
}

bool live_leave_cover(struct live_leave *leave, int kind, uint32_t seed, double share, int width, int height)
{
    leave->share = share;
    if (kind == TRANSITION_WASH) {
        if (leave->wanted) {
            let_go(leave);
        }
        return true;
    }
    if (!leave->wanted || (int)leave->kind != kind || leave->seed != seed) {
        begin(leave, (enum transition_kind)kind, seed, width, height);
    }
    if (!atomic_load(&leave->made)) {
        return false;
    }
    join(leave);
    return leave->transition.over.rgba; /* not when memory was short */
}

/* The one that comes is the one before: the other hides it. */
static bool set(struct live_leave *leave)
{
    return plate_gpu_set(leave->gpu, &leave->transition.over) && plate_gpu_set(leave->gpu, &leave->transition.away);
}

bool live_leave_draw(struct live_leave *leave, struct display *display, struct shader_error *error)
{
    struct display_size panel = display_panel(display);
    float turn[4];
    if (!leave->wanted || leave->running || !leave->transition.over.rgba) {
        if (leave->gpu && !leave->wanted) { /* its textures are of no use until the next one comes */
            live_leave_lost(leave);
        }
        return true;
    }
    if (!leave->gpu && !(leave->gpu = plate_gpu_create(leave->folder, error))) {
        return false;
    }
    leave->set = leave->set || set(leave);
    if (leave->set) {
        struct transition_look look = transition_look(leave->share);
        display_turn(display, turn);
        plate_gpu_present(leave->gpu, look.tick, look.before, display_framebuffer(display), panel.width, panel.height,
                          turn);
    }
    return true;
}
