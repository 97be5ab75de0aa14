# The cells of src/shadow/technique_map_exact.c.
#
# What is seen, t D: w is t D.w (raster_blend.g: a relative error e, and half of its last unit, which is 2^(40 + SEEN_BITS
# - 45) places at most: h); u = D.x/D.w, at most 1 in the image, has 60 bits (wide.h: f, and g for the rounding). The product is rounded (k).
h = hh * 1b-6;
seen = w * ((1 + e) * (1 + f) - 1) * u + w * (1 + e) * g + h * (u * (1 + f) + g) + k;
# The view of a point: q = a/s, s the largest coordinate, at least 2^CELL_NEAR and both off as above; in units of 2^-28
# (l for the quotient, n for its rounding). A cell's centre is half a cell from what is filed there.
point = (o1 - q * o2) / (s + o2) * 1b28 + (q + 0.1) * 1b28 * l + n;
centre = point * 1bCELL_BITS * 1b-29 + 0.5;
# Across a direction, where x is the axis: a - x slope, the slope rounded (m), the product and the last shift as well; v is
# 2^shift, at most 1. A corner's place is exact, that of what is seen is not.
across = (x * m + n1) * v + n2;
filed = (o1 - o2 * slope + x * m + n1) * v + n2;
beside = (filed - corner) * 1bCELL_BITS * 1b-29 + 0.5;
# Twice a triangle's area, where corners are off: dx1 dy2 - dy1 dx2.
area = (dx1 * z1 + z2 * dy2 + z2 * z1) - (dy1 * z3 + z4 * dx2 + z4 * z3);

{ w in [0,1bSEEN_FAR] /\ e in [-1b-DISTANCE_BITS,1b-DISTANCE_BITS] /\ f in [-1b-59,1b-59] /\ g in [-1b-61,1b-61]
  /\ hh in [-1bSEEN_BITS,1bSEEN_BITS] /\ u in [-1,1] /\ k in [-0.5,0.5]
  /\ o1 in [-SEEN_OFF,SEEN_OFF] /\ o2 in [-SEEN_OFF,SEEN_OFF] /\ q in [-1,1] /\ s in [1bCELL_NEAR,1b54] /\ l in [-1b-59,1b-59]
  /\ n in [-0.5,0.5]
  /\ x in [-1bSEEN_FAR,1bSEEN_FAR] /\ m in [-5b-61,5b-61] /\ n1 in [-0.5,0.5] /\ n2 in [-0.5,0.5] /\ v in [0,1] /\ slope in [-1,1]
  /\ corner in [-ACROSS_OFF,ACROSS_OFF]
  /\ |dx1| <= 2bACROSS_BITS /\ |dx2| <= 2bACROSS_BITS /\ |dy1| <= 2bACROSS_BITS /\ |dy2| <= 2bACROSS_BITS
  /\ z1 in [-4,4] /\ z2 in [-4,4] /\ z3 in [-4,4] /\ z4 in [-4,4]
  -> seen in [-SEEN_OFF,SEEN_OFF] /\ centre in [0,1] /\ across in [-ACROSS_OFF,ACROSS_OFF] /\ beside in [0,1]
  /\ |area| <= 1bACROSS_THIN }

(1 + e) * (1 + f) - 1 -> e + f + e * f;
