# tia_sqrt_normalised: before its last line r <= sqrt(n) < r + 2, so that the root is r or r + 1.
# S = sqrt(n) / 2^32.
y0 = (1 + d) / S;
N = S * S;
A = fixed<-32, dn>(N);
r0 = fixed<-31, dn>(A * y0);
w = r0 - S;
rest = N - r0 * r0;
rest1 = fixed<-48, dn>(rest) - 1b-36;   # (rest >> 16) - 2^12
h = fixed<-30, dn>(y0);
t = fixed<-32, dn>(rest1 * h * 0.5);
r = r0 + t;

{ S in [0.5, 1] /\ d in [-3.21e-6, 3.21e-6] -> (r - S) * 1b32 in [-1.2, 0] }

r - S -> 0 - w * d - (w * w) * y0 * 0.5 + (rest1 * h - rest * y0) * 0.5 + (t - rest1 * h * 0.5) { S <> 0 };
w * d -> S * (d * d) + d * (w - S * d);
w - S * d -> (A - N) * y0 + (r0 - A * y0) { S <> 0 };
w -> S * d + (w - S * d);
rest1 * h - rest * y0 -> (rest1 - rest) * h + rest * (h - y0);
rest1 - rest -> (fixed<-48, dn>(rest) - rest) - 1b-36;
rest -> 0 - w * (2 * S + w);
$ S in 16;
