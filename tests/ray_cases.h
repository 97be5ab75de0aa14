/* ray_cases.h - shared by the tests of general rays, in the arithmetic for which these are compiled: random numbers,
 * rays, and conversions between the core's numbers and long double. */
#ifndef TESTS_RAY_CASES_H
#define TESTS_RAY_CASES_H

#include <math.h>

#include "check.h"
#include "prepared.h"
#include "random.h"

/* Returns a random coordinate in -most..most. */
static inline tia_q16 random_q16(long double most)
{
    return (tia_q16)(random_real() * most * 65536);
}

static inline struct tia_vec3 random_vec(long double most)
{
    return (struct tia_vec3){random_q16(most), random_q16(most), random_q16(most)};
}

typedef struct {
    long double x, y, z;
} real3;

static inline long double real_of(num_length x)
{
    return (long double)x / (long double)NUM_LENGTH_ONE;
}

static inline num_length num_of(long double x)
{
    return (num_length)(x * (long double)NUM_LENGTH_ONE);
}

static inline real3 real3_of(struct num_point p)
{
    return (real3){real_of(p.x), real_of(p.y), real_of(p.z)};
}

static inline real3 real3_dir(struct num_dir d)
{
    return (real3){(long double)d.x / (long double)NUM_UNIT_ONE, (long double)d.y / (long double)NUM_UNIT_ONE,
                   (long double)d.z / (long double)NUM_UNIT_ONE};
}

static inline real3 real3_vec(struct tia_vec3 v)
{
    return (real3){v.x / 65536.0L, v.y / 65536.0L, v.z / 65536.0L};
}

static inline struct num_point point_of(real3 p)
{
    return (struct num_point){num_of(p.x), num_of(p.y), num_of(p.z)};
}

static inline real3 plus(real3 a, real3 b, long double s)
{
    return (real3){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline real3 minus(real3 a, real3 b)
{
    return plus(a, b, -1);
}

static inline long double dot(real3 a, real3 b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline real3 cross(real3 a, real3 b)
{
    return (real3){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline long double length(real3 a)
{
    return sqrtl(dot(a, a));
}

static inline real3 unit(real3 v)
{
    return plus((real3){0, 0, 0}, v, 1 / length(v));
}

static inline real3 random_real3(long double most)
{
    return (real3){random_real() * most, random_real() * most, random_real() * most};
}

/* Returns a ray from one point towards another. */
static inline struct ray ray_towards(real3 from, real3 to)
{
    struct ray ray = {.origin = point_of(from)};

    (void)num_normalise(point_of(minus(to, real3_of(ray.origin))), &ray.direction);
    return ray;
}

#endif
