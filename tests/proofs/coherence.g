# The sums of errors in src/render/span/coherence/coherence_proved.h. Each error is a share, p1 to p6, of the largest
# power of two in the sum.
#
# How t moves |Q - P|^2: 2.1 |w| |P| e. Two of them, each off by that and by what it is computed to.
moved = 2.1 / (1 * 1bCOHERENCE_MOVES);
turn = 2 * (p1 + moved * p2);
# A.w; |A'|^2 - R^2 of six errors; A'.w/|w|, |w| and the inverse root.
toward = (0.51 + 1b-13) * p1 + p2;
power = p1 + p2 + p3 + p4 + p5 + p6;
length = p1 + p2 + p3;
# Shadows between samples, with z^2 = e: (R + z + m)^2 would be more, and 2 m z <= m^2 + e.
spare = m * m + z * z - 2 * m * z;
# A path: half an arc, in chords. pi/4; and asin(x)/(2 x) at x = 1/4, whose series is below x + x^3/6 + x^5/10.
arc = 51 / 64 - 0.785398164;
short = 0.5 + 1 / 64 - 0.5 * (1 + x * x / 6 + x * x * x * x / 10);

{ p1 in [0,1] /\ p2 in [0,1] /\ p3 in [0,1] /\ p4 in [0,1] /\ p5 in [0,1] /\ p6 in [0,1]
  /\ m in [0,1b30] /\ z in [0,1b30] /\ x in [0,0.25]
  -> moved <= 1 /\ turn <= 1bCOHERENCE_TURN /\ toward <= 1bCOHERENCE_TOWARD /\ power <= 1bCOHERENCE_POWER
  /\ length <= 1bCOHERENCE_LENGTH /\ spare >= 0 /\ arc >= 0 /\ short >= 0 }

spare -> (m - z) * (m - z);
