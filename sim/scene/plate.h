/* A plate: a picture that lies over a painting, each pixel of which has a tick at which it appears. What grows is
 * painted once and then shown, tick by tick, for next to nothing. Made by scenes other than the painting (garden.h). */
#ifndef FROND_PLATE_H
#define FROND_PLATE_H

#include <stdbool.h>
#include <stdint.h>

struct plate {
    int width, height; /* pixels */
    uint8_t *rgba;     /* width * height * 4: sRGB, multiplied by alpha, R first, from the top left; what covers nothing
                          is 0 */
    float *birth;      /* width * height: ticks since plate->tick; FLT_MAX: never */
    int64_t tick;      /* that births count from */
    uint8_t ground[4]; /* what lies over the whole sheet behind it, sRGB multiplied by alpha; 0: the painting shows */
};

/* Ticks in which a pixel comes up from its birth on: with t the share of them that has passed, 0..1, it is shown to
 * t * t * (3 - 2 * t). */
enum { PLATE_SOFT = 12 };

/* Empty; false and zeroed when memory is short. */
bool plate_init(struct plate *plate, int width, int height);
void plate_finish(struct plate *plate); /* takes zeroed */
/* Covers nothing any more; size, tick and ground stay. */
void plate_clear(struct plate *plate);
/* Lays the ground and what has appeared on it by `tick` over width * height * 3 bytes of sRGB, as
 * shaders/show/plate_gpu.h does, within 1 of 255: each is mixed as it is encoded, below * (1 - alpha) + above. */
void plate_reveal(const struct plate *plate, int64_t tick, uint8_t *rgb);

#endif
