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

/* The relative error of S = b + sqrt(D), 2^(this - B - S) for a root of B bits and a sum of S bits. b, v.v and c as
 * mantissas are below 2^31, 2^31 and 2^32: in units of b's last bit D is off by .51 (2^32 + 2^32 + 2^31 + 2) < 1.3
 * 2^32, so sqrt(D) by that over itself and one bit for rounding down. D is concave along the run: it is least at an
 * end, where it was computed; so is S, which is concave as well. From 2^19 on the computed root is within 1/32 of the
 * true one: S is off by less than 1.4 2^(33 - B) + 1.51 of more than .98 2^(S - 1). Proved: coherence.g (sum), .55 of
 * 1. */
#define COHERENCE_ROOT 36

/* The relative errors of the reciprocal of S and of c, 2^-this. Proved: coherence.g (inverse), 1 of 4. COHERENCE_ROOT's
 * is as large or larger. Unseen: small. */
#define COHERENCE_INVERSE 28

/* The rounding of T, relative, 2^(this - bits): 1/2 of T, which is at least half of its value at an end, as S is at
 * most 2 b and b is largest at an end: so at least 2^(bits - 2). 1 of 1. */
#define COHERENCE_ROUNDED 1

/* The relative error of t: the sum of COHERENCE_ROOT, COHERENCE_ROUNDED and COHERENCE_INVERSE. Proved: coherence.g (t),
 * 1.8 of 2. */
#define COHERENCE_DEPTH 1

/* The least number of bits of a root, as COHERENCE_ROOT assumes. With more, fewer runs are drawn. Unseen: choice. */
#define COHERENCE_SMALLEST 20

/* The largest relative error of t, 2^(this - 32), with which a run is drawn. With less, fewer runs are drawn. Unseen:
 * choice. */
#define COHERENCE_KNOWN 20

/* The rounding of |v|, a root, which is rounded down: 1 of 1. Unseen: small. */
#define COHERENCE_VIEW 0

/* ---- light ---- */

/* The error of |P|^2: T/2, and .51 T^2 of v.v's last bit. Proved: coherence.g (reach), 1.01 of 2. */
#define COHERENCE_REACH 1

/* The error of |Q - P|^2 as computed: .51 T of Q.v twice, a constant and a shift, and |P|^2. Proved: coherence.g
 * (square), 1.3 of 2. */
#define COHERENCE_SQUARE 1

/* The error of |Q - P|^2 by that of t: |Q - P| |P| times t's relative error, 2.1 of 4. Proved: coherence.g (moved). */
#define COHERENCE_MOVES 2

/* The error of the difference of two |Q - P|^2, each off by COHERENCE_MOVES and by COHERENCE_SQUARE. Proved:
 * coherence.g (turn), 3.1 of 4. */
#define COHERENCE_TURN 2

/* The error of r N.(Q - P): .51 T of G.v and a constant, and |G| |P| times t's error. Proved: coherence.g (facing), 1.6
 * of 2. */
#define COHERENCE_FACING 1

/* The number of bits from the top of |Q - P|^2 as computed, which has `bits`, down to its least value: as computed it
 * is at least 2^(bits - 1), and accurate to 1/32: above 2^(bits - this). 1.03 of 2. */
#define COHERENCE_DISTANCE 2

/* The relative error of |Q - P|^2: as computed, and by t. Proved: coherence.g (relative), 1.6 of 2. Unseen: small. */
#define COHERENCE_RELATIVE 1

/* The largest relative error of |Q - P|^2, 2^(this - 25), 1/32, as the next bounds assume. With less, fewer pixels are
 * drawn so. Unseen: choice. */
#define COHERENCE_CLOSE 20

/* The roundings of a cosine's products, 2^-this: they add up to 2^-27.9. Proved: simd_integer.g (cosine), 1 of 4. */
#define COHERENCE_KERNELS 26

/* The error of the difference of two cosines: that of r N.w over r d, half of |w|^2's relative error, and
 * COHERENCE_KERNELS. Proved: coherence.g (lambert), 6.2 of 8. */
#define COHERENCE_LAMBERT 3

/* The largest error of lambert, 1/this, with which shadows are looked for; not a logarithm. A choice: a coarser one
 * decides next to nothing. Unseen: choice. */
#define COHERENCE_COARSE 64

/* ---- paths ---- */

/* The error of the difference of t at two samples: t at both ends is off by 2^t T each: 2 of 4. Unseen: small. */
#define COHERENCE_STEP 2

/* The rounding of a chord between two samples by two shifts, the second one doubled: 1.5 of 4. Unseen: small. */
#define COHERENCE_SHIFTS 2

/* The largest half of an arc, in chords; not a logarithm. An arc that is less than half a circle is at most pi/2 of its
 * chord. Proved: coherence.g (arc), .786 of .796. */
#define COHERENCE_ARC(chord) ((chord) - (chord) / 8 - (chord) / 16 - (chord) / 64)

/* The largest half of an arc, as COHERENCE_ARC, where the chord is at most a quarter of another one, which is no longer
 * than the diameter: half of the chord, but for 1.1 %. Proved: coherence.g (short), .506 of .515; halves are rounded
 * down, 1 of 2. */
#define COHERENCE_SHORT(chord) ((chord) / 2 + (chord) / 64 + coherence_power(1))

/* The error of a run's chord, the points' distance along x alone, by that of t: 2^t |P| at both ends: 2 of 4. Unseen:
 * small. */
#define COHERENCE_ENDS 2

/* The rounding of a run's chord by two shifts: 1 of 2. Unseen: small. */
#define COHERENCE_ENDS_SHIFTS 1

/* ---- shadows at a pixel ---- */

/* The rounding of R as it is shifted to the run's exponent: half of 1. Unseen: small. */
#define COHERENCE_RADIUS 0

/* The rounding of twice the bias as it is shifted to the run's exponent, half of 1, as COHERENCE_RADIUS. Unseen: small.
 */
#define COHERENCE_BIAS 0

/* The rounding of |C - Q|, a root, which is rounded down, with the exponent 15: one of its last bit, and half of the
 * shifted one's. 1.5 of 2. Unseen: small. */
#define COHERENCE_AWAY 1

/* The error of A.w: .51 T of (C + Q).v and a constant, and |P|^2. The error of t is part of the path. Proved:
 * coherence.g (toward), 1.6 of 2. */
#define COHERENCE_TOWARD 1

/* The relative error of |L - C|^2 - r^2 - R^2 times bias/(r + bias), 2^-this of its size times bias/r: 1.5 of 16, as
 * bounds/shadows.h of simd/span counts it (SPAN_SWELL). Unseen: small. */
#define COHERENCE_APART 26

/* The rounding of COHERENCE_APART's product, whose exponent is 30: 2^-this, 1.5 of 8. Unseen: small. */
#define COHERENCE_APART_UNITS 27

/* The error of |A'|^2 - R^2: COHERENCE_APART and COHERENCE_APART_UNITS, .51 T of C.v twice and a constant, |P|^2, the
 * factor 1 + bias/r that it lacks, and N that is off with P. Proved: coherence.g (power), 6 of 8. */
#define COHERENCE_POWER 3

/* The relative rounding of A'.w/|w| by the inverse root and its products, 2^-this: 1 of 4. */
#define COHERENCE_FOOT 28

/* The error of A'.w/|w|: that of A'.w over d, |w|'s relative one, and COHERENCE_FOOT. Proved: coherence.g (length), 3
 * of 4. */
#define COHERENCE_LENGTH 2

/* ---- shadows between two samples, see coherence.c ---- */

/* The share, 1/this, by which w/|w| may turn more than the computed path/d, both accurate to 1/32, besides 2^-24 for
 * the quotient; not a logarithm. Unseen: small. */
#define COHERENCE_TURNING 16

/* The largest error of A'.w/|w|, 2^this, with which a shadow is decided: lengths of 2^30 and more do not matter, and
 * with bounds of 2^24 and 2^58 no sum overflows. With less, fewer pixels are drawn so. Unseen: choice. */
#define COHERENCE_LENGTH_MOST 24

/* The largest error of |A'|^2 - R^2, 2^this, with which a shadow is decided, chosen together with
 * COHERENCE_LENGTH_MOST. Unseen: choice. */
#define COHERENCE_POWER_MOST 58

/* The rounding of m, the largest change of the shadow ray's distance h, by two roundings: 1 of 1. Unseen: small. */
#define COHERENCE_SLIDE 0

/* The number of times that the error e of h^2 counts: at both samples and at a pixel between them; not a logarithm.
 * Proved: coherence.g (spare), 3 of 3. Unseen: small. */
#define COHERENCE_ERRORS 3

/* The number of times that the bound of A'.w/|w| counts: A'.w/|w| and |w| are off at a sample and at a pixel, 4 of 4;
 * not a logarithm. What SPAN_BEYOND says of pixels where A'.w equals |w|^2 holds here too. Unseen: hidden. */
#define COHERENCE_BEHIND 4

#endif
