# tia_rsqrt: 2^31 / sqrt(n / 2^64) within 2 ulp of 2^-31.
#
# s = 1/sqrt(N) with N = n / 2^64 is exact, the seed is y0 = s (1 + d). Its error bound is what
# `make check-exhaustive` finds for all 3 2^30 arguments, 3.2e-6, and 2^-31 for the lower word of n.
# Every right shift of src/math/integer.h is a rounding down here.

N = 1 / (s * s);
y0 = s * (1 + d);
A = fixed<-32, dn>(N);                  # a
q = fixed<-30, dn>(y0 * y0);
c = fixed<-62, dn>(A * 1b-31 + q * 1b-33);      # (a + q) >> 1
p = A * q + c;                          # product
e = 1 + 1b-32 - p;
e1 = fixed<-46, dn>(e);                 # e >> 16
h = fixed<-30, dn>(y0);                 # y >> 1
t = fixed<-31, dn>(h * e1 * 0.5);
y = y0 + t;

{ s in [1, 2] /\ d in [-3.21e-6, 3.21e-6] -> y - s in [-1b-30, 1b-30] }

# (1 - N y0^2) y0 / 2 is Newton's step; what it leaves is -3/2 d^2 - 1/2 d^3.
y - s -> s * (-1.5 * (d * d) - 0.5 * (d * (d * d))) + y0 * (e - (1 - (1 + d) * (1 + d))) * 0.5
         + (h * e1 - y0 * e) * 0.5 + (t - h * e1 * 0.5);
h * e1 - y0 * e -> (h - y0) * e1 + y0 * (e1 - e);
e -> (e - (1 - (1 + d) * (1 + d))) - (2 * d + d * d);
# (A + 2^-33) (q + 2^-31) is p + 2^-64, but for the rounding of c
e - (1 - (1 + d) * (1 + d)) -> 1b-32 + 1b-64 - (c - (A * 1b-31 + q * 1b-33))
         - ((A - N) + 1b-33) * (q + 1b-31) - N * ((q - y0 * y0) + 1b-31) { s <> 0 };
$ s in 64;
