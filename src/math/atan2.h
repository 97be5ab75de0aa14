/* atan2.h - the angle of a vector. */
#ifndef TIA_MATH_ATAN2_H
#define TIA_MATH_ATAN2_H

#include "integer.h"

/* Returns atan2(y, x)/(2 pi), in -1/2..1/2, Q1.62; 0 for (0, 0). |x|, |y| <= 2^62; if one of them is near 2^62, the
 * angle's error is below 2^-55. Uses CORDIC: rotates the vector onto the x axis by angles with the tangents 1, 1/2,
 * 1/4, ... */
static inline int64_t tia_atan2(int64_t y, int64_t x)
{
    int64_t angle = 0;

    if (x < 0) {
        angle = y < 0 ? -(INT64_C(1) << 61) : INT64_C(1) << 61;
        x = -x;
        y = -y;
    }
    x /= 2; /* CORDIC lengthens the vector by the factor 1.65 */
    y /= 2;
    if (x == 0 && y == 0)
        return 0;
    for (int i = 0; i < 60; i++) {
        int64_t dx = y >> i, dy = x >> i;
        angle += y < 0 ? -tia_turns[i] : tia_turns[i];
        x += y < 0 ? -dx : dx;
        y += y < 0 ? dy : -dy;
    }
    return angle;
}

#endif
