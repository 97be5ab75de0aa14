/* vector_floats.h - the float operations listed in src/simd/isa/isa.h, by the compiler's own vectors: 4 floats on any
 * processor. */
#ifndef TESTS_VECTOR_FLOATS_H
#define TESTS_VECTOR_FLOATS_H

#include <math.h>
#include <stdint.h>
#include <string.h>

#define N 4
typedef float F __attribute__((vector_size(16)));
typedef int32_t M __attribute__((vector_size(16)));

#define f_add(a, b) ((a) + (b))
#define f_sub(a, b) ((a) - (b))
#define f_mul(a, b) ((a) * (b))
#define f_fma(a, b, c) ((a) * (b) + (c))
#define f_fnma(a, b, c) ((c) - (a) * (b))
#define f_gt(a, b) ((M)((a) > (b)))
#define f_ge(a, b) ((M)((a) >= (b)))
#define m_and(a, b) ((a) & (b))
#define m_or(a, b) ((a) | (b))
#define m_not(a) (~(a))
#define m_any(a) (m_bits(a) != 0)
#define f_inverse(x) (f_set(1) / (x))
#define f_rsqrt(x) (f_set(1) / f_root(x))
#define f_add_root(a, x) ((a) + f_root(x))
#define f_over_root(a, x) ((a) / f_root(x))
#define f_min(a, b) f_sel(f_gt(b, a), a, b) /* the result is b where one argument is NaN */
#define f_max(a, b) f_sel(f_gt(a, b), a, b)

static inline F f_set(float a)
{
    return (F){a, a, a, a};
}

static inline F f_iota(void)
{
    return (F){0, 1, 2, 3};
}

static inline F f_load(const float *p)
{
    F a;

    memcpy(&a, p, sizeof a);
    return a;
}

static inline void f_store(float *p, F a)
{
    memcpy(p, &a, sizeof a);
}

static inline F f_whole(const uint16_t *p)
{
    return (F){p[0], p[1], p[2], p[3]};
}

static inline F f_sel(M m, F a, F b)
{
    return (F)((m & (M)a) | (~m & (M)b));
}

static inline F f_abs(F a)
{
    return (F)((M)a & (M){INT32_MAX, INT32_MAX, INT32_MAX, INT32_MAX});
}

static inline F f_root(F x)
{
    return (F){sqrtf(x[0]), sqrtf(x[1]), sqrtf(x[2]), sqrtf(x[3])};
}

static inline F f_round(F a)
{
    return (F){rintf(a[0]), rintf(a[1]), rintf(a[2]), rintf(a[3])};
}

static inline unsigned m_bits(M m)
{
    return (unsigned)((m[0] & 1) | (m[1] & 2) | (m[2] & 4) | (m[3] & 8));
}

static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    for (int i = 0; i < N; i++)
        out[i] = (uint16_t)(r[i] * 2048 + g[i] * 32 + b[i]);
}

#endif
