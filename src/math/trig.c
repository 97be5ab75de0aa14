/* trig.c - sine, cosine and cot(fov / 2) by their power series. */
#include "trig.h"

#include "divide.h"
#include "integer.h"

#define ONE (UINT64_C(1) << 63) /* 1.0 as Q1.63 */

/* Returns the product of two numbers in Q1.63. */
static uint64_t product(uint64_t a, uint64_t b)
{
    struct tia_wide p = tia_wide_product(a, b);
    return p.high << 1 | p.low >> 63;
}

/* Returns the Taylor series 1 - z2 / (n (n-1)) (1 - z2 / ((n+2) (n+1)) (...)) up to n = last: cos z for an even `last`,
 * sin z / z for an odd one. For z <= pi/4 the omitted terms, from z^22 on, are below 2^-70. */
static uint64_t series(uint64_t z2, unsigned last)
{
    uint64_t sum = ONE;
    for (unsigned n = last; n >= 2; n -= 2)
        sum = ONE - tia_quotient(product(z2, sum), n * (n - 1));
    return sum;
}

/* Returns 2^56 a / b by long division; a / b < 2^8. */
static uint64_t quotient(uint64_t a, uint64_t b)
{
    uint64_t q = tia_quotient(a, b), rest = a - q * b;
    for (unsigned i = 0; i < 56; i++) {
        /* rest < b <= 2^63: no overflow */
        rest <<= 1;
        q = q << 1 | (rest >= b);
        rest -= rest >= b ? b : 0;
    }
    return q;
}

void tia_octant(uint32_t half_degrees, uint64_t *sine, uint64_t *cosine)
{
    /* converts to radians: times pi / (360 * 2^16), with 86 fraction bits, then rounded down to 63 */
    struct tia_wide z86 = tia_wide_product(half_degrees, UINT64_C(0x8efa351294e9c8ae));
    uint64_t z = z86.high << 41 | z86.low >> 23;
    uint64_t z2 = product(z, z);
    *sine = product(z, series(z2, 21));
    *cosine = series(z2, 20);
}

uint64_t tia_cotangent(tia_q16 fov)
{
    /* In tia_octant's unit, half of fov's, the number fov stands for the angle fov/2. Above 45 degrees cot x = tan(90 -
     * x). */
    const uint32_t right = 90 * TIA_Q16_ONE;
    uint32_t angle = (uint32_t)fov;
    uint64_t sine, cosine;

    tia_octant(angle <= right ? angle : 2 * right - angle, &sine, &cosine);
    return angle <= right ? quotient(cosine, sine) : quotient(sine, cosine);
}
