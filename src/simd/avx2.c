/* avx2.c - 8 floats: AVX2 and FMA. */
#include "avx2.h"
#include "stream_x86.h"

#include "kernel.h"
#include "simd.h"

#define QN 4
typedef __m256i Q;
typedef __m128i W;
typedef __m256i K; /* all bits of the pixels in the set */
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

#include "raster.h"

SIMD(avx2, &raster_runs);
