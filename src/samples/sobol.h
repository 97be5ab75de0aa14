/* sobol.h - the random numbers of a pixel's samples: Owen-scrambled Sobol points, in 32-bit integers.
 *
 * A number is a function of the pixel, the sample and the dimension alone, so samples may be drawn in any order, on any
 * machine. Dimensions come in quads: the samples' points in a quad are spread over the four-dimensional cube as evenly
 * as Sobol points; different quads are independent. Each quad shuffles the order of the samples, and scrambles each of
 * its dimensions by Owen's method: a hash of the higher bits decides whether a bit is flipped (Laine and Karras,
 * "Stratified sampling for stochastic transparency", 2011; Burley, "Practical hash-based Owen scrambling", 2020;
 * constants by Vegdahl).
 *
 * The numbers are u in 0..2^32 - 1 and stand for (u + 1/2)/2^32. */
#ifndef TIA_SAMPLES_SOBOL_H
#define TIA_SAMPLES_SOBOL_H

#include <stdint.h>

/* Bit-reversed points of the Sobol sequence's third and fourth dimension: [dimension - 2][n][v] for the value v of bits
 * 4n..4n+3 of the index. */
extern const uint32_t tia_sobol_tables[2][8][16];

#define SOBOL_WORD uint32_t
#define SOBOL_STEP(name) sobol_##name
#include "sobol_steps.h"
#undef SOBOL_WORD
#undef SOBOL_STEP

/* Returns the bit-reversed point `index` of dimension 2 or 3. */
static inline uint32_t sobol_table(uint32_t index, unsigned dimension)
{
    uint32_t sum = 0;

    for (unsigned i = 0; i < 8; i++)
        sum ^= tia_sobol_tables[dimension - 2][i][index >> (4 * i) & 15];
    return sum;
}

/* Returns the bit-reversed point `index` of dimension 0..3. Dimension 0 is the radical inverse; the other dimensions
 * have the matrices of Joe and Kuo (2008). */
static inline uint32_t sobol_reversed(uint32_t index, unsigned dimension)
{
    return dimension == 0 ? index : dimension == 1 ? sobol_pascal(index) : sobol_table(index, dimension);
}

struct sampler {
    uint32_t seed, index; /* the pixel's seed; the sample's number */
};

/* Returns the sampler of sample `index` of pixel (x, y). */
static inline struct sampler sampler_of(uint32_t seed, int x, int y, uint32_t index)
{
    return (struct sampler){sobol_hash2(sobol_hash2(seed, (uint32_t)y), (uint32_t)x), index};
}

/* A quad of a sample: the seed of its dimensions' scrambling, and the sample's index in its order. */
struct sampler_quad {
    uint32_t hash, index;
};

static inline struct sampler_quad sampler_quad(const struct sampler *sampler, uint32_t quad)
{
    uint32_t hash = sobol_hash2(sampler->seed, quad);

    return (struct sampler_quad){hash, sobol_reverse(sobol_scramble(sobol_reverse(sampler->index), hash))};
}

/* Returns the number of a quad's dimension, 0..3. */
static inline uint32_t sampler_number(const struct sampler_quad *quad, unsigned dimension)
{
    uint32_t point = sobol_reversed(quad->index, dimension);

    return sobol_reverse(sobol_scramble(point, sobol_hash2(quad->hash, dimension)));
}

/* Writes the sample's numbers in dimensions `first` and `first` + 1 of a quad. */
static inline void sampler_pair(const struct sampler *sampler, uint32_t quad, unsigned first, uint32_t u[2])
{
    const struct sampler_quad of = sampler_quad(sampler, quad);

    u[0] = sampler_number(&of, first);
    u[1] = sampler_number(&of, first + 1);
}

#endif
