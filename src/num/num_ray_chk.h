/* num_ray_chk.h - where in the core the checks of num_ray_q16.h are, see num_chk.h. */
#ifndef TIA_NUM_RAY_CHK_H
#define TIA_NUM_RAY_CHK_H

#define num_int(n) (NUM_AT, num_int(n))
#define num_product(a, b) (NUM_AT, num_product(a, b))
#define num_dot_x(a, d) (NUM_AT, num_dot_x(a, d))
#define num_dot_d(a, d) (NUM_AT, num_dot_d(a, d))
#define num_cross_d(a, d) (NUM_AT, num_cross_d(a, d))
#define num_normalise(v, d) (NUM_AT, num_normalise(v, d))
#define num_sqrt_d(d) (NUM_AT, num_sqrt_d(d))
#define num_parts(a, p) (NUM_AT, num_parts(a, p))
#define num_levels(c, n, t) (NUM_AT, num_levels(c, n, t))
#define num_power(d, e) (NUM_AT, num_power(d, e))
#define num_point_at(a, d, t) (NUM_AT, num_point_at(a, d, t))

#endif
