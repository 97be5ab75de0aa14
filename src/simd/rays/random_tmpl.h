/* random_tmpl.h - random numbers of samples, as in samples/sobol.h, for several samples side by side.
 *
 * Parameters: the doubles and 64-bit integers of isa/isa.h, OF16() where it is defined. Defines: quads_of(),
 * quads_number(), vu_number(), vu_unit(), vu_load(), vu_store(), struct quads. */
#ifndef TIA_SIMD_RAYS_RANDOM_TMPL_H
#define TIA_SIMD_RAYS_RANDOM_TMPL_H

#include "samples/sobol.h"
#include "vector_tmpl.h"

#if LANES > 1
typedef uint32_t vu __attribute__((vector_size(4 * LANES)));
#else
typedef uint32_t vu;
#endif

#define SOBOL_WORD vu
#define SOBOL_STEP(name) lanes_##name
#include "samples/sobol_steps.h"
#undef SOBOL_WORD
#undef SOBOL_STEP

LANE_OP vu vu_load(const uint32_t *p)
{
    vu u;

    __builtin_memcpy(&u, p, sizeof u);
    return u;
}

LANE_OP void vu_store(uint32_t *p, vu u)
{
    __builtin_memcpy(p, &u, sizeof u);
}

LANE_OP vu vu_table(vu index, unsigned dimension)
{
#ifdef OF16
    vu sum = {0};

    for (unsigned i = 0; i < 8; i++)
        sum ^= OF16(tia_sobol_tables[dimension - 2][i], index >> (4 * i));
    return sum;
#else
    uint32_t at[LANES];

    vu_store(at, index);
    for (int k = 0; k < LANES; k++)
        at[k] = sobol_table(at[k], dimension);
    return vu_load(at);
#endif
}

/* A quad of each lane's sample: a seed for scrambling, and the sample's index in the shuffled sequence. */
struct quads {
    vu hash, at;
};

LANE_OP struct quads quads_of(vu seed, vu index, vu quad)
{
    vu hash = lanes_hash2(seed, quad);

    return (struct quads){hash, lanes_reverse(lanes_scramble(lanes_reverse(index), hash))};
}

/* Returns the number of dimension i, 0..3, see sampler_pair(). */
LANE_OP vu quads_number(const struct quads *q, unsigned i)
{
    vu none = {0}, point = i == 0 ? q->at : i == 1 ? lanes_pascal(q->at) : vu_table(q->at, i);

    return lanes_reverse(lanes_scramble(point, lanes_hash2(q->hash, none + i)));
}

LANE_OP vd vu_number(vu u)
{
#if LANES > 1
    typedef double pure __attribute__((vector_size(8 * LANES)));
    pure given = __builtin_convertvector(u, pure);
    vd d;

    __builtin_memcpy(&d, &given, sizeof d);
#else
    vd d = (double)u;
#endif
    return d;
}

/* Returns (u + 1/2)/2^32, which is exact. */
LANE_OP vd vu_unit(vu u)
{
    return (vu_number(u) + vset(0.5)) * vset(SURE_Q32);
}

#endif
