#include "lsystem_turtle.h"

#include <math.h>
#include <string.h>

float lsystem_dot(const float a[3], const float b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

static bool make_unit(float v[3])
{
    float length = sqrtf(lsystem_dot(v, v));
    for (int d = 0; d < 3 && length > 1e-6f; d++) {
        v[d] /= length;
    }
    return length > 1e-6f;
}

/* a times x plus b times y */
static void mix(float a, const float x[3], float b, const float y[3], float result[3])
{
    for (int d = 0; d < 3; d++) {
        result[d] = a * x[d] + b * y[d];
    }
}

static void cross(const float a[3], const float b[3], float result[3])
{
    result[0] = a[1] * b[2] - a[2] * b[1];
    result[1] = a[2] * b[0] - a[0] * b[2];
    result[2] = a[0] * b[1] - a[1] * b[0];
}

void lsystem_turn(float degrees, float *sine, float *cosine)
{
    double quarters = floor((double)degrees / 90 + 0.5), a = ((double)degrees - 90 * quarters) * 0.017453292519943295;
    double q = a * a, s = a * (1 + q * (-1.0 / 6 + q * (1.0 / 120 + q * (-1.0 / 5040 + q / 362880))));
    double c = 1 + q * (-0.5 + q * (1.0 / 24 + q * (-1.0 / 720 + q * (1.0 / 40320 - q / 3628800))));
    int quarter = (int)(quarters - 4 * floor(quarters / 4));
    *sine = (float)(quarter == 0 ? s : quarter == 1 ? c : quarter == 2 ? -s : -c);
    *cosine = (float)(quarter == 0 ? c : quarter == 1 ? -s : quarter == 2 ? -c : s);
}

struct lsystem_turtle lsystem_turtle_headed(const float heading[3], bool flat)
{
    struct lsystem_turtle turtle = {.heading = {heading[0], heading[1], flat ? 0 : heading[2]}};
    if (!make_unit(turtle.heading)) {
        memcpy(turtle.heading, (const float[3]){0, -1, 0}, sizeof turtle.heading);
    }
    cross(turtle.heading, (const float[3]){0, 0, 1}, turtle.left);
    if (!make_unit(turtle.left)) { /* straight away */
        memcpy(turtle.left, (const float[3]){-1, 0, 0}, sizeof turtle.left);
    }
    return turtle;
}

void lsystem_turtle_head(struct lsystem_turtle *turtle, const float heading[3])
{
    float to[3] = {heading[0], heading[1], heading[2]}, left[3];
    if (!make_unit(to)) {
        return;
    }
    mix(1, turtle->left, -lsystem_dot(turtle->left, to), to, left);
    if (!make_unit(left)) { /* straight to the left, or away from it: the left is where it was headed from, or to */
        float sign = lsystem_dot(turtle->left, to) > 0 ? -1 : 1;
        mix(sign, turtle->heading, 0, to, left);
        mix(1, left, -lsystem_dot(left, to), to, left);
        make_unit(left);
    }
    memcpy(turtle->heading, to, sizeof to);
    memcpy(turtle->left, left, sizeof left);
}

void lsystem_turtle_branch(struct lsystem_turtle *turtle, float roll, float angle)
{
    float up[3], side[3], heading[3], sine, cosine;
    cross(turtle->heading, turtle->left, up);
    lsystem_turn(roll, &sine, &cosine);
    mix(cosine, turtle->left, sine, up, side);
    lsystem_turn(angle, &sine, &cosine);
    mix(cosine, turtle->heading, sine, side, heading);
    mix(cosine, side, -sine, turtle->heading, turtle->left);
    memcpy(turtle->heading, heading, sizeof heading);
    make_unit(turtle->heading);
    mix(1, turtle->left, -lsystem_dot(turtle->left, turtle->heading), turtle->heading, turtle->left);
    make_unit(turtle->left);
}

void lsystem_turtle_bend(struct lsystem_turtle *turtle, const float towards[3], float degrees)
{
    float to[3] = {towards[0], towards[1], towards[2]}, aside[3], heading[3], sine, cosine;
    if (!make_unit(to)) {
        return;
    }
    mix(1, to, -lsystem_dot(to, turtle->heading), turtle->heading, aside);
    float share = sqrtf(lsystem_dot(aside, aside));
    if (!make_unit(aside)) {
        return;
    }
    lsystem_turn(degrees * share, &sine, &cosine);
    mix(cosine, turtle->heading, sine, aside, heading);
    lsystem_turtle_head(turtle, heading);
}

void lsystem_turtle_spin(struct lsystem_turtle *turtle, float degrees)
{
    float sine, cosine, *both[2] = {turtle->heading, turtle->left};
    lsystem_turn(degrees, &sine, &cosine);
    for (int i = 0; i < 2; i++) {
        float x = both[i][0], z = both[i][2];
        both[i][0] = cosine * x + sine * z;
        both[i][2] = cosine * z - sine * x;
    }
}
