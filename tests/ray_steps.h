/* ray_steps.h - for tests of single steps of src/simd/rays. A step's inputs have the largest errors that their bounds
 * allow, in the direction that changes the result most; its output is compared with the formula. Include it after
 * one_lane.h. */
#ifndef TESTS_RAY_STEPS_H
#define TESTS_RAY_STEPS_H

#include <math.h>

#include "check.h"
#include "random.h"

/* The largest fraction of a bound that an error has used. It is printed and checked at the end of a test. */
struct used {
    const char *name;
    double most;
    unsigned long sure, open; /* numbers of certain and of undecided results */
};

static inline void use(struct used *u, long double gap, double bound)
{
    double part = (double)(gap < 0 ? -gap : gap) / bound;

    u->most = part > u->most || isnan(part) ? part : u->most;
    u->sure++;
}

static inline void check_used(const struct used *u)
{
    printf("# %s: %lu sure, %lu open, %.3f used\n", u->name, u->sure, u->open, u->most);
    CHECK_MSG(u->most <= 1, "the bound of the %s is exceeded %.2f times", u->name, u->most);
    CHECK_MSG(u->sure > 1000, "the %s: only %lu are sure", u->name, u->sure);
}

/* A vector of the reference, in long double. */
struct real {
    long double v[3];
};

static inline struct real real_of(struct v3 a)
{
    return (struct real){{a.x, a.y, a.z}};
}

static inline struct v3 v3_of(struct real a)
{
    return (struct v3){(double)a.v[0], (double)a.v[1], (double)a.v[2]};
}

static inline long double real_dot(struct real a, struct real b)
{
    return a.v[0] * b.v[0] + a.v[1] * b.v[1] + a.v[2] * b.v[2];
}

/* Returns a + b s. */
static inline struct real real_along(struct real a, struct real b, long double s)
{
    return (struct real){{a.v[0] + b.v[0] * s, a.v[1] + b.v[1] * s, a.v[2] + b.v[2] * s}};
}

static inline struct real real_unit(struct real a)
{
    const struct real zero = {{0, 0, 0}};

    return real_along(zero, a, 1 / sqrtl(real_dot(a, a)));
}

static inline struct real real_cross(struct real a, struct real b)
{
    return (struct real){
        {a.v[1] * b.v[2] - a.v[2] * b.v[1], a.v[2] * b.v[0] - a.v[0] * b.v[2], a.v[0] * b.v[1] - a.v[1] * b.v[0]}};
}

static inline long double real_gap(struct real a, struct v3 b)
{
    struct real way = real_along(a, real_of(b), -1);

    return sqrtl(real_dot(way, way));
}

static inline struct real real_random(void)
{
    struct real a;

    do {
        for (int i = 0; i < 3; i++)
            a.v[i] = random_real();
    } while (real_dot(a, a) > 1 || real_dot(a, a) < 0.01L);
    return real_unit(a);
}

/* Returns a unit vector perpendicular to a. */
static inline struct real real_aside(struct real a)
{
    return real_unit(real_cross(a, real_random()));
}

/* Returns the unit vector a, turned towards `to` by an angle whose chord is e. `to` is a unit vector perpendicular to
 * a. */
static inline struct real real_turned(struct real a, struct real to, long double e)
{
    long double turn = 2 * asinl(e / 2);
    const struct real zero = {{0, 0, 0}};

    return real_along(real_along(zero, a, cosl(turn)), to, sinl(turn));
}

/* Returns a random number in 2^-(least + 1)..2^-most, or 0. */
static inline double some_size(int most, int least)
{
    int bits = most + (int)(random_bits() % (unsigned)(least - most + 1));

    return random_bits() % 4 ? ldexp(1 + fabs(random_double()), -bits - 1) : 0;
}

/* Returns a number in 0..1. */
static inline double some_part(void)
{
    return fabs(random_double());
}

static inline double some_sign(void)
{
    return random_bits() % 2 ? 1 : -1;
}

#endif
