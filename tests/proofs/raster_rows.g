# Where an edge crosses a row, src/raster/polygon_rows.c: -(y j + c)/x, in units of 2^-WALKER_BITS. Of dividend and divisor all
# after 64 bits is cut, and of the dividend one bit more (s, t, u); the reciprocal has an error of its own (r,
# wide_reciprocal.g), and the quotient is rounded down (a; b for the step). After 8191 steps:
relative = (1 - s) * (1 - u) * (1 + t) * (1 + r) - 1;
off = first * 1bWALKER_BITS * relative - a + n * (step * 1bWALKER_BITS * relative - b);
# A corner's place in the image, src/raster/polygon_box.c: q is a/w. The divisor's first 32 bits are x + c, 2^31 at least; the
# dividend in the same units is q (x + c), cut by b1; the reciprocal of x is 2^63/x (1 + i), (reciprocal.g: 1.02 of at least
# 2^31); the product is cut to 2^-32 (b2), and that times the size to 2^-16 of a pixel (b3).
cut = q * c / x * 1b32 - b1 / x * 1b32;
quotient = ((q * 1b32 + cut) * (1 + i) - b2) - q * 1b32;
place = quotient * size * 1b-17 - b3;

{ s in [0,1b-63] /\ u in [0,1b-62] /\ t in [0,129b-70] /\ r in [-1b-60,1b-60] /\ a in [0,1] /\ b in [0,1] /\ n in [0,8191]
  /\ first in [0,2bWALKER_FIRST] /\ step in [0,2bWALKER_STEP]
  /\ q in [0,1] /\ c in [0,1] /\ x in [1b31,1b32] /\ b1 in [0,1] /\ b2 in [0,1] /\ b3 in [0,1] /\ i in [-33b-36,33b-36]
  /\ size in [1,8192]
  -> off in [-WALKER_ERROR,WALKER_ERROR] /\ place in [-BOX_MARGIN,BOX_MARGIN] }

quotient -> q * 1b32 * i + cut * (1 + i) - b2 { x <> 0 };
relative -> ((1 - s) * (1 - u) - 1) * (1 + t) * (1 + r) + t + r + t * r;
(1 - s) * (1 - u) - 1 -> s * u - s - u;
