/* proved.h - the roundings of doubles on the way to an intersection, in units of u = 2^-53 times the quantity beside
 * each number. `make prove` shows that they are no larger: tests/proofs/rays_forms.g counts the roundings,
 * rays_sphere.g proves a sphere's discriminant. */
#ifndef TIA_SIMD_RAYS_PROVED_H
#define TIA_SIMD_RAYS_PROVED_H

#define SURE_ALONG 8   /* a sphere's tca: |L| */
#define SURE_ASIDE 16  /* a sphere's P: |L| */
#define SURE_SQUARE 32 /* r^2 - |P|^2: r^2 */
#define SURE_FACE 16   /* D.(a x b): |x| + |y| + |z| of the origin and the most of a corner, squared */
#define SURE_PAIR 25   /* D.(a x b) in floats, in units of 2^-24: see pairs_tmpl.h */
#define SURE_WAY 16    /* (P - O).N and D.N: |P - O|, and 1 */
#define SURE_SLAB 4    /* a plane across an axis: t */
#define SURE_NORMAL 8  /* v/|v|: 1 */
#define SURE_TUBE 16   /* a ray in a cylinder's axes: |L|, and 1 */

#endif
