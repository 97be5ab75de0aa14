/* binary.h - numbers in binary files, converted to fixed point as decimal ones are: rounded to nearest, ties away from
 * 0. */
#ifndef TIA_READ_MODEL_BINARY_H
#define TIA_READ_MODEL_BINARY_H

#include "read/text/text_lines.h"

/* Returns the unsigned number in `size` bytes, 1 to 8. */
static inline uint64_t tia_binary_unsigned(const char *at, unsigned size, bool big_endian)
{
    uint64_t value = 0;

    for (unsigned i = 0; i < size; i++)
        value = value << 8 | (unsigned char)at[big_endian ? i : size - 1 - i];
    return value;
}

/* Returns the unsigned number in 4 bytes, little endian. */
static inline uint32_t tia_binary_little(const char *at)
{
    const unsigned char *byte = (const unsigned char *)at;

    return byte[0] | (uint32_t)byte[1] << 8 | (uint32_t)byte[2] << 16 | (uint32_t)byte[3] << 24;
}

/* Converts (-1)^negative m 2^exponent, m < 2^53. */
static inline int64_t tia_binary_fixed(bool negative, uint64_t m, int exponent)
{
    uint64_t size;

    if (exponent >= 0)
        size = m << exponent;
    else
        size = exponent < -54 ? 0 : (m + (UINT64_C(1) << (-exponent - 1))) >> -exponent;
    return negative ? -(int64_t)size : (int64_t)size;
}

/* Converts a number of IEEE 754 with `fraction` bits after the point and the exponent's bias. An exponent of 31 or more
 * means a number of 2^31 or more. */
static inline enum tia_decimal tia_binary_ieee(int64_t *out, bool negative, unsigned exponent, uint64_t m,
                                               unsigned fraction, unsigned bias, unsigned bits)
{
    if (exponent == 2 * bias + 1 && m)
        return TIA_DECIMAL_NONE;
    if (exponent >= bias + 31)
        return TIA_DECIMAL_RANGE;
    m |= exponent ? UINT64_C(1) << fraction : 0;
    *out = tia_binary_fixed(negative, m, (int)(exponent ? exponent : 1) - (int)bias - (int)fraction + (int)bits);
    return TIA_DECIMAL_FINE;
}

/* Convert an IEEE number, given by its bits, to a number times 2^bits; bits is in 0..32. The number must be below 2^31
 * in size; TIA_DECIMAL_RANGE also for infinities, TIA_DECIMAL_NONE for NaN. */
static inline enum tia_decimal tia_binary_float(int64_t *out, uint32_t ieee, unsigned bits)
{
    return tia_binary_ieee(out, ieee >> 31, ieee >> 23 & 0xff, ieee & 0x7fffff, 23, 127, bits);
}

static inline enum tia_decimal tia_binary_double(int64_t *out, uint64_t ieee, unsigned bits)
{
    return tia_binary_ieee(out, ieee >> 63, (unsigned)(ieee >> 52 & 0x7ff), ieee & ((UINT64_C(1) << 52) - 1), 52, 1023,
                           bits);
}

#endif
