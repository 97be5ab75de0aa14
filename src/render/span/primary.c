#include "math/fast.h"

#include "primary.h"

#include "span_shift.h"

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
