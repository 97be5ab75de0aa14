/* wasm.h - 4 floats: fixed-width SIMD of WebAssembly. See kernel.h for what each operation is. It has no estimates:
 * roots and quotients are rounded correctly. */
#ifndef TIA_SIMD_WASM_H
#define TIA_SIMD_WASM_H

#include <stdint.h>
#include <wasm_simd128.h>

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

/* Whole numbers below 2^16: exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    v128_t v = wasm_u32x4_trunc_sat_f32x4(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)));

    wasm_v128_store64_lane(out, wasm_u16x8_narrow_i32x4(v, v), 0);
}

#endif
