# Factors that bounds of samples have in src/simd/rays: emitters.h, look.h, ends.h, scatter.h, direction.h. Each is by
# how much a quotient's error is larger than its parts' errors, where the code has made sure that those are small.
#
# pi d^2/(A c): (1 + x)^2/(1 - y) - 1 is x and y times these, x = ed/d and y = ec/c
plane_x = (2 + x) / (1 - y);
plane_y = 1 / (1 - y);
# a cone's sine squared: 1/(1 - z)^2 - 1 is z times this, z = ed/d
cone = (2 - z) / ((1 - z) * (1 - z));
# 1 - cos of it, and a density, its inverse, within a part of it
open = 1 / (1 - part);
# reflectance over densities of which a 16th may be wrong, and the heuristic's weight, where it is a quarter
share = 1 / (1 - sixteenth);
weight = 1 / (1 - quarter);
# a direction around an axis, tangents and axis together
around = sqrt(14 + 14 + 1);

{ x in [0,0.125] /\ y in [0,0.125] /\ z in [0,0.03125] /\ part in [0,0.125] /\ sixteenth in [0,0.0625]
  /\ quarter in [0,0.25]
  -> plane_x in [0,2.43] /\ plane_y in [0,1.15]
  /\ cone in [0,2.1]
  /\ open in [0,1.15]
  /\ share in [0,1.125] /\ weight in [0,1.5]
  /\ around in [0,6] }
