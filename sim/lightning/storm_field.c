/* What a storm gives to others, and its hash. */
#include <math.h>
#include <stdlib.h>
#include <string.h>

#include "along.h"
#include "distance.h"
#include "hash.h"
#include "piece.h"
#include "rounded.h"
#include "storm_state.h"

enum { BACK = 5 };                /* particles that a direction is taken over */
static const float REACH = 0.02f; /* of the longer side: how far from a branch its direction is told */

/* It has grown, and neither water nor a visitor has taken it back; whether it has faded does not matter. */
static bool is_there(const struct storm *storm, int i)
{
    const struct storm_owner *owner = &storm->owners[i];
    const struct storm_bolt *bolt = &storm->bolts[owner->slot];
    const struct bolt_segment *segment = &storm->segments[i];
    return segment->birth <= (float)(storm->now - storm->origin) && segment->radius > 0 && bolt->undone == 0 &&
           bolt->nodes[owner->node].left > 0;
}

/* A piece, in pixels. */
struct piece {
    float ax, ay, bx, by, radius;
    int x0, x1, y0, y1; /* of what is within `radius` of it, end exclusive */
};

static struct piece piece_of(const struct storm *storm, const struct bolt_segment *segment, int width, int height,
                             float around)
{
    float x = (float)width / (float)storm->width, y = (float)height / (float)storm->height;
    struct piece piece = {segment->from[0] * x,
                          segment->from[1] * y,
                          segment->to[0] * x,
                          segment->to[1] * y,
                          fmaxf(segment->radius * sqrtf(x * y), 0.5f) + around,
                          0,
                          0,
                          0,
                          0};
    float reach = piece.radius + 1;
    piece.x0 = (int)fmaxf(fminf(piece.ax, piece.bx) - reach, 0);
    piece.y0 = (int)fmaxf(fminf(piece.ay, piece.by) - reach, 0);
    piece.x1 = (int)fminf(fmaxf(piece.ax, piece.bx) + reach + 1, (float)width);
    piece.y1 = (int)fminf(fmaxf(piece.ay, piece.by) + reach + 1, (float)height);
    return piece;
}

/* Of the middle of a pixel. */
static float distance_from(const struct piece *piece, int x, int y)
{
    float px = (float)x + 0.5f - piece->ax, py = (float)y + 0.5f - piece->ay;
    return sqrtf(piece_square(px, py, piece->bx - piece->ax, piece->by - piece->ay));
}

void storm_field_draw(const struct storm *storm, int slot, int width, int height, float *values)
{
    for (int i = 0; i < storm->count; i++) {
        if (!is_there(storm, i) || storm->owners[i].again || (slot >= 0 && storm->owners[i].slot != slot)) {
            continue;
        }
        struct piece piece = piece_of(storm, &storm->segments[i], width, height, 0);
        for (int y = piece.y0; y < piece.y1; y++) {
            for (int x = piece.x0; x < piece.x1; x++) {
                float cover = piece.radius + 0.5f - distance_from(&piece, x, y), *here = &values[y * width + x];
                cover = cover < 0 ? 0 : cover < 1 ? cover : 1;
                *here = 1 - cover < *here ? rounded(1 - cover) : *here;
            }
        }
    }
}

static void field_dark(const struct storm *storm, int width, int height, float *values)
{
    for (int i = 0; i < width * height; i++) {
        values[i] = 1;
    }
    storm_scar_lay(storm, width, height, values);
    storm_field_draw(storm, -1, width, height, values);
}

/* What of it is a scar tells its direction by what it looks like. */
static bool add_scars(const struct storm *storm, int width, int height, float *values)
{
    size_t count = (size_t)width * (size_t)height;
    float *dark = malloc(3 * count * sizeof *dark), *along = dark ? dark + count : NULL;
    for (size_t i = 0; i < count && dark; i++) {
        dark[i] = 1;
    }
    if (dark) {
        storm_scar_lay(storm, width, height, dark);
    }
    bool good = dark && along_of_pattern(dark, width, height, along);
    for (size_t i = 0; i < count && good; i++) {
        bool bare = !(fabsf(values[i]) > 0 || fabsf(values[count + i]) > 0);
        values[i] = bare ? along[i] : values[i];
        values[count + i] = bare ? along[count + i] : values[count + i];
    }
    free(dark);
    return good;
}

/* From some particles back to this one, in pixels. */
static void direction_of(const struct storm *storm, const struct storm_owner *owner, float x, float y, float way[2])
{
    const struct storm_bolt *bolt = &storm->bolts[owner->slot];
    int32_t back = owner->node;
    for (int i = 0; i < BACK && bolt->nodes[back].parent >= 0; i++) {
        back = bolt->nodes[back].parent;
    }
    way[0] = (bolt->nodes[owner->node].even[0] - bolt->nodes[back].even[0]) * x;
    way[1] = (bolt->nodes[owner->node].even[1] - bolt->nodes[back].even[1]) * y;
    float length = sqrtf(way[0] * way[0] + way[1] * way[1]);
    way[0] = length > 0 ? way[0] / length : 0;
    way[1] = length > 0 ? way[1] / length : 0;
}

/* Each branch tells its direction around it, the less the farther; where many do, they agree on one. */
static bool field_along(const struct storm *storm, int width, int height, float *values)
{
    size_t count = (size_t)width * (size_t)height;
    float *most = calloc(count, sizeof *most), reach = REACH * (float)(width > height ? width : height) + 1;
    if (!most) {
        return false;
    }
    memset(values, 0, 2 * count * sizeof *values);
    for (int i = 0; i < storm->count; i++) {
        const struct bolt_segment *segment = &storm->segments[i];
        float way[2];
        if (!is_there(storm, i) || storm->owners[i].again) {
            continue;
        }
        struct piece piece = piece_of(storm, segment, width, height, reach);
        direction_of(storm, &storm->owners[i], (float)width, (float)height, way);
        for (int y = piece.y0; y < piece.y1; y++) {
            for (int x = piece.x0; x < piece.x1; x++) {
                size_t at = (size_t)y * (size_t)width + (size_t)x;
                float near = 1 - fmaxf(distance_from(&piece, x, y) - (piece.radius - reach), 0) / reach;
                if (near > 0) {
                    values[at] += near * near * way[0];
                    values[count + at] += near * near * way[1];
                    most[at] = near > most[at] ? near : most[at];
                }
            }
        }
    }
    for (size_t i = 0; i < count; i++) {
        float x = values[i], y = values[count + i], length = sqrtf(x * x + y * y);
        float scale = length > 1e-6f ? most[i] / fmaxf(length, most[i]) : 0;
        values[i] = rounded(x * scale);
        values[count + i] = rounded(y * scale);
    }
    free(most);
    return add_scars(storm, width, height, values);
}

/* Eq. 10 over its range, from the lattice; nearer to a branch than a place of that, less by the distance. */
static bool field_around(const struct storm *storm, int width, int height, float *values)
{
    size_t count = (size_t)width * (size_t)height, places = (size_t)storm->columns * (size_t)storm->rows;
    float *potential = malloc(places * sizeof *potential), *far = malloc(count * sizeof *far);
    uint8_t *open = malloc(count);
    bool good = potential && far && open && storm_potential(storm, potential);
    if (good) {
        float least = potential[0], most = potential[0], spacing = (float)width / (float)storm->columns;
        bool any = false;
        for (size_t i = 0; i < places; i++) {
            least = fminf(least, potential[i]);
            most = fmaxf(most, potential[i]);
        }
        field_dark(storm, width, height, values);
        for (size_t i = 0; i < count; i++) {
            open[i] = values[i] > 0.5f;
            any = any || open[i] == 0;
        }
        good = distance_transform(open, width, height, far);
        for (size_t i = 0; i < count && good; i++) {
            float x = ((float)(i % (size_t)width) + 0.5f) / (float)width;
            size_t row = i / (size_t)width;
            float y = ((float)row + 0.5f) / (float)height;
            float high = any && most > least ? (most - storm_sample(storm, potential, x, y)) / (most - least) : 1;
            /* the border counts as ground in the transform: there the lattice alone tells */
            float edge = fminf(fminf(x, 1 - x) * (float)width, fminf(y, 1 - y) * (float)height) + 0.25f;
            float near = any && far[i] < edge ? fminf(far[i] / spacing, 1) : 1;
            near = open[i] == 0 ? 0 : near;
            values[i] = rounded(fminf(fmaxf(high, 0), 1) * near);
        }
    }
    free(potential);
    free(far);
    free(open);
    return good;
}

bool storm_field(void *scene, enum scene_field which, int width, int height, float *values)
{
    const struct storm *storm = scene;
    if (which == FIELD_ALONG) {
        return field_along(storm, width, height, values);
    }
    if (which == FIELD_AROUND) {
        return field_around(storm, width, height, values);
    }
    field_dark(storm, width, height, values);
    return true;
}

uint64_t storm_hash(const void *scene)
{
    const struct storm *storm = scene;
    uint64_t found = HASH_START;
    for (int i = 0; i < storm->count; i++) {
        const struct bolt_segment *segment = &storm->segments[i];
        for (int d = 0; d < 3; d++) {
            found = hash_number(found, (int64_t)floorf(segment->to[d] * 64));
        }
        found = hash_number(found, (int64_t)floorf(segment->radius * 256));
        found = hash_number(found, (int64_t)floorf(segment->heat * 256));
        found = hash_number(found, (int64_t)floorf(segment->birth));
        found = hash_number(found, segment->death < 1e9f ? (int64_t)floorf(segment->death) : -1);
    }
    for (int i = 0; i < storm->mask_columns * storm->mask_rows; i++) {
        found = storm->mask[i] < 0.5f ? hash_number(found, i) : found;
        found = storm->scar[i] > 0 ? hash_number(hash_number(found, i), storm->scar[i]) : found;
    }
    found = hash_number(found, storm->origin);
    return hash_number(hash_number(found, storm->def.kind), (int64_t)storm_particles(storm));
}
