#include "coherence_pays.h"

#define WIDE 1024 /* pixels */

/* True if three conditions hold. The sphere is seen from outside: c > 0. D = (L.v)^2 - c v.v is concave along rows: c >
 * L.x^2. The sphere's radius covers more than WIDE pixels, each 2 units of pixel coordinates wide: r depth > 2 WIDE
 * sqrt(c). */
bool coherence_pays(const struct primary_rays *primary, const struct span_sphere *sphere)
{
    num_wide depth = num_shift(num_square(primary->depth), -2 * primary->exponent); /* exponent 0 */

    return sphere->c > sphere->centre.x * sphere->centre.x && sphere->c > 0 &&
           num_product_above(num_square(sphere->radius), depth, sphere->c, (num_wide)4 * WIDE * WIDE);
}
