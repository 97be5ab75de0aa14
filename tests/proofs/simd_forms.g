# The sums of src/simd, with a factor 1 + e, |e| <= u, for each rounding (the standard model; the float of NEON on ARMv7
# takes what is below 2^-126 for 0, which is far below what counts). x is a whole number below 2^13, or that and a half:
# exact. A sum's error is at most the largest factor's times the sum of its terms' sizes.
#
# linear: (c0 (1 + e0) + c1 x (1 + e1) (1 + e2)) (1 + e3)
linear0 = (1 + e0) * (1 + e3) - 1;
linear1 = (1 + e1) * (1 + e2) * (1 + e3) - 1;
# quadratic: ((d2 x + d1) x + d0), coefficients, two products and two sums
quadratic2 = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1;
quadratic1 = (1 + e0) * (1 + e2) * (1 + e3) * (1 + e4) - 1;
# b + sqrt(D): sqrt(D) is at most half of the sum, as b^2 = D + c v.v. From an estimate it is x/sqrt(x), good for r.
sum = (half * (1 + r) * (1 + e0) + (1 - half)) * (1 + e1) - 1;
# a s^2: coefficient, two products and two sums, and a's own two roundings in double; h s: linear, sum, product, sum
term2 = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) - 1;
term1 = (1 + l) * (1 + e1) * (1 + e2) * (1 + e3) - 1;
term0 = (1 + q) * (1 + e3) - 1;
# K s + G.v: coefficient, product, sum; linear, sum
facing = (1 + e0) * (1 + e1) * (1 + e2) - 1;
turn = (1 + l) * (1 + e2) - 1;
# times 1/r, rounded, and 1/sqrt; two products
lambert = (1 + e0) * (1 + e1) * (1 + e2) * (1 + r) - 1;
# lambert, at most 1, times tint and colour (rounded), added to a sum of at most 1; a caster: colour, product
colour = (1 + e0) * (1 + e1) * (1 + e2) - 1;
colour_sum = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) - 1;
caster = (1 + e0) * (1 + e1) - 1;
# two lines that meet in the middle of three samples, m + t (e - s)/2 + a ((s - m) + (e - m))/2 with a = |t|, whole eighths:
# three differences and a sum, two products and two sums
lines = (m + t * ((end - start) * (1 + e0) * 0.5) * (1 + e4)) * (1 + e5);
bent = (((start - m) * (1 + e1) + (end - m) * (1 + e2)) * (1 + e3)) * 0.5;
between = (lines + a * bent * (1 + e6)) * (1 + e7);
exactly = (m + t * ((end - start) * 0.5)) + a * (((start - m) + (end - m)) * 0.5);
line = between - exactly;
# (A'.w)^2: a product and the difference; |w|^2 k (1 + B): coefficient, two products, the difference
delta0 = (1 + e0) * (1 + e1) - 1;
delta1 = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) - 1;

{ e0 in [-1b-24,1b-24] /\ e1 in [-1b-24,1b-24] /\ e2 in [-1b-24,1b-24] /\ e3 in [-1b-24,1b-24]
  /\ e4 in [-1b-24,1b-24] /\ e5 in [-1b-24,1b-24] /\ e6 in [-1b-24,1b-24] /\ e7 in [-1b-24,1b-24]
  /\ start in [-1.01,1.01] /\ m in [-1.01,1.01] /\ end in [-1.01,1.01] /\ t in [-1,1] /\ a in [0,1] /\ half in [0,0.5] /\ r in [-SIMD_ROOTb-24,SIMD_ROOTb-24]
  /\ l in [-SIMD_LINEARb-24,SIMD_LINEARb-24] /\ q in [-6b-24,6b-24]
  -> linear0 in [-SIMD_LINEARb-24,SIMD_LINEARb-24] /\ linear1 in [-SIMD_LINEARb-24,SIMD_LINEARb-24]
  /\ quadratic2 in [-6b-24,6b-24] /\ quadratic1 in [-6b-24,6b-24]
  /\ quadratic2 in [-SIMD_QUADRATICb-24,SIMD_QUADRATICb-24]
  /\ sum in [-SIMD_SUMb-24,SIMD_SUMb-24]
  /\ term2 in [-SIMD_TERMb-24,SIMD_TERMb-24] /\ term1 in [-SIMD_TERMb-24,SIMD_TERMb-24]
  /\ term0 in [-SIMD_TERMb-24,SIMD_TERMb-24]
  /\ facing in [-SIMD_FACINGb-24,SIMD_FACINGb-24] /\ turn in [-SIMD_TURNb-24,SIMD_TURNb-24]
  /\ lambert in [-SIMD_LAMBERTb-24,SIMD_LAMBERTb-24]
  /\ colour in [-SIMD_COLOURb-24,SIMD_COLOURb-24] /\ colour_sum in [-SIMD_COLOURb-24,SIMD_COLOURb-24]
  /\ caster in [-SIMD_COLOURb-24,SIMD_COLOURb-24]
  /\ line in [-SIMD_LINEb-24,SIMD_LINEb-24]
  /\ delta0 in [-SIMD_DELTAb-24,SIMD_DELTAb-24] /\ delta1 in [-SIMD_DELTAb-24,SIMD_DELTAb-24] }

sum -> half * ((1 + r) * (1 + e0) - 1) * (1 + e1) + e1;
line -> t * ((end - start) * e0 * 0.5) * (1 + e4) * (1 + e5) * (1 + e7) + t * ((end - start) * 0.5) * e4 * (1 + e5) * (1 + e7)
        + (m + t * ((end - start) * 0.5)) * e5 * (1 + e7)
        + a * (((start - m) * e1 + (end - m) * e2) * (1 + e3) * 0.5) * (1 + e6) * (1 + e7)
        + a * (((start - m) + (end - m)) * e3 * 0.5) * (1 + e6) * (1 + e7)
        + a * (((start - m) + (end - m)) * 0.5) * e6 * (1 + e7) + exactly * e7;
