/* Segments as they are seen: turned, in perspective, come up and faded. */
#include "bolt_light_work.h"

#include <float.h>
#include <math.h>
#include <string.h>

static const float RISE[BOLT_STYLES] = {2, 12, 12}; /* ticks */
static const float FADE = 30;                       /* ticks, of what has no life of its own */
static const float NEAREST = 0.2f;                  /* of the distance of the sheet */
static const float DEPTH = 1.6f;                    /* of the longer side of the sheet: all that is told apart */
static const float DIMMED = 0.6f;                   /* of its strength, that the farthest has lost */

static float clamp(float value, float low, float high)
{
    return value > low ? value < high ? value : high : low;
}

/* Sine of so many turns, by its series: the same on every machine. */
static float sine(double turns)
{
    turns = isfinite(turns) ? turns - floor(turns + 0.5) : 0;
    turns = turns > 0.25 ? 0.5 - turns : turns < -0.25 ? -0.5 - turns : turns;
    double x = turns * 6.283185307179586, square = x * x, term = x, sum = x;
    for (int n = 2; n <= 16; n += 2) {
        term *= -square / (n * (n + 1));
        sum += term;
    }
    return (float)sum;
}

struct bolt_eye bolt_eye(const struct bolt_view *view, int width, int height)
{
    float wide = (float)(view->width > 1 ? view->width : 1), high = (float)(view->height > 1 ? view->height : 1);
    float longer = fmaxf(wide, high), x = (float)width / wide, y = (float)height / high;
    return (struct bolt_eye){.turn = {sine((double)view->turn), sine((double)view->turn + 0.25)},
                             .tilt = {sine((double)view->tilt), sine((double)view->tilt + 0.25)},
                             .middle = {wide / 2, high / 2},
                             .away = BOLT_AWAY * longer,
                             .scale = {x, y, sqrtf(x * y)},
                             .depth = 1 / (DEPTH * longer)};
}

struct bolt_view bolt_view_sound(const struct bolt_view *view)
{
    struct bolt_view sound = *view;
    for (int c = 0; c < 3; c++) {
        sound.look.colour[c] = clamp(view->look.colour[c], 0, 1);
        sound.look.core[c] = clamp(view->look.core[c], 0, 1);
        sound.look.ground[c] = clamp(view->look.ground[c], 0, 1);
    }
    sound.look.style = view->look.style > 0 && view->look.style < BOLT_STYLES ? view->look.style : BOLT_GLOW;
    sound.look.tip = clamp(view->look.tip, 0, BOLT_FAR);
    sound.look.trunk = fmaxf(clamp(view->look.trunk, 0, BOLT_FAR), sound.look.tip + 1e-3f);
    sound.flash = clamp(view->flash, 0, 1);
    return sound;
}

float bolt_age(const struct bolt_view *view, double tick)
{
    return (float)clamp((float)(tick - (double)view->tick), -1e9f, 1e9f);
}

float bolt_rise(const struct bolt_look *look)
{
    return RISE[look->style];
}

float bolt_fade(const struct bolt_look *look)
{
    return look->life >= 1 ? fminf(look->life, 1e6f) : FADE;
}

static bool near(const float place[3])
{
    return fabsf(place[0]) <= BOLT_FAR && fabsf(place[1]) <= BOLT_FAR && fabsf(place[2]) <= BOLT_FAR;
}

bool bolt_sound(const struct bolt_segment *segment, struct bolt_segment *sound)
{
    *sound = *segment;
    sound->radius = clamp(segment->radius, 0, BOLT_FAR);
    sound->radius_from = clamp(segment->radius_from, 0, BOLT_FAR);
    sound->heat = clamp(segment->heat, 0, 1);
    sound->leaf = clamp(segment->leaf, 0, BOLT_FAR);
    sound->birth = clamp(segment->birth, -1e9f, 1e9f);
    sound->death = segment->death < 1e9f ? fmaxf(segment->death, -1e9f) : FLT_MAX;
    return near(segment->from) && near(segment->to) && segment->birth < 1e9f && sound->heat > 0 &&
           (sound->radius > 0 || sound->radius_from > 0 || sound->leaf > 0);
}

/* Turned and tilted, about the middle. */
static void turn(const struct bolt_eye *eye, const float place[3], float seen[3])
{
    float x = eye->turn[1] * place[0] + eye->turn[0] * place[2];
    float z = eye->turn[1] * place[2] - eye->turn[0] * place[0];
    seen[0] = x;
    seen[1] = eye->tilt[1] * place[1] - eye->tilt[0] * z;
    seen[2] = eye->tilt[0] * place[1] + eye->tilt[1] * z;
}

/* Where a place is seen, how much larger than on the sheet, how deep; false when it is too near. */
static bool see(const struct bolt_eye *eye, const float place[3], float at[2], float *larger, float *depth)
{
    float seen[3];
    turn(eye, (float[3]){place[0] - eye->middle[0], place[1] - eye->middle[1], place[2]}, seen);
    float away = eye->away + seen[2];
    *larger = away > NEAREST * eye->away ? eye->away / away : 0;
    at[0] = (eye->middle[0] + seen[0] * *larger) * eye->scale[0];
    at[1] = (eye->middle[1] + seen[1] * *larger) * eye->scale[1];
    *depth = clamp(0.5f + seen[2] * eye->depth, 0, 1);
    return *larger > 0;
}

/* Between two places, with their radii in cells. */
static bool stroke_of(const struct bolt_eye *eye, const float from[3], const float to[3], float radius_from,
                      float radius, struct bolt_stroke *stroke)
{
    float end[2], larger[2];
    if (!see(eye, from, stroke->at, &larger[0], &stroke->depth[0]) ||
        !see(eye, to, end, &larger[1], &stroke->depth[1])) {
        return false;
    }
    stroke->along[0] = end[0] - stroke->at[0];
    stroke->along[1] = end[1] - stroke->at[1];
    float square = stroke->along[0] * stroke->along[0] + stroke->along[1] * stroke->along[1];
    stroke->shrink = square > 1e-6f ? 1 / square : 0;
    stroke->radius[0] = radius_from * larger[0] * eye->scale[2];
    stroke->radius[1] = radius * larger[1] * eye->scale[2];
    stroke->thick = eye->depth / eye->scale[2];
    float far = clamp(stroke->depth[0] + stroke->depth[1] - 1, 0, 1);
    stroke->strength *= 1 - DIMMED * far;
    return true;
}

static uint32_t mixed(uint32_t bits)
{
    bits = (bits ^ (bits >> 16)) * 0x7feb352du;
    bits = (bits ^ (bits >> 15)) * 0x846ca68bu;
    return bits ^ (bits >> 16);
}

/* -1..1, from where the leaf begins. */
static void chance(const float place[3], uint32_t salt, float out[3])
{
    uint32_t bits = salt;
    for (int i = 0; i < 3; i++) {
        float whole = place[i] + 0.0f; /* no -0 */
        uint32_t own;
        memcpy(&own, &whole, sizeof own);
        bits = mixed(bits ^ own);
    }
    for (int i = 0; i < 3; i++) {
        bits = mixed(bits + 0x9e3779b9u);
        out[i] = (float)(bits >> 8) / 8388608.0f - 1;
    }
}

static void unit(float v[3], float x, float y, float z)
{
    float square = v[0] * v[0] + v[1] * v[1] + v[2] * v[2];
    if (!(square > 1e-12f)) {
        v[0] = x, v[1] = y, v[2] = z;
        return;
    }
    float scale = 1 / sqrtf(square);
    v[0] *= scale, v[1] *= scale, v[2] *= scale;
}

/* A leaf goes on from its twig, to a side and a little up, and turns its face up and to the eye. */
static bool leaf_of(const struct bolt_eye *eye, const struct bolt_segment *segment, float grown,
                    struct bolt_stroke *stroke)
{
    float twig[3], side[3], face[3], end[3], normal[3];
    for (int i = 0; i < 3; i++) {
        twig[i] = segment->to[i] - segment->from[i];
    }
    unit(twig, 0, -1, 0);
    chance(segment->to, 1, side);
    for (int i = 0; i < 3; i++) {
        side[i] = 0.7f * twig[i] + 1.1f * side[i];
    }
    side[1] -= 0.1f;
    unit(side, 0, -1, 0);
    chance(segment->to, 2, face);
    face[0] *= 0.8f;
    face[1] = 0.8f * face[1] - 0.5f;
    face[2] = 0.8f * face[2] - 0.3f;
    float along = face[0] * side[0] + face[1] * side[1] + face[2] * side[2];
    for (int i = 0; i < 3; i++) {
        face[i] -= along * side[i];
        end[i] = segment->to[i] + 2 * grown * segment->leaf * side[i];
    }
    unit(face, 0, 0, -1);
    turn(eye, face, normal);
    float sign = normal[2] > 0 ? -1 : 1; /* both sides are seen */
    for (int i = 0; i < 3; i++) {
        stroke->normal[i] = sign * normal[i];
    }
    float breadth = 0.5f * grown * segment->leaf * (0.35f + 0.65f * fabsf(normal[2]));
    stroke->leaf = true;
    stroke->tone = 1;
    return stroke_of(eye, segment->to, end, breadth, breadth, stroke);
}

static float eased(float t)
{
    return t * t * (3 - 2 * t);
}

int bolt_strokes(const struct bolt_view *view, const struct bolt_eye *eye, float age,
                 const struct bolt_segment *segment, struct bolt_stroke strokes[2])
{
    const struct bolt_look *look = &view->look;
    int style = look->style, count = 0;
    float grown = eased(clamp((age - segment->birth) / bolt_rise(look), 0, 1)), left = 1;
    if (segment->death < FLT_MAX) {
        float fade = fmaxf(fminf(bolt_fade(look), segment->death - segment->birth), 1);
        float gone = clamp((age - segment->death) / fade + 1, 0, 1);
        left = style == BOLT_GLOW ? (1 - gone) * (1 - gone) : 1 - eased(gone);
    }
    if (!(grown * left > 0)) {
        return 0;
    }
    float size = style == BOLT_BODY ? grown * left : style == BOLT_LINE ? 0.4f + 0.6f * grown : 0.7f + 0.3f * left;
    struct bolt_stroke stroke = {.strength = style == BOLT_BODY ? segment->heat : segment->heat * grown * left};
    float slender = clamp((look->trunk - segment->radius) / (look->trunk - look->tip), 0, 1);
    stroke.tone = slender * slender * slender;
    strokes[count] = stroke;
    if (stroke_of(eye, segment->from, segment->to, size * segment->radius_from, size * segment->radius,
                  &strokes[count])) {
        count++;
    }
    strokes[count] = stroke;
    if (segment->leaf > 0 && leaf_of(eye, segment, style == BOLT_BODY ? size : grown, &strokes[count])) {
        count++;
    }
    return count;
}
