/* vec.h - vectors in double, and exact conversions from the public formats. */
#ifndef TESTS_ORACLE_VEC_H
#define TESTS_ORACLE_VEC_H

#include "pixel.h"

#include <math.h>

#define PI 3.14159265358979323846

struct ray {
    struct oracle_vec origin, direction;
};

struct colour {
    double channel[3];
};

static inline double q16(tia_q16 value)
{
    return value / 65536.0;
}

static inline double q30(tia_q30 value)
{
    return value / 1073741824.0;
}

static inline double radians(tia_q16 degrees)
{
    return q16(degrees) * PI / 180.0;
}

static inline struct oracle_vec position(struct tia_vec3 v)
{
    return (struct oracle_vec){q16(v.x), q16(v.y), q16(v.z)};
}

/* Converts a position with its fine digits. */
static inline struct oracle_vec finely(struct tia_vec3 v, const struct tia_fine_place *fine)
{
    struct oracle_vec p = position(v);

    return fine ? (struct oracle_vec){p.x + ldexp(fine->x, -32), p.y + ldexp(fine->y, -32), p.z + ldexp(fine->z, -32)}
                : p;
}

static inline struct colour rgb(struct tia_rgb c)
{
    return (struct colour){{q30(c.r), q30(c.g), q30(c.b)}};
}

static inline bool is_black(struct colour c)
{
    return !(c.channel[0] > 0) && !(c.channel[1] > 0) && !(c.channel[2] > 0);
}

static inline struct colour grey(double x)
{
    return (struct colour){{x, x, x}};
}

static inline struct colour product(struct colour a, struct colour b)
{
    for (int i = 0; i < 3; i++)
        a.channel[i] *= b.channel[i];
    return a;
}

/* Returns o c + 1 - o. */
static inline struct colour mixed(double o, struct colour c)
{
    for (int i = 0; i < 3; i++)
        c.channel[i] = o * c.channel[i] + 1 - o;
    return c;
}

static inline struct oracle_vec sub(struct oracle_vec a, struct oracle_vec b)
{
    return (struct oracle_vec){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Returns a + s b. */
static inline struct oracle_vec along(struct oracle_vec a, double s, struct oracle_vec b)
{
    return (struct oracle_vec){a.x + s * b.x, a.y + s * b.y, a.z + s * b.z};
}

static inline double dot(struct oracle_vec a, struct oracle_vec b)
{
    return a.x * b.x + a.y * b.y + a.z * b.z;
}

static inline struct oracle_vec cross(struct oracle_vec a, struct oracle_vec b)
{
    return (struct oracle_vec){a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

static inline double length(struct oracle_vec a)
{
    return sqrt(dot(a, a));
}

static inline struct oracle_vec scaled(struct oracle_vec a, double s)
{
    return (struct oracle_vec){a.x * s, a.y * s, a.z * s};
}

static inline struct oracle_vec divide(struct oracle_vec a, double s)
{
    return (struct oracle_vec){a.x / s, a.y / s, a.z / s};
}

static inline struct oracle_vec unit(struct oracle_vec a)
{
    return divide(a, length(a));
}

/* Converts a public direction to a unit vector. */
static inline struct oracle_vec direction(struct tia_dir3 d)
{
    return unit((struct oracle_vec){q30(d.x), q30(d.y), q30(d.z)});
}

static inline struct oracle_vec at(struct ray ray, double t)
{
    return along(ray.origin, t, ray.direction);
}

/* Computes the tangents of shape.h: U = normalise(y x N), V = N x U. If N is y, U = x and V = -z; if N is -y, U = x and
 * V = z. */
static inline void tangents(struct oracle_vec n, struct oracle_vec *u, struct oracle_vec *v)
{
    const struct oracle_vec x = {1, 0, 0}, y = {0, 1, 0};

    *u = length(cross(y, n)) > 0 ? unit(cross(y, n)) : x;
    *v = cross(n, *u);
}

/* Computes the axes of light.h: A = normalise(e x N), B = N x A. Here e is the unit vector of that coordinate of N
 * which is nearest to 0. */
static inline void axes(struct oracle_vec n, struct oracle_vec *a, struct oracle_vec *b)
{
    double x = fabs(n.x), y = fabs(n.y), z = fabs(n.z);
    struct oracle_vec e = {x <= y && x <= z, !(x <= y && x <= z) && y <= z, 0};

    e.z = !(e.x > 0) && !(e.y > 0);
    *a = unit(cross(e, n));
    *b = cross(n, *a);
}

#endif
