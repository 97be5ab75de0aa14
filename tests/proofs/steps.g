# The errors of src/render/span/steps, which steps_proved.h derives, in units of the last bit of a word of 32 bits.
#
# A mantissa of 32 bits is cut off by c, a reciprocal off by i, both relative. lambda is a quotient of two mantissas; r,
# p and lambda are mantissas; every product and sum is cut off. The sum of squares and the sum with r lambda are of
# positive terms; k and q are the first one's share.
lambda = (1 + c1) / (1 + c2) * (1 + i1) * (1 + c3);
rl = lambda * (1 + c4) * (1 + c5);
square = (1 + k * (rl * rl * (1 + c6) - 1) + (1 - k) * c7) * (1 + c8);
root = sqrt(square) * (1 + c9);
both = (1 + q * (root - 1) + (1 - q) * (rl - 1)) * (1 + c10);
away = (1 + c7) * (1 + i2) / both * (1 + c11);
facing = rl * away * (1 + c12);
# W: twice the largest u, which is below 2^30.1 units, has the error of r N.w; u is cut off to 2^-29 of it; the quotient
# by c, a mantissa and a reciprocal, has its own and is cut off.
word = (2 * (facing - 1) - u * 1b-29) * 1149300000 + 1149300000 * ((1 + c13) * (1 + i3) * (1 + c14) * (1 + c15) - 1) - v;
# steps_walk: 64 steps of g and of b, of which W b has 2^30.1/2^32; the first pixel's; and a product of steps_high.
coarse = 64 * (0.5 + 0.5 * w) + 0.51 + 0.51 * w + 3;
fine = 1 + 0.51 + 0.51 * w + 1;
# D: c to half a unit times v.v, below 2^31; b's accumulator; products of halves, 3 each, and their steps, 2^64 being a
# unit of 2^32; the upper word's cut. By K, of which 2^31/turned is the least: b^2 and c v.v.
depth = 0.25 + 1b-16 + (5 * 3 + 8 * 1b19) * 1b-32 + 1;
depth_turned = 2 * 2 * 0.51 * 1.02;
walked = 64 * 1 + 1b-9 * 2048 + 1b-9 * 64 + 0.05;
walked_up = 1b-9 * 2048 + 1b-9 * 64 + 0.05;
turned = 0.51 * (1 + 2 * w);
margin = 1 + 1 + 0.25 + 2;
halves = 3 * (1 + 1 + 0.25) + 2;
# Where u turns: l and omega S by what is cut off, by D's doubt and by K's, as shares of 2^32.
way = (0.125 + 3 * 0.25) + 1 + 0.5 * ((2 * 0.25 + 0.125 + 0.5) + 1);
way_depth = 2 * 0.125 + 0.25;
way_turned = 0.25 * 0.5 + 0.25 + 0.5 * (0.25 * 0.5 + 0.25 + 0.125 + 0.5 * 0.5);

{ c1 in [-1b-31,0] /\ c2 in [-1b-31,0] /\ c3 in [-1b-31,0] /\ c4 in [-1b-31,0] /\ c5 in [-1b-31,0] /\ c6 in [-1b-31,0]
  /\ c7 in [-1b-31,0] /\ c8 in [-1b-31,0] /\ c9 in [-1b-31,0] /\ c10 in [-1b-31,0] /\ c11 in [-1b-31,0]
  /\ c12 in [-1b-31,0] /\ c13 in [-1b-31,0] /\ c14 in [-1b-31,0] /\ c15 in [-1b-31,0]
  /\ i1 in [-17b-35,1b-33] /\ i2 in [-17b-35,1b-33] /\ i3 in [-17b-35,1b-33]
  /\ k in [0,1] /\ q in [0.5,1] /\ u in [0,1] /\ v in [0,1] /\ w in [0,0.27]
  -> word in [-STEPS_WORD,STEPS_WORD] /\ coarse <= STEPS_COARSE /\ fine <= STEPS_FINE /\ depth <= STEPS_DEPTH
  /\ depth_turned <= STEPS_DEPTH_TURNED /\ walked <= STEPS_WALKED /\ walked_up <= STEPS_WALKED_UP
  /\ turned <= STEPS_TURNED /\ margin <= STEPS_MARGIN /\ halves <= STEPS_HALVES_MARGIN
  /\ way <= STEPS_WAY /\ way_depth <= 1 /\ way_turned <= 1 }
