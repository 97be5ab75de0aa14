# What doubles round by in src/simd/rays, as in simd_forms.g: a factor 1 + e, |e| <= u, for each rounding of a term. A
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
# a ray in a cylinder's axes: of three coordinates each the difference, the axis, a product and two sums, then two
# products and their sum across; of the direction's the axis, a product and two sums, then f^2, 1/f^2 and t
tube = 1.7321 * ((1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1) + 1.4143 * ((1 + e5) * (1 + e6) - 1);
tubed = 1.7321 * ((1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) - 1)
        + ((1 + e4) * (1 + e5) * (1 + e6) * (1 + e7) * (1 + e8) - 1);
# how far unit vectors are apart; a distance back in the world: see vector.h, instance.h
turned = sqrt(2 / (1 + sqrt(1 - relative * relative)));
scaled = 1 / (1 - ratio);

{ e0 in [-1b-53,1b-53] /\ e1 in [-1b-53,1b-53] /\ e2 in [-1b-53,1b-53] /\ e3 in [-1b-53,1b-53]
  /\ e4 in [-1b-53,1b-53] /\ e5 in [-1b-53,1b-53] /\ e6 in [-1b-53,1b-53] /\ e7 in [-1b-53,1b-53]
  /\ e8 in [-1b-53,1b-53]
  /\ relative in [0,0.0625] /\ ratio in [0,0.0625] /\ root in [-1.69e-16,1.69e-16]
  -> tca in [-SURE_ALONGb-53,SURE_ALONGb-53]
  /\ aside + along in [-SURE_ASIDEb-53,SURE_ASIDEb-53]
  /\ area in [-SURE_FACEb-53,SURE_FACEb-53]
  /\ way in [-SURE_WAYb-53,SURE_WAYb-53]
  /\ slab in [-SURE_SLABb-53,SURE_SLABb-53]
  /\ unit in [-SURE_NORMALb-53,SURE_NORMALb-53]
  /\ sqrt(1 + slab) - 1 in [-1.69e-16,1.69e-16]
  /\ tube in [-SURE_TUBEb-53,SURE_TUBEb-53] /\ tubed in [-SURE_TUBEb-53,SURE_TUBEb-53]
  /\ turned in [0,1.0009765625] /\ scaled in [0,1.07] }
