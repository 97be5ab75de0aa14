# The factors of src/simd/span/cells_tmpl.h. e0 to e9 are roundings, `root` and `inverse` those of the estimates (simd_newton.g).
#
# D', halved, of which x may be a pixel, or an eighth of 8 pixels, outside of the run: a coefficient, a product and a sum.
slope = ((1 + e0) * (1 + e1) * (1 + e2) - 1) * 0.5 * 1.125;
# D'/(2 sqrt(D)) plus b1: D is off by 8 units of its size, which is at most 2^11 D / .98; h is half of that, relative, with
# its second order. Two roundings; the part that is added to |S'| for it is rounded as well.
part = ((1 + h) * (1 + root) * (1 + e0) * (1 + e1) - 1) / 0.875;
first = ((1 + e0) * (1 + e1) - 1) / 0.875;
spare = (1 + h) * (1 + root) * (1 + e0) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5);
# |P'| and |P''|: 1/S up to three times, and products; S'' has 1/sqrt(D) three times and 1.01 from bounds/cells.h.
motion = CELL_MOTION * 0.001 * (1 + inverse) * (1 + inverse) * (1 + inverse) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3)
       * (1 + e4) * (1 + e5) * (1 + e6) * (1 + e7) * (1 + e8) * (1 + e9);
bend = 1.01 * (1 + root) * (1 + root) * (1 + root) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4);
# |w| = sqrt(|w|^2 s^2)/S c: |w|^2 within .019, so its root within .0096; 1/S within .01.
far = (1 + w) * t * (1 + root) * (1 + inverse) * (1 + e0) * (1 + e1) * (1 + e2);
nearest = far * (1 - CELL_FAR * 0.001) * (1 + e3) * (1 + e4);
farthest = far * (1 + CELL_FAR * 0.001) * (1 + e3) * (1 + e4);
# What a shadow's edge keeps clear of: sums of what is not negative, 1/|w| once; and what a line is off by: 1/|w| twice.
clear = CELL_UNIT * 0.001 * (1 + inverse) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5) * (1 + e6)
      * (1 + e7) * (1 + e8) * (1 + e9);
off = CELL_OFF * 0.001 * (1 + inverse) * (1 + inverse) * (1 + e0) * (1 + e1) * (1 + e2) * (1 + e3) * (1 + e4) * (1 + e5)
    * (1 + e6) * (1 + e7) * (1 + e8) * (1 + e9);
# (a sqrt(4 - 3 a^2))^2, a^2 from 0 to 1.
pull = a2 * (4 - 3 * a2);
over = pull - CELL_BEND * CELL_BEND * 0.000001;

{ e0 in [-1b-24,1b-24] /\ e1 in [-1b-24,1b-24] /\ e2 in [-1b-24,1b-24] /\ e3 in [-1b-24,1b-24]
  /\ e4 in [-1b-24,1b-24] /\ e5 in [-1b-24,1b-24] /\ e6 in [-1b-24,1b-24] /\ e7 in [-1b-24,1b-24]
  /\ e8 in [-1b-24,1b-24] /\ e9 in [-1b-24,1b-24] /\ h in [-9b-14,9b-14] /\ w in [-0.0096,0.0096] /\ t in [0.99,1.0102]
  /\ root in [-SIMD_ROOTb-24,SIMD_ROOTb-24] /\ inverse in [-SIMD_INVERSEb-24,SIMD_INVERSEb-24] /\ a2 in [0,1]
  -> slope in [-CELL_SLOPEb-24,CELL_SLOPEb-24] /\ part in [-1b-CELL_TURN,1b-CELL_TURN] /\ first in [-1b-CELL_TURN,1b-CELL_TURN]
  /\ spare >= 0.875 /\ motion >= 1 /\ bend >= 1 /\ nearest <= 1 /\ farthest >= 1 /\ clear >= 1 /\ off >= 1
  /\ over <= 0 }

pull -> 4 / 3 - 3 * ((a2 - 2 / 3) * (a2 - 2 / 3));
