/* depth.h - nearness, the filter of depths in 63 bits, and the exact order of depths.
 *
 * Nearness is f/det 2^scale, clamped to 0..2^62. In perspective only points in front of the eye are visible, where f >
 * 0. In orthographic views h has both signs: f/det 2^scale is within +-2^61, and 2^61 is added to it. So all later
 * results are in the same range as in perspective, and a step from one end of the range to the other is again at most
 * 2^62.
 *
 * f/2^cut loses less than one unit of nearness, as 2^cut <= det/2^scale. The reciprocal's relative error is below 1.13
 * 2^-60, that is 5 units at 2^62; with the bits that the shift drops, the error of nearness is below 7. The roundings
 * of a step add up to less than 2, and the relative error of all steps of a run together adds 5 units again. Over at
 * most 8191 steps the whole error is below DEPTH_ERROR (ranges.h; proved in tests/proofs/raster_depth.g). Two such
 * values that differ by more than DEPTH_UNSURE are in the same order as the exact ones. Clamping never moves two values
 * apart, so the order of clamped values that differ so much is certain as well. Steps, however, are taken only where
 * neither end of a run is clamped.
 */
#ifndef TIA_RASTER_DEPTH_H
#define TIA_RASTER_DEPTH_H

#include "polygon.h"
#include "ranges.h"

#define DEPTH_MOST (INT64_C(1) << 62)

struct depth_run {
    uint64_t z, step; /* modulo 2^64, as the value after the last pixel may overflow */
    bool steady;      /* z can be stepped along the run */
};

/* Gives the polygon's plane as targets store it. */
void tia_depth_plane(const struct polygon *p, struct tia_raster_plane *plane);

/* Returns nearness along the covered pixels x0..x1-1 of row y. */
struct depth_run tia_depth_run(const struct polygon *p, int y, int x0, int x1);

/* Gives nearness along the first of these pixels, of which all or none are clamped, at one end of the range. Returns
 * the first pixel that is not one of them, or x1. */
int tia_depth_part(const struct polygon *p, int y, int x0, int x1, struct depth_run *run);

/* Returns the result of tia_depth_run, in the most frequent case without a call. A narrow polygon is never
 * orthographic, so its nearness is 0 where f is 0. */
static inline struct depth_run depth_run(const struct polygon *p, int y, int x0, int x1)
{
    const struct depth_scale *d = &p->depth;

    if (!d->steady || !p->narrow)
        return tia_depth_run(p, y, x0, x1);
    int64_t cut = narrow_form_at(&p->of.narrow_forms.plane, x0, y) >> d->cut;
    return (struct depth_run){(uint64_t)wide_down(wide_product(cut, (int64_t)d->reciprocal), d->shift),
                              (uint64_t)d->step, true};
}

/* Returns the nearness at one covered pixel. */
int64_t tia_depth_at(const struct polygon *p, int x, int y);

/* Returns 1 if p is nearer than the plane at pixel (x, y), -1 if farther, 0 if both planes are equal. */
int tia_depth_order(const struct polygon *p, const struct tia_raster_plane *plane, int x, int y);

#endif
