/* neon32.h - 4 floats: NEON of ARMv7, which has neither roots nor quotients, and flushes numbers below 2^-126 to 0.
 *
 * So sqrt(x) is computed as x times 1/sqrt(x), whose error is SIMD_ROOT (span/proved.h). The flushing is harmless.
 * Where a bound becomes 0, the quantity compared with it is either 0, which leaves the pixel undecided, or at least
 * 2^-126, which is more than the bound. */
#ifndef TIA_SIMD_ISA_NEON32_H
#define TIA_SIMD_ISA_NEON32_H

#include <arm_neon.h>
#include <stdint.h>

#include "isa.h"

#define N 4
typedef float32x4_t F;
typedef uint32x4_t M;

#define f_round(a) vsubq_f32(vaddq_f32(a, vdupq_n_f32(12582912.f)), vdupq_n_f32(12582912.f)) /* 1.5 2^23 */
#define f_fma(a, b, c) vmlaq_f32(c, a, b)
#define f_fnma(a, b, c) vmlsq_f32(c, a, b)
#define f_add_root(a, x) f_fma(x, f_rsqrt(x), a)

static inline unsigned m_bits(M m)
{
    static const uint32_t bit[4] = {1, 2, 4, 8};
    uint32x4_t set = vandq_u32(m, vld1q_u32(bit));
    uint32x2_t half = vadd_u32(vget_low_u32(set), vget_high_u32(set));

    return vget_lane_u32(vpadd_u32(half, half), 0);
}

#define m_any(a) (m_bits(a) != 0)

#include "neon_both.h"

#include "one.h" /* doubles by the floating-point unit, as this vector unit has none */

#endif
