/* coherence_proved.h - the bounds of a run's fixed-point errors by name, each with its derivation.
 *
 * A bound is the binary logarithm of a power of two, unless its row says otherwise. A sum of up to four terms is
 * bounded by four times its largest term. This is coarse by a few bits, which costs next to nothing: a level is 2^-6,
 * and the errors are near 2^-20. A row is the number that is added for such a sum, or the constant part of one of its
 * terms. tests/proofs/coherence.g reads the numbers here and proves the sums. simd/bound.h explains "Unseen" and "1 of
 * 2"; tests/quick/bounds and tests/bounds check these rows, too.
 *
 * T is the mantissa of t, below 2^31. An accumulator's upper half is off by up to .51 of its last bit, and its product
 * with T by .51 T last bits of the product. Constants and shifted values are off by half a bit.
 *
 * As t has a relative error e, the integer code computes the light at the point P (1 + e), |e| < 2^bounds.t. This
 * changes |Q - P|^2 by up to 2.1 |w| |P| e; r N.w, which is computed as c - L.Q + G.P, by |G| |P| e; A.w by 1.1 (|A| +
 * |w|) |P| e; and |A|^2 by 2.1 |A| |P| e.
 *
 * A build that defines BOUND_SCALES multiplies each bound by a factor for its name, see simd/bound.h. */
#ifndef TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H
#define TIA_RENDER_SPAN_COHERENCE_COHERENCE_PROVED_H

/* COHERENCE_BITS(NAME): the logarithm of a bound; COHERENCE_BELOW(NAME): that of 2^-NAME; COHERENCE_WIDE(NAME, x): x,
 * where x is the bound itself. */
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

/* The largest relative error of t, 2^(this - 32), with which a run is drawn. With a smaller one, fewer runs are drawn.
 * Unseen: choice. */
#define COHERENCE_KNOWN 20

/* The rounding of |v|, a root that is rounded down. 1 of 1. Unseen: small. */
#define COHERENCE_VIEW 0

/* ---- light ---- */

/* The error of |Q - P|^2 that the error of t causes: 2.1 |Q - P| |P| times t's relative error. 2.1 of 4. */
#define COHERENCE_MOVES 2

/* The error of the difference of two values of |Q - P|^2, each off by COHERENCE_MOVES and COHERENCE_SQUARE. Proved:
 * coherence.g (turn), 3.1 of 4. */
#define COHERENCE_TURN 2

/* The lower limit of |Q - P|^2, 2^(bits - this), where its computed value has `bits` bits. The computed value is at
 * least 2^(bits - 1), and accurate to 1/32. 1.03 of 2. */
#define COHERENCE_DISTANCE 2

/* Shadows between two samples are searched only where the error of lambert is below 1/this (not a logarithm). A choice:
 * with larger errors almost nothing is decided. Unseen: choice. */
#define COHERENCE_COARSE 64

/* ---- paths ---- */

/* The error of the difference of t at two samples, each off by 2^bounds.t T. 2 of 4. Unseen: small. */
#define COHERENCE_STEP 2

/* The rounding of a chord between two samples by two shifts, of which the second is doubled. 1.5 of 4. Unseen:
 * small. */
#define COHERENCE_SHIFTS 2

/* An upper limit of half of an arc with this chord (not a logarithm). An arc of less than half a circle is at most pi/2
 * times its chord. Proved: coherence.g (arc), .786 of .796. */
#define COHERENCE_ARC(chord) ((chord) - (chord) / 8 - (chord) / 16 - (chord) / 64)

/* An upper limit of half of an arc, like COHERENCE_ARC, where the chord is at most a quarter of the circle's diameter:
 * half of the chord and 1.1 % of that. Proved: coherence.g (short), .506 of .515; the quotients are rounded down, 1 of
 * 2. */
#define COHERENCE_SHORT(chord) ((chord) / 2 + (chord) / 64 + num_bound(1))

/* The error of a run's chord, the distance of its end points along x alone, that the errors of t cause: 2^bounds.t |P|
 * at each end. 2 of 4. Unseen: small. */
#define COHERENCE_ENDS 2

/* The rounding of a run's chord by two shifts: 1 of 2. Unseen: small. */
#define COHERENCE_ENDS_SHIFTS 1

/* ---- shadows at a pixel ---- */

/* The rounding of R when it is shifted to the run's exponent: .5 of 1. Unseen: small. */
#define COHERENCE_RADIUS 0

/* The rounding of twice the bias when it is shifted to the run's exponent: .5 of 1. Unseen: small. */
#define COHERENCE_BIAS 0

/* The rounding of |C - Q|, a root with the exponent 15: one last bit, as it is rounded down, and half of the last bit
 * after the shift to the run's exponent. 1.5 of 2. Unseen: small. */
#define COHERENCE_AWAY 1

/* The error of A.w without that of t, which the path includes: .51 T for t (C + Q).v, half a bit for the constant, and
 * the error of |P|^2. Proved: coherence.g (toward), 1.6 of 2. */
#define COHERENCE_TOWARD 1

/* The error of |L - C|^2 - r^2 - R^2 times bias/(r + bias): 2^-this of the first factor's size times bias/r. Counted as
 * in SPAN_SWELL of simd/span/bounds/shadows.h: 1.5 of 16. Unseen: small. */
#define COHERENCE_APART 26

/* The rounding of the first factor of COHERENCE_APART, which has the exponent 30: 2^-this, 1.5 of 8. Unseen: small. */
#define COHERENCE_APART_UNITS 27

/* The error of |A'|^2 - R^2: COHERENCE_APART and COHERENCE_APART_UNITS; .51 T twice for t C.v, and half a bit for the
 * constant; the error of |P|^2; the omitted factor 1 + bias/r; and the error of N, which is off with P. Proved:
 * coherence.g (power), 6 of 8. */
#define COHERENCE_POWER 3

/* The relative rounding of A'.w/|w| by the inverse root and the products with it, 2^-this: 1 of 4. */
#define COHERENCE_FOOT 28

/* The error of A'.w/|w|: the error of A'.w over d, the relative error of |w|, and COHERENCE_FOOT. Proved: coherence.g
 * (length), 3 of 4. */
#define COHERENCE_LENGTH 2

/* ---- shadows between two samples, see coherence.c ---- */

/* The share, 1/this, by which the turn of w/|w| may exceed the computed path/d (not a logarithm). `path` and d are
 * accurate to 1/32 each; 2^-24 for the quotient is added separately. Unseen: small. */
#define COHERENCE_TURNING 16

/* The largest error of A'.w/|w|, 2^this, with which a shadow is decided: lengths that matter are below 2^30, and with
 * this bound and COHERENCE_POWER_MOST no sum overflows. With a smaller one, fewer pixels are decided. Unseen:
 * choice. */
#define COHERENCE_LENGTH_MOST 24

/* The largest error of |A'|^2 - R^2, 2^this, with which a shadow is decided, chosen together with
 * COHERENCE_LENGTH_MOST. Unseen: choice. */
#define COHERENCE_POWER_MOST 58

/* The rounding of m, the largest change of the shadow ray's distance h: two roundings, 1 of 1. Unseen: small. */
#define COHERENCE_SLIDE 0

/* The number of times that the error e of h^2 counts (not a logarithm): at a sample, at a pixel, and in 2 m sqrt(e) <=
 * m^2 + e, see coherence.c. Proved: coherence.g (spare), 3 of 3. Unseen: small. */
#define COHERENCE_ERRORS 3

/* The number of times that the bound of A'.w/|w| counts (not a logarithm): for A'.w/|w| and for |w|, at a sample and at
 * a pixel. 4 of 4. Where A'.w equals |w|^2, h gives the same verdict, as in SPAN_BEYOND. Unseen: hidden. */
#define COHERENCE_BEHIND 4

#endif
