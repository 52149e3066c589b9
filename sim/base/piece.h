/* How far a place is from a straight piece of a line. Inline: strokes ask it of every cell. */
#ifndef FROND_PIECE_H
#define FROND_PIECE_H

/* The square of the distance of (px, py) from the piece that goes from (0, 0) over (dx, dy), which may have no length;
 * in squares of the caller's unit. What grows by it depends on its last bit. */
static inline float piece_square(float px, float py, float dx, float dy)
{
    float length = dx * dx + dy * dy, t = length > 0 ? (px * dx + py * dy) / length : 0;
    t = t < 0 ? 0 : t > 1 ? 1 : t;
    float x = px - t * dx, y = py - t * dy;
    return x * x + y * y;
}

#endif
