#include "places.h"

#include "math/wide.h"
#include "raster/distance.h"

void tia_place_of_vertex(const struct tia_places *p, const struct tia_raster_vertex *v, int64_t at[3])
{
    tia_flat_affine(p->flat, v, at);
    for (int k = 0; k < 3; k++)
        at[k] *= 1 << SEEN_BITS;
}

/* Gives a b 2^-shift, rounded; false when the result has more than SEEN_FAR bits. */
static bool scaled(int64_t a, int64_t b, int shift, int64_t *out)
{
    wide product = wide_product(a, b);

    if (wide_bits(wide_size(product)) - shift > SEEN_FAR)
        return false;
    *out = wide_round(product, (unsigned)shift);
    return true;
}

bool tia_place_seen(const struct tia_places *p, int x, int y, uint32_t face, int64_t at[3])
{
    const struct tia_raster_grid *l = &p->flat->grid;
    int64_t distance = tia_plane_distance(&p->flat->planes[face], l, x, y);
    int64_t u = wide_quotient(l->x + (int64_t)l->right * x, l->w, 60);
    int64_t v = wide_quotient(l->y - (int64_t)l->down * y, l->w, 60);
    int places = TIA_DISTANCE_BITS - l->fraction - SEEN_BITS;

    if (distance <= 0 || distance >= INT64_C(1) << 62)
        return false;
    if (l->projection != TIA_ORTHOGRAPHIC)
        return scaled(u, distance, 60 + places, &at[0]) && scaled(v, distance, 60 + places, &at[1]) &&
               scaled(INT64_C(1) << 60, distance, 60 + places, &at[2]);
    return scaled(u, 1, 60 - l->fraction - SEEN_BITS, &at[0]) && scaled(v, 1, 60 - l->fraction - SEEN_BITS, &at[1]) &&
           scaled(-1, distance, places, &at[2]);
}

void tia_place_across(const struct tia_places *p, const int64_t at[3], int64_t out[2])
{
    for (int i = 0; i < 2; i++) {
        int k = (p->axis + 1 + i) % 3;
        int64_t a = at[k] - wide_round(wide_product(at[p->axis], p->slope[k]), 60) - p->middle[k];
        int shift = p->scale - SEEN_BITS;
        out[i] = shift >= 0 ? a * (INT64_C(1) << shift) : tia_round_shift(a, (unsigned)-shift);
    }
}

/* Chooses the axis nearest to the light's direction, the middle of all points, and the unit across the axis. */
static void aim(struct tia_places *p)
{
    const struct tia_flat_scene *flat = p->flat;
    int64_t d[3], low[3], high[3], half = 1;

    tia_flat_affine(flat, p->light, d);
    p->axis = place_largest(d);
    p->scale = SEEN_BITS;
    for (int k = 0; k < 3; k++) {
        p->slope[k] = wide_quotient(d[k], d[p->axis], 60);
        p->middle[k] = 0;
        low[k] = INT64_MAX;
        high[k] = INT64_MIN;
    }
    for (uint32_t i = 0; i < flat->point_count; i++) {
        int64_t at[3], place[2];
        if (tia_flat_is_direction(flat, &flat->points[i]))
            continue;
        tia_place_of_vertex(p, &flat->points[i], at);
        tia_place_across(p, at, place);
        for (int k = 0; k < 2; k++) {
            low[k] = place[k] < low[k] ? place[k] : low[k];
            high[k] = place[k] > high[k] ? place[k] : high[k];
        }
    }
    for (int k = 0; k < 2 && low[0] <= high[0]; k++) {
        p->middle[(p->axis + 1 + k) % 3] = low[k] + (high[k] - low[k]) / 2;
        half = (high[k] - low[k]) / 2 + 1 > half ? (high[k] - low[k]) / 2 + 1 : half;
    }
    int scale = ACROSS_BITS - 64 + (int)tia_clz64((uint64_t)half) + SEEN_BITS;
    p->scale = scale < SEEN_BITS ? scale : SEEN_BITS;
}

void tia_places_init(struct tia_places *p, const struct tia_flat_scene *flat, const tia_flat_light *light)
{
    *p = (struct tia_places){.flat = flat, .light = light, .parallel = tia_flat_is_direction(flat, light)};
    if (p->parallel)
        aim(p);
    else
        tia_place_of_vertex(p, light, p->origin);
}
