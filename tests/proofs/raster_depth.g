# The filter of src/raster/depth.h. Exact nearness is z = f/2^cut (2^cut 2^scale/det) = c p, from 0 to 2^62 and a unit, with
# p <= 1 as 2^cut <= det/2^scale. What is computed:
# f/2^cut rounded down by a; times the reciprocal of det, of which all after 64 bits was cut (t) and which has an error of
# its own (r, wide_reciprocal.g); shifted, that is rounded down by b.
relative = (1 + r) * (1 + t) - 1;
first = z * relative - a * p * (1 + r) * (1 + t) - b;
# A step s, as much smaller; n of them, together no farther than from one end to the other: n s is y.
stepped = y * relative - n * (d * p * (1 + r) * (1 + t)) - n * e;
off = first + stepped;

{ r in [-1b-60,1b-60] /\ t in [0,129b-70] /\ z in [0,1b62] /\ y in [-1b62,1b62] /\ p in [0,1] /\ n in [0,8191]
  /\ a in [0,1] /\ b in [0,1] /\ d in [0,1] /\ e in [0,1]
  -> off in [-DEPTH_ERROR,DEPTH_ERROR] }

relative -> r + t + r * t;
