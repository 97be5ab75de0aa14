#include "forms_wide.h"
#include "halves.h"
#include "polygon.h"
#include "ranges.h"

#define QUOTIENT_BITS 42 /* largest number of bits of a quotient, far beyond the range of values */

/* The point at a pixel is a weighted sum of the corners; a corner's weight is det(D, q, q'), with q and q' the other
 * two corners. The value is the weighted mean of the values of the corners that are points. */
bool tia_raster_corners_init(struct tia_raster_corners *corners, const struct tia_raster_grid *grid,
                             const struct tia_raster_vertex vertices[3])
{
    int64_t q[3][3];
    wide n[3];

    if (!corners || !grid || !vertices || !tia_polygon_has_range(grid, vertices, 3))
        return false;
    for (int i = 0; i < 3; i++) {
        q[i][0] = vertices[i].x;
        q[i][1] = vertices[i].y;
        q[i][2] = vertices[i].w;
    }
    wide_cross(q[0], q[1], n);
    int sign = wide_sign(wide_determinant(n, q[2]));
    for (int i = 0; i < 3; i++) {
        bool point = grid->projection == TIA_ORTHOGRAPHIC ? vertices[i].w != 0 : vertices[i].h != 0;
        wide_cross(q[(i + 1) % 3], q[(i + 2) % 3], n);
        struct wide_form f = wide_form_of(n, grid);
        halves_put(corners->weights[i][0], wide_times(f.x, point * sign));
        halves_put(corners->weights[i][1], wide_times(f.y, point * sign));
        halves_put(corners->weights[i][2], wide_times(f.c, point * sign));
    }
    return sign != 0;
}

/* True if the value is at least m - 1/2, that is, if the sum of (2 a - 2 m + 1) weight is at least 0. Weights, below
 * 2^116, are split into their lower 62 bits and the rest, so neither sum reaches 2^98. */
static bool is_at_least(const wide weight[3], const tia_q16 a[3], int64_t m)
{
    wide low = wide_product(0, 0), high = low;

    for (int i = 0; i < 3; i++) {
        int64_t factor = 2 * (int64_t)a[i] - 2 * m + 1;
        uint64_t rest = wide_low(weight[i]) & ((UINT64_C(1) << 62) - 1);
        low = wide_sum(low, wide_product((int64_t)rest, factor));
        high = wide_sum(high, wide_product(wide_down(weight[i], 62), factor));
    }
    return !wide_is_negative(wide_sum(high, wide_product(wide_down(low, 62), 1)));
}

static tia_q16 search(const wide weight[3], const tia_q16 a[3])
{
    int64_t n = INT32_MIN;

    for (int64_t bit = INT64_C(1) << 31; bit; bit /= 2)
        if (n + bit <= INT32_MAX && is_at_least(weight, a, n + bit))
            n += bit;
    return (tia_q16)n;
}

/* Returns the length of |over/under| in bits, or one more. under > 0. */
static int quotient_bits(wide over, int64_t under)
{
    return wide_bits(wide_size(over)) - (64 - (int)tia_clz64((uint64_t)under)) + 1;
}

/* Returns over/under, of at most QUOTIENT_BITS bits, with BLEND_BITS fraction bits; if below 2^31, its error is at most
 * 1 + 2^-8 units. */
static int64_t fine_quotient(wide over, int64_t under)
{
    wide size = wide_size(over);
    int bits = wide_bits(size), excess = bits > 63 ? bits - 63 : 0;
    unsigned zeros = tia_clz64((uint64_t)under);
    int64_t top = excess ? wide_down(size, (unsigned)excess) : (int64_t)wide_low(size);
    int shift = 126 - (int)zeros - BLEND_BITS - excess;
    wide product = wide_product(top, wide_reciprocal((uint64_t)under << zeros));
    int64_t quotient = shift > 126 ? 0 : wide_down(product, (unsigned)shift);

    return wide_is_negative(over) ? -quotient : quotient;
}

/* Interpolates with the upper 60 bits of the weights, all cut at the same bit: each is off by less than 1, and the
 * largest is at least 2^59. So if their sum is at least 2^BLEND_LEAST, the quotient's error is small (ranges.h;
 * tests/proofs/raster_blend.g), and the exact sum is needed only close to a rounding boundary. */
tia_q16 tia_raster_corners_blend(const struct tia_raster_corners *corners, int x, int y, const tia_q16 a[3])
{
    wide weight[3], over = wide_product(0, 0), sum = over;
    int64_t under = 0;
    int bits = 0;

    if (!corners || !a || x < 0 || y < 0 || x >= TIA_SIZE_MAX || y >= TIA_SIZE_MAX)
        return 0;
    for (int i = 0; i < 3; i++) {
        struct wide_form f = {halves_get(corners->weights[i][0]), halves_get(corners->weights[i][1]),
                              halves_get(corners->weights[i][2])};
        weight[i] = wide_form_at(&f, x, y);
        sum = wide_sum(sum, weight[i]);
        int own = wide_bits(wide_size(weight[i]));
        bits = own > bits ? own : bits;
    }
    if (wide_sign(sum) <= 0)
        return 0;
    for (int i = 0; i < 3; i++) {
        int64_t upper = bits > 60 ? wide_down(weight[i], (unsigned)(bits - 60)) : (int64_t)wide_low(weight[i]);
        over = wide_sum(over, wide_product(upper, a[i]));
        under += upper;
    }
    if (bits > 60 && under < INT64_C(1) << BLEND_LEAST)
        return search(weight, a);
    if (quotient_bits(over, under) > QUOTIENT_BITS)
        return wide_is_negative(over) ? INT32_MIN : INT32_MAX;
    int64_t shifted = fine_quotient(over, under) + (INT64_C(1) << (BLEND_BITS - 1)) + BLEND_UNSURE,
            nearest = shifted >> BLEND_BITS;
    if ((shifted & ((INT64_C(1) << BLEND_BITS) - 1)) < 2 * BLEND_UNSURE)
        nearest -= !is_at_least(weight, a, nearest);
    return tia_saturate_s32(nearest);
}
