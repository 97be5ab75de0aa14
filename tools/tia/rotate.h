/* rotate.h - positions of pixels in a picture that is rotated clockwise. */
#ifndef TOOLS_TIA_ROTATE_H
#define TOOLS_TIA_ROTATE_H

#include <tia/render.h>

struct rotation {
    unsigned degrees;       /* 0, 90, 180, 270 */
    unsigned width, height; /* size of the picture before rotation */
};

/* True if the rotation swaps width and height. */
static inline bool rotation_swaps(unsigned degrees)
{
    return degrees % 180 != 0;
}

/* Returns the inverse rotation. */
struct rotation rotation_inverse(const struct rotation *rotation);

/* Returns the rectangle of the rotated picture that shows `tile` of the original. */
struct tia_tile rotation_tile(const struct rotation *rotation, struct tia_tile tile);

/* Returns a surface for drawing a tile of the original picture, so that it appears rotated in `surface`, the memory of
 * the rotated tile of width x height pixels. */
struct tia_surface rotation_surface(const struct rotation *rotation, const struct tia_surface *surface, unsigned width,
                                    unsigned height);

#endif
