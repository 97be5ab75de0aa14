/* proved.h - bounds of the roundings of doubles in intersections. Each comment names the rounded quantity and, after
 * the colon, a size: the bound is the number times u = 2^-53 times this size. `make prove` proves them:
 * tests/proofs/rays_forms.g counts the roundings, rays_sphere.g proves a sphere's discriminant. */
#ifndef TIA_SIMD_RAYS_PROVED_H
#define TIA_SIMD_RAYS_PROVED_H

#define SURE_ALONG 8   /* a sphere's tca: |L| */
#define SURE_ASIDE 16  /* a sphere's P: |L| */
#define SURE_SQUARE 32 /* r^2 - |P|^2: r^2 */
#define SURE_FACE 16   /* D.(a x b): far^2, see triangle_tmpl.h */
#define SURE_PAIR 25   /* D.(a x b) in floats: (R + |M|) c, in units of 2^-24, see pairs_tmpl.h */
#define SURE_WAY 16    /* (P - O).N: |P - O|; D.N: 1 */
#define SURE_SLAB 4    /* t of a plane across an axis: t */
#define SURE_NORMAL 8  /* v/|v|: 1 */
#define SURE_TUBE 16   /* origin and direction in a cylinder's axes: |L| and 1 */

#endif
