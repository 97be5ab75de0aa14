/* rotate.h - where the pixels of a picture go when it is shown turned clockwise. */
#ifndef TOOLS_TIA_TURN_H
#define TOOLS_TIA_TURN_H

#include <tia/render.h>

struct rotation {
    unsigned degrees;       /* 0, 90, 180, 270 */
    unsigned width, height; /* of the picture before it is turned */
};

/* Whether the turned picture is as wide as the picture is high. */
static inline bool rotation_swaps(unsigned degrees)
{
    return degrees % 180 != 0;
}

/* The turn that takes the turned picture back to the picture. */
struct rotation rotation_inverse(const struct rotation *rotation);

/* The rectangle of the turned picture that holds `tile` of the picture. */
struct tia_tile rotation_tile(const struct rotation *rotation, struct tia_tile tile);

/* The surface on which the picture's pixels fall into `surface`, which is plain memory of a
 * turned tile width x height pixels in size. */
struct tia_surface rotation_surface(const struct rotation *rotation, const struct tia_surface *surface, unsigned width,
                                    unsigned height);

#endif
