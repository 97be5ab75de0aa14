/* sphere.h - a sphere seen from the eye: which pixels see it, and how far away.
 *
 * For the direction v, with b = L.v and c = L.L - r^2, the roots of |t v - L|^2 = r^2 are
 *
 *     t = (b -+ sqrt(b^2 - c v.v)) / v.v.
 *
 * Seen from outside the nearer root is c / (b + sqrt(b^2 - c v.v)), where nothing cancels; from
 * inside it is the farther one, (b + sqrt(b^2 - c v.v)) / v.v.
 */
#ifndef TIA_SPHERE_H
#define TIA_SPHERE_H

#include "view.h"

/* Prepares a sphere whose radius is not 0; else a body that no pixel sees. */
void sphere_prepare(const struct tia_view *view, struct body *body, struct tia_vec3 centre, tia_q16 radius);

/* The pixels of row y that see the sphere; `guess` is for speed only. */
struct run sphere_run(const struct tia_view *view, const struct body *body, int y, struct run guess);

/* t of the pixels x .. x + count - 1 (count <= CHUNK) of row y, which all see the sphere. */
void sphere_distances(const struct tia_view *view, const struct body *body, int y, int x, int count, num_u *t);

#endif
