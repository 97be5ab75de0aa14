/* float_vec.h - vectors of floats. */
#ifndef BENCH_FLOAT_VEC_H
#define BENCH_FLOAT_VEC_H

#include <math.h>

struct vec {
    float x, y, z;
};

/* Returns a + s b. */
static inline struct vec vec_along(struct vec a, float s, struct vec b)
{
    return (struct vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline struct vec vec_sub(struct vec a, struct vec b)
{
    return vec_along(a, -1, b);
}

static inline struct vec vec_scaled(struct vec a, float s)
{
    return (struct vec){a.x * s, a.y * s, a.z * s};
}

static inline float vec_dot(struct vec a, struct vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct vec vec_cross(struct vec a, struct vec b)
{
    return (struct vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline struct vec vec_unit(struct vec a)
{
    return vec_scaled(a, 1 / sqrtf(vec_dot(a, a)));
}

/* Returns the direction that has the coordinates d in a frame whose z axis is n. */
static inline struct vec vec_around(struct vec n, struct vec d)
{
    const struct vec other = fabsf(n.x) < 0.5F ? (struct vec){1, 0, 0} : (struct vec){0, 1, 0};
    struct vec u = vec_unit(vec_cross(other, n)), v = vec_cross(n, u);

    return vec_along(vec_along(vec_scaled(n, d.z), d.x, u), d.y, v);
}

#endif
