#include "ink.h"

#include <math.h>
#include <stddef.h>
#include <string.h>

#include "exponential.h"

const float ink_ground[INK_BANDS] = {0.9235f, 0.9379f, 0.9399f, 0.9400f, 0.9400f, 0.9400f};

/* Six bands to linear sRGB: least squares over two-ink mixes of the same curves in sixteen bands, CIE 1931, D65;
 * rows scaled so that a flat spectrum is neutral. */
static const float band_to_rgb[3][INK_BANDS] = {
    {0.1407f, -0.1433f, -0.3217f, -0.0407f, 0.6299f, 0.7351f},
    {-0.0724f, 0.0088f, 0.4099f, 0.5997f, 0.0937f, -0.0397f},
    {0.5387f, 0.5456f, 0.0346f, -0.0843f, -0.0249f, -0.0097f},
};

const struct ink inks[] = {
    {"cobalt blue",
     "A clear, slightly opaque blue.",
     {0.1231f, 0.2085f, 0.8674f, 1.7543f, 2.6714f, 2.9150f},
     {0.2294f, 0.2443f, 0.1252f, 0.0701f, 0.0606f, 0.0600f}},
    {"phthalo turquoise",
     "Transparent; runs from ice to petrol.",
     {0.5009f, 0.3497f, 0.2468f, 0.7420f, 1.8272f, 2.7911f},
     {0.0396f, 0.0618f, 0.0616f, 0.0365f, 0.0227f, 0.0202f}},
    {"ochre",
     "Opaque earth; gold to umber.",
     {2.2465f, 2.0557f, 1.3096f, 0.7057f, 0.3342f, 0.1708f},
     {0.0821f, 0.0894f, 0.1391f, 0.2480f, 0.3419f, 0.3730f}},
    {"quinacridone magenta",
     "Transparent; pink to crimson.",
     {0.6208f, 1.0604f, 2.0970f, 2.5236f, 1.0746f, 0.0878f},
     {0.0200f, 0.0200f, 0.0200f, 0.0210f, 0.0368f, 0.0797f}},
    {"sap green",
     "Transparent; spring leaf to forest.",
     {2.2368f, 1.9980f, 0.7709f, 0.4595f, 0.6725f, 1.1109f},
     {0.0201f, 0.0234f, 0.0531f, 0.0647f, 0.0343f, 0.0209f}},
    {"burnt sienna",
     "A warm red-brown earth.",
     {2.9299f, 2.8944f, 2.6442f, 2.0154f, 1.1254f, 0.4723f},
     {0.0500f, 0.0500f, 0.0506f, 0.0589f, 0.1230f, 0.2126f}},
    {"hansa yellow",
     "A bright opaque yellow.",
     {2.0448f, 1.8487f, 0.3413f, 0.0536f, 0.0316f, 0.0301f},
     {0.0204f, 0.0321f, 0.2053f, 0.2769f, 0.2799f, 0.2800f}},
    {"carbon black",
     "Warm black; covers everything.",
     {2.5429f, 2.4875f, 2.4119f, 2.3491f, 2.2850f, 2.2142f},
     {0.0200f, 0.0200f, 0.0200f, 0.0200f, 0.0200f, 0.0200f}},
    {"cyan",
     "The printer's transparent blue.",
     {0.0900f, 0.0500f, 0.1400f, 0.5600f, 1.7500f, 2.7000f},
     {0.0400f, 0.0500f, 0.0400f, 0.0250f, 0.0200f, 0.0200f}},
    {"magenta",
     "The printer's transparent pink.",
     {0.3300f, 0.5200f, 1.6500f, 2.2500f, 0.8000f, 0.0400f},
     {0.0250f, 0.0220f, 0.0200f, 0.0200f, 0.0350f, 0.0600f}},
    {"yellow",
     "The printer's transparent yellow.",
     {2.2500f, 1.5500f, 0.1300f, 0.0350f, 0.0250f, 0.0250f},
     {0.0200f, 0.0250f, 0.0600f, 0.0700f, 0.0700f, 0.0700f}},
    {.name = NULL},
};

/* Short names, and the ink that each means. */
static const struct {
    const char *name, *ink;
} aliases[] = {
    {"black", "carbon black"},
    {"carbon", "carbon black"},
    {"cobalt", "cobalt blue"},
    {"blue", "cobalt blue"},
    {"turquoise", "phthalo turquoise"},
    {"phthalo", "phthalo turquoise"},
    {"quinacridone", "quinacridone magenta"},
    {"sap", "sap green"},
    {"green", "sap green"},
    {"sienna", "burnt sienna"},
    {"brown", "burnt sienna"},
    {"hansa", "hansa yellow"},
};

const char *const ink_names[] = {
    "cobalt blue",  "phthalo turquoise",
    "ochre",        "quinacridone magenta",
    "sap green",    "burnt sienna",
    "hansa yellow", "carbon black",
    "cyan",         "magenta",
    "yellow",       "black",
    "carbon",       "cobalt",
    "blue",         "turquoise",
    "phthalo",      "quinacridone",
    "sap",          "green",
    "sienna",       "brown",
    "hansa",        NULL,
};

const struct palette palettes[] = {
    {"reef",
     "Sea colours: greens, corals and violets.",
     {"phthalo turquoise", "quinacridone magenta", "ochre", "cobalt blue"},
     .safe = false},
    {"garden", "Leaves and water.", {"sap green", "hansa yellow", "phthalo turquoise", "burnt sienna"}, .safe = false},
    {"dusk",
     "Violets and embers.",
     {"cobalt blue", "quinacridone magenta", "burnt sienna", "carbon black"},
     .safe = false},
    {"earth", "Ground, lichen and soot.", {"ochre", "burnt sienna", "sap green", "carbon black"}, .safe = false},
    {"press", "The four inks of a printing press.", {"cyan", "magenta", "yellow", "carbon black"}, .safe = false},
    {"harbour",
     "Water, rust and lamps.",
     {"phthalo turquoise", "burnt sienna", "hansa yellow", "carbon black"},
     .safe = true,
     .grey = true},
    {"kingfisher",
     "Two blues, bright yellow and black.",
     {"cobalt blue", "cyan", "hansa yellow", "carbon black"},
     .safe = true,
     .grey = true},
    {"lantern",
     "Deep blue, red earth and light.",
     {"cobalt blue", "burnt sienna", "hansa yellow", "carbon black"},
     .safe = true},
    {.name = NULL},
};

int ink_find(const char *name)
{
    for (size_t i = 0; i < sizeof aliases / sizeof *aliases; i++) {
        if (strcmp(aliases[i].name, name) == 0) {
            name = aliases[i].ink;
            break;
        }
    }
    for (int i = 0; inks[i].name; i++) {
        if (strcmp(inks[i].name, name) == 0) {
            return i;
        }
    }
    return INK_NONE;
}

int palette_find(const char *name)
{
    for (int i = 0; palettes[i].name; i++) {
        if (strcmp(palettes[i].name, name) == 0) {
            return i;
        }
    }
    return PALETTE_NONE;
}

/* Reflectance of a layer of absorption k and scattering s over a ground. Neither coth nor a division by s: both vanish
 * where there is no ink. */
static float layer(float k, float s, float ground)
{
    k += 1e-5f;
    float a = k + s;
    float b = sqrtf(k * (k + 2 * s));
    float e = exponential(-2 * b);
    float above = s * (1 - e) - ground * (a * (1 - e) - b * (1 + e));
    float below = (a - ground * s) * (1 - e) + b * (1 + e);
    return above / below;
}

void ink_into_gamut(float rgb[3])
{
    float least = rgb[0] < rgb[1] ? rgb[0] : rgb[1];
    least = rgb[2] < least ? rgb[2] : least;
    if (least < 0) {
        float luminance = 0.2126f * rgb[0] + 0.7152f * rgb[1] + 0.0722f * rgb[2];
        luminance = luminance > 0 ? luminance : 0;
        float share = luminance / (luminance - least);
        for (int c = 0; c < 3; c++) {
            float v = luminance + (rgb[c] - luminance) * share;
            rgb[c] = v > 0 ? v : 0;
        }
    }
}

void ink_mix_unbounded(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float rgb[3])
{
    rgb[0] = rgb[1] = rgb[2] = 0;
    for (int band = 0; band < INK_BANDS; band++) {
        float k = 0;
        float s = 0;
        for (int i = 0; i < INK_PALETTE; i++) {
            k += thickness[i] * inks[ink[i]].absorption[band];
            s += thickness[i] * inks[ink[i]].scattering[band];
        }
        float reflectance = layer(k, s, ink_ground[band]);
        for (int c = 0; c < 3; c++) {
            rgb[c] += band_to_rgb[c][band] * reflectance;
        }
    }
}

void ink_mix(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float rgb[3])
{
    ink_mix_unbounded(ink, thickness, rgb);
    ink_into_gamut(rgb);
}

float ink_encode(float linear)
{
    if (linear <= 0.0031308f) {
        return linear > 0 ? 12.92f * linear : 0;
    }
    return linear < 1 ? 1.055f * power(linear, 1 / 2.4f) - 0.055f : 1;
}

float ink_decode(float display)
{
    if (display <= 0.04045f) {
        return display > 0 ? display / 12.92f : 0;
    }
    return display < 1 ? power((display + 0.055f) / 1.055f, 2.4f) : 1;
}

void ink_cmy(int ink, float cmy[3])
{
    int all[INK_PALETTE] = {ink, ink, ink, ink};
    float rgb[3];
    float white[3];
    ink_mix(all, (float[INK_PALETTE]){1, 0, 0, 0}, rgb);
    ink_mix(all, (float[INK_PALETTE]){0, 0, 0, 0}, white);
    for (int c = 0; c < 3; c++) {
        cmy[c] = 1 - ink_encode(rgb[c] / white[c]);
    }
}

void ink_mix_cmy(const int ink[INK_PALETTE], const float thickness[INK_PALETTE], float display[3])
{
    display[0] = display[1] = display[2] = 1;
    for (int i = 0; i < INK_PALETTE; i++) {
        float cmy[3];
        ink_cmy(ink[i], cmy);
        for (int c = 0; c < 3; c++) {
            display[c] -= thickness[i] * cmy[c];
        }
    }
    for (int c = 0; c < 3; c++) {
        display[c] = display[c] > 0 ? display[c] : 0;
    }
}
