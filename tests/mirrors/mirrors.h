/* mirrors.h - chains of mirrors: the points at which a camera's ray meets one object after the other. */
#ifndef TESTS_MIRRORS_MIRRORS_H
#define TESTS_MIRRORS_MIRRORS_H

#include <tia/tia.h>

/* A type of 113 bits, as in num/num_f128.h. It holds the coordinates of every arithmetic exactly. */
#if __LDBL_MANT_DIG__ == 113
typedef long double mirror_real;
#else
typedef __float128 mirror_real;
#endif

struct mirror_hit {
    uint32_t object;
    mirror_real at[3];
};

/* Follows the ray of a pixel of the view, in the arithmetic of the view's core, as if every object were a mirror.
 * Returns the number of hits, `most` or fewer. */
typedef unsigned mirror_chain(const struct tia_view *view, int x, int y, unsigned most, struct mirror_hit hits[]);

mirror_chain mirror_chain_q16, mirror_chain_f32, mirror_chain_f64, mirror_chain_f128;

#endif
