/* Who did what where: groups and their marks. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "brush.h"
#include "history_state.h"
#include "painting_verb.h"

enum { LATEST = 16 }; /* marks of a group that a stroke may go on from */
#define APART 12.0f   /* cells between them, edge to edge, at most */

static struct mark mark_at(const struct history *history, struct point from, struct point to, float radius)
{
    float width = (float)history->painting.width, height = (float)history->painting.height;
    float margin = (float)history->painting.margin;
    return (struct mark){.x0 = from.x * width + margin,
                         .y0 = from.y * height + margin,
                         .x1 = to.x * width + margin,
                         .y1 = to.y * height + margin,
                         .radius = radius,
                         .counts = true};
}

static struct point on_sheet(struct point at)
{
    at.x = at.x >= 0.0f ? at.x : 0.0f; /* NaN as well */
    at.y = at.y >= 0.0f ? at.y : 0.0f;
    return (struct point){at.x <= 1.0f ? at.x : 1.0f, at.y <= 1.0f ? at.y : 1.0f};
}

/* Whether it begins at a point: a stroke of such a verb is never a part of the one before. */
static bool is_press(const struct action *action)
{
    const struct key *at = verbs[action->verb]->painting ? key_find(action_keys(action->verb), "at") : NULL;
    return at && at->required;
}

int history_marks_of(const struct history *history, const struct action *action, struct mark *marks)
{
    const struct action_path *path = &action->path;
    const struct painting_verb *verb = verbs[action->verb]->painting;
    bool point = is_press(action) || action->has_at, by_path = path->count > 0;
    bool whole = action->invert || (!by_path && (action->formula.values || action->picture.values));
    int count = 0;
    if (whole || (!point && !by_path) || (verb && verb->common)) {
        return 0;
    }
    if (by_path && key_find(action_keys(action->verb), "path")) {
        struct point from = on_sheet(path->points[0]);
        for (int i = path->count > 1; i < path->count && count < STROKE_MARKS; i++) {
            struct point to = on_sheet(path->points[i]);
            marks[count++] = mark_at(history, from, to, action->radius);
            from = to;
        }
    } else {
        marks[count++] = mark_at(history, action->at, action->at, action->radius);
        if (action->verb == ACTION_DROP && action->brush != BRUSH_NONE) {
            marks[0].stamp = action->reach;
        }
    }
    for (int i = 0; i < count; i++) {
        marks[i].kind = verb ? verb->mark : MARK_GROWS;
    }
    return count;
}

struct rectangle history_around(const struct history *history, const struct mark *marks, int count, float reach)
{
    float x0 = 1e9f, x1 = -1e9f, y0 = 1e9f, y1 = -1e9f;
    for (int i = 0; i < count; i++) {
        const struct mark *mark = &marks[i];
        float around = mark->radius + reach;
        x0 = fminf(x0, fminf(mark->x0, mark->x1) - around);
        x1 = fmaxf(x1, fmaxf(mark->x0, mark->x1) + around);
        y0 = fminf(y0, fminf(mark->y0, mark->y1) - around);
        y1 = fmaxf(y1, fmaxf(mark->y0, mark->y1) + around);
    }
    struct rectangle cells = {(int)x0 - 1, (int)x1 + 2, (int)y0 - 1, (int)y1 + 2};
    return count > 0 ? rectangle_clip(cells, history->width, history->height) : (struct rectangle){0, 0, 0, 0};
}

bool history_has(const struct history *history, const struct group *group, enum group_state state)
{
    return group->state == state &&
           (state != GROUP_DONE || group->begin > past_horizon(history->past) || past_horizon(history->past) == 0);
}

struct group *history_find(struct history *history, int visitor, enum group_state state)
{
    struct group *found = NULL;
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        struct group *group = &history->groups[i];
        bool theirs = visitor == 0 ? group->visitor >= 0 : group->visitor == visitor;
        uint32_t when = state == GROUP_DONE ? group->last : group->undone;
        if (theirs && history_has(history, group, state) &&
            (!found || when > (state == GROUP_DONE ? found->last : found->undone))) {
            found = group;
        }
    }
    return found;
}

static void release_taken(struct history *history, struct group *group)
{
    for (int i = 0; i < group->taken_count; i++) {
        past_release(history->past, group->taken[i].version);
    }
    free(group->taken);
    group->taken = NULL;
    group->taken_count = group->taken_room = 0;
}

void history_drop_group(struct history *history, struct group *group)
{
    release_taken(history, group);
    group->state = GROUP_GONE;
}

void history_count_marks(struct history *history, uint32_t group, bool counts)
{
    for (int i = 0; i < history->mark_count; i++) {
        if (history->marks[i].group == group) {
            history->marks[i].counts = counts;
        }
    }
}

/* Whether a stroke goes on from where a group has been. */
static bool goes_on(const struct history *history, const struct group *group, const struct mark *first)
{
    int looked = 0;
    for (int i = history->mark_count - 1; i >= 0 && looked < LATEST; i--) {
        const struct mark *mark = &history->marks[i];
        if (mark->group == group->id) {
            looked++;
            if (mark_distance(mark, first->x0, first->y0) <= first->radius + APART) {
                return true;
            }
        }
    }
    return false;
}

/* The group that goes on with this action, or NULL. */
static struct group *find_open(struct history *history, const struct action *action, const struct mark *marks,
                               uint32_t moment)
{
    bool press = is_press(action);
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        struct group *group = &history->groups[i];
        bool open = group->state == GROUP_DONE && group->visitor == action->visitor &&
                    group->rewinds == (action->verb == ACTION_REWIND) &&
                    moment / MOMENTS - group->last / MOMENTS <= (uint32_t)history->def.pause;
        if (open && !press && goes_on(history, group, marks)) {
            return group;
        }
    }
    return NULL;
}

/* What a visitor has undone cannot come back; the oldest beyond so many levels stays painted. */
static void make_way(struct history *history, int visitor)
{
    struct group *oldest = NULL;
    int done = 0;
    for (int i = 0; i < HISTORY_GROUPS; i++) {
        struct group *group = &history->groups[i];
        if (group->visitor == visitor && group->state == GROUP_UNDONE) {
            history_drop_group(history, group);
        } else if (group->visitor == visitor && group->state == GROUP_DONE) {
            done++;
            oldest = !oldest || group->last < oldest->last ? group : oldest;
        }
    }
    if (done >= history->def.levels && oldest) {
        history_drop_group(history, oldest);
    }
}

struct group *history_group_for(struct history *history, const struct action *action, const struct mark *marks,
                                uint32_t moment)
{
    struct group *group = find_open(history, action, marks, moment);
    if (!group) {
        make_way(history, action->visitor);
        group = &history->groups[history->next_group % HISTORY_GROUPS];
        history_drop_group(history, group);
        *group = (struct group){.id = history->next_group++,
                                .visitor = action->visitor,
                                .state = GROUP_DONE,
                                .rewinds = action->verb == ACTION_REWIND,
                                .begin = moment};
    }
    group->last = moment;
    return group;
}

/* The oldest marks go; a group that has lost some cannot be undone. */
static void forget_marks(struct history *history, int count)
{
    for (int i = 0; i < count; i++) {
        struct group *group = &history->groups[history->marks[i].group % HISTORY_GROUPS];
        if (group->id == history->marks[i].group && group->state == GROUP_DONE) {
            history_drop_group(history, group);
        }
    }
    history->mark_count -= count;
    memmove(history->marks, history->marks + count, (size_t)history->mark_count * sizeof history->marks[0]);
}

void history_add_marks(struct history *history, const struct group *group, const struct mark *marks, int count)
{
    if (history->mark_count + count > HISTORY_MARKS) {
        forget_marks(history, HISTORY_MARKS / 4);
    }
    for (int i = 0; i < count; i++) {
        struct mark *mark = &history->marks[history->mark_count++];
        *mark = marks[i];
        mark->group = group->id;
        mark->moment = group->last;
    }
}
