#include "math/fast.h"

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

num_wide primary_y(const struct primary_rays *primary, int y)
{
    return num_pixel_coordinate(primary->height - 2 * y - 1, primary->exponent);
}

struct row_form primary_form(const struct primary_rays *primary, const struct num_vec *a, int x, int y, int shift)
{
    int middle = primary->width / 2;
    num_wide middle_x = num_pixel_coordinate(2 * middle + 1 - primary->width, primary->exponent);
    num_wide start = a->x * middle_x + a->y * primary_y(primary, y) - a->z * primary->depth;
    struct row_form form = {span_shift(start, shift) + NUM_HALF,
                            span_shift(a->x * num_pixel_coordinate(2, primary->exponent), shift)};

    /* With x - middle as its factor, the product is never larger than the form itself. Although the shift rounds, a
     * pixel's value does not depend on the start of the span. */
    form.start += (num_wide)(x - middle) * form.step;
    return form;
}

struct row_square primary_square(const struct primary_rays *primary, int x, int y)
{
    int shift = primary->square_shift;
    num_wide first = num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent), row = primary_y(primary, y);
    num_wide step = num_pixel_coordinate(2, primary->exponent);
    num_wide square = num_square(first) + num_square(row) + num_square(primary->depth);
    struct row_square s = {num_up(square, shift) + NUM_HALF, num_up(step * (2 * first + step), shift),
                           num_up(2 * num_square(step), shift)};

    return s;
}
