# The roundings of src/simd/span/exact.c and distance.h in doubles: a factor 1 + e for each, |e| <= u = 2^-53. Values are
# scaled so that the sizes to which errors are relative are 1.
#
# D: an upper half, and a lower one with a sign of at most half of its size; their sum, and the sum with what K - K0 adds.
d = ((1 - l) * (1 + e0) + l * (1 + e1)) * (1 + e2) * (1 + e3);
root = sqrt(d) * (1 + e4);
# b: the conversion of the integer and the difference. S: b has the share s, the root the rest.
sum = (s * ((1 + e5) * (1 + e6)) + (1 - s) * root) * (1 + e7);
# t from outside: c, c root, root sum, 1 over that and the product; from inside v.v, 2, and the quotient
outside = (1 + f0) * (1 + f1) * (1 + f2) * (1 + f3) / ((1 + f4) * sum) - 1;
inside = sum * (1 + f0) / ((1 + f1) * (1 + f2)) - 1;
# P: K and the product
point = (1 + e0) * (1 + e1) - 1;
# |w|^2: differences, squares and two sums; times h and the rounding of that difference
square = (1 + e0) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) - 1;
# the cosine: differences of both vectors, a product and two sums; 1/r, 1/|w| of a root, their product and the last
cosine = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * ((1 + e5) * (1 + e6) * (1 + e7) * (1 + f0) * (1 + f1)) - 1;
# A.w: differences, a product and two sums
toward = (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) - 1;
# h: S - 2 C, a product, two sums and c's
power = (1 + f0) * (1 + f1) * (1 + f2) * (1 + f3) * (1 + f4) - 1;

{ e0 in [-1b-53,1b-53] /\ e1 in [-1b-53,1b-53] /\ e2 in [-1b-53,1b-53] /\ e3 in [-1b-53,1b-53]
  /\ e4 in [-1b-53,1b-53] /\ e5 in [-1b-53,1b-53] /\ e6 in [-1b-53,1b-53] /\ e7 in [-1b-53,1b-53]
  /\ f0 in [-1b-53,1b-53] /\ f1 in [-1b-53,1b-53] /\ f2 in [-1b-53,1b-53] /\ f3 in [-1b-53,1b-53]
  /\ f4 in [-1b-53,1b-53] /\ l in [-1,0.34] /\ s in [0,1]
  -> d - 1 in [-6b-53,6b-53] /\ root - 1 in [-5b-53,5b-53] /\ sum - 1 in [-6b-53,6b-53]
  /\ outside in [-PIXEL_DISTANCEb-53,PIXEL_DISTANCEb-53] /\ inside in [-PIXEL_DISTANCEb-53,PIXEL_DISTANCEb-53]
  /\ point in [-PIXEL_POINTb-53,PIXEL_POINTb-53] /\ square in [-PIXEL_SQUAREb-53,PIXEL_SQUAREb-53]
  /\ cosine in [-PIXEL_COSINEb-53,PIXEL_COSINEb-53] /\ toward in [-PIXEL_TOWARDb-53,PIXEL_TOWARDb-53]
  /\ power in [-PIXEL_POWERb-53,PIXEL_POWERb-53] }

d - 1 -> ((1 - l) * e0 + l * e1) * ((1 + e2) * (1 + e3)) + ((1 + e2) * (1 + e3) - 1);
root - 1 -> (d - 1) / (sqrt(d) + 1) * (1 + e4) + e4;
sum - 1 -> (s * ((1 + e5) * (1 + e6) - 1) + (1 - s) * (root - 1)) * (1 + e7) + e7;
outside -> ((1 + f0) * (1 + f1) * (1 + f2) * (1 + f3) - 1 - ((1 + f4) * (1 + (sum - 1)) - 1)) / ((1 + f4) * (1 + (sum - 1)));
inside -> ((1 + (sum - 1)) * (1 + f0) - 1 - ((1 + f1) * (1 + f2) - 1)) / ((1 + f1) * (1 + f2));
$ s in 8;
