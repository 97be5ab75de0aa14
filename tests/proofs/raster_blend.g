# Values at a pixel, src/raster/blend.c: v = sum w a/sum w. Of each weight less than one of its last unit is cut (e), so
# with the sum u the quotient is off by (e1 (v - a1) + e2 (v - a2) + e3 (v - a3))/u; then it is cut to BLEND_BITS: top, 63
# bits of it (s), times the reciprocal of u (r, wide_reciprocal.g), rounded down (b).
sum = (e1 * (v - a1) + e2 * (v - a2) + e3 * (v - a3)) / u;
last = (1 - s) * (1 + r) - 1;
off = sum * 1bBLEND_BITS + (v + sum) * 1bBLEND_BITS * last - b;
# The exact sum's sign, in two parts: 2 a - 2 m + 1 is below 2^33 + 2, a weight below 2^RASTER_EDGE is 62 bits and a rest.
factor = 2 * a1 - 2 * m + 1;
low = w1 * factor1 + w2 * factor2 + w3 * factor3;
high = h1 * factor1 + h2 * factor2 + h3 * factor3;
# src/raster/distance.c: two numbers cut to 62 bits (c, d), their quotient (wide.h: 2^-59, and half a unit of 2^-60 of at
# least a half) and the last rounding, which is half a unit.
distance = (1 - c) / (1 - d) * (1 + q) * (1 + k) - 1;

{ v in [-1b31,1b31] /\ a1 in [-1b31,1b31] /\ a2 in [-1b31,1b31] /\ a3 in [-1b31,1b31] /\ e1 in [0,1] /\ e2 in [0,1]
  /\ e3 in [0,1] /\ u in [1bBLEND_LEAST,1b62] /\ s in [0,1b-62] /\ r in [-1b-60,1b-60] /\ b in [-1,1] /\ m in [-1b31,1b31]
  /\ |factor1| <= 9b30 /\ |factor2| <= 9b30 /\ |factor3| <= 9b30
  /\ w1 in [0,1b62] /\ w2 in [0,1b62] /\ w3 in [0,1b62]
  /\ |h1| <= 1b54 /\ |h2| <= 1b54 /\ |h3| <= 1b54
  /\ c in [0,1b-61] /\ d in [0,1b-61] /\ q in [-1b-59,1b-59] /\ k in [-1b-60,1b-60]
  -> off in [-BLEND_UNSURE,BLEND_UNSURE] /\ |factor| <= 9b30 /\ |low| <= 1b98 /\ |high| <= 1b98
  /\ |distance| <= 1b-DISTANCE_BITS }

last -> r - s - s * r;
distance -> ((1 - c) / (1 - d) - 1) * (1 + q) * (1 + k) + q + k + q * k { 1 - d <> 0 };
(1 - c) / (1 - d) - 1 -> (d - c) / (1 - d) { 1 - d <> 0 };
