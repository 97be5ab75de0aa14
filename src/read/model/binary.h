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

/* Convert an IEEE number, given by its bits, to a number times 2^bits; bits is in 0..32. The number must be below 2^31
 * in size; TIA_DECIMAL_RANGE also for infinities, TIA_DECIMAL_NONE for NaN. */
enum tia_decimal tia_binary_float(int64_t *out, uint32_t ieee, unsigned bits);
enum tia_decimal tia_binary_double(int64_t *out, uint64_t ieee, unsigned bits);

#endif
