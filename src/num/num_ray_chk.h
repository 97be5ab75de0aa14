/* num_ray_chk.h - records file and line of calls for the checks of num_ray_q16.h, see num_chk.h. */
#ifndef TIA_NUM_NUM_RAY_CHK_H
#define TIA_NUM_NUM_RAY_CHK_H

#define num_integer(n) (NUM_AT, num_integer(n))
#define num_product(a, b) (NUM_AT, num_product(a, b))
#define num_point_dot(a, d) (NUM_AT, num_point_dot(a, d))
#define num_dir_dot(a, d) (NUM_AT, num_dir_dot(a, d))
#define num_dir_cross(a, d) (NUM_AT, num_dir_cross(a, d))
#define num_normalise(v, d) (NUM_AT, num_normalise(v, d))
#define num_unit_sqrt(d) (NUM_AT, num_unit_sqrt(d))
#define num_barycentric(a, p) (NUM_AT, num_barycentric(a, p))
#define num_levels(c, n, t) (NUM_AT, num_levels(c, n, t))
#define num_power(d, e) (NUM_AT, num_power(d, e))
#define num_power_length(d, e) (NUM_AT, num_power_length(d, e))
#define num_power_near(d, e, off) (NUM_AT, num_power_near(d, e, off))
#define num_point_at(a, d, t) (NUM_AT, num_point_at(a, d, t))

#endif
