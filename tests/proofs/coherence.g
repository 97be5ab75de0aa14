# What src/render/span/coherence/coherence_proved.h says of sums of errors: p is the largest of the powers of two there, and each
# error a share of it.
#
# S = b + sqrt(D), in units of b's last bit. D is off by .51 of the last bits of b twice, of v.v and of c; the root, at
# least 31/32 of the computed one, which is at least 2^(B - 1), by that over itself and by one for rounding down, b by
# .51. S is at least .98 2^(S - 1). Over 2^(36 - B - S), with w = 2^B.
d = 0.51 * (1b32 + 1b32 + 1b31 + 2);
root = d * 2 * 32 / 31 + 1.51 * w;
sum = root / 0.49 / 1bCOHERENCE_ROOT;
# t, relative: S; half a bit of T, which is at least 2^(bits - 2); 2^-30 for the reciprocal and c, against 2^-28; with
# the products of these, which are below 2^-12 each.
inverse = 1b-30 / 1b-COHERENCE_INVERSE;
t = (sum * p1 + 0.5 * 1b1 * p2 + inverse * p3) * (1 + 1b-11);
# |P|^2: T/2 and .51 T^2. |Q - P|^2: .51 T, a constant and a shift, over twice T; T is at least 2^13.
reach = 0.5 * p1 + 0.51 * p2;
square = (0.51 + 1b-13) / 2 * p1 + p2;
# How t moves |Q - P|^2: 2.1 |w| |P| e. Two of them, each off by that and by what it is computed to.
moved = 2.1 / (1 * 1bCOHERENCE_MOVES);
turn = 2 * (p1 + moved * p2);
facing = (0.51 + 1b-13) * p1 + p2;
relative = p1 + moved * p2;
# lambert = r N.w/(r |w|), twice: r N.w; half of |w|^2's relative error, which is below 2^-5, with its second order, in
# units of half of its bound; and 2^-26 for products (simd_integer.g).
kernels = 1b-26 / 1b-COHERENCE_KERNELS;
lambert = 2 * (p1 * (1 + 1b-5) + (1 + 0.75 * 1b-5) * p2 + kernels * p3);
# A.w; |A'|^2 - R^2 of six errors; A'.w/|w|, |w| and the inverse root.
toward = (0.51 + 1b-13) * p1 + p2;
power = p1 + p2 + p3 + p4 + p5 + p6;
length = p1 + p2 + p3;
# Shadows between samples, with z^2 = e: (R + z + m)^2 would be more, and 2 m z <= m^2 + e.
spare = m * m + z * z - 2 * m * z;
# A path: half an arc, in chords. pi/4; and asin(x)/(2 x) at x = 1/4, whose series is below x + x^3/6 + x^5/10.
arc = 51 / 64 - 0.785398164;
short = 0.5 + 1 / 64 - 0.5 * (1 + x * x / 6 + x * x * x * x / 10);

{ w in [1b19,1b32] /\ p1 in [0,1] /\ p2 in [0,1] /\ p3 in [0,1] /\ p4 in [0,1] /\ p5 in [0,1] /\ p6 in [0,1]
  /\ m in [0,1b30] /\ z in [0,1b30] /\ x in [0,0.25]
  -> sum <= 0.55 /\ t <= 1bCOHERENCE_DEPTH /\ reach <= 1bCOHERENCE_REACH /\ square <= 1bCOHERENCE_SQUARE
  /\ moved <= 1 /\ turn <= 1bCOHERENCE_TURN /\ facing <= 1bCOHERENCE_FACING /\ relative <= 1bCOHERENCE_RELATIVE
  /\ lambert <= 1bCOHERENCE_LAMBERT /\ toward <= 1bCOHERENCE_TOWARD /\ power <= 1bCOHERENCE_POWER
  /\ length <= 1bCOHERENCE_LENGTH /\ spare >= 0 /\ arc >= 0 /\ short >= 0 }

spare -> (m - z) * (m - z);
