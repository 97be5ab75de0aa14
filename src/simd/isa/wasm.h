/* wasm.h - fixed-width SIMD of WebAssembly: 4 floats, 2 doubles. It has no estimates; roots and quotients are correctly
 * rounded. */
#ifndef TIA_SIMD_ISA_WASM_H
#define TIA_SIMD_ISA_WASM_H

#include <stdint.h>
#include <wasm_simd128.h>

#include "isa.h"

#define N 4
typedef v128_t F;
typedef v128_t M;
#define f_set(a) wasm_f32x4_splat(a)
#define f_load(p) wasm_v128_load(p)
#define f_store(p, a) wasm_v128_store(p, a)
#define f_whole(p) wasm_f32x4_convert_u32x4(wasm_u32x4_load16x4(p))
#define f_iota() wasm_f32x4_const(0, 1, 2, 3)
#define f_add(a, b) wasm_f32x4_add(a, b)
#define f_sub(a, b) wasm_f32x4_sub(a, b)
#define f_mul(a, b) wasm_f32x4_mul(a, b)
#define f_min(a, b) wasm_f32x4_pmin(b, a)
#define f_max(a, b) wasm_f32x4_pmax(b, a)
#define f_abs(a) wasm_f32x4_abs(a)
#define f_round(a) wasm_f32x4_nearest(a)
#define f_fma(a, b, c) f_add(f_mul(a, b), c)
#define f_fnma(a, b, c) f_sub(c, f_mul(a, b))
#define f_gt(a, b) wasm_f32x4_gt(a, b)
#define f_ge(a, b) wasm_f32x4_ge(a, b)
#define m_and(a, b) wasm_v128_and(a, b)
#define m_or(a, b) wasm_v128_or(a, b)
#define m_not(a) wasm_v128_not(a)
#define m_bits(a) ((unsigned)wasm_i32x4_bitmask(a))
#define m_any(a) wasm_v128_any_true(a)
#define f_sel(m, a, b) wasm_v128_bitselect(a, b, m)
#define f_inverse(x) wasm_f32x4_div(f_set(1), x)
#define f_rsqrt(x) f_inverse(wasm_f32x4_sqrt(x))
#define f_add_root(a, x) f_add(a, wasm_f32x4_sqrt(x))
#define f_over_root(a, x) wasm_f32x4_div(a, wasm_f32x4_sqrt(x))

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    v128_t v = wasm_u32x4_trunc_sat_f32x4(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    wasm_v128_store64_lane(out, wasm_u16x8_narrow_i32x4(v, v), 0);
}

/* ---- doubles, for rays ---- */

#define LANES 2
typedef double vd __attribute__((vector_size(16)));
typedef int64_t vi __attribute__((vector_size(16)));
typedef v128_t vm;
#define vset(x) ((vd)wasm_f64x2_splat(x))
#define vsqrt(a) ((vd)wasm_f64x2_sqrt((v128_t)(a)))
#define vabs(a) ((vd)wasm_f64x2_abs((v128_t)(a)))
#define vmin(a, b) ((vd)wasm_f64x2_pmin((v128_t)(a), (v128_t)(b)))
#define vmax(a, b) ((vd)wasm_f64x2_pmax((v128_t)(a), (v128_t)(b)))
#define vlt(a, b) wasm_f64x2_lt((v128_t)(a), (v128_t)(b))
#define vle(a, b) wasm_f64x2_le((v128_t)(a), (v128_t)(b))
#define vsel(m, a, b) ((vd)wasm_v128_bitselect((v128_t)(a), (v128_t)(b), m))
#define mand(a, b) wasm_v128_and(a, b)
#define mor(a, b) wasm_v128_or(a, b)
#define mnot(a) wasm_v128_not(a)
#define mbits(m) ((unsigned)wasm_i64x2_bitmask(m))

LANE_OP vm mof(unsigned bits)
{
    return wasm_i64x2_make(-(int64_t)(bits & 1), -(int64_t)(bits >> 1 & 1));
}

typedef float vp __attribute__((vector_size(16)));
#define vp_set(x) ((vp)wasm_f32x4_splat(x))
#define vp_load(p) ((vp)wasm_v128_load64_splat(p))
#define vp_min(a, b) ((vp)wasm_f32x4_pmin((v128_t)(a), (v128_t)(b)))
#define vp_max(a, b) ((vp)wasm_f32x4_pmax((v128_t)(a), (v128_t)(b)))
#define vp_le(a, b) ((unsigned)wasm_i32x4_bitmask(wasm_f32x4_le((v128_t)(a), (v128_t)(b))))
#define vp_swap(a) ((vp)wasm_i32x4_shuffle((v128_t)(a), (v128_t)(a), 1, 0, 3, 2))

LANE_OP vp vp_of(vd a)
{
    v128_t f = wasm_f32x4_demote_f64x2_zero((v128_t)a);

    return (vp)wasm_i32x4_shuffle(f, f, 0, 0, 1, 1);
}

#endif
