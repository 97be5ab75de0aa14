# The sizes in src/raster/ranges.h: what coordinates of points below 2^RASTER_POINT (perspective) or 2^FLAT_POINT
# (orthographic) and pixels of at most 2^RASTER_PIXEL lead to; directions are up to twice as large. Each line takes what
# the ones before are bounded by. Sums are bounded term by term, so in any order.
#
# perspective: q of any corners, n of normals; h is 0 or 1
normal = q1 * q2 - q3 * q4;
edge = n1 * d1 + n2 * d2 + n3 * d3;
form = (h1 * n1 + h2 * n2 + h3 * n3) * d1 + (h1 * n4 + h2 * n5 + h3 * n6) * d2 + (h1 * n7 + h2 * n8 + h3 * n9) * d3;
det = q1 * n1 + q2 * n2 + q3 * n3;
order = f * t;
# orthographic: p of any corners, m of normals; k is a nearness
pnormal = p1 * p2 - p3 * p4;
pedge = m1 * d1 + m2 * d2 + m3 * d3;
pform = (k1 * m1 + k2 * m2 + k3 * m3) * d1 + (k1 * m4 + k2 * m5 + k3 * m6) * d2 + (k1 * m7 + k2 * m8 + k3 * m9) * d3;
pdet = p1 * m1 + p2 * m2 + p3 * m3;
porder = g * s;
# 64 bits: the product is c^2 times D's components; a normal is at most 2 c^2, N at most 4 c^2, c below 2^30
narrow = 4 * product;
sums = 2 * (2 * c * c);

{ |q1| <= 2bRASTER_POINT /\ |q2| <= 2bRASTER_POINT /\ |q3| <= 2bRASTER_POINT /\ |q4| <= 2bRASTER_POINT
  /\ |n1| <= 1bRASTER_NORMAL /\ |n2| <= 1bRASTER_NORMAL /\ |n3| <= 1bRASTER_NORMAL /\ |n4| <= 1bRASTER_NORMAL
  /\ |n5| <= 1bRASTER_NORMAL /\ |n6| <= 1bRASTER_NORMAL /\ |n7| <= 1bRASTER_NORMAL /\ |n8| <= 1bRASTER_NORMAL
  /\ |n9| <= 1bRASTER_NORMAL /\ h1 in [0,1] /\ h2 in [0,1] /\ h3 in [0,1]
  /\ |d1| <= 1bRASTER_PIXEL /\ |d2| <= 1bRASTER_PIXEL /\ |d3| <= 1bRASTER_PIXEL
  /\ |f| <= 1bRASTER_PLANE /\ |t| <= 1bRASTER_DET
  /\ |p1| <= 2bFLAT_POINT /\ |p2| <= 2bFLAT_POINT /\ |p3| <= 2bFLAT_POINT /\ |p4| <= 2bFLAT_POINT
  /\ |m1| <= 1bFLAT_NORMAL /\ |m2| <= 1bFLAT_NORMAL /\ |m3| <= 1bFLAT_NORMAL /\ |m4| <= 1bFLAT_NORMAL
  /\ |m5| <= 1bFLAT_NORMAL /\ |m6| <= 1bFLAT_NORMAL /\ |m7| <= 1bFLAT_NORMAL /\ |m8| <= 1bFLAT_NORMAL
  /\ |m9| <= 1bFLAT_NORMAL /\ |k1| <= 2bFLAT_POINT /\ |k2| <= 2bFLAT_POINT /\ |k3| <= 2bFLAT_POINT
  /\ |g| <= 1bFLAT_PLANE /\ |s| <= 1bFLAT_DET
  /\ product in [0,1bNARROW_SQUARE] /\ c in [0,1b30]
  -> |normal| <= 1bRASTER_NORMAL /\ |edge| <= 1bRASTER_EDGE /\ |form| <= 1bRASTER_PLANE /\ |det| <= 1bRASTER_DET
  /\ |order| <= 1bRASTER_ORDER
  /\ |pnormal| <= 1bFLAT_NORMAL /\ |pedge| <= 1bFLAT_EDGE /\ |pform| <= 1bFLAT_PLANE /\ |pdet| <= 1bFLAT_DET
  /\ |porder| <= 1bFLAT_ORDER
  /\ narrow in [0,1b63] /\ sums in [0,1b63] }
