/* primary_view.c - what primary.h computes once a view, or once a sphere or light: small, not fast. */
#include "primary.h"

#include "span_shift.h"

#include "math/integer.h"
#include "math/trig.h"

/* Prepares the rays. The exponent of pixel coordinates keeps |v| below 2^30 in every pixel, and also at the position
 * after the last pixel, to which a struct row_square is advanced. The step there, 4 X + 4 with X <= width + 1, is below
 * (width + 3)^2. */
void primary_prepare(struct primary_rays *primary, unsigned width, unsigned height, tia_q16 fov)
{
    uint64_t cotangent = tia_cotangent(fov);
    uint64_t w = (uint64_t)width + 3, h = (uint64_t)height + 1;
    uint64_t d = (h * ((cotangent >> 40) + 1) >> 16) + 1;
    int bits = 64 - (int)tia_clz64(w * w + h * h + d * d);

    primary->width = (int)width;
    primary->height = (int)height;
    primary->exponent = 30 - (bits + 1) / 2;
    primary->exact = fov == TIA_Q16(90);
    primary->depth = primary->exact ? num_pixel_coordinate((int32_t)height, primary->exponent)
                                    : num_depth(height, cotangent, primary->exponent);
    primary->x_reach = num_pixel_coordinate((int32_t)w, primary->exponent);
    primary->y_reach = num_pixel_coordinate((int32_t)h, primary->exponent);
    num_wide most = num_square(primary->x_reach) + num_square(primary->y_reach) + num_square(primary->depth);
    primary->square_shift = 63 - num_bits(most + span_shift(most, -20));
}

num_wide primary_reach(const struct primary_rays *primary, const struct num_vec *a)
{
    num_wide reach =
        num_abs(a->x) * primary->x_reach + num_abs(a->y) * primary->y_reach + num_abs(a->z) * primary->depth;
    return reach + span_shift(reach, -20); /* headroom for NUM_HALF */
}
