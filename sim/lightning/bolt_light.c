#include "bolt_light.h"

#include <stdlib.h>

#include "bolt_light_work.h"
#include "ink.h"

static bool make_samples(struct bolt_samples *samples, int style, int width, int height)
{
    size_t count = (size_t)width * (size_t)height;
    *samples = (struct bolt_samples){.width = width, .height = height, .style = style};
    samples->samples = calloc(count, sizeof *samples->samples);
    samples->depth = style == BOLT_BODY ? malloc(count * sizeof *samples->depth) : NULL;
    for (size_t i = 0; i < count && samples->depth; i++) {
        samples->depth[i] = UINT16_MAX;
    }
    return samples->samples && (style != BOLT_BODY || samples->depth);
}

static void finish_samples(struct bolt_samples *samples)
{
    free(samples->samples);
    free(samples->depth);
}

static void draw(const struct bolt_view *view, double tick, const struct bolt_samples *samples)
{
    struct bolt_eye eye = bolt_eye(view, samples->width, samples->height);
    float age = bolt_age(view, tick);
    for (int i = 0; i < view->count; i++) {
        struct bolt_segment sound;
        struct bolt_stroke strokes[2];
        int count = bolt_sound(&view->segments[i], &sound) ? bolt_strokes(view, &eye, age, &sound, strokes) : 0;
        for (int stroke = 0; stroke < count; stroke++) {
            bolt_draw(samples, &strokes[stroke]);
        }
    }
}

static void paint(const struct bolt_view *view, const struct bolt_samples *samples, const struct bolt_chain *chain,
                  int width, int height, uint8_t *rgb)
{
    static void (*const styles[BOLT_STYLES])(const struct bolt_paint *, int, uint8_t *) = {
        [BOLT_GLOW] = bolt_paint_light, [BOLT_LINE] = bolt_paint_lines, [BOLT_BODY] = bolt_paint_bodies};
    uint8_t encoded[BOLT_ENCODED + 1];
    for (int i = 0; i <= BOLT_ENCODED; i++) {
        float root = (float)i / BOLT_ENCODED;
        encoded[i] = (uint8_t)(255 * ink_encode(root * root) + 0.5f);
    }
    const struct bolt_paint job = {view, samples, chain, encoded, width, height};
    for (int y = 0; y < height; y++) {
        styles[samples->style](&job, y, rgb + 3 * (size_t)y * (size_t)width);
    }
}

bool bolt_light_lay(const struct bolt_view *view, double tick, int width, int height, uint8_t *rgb)
{
    struct bolt_view sound = bolt_view_sound(view);
    int style = sound.look.style;
    int super = style == BOLT_BODY ? BOLT_SUPER : 1;
    struct bolt_samples samples = {0};
    struct bolt_chain chain = {0};
    if (width < 1 || height < 1) {
        return true;
    }
    bool good = make_samples(&samples, style, super * width, super * height);
    if (good) {
        draw(&sound, tick, &samples);
        good = style == BOLT_LINE || bolt_chain_make(&chain, &samples);
    }
    if (good) {
        paint(&sound, &samples, &chain, width, height, rgb);
    }
    bolt_chain_finish(&chain);
    finish_samples(&samples);
    return good;
}
