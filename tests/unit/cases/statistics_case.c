#include "statistics_case.h"

#include <math.h>

void sample_add(struct sample *sample, double value)
{
    if (sample->count < SAMPLE_MAX) {
        sample->values[sample->count++] = value;
    }
}

double sample_mean(const struct sample *sample)
{
    double sum = 0;
    for (int i = 0; i < sample->count; i++) {
        sum += sample->values[i];
    }
    return sum / sample->count;
}

double sample_variance(const struct sample *sample)
{
    double mean = sample_mean(sample), sum = 0;
    for (int i = 0; i < sample->count; i++) {
        sum += (sample->values[i] - mean) * (sample->values[i] - mean);
    }
    return sum / (sample->count - 1);
}

double sample_error(const struct sample *sample)
{
    return sqrt(sample_variance(sample) / sample->count);
}

/* By the series below the mean, by the continued fraction above it (Lentz). */
double chance_of_chi_square(double chi, double freedom)
{
    double a = freedom / 2, x = chi / 2, scale = exp(a * log(x > 0 ? x : 1e-300) - x - lgamma(a));
    if (x < a + 1) {
        double term = 1 / a, sum = term;
        for (int n = 1; n < 10000 && term > sum * 1e-15; n++) {
            term *= x / (a + n);
            sum += term;
        }
        return 1 - sum * scale;
    }
    double b = x + 1 - a, c = 1e300, d = 1 / b, h = d;
    for (int n = 1; n < 10000; n++) {
        double an = -n * (n - a);
        b += 2;
        d = 1 / (an * d + b);
        c = b + an / c;
        h *= d * c;
        if (fabs(d * c - 1) < 1e-15) {
            break;
        }
    }
    return h * scale;
}

/* The continued fraction of I_x(a, b), good for x < (a + 1) / (a + b + 2). */
static double beta_fraction(double x, double a, double b)
{
    double c = 1, d = 1 / (1 - (a + b) * x / (a + 1)), h = d;
    for (int m = 1; m < 10000; m++) {
        double even = m * (b - m) * x / ((a + 2 * m - 1) * (a + 2 * m));
        double odd = -(a + m) * (a + b + m) * x / ((a + 2 * m) * (a + 2 * m + 1));
        d = 1 / (1 + even * d);
        c = 1 + even / c;
        h *= d * c;
        d = 1 / (1 + odd * d);
        c = 1 + odd / c;
        h *= d * c;
        if (fabs(d * c - 1) < 1e-15) {
            break;
        }
    }
    return h * exp(lgamma(a + b) - lgamma(a) - lgamma(b) + a * log(x) + b * log1p(-x)) / a;
}

double chance_of_t(double t, double freedom)
{
    double a = freedom / 2, b = 0.5, x = freedom / (freedom + t * t);
    if (x >= 1) {
        return 1;
    }
    return x < (a + 1) / (a + b + 2) ? beta_fraction(x, a, b) : 1 - beta_fraction(1 - x, b, a);
}

double chance_of_same_mean(const struct sample *a, const struct sample *b)
{
    double va = sample_variance(a) / a->count, vb = sample_variance(b) / b->count, both = va + vb;
    double freedom = both * both / (va * va / (a->count - 1) + vb * vb / (b->count - 1));
    return chance_of_t((sample_mean(a) - sample_mean(b)) / sqrt(both), freedom);
}

double chance_of_mean(const struct sample *sample, double mean, int others, double rounded)
{
    double off = fabs(sample_mean(sample) - mean) - rounded;
    double error = sqrt(sample_variance(sample) * (1.0 / sample->count + 1.0 / others));
    return off > 0 ? chance_of_t(off / error, sample->count - 1) : 1;
}
