/* sure_numbers.h - units of fixed-point numbers in doubles, and conversions. Integers of up to 53 bits times these
 * units are exact. */
#ifndef TIA_SIMD_RAYS_SURE_NUMBERS_H
#define TIA_SIMD_RAYS_SURE_NUMBERS_H

#include "render/trace/trace.h"

#define P2M(n) (1.0 / (double)(UINT64_C(1) << (n))) /* 2^-n, n < 64 */
#define SURE_UNIT P2M(45)                           /* unit of fixed-point coordinates */
#define SURE_EPS P2M(53)                            /* half a unit in the last place of 1.0 */

/* Units of Q16.16 and similar formats, and of 32 random bits. Products of integers with these are exact. */
#define SURE_Q16 P2M(16)
#define SURE_Q30 P2M(30)
#define SURE_Q32 P2M(32)
#define SURE_Q62 P2M(62)

static inline double sure_length(num_length x)
{
    return (double)x * SURE_UNIT;
}

/* Returns 2^bits for bits in -28..31. */
static inline double sure_two_to(int bits)
{
    return bits < 0 ? 1 / (double)(INT64_C(1) << -bits) : (double)(INT64_C(1) << bits);
}

static inline double sure_cosine(num_unit d)
{
    return (double)d * SURE_Q62;
}

static inline void sure_point(double to[3], struct num_point p)
{
    to[0] = sure_length(p.x);
    to[1] = sure_length(p.y);
    to[2] = sure_length(p.z);
}

static inline void sure_dir(double to[3], struct num_dir d)
{
    to[0] = sure_cosine(d.x);
    to[1] = sure_cosine(d.y);
    to[2] = sure_cosine(d.z);
}

static inline void sure_rgb(double to[3], const struct tia_rgb *c)
{
    to[0] = (double)c->r * SURE_Q30;
    to[1] = (double)c->g * SURE_Q30;
    to[2] = (double)c->b * SURE_Q30;
}

static inline double sure_most3(const double c[3])
{
    double most = c[0] > c[1] ? c[0] : c[1];

    return most > c[2] ? most : c[2];
}

/* Sets a corner from Q16.16. */
static inline void sure_corner(double to[3], const struct tia_vec3 *from)
{
    to[0] = (double)from->x * SURE_Q16;
    to[1] = (double)from->y * SURE_Q16;
    to[2] = (double)from->z * SURE_Q16;
}

#endif
