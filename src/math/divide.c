/* divide.c - 64-bit division. Elsewhere than here it would link a long function on 32-bit machines. */
#include "divide.h"

uint64_t tia_quotient(uint64_t a, uint64_t b)
{
    return UINTPTR_MAX > UINT32_MAX ? a / b : divide_by_bits(a, b);
}
