/* isa.h - the operations that a file of this directory defines for one instruction set. The templates in span/ and
 * rays/ and raster_tmpl.h use them.
 *
 * Floats, for span/kernel_tmpl.h:
 *
 *   N                      floats in a vector: 4, 8 or 16
 *   F, M                   a vector of floats, and the result of comparing two
 *   f_set(a) f_load(p) f_store(p, a) f_iota()     f_load needs no alignment; f_iota is 0, 1, 2, ...
 *   f_whole(p)                                    N unsigned 16-bit integers, as floats
 *   f_add f_sub f_mul f_min f_max f_abs f_round   f_max(a, NaN) and f_min(a, NaN) are NaN; f_round is to nearest
 *   f_fma(a, b, c) f_fnma(a, b, c)                a b + c and c - a b, rounded once or twice
 *   f_rsqrt f_inverse                             1/sqrt(x) and 1/x, see span/proved.h
 *   f_add_root(a, x) f_over_root(a, x)            a + sqrt(x), a/sqrt(x)
 *   f_gt f_ge m_and m_or m_not m_any m_bits f_sel(m, a, b)   f_gt and f_ge are false where an argument is NaN
 *   i_pack(r, g, b, out)                          N pixels of integer levels
 *   STREAM                                        `stream` and `settle` of struct simd_kernels; optional
 *
 * Doubles, for rays/, and pairs of floats for its boxes, two floats per lane:
 *
 *   LANES            1, 2, 4 or 8
 *   vd, vi, vm       vectors of LANES doubles, 64-bit integers, truth values; vd has C's + - * /, vi + - & << >>
 *   vset(x)          x in every lane
 *   vsqrt vabs vmin vmax      vmin(a, NaN) and vmax(a, NaN) are unspecified
 *   vlt vle          a < b, a <= b: false where one is NaN
 *   vsel(m, a, b)    a where m is true
 *   mand mor mnot, mbits(m), mof(bits)    lane k is bit k
 *   vp               a vector of LANES pairs of floats, with C's + - *
 *   vp_set(x) vp_load(p) vp_of(a)         x everywhere; p[0], p[1] in each lane; each lane of a, twice
 *   vp_min vp_max vp_swap vp_le(a, b)     vp_swap swaps each pair; vp_le: bit 2 k + i is float i of lane k
 *
 * Optional, where a vp has more than 8 floats:
 *   vb               8 floats, with C's + - *, and vb_set vb_min vb_max vb_le, as for vp
 *
 * Optional, where the instruction set does this quickly:
 *   VRSQRT(a)                 1/sqrt(a) within 8 u of itself, a being positive and far from the ends of the range
 *   VBYTES(x)                 the lowest LANES bytes of a uint64_t, as numbers
 *   WORDS_GE(p, a, b)         bits 0..3: which of the uint32_t p[0], ..., p[3] are at least a; bits 4..7: at least b
 *   VPACK(a, lanes)           the chosen lanes, moved together to the first ones
 *   OF16(table, index)        table[index & 15] in each lane, as a vu of rays/random_tmpl.h; the table has 16 words
 *
 * Integers, for raster_tmpl.h, if the instruction set compares 64-bit integers:
 *
 *   QN, Q, W, K           pixels in a vector; vectors of 64-bit and 32-bit integers; a set of these pixels
 *   q_set q_ramp(z, s)    z everywhere; z, z + s, z + 2s, ...
 *   q_add q_sub q_clamp   q_clamp: negative numbers become 0
 *   q_gt(a, b)            signed
 *   w_set w_add w_eq
 *   q_load(p) w_load(p)   QN integers
 *   q_part w_part (p, k), q_store w_store (p, k, a)     for the pixels in k; others are neither read nor written
 *   k_all() k_first(n)    all pixels; the first n, n < QN
 *   k_and k_or k_minus(a, b) k_any k_bits k_of(bits)
 */
#ifndef TIA_SIMD_ISA_ISA_H
#define TIA_SIMD_ISA_ISA_H

#define LANE_OP static inline __attribute__((always_inline, unused))

/* Returns two adjacent floats as one double, which processors can load into every lane at once. */
LANE_OP double two_floats(const float *p)
{
    double both;

    __builtin_memcpy(&both, p, sizeof both);
    return both;
}

#endif
