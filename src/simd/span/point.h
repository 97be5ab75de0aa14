/* point.h - a visible point in double precision, and the lights that reach it: the formulas of docs/definition.md, with
 * a bound on the error of each value, which bounds/pixels.h derives. Lengths are in units of 2^-16. */
#ifndef TIA_SIMD_SPAN_POINT_H
#define TIA_SIMD_SPAN_POINT_H

#include "pair.h"
#include "row.h"

/* A row's pixels of a sphere, and constants of the sphere: bias/r is `swell`. */
struct simd_seat {
    const struct tia_view *view;
    const struct simd_row *row;
    const struct primary_rays *primary;
    const struct span_sphere *sphere;
    double centre[3], radius, per_radius, swell;
};

/* The visible point P, r N, and the start P + bias N of shadow rays. */
struct simd_point {
    double p[3], n[3], start[3];
    double begins;         /* sum of the sizes of the start's components */
    double moved, started; /* bounds of the errors of P and of the start */
};

/* The numbers of spheres that may block a light. */
struct simd_blockers {
    int count;
    uint8_t sphere[TIA_SPAN_SPHERES];
};

/* A light at a point: the cosine, at least 0, the bound of its error, and the product of the transmissions of the
 * spheres that shadow it, whose number is `passed`; `none` where it certainly adds nothing. */
struct simd_arrival {
    double cosine, off, tint[3];
    int passed;
    bool none;
};

void tia_simd_seat(const struct tia_view *view, const struct simd_row *row, uint32_t sphere, struct simd_seat *seat);

/* Gives the visible point of pixel x; false when its error is too large. */
bool tia_simd_point(const struct simd_seat *seat, int x, struct simd_point *point);

/* Gives a light at a point; false when it is undecided. */
bool tia_simd_arrive(const struct simd_seat *seat, const struct simd_lamp *lamp, const struct simd_blockers *blockers,
                     const struct simd_point *point, struct simd_arrival *arrival);

static inline double simd_at_most_1(double a)
{
    return a > 1 ? 1 : a;
}

#endif
