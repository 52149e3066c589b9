#include "picture_resample.h"

#include <math.h>
#include <stdlib.h>

static double kernel(double x, double b, double c)
{
    x = fabs(x);
    if (x < 1) {
        return ((12 - 9 * b - 6 * c) * x * x * x + (-18 + 12 * b + 6 * c) * x * x + (6 - 2 * b)) / 6;
    }
    if (x < 2) {
        return ((-b - 6 * c) * x * x * x + (6 * b + 30 * c) * x * x + (-12 * b - 48 * c) * x + (8 * b + 24 * c)) / 6;
    }
    return 0;
}

static int clamp_int(int value, int low, int high)
{
    return value < low ? low : value > high ? high : value;
}

bool resample_init(struct resample *resample, int from, int to, float b, float c)
{
    double step = (double)from / to;
    double wide = step > 1 ? step : 1;
    int span = (int)ceil(4 * wide);
    int taps = span < from ? span : from;
    *resample = (struct resample){.count = to, .taps = taps};
    resample->start = malloc(sizeof *resample->start * (size_t)to);
    resample->weights = calloc((size_t)to * (size_t)taps, sizeof *resample->weights);
    if (!resample->start || !resample->weights) {
        resample_finish(resample);
        return false;
    }
    for (int i = 0; i < to; i++) {
        double centre = (i + 0.5) * step - 0.5;
        int first = (int)floor(centre - 2 * wide) + 1;
        int start = clamp_int(first, 0, from - taps);
        float *weights = resample->weights + (size_t)i * (size_t)taps;
        double sum = 0;
        for (int j = first; j < first + span; j++) {
            sum += kernel((j - centre) / wide, b, c);
        }
        for (int j = first; j < first + span; j++) {
            weights[clamp_int(j, start, start + taps - 1) - start] += (float)(kernel((j - centre) / wide, b, c) / sum);
        }
        resample->start[i] = start;
    }
    return true;
}

void resample_finish(struct resample *resample)
{
    free(resample->start);
    free(resample->weights);
    *resample = (struct resample){0};
}

void resample_row(const struct resample *resample, const float *in, float *out)
{
    int taps = resample->taps;
    const float *w = resample->weights;
    if (taps == 4) {
        for (int i = 0; i < resample->count; i++, w += 4) {
            const float *s = in + resample->start[i];
            out[i] = (w[0] * s[0] + w[1] * s[1]) + (w[2] * s[2] + w[3] * s[3]);
        }
        return;
    }
    for (int i = 0; i < resample->count; i++, w += taps) {
        const float *s = in + resample->start[i];
        float sum = 0;
        for (int j = 0; j < taps; j++) {
            sum += w[j] * s[j];
        }
        out[i] = sum;
    }
}
