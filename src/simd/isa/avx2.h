/* avx2.h - AVX2 and FMA: 8 floats, 4 doubles, 4 integers. */
#ifndef TIA_SIMD_ISA_AVX2_H
#define TIA_SIMD_ISA_AVX2_H

#include <immintrin.h>
#include <stdint.h>

#include "isa.h"

#define N 8
typedef __m256 F;
typedef __m256 M;
#define f_set(a) _mm256_set1_ps(a)
#define f_load(p) _mm256_loadu_ps(p)
#define f_store(p, a) _mm256_storeu_ps(p, a)
#define f_whole(p) _mm256_cvtepi32_ps(_mm256_cvtepu16_epi32(_mm_loadu_si128((const void *)(p))))
#define f_iota() _mm256_set_ps(7, 6, 5, 4, 3, 2, 1, 0)
#define f_add(a, b) _mm256_add_ps(a, b)
#define f_sub(a, b) _mm256_sub_ps(a, b)
#define f_mul(a, b) _mm256_mul_ps(a, b)
#define f_min(a, b) _mm256_min_ps(a, b)
#define f_max(a, b) _mm256_max_ps(a, b)
#define f_abs(a) _mm256_andnot_ps(f_set(-0.f), a)
#define f_round(a) _mm256_round_ps(a, _MM_FROUND_TO_NEAREST_INT | _MM_FROUND_NO_EXC)
#define f_fma(a, b, c) _mm256_fmadd_ps(a, b, c)
#define f_fnma(a, b, c) _mm256_fnmadd_ps(a, b, c)
#define f_gt(a, b) _mm256_cmp_ps(a, b, _CMP_GT_OQ)
#define f_ge(a, b) _mm256_cmp_ps(a, b, _CMP_GE_OQ)
#define m_and(a, b) _mm256_and_ps(a, b)
#define m_or(a, b) _mm256_or_ps(a, b)
#define m_not(a) _mm256_xor_ps(a, _mm256_castsi256_ps(_mm256_set1_epi32(-1)))
#define m_bits(a) ((unsigned)_mm256_movemask_ps(a))
#define m_any(a) (m_bits(a) != 0)
#define f_sel(m, a, b) _mm256_blendv_ps(b, a, m)

static inline F f_rsqrt(F x)
{
    F y = _mm256_rsqrt_ps(x), t = f_mul(f_mul(x, y), y);

    return f_mul(y, f_fnma(f_set(.5f), t, f_set(1.5f)));
}

static inline F f_inverse(F x)
{
    F y = _mm256_rcp_ps(x);

    return f_mul(y, f_fnma(x, y, f_set(2)));
}

#define f_add_root(a, x) f_add(a, _mm256_sqrt_ps(x))
#define f_over_root(a, x) f_mul(a, f_rsqrt(x))

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    __m256i v = _mm256_cvtps_epi32(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    _mm_storeu_si128((void *)out, _mm_packus_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1)));
}

/* ---- integers, for the rasteriser's runs ---- */

#define QN 4
typedef __m256i Q;
typedef __m128i W;
typedef __m256i K; /* a set of pixels: all bits of its members are set */
#define q_set(a) _mm256_set1_epi64x(a)
#define q_add(a, b) _mm256_add_epi64(a, b)
#define q_sub(a, b) _mm256_sub_epi64(a, b)
#define q_clamp(a) _mm256_andnot_si256(q_gt(_mm256_setzero_si256(), a), a)
#define q_gt(a, b) _mm256_cmpgt_epi64(a, b)
#define q_load(p) _mm256_loadu_si256((const void *)(p))
#define q_part(p, k) _mm256_maskload_epi64((const long long *)(p), k)
#define q_store(p, k, a) _mm256_maskstore_epi64((long long *)(p), k, a)
#define w_set(a) _mm_set1_epi32((int)(a))
#define w_add(a, b) _mm_add_epi32(a, b)
#define w_eq(a, b) _mm256_cvtepi32_epi64(_mm_cmpeq_epi32(a, b))
#define w_load(p) _mm_loadu_si128((const void *)(p))
#define w_part(p, k) _mm_maskload_epi32((const int *)(p), k_half(k))
#define w_store(p, k, a) _mm_maskstore_epi32((int *)(p), k_half(k), a)
#define k_all() _mm256_set1_epi64x(-1)
#define k_first(n) q_gt(q_set(n), _mm256_set_epi64x(3, 2, 1, 0))
#define k_and(a, b) _mm256_and_si256(a, b)
#define k_or(a, b) _mm256_or_si256(a, b)
#define k_minus(a, b) _mm256_andnot_si256(b, a)
#define k_any(a) (!_mm256_testz_si256(a, a))
#define k_bits(a) ((unsigned)_mm256_movemask_pd(_mm256_castsi256_pd(a)))

static inline W k_half(K k)
{
    __m128 low = _mm_castsi128_ps(_mm256_castsi256_si128(k)), high = _mm_castsi128_ps(_mm256_extracti128_si256(k, 1));

    return _mm_castps_si128(_mm_shuffle_ps(low, high, _MM_SHUFFLE(2, 0, 2, 0)));
}

static inline K k_of(unsigned bits)
{
    __m256i bit = _mm256_set_epi64x(8, 4, 2, 1);

    return _mm256_cmpeq_epi64(_mm256_and_si256(q_set(bits), bit), bit);
}

static inline Q q_ramp(uint64_t z, uint64_t step)
{
    return _mm256_set_epi64x((int64_t)(z + 3 * step), (int64_t)(z + 2 * step), (int64_t)(z + step), (int64_t)z);
}

/* ---- doubles, for rays ---- */

#define LANES 4
typedef __m256d vd;
typedef int64_t vi __attribute__((vector_size(32)));
typedef __m256d vm;
#define VBYTES(x) _mm256_cvtepi32_pd(_mm_cvtepu8_epi32(_mm_cvtsi32_si128((int)(x))))
#define vset(x) _mm256_set1_pd(x)
#define vsqrt(a) _mm256_sqrt_pd(a)
#define vabs(a) _mm256_andnot_pd(_mm256_set1_pd(-0.0), a)
#define vmin(a, b) _mm256_min_pd(a, b)
#define vmax(a, b) _mm256_max_pd(a, b)
#define vlt(a, b) _mm256_cmp_pd(a, b, _CMP_LT_OQ)
#define vle(a, b) _mm256_cmp_pd(a, b, _CMP_LE_OQ)
#define vsel(m, a, b) _mm256_blendv_pd(b, a, m)
#define mand(a, b) _mm256_and_pd(a, b)
#define mor(a, b) _mm256_or_pd(a, b)
#define mnot(a) _mm256_xor_pd(a, _mm256_castsi256_pd(_mm256_set1_epi64x(-1)))
#define mbits(m) ((unsigned)_mm256_movemask_pd(m))

LANE_OP vm mof(unsigned bits)
{
    const __m256i bit = _mm256_set_epi64x(8, 4, 2, 1);

    return _mm256_castsi256_pd(_mm256_cmpeq_epi64(_mm256_and_si256(_mm256_set1_epi64x(bits), bit), bit));
}

#define WORDS_GE(p, a, b) words_ge(_mm_loadu_si128((const void *)(p)), (int)(a), (int)(b))
LANE_OP unsigned words_ge(__m128i four, int a, int b)
{
    __m256i both = _mm256_broadcastsi128_si256(four), least = _mm256_set_m128i(_mm_set1_epi32(b), _mm_set1_epi32(a));

    return (unsigned)_mm256_movemask_ps(_mm256_castsi256_ps(_mm256_cmpeq_epi32(_mm256_max_epu32(both, least), both)));
}

#define VPACK(a, lanes) packed_lanes(a, lanes)
LANE_OP vd packed_lanes(vd a, unsigned lanes)
{
    /* For each set of lanes the places of their halves, a byte each. */
    static const uint64_t halves[16] = {
        0,     0x100,     0x302,     0x3020100,     0x504,     0x5040100,     0x5040302,     0x50403020100,
        0x706, 0x7060100, 0x7060302, 0x70603020100, 0x7060504, 0x70605040100, 0x70605040302, 0x706050403020100};
    __m256i index = _mm256_cvtepu8_epi32(_mm_set1_epi64x((int64_t)halves[lanes]));

    return _mm256_castps_pd(_mm256_permutevar8x32_ps(_mm256_castpd_ps(a), index));
}

typedef __m256 vp;
#define vp_set(x) _mm256_set1_ps(x)
#define vp_load(p) _mm256_castpd_ps(_mm256_set1_pd(two_floats(p)))
#define vp_min(a, b) _mm256_min_ps(a, b)
#define vp_max(a, b) _mm256_max_ps(a, b)
#define vp_le(a, b) ((unsigned)_mm256_movemask_ps(_mm256_cmp_ps(a, b, _CMP_LE_OQ)))
#define vp_swap(a) _mm256_permute_ps(a, 0xb1)

LANE_OP vp vp_of(vd a)
{
    return _mm256_permutevar8x32_ps(_mm256_castps128_ps256(_mm256_cvtpd_ps(a)),
                                    _mm256_set_epi32(3, 3, 2, 2, 1, 1, 0, 0));
}

#endif
