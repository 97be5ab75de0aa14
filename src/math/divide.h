/* divide.h - 64-bit quotients and remainders, with a single function for division. */
#ifndef TIA_MATH_DIVIDE_H
#define TIA_MATH_DIVIDE_H

#include <stdint.h>

/* Returns a/b, rounded down; b is not 0. */
uint64_t tia_quotient(uint64_t a, uint64_t b);

/* Returns a modulo b. */
static inline uint64_t divide_rest(uint64_t a, uint64_t b)
{
    return a - tia_quotient(a, b) * b;
}

#endif
