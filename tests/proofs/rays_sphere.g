# Spheres of src/simd/rays: s = r^2 - |P|^2 as doubles compute it, of their P, is within es of the exact one of the
# integers' P, wherever that is. r is scaled to 1..2. The integers' P is P - e, |e| <= lambda: e.P = k |P| lambda and
# e.e = c lambda^2, with k in -1..1 by Cauchy and Schwarz, which gappa cannot know, and c in 0..1. `all` is lambda at
# least; P here is r long at most: sphere_tmpl.h says what follows beyond.
@rnd = float<ieee_64,ne>;
px = rnd(px_); py = rnd(py_); pz = rnd(pz_); r = rnd(r_); lambda = rnd(lambda_);
square rnd= r * r;
s rnd= square - (px * px + py * py + pz * pz);
PP = px * px + py * py + pz * pz;
S = r * r - PP;
Sq = S + k * (2 * P * lambda) - c * (lambda * lambda);
es rnd= 2 * r * lambda + lambda * lambda + SURE_SQUAREb-53 * square;
ES = 2 * r * lambda + lambda * lambda + SURE_SQUAREb-53 * (r * r);

{ r in [1,2] /\ |px| <= 2 /\ |py| <= 2 /\ |pz| <= 2 /\ PP in [0,4] /\ P in [0,2] /\ r - P in [0,2]
  /\ lambda in [1b-50,1b-8] /\ k in [-1,1] /\ c in [0,1] -> (s - Sq) + es >= 0 /\ (s - Sq) - es <= 0 }

(s - Sq) + es -> (((s - S) + SURE_SQUAREb-53 * (r * r)) + (es - ES))
                 + (2 * lambda) * ((r - P) + P * (1 - k)) + (lambda * lambda) * (1 + c);
(s - Sq) - es -> (((s - S) - SURE_SQUAREb-53 * (r * r)) - (es - ES))
                 - (2 * lambda) * ((r - P) + P * (1 + k)) - (lambda * lambda) * (1 - c);
