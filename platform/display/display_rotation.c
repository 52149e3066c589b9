#include "display_rotation.h"

/* What points up on the sheet points right at 90 degrees. */
void rotation_matrix(int rotation, bool flipped, float turn[4])
{
    static const float COSINE[4] = {1, 0, -1, 0}, SINE[4] = {0, 1, 0, -1};
    float c = COSINE[rotation / 90], s = SINE[rotation / 90], up = flipped ? -1.f : 1.f;
    turn[0] = c;
    turn[1] = -s * up;
    turn[2] = s;
    turn[3] = c * up;
}

void rotation_untouch(int rotation, float *x, float *y)
{
    float across = *x, down = *y;
    switch (rotation) {
    case 90:
        *x = down;
        *y = 1 - across;
        break;
    case 180:
        *x = 1 - across;
        *y = 1 - down;
        break;
    case 270:
        *x = 1 - down;
        *y = across;
        break;
    default:
        break;
    }
}

void rotation_pixel(int rotation, int panel_width, int panel_height, int *x, int *y)
{
    int across = *x, down = *y;
    switch (rotation) {
    case 90:
        *x = panel_width - 1 - down;
        *y = across;
        break;
    case 180:
        *x = panel_width - 1 - across;
        *y = panel_height - 1 - down;
        break;
    case 270:
        *x = down;
        *y = panel_height - 1 - across;
        break;
    default:
        break;
    }
}
