/* avx2.c - 4 doubles: AVX2 and FMA. */
#include <immintrin.h>

#include "lanes.h"

#define LANES 4
typedef __m256d vd;
typedef int64_t vi __attribute__((vector_size(32)));
typedef __m256d vm;
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

#include "pixels.h"
#include "tracer.h"
#include "walk_paths.h"

SURE(avx2);
