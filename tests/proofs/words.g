# The errors of src/render/span/words, which words_proved.h derives.
#
# y is (1 + d)/sqrt(q), so that e = 1 - q y^2 is 1 - (1 + d)^2; as computed it is larger by c: y^2 and q y^2 are cut off,
# by a unit of 2^-26 each, as q is below 2^32. The step is y (1 + e/2) with y, at least 2^29, and its half cut off.
e = 1 - (1 + d) * (1 + d);
next = (1 + d) * (1 + (e + c) / 2) - 1;
# The cosine of 2^28: f y is cut off to a unit of up to 2^29, and so is its product with 1/R, which is off by i.
cosine = 1b28 * ((1 + next - h - k) * (1 + i) - 1) - u - v;
# |w|^2: the constant, the shifted |P|^2, and twice Q.v by half a word of t, with its product's last bit.
square = a1 + a2 + 2 * ((a3 + 0.51) / 2 + a4);
# |P|^2: t^2 by a word of v.v; v.v, doubled, by one of t^2; the product.
reach = a1 + 2 * (a2 + 0.51) + a3;
facing = a1 + (a2 + 0.01) / 2 + a3;
# The point: 1.05 |d|/|w|.
moved = 1.05 * 1b14;

{ d in [-1b-13,1b-13] /\ c in [0,2b-26] /\ h in [0,1b-29] /\ k in [0,1b-29] /\ i in [-33b-36,33b-36]
  /\ u in [0,1] /\ v in [0,1] /\ a1 in [0,1] /\ a2 in [0,1] /\ a3 in [0,1] /\ a4 in [0,1]
  -> cosine in [-WORDS_COSINE,WORDS_COSINE] /\ square <= WORDS_SQUARE /\ reach <= WORDS_REACH /\ facing <= WORDS_FACING
  /\ moved <= SPAN_ERROR_WORDS }

next -> -1.5 * (d * d) - 0.5 * (d * d) * d + (1 + d) * c / 2;
