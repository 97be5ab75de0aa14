/* sse41.h - SSE4.1: 4 floats, 2 doubles. */
#ifndef TIA_SIMD_ISA_SSE41_H
#define TIA_SIMD_ISA_SSE41_H

#include <smmintrin.h>
#include <stdint.h>

#include "isa.h"

#define N 4
typedef __m128 F;
typedef __m128 M;
#define f_set(a) _mm_set1_ps(a)
#define f_load(p) _mm_loadu_ps(p)
#define f_store(p, a) _mm_storeu_ps(p, a)
#define f_whole(p) _mm_cvtepi32_ps(_mm_cvtepu16_epi32(_mm_loadl_epi64((const void *)(p))))
#define f_iota() _mm_set_ps(3, 2, 1, 0)
#define f_add(a, b) _mm_add_ps(a, b)
#define f_sub(a, b) _mm_sub_ps(a, b)
#define f_mul(a, b) _mm_mul_ps(a, b)
#define f_min(a, b) _mm_min_ps(a, b)
#define f_max(a, b) _mm_max_ps(a, b)
#define f_abs(a) _mm_andnot_ps(f_set(-0.f), a)
#define f_round(a) _mm_round_ps(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define f_fma(a, b, c) _mm_add_ps(_mm_mul_ps(a, b), c)
#define f_fnma(a, b, c) _mm_sub_ps(c, _mm_mul_ps(a, b))
#define f_gt(a, b) _mm_cmpgt_ps(a, b)
#define f_ge(a, b) _mm_cmpge_ps(a, b)
#define m_and(a, b) _mm_and_ps(a, b)
#define m_or(a, b) _mm_or_ps(a, b)
#define m_not(a) _mm_xor_ps(a, _mm_castsi128_ps(_mm_set1_epi32(-1)))
#define m_bits(a) ((unsigned)_mm_movemask_ps(a))
#define m_any(a) (m_bits(a) != 0)
#define f_sel(m, a, b) _mm_blendv_ps(b, a, m)

static inline F f_rsqrt(F x)
{
    F y = _mm_rsqrt_ps(x), t = f_mul(f_mul(x, y), y);

    return f_mul(y, f_fnma(f_set(.5f), t, f_set(1.5f)));
}

static inline F f_inverse(F x)
{
    F y = _mm_rcp_ps(x);

    return f_mul(y, f_fnma(x, y, f_set(2)));
}

#define f_add_root(a, x) f_add(a, _mm_sqrt_ps(x))
#define f_over_root(a, x) _mm_div_ps(a, _mm_sqrt_ps(x))

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    __m128i v = _mm_cvtps_epi32(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    _mm_storel_epi64((void *)out, _mm_packus_epi32(v, v));
}

/* ---- doubles, for rays ---- */

#define LANES 2
typedef __m128d vd;
typedef int64_t vi __attribute__((vector_size(16)));
typedef __m128d vm;
#define VBYTES(x) _mm_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_cvtsi32_si128((int)(x))))
#define vset(x) _mm_set1_pd(x)
#define vsqrt(a) _mm_sqrt_pd(a)
#define vabs(a) _mm_andnot_pd(_mm_set1_pd(-0.0), a)
#define vmin(a, b) _mm_min_pd(a, b)
#define vmax(a, b) _mm_max_pd(a, b)
#define vlt(a, b) _mm_cmplt_pd(a, b)
#define vle(a, b) _mm_cmple_pd(a, b)
#define vsel(m, a, b) _mm_blendv_pd(b, a, m)
#define mand(a, b) _mm_and_pd(a, b)
#define mor(a, b) _mm_or_pd(a, b)
#define mnot(a) _mm_xor_pd(a, _mm_castsi128_pd(_mm_set1_epi32(-1)))
#define mbits(m) ((unsigned)_mm_movemask_pd(m))

LANE_OP vm mof(unsigned bits)
{
    return _mm_castsi128_pd(_mm_set_epi64x(-(int64_t)(bits >> 1 & 1), -(int64_t)(bits & 1)));
}

typedef __m128 vp;
#define vp_set(x) _mm_set1_ps(x)
#define vp_of(a) _mm_unpacklo_ps(_mm_cvtpd_ps(a), _mm_cvtpd_ps(a))
#define vp_load(p) _mm_castpd_ps(_mm_set1_pd(two_floats(p)))
#define vp_min(a, b) _mm_min_ps(a, b)
#define vp_max(a, b) _mm_max_ps(a, b)
#define vp_le(a, b) ((unsigned)_mm_movemask_ps(_mm_cmple_ps(a, b)))
#define vp_swap(a) _mm_shuffle_ps(a, a, 0xb1)

#endif
