/* depth.h - nearness, the filter in 63 bits, and the exact order behind it.
 *
 * Nearness is f/det 2^scale, clamped to 0..2^62. In perspective only points in front of the eye are visible, where f >
 * 0. Orthographic h has both signs, so 2^61 is added to nearness; f/det 2^scale is within +-2^61 then, so no later
 * result is larger than in perspective, and a step from one end to the other is again at most 2^62.
 *
 * f/2^cut loses less than one unit of nearness, for 2^cut <= det/2^scale. The reciprocal's relative error is below 1.13
 * 2^-60, that is 5 units of 2^62; with the bits that the shift drops, nearness errs by less than 7. A step errs by less
 * than 2, and along a run the relative error of all steps together is again 5: over at most 8191 steps less than
 * DEPTH_ERROR in all (ranges.h; proved in tests/proofs/raster_depth.g). Two such values that differ by more than
 * DEPTH_UNSURE are ordered as the exact ones. Clamping moves no two values apart, so clamped values that differ so much
 * are sure as well; but steps are taken only where neither end of a run is clamped.
 */
#ifndef TIA_RASTER_DEPTH_H
#define TIA_RASTER_DEPTH_H

#include "polygon.h"
#include "ranges.h"

#define DEPTH_MOST (INT64_C(1) << 62)

struct depth_run {
    uint64_t z, step; /* modulo 2^64: the step after the last pixel is not used */
    bool steady;      /* z may be stepped */
};

void tia_depth_plane(const struct polygon *p, struct tia_raster_plane *plane);

/* Returns the run of nearness at pixels x0..x1-1 of row y, which are covered. */
struct depth_run tia_depth_run(const struct polygon *p, int y, int x0, int x1);

/* Returns the run of tia_depth_run, without a call in the most frequent case: a narrow polygon is never orthographic,
 * so nearness is 0 where f is. */
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

/* Returns 1 where p is nearer than the plane, -1 farther, 0 when they are the same. */
int tia_depth_order(const struct polygon *p, const struct tia_raster_plane *plane, int x, int y);

#endif
