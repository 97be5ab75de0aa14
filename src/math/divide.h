/* divide.h - 64-bit quotients and remainders, with a single function for division. */
#ifndef TIA_MATH_DIVIDE_H
#define TIA_MATH_DIVIDE_H

#include <stdbool.h>
#include <stdint.h>

/* Returns a/b, rounded down; b is not 0. */
uint64_t tia_quotient(uint64_t a, uint64_t b);

/* Returns a/b bit by bit, with code that is small: tia_quotient on machines of 32 bits. Twice the rest fits, since the
 * rest is made of the upper 63 bits of `a` at most. */
static inline uint64_t divide_by_bits(uint64_t a, uint64_t b)
{
    uint64_t rest = 0;

    for (int i = 0; i < 64; i++) {
        rest = rest << 1 | a >> 63;
        bool fits = rest >= b;
        rest -= fits ? b : 0;
        a = a << 1 | fits;
    }
    return a;
}

/* Returns a modulo b. */
static inline uint64_t divide_rest(uint64_t a, uint64_t b)
{
    return a - tia_quotient(a, b) * b;
}

#endif
