#include "motif.h"

#include <math.h>
#include <stddef.h>

#include "noise.h"
#include "smooth.h"

const char *const motif_names[MOTIFS + 1] = {"portrait", "sphere", "landscape", "winter", "leaf", NULL};

/* All of it in a square from -1 to 1, x to the right and y down. */
struct spot {
    float x, y;
};

static float bump(struct spot at, float x, float y, float wide, float high)
{
    float dx = (at.x - x) / wide, dy = (at.y - y) / high;
    return expf(-(dx * dx + dy * dy));
}

static float mix(float a, float b, float t)
{
    return a + (b - a) * t;
}

static float both_bumps(struct spot at, float x, float y, float wide, float high)
{
    return bump(at, x, y, wide, high) + bump(at, -x, y, wide, high);
}

/* How far a face stands out. */
static float face_height(struct spot at)
{
    float dx = at.x / (0.47f - 0.10f * smooth_between(0.1f, 0.7f, at.y)), dy = (at.y + 0.02f) / 0.66f;
    float head = 1 - dx * dx - dy * dy;
    float height = head > 0 ? 0.42f * sqrtf(head) : 0;
    float nose = 0.12f * bump(at, 0, 0.0f, 0.055f, 0.22f) * smooth_between(-0.3f, 0.1f, at.y);
    nose += 0.11f * bump(at, 0, 0.145f, 0.07f, 0.07f) + 0.05f * both_bumps(at, 0.065f, 0.165f, 0.04f, 0.035f);
    float eyes = -0.10f * both_bumps(at, 0.19f, -0.11f, 0.12f, 0.075f);
    eyes += 0.065f * both_bumps(at, 0.19f, -0.10f, 0.07f, 0.045f);
    float brow = 0.05f * both_bumps(at, 0.18f, -0.23f, 0.15f, 0.05f);
    float cheek = 0.06f * both_bumps(at, 0.27f, 0.10f, 0.13f, 0.11f);
    float mouth = 0.05f * bump(at, 0, 0.30f, 0.13f, 0.035f) + 0.055f * bump(at, 0, 0.37f, 0.11f, 0.04f);
    mouth -= 0.05f * bump(at, 0, 0.335f, 0.17f, 0.014f) + 0.03f * bump(at, 0, 0.44f, 0.12f, 0.04f);
    float chin = 0.06f * bump(at, 0, 0.54f, 0.12f, 0.08f);
    return height + nose + eyes + brow + cheek + mouth + chin;
}

/* Light from the upper left on a height; 0..1. */
static float lit(float left, float right, float up, float down, float apart)
{
    float nx = (left - right) / (2 * apart), ny = (up - down) / (2 * apart);
    float length = sqrtf(nx * nx + ny * ny + 1);
    float light = (-0.52f * nx - 0.50f * ny + 0.69f) / length;
    return light > 0 ? light : 0;
}

static float eye_tone(struct spot at, float tone)
{
    for (int side = -1; side <= 1; side += 2) {
        float x = at.x - 0.19f * (float)side, y = at.y + 0.105f;
        float lid = 0.046f - 2.6f * x * x, open = lid - fabsf(y + 0.006f);
        float white = smooth_between(0, 0.008f, open);
        float iris = smooth_between(0.048f, 0.040f, sqrtf(x * x + y * y)),
              pupil = smooth_between(0.021f, 0.016f, sqrtf(x * x + y * y));
        float glint = smooth_between(0.013f, 0.008f, hypotf(x + 0.014f, y + 0.015f));
        float ball = mix(mix(mix(0.78f, 0.26f, iris), 0.02f, pupil), 0.95f, glint);
        tone = mix(tone, ball, white);
        tone = mix(tone, 0.04f,
                   smooth_between(0.014f, 0.004f, fabsf(y + lid + 0.004f)) * smooth_between(0.15f, 0.12f, fabsf(x)));
        float arch = at.y + 0.235f + 0.9f * (fabsf(x) * fabsf(x)) + 0.02f * x * (float)side;
        tone = mix(tone, 0.09f,
                   0.9f * smooth_between(0.034f, 0.012f, fabsf(arch)) * smooth_between(0.165f, 0.10f, fabsf(x)));
    }
    return tone;
}

/* Hair falls from a parting to the shoulders, in strands. */
static float hair_tone(struct spot at, float *cover)
{
    float px = at.x - 0.06f, fall = smooth_between(-0.85f, 0.9f, at.y);
    float outer = hypotf(px / (0.60f + 0.10f * fall), (at.y + 0.12f) / 0.78f);
    float line = -0.44f + 0.55f * px * px + 1.4f * fabsf(px) * fabsf(px) * fabsf(px) + 0.10f * px;
    float forehead = smooth_between(line + 0.02f, line - 0.02f, at.y);
    float sides = smooth_between(0.385f, 0.43f, fabsf(at.x) + 0.10f * smooth_between(0.0f, 0.75f, at.y)) *
                  smooth_between(0.86f, 0.45f, at.y + 0.09f * sinf(31 * at.x) + 0.05f * sinf(57 * at.x));
    float inside = at.y < 0.1f ? smooth_between(1.03f, 0.99f, outer)
                               : smooth_between(0.68f, 0.64f, fabsf(px) + 0.02f * sinf(14 * at.y));
    *cover = inside * (forehead > sides ? forehead : sides);
    float along = fabsf(px) * 20 + 3.2f * at.y + 1.3f * sinf(3.1f * at.y + 2 * px);
    float strand = 0.5f + 0.5f * sinf(3.2f * along + 2 * noise_smooth(at.x * 300, at.y * 60, 40, 5, RANDOM_SMOOTH));
    float sheen = bump(at, -0.32f, -0.55f, 0.22f, 0.14f) + 0.6f * bump(at, 0.36f, -0.42f, 0.12f, 0.22f);
    return 0.015f + 0.045f * strand * strand + 0.22f * sheen * strand;
}

static float portrait(struct spot at)
{
    const float apart = 0.004f;
    at.y += 0.10f;
    at.x += 0.03f * at.y;
    float back = mix(0.70f, 0.34f, smooth_between(-1, 1, at.x + 0.4f * at.y)), tone = back;
    float neck = smooth_between(0.235f, 0.215f, fabsf(at.x) - 0.10f * smooth_between(0.75f, 1.1f, at.y)) *
                 smooth_between(0.35f, 0.45f, at.y);
    tone = mix(tone, 0.40f - 0.24f * bump(at, 0.03f, 0.66f, 0.30f, 0.13f) - 0.5f * at.x, neck);
    float shoulder = 0.80f + 0.55f * (fabsf(at.x) - 0.15f) * (fabsf(at.x) - 0.15f);
    float collar = 0.98f - 0.9f * fabsf(at.x);
    float cloth = smooth_between(-0.01f, 0.01f, at.y - (shoulder > collar ? shoulder : collar));
    tone = mix(tone, 0.05f + 0.05f * (0.5f + 0.5f * sinf(26 * at.x + 9 * at.y)), cloth);
    float dx = at.x / (0.47f - 0.10f * smooth_between(0.1f, 0.7f, at.y)), dy = (at.y + 0.02f) / 0.66f;
    float face = smooth_between(1.0f, 0.97f, dx * dx + dy * dy);
    if (face > 0) {
        struct spot l = {at.x - apart, at.y}, r = {at.x + apart, at.y}, u = {at.x, at.y - apart},
                    d = {at.x, at.y + apart};
        float skin = 0.06f + 0.78f * lit(face_height(l), face_height(r), face_height(u), face_height(d), apart);
        skin *= 1 - 0.45f * bump(at, 0, 0.335f, 0.15f, 0.05f); /* lips */
        skin = mix(skin, 0.03f,
                   smooth_between(0.012f, 0.004f, fabsf(at.y - 0.337f + 0.25f * at.x * at.x)) *
                       smooth_between(0.155f, 0.12f, fabsf(at.x)));
        skin = mix(skin, 0.05f, 0.8f * both_bumps(at, 0.035f, 0.195f, 0.022f, 0.014f)); /* nostrils */
        tone = mix(tone, eye_tone(at, skin), face);
    }
    float cover, hair = hair_tone(at, &cover);
    return mix(tone, hair, cover);
}

static float sphere(struct spot at)
{
    float x = at.x / 0.62f, y = (at.y + 0.08f) / 0.62f, square = x * x + y * y;
    float ground = at.y > 0.30f ? mix(0.36f, 0.66f, smooth_between(0.3f, 1, at.y))
                                : mix(0.50f, 0.80f, smooth_between(-1, 0.3f, at.y));
    ground *= 1 - 0.75f * bump(at, 0.30f, 0.60f, 0.55f, 0.13f);
    if (square >= 1) {
        return ground;
    }
    float z = sqrtf(1 - square), light = -0.53f * x - 0.60f * y + 0.60f * z;
    float shine = -0.30f * x - 0.34f * y + 0.89f * z;
    float tone = 0.04f + 0.70f * (light > 0 ? light : 0) + 0.6f * powf(shine > 0 ? shine : 0, 60);
    tone += 0.10f * smooth_between(0.5f, 1, square) * smooth_between(0, 0.8f, y); /* light from the ground */
    return mix(ground, tone, smooth_between(1, 0.985f, square));
}

/* A leaf with its veins. */
static float leaf(struct spot at)
{
    float x = 0.80f * at.x + 0.60f * at.y, y = -0.60f * at.x + 0.80f * at.y; /* along, across */
    float half = x > -0.9f && x < 0.9f ? 0.46f * powf(1 - powf(fabsf(x) / 0.9f, 2.2f), 0.8f) : 0;
    half *= 1 + 0.03f * sinf(60 * x);
    float inside = smooth_between(0, 0.015f, half - fabsf(y));
    float side = (x + 0.75f * fabsf(y)) * 6.5f, rib = fabsf(side - floorf(side) - 0.5f);
    float vein = smooth_between(0.10f, 0.03f, rib) * 0.7f;
    float middle = smooth_between(0.022f, 0.010f, fabsf(y));
    vein = vein > middle ? vein : middle;
    float tone = 0.30f + 0.16f * y + 0.10f * noise_smooth(at.x * 100, at.y * 100, 14, 3, RANDOM_SMOOTH);
    tone = mix(tone, 0.03f, vein);
    float stalk =
        smooth_between(0.02f, 0.01f, fabsf(y)) * smooth_between(0.86f, 0.9f, x) * smooth_between(1.2f, 1.1f, x);
    return mix(mix(0.86f, 0.10f, stalk), tone, inside);
}

struct scene {
    float sky_top[3], sky_low[3], hill_far[3], hill_near[3], ground[3], shade[3];
};

static const struct scene SUMMER = {{0.16f, 0.34f, 0.56f}, {0.80f, 0.66f, 0.44f}, {0.26f, 0.34f, 0.42f},
                                    {0.11f, 0.17f, 0.12f}, {0.30f, 0.27f, 0.09f}, {0.06f, 0.07f, 0.03f}};
static const struct scene WINTER = {{0.40f, 0.46f, 0.52f}, {0.80f, 0.76f, 0.70f}, {0.48f, 0.53f, 0.58f},
                                    {0.36f, 0.40f, 0.45f}, {0.82f, 0.83f, 0.84f}, {0.42f, 0.49f, 0.60f}};

static void blend(float colour[3], const float other[3], float t)
{
    for (int c = 0; c < 3; c++) {
        colour[c] = mix(colour[c], other[c], t);
    }
}

/* Sky, two rows of hills, a field with a path, in broad strokes. */
static void landscape(const struct scene *scene, struct spot at, float wide, float rgb[3])
{
    float x = at.x * wide;
    float stroke = noise_smooth(x * 200 + at.y * 60, at.y * 420, 22, 7, RANDOM_SMOOTH);
    float daub = noise_smooth(x * 200, at.y * 200, 7, 8, RANDOM_SMOOTH);
    for (int c = 0; c < 3; c++) {
        rgb[c] = mix(scene->sky_top[c], scene->sky_low[c], smooth_between(-1, 0.25f, at.y + 0.06f * stroke));
    }
    const float white[3] = {0.88f, 0.86f, 0.82f};
    float cloud = noise_smooth(x * 80, at.y * 220, 38, 9, RANDOM_SMOOTH) + 0.4f * stroke;
    blend(rgb, white, 0.55f * smooth_between(0.05f, 0.6f, cloud) * smooth_between(0.2f, -0.3f, at.y));
    float far = 0.16f + 0.10f * noise_smooth(x * 100, 0, 55, 11, RANDOM_SMOOTH);
    float near = 0.30f + 0.09f * noise_smooth(x * 100, 50, 42, 12, RANDOM_SMOOTH) - 0.05f * x;
    float field = 0.42f + 0.03f * sinf(2.2f * x);
    blend(rgb, scene->hill_far, smooth_between(far - 0.02f, far + 0.02f, at.y + 0.012f * daub));
    blend(rgb, scene->hill_near, smooth_between(near - 0.015f, near + 0.015f, at.y + 0.02f * daub));
    if (at.y > field) {
        float depth = (at.y - field) / (1 - field);
        blend(rgb, scene->ground, smooth_between(field - 0.01f, field + 0.02f, at.y));
        blend(rgb, scene->shade, 0.45f * smooth_between(-0.2f, 0.7f, stroke + 0.4f * daub) * (0.4f + 0.6f * depth));
        float path = fabsf(x - 0.25f - 0.5f * sinf(2.6f * depth)) / (0.03f + 0.24f * depth);
        blend(rgb, scene->sky_low, 0.55f * smooth_between(1, 0.7f, path + 0.15f * daub));
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] *= 1 + 0.07f * daub + 0.06f * stroke;
    }
}

void motif_draw(enum motif motif, int width, int height, float *rgb)
{
    int shorter = width < height ? width : height;
    for (int y = 0; y < height; y++) {
        for (int x = 0; x < width; x++) {
            float *pixel = rgb + 3 * ((size_t)y * (size_t)width + (size_t)x);
            struct spot at = {((float)x + 0.5f - 0.5f * (float)width) * 2 / (float)shorter,
                              ((float)y + 0.5f - 0.5f * (float)height) * 2 / (float)shorter};
            if (motif == MOTIF_LANDSCAPE || motif == MOTIF_WINTER) {
                struct spot whole = {at.x * (float)shorter / (float)width, at.y * (float)shorter / (float)height};
                landscape(motif == MOTIF_WINTER ? &WINTER : &SUMMER, whole, (float)width / (float)height, pixel);
                continue;
            }
            float tone = motif == MOTIF_PORTRAIT ? portrait(at) : motif == MOTIF_SPHERE ? sphere(at) : leaf(at);
            tone += 0.018f * random_signed(x, y, 5, RANDOM_GRAIN); /* as of film */
            tone = tone < 0 ? 0 : tone > 1 ? 1 : tone;
            pixel[0] = tone * 1.00f;
            pixel[1] = tone * (0.93f + 0.07f * tone);
            pixel[2] = tone * (0.84f + 0.16f * tone);
        }
    }
}
