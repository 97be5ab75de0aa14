/* wasm.c - 2 doubles: fixed-width SIMD of WebAssembly. */
#include <wasm_simd128.h>

#include "lanes.h"

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

#include "pixels.h"
#include "tracer.h"
#include "walk_paths.h"

SURE(wasm);
