/* What stands where and when: the palette, seats, opening hours, the staff's corners. */
#include <string.h>

#include "exhibit_read.h"
#include "ink.h"

static void read_tool(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit_palette *palette = context;
    struct names names = names_of_choices(exhibit_tool_names);
    int tool = 0;
    (void)index;
    if (value_choice(reader, &names, "tool", item, &tool)) {
        palette->tools[tool] = true;
    }
}

void exhibit_read_palette(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    struct exhibit_palette *palette = &exhibit->palette;
    const struct yaml_node *node = exhibit_mapping(reader, root, "palette", hud_keys, palette);
    const struct yaml_node *tools = node ? yaml_get(node, "tools") : NULL;
    for (int kind = 0; kind < SCENE_KINDS; kind++) {
        palette->tools[tool_first(kind)] = true;
    }
    if (tools && !yaml_is_nothing(tools)) {
        size_t length = reader_enter(reader, "palette");
        inputs_list(reader, node, "tools", TOOLS, "a list of tools: [drop, brush]", read_tool, palette);
        reader_leave(reader, length);
        return;
    }
    for (int i = 0; i < TOOLS; i++) {
        palette->tools[i] = true;
    }
}

void exhibit_same_ink(struct reader *reader, const struct yaml_node *at, const struct exhibit *exhibit, int ink)
{
    const struct script *first = exhibit->scenes[0].script;
    for (int i = 1; i < exhibit->scene_count; i++) {
        const struct script *script = exhibit->scenes[i].script;
        if (exhibit->scenes[i].kind != SCENE_PAINTING) {
            continue;
        }
        if (ink >= script->ink_count || script->inks[ink] != first->inks[ink]) {
            reader_problem(reader, at,
                           "%s is not ink %d of the scene '%s'; an ink that every scene has in the same "
                           "place of its list",
                           inks[first->inks[ink]].name, ink + 1, exhibit->scenes[i].id ? exhibit->scenes[i].id : "");
            return;
        }
    }
}

static bool overlap(const float *a, const float *b)
{
    return a[0] < b[2] && b[0] < a[2] && a[1] < b[3] && b[1] < a[3];
}

static void read_seat(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit *exhibit = context;
    struct exhibit_seat *seat = &exhibit->seats[index];
    const struct yaml_node *zone = item->kind == YAML_MAPPING ? yaml_get(item, "zone") : NULL;
    static const float NOWHERE[4] = {2, 2, 2, 2};
    exhibit->seat_count = index + 1;
    exhibit_defaults(seat_keys, seat);
    memcpy(seat->zone, NOWHERE, sizeof NOWHERE); /* what cannot be read overlaps nothing */
    if (item->kind != YAML_MAPPING) {
        value_wrong_kind(reader, item, "{zone: [0, 0, 0.5, 1], ink: INK, side: left}");
        return;
    }
    mapping_read(reader, seat_keys, item, seat, NULL);
    for (int i = 0; i < index; i++) {
        if (overlap(exhibit->seats[i].zone, seat->zone)) {
            exhibit_problem(reader, "zone", zone, "overlaps that of seats[%d]; zones that share nothing but edges", i);
        }
    }
    if (seat->ink >= 0) {
        size_t length = reader_enter(reader, "ink");
        exhibit_same_ink(reader, yaml_get(item, "ink"), exhibit, seat->ink);
        reader_leave(reader, length);
    }
}

void exhibit_read_seats(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    struct script *outer = reader->script;
    struct script first = *outer; /* its memory, with the inks of the first scene */
    if (exhibit->scene_count > 0) {
        memcpy(first.inks, exhibit->scenes[0].script->inks, sizeof first.inks);
        first.ink_count = exhibit->scenes[0].script->ink_count;
    }
    reader->script = &first;
    reader->whose = "first scene's";
    inputs_list(reader, root, "seats", EXHIBIT_SEATS, "a list of {zone: [0, 0, 0.5, 1], ink: INK, side: left}",
                read_seat, exhibit);
    reader->whose = NULL;
    reader->script = outer;
    outer->memory = first.memory;
    if (exhibit->seat_count == 0) {
        exhibit_defaults(seat_keys, &exhibit->seats[0]);
        exhibit->seat_count = 1;
    }
}

static int day_of(const char *text, size_t length)
{
    for (int i = 0; day_names[i]; i++) {
        if (strlen(day_names[i]) == length && strncmp(day_names[i], text, length) == 0) {
            return i;
        }
    }
    return -1;
}

/* A day, or a span of them, which may go round the end of the week. */
static void read_days(struct reader *reader, const struct yaml_node *node, struct exhibit_hours *hours)
{
    enum { WEEK = 7 };
    char found[128];
    const char *text = node->kind == YAML_SCALAR ? node->text : "", *dash = strchr(text, '-');
    int first = day_of(text, dash ? (size_t)(dash - text) : strlen(text));
    int last = dash ? day_of(dash + 1, strlen(dash + 1)) : first;
    if (node->kind == YAML_REFUSED) {
        return;
    }
    if (first < 0 || last < 0) {
        reader_problem(reader, node, "%s is no day; one of mon, tue, wed, thu, fri, sat, sun, or a span: mon-fri",
                       yaml_found(node, found, sizeof found));
        return;
    }
    for (int day = first;; day = (day + 1) % WEEK) {
        hours->days[day] = true;
        if (day == last) {
            return;
        }
    }
}

static void read_day(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    (void)index;
    read_days(reader, item, context);
}

static void read_hours(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit *exhibit = context;
    struct exhibit_hours *hours = &exhibit->hours[index];
    if (!exhibit_item(reader, item, schedule_keys, hours, "{days: mon-fri, open: \"10:00\", close: \"18:00\"}")) {
        return;
    }
    const struct yaml_node *days = yaml_get(item, "days");
    if (days && days->kind == YAML_LIST) {
        inputs_list(reader, item, "days", 7, "a list of days", read_day, hours);
        if (days->count == 0) {
            exhibit_problem(reader, "days", days, "a list of 0; at least one day, or no list for every day");
        }
    } else if (days && !yaml_is_nothing(days)) {
        size_t length = reader_enter(reader, "days");
        read_days(reader, days, hours);
        reader_leave(reader, length);
    } else {
        memset(hours->days, true, sizeof hours->days);
    }
    exhibit->hours_count = index + 1;
}

void exhibit_read_hours(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    inputs_list(reader, root, "schedule", EXHIBIT_HOURS, "a list of {days: mon-fri, open: \"10:00\", close: \"18:00\"}",
                read_hours, exhibit);
}

static void read_tap(struct reader *reader, const struct yaml_node *item, int index, void *context)
{
    struct exhibit_staff *staff = context;
    struct names names = names_of_choices(corner_names);
    (void)index;
    if (value_choice(reader, &names, "corner", item, &staff->taps[staff->tap_count])) {
        staff->tap_count++;
    }
}

void exhibit_read_staff(struct reader *reader, const struct yaml_node *root, struct exhibit *exhibit)
{
    struct exhibit_staff *staff = &exhibit->staff;
    const struct yaml_node *node = exhibit_mapping(reader, root, "staff", staff_keys, staff);
    const struct yaml_node *taps = node ? yaml_get(node, "taps") : NULL;
    if (taps && !yaml_is_nothing(taps)) {
        size_t length = reader_enter(reader, "staff");
        inputs_list(reader, node, "taps", EXHIBIT_TAPS, "a list of corners: [top left, top right, bottom right]",
                    read_tap, staff);
        if (taps->kind == YAML_LIST && taps->count < EXHIBIT_TAPS_MIN) {
            exhibit_problem(reader, "taps", taps, "a list of %d; at least %d corners, so that no visitor gets there",
                            taps->count, EXHIBIT_TAPS_MIN);
        }
        reader_leave(reader, length);
        return;
    }
    for (staff->tap_count = 0; corner_names[staff->tap_count]; staff->tap_count++) {
        staff->taps[staff->tap_count] = staff->tap_count;
    }
}
