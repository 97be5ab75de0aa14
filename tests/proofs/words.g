# The errors of src/render/span/words, which words_proved.h derives.
#
# y is (1 + d)/sqrt(q), so that e = 1 - q y^2 is 1 - (1 + d)^2; as computed it is larger by c: y^2 and q y^2 are cut off,
# by a unit of 2^-26 each, as q is below 2^32. The step is y (1 + e/2) with y, at least 2^29, off by less than a unit.
e = 1 - (1 + d) * (1 + d);
next = (1 + d) * (1 + (e + c) / 2) - 1;
# The cosine of 2^28: f y is cut off to a unit of up to 2^29, and so is its product with 1/R, which is off by i.
cosine = 1b28 * ((1 + next - h) * (1 + i) - 1) - u - v;
# A form times t, without its accumulator's error: the word of the middle by t, that of the pixel's number by the step and
# the step's by the number, each by half a word; and two products. Where processors add products, their fraction is less
# than one of the units here.
form = a1 / 2 + a2 / 2 + a3 / 2 + a4 + a5;
# |w|^2: the constant, -2 Q.v with an accumulator off by .51 twice, and |P|^2 times a power of two.
square = b1 + 1.02 / 2 + form + b2;
# |P|^2: t^2 by half a word of v.v; v.v by one of t^2; the product.
reach = b1 / 2 + b2 + 0.51 + b3;
facing = b1 + 0.01 / 2 + form;
# The point: 1.05 |d|/|w|.
moved = 1.05 * 1b14;

{ d in [-1b-13,1b-13] /\ c in [0,2b-26] /\ h in [-1b-29,1b-29] /\ i in [-33b-36,33b-36]
  /\ u in [0,1] /\ v in [0,1]
  /\ a1 in [0,1] /\ a2 in [-1,1] /\ a3 in [-1,1] /\ a4 in [0,1] /\ a5 in [0,1] /\ b1 in [0,1] /\ b2 in [0,1] /\ b3 in [0,1]
  -> cosine in [-WORDS_COSINE,WORDS_COSINE] /\ square <= WORDS_SQUARE /\ reach <= WORDS_REACH /\ facing <= WORDS_FACING
  /\ moved <= SPAN_ERROR_WORDS }

next -> -1.5 * (d * d) - 0.5 * (d * d) * d + (1 + d) * c / 2;
