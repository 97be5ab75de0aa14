# A Newton step for 1/sqrt(x) and for 1/x in float: y (3/2 - x y^2/2) and y (2 - x y), from an estimate off by e: that of
# rsqrtps and rcpps errs by less than 1.5 2^-12, those with 14 bits by 2^-14, and NEON's, of 8 bits, by less than 2^-8,
# after the first of its two steps by 1.5 2^-16 and the roundings: below 1.5 2^-12 too. Factors as in simd_forms.g;
# x y^2 is 1 + g with g = (1 + e)^2 - 1. (The steps of NEON and of FMA round less often.)
g = (1 + e) * (1 + e) - 1;
t = (1 + g) * (1 + e0) * (1 + e1);              # (x y) y
h = 1.5 - 0.5 * t;                              # .5 t is exact
root = (1 + e) * h * (1 + e2) * (1 + e3) - 1;
p = (1 + e) * (1 + e0);                         # x y
inverse = (1 + e) * (2 - p) * (1 + e2) * (1 + e3) - 1;

{ e in [-3b-13,3b-13] /\ e0 in [-1b-24,1b-24] /\ e1 in [-1b-24,1b-24] /\ e2 in [-1b-24,1b-24]
  /\ e3 in [-1b-24,1b-24]
  -> root in [-SIMD_ROOTb-24,SIMD_ROOTb-24] /\ inverse in [-SIMD_INVERSEb-24,SIMD_INVERSEb-24] }

root -> (((1 + e) * (1.5 - 0.5 * ((1 + e) * (1 + e))) - 1) + (1 + e) * (h - (1.5 - 0.5 * ((1 + e) * (1 + e)))))
        * ((1 + e2) * (1 + e3)) + ((1 + e2) * (1 + e3) - 1);
(1 + e) * (1.5 - 0.5 * ((1 + e) * (1 + e))) - 1 -> 0 - e * e * (1.5 + 0.5 * e);
h - (1.5 - 0.5 * ((1 + e) * (1 + e))) -> 0 - 0.5 * ((1 + e) * (1 + e)) * ((1 + e0) * (1 + e1) - 1);
inverse -> (((1 + e) * (1 - e) - 1) - (1 + e) * (1 + e) * e0) * ((1 + e2) * (1 + e3)) + ((1 + e2) * (1 + e3) - 1);
(1 + e) * (1 - e) - 1 -> 0 - e * e;
