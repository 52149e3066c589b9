/* The light on the picture: soft, from the upper left. */
#ifndef FROND_PICTURE_LIGHT_H
#define FROND_PICTURE_LIGHT_H

/* Unit vectors, x right, y down, z to the eye: to the light, and half way between it and the eye. */
struct light {
    float x, y, z;
    float half_x, half_y, half_z;
};

struct light light_default(void);

#endif
