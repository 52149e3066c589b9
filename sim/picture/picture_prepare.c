#include "picture_work.h"

#include <string.h>

#include "exponential.h"

struct blur blur_of(float sigma)
{
    struct blur blur = {.radius = (int)(3 * sigma + 0.5f)};
    blur.radius = blur.radius < BLUR_RADIUS_MAX ? blur.radius : BLUR_RADIUS_MAX;
    float sum = 0;
    for (int i = 0; i <= blur.radius; i++) {
        blur.taps[i] = exponential(-0.5f * (float)(i * i) / (sigma * sigma));
        sum += i ? 2 * blur.taps[i] : blur.taps[i];
    }
    for (int i = 0; i <= blur.radius; i++) {
        blur.taps[i] /= sum;
    }
    return blur;
}

/* The border is repeated outwards. */
static void blur_across(const struct blur *blur, const float *in, int n, float *out)
{
    int inner = n - blur->radius;
    for (int x = 0; x < n; x++) {
        out[x] = blur->taps[0] * in[x];
    }
    for (int i = 1; i <= blur->radius; i++) {
        float tap = blur->taps[i];
        for (int x = blur->radius; x < inner; x++) {
            out[x] += tap * (in[x - i] + in[x + i]);
        }
    }
    for (int x = 0; x < n; x++) {
        if (x == blur->radius && inner > x) {
            x = inner;
        }
        for (int i = 1; i <= blur->radius; i++) {
            int left = x - i > 0 ? x - i : 0;
            int right = x + i < n - 1 ? x + i : n - 1;
            out[x] += blur->taps[i] * (in[left] + in[right]);
        }
    }
}

static void blur_down(const struct blur *blur, const float *plane, int width, int height, int y, float *out)
{
    const float *here = plane + (size_t)y * (size_t)width;
    for (int x = 0; x < width; x++) {
        out[x] = blur->taps[0] * here[x];
    }
    for (int i = 1; i <= blur->radius; i++) {
        float tap = blur->taps[i];
        int above = y - i > 0 ? y - i : 0;
        int below = y + i < height - 1 ? y + i : height - 1;
        const float *up = plane + (size_t)above * (size_t)width;
        const float *down = plane + (size_t)below * (size_t)width;
        for (int x = 0; x < width; x++) {
            out[x] += tap * (up[x] + down[x]);
        }
    }
}

float picture_depth_ref(const struct picture *picture)
{
    enum { BINS = 1024 };
    const float deepest = 2;
    const float carved = 0.1f;
    int64_t bins[BINS] = {0};
    int64_t count = 0;
    size_t cells = (size_t)picture->def.cells_x * (size_t)picture->def.cells_y;
    for (size_t i = 0; i < cells; i++) {
        float h = picture->planes.depth[i];
        if (h > carved) {
            int bin = h < deepest ? (int)(h * (BINS / deepest)) : BINS - 1;
            bins[bin < BINS ? bin : BINS - 1]++;
            count++;
        }
    }
    int64_t below = 0;
    int bin = 0;
    while (bin < BINS && (below += bins[bin]) * 5 < count * 4) {
        bin++;
    }
    float ref = ((float)bin + 0.5f) * (deepest / BINS);
    return ref > 0.25f ? ref : 0.25f;
}

void picture_prepare_across(struct picture_worker *worker, int y0, int y1)
{
    struct picture *picture = worker->picture;
    int width = picture->def.cells_x;
    float inverse = 0.9f / picture->depth_ref;
    const float scale = 0.45f / 0.716297870f; /* tanh(0.9): a well carved branch is 0.45 deep */
    for (int y = y0; y < y1; y++) {
        size_t at = (size_t)y * (size_t)width;
        const float *depth = picture->planes.depth + at;
        float *relief = picture->own[LAYER_RELIEF] + at;
        for (int x = 0; x < width; x++) {
            float h = depth[x] > 0 ? depth[x] : 0;
            relief[x] = scale * (1 - 2 / (exponential(2 * inverse * h) + 1));
        }
        blur_across(&picture->wide, depth, width, picture->blur_wide + at);
        blur_across(&picture->narrow, relief, width, picture->blur_narrow + at);
        blur_across(&picture->broad, relief, width, picture->blur_broad + at);
    }
}

/* How much of the pigment of a row shows as ink: `share` gets what multiplies each ink's amount, `line` the pigment on
 * ground that is not carved, `body` where there is any. `local` is the depth blurred over four cells. False where the
 * row has no pigment. */
static bool ink_share(const struct picture *picture, size_t at, const float *local, float *share, float *line,
                      float *body)
{
    const float *depth = picture->planes.depth + at;
    int width = picture->def.cells_x;
    float inverse = 1 / picture->depth_ref;
    float most = 0;
    for (int x = 0; x < width; x++) {
        share[x] = 0;
    }
    for (int i = 0; i < INK_PALETTE; i++) {
        if (picture->planes.ink[i]) {
            const float *ink = picture->planes.ink[i] + at;
            for (int x = 0; x < width; x++) {
                share[x] += ink[x] > 0 ? ink[x] : 0;
                most = share[x] > most ? share[x] : most;
            }
        }
    }
    if (most <= 0) {
        memset(line, 0, (size_t)width * sizeof *line);
        memset(body, 0, (size_t)width * sizeof *body);
        return false;
    }
    /* The paper's mixing clips to black where Kubelka-Munk only deepens. */
    float fullest = picture->def.mixing == INK_CMY ? 1.05f : 1.9f;
    for (int x = 0; x < width; x++) {
        float pigment = share[x];
        float h = depth[x] > 0 ? depth[x] : 0;
        float t = h * inverse;
        float carved = smooth_between(0.02f, 0.1f, h);
        float veins = (0.25f + 0.75f * power(t, 1.3f)) * (1 + 1.6f * (h - local[x]) * inverse);
        veins = veins > 0.12f ? veins : 0.12f;
        veins = veins < 2.2f ? veins : 2.2f;
        line[x] = (pigment < 0.25f ? 4 * pigment : 1) * (1 - carved);
        body[x] = pigment < 0.05f ? 20 * pigment : 1;
        /* Ink saturates: twice the pigment is not twice as dark. A drawn line has no depth to thicken it. */
        float ink = fullest * (1 - exponential(-pigment * (1 / 0.45f)));
        share[x] = ink / (pigment > 1e-6f ? pigment : 1e-6f) * (0.8f + (veins - 0.8f) * carved);
    }
    return true;
}

void picture_prepare_down(struct picture_worker *worker, int y0, int y1)
{
    struct picture *picture = worker->picture;
    int width = picture->def.cells_x;
    int height = picture->def.cells_y;
    unsigned inked = 0;
    for (int y = y0; y < y1; y++) {
        size_t at = (size_t)y * (size_t)width;
        blur_down(&picture->narrow, picture->blur_narrow, width, height, y, picture->own[LAYER_FILM] + at);
        blur_down(&picture->broad, picture->blur_broad, width, height, y, picture->own[LAYER_HOLLOW] + at);
        float *local = worker->cells[0];
        float *share = worker->cells[1];
        float *line = picture->own[LAYER_LINE] + at;
        blur_down(&picture->wide, picture->blur_wide, width, height, y, local);
        bool any = ink_share(picture, at, local, share, line, picture->own[LAYER_BODY] + at);
        for (int i = 0; i < INK_PALETTE; i++) {
            float *out = picture->own[LAYER_INK + i] + at;
            if (!any || !picture->planes.ink[i]) {
                memset(out, 0, (size_t)width * sizeof *out);
                continue;
            }
            const float *ink = picture->planes.ink[i] + at;
            float most = 0;
            for (int x = 0; x < width; x++) {
                out[x] = ink[x] > 0 ? ink[x] * share[x] : 0;
                most = out[x] > most ? out[x] : most;
            }
            inked |= most > 0 ? 1u << i : 0;
        }
        for (int x = 0; x < width; x++) {
            inked |= line[x] > 0 ? 1u << INK_PALETTE : 0;
        }
    }
    atomic_fetch_or(&picture->inked, inked);
}

void picture_prepare_plain(struct picture_worker *worker, int y0, int y1)
{
    struct picture *picture = worker->picture;
    size_t width = (size_t)picture->def.cells_x;
    unsigned inked = 0;
    for (int y = y0; y < y1; y++) {
        size_t at = (size_t)y * width;
        const float *depth = picture->planes.depth + at;
        float *plain = picture->own[LAYER_PLAIN] + at;
        for (size_t x = 0; x < width; x++) {
            float cover = 4 * depth[x];
            cover = cover > 0 ? cover : 0;
            cover = cover < 1 ? cover : 1;
            plain[x] = cover;
        }
        float *line = picture->own[LAYER_LINE] + at;
        memset(line, 0, width * sizeof *line);
        for (int i = 0; i < INK_PALETTE; i++) {
            const float *ink = picture->planes.ink[i] ? picture->planes.ink[i] + at : NULL;
            for (size_t x = 0; ink && x < width; x++) {
                line[x] += ink[x] > 0 ? ink[x] : 0;
                inked |= ink[x] > 0 ? 1u << i : 0;
            }
        }
        for (size_t x = 0; x < width; x++) {
            line[x] = (line[x] < 0.25f ? 4 * line[x] : 1) * (1 - smooth_between(0.02f, 0.1f, depth[x]));
            inked |= line[x] > 0 ? 1u << INK_PALETTE : 0;
        }
    }
    atomic_fetch_or(&picture->inked, inked);
}
