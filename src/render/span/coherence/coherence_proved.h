/* coherence_proved.h - the error bounds of a run's integers by name, each with its derivation.
 *
 * A bound is the logarithm of a power of two, but for those that say otherwise: sums of up to four terms are below four
 * times the largest. That is coarse, by a few bits, and costs next to nothing; a level is 2^-6, and the errors are near
 * 2^-20. A row is a number that makes up for such a sum, or that a term begins with. tests/proofs/coherence.g reads the
 * numbers here and proves the sums. "Unseen" and "1 of 2" mean what simd/bound.h says, and tests/quick/bounds and
 * tests/bounds look at these rows as well.
 *
 * T is the mantissa of t, below 2^31. An accumulator's upper half is off by .51 of its last bit: products of T with a
 * form by .51 T of theirs, constants and shifts by half a bit.
 *
 * The point at which the integer code computes the light is P (1 + e), |e| < 2^t. That moves |Q - P|^2 by up to 2.1 |w|
 * |P| e, r N.w, as computed c - L.Q + G.P, by |G| |P| e, A.w by 1.1 (|A| + |w|) |P| e and |A|^2 by 2.1 |A| |P| e.
 *
 * A build that defines BOUND_SCALES scales a bound by its name, see simd/bound.h; in any other build a bound is
 * unscaled. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H

/* COHERENCE_BITS(NAME): the logarithm of a bound; COHERENCE_BELOW(NAME): that of 2^-NAME; COHERENCE_WIDE(NAME, x): x is
 * a bound itself. */
#ifdef BOUND_SCALES
#include BOUND_SCALES
#define COHERENCE_BITS(name) ((name) + bound_bits_of(#name))
#define COHERENCE_BELOW(name) (bound_bits_of(#name) - (name))
#define COHERENCE_WIDE(name, ...) BOUND_SCALED(#name, (__VA_ARGS__))
#else
#define COHERENCE_BITS(name) (name)
#define COHERENCE_BELOW(name) (-(name))
#define COHERENCE_WIDE(name, ...) (__VA_ARGS__)
#endif

/* ---- t ---- */

/* S = b + sqrt(D), relative, 2^(this - B - S) for a root of B and a sum of S bits. b, v.v and c as mantissas are below
 * 2^31, 2^31 and 2^32: in units of b's last bit D is off by .51 (2^32 + 2^32 + 2^31 + 2) < 1.3 2^32, so sqrt(D) by that
 * over itself and one bit for rounding down. D is concave along the run: it is least at an end, where it was computed;
 * so is S, which is concave as well. From 2^19 on the computed root is within 1/32 of the true one: S is off by less
 * than 1.4 2^(33 - B) + 1.51 of more than .98 2^(S - 1). Proved: coherence.g (sum), .55 of 1. */
#define COHERENCE_ROOT 36

/* The reciprocal and c, relative, 2^-this. Proved: coherence.g (inverse), 1 of 4. COHERENCE_ROOT's is as
 * large or larger. Unseen: small. */
#define COHERENCE_INVERSE 28

/* T is rounded by 1/2, and is at least half of its value at an end, as S is at most 2 b and b is largest at an end: so
 * at least 2^(bits - 2). 1 of 1. */
#define COHERENCE_ROUNDED 1

/* t: the sum of the three above. Proved: coherence.g (t), 1.8 of 2. */
#define COHERENCE_DEPTH 1

/* A root has at least so many bits, as COHERENCE_ROOT assumes. With more, fewer runs are drawn. Unseen: choice. */
#define COHERENCE_SMALLEST 20

/* t is accurate to 2^(this - 32). With less, fewer runs are drawn. Unseen: choice. */
#define COHERENCE_KNOWN 20

/* |v| is a root, which is rounded down: 1 of 1. Unseen: small. */
#define COHERENCE_VIEW 0

/* ---- light ---- */

/* |P|^2: T/2, and .51 T^2 of v.v's last bit. Proved: coherence.g (reach), 1.01 of 2. */
#define COHERENCE_REACH 1

/* |Q - P|^2: .51 T of Q.v twice, a constant and a shift, and |P|^2. Proved: coherence.g (square), 1.3 of 2. */
#define COHERENCE_SQUARE 1

/* |Q - P|^2 by |Q - P| |P| times t's relative error, 2.1 of 4. Proved: coherence.g (moved). */
#define COHERENCE_MOVES 2

/* Two of |Q - P|^2, each off by that and by what it is computed to. Proved: coherence.g (turn), 3.1 of 4. */
#define COHERENCE_TURN 2

/* r N.(Q - P): .51 T of G.v and a constant, and |G| |P| times t's error. Proved: coherence.g (facing), 1.6 of 2. */
#define COHERENCE_FACING 1

/* |Q - P|^2 as computed is at least 2^(bits - 1), and accurate to 1/32: above 2^(bits - this). 1.03 of 2. */
#define COHERENCE_DISTANCE 2

/* |Q - P|^2, relative: as computed, and by t. Proved: coherence.g (relative), 1.6 of 2. Unseen: small. */
#define COHERENCE_RELATIVE 1

/* |Q - P|^2 is accurate to 2^(this - 25), 1/32, as the next bounds assume. With less, fewer pixels are drawn so.
 * Unseen: choice. */
#define COHERENCE_CLOSE 20

/* The products of a cosine, 2^-this: they add up to 2^-27.9. Proved: simd_integer.g (cosine), 1 of 4. */
#define COHERENCE_KERNELS 26

/* Two cosines: r N.w over r d, half of |w|^2's relative error, and those products. Proved: coherence.g (lambert), 6.2
 * of 8. */
#define COHERENCE_LAMBERT 3

/* Shadows are looked for where lambert is known within 1/this; not a logarithm. A choice: a coarser one decides next to
 * nothing. Unseen: choice. */
#define COHERENCE_COARSE 64

/* ---- paths ---- */

/* t at both ends is off by 2^t T each: 2 of 4. Unseen: small. */
#define COHERENCE_STEP 2

/* Two shifts that are rounded, the second one doubled: 1.5 of 4. Unseen: small. */
#define COHERENCE_SHIFTS 2

/* Half an arc, in chords; not a logarithm. An arc that is less than half a circle is at most pi/2 of its chord. Proved:
 * coherence.g (arc), .786 of .796. */
#define COHERENCE_ARC(chord) ((chord) - (chord) / 8 - (chord) / 16 - (chord) / 64)

/* The same, where the chord is at most a quarter of another one, which is no longer than the diameter: half of it, but
 * for 1.1 %. Proved: coherence.g (short), .506 of .515; halves are rounded down, 1 of 2. */
#define COHERENCE_SHORT(chord) ((chord) / 2 + (chord) / 64 + coherence_power(1))

/* A run's chord, the points' distance along x alone, is off by 2^t |P| at both ends: 2 of 4. Unseen: small. */
#define COHERENCE_ENDS 2

/* The chord is off by two shifts as well: 1 of 2. Unseen: small. */
#define COHERENCE_ENDS_SHIFTS 1

/* ---- shadows at a pixel ---- */

/* R and twice the bias are shifted to the run's exponent: half of 1. Unseen: small. */
#define COHERENCE_RADIUS 0
#define COHERENCE_BIAS 0 /* as COHERENCE_RADIUS. Unseen: small. */

/* |C - Q| is a root, which is rounded down, with the exponent 15: one of its last bit, and half of the shifted
 * one's. 1.5 of 2. Unseen: small. */
#define COHERENCE_AWAY 1

/* A.w: .51 T of (C + Q).v and a constant, and |P|^2. The error of t is part of the path. Proved: coherence.g
 * (toward), 1.6 of 2. */
#define COHERENCE_TOWARD 1

/* |L - C|^2 - r^2 - R^2 times bias/(r + bias) is off by 2^-this of its size times bias/r: 1.5 of 16, as
 * bounds/shadows.h of simd/span counts it (SPAN_SWELL). Unseen: small. */
#define COHERENCE_APART 26

/* And its exponent is 30: 2^-this, 1.5 of 8. Unseen: small. */
#define COHERENCE_APART_UNITS 27

/* |A'|^2 - R^2: the former two, .51 T of C.v twice and a constant, |P|^2, the factor 1 + bias/r that it lacks, and N
 * that is off with P. Proved: coherence.g (power), 6 of 8. */
#define COHERENCE_POWER 3

/* The inverse root and its products, of A'.w/|w|, 2^-this: 1 of 4. */
#define COHERENCE_FOOT 28

/* A'.w/|w|: A'.w's over d, |w|'s relative one, and the former. Proved: coherence.g (length), 3 of 4. */
#define COHERENCE_LENGTH 2

/* ---- shadows between two samples, see coherence.c ---- */

/* w/|w| turns by path/d at most, both accurate to 1/32: 1/this more, and 2^-24 for the quotient; not a logarithm.
 * Unseen: small. */
#define COHERENCE_TURNING 16

/* Lengths of 2^30 and more do not matter, and with bounds of 2^24 and 2^58 no sum overflows. With less, fewer pixels
 * are drawn so. Unseen: choice. */
#define COHERENCE_LENGTH_MOST 24
#define COHERENCE_POWER_MOST 58 /* as the former has it. Unseen: choice. */

/* m by two roundings: 1 of 1. Unseen: small. */
#define COHERENCE_SLIDE 0

/* h^2 is off by e at both samples and at a pixel between them: so many times e, which is not a logarithm. Proved:
 * coherence.g (spare), 3 of 3. Unseen: small. */
#define COHERENCE_ERRORS 3

/* A'.w/|w| and |w| are off at a sample and at a pixel: so many times their bound, 4 of 4; not a logarithm. As
 * SPAN_BEYOND. Unseen: hidden. */
#define COHERENCE_BEHIND 4

#endif
