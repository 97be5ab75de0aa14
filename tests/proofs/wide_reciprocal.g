# wide_reciprocal, z = 1/b where b is the fraction of 64 bits, 1/2 <= b < 1: its relative error is below 2^-60.
#
# y = z (1 + r): tia_reciprocal (reciprocal.g) of b's upper 32 bits, which drops less than 2^-32 of at least 1/2.
# e is 1 - b y = -r, rounded up by f; its square is that of e without g, and rounded down by h; k is the last floor, of a
# result that is at least z's half.
e = f - r;
square = (e - g) * (e - g) - h;
result = (1 + r) * (1 + e + square) - k - 1;

{ r in [-165b-38,165b-38] /\ f in [0,1b-62] /\ g in [0,1b-56] /\ h in [0,1b-62] /\ k in [0,1b-62]
  -> result in [-1b-60,1b-60] }

result -> r * r * r + (1 + r) * (f - h + (g - f) * (2 * r + g - f)) - k;
