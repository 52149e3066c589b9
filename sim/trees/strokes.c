#include "strokes.h"

#include <stdlib.h>

#include "random.h"

const char *const stroke_names[STROKE_KINDS + 1] = {"branch", "leaf", "tendril", "needle", NULL};

void strokes_finish(struct strokes *strokes)
{
    free(strokes->points);
    free(strokes->strokes);
    *strokes = (struct strokes){0};
}

void strokes_empty(struct strokes *strokes)
{
    strokes->count = strokes->point_count = 0;
}

bool strokes_begin(struct strokes *strokes, enum stroke_kind kind, int layer, int level, float reach, float tone)
{
    if (strokes->count == strokes->room) {
        int32_t room = 2 * strokes->room + 1024;
        struct stroke *more = realloc(strokes->strokes, (size_t)room * sizeof *more);
        if (!more) {
            return false;
        }
        strokes->strokes = more;
        strokes->room = room;
    }
    strokes->strokes[strokes->count++] = (struct stroke){.first = strokes->point_count,
                                                         .kind = (uint8_t)kind,
                                                         .layer = (uint8_t)layer,
                                                         .level = (uint8_t)level,
                                                         .reach = reach,
                                                         .tone = tone};
    return true;
}

bool strokes_point(struct strokes *strokes, float x, float y, float radius, float birth)
{
    if (strokes->point_count == strokes->point_room) {
        int32_t room = 2 * strokes->point_room + 8192;
        struct stroke_point *more = realloc(strokes->points, (size_t)room * sizeof *more);
        if (!more) {
            return false;
        }
        strokes->points = more;
        strokes->point_room = room;
    }
    strokes->points[strokes->point_count++] = (struct stroke_point){x, y, radius, birth};
    strokes->strokes[strokes->count - 1].count++;
    return true;
}

bool strokes_branches(struct strokes *strokes, const struct dendrite *dendrite, int layer)
{
    bool good = true;
    for (int32_t b = 0; b < dendrite->branch_count && good; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        const int32_t *order = dendrite->order + branch->first;
        const struct dendrite_node *nodes = dendrite->nodes;
        float tone = random_unit(nodes[order[0]].vertex, layer, 1, RANDOM_PLACE);
        float reach = branch->junction >= 0 ? nodes[branch->junction].reach : 0;
        good = strokes_begin(strokes, STROKE_BRANCH, layer, branch->level, reach, tone);
        if (good && branch->junction >= 0) {
            const struct dendrite_node *junction = &nodes[branch->junction];
            float own = nodes[order[0]].radius;
            own = own < junction->radius ? own : junction->radius; /* no knob where a twig leaves a trunk */
            good = strokes_point(strokes, junction->x, junction->y, own, junction->birth);
        }
        for (int32_t i = 0; i < branch->count && good; i++) {
            const struct dendrite_node *node = &nodes[order[i]];
            good = strokes_point(strokes, node->x, node->y, node->radius, node->birth);
        }
    }
    return good;
}
