/* divisor.h - the greatest common divisor. */
#ifndef TIA_MATH_DIVISOR_H
#define TIA_MATH_DIVISOR_H

#include <stdint.h>

/* Returns the greatest common divisor of two numbers, which are not both 0. */
static inline uint32_t common_divisor(uint32_t a, uint32_t b)
{
    while (b) {
        uint32_t rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

#endif
