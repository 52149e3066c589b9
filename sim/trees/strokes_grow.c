/* What grows on branches: leaves, tendrils, needles. */
#include <math.h>

#include "random.h"
#include "strokes.h"

static const float PI = 3.14159265f;

static float chance(const struct dendrite_node *node, int what, uint32_t seed)
{
    return random_unit(node->vertex, what, seed, RANDOM_PLACE);
}

/* Where a branch leads at its i-th node, radians. */
static float heading(const struct dendrite *dendrite, const struct dendrite_branch *branch, int32_t i)
{
    const int32_t *order = dendrite->order + branch->first;
    int32_t before = i >= 3 ? order[i - 3] : branch->junction >= 0 ? branch->junction : order[0];
    int32_t after = i + 2 < branch->count ? order[i + 2] : order[branch->count - 1];
    const struct dendrite_node *a = &dendrite->nodes[before], *b = &dendrite->nodes[after];
    return atan2f(b->y - a->y, b->x - a->x);
}

/* A leaf is a stroke that is widest a third along, on a stalk, bent a little. */
static bool add_leaf(struct strokes *strokes, const struct dendrite_node *node, float angle, float size, int layer,
                     float tone)
{
    enum { STALK = 2, BLADE = 9 };
    float x = node->x, y = node->y, birth = node->birth, bend = (tone - 0.5f) * 0.16f;
    if (!strokes_begin(strokes, STROKE_LEAF, layer, node->level, node->reach, tone)) {
        return false;
    }
    for (int i = 0; i <= STALK + BLADE; i++) {
        float along = (float)(i - STALK) / BLADE;
        float wide = i < STALK ? 0.04f : 0.24f * powf(sinf(PI * powf(along, 0.72f)), 0.85f) + 0.012f;
        if (!strokes_point(strokes, x, y, size * wide, birth)) {
            return false;
        }
        float step = size / (STALK + BLADE);
        birth += step * strokes->pace;
        x += step * cosf(angle);
        y += step * sinf(angle);
        angle += bend;
    }
    return true;
}

bool strokes_leaves(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, float apart,
                    uint32_t seed)
{
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        const int32_t *order = dendrite->order + branch->first;
        float next =
            dendrite->nodes[order[0]].reach + apart * (0.3f + 0.7f * chance(&dendrite->nodes[order[0]], 2, seed));
        int side = (b & 1) * 2 - 1;
        for (int32_t i = 0; i < branch->count; i++) {
            const struct dendrite_node *node = &dendrite->nodes[order[i]];
            bool tip = i == branch->count - 1;
            if ((node->reach < next && !tip) || (tip && branch->count < 4)) {
                continue;
            }
            float luck = chance(node, 3, seed);
            float turn = tip ? 0.3f * (luck - 0.5f) : (float)side * (0.65f + 0.5f * luck);
            float own = size * (0.62f + 0.5f * chance(node, 4, seed)) * (tip ? 0.9f : 1);
            if (!add_leaf(strokes, node, heading(dendrite, branch, i) + turn, own, layer, chance(node, 5, seed))) {
                return false;
            }
            next = node->reach + apart * (0.6f + 0.8f * luck);
            side = -side;
        }
    }
    return true;
}

bool strokes_tendrils(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, uint32_t seed)
{
    enum { POINTS = 34 };
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        int32_t i = branch->count - 1;
        const struct dendrite_node *node = &dendrite->nodes[dendrite->order[branch->first + i]];
        if (branch->count < 6 || chance(node, 6, seed) > 0.45f) {
            continue;
        }
        float angle = heading(dendrite, branch, i), turn = chance(node, 7, seed) < 0.5f ? -1 : 1;
        float own = size * (0.6f + 0.8f * chance(node, 8, seed)), x = node->x, y = node->y;
        float birth = node->birth;
        if (!strokes_begin(strokes, STROKE_TENDRIL, layer, node->level, node->reach, chance(node, 9, seed))) {
            return false;
        }
        for (int k = 0; k < POINTS; k++) {
            float along = (float)k / POINTS, thin = node->radius * 0.8f * (1 - 0.6f * along);
            if (!strokes_point(strokes, x, y, thin > 0.22f ? thin : 0.22f, birth)) {
                return false;
            }
            float step = own * 0.13f * (1 - 0.72f * along);
            birth += step * strokes->pace;
            x += step * cosf(angle);
            y += step * sinf(angle);
            angle += turn * (0.02f + 0.52f * along);
        }
    }
    return true;
}

static bool add_needle(struct strokes *strokes, const struct dendrite_node *node, float angle, float size, int layer,
                       float tone)
{
    static const float ALONG[] = {0, 0.6f, 1}, RADIUS[] = {0.32f, 0.25f, 0.12f};
    bool good = strokes_begin(strokes, STROKE_NEEDLE, layer, node->level, node->reach, tone);
    for (int i = 0; i < 3 && good; i++) {
        float far = ALONG[i] * size;
        good = strokes_point(strokes, node->x + far * cosf(angle), node->y + far * sinf(angle), RADIUS[i],
                             node->birth + far * strokes->pace);
    }
    return good;
}

bool strokes_needles(struct strokes *strokes, const struct dendrite *dendrite, int layer, float size, uint32_t seed)
{
    for (int32_t b = 0; b < dendrite->branch_count; b++) {
        const struct dendrite_branch *branch = &dendrite->branches[b];
        for (int32_t i = 1; i < branch->count; i += 2) {
            const struct dendrite_node *node = &dendrite->nodes[dendrite->order[branch->first + i]];
            float angle = heading(dendrite, branch, i);
            float left = (float)(branch->count - i) / 16, own = size * (left < 1 ? 0.35f + 0.65f * left : 1);
            for (int side = -1; side <= 1; side += 2) {
                float luck = chance(node, 10 + side, seed);
                if (luck > 0.25f && !add_needle(strokes, node, angle + (float)side * PI / 3,
                                                own * (0.35f + 0.9f * luck * node->radius), layer, luck)) {
                    return false;
                }
            }
        }
    }
    return true;
}
