/* divide.c - 64-bit division. Elsewhere than here it would link a long function on 32-bit machines. */
#include "divide.h"

#include <stdbool.h>

/* Returns a/b bit by bit, with code that is small. */
static inline uint64_t by_bits(uint64_t a, uint64_t b)
{
    uint64_t rest = 0;

    for (int i = 0; i < 64; i++) {
        bool over = rest >> 63; /* then twice the rest is at least 2^64, above b */
        rest = rest << 1 | a >> 63;
        bool fits = over || rest >= b;
        rest -= fits ? b : 0;
        a = a << 1 | fits;
    }
    return a;
}

uint64_t tia_quotient(uint64_t a, uint64_t b)
{
    return UINTPTR_MAX > UINT32_MAX ? a / b : by_bits(a, b);
}
