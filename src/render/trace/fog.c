/* fog.c - the mean density along a ray, and what passes the fog.
 *
 * With h = y - level, H = height and u = h/H the density is 1 for u <= 0 and 1/(1 + u^2) above. Its integral over h
 * from 0 on is H atan u, so that the mean is
 *
 *     (atan v - atan u)/(v - u)    between u and v that are not negative,
 *     1 - s + s atan(v)/v          from below 0 to v > 0, with the share s of the way above 0,
 *     1                            below 0.
 *
 * The difference of the angles is that of the directions (H, h), and is computed without cancellation. It is off by
 * less than 2^-50, and its quotient with v - u by 2^-36 if that is at least 2^-14. Below, the mean is the density in
 * the middle, 1/(1 + u^2) with an error of (v - u)^2/12 < 2^-31. Up to infinity the integral from h on is H atan(H/h),
 * or H pi/2 - h for h < 0. */
#include "fog.h"

#include "rgb.h"

#define HALF_PI num_unit_of_q62(INT64_C(0x6487ed5110b4611a))
#define LEAST_RISE (NUM_LENGTH_ONE / 16384)

/* Returns the unit vector along (H, h). */
static struct num_dir slope_of(num_length height, num_length h)
{
    const struct num_point along = {height, h, 0};
    struct num_dir d;

    (void)num_normalise(along, &d);
    return d;
}

/* Returns the angle of (x, y), 0..pi/2. */
static num_unit angle_of(num_unit y, num_unit x)
{
    return num_times(4 * num_atan2(y, x), HALF_PI);
}

/* Returns the mean density between two heights, 0 <= low <= high. */
static num_unit density_above(num_length height, num_length low, num_length high)
{
    num_length rise = high - low, part = num_ratio(rise, height);

    if (part < LEAST_RISE) {
        num_unit cosine = slope_of(height, low + rise / 2).x;
        return num_times(cosine, cosine);
    }
    const struct num_dir a = slope_of(height, low), b = slope_of(height, high);
    num_unit turn = angle_of(num_dir_cross(a, b).z, num_dir_dot(a, b));
    if (rise >= height)
        return num_times(turn, num_fraction(height, rise));
    return num_fraction(num_length_of_unit(turn), part);
}

/* Returns the mean density along a line that rises by `rise` from h on. */
static num_unit mean_density(num_length height, num_length h, num_length rise)
{
    num_length low = rise < 0 ? h + rise : h, high = rise < 0 ? h : h + rise;

    if (high <= 0)
        return NUM_UNIT_ONE;
    if (low >= 0)
        return density_above(height, low, high);
    return NUM_UNIT_ONE - num_times(num_fraction(high, high - low), NUM_UNIT_ONE - density_above(height, 0, high));
}

/* Returns the share that passes the fog up to infinity. */
static num_unit endless_share(const struct tia_fog *fog, const struct ray *ray, num_length h)
{
    num_length height = num_length_of(fog->height);

    if (!fog->height || ray->direction.y <= 0)
        return 0;
    const struct num_dir d = slope_of(height, h > 0 ? h : 0);
    num_length above = num_times(height, angle_of(d.x, d.y)) - (h < 0 ? h : 0);
    return num_fade(num_div(num_ratio(above, num_length_of(fog->distance)), ray->direction.y));
}

num_unit ray_fog_share(const struct tia_fog *fog, const struct ray *ray, const struct hit *hit)
{
    num_length h = ray->origin.y - num_length_of(fog->level);

    if (hit->light == TIA_NO_OBJECT && hit->object == TIA_NO_OBJECT)
        return endless_share(fog, ray, h);
    num_length way = hit->t;
    if (fog->height)
        way = num_times(way, mean_density(num_length_of(fog->height), h, num_times(way, ray->direction.y)));
    return num_fade(num_ratio(way, num_length_of(fog->distance)));
}

void ray_fog_veil(const struct tia_fog *fog, const struct ray *ray, const struct hit *hit, num_length throughput[3],
                  num_length colour[3])
{
    num_unit share = ray_fog_share(fog, ray, hit);
    num_length own[3];

    ray_rgb(&fog->colour, own);
    for (int c = 0; c < 3; c++) {
        num_length through = num_times(throughput[c], share);
        colour[c] = num_sum_within(colour[c], num_product_within(own[c], throughput[c] - through));
        throughput[c] = through;
    }
}
