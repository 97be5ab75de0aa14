/* sums.h - a row's directions, and sums of products for a pixel and a sphere. Those whose terms may cancel are computed
 * in integers with K0 in the place of K; what K - K0 contributes is added in doubles. */
#ifndef TIA_SIMD_SPAN_SUMS_H
#define TIA_SIMD_SPAN_SUMS_H

#include "render/span/span.h"

/* A row's directions (v_x, v_y, -K). The integers have K0, which is K rounded, in the place of K. */
struct simd_row {
    int y;
    double depth, lacks, lacks2;   /* K, K - K0 and K^2 - K0^2, in units of pixel coordinates */
    double turn;                   /* bound of the relative error of K, with that of what K - K0 adds */
    double per_depth, per_depth2;  /* 1/K and its square */
    num_wide y_coordinate, square; /* v_y, and v_y^2 + K0^2 */
};

/* Returns v_x of pixel x. */
static inline num_wide simd_across(const struct primary_rays *primary, int x)
{
    return num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent);
}

/* Returns a.v with K0 in the place of K, exactly; `x` is v_x. */
static inline num_wide simd_product(const struct primary_rays *primary, const struct simd_row *row, struct num_vec a,
                                    num_wide x)
{
    return a.x * x + a.y * row->y_coordinate - a.z * primary->depth;
}

/* Returns a b - c d, rounded two or three times: all cancellation happens in integers. */
static inline double simd_difference(num_wide a, num_wide b, num_wide c, num_wide d)
{
#if TIA_INT128
    __extension__ typedef __int128 whole;
    whole r = (whole)a * b - (whole)c * d;
    int64_t low = (int64_t)r; /* signed: so each half is converted by an instruction, not a call */

    return (double)((int64_t)(r >> 64) + (low < 0)) * 0x1p64 + (double)low;
#else
    struct tia_wide p = tia_wide_product((uint64_t)num_abs(a), (uint64_t)num_abs(b));
    struct tia_wide q = tia_wide_product((uint64_t)num_abs(c), (uint64_t)num_abs(d));
    struct tia_wide r;

    if ((a < 0) != (b < 0))
        p = (struct tia_wide){~p.high + !p.low, 0 - p.low};
    if ((c < 0) == (d < 0))
        q = (struct tia_wide){~q.high + !q.low, 0 - q.low};
    r.low = p.low + q.low;
    r.high = p.high + q.high + (r.low < p.low);
    if ((int64_t)r.high < 0)
        return -((double)(~r.high + !r.low) * 0x1p64 + (double)(0 - r.low));
    return (double)r.high * 0x1p64 + (double)r.low;
#endif
}

/* Returns D = b^2 - c v.v; `b` is L.v with K0 in the place of K, `x` is v_x. */
static inline double simd_discriminant(const struct primary_rays *primary, const struct simd_row *row,
                                       const struct span_sphere *sphere, num_wide b, num_wide x)
{
    double z = (double)sphere->centre.z, c = (double)sphere->c, k0 = (double)primary->depth;
    double first = (double)b * z + c * k0, second = z * z - c;

    return simd_difference(b, b, sphere->c, x * x + row->square) + row->lacks * (row->lacks * second - 2 * first);
}

#endif
