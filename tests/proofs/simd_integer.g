# The rounding of a cosine in the integer code, SPAN_ERROR_KERNELS of span_proved.h: the value is at most 1, `scaled` is r N.w in the
# scale of render/span/span_light.c, whose last bit is at most 2^-29 of r |w|; tia_rsqrt's error (rsqrt.g), 2^-30 relative;
# num_mul_top rounds where the cosine times r 2^(46 - bits), at least 2^29, is whole; tia_reciprocal (reciprocal.g) is
# off by 1.02 2^-32 relative to at least 2^31, and num_lambert rounds to 2^-30.
cosine = (((l + a) * (1 + b) + c) * (1 + d) + f) - l;

{ l in [0,1] /\ a in [-1b-30,1b-30] /\ b in [-1b-30,1b-30] /\ c in [-1b-30,1b-30] /\ d in [-33b-36,33b-36]
  /\ f in [-1b-31,1b-31]
  -> cosine in [-SPAN_ERROR_KERNELS,SPAN_ERROR_KERNELS] }

cosine -> l * ((1 + b) * (1 + d) - 1) + a * ((1 + b) * (1 + d)) + c * (1 + d) + f;
