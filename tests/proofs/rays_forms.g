# What doubles round by in src/levels/rays, as in level_forms.g: a factor 1 + e, |e| <= u, for each rounding of a term. A
# sum's error is at most the largest factor's times the sum of its terms' sizes. Fused products round less often.
#
# L = C - O; L.D: a difference, a product, two sums
tca = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) - 1;
# P = L - D tca: what is of L, and what is of D tca, whose size is L's at most
aside = (1 + e0) * (1 + e1) - 1;
along = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) - 1;
# D.(A x B) + (O x D).(B - A) from a centre: O's difference, product and difference, product and five sums
area = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) * (1 + e6) * (1 + e7) * (1 + e8) - 1;
# (P - O).N and D.N: the normal's conversion, the difference, product and two sums
way = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1;
# (plane - O) (1/D): of t; a square's under a root
slab = (1 + e0) * (1 + e1) * (1 + e2) - 1;
# v/|v|: three squares' roundings under the root, the root, 1/x, the product
unit = (1 + e3) * (1 + e4) / ((1 + root) * (1 + e5)) - 1;
# how far unit vectors are apart; a distance back in the world; a root that moves: see vector.h, instance.h, round.h
turned = 1 / (1 - 0.5 * relative);
scaled = 1 / (1 - ratio);
moved = 1 / (1 + sqrt(1 - part));

{ e0 in [-1b-53,1b-53] /\ e1 in [-1b-53,1b-53] /\ e2 in [-1b-53,1b-53] /\ e3 in [-1b-53,1b-53]
  /\ e4 in [-1b-53,1b-53] /\ e5 in [-1b-53,1b-53] /\ e6 in [-1b-53,1b-53] /\ e7 in [-1b-53,1b-53]
  /\ e8 in [-1b-53,1b-53]
  /\ relative in [0,0.0625] /\ ratio in [0,0.0625] /\ part in [0,0.25] /\ root in [-1.69e-16,1.69e-16]
  -> tca in [-SURE_ALONGb-53,SURE_ALONGb-53]
  /\ aside + along in [-SURE_ASIDEb-53,SURE_ASIDEb-53]
  /\ area in [-SURE_FACEb-53,SURE_FACEb-53]
  /\ way in [-SURE_WAYb-53,SURE_WAYb-53]
  /\ slab in [-SURE_SLABb-53,SURE_SLABb-53]
  /\ unit in [-SURE_NORMALb-53,SURE_NORMALb-53]
  /\ sqrt(1 + slab) - 1 in [-1.69e-16,1.69e-16]
  /\ turned in [0,1.0625] /\ scaled in [0,1.07] /\ 0.5 * moved in [0,0.27] }
