#include "coherence_pays.h"

#define WIDE 1024 /* pixels */

/* True if the sphere is seen from outside, so that D = (L.v)^2 - c v.v is concave along rows, and its radius, in front
 * of the eye, is wider than WIDE pixels: r depth > WIDE sqrt(c). */
bool coherence_pays(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    num_wide depth = num_shift(primary->depth * primary->depth, -2 * primary->exponent); /* exponent 0 */

    return sphere->c > sphere->centre.x * sphere->centre.x && sphere->c > 0 &&
           num_product_above(sphere->radius * sphere->radius, depth, sphere->c, (num_wide)4 * WIDE * WIDE);
}
