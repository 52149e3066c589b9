#include "vision.h"

#include <math.h>

static const struct {
    const char *name;
    float see[3][3];
} VISION[VISIONS] = {
    [VISION_USUAL] = {"usual", {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}}},
    [VISION_PROTANOPIA] = {"protanopia",
                           {{0.152286f, 1.052583f, -0.204868f},
                            {0.114503f, 0.786281f, 0.099216f},
                            {-0.003882f, -0.048116f, 1.051998f}}},
    [VISION_DEUTERANOPIA] = {"deuteranopia",
                             {{0.367322f, 0.860646f, -0.227968f},
                              {0.280085f, 0.672501f, 0.047413f},
                              {-0.011820f, 0.042940f, 0.968881f}}},
    [VISION_TRITANOPIA] = {"tritanopia",
                           {{1.255528f, -0.076749f, -0.178779f},
                            {-0.078411f, 0.930809f, 0.147602f},
                            {0.004733f, 0.691367f, 0.303900f}}},
    [VISION_GREY] = {"grey", {{0.2126f, 0.7152f, 0.0722f}, {0.2126f, 0.7152f, 0.0722f}, {0.2126f, 0.7152f, 0.0722f}}},
};

const char *vision_name(enum vision vision)
{
    return VISION[vision].name;
}

void vision_see(enum vision vision, const float rgb[3], float seen[3])
{
    float from[3] = {rgb[0], rgb[1], rgb[2]};
    for (int c = 0; c < 3; c++) {
        const float *row = VISION[vision].see[c];
        float value = row[0] * from[0] + row[1] * from[1] + row[2] * from[2];
        seen[c] = value < 0 ? 0 : value > 1 ? 1 : value;
    }
}

static float lightness(float share)
{
    return share > 216.0f / 24389 ? cbrtf(share) : (24389.0f / 27 * share + 16) / 116;
}

void vision_lab(const float rgb[3], float lab[3])
{
    float x = lightness((0.4124564f * rgb[0] + 0.3575761f * rgb[1] + 0.1804375f * rgb[2]) / 0.95047f);
    float y = lightness(0.2126729f * rgb[0] + 0.7151522f * rgb[1] + 0.0721750f * rgb[2]);
    float z = lightness((0.0193339f * rgb[0] + 0.1191920f * rgb[1] + 0.9503041f * rgb[2]) / 1.08883f);
    lab[0] = 116 * y - 16;
    lab[1] = 500 * (x - y);
    lab[2] = 200 * (y - z);
}

#define DEGREE 0.0174532925199433

/* Degrees, 0..360. */
static double hue(double a, double b)
{
    double angle = a == 0 && b == 0 ? 0 : atan2(b, a) / DEGREE;
    return angle < 0 ? angle + 360 : angle;
}

static double power7(double chroma)
{
    double p = pow(chroma, 7);
    return sqrt(p / (p + 6103515625.0)); /* 25^7 */
}

float vision_distance(const float one[3], const float other[3])
{
    double mean = 0.5 * (hypot((double)one[1], (double)one[2]) + hypot((double)other[1], (double)other[2]));
    double stretch = 1 + 0.5 * (1 - power7(mean));
    double a1 = stretch * (double)one[1], b1 = (double)one[2], a2 = stretch * (double)other[1], b2 = (double)other[2];
    double chroma1 = hypot(a1, b1), chroma2 = hypot(a2, b2), hue1 = hue(a1, b1), hue2 = hue(a2, b2);
    double turn = chroma1 * chroma2 == 0 ? 0 : hue2 - hue1;
    turn = turn > 180 ? turn - 360 : turn < -180 ? turn + 360 : turn;
    double hue_mean = hue1 + hue2;
    if (chroma1 * chroma2 != 0) {
        hue_mean = fabs(hue1 - hue2) <= 180 ? 0.5 * hue_mean : 0.5 * (hue_mean < 360 ? hue_mean + 360 : hue_mean - 360);
    }
    double light = 0.5 * ((double)one[0] + (double)other[0]), chroma = 0.5 * (chroma1 + chroma2);
    double t = 1 - 0.17 * cos((hue_mean - 30) * DEGREE) + 0.24 * cos(2 * hue_mean * DEGREE) +
               0.32 * cos((3 * hue_mean + 6) * DEGREE) - 0.20 * cos((4 * hue_mean - 63) * DEGREE);
    double middle = (light - 50) * (light - 50), bend = (hue_mean - 275) / 25;
    double d_light = ((double)other[0] - (double)one[0]) / (1 + 0.015 * middle / sqrt(20 + middle));
    double d_chroma = (chroma2 - chroma1) / (1 + 0.045 * chroma);
    double d_hue = 2 * sqrt(chroma1 * chroma2) * sin(0.5 * turn * DEGREE) / (1 + 0.015 * chroma * t);
    double rotation = -2 * power7(chroma) * sin(60 * exp(-bend * bend) * DEGREE);
    return (float)sqrt(d_light * d_light + d_chroma * d_chroma + d_hue * d_hue + rotation * d_chroma * d_hue);
}

/* An ink alone; INK_NONE: the ground. */
static void lab_of(enum vision vision, int ink, float thickness, float lab[3])
{
    int all[INK_PALETTE] = {0};
    float rgb[3], layer[INK_PALETTE] = {0};
    if (ink != INK_NONE) {
        all[0] = ink;
        layer[0] = thickness;
    }
    ink_mix(all, layer, rgb);
    vision_see(vision, rgb, rgb);
    vision_lab(rgb, lab);
}

static float between(enum vision vision, int one, int other, float thickness)
{
    float labs[2][3];
    lab_of(vision, one, thickness, labs[0]);
    lab_of(vision, other, thickness, labs[1]);
    return vision_distance(labs[0], labs[1]);
}

float vision_between(enum vision vision, const int ink[INK_PALETTE], float thickness)
{
    float least = 1e9f;
    for (int i = 0; i < INK_PALETTE; i++) {
        for (int j = 0; j < i; j++) {
            least = fminf(least, between(vision, ink[i], ink[j], thickness));
        }
    }
    return least;
}

float vision_from_ground(enum vision vision, const int ink[INK_PALETTE], float thickness)
{
    float least = 1e9f;
    for (int i = 0; i < INK_PALETTE; i++) {
        least = fminf(least, between(vision, ink[i], INK_NONE, thickness));
    }
    return least;
}

bool vision_is_safe(const int ink[INK_PALETTE])
{
    bool safe = true;
    for (enum vision vision = VISION_USUAL; vision < VISION_GREY; vision++) {
        safe = safe && vision_between(vision, ink, VISION_INKED) >= VISION_INKED_LEAST &&
               vision_between(vision, ink, VISION_TINT) >= VISION_TINT_LEAST &&
               vision_from_ground(vision, ink, VISION_INKED) >= VISION_GROUND_LEAST &&
               vision_from_ground(vision, ink, VISION_TINT) >= VISION_PALE_LEAST;
    }
    return safe;
}

bool vision_is_grey(const int ink[INK_PALETTE])
{
    return vision_between(VISION_GREY, ink, VISION_INKED) >= VISION_GREY_LEAST;
}
