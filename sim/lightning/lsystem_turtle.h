/* The turtle of an L-system: where it is headed, and its left (Prusinkiewicz and Lindenmayer, section 1.5). Additions,
 * products, divisions and roots alone: the same bits on every machine. */
#ifndef FROND_LSYSTEM_TURTLE_H
#define FROND_LSYSTEM_TURTLE_H

#include <stdbool.h>

struct lsystem_turtle {
    float heading[3], left[3]; /* of length 1, at right angles */
};

/* Sine and cosine of degrees, error below 1e-6. */
void lsystem_turn(float degrees, float *sine, float *cosine);

/* Headed there, upwards (-y) where it is 0; flat: in the plane of x and y. */
struct lsystem_turtle lsystem_turtle_headed(const float heading[3], bool flat);
/* Heads to the side that lies `roll` degrees about the heading from its left, by `angle` degrees. */
void lsystem_turtle_branch(struct lsystem_turtle *turtle, float roll, float angle);
/* Heads towards a direction of any length by `degrees` times the sine of the angle to it: no further than to it, as
 * long as degrees <= 57. */
void lsystem_turtle_bend(struct lsystem_turtle *turtle, const float towards[3], float degrees);
/* Turns about the axis y. */
void lsystem_turtle_spin(struct lsystem_turtle *turtle, float degrees);
/* Heads to where it is told; the left follows. Nothing where that is 0. */
void lsystem_turtle_head(struct lsystem_turtle *turtle, const float heading[3]);

float lsystem_dot(const float a[3], const float b[3]);

#endif
