/* raster_tmpl.h - the template of the rasteriser's runs, for instruction sets that compare 64-bit integers; others have
 * those of plain C. Besides, the kernels of shadow techniques.
 *
 * Parameters: the integers and doubles of isa/isa.h. Defines: `raster_runs`, a struct tia_raster_runs. */
#ifndef TIA_SIMD_RASTER_TMPL_H
#define TIA_SIMD_RASTER_TMPL_H

#include "raster/runs.h"
#include "shadow/kernels_tmpl.h"

#ifdef QN

/* Returns those of the `unsure` pixels in which the polygon is nearer. It is nearer than an empty pixel, and not nearer
 * than its own face. */
static __attribute__((noinline)) unsigned settle(const struct raster_polygon *p, size_t at, unsigned unsure)
{
    W there = w_part(p->face + at, k_of(unsure));
    unsigned empty = k_bits(w_eq(there, w_set(TIA_NO_FACE))), same = k_bits(w_eq(there, w_set(p->own)));
    unsigned nearer = unsure & empty;

    for (unsigned open = unsure & ~(empty | same), one; open; open &= ~one) {
        unsigned first = (unsigned)__builtin_ctz(open);
        bool is = p->is_nearer(p->ctx, at + first);
        one = 1u << first;
        if (p->face[at + first] == *p->equal)
            one |= open & k_bits(w_eq(there, w_set(*p->equal)));
        nearer |= is ? one : 0;
    }
    return nearer;
}

/* Returns the pixels of `live` in which the polygon is nearer. */
INLINE K nearer_ones(const struct raster_polygon *p, size_t at, Q z, Q there, K live)
{
    Q difference = q_sub(z, there);
    K nearer = k_and(live, q_gt(difference, q_set(DEPTH_UNSURE)));
    K unsure = k_minus(k_and(live, q_gt(difference, q_set(-DEPTH_UNSURE - 1))), nearer);

    return k_any(unsure) ? k_or(nearer, k_of(settle(p, at, k_bits(unsure)))) : nearer;
}

INLINE void put_nearest(const struct raster_polygon *p, size_t at, Q z, K nearer)
{
    if (!k_any(nearer))
        return;
    q_store(p->nearness + at, nearer, q_clamp(z)); /* rounding may make z negative; a nearness of 0 is infinitely far */
    w_store(p->face + at, nearer, w_set(p->own));
}

static void nearest(const struct raster_polygon *p, size_t at, int pixels, uint64_t first)
{
    Q z = q_ramp(first, p->step), step = q_set((int64_t)(QN * p->step));

    for (; pixels >= QN; pixels -= QN, at += QN, z = q_add(z, step))
        put_nearest(p, at, z, nearer_ones(p, at, z, q_load(p->nearness + at), k_all()));
    if (pixels) {
        K live = k_first(pixels);
        put_nearest(p, at, z, nearer_ones(p, at, z, q_part(p->nearness + at, live), live));
    }
}

static void add(const struct raster_polygon *p, size_t at, int pixels, uint64_t first)
{
    Q z = q_ramp(first, p->step), step = q_set((int64_t)(QN * p->step));
    W one = w_set(p->one);
    bool nearer = p->nearer;

    for (; pixels >= QN; pixels -= QN, at += QN, z = q_add(z, step)) {
        K counted = nearer_ones(p, at, z, q_load(p->nearness + at), k_all());
        counted = nearer ? counted : k_minus(k_all(), counted);
        if (k_any(counted))
            w_store(p->count + at, counted, w_add(w_load(p->count + at), one));
    }
    if (pixels) {
        K live = k_first(pixels), counted = nearer_ones(p, at, z, q_part(p->nearness + at, live), live);
        counted = nearer ? counted : k_minus(live, counted);
        w_store(p->count + at, counted, w_add(w_part(p->count + at, counted), one));
    }
}

#else

static void nearest(const struct raster_polygon *p, size_t at, int pixels, uint64_t z)
{
    tia_raster_runs_plain.nearest(p, at, pixels, z);
}

static void add(const struct raster_polygon *p, size_t at, int pixels, uint64_t z)
{
    tia_raster_runs_plain.add(p, at, pixels, z);
}

#endif

static const struct tia_raster_runs raster_runs = {nearest, add, &shadow_kernels};

#endif
