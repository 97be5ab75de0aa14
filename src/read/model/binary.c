#include "binary.h"

/* Converts (-1)^negative m 2^exponent, m < 2^53. */
static enum tia_decimal fixed(int64_t *out, bool negative, uint64_t m, int exponent)
{
    uint64_t size;

    if (exponent >= 0)
        size = m << exponent;
    else
        size = exponent < -54 ? 0 : (m + (UINT64_C(1) << (-exponent - 1))) >> -exponent;
    *out = negative ? -(int64_t)size : (int64_t)size;
    return TIA_DECIMAL_FINE;
}

/* Converts a number of IEEE 754 with `fraction` bits after the point and the exponent's bias. An exponent of 31 or more
 * means a number of 2^31 or more. */
static enum tia_decimal convert(int64_t *out, bool negative, unsigned exponent, uint64_t m, unsigned fraction,
                                unsigned bias, unsigned bits)
{
    if (exponent == 2 * bias + 1 && m)
        return TIA_DECIMAL_NONE;
    if (exponent >= bias + 31)
        return TIA_DECIMAL_RANGE;
    m |= exponent ? UINT64_C(1) << fraction : 0;
    return fixed(out, negative, m, (int)(exponent ? exponent : 1) - (int)bias - (int)fraction + (int)bits);
}

enum tia_decimal tia_binary_float(int64_t *out, uint32_t ieee, unsigned bits)
{
    return convert(out, ieee >> 31, ieee >> 23 & 0xff, ieee & 0x7fffff, 23, 127, bits);
}

enum tia_decimal tia_binary_double(int64_t *out, uint64_t ieee, unsigned bits)
{
    return convert(out, ieee >> 63, (unsigned)(ieee >> 52 & 0x7ff), ieee & ((UINT64_C(1) << 52) - 1), 52, 1023, bits);
}
