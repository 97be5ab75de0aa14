/* isa.h - the operations that a file of this directory defines for one instruction set; the templates of span/, rays/
 * and raster_tmpl.h are made of them.
 *
 * Floats, for span/kernel_tmpl.h:
 *
 *   N                      floats in a vector: 4, 8 or 16
 *   F, M                   a vector of floats, and the result of comparing two
 *   f_set(a) f_load(p) f_store(p, a) f_iota()     f_load needs no alignment; f_iota is 0, 1, 2, ...
 *   f_whole(p)                                    N numbers of 16 bits
 *   f_add f_sub f_mul f_min f_max f_abs f_round   f_max(a, NaN) and f_min(a, NaN) are NaN; f_round is to nearest
 *   f_fma(a, b, c) f_fnma(a, b, c)                a b + c and c - a b, rounded once or twice
 *   f_rsqrt f_inverse                             1/sqrt(x) and 1/x, see span/proved.h
 *   f_add_root(a, x) f_over_root(a, x)            a + sqrt(x), a/sqrt(x)
 *   f_gt f_ge m_and m_or m_not m_any m_bits f_sel(m, a, b)   false where an argument is NaN
 *   i_pack(r, g, b, out)                          N pixels of integer levels
 *   STREAM                                        stream and settle of span/run.h; optional
 *
 * Doubles, for rays/, and pairs of floats for its boxes (vp: two a lane):
 *
 *   LANES            1, 2, 4 or 8
 *   vd, vi, vm       vectors of LANES doubles, integers, truth values; vd has the language's + - * /, vi also << >>
 *   vset(x)          x in every lane
 *   vsqrt vabs vmin vmax      vmin(a, NaN) and vmax(a, NaN) may be anything
 *   vlt vle          a < b, a <= b: false where one is NaN
 *   vsel(m, a, b)    a where m is true
 *   mand mor mnot, mbits(m), mof(bits)    lane k is bit k
 *
 * Optional, where the instruction set does this quickly:
 *   OF16(table, index)        the words of a table of 16 at the low four bits of each lane's index: vu,
 *                             see rays/random_tmpl.h
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
 *   k_all() k_first(n)    n below QN
 *   k_and k_or k_minus(a, b) k_any k_bits k_of(bits)
 * */
#ifndef TIA_SIMD_ISA_ISA_H
#define TIA_SIMD_ISA_ISA_H

#define LANE_OP static inline __attribute__((always_inline, unused))

/* Returns two floats that lie side by side as a double, which processors load into every lane at once. */
LANE_OP double two_floats(const float *p)
{
    double both;

    __builtin_memcpy(&both, p, sizeof both);
    return both;
}

#endif
