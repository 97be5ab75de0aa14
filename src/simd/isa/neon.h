/* neon.h - NEON of AArch64: 4 floats, 2 doubles. */
#ifndef TIA_SIMD_ISA_NEON_H
#define TIA_SIMD_ISA_NEON_H

#include <arm_neon.h>
#include <stdint.h>

#include "isa.h"

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

/* ---- doubles, for rays ---- */

#define LANES 2
typedef float64x2_t vd;
typedef int64_t vi __attribute__((vector_size(16)));
typedef uint64x2_t vm;
#define vset(x) vdupq_n_f64(x)
#define vsqrt(a) vsqrtq_f64(a)
#define vabs(a) vabsq_f64(a)
#define vmin(a, b) vminq_f64(a, b)
#define vmax(a, b) vmaxq_f64(a, b)
#define vlt(a, b) vcltq_f64(a, b)
#define vle(a, b) vcleq_f64(a, b)
#define vsel(m, a, b) vbslq_f64(m, a, b)
#define mand(a, b) vandq_u64(a, b)
#define mor(a, b) vorrq_u64(a, b)
#define mnot(a) veorq_u64(a, vdupq_n_u64(UINT64_MAX))
#define mbits(m) ((unsigned)((vgetq_lane_u64(m, 0) & 1) | (vgetq_lane_u64(m, 1) & 2)))

LANE_OP vm mof(unsigned bits)
{
    return vcombine_u64(vcreate_u64(0 - (uint64_t)(bits & 1)), vcreate_u64(0 - (uint64_t)(bits >> 1 & 1)));
}

typedef float32x4_t vp;
#define vp_set(x) vdupq_n_f32(x)
#define vp_load(p) vreinterpretq_f32_f64(vdupq_n_f64(two_floats(p)))
#define vp_min(a, b) vminq_f32(a, b)
#define vp_max(a, b) vmaxq_f32(a, b)
#define vp_swap(a) vrev64q_f32(a)

LANE_OP unsigned vp_le(vp a, vp b)
{
    static const uint32_t bit[4] = {1, 2, 4, 8};

    return vaddvq_u32(vandq_u32(vcleq_f32(a, b), vld1q_u32(bit)));
}

LANE_OP vp vp_of(vd a)
{
    float32x2_t f = vcvt_f32_f64(a);

    return vcombine_f32(vdup_lane_f32(f, 0), vdup_lane_f32(f, 1));
}

#endif
