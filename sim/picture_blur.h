/* Gaussian blurs of the picture: symmetric taps. */
#ifndef FROND_PICTURE_BLUR_H
#define FROND_PICTURE_BLUR_H

enum { BLUR_RADIUS_MAX = 16 };

struct blur {
    int radius;                      /* cells */
    float taps[BLUR_RADIUS_MAX + 1]; /* centre, then each side; all together sum to 1; 0 beyond the radius */
};

/* Out to three sigmas; sigma in cells. */
struct blur blur_of(float sigma);

/* Sigmas, cells: of the depth around a vein; of the liquid's surface; of what shades a place from the light. */
#define BLUR_WIDE   4.0f
#define BLUR_NARROW 0.8f
#define BLUR_BROAD  5.0f

#endif
