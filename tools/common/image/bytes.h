/* bytes.h - numbers in files, the low byte first. */
#ifndef TOOLS_IMAGE_BYTES_H
#define TOOLS_IMAGE_BYTES_H

#include <stdint.h>
#include <string.h>

/* Writes the lower `count` bytes of a number, at most 8. Returns the byte behind them. */
static inline unsigned char *put_bytes(unsigned char *at, uint64_t value, unsigned count)
{
    for (unsigned i = 0; i < count; i++)
        *at++ = (unsigned char)(value >> 8 * i & 255u);
    return at;
}

/* Writes an IEEE 754 number of 32 bits. Returns the byte behind it. */
static inline unsigned char *put_float_bytes(unsigned char *at, float value)
{
    uint32_t bits;

    memcpy(&bits, &value, sizeof bits);
    return put_bytes(at, bits, sizeof bits);
}

#endif
