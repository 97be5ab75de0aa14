# What the integer code adds to a cosine, 2^-26 in src/simd/span/bounds/levels.h: the value is at most 1, `scaled` is r N.w in the
# scale of render/span/span_light.c, whose last bit is at most 2^-29 of r |w|; tia_rsqrt's error (rsqrt.g), 2^-30 relative;
# num_mul_top rounds where the cosine times r 2^(46 - bits), at least 2^29, is whole; tia_reciprocal (reciprocal.g) is
# off by 1.02 2^-32 relative to at least 2^31, and num_lambert rounds to 2^-30.
cosine = (((l + a) * (1 + b) + c) * (1 + d) + f) - l;

# And the quotient, 2^-29 in bounds/depths.h: tia_reciprocal, and c with 32 bits.
quotient = (1 + d) * (1 + g) - 1;

{ l in [0,1] /\ a in [-1b-30,1b-30] /\ b in [-1b-30,1b-30] /\ c in [-1b-30,1b-30] /\ d in [-33b-36,33b-36]
  /\ f in [-1b-31,1b-31] /\ g in [-1b-32,1b-32]
  -> cosine in [-1b-26,1b-26] /\ quotient in [-1b-29,1b-29] }

cosine -> l * ((1 + b) * (1 + d) - 1) + a * ((1 + b) * (1 + d)) + c * (1 + d) + f;
