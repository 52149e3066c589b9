#include "laplacian_harmonics.h"

#include <math.h>

static const double PI = 3.14159265358979323846;
static const double INNER = 0.5; /* R1 */

/* Sine and cosine of a turn's part, 0..1: by series, the same on every machine. */
static void turn(double part, double *sine, double *cosine)
{
    double angle = 2 * PI * (part - 0.5), square = angle * angle, term = angle, sum = angle, other = 1, even = 1;
    for (int k = 1; k < 16; k++) {
        other *= -square / ((2 * k - 1) * (2 * k));
        even += other;
        term *= -square / ((2 * k) * (2 * k + 1));
        sum += term;
    }
    *sine = -sum;
    *cosine = -even;
}

/* All real spherical harmonics of a direction, orthonormal. */
static void spherical(int degree, double x, double y, double z, double *basis)
{
    double real = 1, imaginary = 0, start = sqrt(1 / (4 * PI));
    for (int m = 0; m <= degree; m++) {
        double before = 0, legendre = start;
        for (int n = m; n <= degree; n++) {
            if (n > m) {
                double nn = (double)(n * n), mm = (double)(m * m), less = (double)((n - 1) * (n - 1));
                double next = sqrt((4 * nn - 1) / (nn - mm)) *
                              (z * legendre - (n > m + 1 ? sqrt((less - mm) / (4 * less - 1)) * before : 0));
                before = legendre;
                legendre = next;
            }
            double *middle = basis + n * (n + 1);
            middle[m] = m == 0 ? legendre : sqrt(2) * legendre * real;
            if (m > 0) {
                middle[-m] = sqrt(2) * legendre * imaginary;
            }
        }
        double turned = real * x - imaginary * y;
        imaginary = real * y + imaginary * x;
        real = turned;
        start *= sqrt((2.0 * m + 3) / (2.0 * m + 2));
    }
}

static void circular(int degree, double x, double y, double *basis)
{
    double real = 1, imaginary = 0;
    basis[0] = 1;
    for (int n = 1; n <= degree; n++) {
        double turned = real * x - imaginary * y;
        imaginary = real * y + imaginary * x;
        real = turned;
        basis[2 * n - 1] = real;
        basis[2 * n] = imaginary;
    }
}

static int coefficient_count(const struct laplacian_harmonics *harmonics)
{
    return harmonics->dimensions == 2 ? 2 * harmonics->degree + 1 : (harmonics->degree + 1) * (harmonics->degree + 1);
}

static void basis_of(const struct laplacian_harmonics *harmonics, double x, double y, double z, double *basis)
{
    if (harmonics->dimensions == 2) {
        circular(harmonics->degree, x, y, basis);
    } else {
        spherical(harmonics->degree, x, z, -y, basis); /* its pole is up */
    }
}

/* What a row counts, all rows together 2: Fejer's rule, which is exact for all harmonics below degree `rows`. The area
 * between two circles of latitude is so for degree 0 alone. */
static double weight_of_row(int row, int rows)
{
    double sum = 1;
    for (int k = 1; k <= rows / 2; k++) {
        double ignored, cosine, turns = (2 * row + 1.0) * k / (2.0 * rows);
        turn(turns - floor(turns), &ignored, &cosine);
        sum -= 2 * cosine / (4.0 * k * k - 1);
    }
    return 2 * sum / rows;
}

/* area: of a cell on the sphere. */
static void add_cell(struct laplacian_harmonics *harmonics, const struct action_raster *environment, int row,
                     int column, double area)
{
    double basis[LAPLACIAN_COEFFICIENTS] = {0}, sine, cosine, polar_sine, polar_cosine;
    double value = (double)environment->values[row * environment->width + column];
    turn((column + 0.5) / environment->width, &sine, &cosine);
    if (harmonics->dimensions == 2) {
        basis_of(harmonics, cosine, sine, 0, basis);
        for (int i = 0; i < coefficient_count(harmonics); i++) {
            harmonics->coefficients[i] +=
                value * basis[i] * (i == 0 ? 1 : 2) / ((double)environment->width * environment->height);
        }
        return;
    }
    turn((row + 0.5) / environment->height / 2, &polar_sine, &polar_cosine);
    basis_of(harmonics, polar_sine * cosine, -polar_cosine, polar_sine * sine, basis);
    for (int i = 0; i < coefficient_count(harmonics); i++) {
        harmonics->coefficients[i] += value * basis[i] * area;
    }
}

static double sum_at(const struct laplacian_harmonics *harmonics, const double *basis, double distance)
{
    double sum = 0, power = 1, part = distance / harmonics->radius;
    double within = INNER / (distance > INNER ? distance : INNER), inner = within, outer = INNER / harmonics->radius;
    double outer_power = outer;
    int at = 0;
    for (int n = 0; n <= harmonics->degree; n++) {
        double radial = n == 0 ? 1 : power;
        int count = harmonics->dimensions == 3 ? 2 * n + 1 : n == 0 ? 1 : 2;
        if (n > 0) { /* a_n r^n + b_n r^(-n-1), both over a_n R2^n + b_n R2^(-n-1) = 1; in 2D r^-n */
            double extra = harmonics->dimensions == 3 ? 1 : 0;
            double fading = extra > 0 ? inner * inner * within : inner * inner;
            double edge = extra > 0 ? outer_power * outer_power * outer : outer_power * outer_power;
            radial *= (1 - fading) / (1 - edge);
        }
        for (int i = 0; i < count; i++, at++) {
            sum += harmonics->coefficients[at] * basis[at] * radial;
        }
        power *= part;
        inner = n == 0 ? within : inner * within;
        outer_power = n == 0 ? outer : outer_power * outer;
    }
    return sum;
}

double laplacian_harmonics_value(const struct laplacian_harmonics *harmonics, const float *at)
{
    double x = (double)at[0], y = (double)at[1], z = harmonics->dimensions == 3 ? (double)at[2] : 0;
    double distance = sqrt(x * x + y * y + z * z), basis[LAPLACIAN_COEFFICIENTS] = {0};
    double inverse = distance > 0 ? 1 / distance : 0;
    basis_of(harmonics, x * inverse, y * inverse, z * inverse, basis);
    return sum_at(harmonics, basis, distance < harmonics->radius ? distance : harmonics->radius);
}

/* A harmonic function is greatest on its border (the maximum principle): looked for over the sphere. */
static void find_most(struct laplacian_harmonics *harmonics)
{
    enum { AROUND = 96, UP = 48 };
    double least = INFINITY, most = 0, radius = harmonics->radius;
    for (int row = 0; row <= (harmonics->dimensions == 3 ? UP : 0); row++) {
        for (int column = 0; column < AROUND; column++) {
            double sine, cosine, polar_sine = 1, polar_cosine = 0;
            turn((double)column / AROUND, &sine, &cosine);
            if (harmonics->dimensions == 3) {
                turn((double)row / UP / 2, &polar_sine, &polar_cosine);
            }
            const float at[3] = {(float)(radius * polar_sine * cosine),
                                 (float)(radius * (harmonics->dimensions == 3 ? -polar_cosine : sine)),
                                 (float)(radius * polar_sine * sine)};
            double value = laplacian_harmonics_value(harmonics, at);
            least = value < least ? value : least;
            most = row + column == 0 || value > most ? value : most;
        }
    }
    harmonics->most = most + 0.01 * (most - least); /* between the samples */
}

void laplacian_harmonics_project(struct laplacian_harmonics *harmonics, int dimensions, int degree, double radius,
                                 const struct action_raster *environment)
{
    *harmonics = (struct laplacian_harmonics){.dimensions = dimensions, .degree = degree, .radius = radius};
    for (int row = 0; row < environment->height; row++) {
        double area = weight_of_row(row, environment->height) * 2 * PI / environment->width;
        for (int column = 0; column < environment->width; column++) {
            add_cell(harmonics, environment, row, column, area);
        }
    }
    find_most(harmonics);
}
