#include "studio_tell.h"

#include "studio_work.h"

static void tell(struct studio *studio, struct studio_event *event)
{
    const struct studio_teller *teller = &studio->def.teller;
    event->ticked = studio->ticked;
    event->script = studio->script;
    event->engine = studio->engine;
    event->history = studio->history ? studio->def.history : (struct history_def){.bytes = 0};
    teller->tell(teller->data, event);
}

void studio_tell(struct studio *studio, enum studio_event_kind kind)
{
    if (studio->def.teller.tell) {
        struct studio_event event = {.kind = kind,
                                     .def = studio->engine->ops->get_def(studio->engine),
                                     .whole = kind == STUDIO_WHOLE ? &studio->whole : NULL};
        tell(studio, &event);
    }
}

void studio_tell_action(struct studio *studio, const struct action *action)
{
    if (studio->def.teller.tell) {
        struct studio_event event = {.kind = STUDIO_ACTION, .action = action};
        tell(studio, &event);
    }
}

void studio_tell_ticked(struct studio *studio, double busy_s)
{
    studio->ticked++;
    if (studio->def.teller.tell) {
        struct studio_event event = {.kind = STUDIO_TICKED, .busy_s = busy_s};
        tell(studio, &event);
    }
}

void studio_tell_restored(struct studio *studio, int64_t lost)
{
    if (studio->def.teller.tell) {
        struct studio_event event = {
            .kind = STUDIO_RESTORED, .def = studio->engine->ops->get_def(studio->engine), .lost = lost};
        tell(studio, &event);
    }
}
