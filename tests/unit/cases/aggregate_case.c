#include "aggregate_case.h"

#include <math.h>
#include <stdint.h>
#include <stdlib.h>

double aggregate_gyration(place *places, int count)
{
    double mean[3] = {0}, sum = 0;
    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 3; d++) {
            mean[d] += places[i][d] / count;
        }
    }
    for (int i = 0; i < count; i++) {
        for (int d = 0; d < 3; d++) {
            sum += (places[i][d] - mean[d]) * (places[i][d] - mean[d]);
        }
    }
    return sqrt(sum / count);
}

static double slope_of(const double *x, const double *y, int count)
{
    double sx = 0, sy = 0, sxx = 0, sxy = 0;
    for (int i = 0; i < count; i++) {
        sx += x[i];
        sy += y[i];
        sxx += x[i] * x[i];
        sxy += x[i] * y[i];
    }
    return (count * sxy - sx * sy) / (count * sxx - sx * sx);
}

double aggregate_box_dimension(place *places, int count)
{
    enum { GRID = 1024, SIZES = 4 };
    double logs[SIZES], counts[SIZES];
    for (int k = 0; k < SIZES; k++) {
        int boxes = 0;
        uint8_t *seen = calloc((size_t)GRID * GRID, 1);
        for (int i = 0; i < count && seen; i++) {
            int x = ((int)floor(places[i][0] + 0.5) + GRID / 2) >> (k + 1);
            int y = ((int)floor(places[i][1] + 0.5) + GRID / 2) >> (k + 1);
            if (x < 0 || y < 0 || x >= GRID || y >= GRID) {
                free(seen);
                return NAN;
            }
            boxes += !seen[y * GRID + x];
            seen[y * GRID + x] = 1;
        }
        free(seen);
        logs[k] = -k * log(2);
        counts[k] = log(boxes);
    }
    return slope_of(logs, counts, SIZES);
}

double aggregate_growth_dimension(place *places, int count, int from)
{
    enum { PARTS = 5 };
    double sizes[PARTS], counts[PARTS];
    for (int k = 0; k < PARTS; k++) {
        int part = (int)(from * pow((double)count / from, k / (PARTS - 1.0)));
        sizes[k] = log(aggregate_gyration(places, part));
        counts[k] = log(part);
    }
    return slope_of(sizes, counts, PARTS);
}

static double distance(const double *a, const double *b)
{
    double x = a[0] - b[0], y = a[1] - b[1], z = a[2] - b[2];
    return sqrt(x * x + y * y + z * z);
}

double aggregate_mass_dimension(place *places, int count)
{
    enum { RADII = 5 };
    double most = 0, radii[RADII], counts[RADII];
    for (int i = 0; i < count; i++) {
        most = fmax(most, distance(places[i], places[0]));
    }
    for (int k = 0; k < RADII; k++) {
        double radius = most / 8 * pow(4, k / (RADII - 1.0));
        int within = 0;
        for (int i = 0; i < count; i++) {
            within += distance(places[i], places[0]) <= radius;
        }
        radii[k] = log(radius);
        counts[k] = log(within);
    }
    return slope_of(radii, counts, RADII);
}
