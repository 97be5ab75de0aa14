/* avx512.c - 8 doubles: AVX-512 F, DQ and VL. */
#include <immintrin.h>

#include "lanes.h"

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
#define OF16(table, index)                                                                                             \
    (vu) _mm256_permutex2var_epi32(_mm256_loadu_si256((const void *)(table)), (__m256i)(index),                        \
                                   _mm256_loadu_si256((const void *)((table) + 8)))

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

#include "pixels.h"
#include "tracer.h"
#include "walk_paths.h"

SURE(avx512);
