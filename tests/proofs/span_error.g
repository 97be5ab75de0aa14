# The errors of the integers that src/render/span/span_proved.h derives. The name of a row stands for its factor, 2 to the
# power of the row's 256ths. Each error is relative to what span_error.c multiplies by the factor.
#
# From outside, in units of b's last bit. D is off by .51 of the last bits of b twice, of v.v and of c; the root by half
# of that over itself, as it is within 1/32, and by one for rounding down; S is within .02.
d = 0.51 * (1b32 + 1b32 + 1b31 + 2);
root = d / 2 * 32 / 31 * 1.02;
sum = (0.51 + 1) * 1.02;
# K, off by .51 of its last bit: D by twice .51 b r and by .51/K of itself twice; b by .51 of L.z; P across the ray and
# the root, at most S, by .51/K.
turned_root = 2 * 0.51 / 2 * 32 / 31;
turned_sum = 0.51 * 1.02;
turned = 0.51 + 0.51;
# Half a bit of T, at least half of its value at an end; the reciprocal of S, c, and half a bit of 2^31; t S at an end.
rounded = 0.5 * 2;
inverse = (1 + f) * (1 + g) - 1 + u;
mantissa = 1 + 1b-5;
# From inside, as a part of 2^31, over v.v 2^t_shift: times 2^(63 - 31).
inside_root = d / 2 * 32 / 31 * 1b32;
inside_turned = 0.51 * 1.04 * 1b31 * 1b32;
inside_sum = 0.51 * 1b32;
inside_units = (0.51 + 1) * 1b32;
inside_square = 0.51;
# Products with T, at least 2^13, and half bits of constants and shifts.
reach = 0.5;
reach_square = 0.51;
square = 2 * 0.51 + (0.5 + 0.5) * h;
facing = 0.51 + 0.5 * h;
toward = 0.51 + (0.5 + 0.5 + 0.5) * h;
power = 2 * 0.51 + (0.5 + 0.5) * h;
# A point moved by d, which is less than a 20th of w and of A: |w - d|^2 and |A - d|^2, (A - d).(w - d), and N's part of
# |A'|^2.
moved = 2 + m;
toward_moved = 1 + m;
power_moved = 2 + m + 0.25;
# |w|^2 is within 1/32 of its value: 1 + e, whose root is s. The cosine is (l + a)/s, a being the error of r N.w.
distance = 1 / (1 - 1b-5);
s = sqrt(1 + e);
cosine = 1 / s;
half = 2 / (s * (1 + s));
# The bias: 2^-13 of the cosine's error, with its products' roundings.
bias = 1b-13 * (1 + k);
# bias/(r + bias), at most 1/7, of three terms' half bits, as a quotient by r - bias and by itself.
apart = 1.5 * 1b-30 * 1.15 * 1b-13;
apart_units = 1.5 * 1b-30 / 7;

{ f in [-33b-36,33b-36] /\ g in [-1b-32,1b-32] /\ u in [-1b-32,1b-32] /\ h in [0,1b-13] /\ m in [0,0.1] /\ e in [-1b-5,1b-5]
  /\ k in [0,0.05]
  -> root <= SPAN_ERROR_ROOT /\ sum <= SPAN_ERROR_SUM /\ turned_root <= SPAN_ERROR_TURNED_ROOT
  /\ turned_sum <= SPAN_ERROR_TURNED_SUM /\ turned <= SPAN_ERROR_TURNED /\ rounded <= SPAN_ERROR_ROUNDED
  /\ inverse in [-SPAN_ERROR_INVERSE,SPAN_ERROR_INVERSE] /\ mantissa <= SPAN_ERROR_MANTISSA /\ inside_root <= SPAN_ERROR_INSIDE_ROOT
  /\ inside_turned <= SPAN_ERROR_INSIDE_TURNED /\ inside_sum <= SPAN_ERROR_INSIDE_SUM
  /\ inside_units <= SPAN_ERROR_INSIDE_UNITS /\ inside_square <= SPAN_ERROR_INSIDE_SQUARE
  /\ reach <= SPAN_ERROR_REACH /\ reach_square <= SPAN_ERROR_REACH_SQUARE /\ square <= SPAN_ERROR_SQUARE
  /\ facing <= SPAN_ERROR_FACING /\ toward <= SPAN_ERROR_TOWARD /\ power <= SPAN_ERROR_POWER
  /\ moved <= SPAN_ERROR_MOVED /\ toward_moved <= SPAN_ERROR_TOWARD_MOVED /\ power_moved <= SPAN_ERROR_POWER_MOVED
  /\ distance <= SPAN_ERROR_DISTANCE /\ cosine <= SPAN_ERROR_COSINE /\ half <= SPAN_ERROR_COSINE
  /\ bias <= SPAN_ERROR_BIAS /\ apart <= SPAN_ERROR_APART /\ apart_units <= SPAN_ERROR_APART_UNITS }

$ e in 16;
