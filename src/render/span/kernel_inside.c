/* kernel_inside.c - the distances of a sphere around the eye: apart from the other kernels, as flash is scarce. */
#include "kernels.h"

#include "math/integer.h"

void span_sphere_inside(const struct sphere_line *line, num_u *t)
{
    num_wide b = line->b;
    struct row_square v = line->square;

    for (int i = 0; i < line->count; i++) {
        num_wide along = num_top(b);
        num_u top = (num_u)num_abs(along), square = num_top_u(v.start);
        num_u sum = top + num_sqrt(num_mul_u(top, top) + num_mul_u(line->c_disc, square));
        if (along < 0)
            t[i] = num_quotient(line->c_top, sum > 0 ? sum : NUM_LEAST, line->behind_shift);
        else
            t[i] = num_quotient(sum, square > 0 ? square : NUM_LEAST, line->t_shift);
        b += line->b_step;
        v.start += v.step;
        v.step += v.twice;
    }
}
