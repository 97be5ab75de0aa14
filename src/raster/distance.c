#include "distance.h"

#include "halves.h"

/* Returns the mantissa m of a = m 2^exponent, m in 2^61..2^62; a > 0. */
static int64_t mantissa(wide a, int *exponent)
{
    int bits = wide_bits(a);

    *exponent = bits - 62;
    return bits > 62 ? wide_down(a, (unsigned)(bits - 62)) : (int64_t)(wide_low(a) << (62 - bits));
}

/* Returns m 2^exponent, m in 0..2^93, rounded, at most 2^62. */
static int64_t scaled(wide m, int exponent)
{
    int bits = wide_bits(m) + exponent;

    if (bits > 62)
        return INT64_C(1) << 62;
    if (exponent >= 0)
        return (int64_t)(wide_low(m) << exponent);
    return exponent < -126 ? 0 : wide_round(m, (unsigned)-exponent);
}

/* With t = det/f the visible point of a plane is t D, and in perspective its distance t D.w. In orthographic views that
 * point has w = 1, so t = 1/D.w, and -h = -f/(det D.w). */
int64_t tia_plane_distance(const struct tia_raster_plane *plane, const struct tia_raster_grid *l, int x, int y)
{
    bool flat = l->projection == TIA_ORTHOGRAPHIC;
    wide f = wide_sum(wide_sum(wide_times(halves_get(plane->x), x), wide_times(halves_get(plane->y), y)),
                      halves_get(plane->c));
    wide above = flat ? wide_difference(wide_product(0, 0), f) : halves_get(plane->det);
    wide below = flat ? wide_times(halves_get(plane->det), l->w) : f;
    int up, down;

    if (wide_sign(below) <= 0 || wide_sign(above) <= 0)
        return 0;
    int64_t a = mantissa(above, &up), b = mantissa(below, &down);
    wide ratio = wide_product(wide_quotient(a, b, 60), flat ? 1 : l->w);
    return scaled(ratio, up - down - 60 + TIA_DISTANCE_BITS - (flat ? 0 : l->fraction));
}

int64_t tia_raster_distance(const struct tia_raster_plane *plane, const struct tia_raster_grid *grid, int x, int y)
{
    bool seen = plane && grid && x >= 0 && y >= 0 && x < (int)grid->width && y < (int)grid->height;

    return seen ? tia_plane_distance(plane, grid, x, y) : 0;
}
