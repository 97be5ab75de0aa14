# The filter of src/shadow/occluder.h. s = f/det: f cut to 62 bits (c), the reciprocal of det, of which all after 64 bits was cut
# (t), with its own error (r, wide_reciprocal.g), and the product cut to 2^60 at least (d); m cut to 62 bits (k).
s = (1 - c) * (1 + t) * (1 + r) * (1 - d) * (1 - k) - 1;
# m s, rounded down (a1), and shifted (a2); M.D, shifted (a3).
off = ms * s - a1 - a2 + a3;
# M.D = (x i + y j + c) 2^unit, each rounded down.
cut = b1 * i + b2 * j + b3;

{ c in [0,1b-61] /\ t in [0,129b-70] /\ r in [-1b-60,1b-60] /\ d in [0,1b-60] /\ k in [0,1b-61] /\ ms in [-1b62,1b62]
  /\ a1 in [0,1] /\ a2 in [0,1] /\ a3 in [0,1] /\ b1 in [0,1] /\ b2 in [0,1] /\ b3 in [0,1] /\ i in [0,8191] /\ j in [0,8191]
  -> off in [-OCCLUDER_UNSURE,OCCLUDER_UNSURE] /\ cut in [0,OCCLUDER_CUT] }

s -> (1 - c) * (1 - d) * (1 - k) * (t + r + t * r) + ((1 - c) * (1 - d) * (1 - k) - 1);
(1 - c) * (1 - d) * (1 - k) - 1 -> c * d - c - d - k * (1 - c) * (1 - d);
