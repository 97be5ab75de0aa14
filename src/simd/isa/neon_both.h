/* neon_both.h - the operations that both kinds of NEON have. */
#ifndef TIA_SIMD_ISA_NEON_BOTH_H
#define TIA_SIMD_ISA_NEON_BOTH_H

#define f_set(a) vdupq_n_f32(a)
#define f_load(p) vld1q_f32(p)
#define f_store(p, a) vst1q_f32(p, a)
#define f_whole(p) vcvtq_f32_u32(vmovl_u16(vld1_u16(p)))
#define f_add(a, b) vaddq_f32(a, b)
#define f_sub(a, b) vsubq_f32(a, b)
#define f_mul(a, b) vmulq_f32(a, b)
#define f_min(a, b) vminq_f32(a, b)
#define f_max(a, b) vmaxq_f32(a, b)
#define f_abs(a) vabsq_f32(a)
#define f_gt(a, b) vcgtq_f32(a, b)
#define f_ge(a, b) vcgeq_f32(a, b)
#define m_and(a, b) vandq_u32(a, b)
#define m_or(a, b) vorrq_u32(a, b)
#define m_not(a) vmvnq_u32(a)
#define f_sel(m, a, b) vbslq_f32(m, a, b)
#define f_over_root(a, x) f_mul(a, f_rsqrt(x))

static inline F f_iota(void)
{
    static const float iota[4] = {0, 1, 2, 3};

    return vld1q_f32(iota);
}

/* Returns 1/sqrt(x). The estimate has 8 bits, which each of two Newton steps doubles. */
static inline F f_rsqrt(F x)
{
    F y = vrsqrteq_f32(x);

    y = vmulq_f32(y, vrsqrtsq_f32(vmulq_f32(x, y), y));
    return vmulq_f32(y, vrsqrtsq_f32(vmulq_f32(x, y), y));
}

static inline F f_inverse(F x)
{
    F y = vrecpeq_f32(x);

    y = vmulq_f32(y, vrecpsq_f32(x, y));
    return vmulq_f32(y, vrecpsq_f32(x, y));
}

/* Packs N pixels of integer levels. A packed pixel is below 2^16, so all sums are exact. */
static inline void i_pack(F r, F g, F b, uint16_t *out)
{
    vst1_u16(out, vmovn_u32(vcvtq_u32_f32(f_fma(r, f_set(2048), f_fma(g, f_set(32), b)))));
}

#endif
