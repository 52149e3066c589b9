/* Doubles for cmocka 1.1.5, whose assert_float_equal takes floats. Included after cmocka.h. */
#ifndef FROND_TESTS_NEAR_H
#define FROND_TESTS_NEAR_H

#include <math.h>

/* Fails with both values unless they are no farther apart than `within`. */
#define assert_near(value, expected, within)                                                                           \
    do {                                                                                                               \
        double near_value = (value), near_expected = (expected);                                                       \
        if (!(fabs(near_value - near_expected) <= (within))) {                                                         \
            fail_msg("%s is %.9g, expected %.9g within %.3g", #value, near_value, near_expected, (double)(within));    \
        }                                                                                                              \
    } while (0)

#endif
