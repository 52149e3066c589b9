#include "xray.h"

#include <math.h>

#include "ink.h"

const struct xray_scale xray_scales[XRAY_LAYERS] = {
    [XRAY_CATALYST] = {0, 1, false}, [XRAY_ACTIVE] = {0, 0.16f, false}, [XRAY_CARVED] = {0, 1, false},
    [XRAY_SOLVENT] = {0, 6, false},  [XRAY_VELOCITY] = {0, 0.1f, true}, [XRAY_GUIDANCE] = {0, 1, true},
};

const uint8_t xray_ground[3] = {14, 16, 20};

static const float turn_degrees = 0.0174532925f;

/* Where a palette begins and ends: hue of OKLCh in degrees, turned the straight way. */
static const float hues[XRAY_LAYERS][2] = {
    [XRAY_CATALYST] = {275, 195},
    [XRAY_ACTIVE] = {-40, 95},
    [XRAY_CARVED] = {200, 115},
    [XRAY_SOLVENT] = {310, 215},
};

int xray_text(int width, int height)
{
    int side = width < height ? width : height;
    return side / 36 > 3 ? side / 36 : 3;
}

void xray_layout(int width, int height, int cells_x, int cells_y, struct xray_panel panels[XRAY_LAYERS])
{
    int columns = width >= height ? 3 : 2;
    int rows = XRAY_LAYERS / columns;
    int text = xray_text(width, height);
    int gap = text;
    int wide = (width - gap * (columns + 1)) / columns;
    int high = (height - gap * (rows + 1)) / rows;
    int title = text * 8 / 5, scale = text * 5 / 2;
    int room = high - title - scale > 1 ? high - title - scale : 1;
    wide = wide > 1 ? wide : 1;
    /* As large as fits, in the shape of the painting. */
    int image_wide = wide, image_high = (int)((float)wide * (float)cells_y / (float)cells_x + 0.5f);
    if (image_high > room) {
        image_high = room;
        image_wide = (int)((float)room * (float)cells_x / (float)cells_y + 0.5f);
    }
    image_wide = image_wide > 1 ? image_wide : 1;
    image_high = image_high > 1 ? image_high : 1;
    for (int i = 0; i < XRAY_LAYERS; i++) {
        int x = gap + i % columns * (wide + gap) + (wide - image_wide) / 2;
        int y = gap + i / columns * (high + gap) + (room - image_high) / 2;
        panels[i].title = (struct xray_box){x, y, (wide + image_wide) / 2, title};
        panels[i].image = (struct xray_box){x, y + title, image_wide, image_high};
        panels[i].scale = (struct xray_box){x, y + title + image_high, image_wide, scale};
    }
}

/* Linear sRGB of OKLab; false where a channel leaves 0..1. */
static bool from_oklab(float lightness, float a, float b, float rgb[3])
{
    float l = lightness + 0.3963377774f * a + 0.2158037573f * b;
    float m = lightness - 0.1055613458f * a - 0.0638541728f * b;
    float s = lightness - 0.0894841775f * a - 1.2914855480f * b;
    l = l * l * l;
    m = m * m * m;
    s = s * s * s;
    rgb[0] = 4.0767416621f * l - 3.3077115913f * m + 0.2309699292f * s;
    rgb[1] = -1.2684380046f * l + 2.6097574011f * m - 0.3413193965f * s;
    rgb[2] = -0.0041960863f * l - 0.7034186147f * m + 1.7076147010f * s;
    bool good = true;
    for (int c = 0; c < 3; c++) {
        good = good && rgb[c] >= 0 && rgb[c] <= 1;
    }
    return good;
}

/* Chroma gives way where sRGB cannot show it; lightness stays. */
static void encode(float lightness, float chroma, float hue, uint8_t rgb[3])
{
    float linear[3];
    float a = cosf(hue), b = sinf(hue);
    float low = 0, high = chroma;
    if (!from_oklab(lightness, a * chroma, b * chroma, linear)) {
        for (int i = 0; i < 12; i++) {
            float middle = (low + high) / 2;
            *(from_oklab(lightness, a * middle, b * middle, linear) ? &low : &high) = middle;
        }
        from_oklab(lightness, a * low, b * low, linear);
    }
    for (int c = 0; c < 3; c++) {
        rgb[c] = (uint8_t)(255 * ink_encode(linear[c]) + 0.5f);
    }
}

void xray_colour(enum xray_layer layer, float value, uint8_t rgb[3])
{
    value = value > 0 ? value : 0;
    value = value < 1 ? value : 1;
    float hue = hues[layer][0] + (hues[layer][1] - hues[layer][0]) * value;
    encode(0.2f + 0.76f * value, 0.05f + 0.44f * value * (1 - value) + 0.05f * value, hue * turn_degrees, rgb);
}

void xray_vector_colour(float x, float y, uint8_t rgb[3])
{
    float length = sqrtf(x * x + y * y);
    length = length < 1 ? length : 1;
    encode(0.2f + 0.55f * length, 0.15f * length, atan2f(-y, x), rgb);
}
