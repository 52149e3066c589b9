#include "live_input.h"

#include "bench.h"
#include "kiosk.h"

bool live_input_open(struct live_input *input, const struct script *script, struct display *display,
                     const struct live_input_def *def)
{
    struct display_size size = display_sheet(display);
    bool screen = display_kind(display) == DISPLAY_KMS;
    int fds[SOURCES_MAX];
    *input = (struct live_input){
        .kiosk = def->kiosk, .clock = def->clock, .own = def->inputs ? NULL : inputs_default(script)};
    const struct inputs *inputs = def->inputs ? def->inputs : input->own;
    if (!inputs) {
        return false;
    }
    const struct sources_def sources = {.inputs = inputs,
                                        .touch = screen,
                                        .hold = screen && def->hold,
                                        .console = def->console,
                                        .rotation = def->rotation,
                                        .width = size.width,
                                        .height = size.height};
    input->sources = sources_create(&sources);
    input->controls = controls_create(&(struct controls_def){.inputs = inputs,
                                                             .inks = script->ink_count,
                                                             .coefficients = script->coefficients,
                                                             .seats = def->seats,
                                                             .seat_count = def->seat_count});
    input->lamps.inputs = inputs;
    if (!input->sources || !input->controls) {
        return false;
    }
    display_wake_on(display, fds, sources_fds(input->sources, fds));
    return true;
}

void live_input_close(struct live_input *input)
{
    sources_destroy(input->sources);
    controls_destroy(input->controls);
    inputs_destroy(input->own);
    *input = (struct live_input){.own = NULL};
}

static uint64_t now_us(void)
{
    return (uint64_t)(1e6 * bench_wall_s());
}

static int sooner(int a, int b)
{
    return b >= 0 && b < a ? b : a;
}

int live_input_wait_ms(const struct live_input *input, int most)
{
    return sooner(sooner(most, sources_timeout_ms(input->sources)), controls_timeout_ms(input->controls, now_us()));
}

static void take(struct live_input *input, struct event *event)
{
    struct device device;
    lamps_feel(&input->lamps, event);
    if (event->kind == EVENT_ARRIVED && sources_device(input->sources, event, &device)) {
        controls_introduce(input->controls, event->source, &device);
        lamps_introduce(&input->lamps, event->source, &device);
    }
    uint64_t time_us = event->time_us;
    event->time_us = live_clock_at(&input->clock, time_us);
    bool felt = !input->kiosk || kiosk_feel(input->kiosk, event, live_clock_us(&input->clock));
    event->time_us = time_us;
    if (felt) {
        controls_feel(input->controls, event);
    }
}

/* What visitors want that is no action on the sheet. */
static void grant(struct live_input *input, const struct wish *wish, struct studio *studio)
{
    struct action action = action_default(wish->kind == WISH_UNDO ? ACTION_UNDO : ACTION_REDO);
    action.visitor = wish->visitor;
    if (input->kiosk) {
        kiosk_wish(input->kiosk, wish, live_clock_us(&input->clock));
    } else if (wish->kind == WISH_UNDO || wish->kind == WISH_REDO) {
        studio_post(studio, &action);
    }
}

static void light(struct live_input *input)
{
    int lamp;
    float level;
    while (lamps_next(&input->lamps, now_us(), &lamp, &level)) {
        sources_light(input->sources, lamp, level);
    }
}

/* What has reached the screen since it was looked at last. */
static void look(struct live_input *input, const struct display *display)
{
    struct display_frames frames = display_frames(display);
    if (input->number > 0 && frames.presented > input->before) {
        latency_flip(&input->latency, input->number, frames.last_us);
        input->number = 0;
    }
}

void live_input_feel(struct live_input *input, struct display *display, struct studio *studio)
{
    struct event event;
    struct action action;
    struct wish wish;
    struct studio_consumed consumed;
    uint64_t time_us;
    while (studio_consumed(studio, &consumed)) {
        latency_tick(&input->latency, consumed.event_us, consumed.tick_us, consumed.number);
    }
    look(input, display);
    sources_dispatch(input->sources);
    while (display_event(display, &event)) {
        take(input, &event);
    }
    while (sources_event(input->sources, &event)) {
        take(input, &event);
    }
    controls_run(input->controls, now_us());
    while (controls_action(input->controls, &action, &time_us)) {
        bool taken = input->kiosk ? kiosk_act(input->kiosk, &action, time_us, live_clock_us(&input->clock))
                                  : studio_post_event(studio, &action, time_us);
        input->refused += !taken;
    }
    while (controls_wish(input->controls, &wish)) {
        grant(input, &wish, studio);
    }
    light(input);
}

void live_input_draws(struct live_input *input, const struct display *display, uint64_t number)
{
    look(input, display);
    input->number = number;
    input->before = display_frames(display).presented;
}

void live_input_unseen(struct live_input *input)
{
    latency_forget(&input->latency);
    input->number = 0;
}

bool live_input_log(struct live_input *input, char *line, int size)
{
    return sources_log(input->sources, line, size);
}
