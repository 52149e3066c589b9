/* Samples and the sums of their levels as a picture. The numbers are those of shaders/lightning/bolt_light.glsl. */
#include "bolt_light_work.h"

#include <math.h>

#include "exponential.h"

static float clamp(float value, float low, float high)
{
    return value > low ? value < high ? value : high : low;
}

/* The shoulder of film: light as it comes out, 0..1. */
static float shoulder(float light)
{
    return 1 - exponential2(-1.6f * light);
}

static float encode(const struct bolt_paint *paint, float linear)
{
    return paint->encoded[(int)(BOLT_ENCODED * sqrtf(clamp(linear, 0, 1)) + 0.5f)];
}

/* Colour `own`, 0..255 and multiplied by `cover`, over what is there or, where the ground hides that, over the ground;
 * `own` is linear where it lies on the ground. */
static void cover_pixel(const struct bolt_paint *paint, const float own[3], float cover, uint8_t *rgb)
{
    const struct bolt_view *view = paint->view;
    float flash = view->flash;
    for (int c = 0; c < 3; c++) {
        float under = view->clear ? (float)rgb[c] : encode(paint, view->look.ground[c]);
        float over = own[c] + (1 - cover) * under;
        rgb[c] = (uint8_t)clamp(over + flash * (255 - over) + 0.5f, 0, 255);
    }
}

void bolt_paint_light(const struct bolt_paint *paint, int y, uint8_t *rgb)
{
    const struct bolt_view *view = paint->view;
    const struct bolt_look *look = &view->look;
    const struct bolt_sample *row = paint->samples->samples + (size_t)y * (size_t)paint->width;
    float flash = view->flash;
    for (int x = 0; x < paint->width; x++) {
        float halo, root = (float)row[x].part[0] / 255, light = root * root, hot = clamp(1.6f * light - 0.2f, 0, 1);
        bolt_chain_at(paint->chain, (float)x + 0.5f, (float)y + 0.5f, &halo, NULL);
        for (int c = 0; c < 3; c++) {
            float tint = look->colour[c] + hot * (look->core[c] - look->colour[c]);
            float sum = 5 * light * tint + halo * (11 * look->colour[c] + 8 * halo * look->core[c]);
            float own = shoulder(sum);
            float ground = view->clear ? 0 : look->ground[c];
            float over = encode(paint, 1 - (1 - ground) * (1 - own));
            over += flash * (255 - over);
            if (view->clear) {
                over = 255 - (255 - over) * (255 - (float)rgb[3 * x + c]) / 255;
            }
            rgb[3 * x + c] = (uint8_t)clamp(over + 0.5f, 0, 255);
        }
    }
}

void bolt_paint_lines(const struct bolt_paint *paint, int y, uint8_t *rgb)
{
    const struct bolt_look *look = &paint->view->look;
    const struct bolt_sample *row = paint->samples->samples + (size_t)y * (size_t)paint->width;
    for (int x = 0; x < paint->width; x++) {
        float cover = (float)row[x].part[0] / 255, own[3];
        float core = cover > 0 ? clamp((float)row[x].part[1] / 255 / cover, 0, 1) : 0;
        for (int c = 0; c < 3; c++) {
            own[c] = cover * encode(paint, look->colour[c] + core * (look->core[c] - look->colour[c]));
        }
        cover_pixel(paint, own, cover, rgb + 3 * (size_t)x);
    }
}

static const float KEY[3] = {-0.4508f, -0.7013f, -0.5523f};  /* towards the light */
static const float HALF[3] = {-0.2558f, -0.3980f, -0.8810f}; /* halfway between it and the eye */

/* Of one sample that is not empty, linear; how far it lies behind its surroundings, in depth. */
static void shade(const struct bolt_view *view, struct bolt_sample sample, float depth, float behind, float out[3])
{
    const struct bolt_look *look = &view->look;
    bool leaf = sample.part[3] >= 128;
    float x = (float)sample.part[0] / 127 - 1, y = (float)sample.part[1] / 127 - 1;
    float z = -sqrtf(fmaxf(1 - x * x - y * y, 0)), tone = (float)sample.part[2] / 255;
    float heat = (float)(leaf ? sample.part[3] - 128 : sample.part[3] - 1) / 126;
    float facing = x * KEY[0] + y * KEY[1] + z * KEY[2];
    float shine = fmaxf(x * HALF[0] + y * HALF[1] + z * HALF[2], 0);
    shine *= shine, shine *= shine, shine *= shine, shine *= shine;
    float open = 1 / (1 + 100 * fmaxf(behind, 0));
    open *= open;
    float key = fmaxf(0.88f * facing + 0.12f, leaf ? 0.3f : 0) * (0.25f + 0.75f * open);
    float sky = (0.16f - 0.12f * y) * open, edge = (1 + z) * (1 + z) * 0.22f * open;
    float far = clamp((depth - 0.45f) * 3.2f, 0, 1);
    far = view->clear ? 0 : 0.8f * far * far * (3 - 2 * far);
    for (int c = 0; c < 3; c++) {
        float own = look->colour[c] + (leaf ? 1 : 0.7f * tone) * (look->core[c] - look->colour[c]);
        own *= 0.25f + 0.75f * heat;
        float light = own * (1.45f * key + 1.6f * sky + edge) + (leaf ? 0.06f : 0.16f) * shine * open;
        out[c] = shoulder(light) * (1 - far) + far * look->ground[c];
    }
}

void bolt_paint_bodies(const struct bolt_paint *paint, int y, uint8_t *rgb)
{
    const struct bolt_samples *samples = paint->samples;
    for (int x = 0; x < paint->width; x++) {
        float own[3] = {0}, cover = 0;
        for (int i = 0; i < BOLT_SUPER * BOLT_SUPER; i++) {
            int from_x = BOLT_SUPER * x + i % BOLT_SUPER, from_y = BOLT_SUPER * y + i / BOLT_SUPER;
            size_t from = (size_t)from_y * (size_t)samples->width + (size_t)from_x;
            if (!samples->samples[from].part[3]) {
                continue;
            }
            float value, weight;
            bolt_chain_at(paint->chain, (float)from_x + 0.5f, (float)from_y + 0.5f, &value, &weight);
            float depth = (float)samples->depth[from] / 65535, seen[3];
            shade(paint->view, samples->samples[from], depth, depth * weight - value, seen);
            for (int c = 0; c < 3; c++) {
                own[c] += encode(paint, seen[c]) / (BOLT_SUPER * BOLT_SUPER);
            }
            cover += 1.0f / (BOLT_SUPER * BOLT_SUPER);
        }
        cover_pixel(paint, own, cover, rgb + 3 * (size_t)x);
    }
}
