/* avx2.h - 8 floats: AVX2 and FMA. See kernel.h for what each operation is. */
#ifndef TIA_SIMD_AVX2_H
#define TIA_SIMD_AVX2_H

#include <immintrin.h>
#include <stdint.h>

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

/* Whole numbers below 2^16: exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    __m256i v = _mm256_cvtps_epi32(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    _mm_storeu_si128((void *)out, _mm_packus_epi32(_mm256_castsi256_si128(v), _mm256_extracti128_si256(v, 1)));
}

#endif
