/* avx512.h - AVX-512 F, BW, DQ and VL: 16 floats, 8 doubles, 8 integers. */
#ifndef TIA_SIMD_ISA_AVX512_H
#define TIA_SIMD_ISA_AVX512_H

#include <immintrin.h>
#include <stdint.h>

#include "isa.h"

#pragma GCC diagnostic ignored "-Wsign-conversion" /* intrinsics are macros at -O0 */

#define N 16
typedef __m512 F;
typedef __mmask16 M;
#define f_set(a) _mm512_set1_ps(a)
#define f_load(p) _mm512_loadu_ps(p)
#define f_store(p, a) _mm512_storeu_ps(p, a)
#define f_whole(p) _mm512_cvtepi32_ps(_mm512_cvtepu16_epi32(_mm256_loadu_si256((const void *)(p))))
#define f_iota() _mm512_set_ps(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0)
#define f_add(a, b) _mm512_add_ps(a, b)
#define f_sub(a, b) _mm512_sub_ps(a, b)
#define f_mul(a, b) _mm512_mul_ps(a, b)
#define f_min(a, b) _mm512_min_ps(a, b)
#define f_max(a, b) _mm512_max_ps(a, b)
#define f_abs(a) _mm512_abs_ps(a)
#define f_round(a) _mm512_roundscale_ps(a, 0)
#define f_fma(a, b, c) _mm512_fmadd_ps(a, b, c)
#define f_fnma(a, b, c) _mm512_fnmadd_ps(a, b, c)
#define f_gt(a, b) _mm512_cmp_ps_mask(a, b, _CMP_GT_OQ)
#define f_ge(a, b) _mm512_cmp_ps_mask(a, b, _CMP_GE_OQ)
#define m_and(a, b) ((M)((a) & (b)))
#define m_or(a, b) ((M)((a) | (b)))
#define m_not(a) _knot_mask16(a)
#define m_any(a) ((a) != 0)
#define m_bits(a) ((unsigned)(a))
#define f_sel(m, a, b) _mm512_mask_mov_ps(b, m, a)

static inline F f_rsqrt(F x)
{
    F y = _mm512_rsqrt14_ps(x), t = f_mul(f_mul(x, y), y);

    return f_mul(y, f_fnma(f_set(.5f), t, f_set(1.5f)));
}

static inline F f_inverse(F x)
{
    F y = _mm512_rcp14_ps(x);

    return f_mul(y, f_fnma(x, y, f_set(2)));
}

#define f_add_root(a, x) f_add(a, _mm512_sqrt_ps(x))
#define f_over_root(a, x) f_mul(a, f_rsqrt(x))

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    __m512i v = _mm512_cvtps_epi32(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    _mm256_storeu_si256((void *)out, _mm512_cvtepi32_epi16(v));
}

/* Appends the places of undecided pixels to the list, without a branch for each. Returns the new length. */
#define NOTE_OPEN
static inline int note_open(M sure, int at, int count, uint16_t *list, int n)
{
    const __m512i iota = _mm512_set_epi32(15, 14, 13, 12, 11, 10, 9, 8, 7, 6, 5, 4, 3, 2, 1, 0);
    __mmask16 open = (__mmask16)(~(unsigned)sure & (count < N ? (1u << count) - 1 : 0xffffu));
    __m512i places = _mm512_maskz_compress_epi32(open, _mm512_add_epi32(iota, _mm512_set1_epi32(at)));

    _mm256_storeu_si256((void *)(list + n), _mm512_cvtepi32_epi16(places));
    return n + __builtin_popcount(open);
}

/* ---- integers, for the rasteriser's runs ---- */

#define QN 8
typedef __m512i Q;
typedef __m256i W;
typedef __mmask8 K;
#define q_set(a) _mm512_set1_epi64(a)
#define q_add(a, b) _mm512_add_epi64(a, b)
#define q_sub(a, b) _mm512_sub_epi64(a, b)
#define q_clamp(a) _mm512_max_epi64(a, _mm512_setzero_si512())
#define q_gt(a, b) _mm512_cmpgt_epi64_mask(a, b)
#define q_load(p) _mm512_loadu_si512(p)
#define q_part(p, k) _mm512_maskz_loadu_epi64(k, p)
#define q_store(p, k, a) _mm512_mask_storeu_epi64(p, k, a)
#define w_set(a) _mm256_set1_epi32((int)(a))
#define w_add(a, b) _mm256_add_epi32(a, b)
#define w_eq(a, b) _mm256_cmpeq_epi32_mask(a, b)
#define w_load(p) _mm256_loadu_si256((const void *)(p))
#define w_part(p, k) _mm256_maskz_loadu_epi32(k, p)
#define w_store(p, k, a) _mm256_mask_storeu_epi32(p, k, a)
#define k_all() ((K)255)
#define k_first(n) ((K)((1u << (n)) - 1))
#define k_and(a, b) ((K)((a) & (b)))
#define k_or(a, b) ((K)((a) | (b)))
#define k_minus(a, b) ((K)((a) & ~(b)))
#define k_any(a) ((a) != 0)
#define k_bits(a) ((unsigned)(a))
#define k_of(bits) ((K)(bits))

static inline Q q_ramp(uint64_t z, uint64_t step)
{
    __m512i lane = _mm512_set_epi64(7, 6, 5, 4, 3, 2, 1, 0);

    return q_add(q_set((int64_t)z), _mm512_mullo_epi64(lane, q_set((int64_t)step)));
}

/* ---- doubles, for rays ---- */

#define LANES 8
typedef __m512d vd;
typedef int64_t vi __attribute__((vector_size(64)));
typedef __mmask8 vm;
#define vset(x) _mm512_set1_pd(x)
#define vsqrt(a) _mm512_sqrt_pd(a)
#define vabs(a) _mm512_abs_pd(a)
#define vmin(a, b) _mm512_min_pd(a, b)
#define vmax(a, b) _mm512_max_pd(a, b)
#define vlt(a, b) _mm512_cmp_pd_mask(a, b, _CMP_LT_OQ)
#define vle(a, b) _mm512_cmp_pd_mask(a, b, _CMP_LE_OQ)
#define vsel(m, a, b) _mm512_mask_blend_pd(m, b, a)
#define mand(a, b) ((vm)((a) & (b)))
#define mor(a, b) ((vm)((a) | (b)))
#define mnot(a) _knot_mask8(a)
#define mbits(m) ((unsigned)(m))
#define mof(bits) ((vm)(bits))
#define VRSQRT(a) d_rsqrt(a)
#define VBYTES(x) _mm512_cvtepi32_pd(_mm256_cvtepu8_epi32(_mm_cvtsi64_si128((int64_t)(x))))
#define WORDS_GE(p, a, b)                                                                                              \
    ((unsigned)_mm256_cmpge_epu32_mask(_mm256_broadcastsi128_si256(_mm_loadu_si128((const void *)(p))),                \
                                       _mm256_set_m128i(_mm_set1_epi32((int)(b)), _mm_set1_epi32((int)(a)))))
#define VPACK(a, lanes) _mm512_maskz_compress_pd(mof(lanes), a)
#define OF16(table, index)                                                                                             \
    (vu) _mm256_permutex2var_epi32(_mm256_loadu_si256((const void *)(table)), (__m256i)(index),                        \
                                   _mm256_loadu_si256((const void *)((table) + 8)))

/* From an estimate within 2^-14, two Newton steps. */
LANE_OP vd d_rsqrt(vd x)
{
    vd y = _mm512_rsqrt14_pd(x), half = x * vset(.5);

    y = y * (vset(1.5) - half * y * y);
    return y * (vset(1.5) - half * y * y);
}

typedef __m256 vb;
#define vb_set(x) _mm256_set1_ps(x)
#define vb_min(a, b) _mm256_min_ps(a, b)
#define vb_max(a, b) _mm256_max_ps(a, b)
#define vb_le(a, b) ((unsigned)_mm256_cmp_ps_mask(a, b, _CMP_LE_OQ))

typedef __m512 vp;
#define vp_set(x) _mm512_set1_ps(x)
#define vp_load(p) _mm512_castpd_ps(_mm512_set1_pd(two_floats(p)))
#define vp_min(a, b) _mm512_min_ps(a, b)
#define vp_max(a, b) _mm512_max_ps(a, b)
#define vp_le(a, b) ((unsigned)_mm512_cmp_ps_mask(a, b, _CMP_LE_OQ))
#define vp_swap(a) _mm512_permute_ps(a, 0xb1)

LANE_OP vp vp_of(vd a)
{
    return _mm512_permutexvar_ps(_mm512_set_epi32(7, 7, 6, 6, 5, 5, 4, 4, 3, 3, 2, 2, 1, 1, 0, 0),
                                 _mm512_castps256_ps512(_mm512_cvtpd_ps(a)));
}

#endif
