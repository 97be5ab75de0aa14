/* avx512.c - 16 floats: AVX-512 F, BW, DQ and VL. */
#include "avx512.h"
#include "stream_x86.h"

#include "kernel.h"
#include "simd.h"

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

#include "raster.h"

SIMD(avx512, &raster_runs);
