#include "blur.h"

#include <stddef.h>

enum { BOX_PASSES = 3 };

static void box_row(const float *in, float *out, int count, int step, int half)
{
    float sum = 0, over = 1.0f / (float)(2 * half + 1);
    for (int i = -half; i <= half; i++) {
        sum += in[(i < 0 ? 0 : i < count ? i : count - 1) * step];
    }
    for (int i = 0; i < count; i++) {
        int gone = i - half, next = i + half + 1;
        out[i * step] = sum * over;
        sum += in[(next < count ? next : count - 1) * step] - in[(gone > 0 ? gone : 0) * step];
    }
}

void blur_boxes(float *plane, float *other, int width, int height, float sigma)
{
    int half = (int)(sigma + 0.5f) > 0 ? (int)(sigma + 0.5f) : 1;
    for (int pass = 0; pass < BOX_PASSES; pass++) {
        for (int y = 0; y < height; y++) {
            box_row(plane + (size_t)y * (size_t)width, other + (size_t)y * (size_t)width, width, 1, half);
        }
        for (int x = 0; x < width; x++) {
            box_row(other + x, plane + x, height, width, half);
        }
    }
}
