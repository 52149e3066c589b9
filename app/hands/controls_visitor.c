/* Who somebody is: seats and what they have chosen, controllers and whether they come back. */
#include <math.h>
#include <string.h>

#include "controls_state.h"
#include "device_class.h"
#include "hash.h"

void controls_start_seats(struct controls *controls)
{
    static const struct exhibit_seat WHOLE = {{0, 0, 1, 1}, -1, SIDE_OF_LEFT};
    const struct exhibit_seat *seats = controls->def.seats ? controls->def.seats : &WHOLE;
    int count = controls->def.seats ? controls->def.seat_count : 1;
    controls->seat_count = count < 1 ? 1 : count > EXHIBIT_SEATS ? EXHIBIT_SEATS : count;
    for (int i = 0; i < controls->seat_count; i++) {
        struct seat *seat = &controls->seats[i];
        seat->own_ink = seats[i].ink;
        memcpy(seat->zone, seats[i].zone, sizeof seat->zone);
    }
    controls->def.seats = NULL; /* the caller's, who need not keep them */
    controls_reset_visitors(controls);
}

void controls_reset_visitors(struct controls *controls)
{
    controls->next_ink = controls->shared_ink = 0;
    controls->chance.state = 0;
    for (int i = 0; i < controls->seat_count; i++) {
        controls->seats[i].ink = -1;
        controls->seats[i].tool = TOOL_DROP;
    }
    for (int i = 0; i < OWNERS; i++) {
        struct owner *owner = &controls->owners[i];
        owner->ink = -1;
        owner->moved = false;
        owner->cursor = (struct point){0.5f, 0.5f};
    }
    for (int i = 0; i < GESTURE_FINGERS; i++) {
        if (controls->gestures.finger[i].down) {
            controls_seat_finger(controls, i, controls->finger_seat[i]);
        }
    }
}

/* ---- seats */

static float beyond(float value, float from, float to)
{
    return value < from ? from - value : value > to ? value - to : 0;
}

int controls_seat_at(const struct controls *controls, struct point at)
{
    int nearest = 0;
    float least = INFINITY;
    for (int i = 0; i < controls->seat_count; i++) {
        const float *zone = controls->seats[i].zone;
        float apart = hypotf(beyond(at.x, zone[0], zone[2]), beyond(at.y, zone[1], zone[3]));
        if (apart < least) {
            least = apart;
            nearest = i;
        }
    }
    return nearest;
}

static bool is_shared(const struct controls *controls)
{
    return controls->def.inputs->visitors == VISITORS_SHARED;
}

static int take_ink(struct controls *controls)
{
    int ink = controls->next_ink;
    controls->next_ink = (controls->next_ink + 1) % controls->def.inks;
    return ink;
}

void controls_seat_finger(struct controls *controls, int finger, int seat)
{
    controls->finger_seat[finger] = seat;
    controls->finger_tool[finger] = controls->seats[seat].tool;
    controls->finger_ink[finger] = controls_ink(controls, seat) < 0 ? take_ink(controls) : controls->next_ink;
}

static bool is_seat(const struct controls *controls, int seat)
{
    return seat >= 0 && seat < controls->seat_count;
}

void controls_set_tool(struct controls *controls, int seat, enum exhibit_tool tool)
{
    if (is_seat(controls, seat) && tool < TOOLS) {
        controls->seats[seat].tool = tool;
    }
}

enum exhibit_tool controls_tool(const struct controls *controls, int seat)
{
    return is_seat(controls, seat) ? controls->seats[seat].tool : TOOL_DROP;
}

void controls_set_ink(struct controls *controls, int seat, int ink)
{
    if (!is_seat(controls, seat) || ink >= controls->def.inks) {
        return;
    }
    if (!is_shared(controls)) {
        controls->seats[seat].ink = ink < 0 ? -1 : ink;
    } else if (ink >= 0) {
        controls->shared_ink = ink;
    }
}

int controls_ink(const struct controls *controls, int seat)
{
    if (!is_seat(controls, seat)) {
        return -1;
    }
    int own = controls->seats[seat].own_ink;
    return own >= 0 ? own % controls->def.inks : is_shared(controls) ? controls->shared_ink : controls->seats[seat].ink;
}

/* ---- whose a cause is */

int controls_visitor_of(const struct controls *controls, const struct cause *cause)
{
    return cause->finger != NOBODY ? controls->finger_seat[cause->finger] + 1 : EXHIBIT_SEATS + 1 + cause->owner;
}

bool controls_has_own_ink(const struct controls *controls, const struct cause *cause)
{
    return cause->finger != NOBODY && controls->seats[controls->finger_seat[cause->finger]].own_ink >= 0;
}

int controls_ink_of(const struct controls *controls, const struct cause *cause)
{
    if (cause->finger != NOBODY) {
        int ink = controls_ink(controls, controls->finger_seat[cause->finger]);
        return ink < 0 ? controls->finger_ink[cause->finger] : ink;
    }
    return is_shared(controls) ? controls->shared_ink : controls->owners[cause->owner].ink;
}

void controls_change_ink(struct controls *controls, const struct cause *cause)
{
    int ink = (controls_ink_of(controls, cause) + 1) % controls->def.inks;
    if (controls_has_own_ink(controls, cause)) {
        return;
    }
    if (is_shared(controls)) {
        controls->shared_ink = ink;
    } else if (cause->finger == NOBODY) {
        controls->owners[cause->owner].ink = ink;
    } else if (controls->seats[controls->finger_seat[cause->finger]].ink >= 0) {
        controls->seats[controls->finger_seat[cause->finger]].ink = ink;
    } else {
        controls->finger_ink[cause->finger] = ink;
    }
}

/* ---- controllers */

static struct known *known_of(struct controls *controls, enum event_source source, uint32_t device)
{
    for (int i = 0; i < KNOWN; i++) {
        struct known *known = &controls->known[i];
        if (known->used && known->source == source && known->device == device) {
            return known;
        }
    }
    return NULL;
}

/* Of all that tells a device from others and is the same when it comes back. */
static uint64_t identity_of(enum event_source source, const struct device *device)
{
    char text[2 * SOURCE_NAME + 64];
    int length = snprintf(text, sizeof text, "%d %04x:%04x %s@%s", (int)source, device->vendor, device->product,
                          device->name, device->port);
    return hash_bytes(HASH_START, text, (size_t)length);
}

/* Which of the listed devices of a class it is, a bit each. */
static uint32_t entries_of(const struct binding_source *from, const struct inputs *inputs, const struct device *device)
{
    uint32_t entries = 0;
    int count = 0;
    const struct inputs_device *devices = from->devices ? from->devices(inputs, &count) : NULL;
    for (int i = 0; i < count; i++) {
        entries |= inputs_match(&devices[i], device->vendor, device->product, device->name) ? 1u << i : 0;
    }
    return entries;
}

void controls_introduce(struct controls *controls, enum event_source source, const struct device *device)
{
    const struct inputs *inputs = controls->def.inputs;
    struct known *known = known_of(controls, source, device->id);
    for (int i = 0; i < KNOWN && !known; i++) {
        known = controls->known[i].used ? NULL : &controls->known[i];
    }
    if (!known) {
        return;
    }
    *known =
        (struct known){.used = true, .source = source, .device = device->id, .identity = identity_of(source, device)};
    for (int i = 0; device_classes[i]; i++) {
        for (const struct binding_source *from = device_classes[i]->sources; from->key.name; from++) {
            known->entries |= from->source == source ? entries_of(from, inputs, device) : 0;
        }
    }
}

bool controls_is_device(struct controls *controls, const struct binding *binding, const struct event *event)
{
    if (binding->device < 0) {
        return true;
    }
    const struct known *known = known_of(controls, event->source, event->device);
    return known && known->entries & 1u << binding->device;
}

/* How well a place suits a device that has none: 3 its own from before, 2 free, 1 of one that is gone, 0 taken. */
static int suits(const struct owner *owner, enum event_source source, uint32_t device, uint64_t identity)
{
    if (!owner->used) {
        return 2;
    }
    if (owner->there) {
        return 0;
    }
    bool same = owner->source == source && owner->identity == identity && (identity != 0 || owner->device == device);
    return same ? 3 : 1;
}

static int place_owner(struct controls *controls, enum event_source source, uint32_t device)
{
    const struct known *known = known_of(controls, source, device);
    uint64_t identity = known ? known->identity : 0;
    int best = OWNERS - 1, most = 0; /* with so many controllers the last ones share a point */
    for (int i = 0; i < OWNERS; i++) {
        int suit = suits(&controls->owners[i], source, device, identity);
        if (suit > most) {
            most = suit;
            best = i;
        }
    }
    struct owner *owner = &controls->owners[best];
    if (most == 1 || most == 2) {
        *owner =
            (struct owner){.used = true, .source = source, .identity = identity, .ink = -1, .cursor = {0.5f, 0.5f}};
    }
    if (most > 0) {
        owner->there = true;
        owner->device = device;
    }
    return best;
}

int controls_owner(struct controls *controls, enum event_source source, uint32_t device)
{
    int found = NOBODY;
    for (int i = 0; i < OWNERS && found == NOBODY; i++) {
        const struct owner *owner = &controls->owners[i];
        if (owner->used && owner->there && owner->source == source && owner->device == device) {
            found = i;
        }
    }
    found = found == NOBODY ? place_owner(controls, source, device) : found;
    if (controls->owners[found].ink < 0) {
        controls->owners[found].ink = take_ink(controls);
    }
    return found;
}

void controls_part(struct controls *controls, enum event_source source, uint32_t device)
{
    struct known *known = known_of(controls, source, device);
    if (known) {
        known->used = false;
    }
    for (int i = 0; i < OWNERS; i++) {
        struct owner *owner = &controls->owners[i];
        if (owner->used && owner->there && owner->source == source && owner->device == device) {
            owner->there = owner->moved = false;
            owner->pace[0] = owner->pace[1] = 0;
        }
    }
}

static bool holds(const struct controls *controls, const struct owner *owner)
{
    for (int i = 0; i < CONTACTS; i++) {
        const struct contact *contact = &controls->contacts[i];
        if (contact->used && contact->press.down && contact->finger == NOBODY && contact->source == owner->source &&
            contact->device == owner->device) {
            return true;
        }
    }
    return false;
}

int controls_cursors(const struct controls *controls, uint64_t now_us, struct controls_cursor *cursors, int most)
{
    int count = 0;
    for (int i = 0; i < OWNERS && count < most; i++) {
        const struct owner *owner = &controls->owners[i];
        if (!owner->used || !owner->there || !owner->moved) {
            continue;
        }
        int ink = is_shared(controls) ? controls->shared_ink : owner->ink < 0 ? controls->next_ink : owner->ink;
        cursors[count++] = (struct controls_cursor){.visitor = EXHIBIT_SEATS + 1 + i,
                                                    .at = owner->cursor,
                                                    .ink = ink,
                                                    .held = holds(controls, owner),
                                                    .used = now_us < owner->moved_us + CONTROLS_CURSOR_US};
    }
    return count;
}
