#include "crc_join.h"

/* A CRC is a polynomial over GF(2) modulo P, with the highest power in bit 0. Appending n bytes multiplies the
 * polynomial of the data by x^(8n), so the CRC of the whole is (first * x^(8n) + second) mod P. (The initial values and
 * final inversions cancel.) */
#define POLYNOMIAL 0xedb88320u
#define ONE 0x80000000u

static uint32_t multiply(uint32_t a, uint32_t b)
{
    uint32_t product = 0;
    for (uint32_t power = ONE; power != 0; power >>= 1) {
        if (a & power)
            product ^= b;
        b = (b >> 1) ^ (b & 1u ? POLYNOMIAL : 0u);
    }
    return product;
}

uint32_t crc_join(uint32_t first, uint32_t second, uint64_t bytes)
{
    uint32_t factor = ONE, square = ONE >> 8; /* x^8, then repeated squares */
    for (; bytes != 0; bytes >>= 1) {
        if (bytes & 1u)
            factor = multiply(factor, square);
        square = multiply(square, square);
    }
    return multiply(first, factor) ^ second;
}
