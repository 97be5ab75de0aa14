/* sse41.c - 2 doubles: SSE4.1. */
#include <smmintrin.h>

#include "lanes.h"

#define LANES 2
typedef __m128d vd;
typedef int64_t vi __attribute__((vector_size(16)));
typedef __m128d vm;
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

#include "pixels.h"
#include "tracer.h"
#include "walk_paths.h"

SURE(sse41);
