# What floats round by in src/simd/rays/pairs_tmpl.h, as in rays_forms.g, with |e| <= 2^-24; sizes are in units of (R + |M|) c.
#
# D.P + M.E of an edge: two conversions, a product, five sums; D.N of the whole: two conversions, a product, two sums
edge = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) * (1 + e6) * (1 + e7) - 1;
whole = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1;
# w2 = n - w0 - w1, off by rn, r0 and r1, is off by this: n - w0 is w1 + w2. N is rounded in doubles, too.
third = ((w1 + w2) * e8 + (rn + more - r0) * (1 + e8) - r1) * (1 + e9) + w2 * e9;
# Floats of the bound: by, size, their product, off, the sum
bound = (1 - SURE_SLABb-53) * (1 + 1b-21) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4);

{ e0 in [-1b-24,1b-24] /\ e1 in [-1b-24,1b-24] /\ e2 in [-1b-24,1b-24] /\ e3 in [-1b-24,1b-24]
  /\ e4 in [-1b-24,1b-24] /\ e5 in [-1b-24,1b-24] /\ e6 in [-1b-24,1b-24] /\ e7 in [-1b-24,1b-24]
  /\ e8 in [-1b-24,1b-24] /\ e9 in [-1b-24,1b-24] /\ w1 in [-1,1] /\ w2 in [-1,1] /\ more in [-1b-50,1b-50]
  /\ r0 in [-8193b-34,8193b-34] /\ r1 in [-8193b-34,8193b-34] /\ rn in [-5121b-34,5121b-34]
  -> edge in [-8193b-34,8193b-34] /\ whole in [-5121b-34,5121b-34] /\ third in [-SURE_PAIRb-24,SURE_PAIRb-24]
  /\ bound >= 1 }
