/* meshes.h - bounds of meshes: pairs_tmpl.h, level_tmpl.h. eo is the error of the origin. */
#ifndef TIA_SIMD_RAYS_BOUNDS_MESHES_H
#define TIA_SIMD_RAYS_BOUNDS_MESHES_H

/* ---- pairs of faces in floats, see pairs_tmpl.h ---- */

/* The rounding of an area in floats, relative to (R + |M|) c: 25 roundings of 2^-24, see pairs_tmpl.h. Proved:
 * rays_pairs.g. */
#define BOUND_PAIR_AREA (SURE_PAIR * P2M(24))

/* The error l.each times a face's extent, divided by c, the pair's `size`: the extent is at most 3 c, as c is at least
 * the largest coordinate of any edge. */
FORMULA(PAIR_EDGE);

/* The relative rounding of the bound off + by c in floats: two conversions, a product and a sum, 2^-24 each. Needed:
 * half of 2^-21. Unseen: small. */
#define BOUND_PAIR_ROUNDING P2M(21)

/* ---- level meshes, see level_tmpl.h ---- */

/* The least height of an origin over a level mesh, beyond eo. Roundings move no intersection as far as 2^-30 out of a
 * shape; the difference of two coordinates below 2^17 is rounded by 2^-35. Needed: half of 2^-29. Unseen: small. */
#define BOUND_LEVEL_HEIGHT P2M(29)

/* The height over a level mesh from which a ray that moves away certainly misses it: eo and LEVEL_HEIGHT. */
FORMULA(LEVEL_AWAY);

#endif
