# tia_reciprocal: 2^63 / d between -1.02 and +0.25 ulp of 2^-31.
D = 1 / z;
y0 = z * (1 + d);
e = 1 + 1b-34 - D * y0;
e1 = fixed<-47, dn>(e);                 # e >> 16
h = fixed<-30, dn>(y0);                 # y >> 1
t = fixed<-31, dn>(h * e1);
y = y0 + t;

{ z in [1, 2] /\ d in [-7.9e-6, 7.9e-6] -> (y - z) * 1b31 in [-1.02, 0.2501] }

y - z -> z * (0 - d * d) + y0 * 1b-34 + (h * e1 - y0 * e) + (t - h * e1) { z <> 0 };
h * e1 - y0 * e -> (h - y0) * e1 + y0 * (e1 - e);
e -> 1b-34 - d { z <> 0 };
