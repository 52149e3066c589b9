/* What bolts look like as segments: radii by the pipe model, heat, deaths. */
#include <float.h>
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "random.h"
#include "storm_state.h"

enum { TWIG = 12, SPAN_MOST = 1 << 21 /* ticks since the origin that floats hold well */ };
static const float LEADER = 0.4f, SIDE = 0.42f; /* heat of a strike on its way, and beside its channel */
static const float BODY = 0.7f;                 /* heat of what has a body */
static const float KEEPS = 0.04f;               /* of a radius, that it may be off by while a bolt grows */
static const float SIDES_LIFE = 0.7f;           /* of a strike's life: its side branches */

void storm_touch(struct storm *storm, int segment)
{
    storm->since = segment < storm->since ? segment : storm->since;
}

static void count_tips(struct storm_bolt *bolt)
{
    struct storm_node *nodes = bolt->nodes;
    for (int32_t i = 0; i < bolt->count; i++) {
        nodes[i].tips = 0;
        nodes[i].heaviest = -1;
    }
    for (int32_t i = bolt->count - 1; i >= 0; i--) {
        nodes[i].tips = nodes[i].tips > 0 ? nodes[i].tips : 1;
        int32_t parent = nodes[i].parent;
        if (parent >= 0) {
            nodes[parent].tips += nodes[i].tips;
            int32_t rival = nodes[parent].heaviest;
            nodes[parent].heaviest = rival < 0 || nodes[i].tips >= nodes[rival].tips ? i : rival;
        }
    }
}

static void even_out(struct storm_bolt *bolt)
{
    struct storm_node *nodes = bolt->nodes;
    for (int32_t i = 0; i < bolt->count; i++) {
        memcpy(nodes[i].even, nodes[i].at, sizeof nodes[i].even);
    }
    for (int time = 0; time < bolt->look.smooth; time++) { /* in place, from the tips inwards */
        for (int32_t i = bolt->count - 1; i >= 0; i--) {
            struct storm_node *node = &nodes[i];
            for (int d = 0; d < 3 && node->parent >= 0 && node->heaviest >= 0; d++) {
                float beside = nodes[node->parent].even[d] + nodes[node->heaviest].even[d];
                node->even[d] = 0.5f * node->even[d] + 0.25f * beside;
            }
        }
    }
}

void storm_shape(struct storm *storm, struct storm_bolt *bolt)
{
    const struct bolt_look *look = &bolt->look;
    struct storm_node *nodes = bolt->nodes;
    float most = 1;
    count_tips(bolt);
    even_out(bolt);
    for (int32_t i = 0; i < bolt->count; i++) {
        most = (float)nodes[i].tips > most ? (float)nodes[i].tips : most;
    }
    bolt->most = (int32_t)most;
    float expected = (float)bolt->limit / (float)(bolt->count < bolt->limit ? bolt->count : bolt->limit), left = 1;
    if (bolt->complete) { /* what it would have carried counts less and less */
        left = storm->now < bolt->swells ? (float)(bolt->swells - storm->now) / STORM_SWELL : 0;
    }
    most *= 1 + left * (expected - 1);
    bolt->whole = bolt_shape_excess(look, most);
    int32_t known = 0;
    float radius = look->tip;
    for (int32_t i = 0; i < bolt->count; i++) {
        if (nodes[i].tips != known) {
            known = nodes[i].tips;
            radius = bolt_shape_radius(look, known, bolt->whole);
        }
        nodes[i].radius = radius;
    }
    bolt->shaped = storm->now;
}

static float since_origin(const struct storm *storm, int64_t tick)
{
    return tick == STORM_AGES ? FLT_MAX : (float)(tick - storm->origin);
}

static float death_of(const struct storm *storm, const struct storm_bolt *bolt, const struct storm_node *node)
{
    float last = since_origin(storm, bolt->gone);
    if (bolt->complete && bolt->life > 0) {
        float share = bolt->hit >= 0 && !node->channel ? SIDES_LIFE : 1;
        last = fminf(last, since_origin(storm, bolt->struck) + 1 + share * bolt->life);
    }
    return last;
}

/* Lines are as opaque, bodies as light everywhere; light is brighter where much comes together. */
static float heat_of(const struct storm *storm, const struct storm_bolt *bolt, const struct storm_node *node)
{
    if (bolt->aims) {
        float broad = fmaxf(storm->def.thickness / STORM_BROAD, 1), dimmed = 1 / (broad * broad);
        if (bolt->hit < 0) {
            return LEADER * dimmed;
        }
        return node->channel ? (bolt->dim ? dimmed : 1) : SIDE * dimmed;
    }
    if (bolt->look.style != BOLT_GLOW) {
        return bolt->look.style == BOLT_LINE ? 1 : BODY;
    }
    float most = (float)bolt->most, share = (float)node->tips / (most > 1 ? most : 1);
    return 0.2f + 0.8f * sqrtf(share < 1 ? share : 1);
}

static float leaf_of(const struct storm_bolt *bolt, int32_t i)
{
    const struct bolt_look *look = &bolt->look;
    if (look->leaves <= 0 || bolt->nodes[i].tips > TWIG) {
        return 0;
    }
    bool bears = random_unit(i, 0, 7, RANDOM_PLACE) * look->leaves < 1;
    return bears ? (2.2f + 1.6f * random_unit(i, 1, 7, RANDOM_PLACE)) * look->tip : 0;
}

static void place(const struct storm *storm, const struct storm_bolt *bolt, const struct storm_node *node, float at[3])
{
    float across = bolt->scale * (float)storm->width / bolt->width;
    float down = bolt->scale * (float)storm->height / bolt->height;
    at[0] = 0.5f * (float)storm->width + node->even[0] * across;
    at[1] = 0.5f * (float)storm->height + node->even[1] * down;
    at[2] = node->even[2] * across;
}

/* All but birth and death. */
static struct bolt_segment segment_of(const struct storm *storm, const struct storm_bolt *bolt, int32_t i)
{
    const struct storm_node *node = &bolt->nodes[i], *parent = &bolt->nodes[node->parent];
    float scale = storm->def.thickness * (float)storm->width / bolt->width;
    bool goes_on = parent->heaviest == i || parent->parent < 0;
    float widest = goes_on ? parent->radius : fminf(1.3f * node->radius, parent->radius);
    struct bolt_segment segment = {.radius = scale * node->radius * node->left,
                                   .radius_from = scale * widest * node->left,
                                   .heat = heat_of(storm, bolt, node),
                                   .leaf = scale * leaf_of(bolt, i) * node->left};
    place(storm, bolt, parent, segment.from);
    place(storm, bolt, node, segment.to);
    return segment;
}

static bool make_room(struct storm *storm, int count)
{
    if (storm->count + count <= storm->room) {
        return true;
    }
    int wide = storm->count + count + storm->room / 2 + 1024;
    struct bolt_segment *segments = realloc(storm->segments, (size_t)wide * sizeof *segments);
    storm->segments = segments ? segments : storm->segments;
    struct storm_owner *owners = segments ? realloc(storm->owners, (size_t)wide * sizeof *owners) : NULL;
    storm->owners = owners ? owners : storm->owners;
    storm->room = owners ? wide : storm->room;
    return owners;
}

bool storm_show(struct storm *storm, int slot, int32_t first)
{
    struct storm_bolt *bolt = &storm->bolts[slot];
    if (!make_room(storm, bolt->count - first)) {
        return false;
    }
    for (int32_t i = first; i < bolt->count; i++) {
        struct storm_node *node = &bolt->nodes[i];
        if (node->parent >= 0 && node->left > 0) {
            struct bolt_segment segment = segment_of(storm, bolt, i);
            segment.birth = since_origin(storm, storm->now);
            segment.death = death_of(storm, bolt, node);
            node->segment = storm->count;
            storm_touch(storm, storm->count);
            storm->owners[storm->count] = (struct storm_owner){slot, i, false};
            storm->segments[storm->count++] = segment;
        }
    }
    return true;
}

bool storm_show_again(struct storm *storm, int slot)
{
    struct storm_bolt *bolt = &storm->bolts[slot];
    int length = 0;
    for (int32_t i = bolt->hit; i >= 0; i = bolt->nodes[i].parent) {
        length++;
    }
    if (!make_room(storm, length)) {
        return false;
    }
    for (int32_t i = bolt->hit; i >= 0; i = bolt->nodes[i].parent) {
        if (bolt->nodes[i].parent >= 0 && bolt->nodes[i].left > 0) {
            struct bolt_segment segment = segment_of(storm, bolt, i);
            segment.birth = since_origin(storm, storm->now);
            segment.death = segment.birth + STORM_ECHO * bolt->life;
            storm_touch(storm, storm->count);
            storm->owners[storm->count] = (struct storm_owner){slot, i, true};
            storm->segments[storm->count++] = segment;
        }
    }
    return true;
}

void storm_hide(struct storm *storm, int slot)
{
    int kept = 0;
    struct storm_bolt *bolt = &storm->bolts[slot];
    for (int i = 0; i < storm->count; i++) {
        const struct storm_owner *owner = &storm->owners[i];
        if (owner->slot == slot) {
            storm_touch(storm, kept);
            continue;
        }
        if (kept < i) {
            if (!owner->again) {
                storm->bolts[owner->slot].nodes[owner->node].segment = kept;
            }
            storm->owners[kept] = *owner;
            storm->segments[kept] = storm->segments[i];
        }
        kept++;
    }
    storm->count = kept;
    for (int32_t i = 0; i < bolt->count; i++) {
        bolt->nodes[i].segment = -1;
    }
}

static bool are_same(const struct bolt_segment *a, const struct bolt_segment *b)
{
    bool same = a->radius == b->radius && a->radius_from == b->radius_from && a->death == b->death &&
                a->heat == b->heat && a->leaf == b->leaf;
    for (int d = 0; d < 3; d++) {
        same = same && a->from[d] == b->from[d] && a->to[d] == b->to[d];
    }
    return same;
}

void storm_dress(struct storm *storm, int slot)
{
    const struct storm_bolt *bolt = &storm->bolts[slot];
    for (int32_t i = 0; i < bolt->count; i++) {
        const struct storm_node *node = &bolt->nodes[i];
        if (node->segment < 0 || node->left <= 0) { /* what is washed away goes as it is */
            continue;
        }
        struct bolt_segment *shown = &storm->segments[node->segment], segment = segment_of(storm, bolt, i);
        segment.birth = shown->birth;
        segment.death = death_of(storm, bolt, node);
        if (!bolt->complete && fabsf(segment.radius - shown->radius) <= KEEPS * shown->radius) {
            segment.radius = shown->radius;
        }
        if (!bolt->complete && fabsf(segment.radius_from - shown->radius_from) <= KEEPS * shown->radius_from) {
            segment.radius_from = shown->radius_from;
        }
        if (!bolt->complete && fabsf(segment.heat - shown->heat) <= KEEPS) {
            segment.heat = shown->heat;
        }
        if (!are_same(shown, &segment)) {
            *shown = segment;
            storm_touch(storm, node->segment);
        }
    }
    float last = since_origin(storm, bolt->gone);
    for (int i = 0; i < storm->count && bolt->agains > 0; i++) {
        if (storm->owners[i].slot == slot && storm->owners[i].again && storm->segments[i].death > last) {
            storm->segments[i].death = last;
            storm_touch(storm, i);
        }
    }
}

void storm_rebase(struct storm *storm)
{
    if (storm->now - storm->origin <= SPAN_MOST) {
        return;
    }
    float later = (float)(storm->now - storm->origin);
    for (int i = 0; i < storm->count; i++) {
        struct bolt_segment *segment = &storm->segments[i];
        segment->birth -= later;
        segment->death = segment->death < FLT_MAX ? segment->death - later : FLT_MAX;
    }
    storm->origin = storm->now;
    storm_touch(storm, 0);
}

/* The light of a strike over all, for a moment. */
static float flash_at(const struct storm *storm, int64_t tick)
{
    float age = (float)(tick - storm->flashed), left = 1 - age / STORM_FLASH;
    return storm->flash > 0 && age >= 0 && left > 0 ? storm->flash * left * left : 0;
}

struct bolt_view storm_view(struct storm *storm, int64_t tick, int *since)
{
    struct bolt preset;
    double turns = storm->def.dimensions == 3 ? (double)storm->def.turn * (double)tick / 3600 : 0;
    bolt_preset(&preset, (enum bolt_kind)storm->def.kind, storm->width, storm->height);
    struct bolt_view view = {.segments = storm->segments,
                             .count = storm->count,
                             .tick = storm->origin,
                             .width = storm->width,
                             .height = storm->height,
                             .turn = (float)(turns - floor(turns)),
                             .look = preset.look,
                             .clear = storm->def.clear,
                             .flash = flash_at(storm, tick)};
    view.look.trunk *= storm->def.thickness;
    view.look.tip *= storm->def.thickness;
    view.look.life = storm->def.life;
    *since = storm->since < storm->count ? storm->since : storm->count;
    storm->since = storm->count;
    return view;
}
