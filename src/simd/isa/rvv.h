/* rvv.h - V of RISC-V: 8 floats, 4 doubles, 8 integers, on vectors of any length from 128 bits on.
 *
 * The types of its intrinsics have no size that the compiler knows, so that they can be in no structure. Floats and
 * doubles are vectors of the language instead, of 256 bits: the compiler computes with them in pairs of registers, and
 * sets the number of elements before each instruction. Longer vectors leave the rest of a pair alone. Roots and
 * quotients are correctly rounded, since estimates have intrinsics alone. */
#ifndef TIA_SIMD_ISA_RVV_H
#define TIA_SIMD_ISA_RVV_H

#include <riscv_vector.h>
#include <stdbool.h>
#include <stdint.h>

#include "isa.h"

#define N 8
typedef float F __attribute__((vector_size(32)));
typedef bool M __attribute__((ext_vector_type(8)));
typedef int32_t f_words __attribute__((vector_size(32))); /* the words of an F */
#define f_add(a, b) ((a) + (b))
#define f_sub(a, b) ((a) - (b))
#define f_mul(a, b) ((a) * (b))
#define f_abs(a) __builtin_elementwise_abs(a)
#define f_gt(a, b) __builtin_convertvector((a) > (b), M)
#define f_ge(a, b) __builtin_convertvector((a) >= (b), M)
#define m_and(a, b) ((a) & (b))
#define m_or(a, b) ((a) | (b))
#define m_not(a) (~(a))
#define m_any(a) (m_bits(a) != 0)

LANE_OP F f_set(float a)
{
    return (F){a, a, a, a, a, a, a, a};
}

LANE_OP F f_load(const float *p)
{
    F a;

    __builtin_memcpy(&a, p, sizeof a);
    return a;
}

LANE_OP void f_store(float *p, F a)
{
    __builtin_memcpy(p, &a, sizeof a);
}

LANE_OP F f_iota(void)
{
    return (F){0, 1, 2, 3, 4, 5, 6, 7};
}

typedef uint16_t f_halves __attribute__((vector_size(16)));

LANE_OP F f_whole(const uint16_t *p)
{
    f_halves whole;

    __builtin_memcpy(&whole, p, sizeof whole);
    return __builtin_convertvector(whole, F);
}

LANE_OP unsigned m_bits(M m)
{
    uint8_t bits;

    __builtin_memcpy(&bits, &m, sizeof bits);
    return bits;
}

LANE_OP F f_sel(M m, F a, F b)
{
    f_words mask = -__builtin_convertvector(m, f_words);

    return (F)((mask & (f_words)a) | (~mask & (f_words)b));
}

/* The processor's own minimum ignores a NaN. */
LANE_OP F f_min(F a, F b)
{
    return f_sel(f_gt(b, a), a, b);
}

LANE_OP F f_max(F a, F b)
{
    return f_sel(f_gt(a, b), a, b);
}

/* Returns `a` rounded, |a| < 2^22: the unit of sums with 1.5 2^23 is 1. */
LANE_OP F f_round(F a)
{
    return (a + f_set(12582912)) - f_set(12582912);
}

LANE_OP F f_fma(F a, F b, F c)
{
#pragma STDC FP_CONTRACT ON
    return a * b + c;
}

LANE_OP F f_fnma(F a, F b, F c)
{
#pragma STDC FP_CONTRACT ON
    return c - a * b;
}

/* The language has no root of a vector: the compiler makes one instruction of such a loop. With a sanitizer it does
 * not, and would warn. */
#pragma clang diagnostic ignored "-Wpass-failed"
LANE_OP F f_root(F x)
{
    float a[N];

    f_store(a, x);
#pragma clang loop vectorize(enable) vectorize_width(8, fixed) interleave(disable) unroll(disable)
    for (int k = 0; k < N; k++)
        a[k] = __builtin_sqrtf(a[k]);
    return f_load(a);
}

#define f_inverse(x) (f_set(1) / (x))
#define f_rsqrt(x) f_inverse(f_root(x))
#define f_add_root(a, x) ((a) + f_root(x))
#define f_over_root(a, x) ((a) / f_root(x))

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact; that with 2^23 has the pixel
 * as its lowest bits. (QEMU 7.2 ends at an instruction that converts by cutting off.) */
LANE_OP void i_pack(F r, F g, F b, uint16_t *out)
{
    F sum = f_fma(r, f_set(2048), f_fma(g, f_set(32), b + f_set(8388608)));
    f_halves pixels = __builtin_convertvector((f_words)sum, f_halves);

    __builtin_memcpy(out, &pixels, sizeof pixels);
}

/* ---- integers, for the rasteriser's runs: by intrinsics, as no structure has them ---- */

#define QN 8
typedef vint64m4_t Q;
typedef vint32m2_t W;
typedef vbool16_t K;
#define q_set(a) __riscv_vmv_v_x_i64m4(a, QN)
#define q_add(a, b) __riscv_vadd_vv_i64m4(a, b, QN)
#define q_sub(a, b) __riscv_vsub_vv_i64m4(a, b, QN)
#define q_clamp(a) __riscv_vmax_vx_i64m4(a, 0, QN)
#define q_gt(a, b) __riscv_vmsgt_vv_i64m4_b16(a, b, QN)
#define q_load(p) __riscv_vle64_v_i64m4((const int64_t *)(p), QN)
#define q_part(p, k) __riscv_vle64_v_i64m4_m(k, (const int64_t *)(p), QN)
#define q_store(p, k, a) __riscv_vse64_v_i64m4_m(k, (int64_t *)(p), a, QN)
#define w_set(a) __riscv_vmv_v_x_i32m2((int32_t)(a), QN)
#define w_add(a, b) __riscv_vadd_vv_i32m2(a, b, QN)
#define w_eq(a, b) __riscv_vmseq_vv_i32m2_b16(a, b, QN)
#define w_load(p) __riscv_vle32_v_i32m2((const int32_t *)(p), QN)
#define w_part(p, k) __riscv_vle32_v_i32m2_m(k, (const int32_t *)(p), QN)
#define w_store(p, k, a) __riscv_vse32_v_i32m2_m(k, (int32_t *)(p), a, QN)
#define k_all() __riscv_vmset_m_b16(QN)
#define k_first(n) __riscv_vmsltu_vx_u32m2_b16(__riscv_vid_v_u32m2(QN), (uint32_t)(n), QN)
#define k_and(a, b) __riscv_vmand_mm_b16(a, b, QN)
#define k_or(a, b) __riscv_vmor_mm_b16(a, b, QN)
#define k_minus(a, b) __riscv_vmandn_mm_b16(a, b, QN)
#define k_any(a) (__riscv_vfirst_m_b16(a, QN) >= 0)

LANE_OP unsigned k_bits(K k)
{
    uint8_t bits;

    __riscv_vsm_v_b16(&bits, k, QN);
    return bits;
}

LANE_OP K k_of(unsigned bits)
{
    const uint8_t byte = (uint8_t)bits;

    return __riscv_vlm_v_b16(&byte, QN);
}

LANE_OP Q q_ramp(uint64_t z, uint64_t step)
{
    vuint64m4_t steps = __riscv_vmul_vx_u64m4(__riscv_vid_v_u64m4(QN), step, QN);

    return __riscv_vreinterpret_v_u64m4_i64m4(__riscv_vadd_vx_u64m4(steps, z, QN));
}

/* ---- doubles, for rays ---- */

#define LANES 4
typedef double vd __attribute__((vector_size(32)));
typedef int64_t vi __attribute__((vector_size(32)));
typedef vi vm; /* all bits of a true lane are set */
#define vabs(a) __builtin_elementwise_abs(a)
#define vmin(a, b) __builtin_elementwise_min(a, b)
#define vmax(a, b) __builtin_elementwise_max(a, b)
#define vlt(a, b) ((vm)((a) < (b)))
#define vle(a, b) ((vm)((a) <= (b)))
#define mand(a, b) ((a) & (b))
#define mor(a, b) ((a) | (b))
#define mnot(a) (~(a))

LANE_OP vd vset(double x)
{
    return (vd){x, x, x, x};
}

LANE_OP vd vsqrt(vd x)
{
    double a[LANES];

    __builtin_memcpy(a, &x, sizeof a);
#pragma clang loop vectorize(enable) vectorize_width(4, fixed) interleave(disable) unroll(disable)
    for (int k = 0; k < LANES; k++)
        a[k] = __builtin_sqrt(a[k]);
    __builtin_memcpy(&x, a, sizeof x);
    return x;
}

/* The comparison with 0 makes one instruction of the rest. */
LANE_OP vd vsel(vm m, vd a, vd b)
{
    vm mask = m != 0;

    return (vd)((mask & (vm)a) | (~mask & (vm)b));
}

LANE_OP unsigned mbits(vm m)
{
    return (unsigned)__builtin_reduce_or(m & (vm){1, 2, 4, 8});
}

LANE_OP vm mof(unsigned bits)
{
    const vm bit = {1, 2, 4, 8};

    return (bit & (int64_t)bits) != 0;
}

typedef F vp;
#define vp_set(x) f_set(x)
#define vp_min(a, b) __builtin_elementwise_min(a, b)
#define vp_max(a, b) __builtin_elementwise_max(a, b)
#define vp_le(a, b) m_bits(__builtin_convertvector((a) <= (b), M))

LANE_OP vp vp_load(const float *p)
{
    return (vp)vset(two_floats(p));
}

LANE_OP vp vp_of(vd a)
{
    typedef float floats __attribute__((vector_size(16)));
    floats f = __builtin_convertvector(a, floats);

    return __builtin_shufflevector(f, f, 0, 0, 1, 1, 2, 2, 3, 3);
}

/* By shifts of whole pairs, as a table of places would have to be loaded. */
LANE_OP vp vp_swap(vp a)
{
    typedef uint64_t pairs __attribute__((vector_size(32)));

    return (vp)((pairs)a >> 32 | (pairs)a << 32);
}

#endif
