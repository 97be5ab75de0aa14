/* sobol.h - the numbers that a pixel's samples draw: Owen-scrambled Sobol points, in 32-bit integers.
 *
 * A number is a function of the pixel, the sample and the dimension alone, so samples may be drawn in any order, on any
 * machine. Dimensions come in quads: four of one sample, taken together, are spread over the four-dimensional cube as
 * evenly as Sobol points are; different quads are independent. Each quad shuffles the samples' order and scrambles each
 * of its dimensions by Owen's method, as a hash of the bits above each bit (Laine and Karras, "Stratified sampling for
 * stochastic transparency", 2011; Burley, "Practical hash-based Owen scrambling", 2020; constants by Vegdahl).
 *
 * The numbers are u in 0..2^32 - 1 and stand for (u + 1/2)/2^32. */
#ifndef TIA_SAMPLING_SOBOL_H
#define TIA_SAMPLING_SOBOL_H

#include <stdint.h>

/* Bit-reversed points of the Sobol sequence's third and fourth dimension, for each four bits of the index. */
extern const uint32_t tia_sobol_tables[2][8][16];

static inline uint32_t sobol_hash(uint32_t x)
{
    x = (x ^ x >> 16) * UINT32_C(0x21f0aaad);
    x = (x ^ x >> 15) * UINT32_C(0xd35a2d97);
    return x ^ x >> 15;
}

static inline uint32_t sobol_hash2(uint32_t a, uint32_t b)
{
    return sobol_hash(a ^ sobol_hash(b + UINT32_C(0x9e3779b9)));
}

static inline uint32_t sobol_reverse(uint32_t x)
{
    x = x >> 16 | x << 16;
    x = (x >> 8 & 0x00ff00ff) | (x & 0x00ff00ff) << 8;
    x = (x >> 4 & 0x0f0f0f0f) | (x & 0x0f0f0f0f) << 4;
    x = (x >> 2 & 0x33333333) | (x & 0x33333333) << 2;
    return (x >> 1 & 0x55555555) | (x & 0x55555555) << 1;
}

/* Owen's scrambling of a number whose bits are reversed: no bit depends on a higher one. */
static inline uint32_t sobol_scramble(uint32_t x, uint32_t seed)
{
    x ^= x * UINT32_C(0x3d20adea);
    x += seed;
    x *= seed >> 16 | 1;
    x ^= x * UINT32_C(0x05526c56);
    x ^= x * UINT32_C(0x53a22864);
    return x;
}

/* Point `index` of a dimension 0..3, its bits reversed. The first dimension is the radical inverse; the second's matrix
 * is Pascal's triangle modulo 2, a fivefold tensor product; the others' are those of Joe and Kuo (2008). */
static inline uint32_t sobol_reversed(uint32_t index, unsigned dimension)
{
    if (dimension == 1) {
        index ^= index >> 1 & 0x55555555;
        index ^= index >> 2 & 0x33333333;
        index ^= index >> 4 & 0x0f0f0f0f;
        index ^= index >> 8 & 0x00ff00ff;
        return index ^ index >> 16;
    }
    if (dimension == 0)
        return index;
    uint32_t sum = 0;
    for (unsigned i = 0; i < 8; i++)
        sum ^= tia_sobol_tables[dimension - 2][i][index >> (4 * i) & 15];
    return sum;
}

struct sampler {
    uint32_t seed, index; /* of the pixel; the sample */
};

/* Of sample `index` of pixel (x, y). */
static inline struct sampler sampler_of(uint32_t seed, int x, int y, uint32_t index)
{
    return (struct sampler){sobol_hash2(sobol_hash2(seed, (uint32_t)y), (uint32_t)x), index};
}

/* Two numbers of a quad: those of its dimensions `first` and `first` + 1. */
static inline void sampler_pair(const struct sampler *sampler, uint32_t quad, unsigned first, uint32_t u[2])
{
    uint32_t hash = sobol_hash2(sampler->seed, quad);
    uint32_t index = sobol_reverse(sobol_scramble(sobol_reverse(sampler->index), hash));

    for (unsigned i = 0; i < 2; i++)
        u[i] = sobol_reverse(sobol_scramble(sobol_reversed(index, first + i), sobol_hash2(hash, first + i)));
}

#endif
