/* neon64.h - 4 floats: NEON of AArch64. */
#ifndef TIA_SIMD_NEON64_H
#define TIA_SIMD_NEON64_H

#include <arm_neon.h>
#include <stdint.h>

#define N 4
typedef float32x4_t F;
typedef uint32x4_t M;

#define f_round(a) vrndnq_f32(a)
#define f_fma(a, b, c) vfmaq_f32(c, a, b)
#define f_fnma(a, b, c) vfmsq_f32(c, a, b)
#define f_add_root(a, x) f_add(a, vsqrtq_f32(x))
#define m_any(a) (vmaxvq_u32(a) != 0)

static inline unsigned m_bits(M m)
{
    static const uint32_t bit[4] = {1, 2, 4, 8};

    return vaddvq_u32(vandq_u32(m, vld1q_u32(bit)));
}

#include "neon_both.h"

#endif
