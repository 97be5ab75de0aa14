/* fall_oracle.h - balls between planes in double precision, simulated from contact to contact. The time of a contact is
 * a root of the textbook's quadratic. There are no time steps, and no ball comes to rest. */
#ifndef TESTS_FALL_ORACLE_H
#define TESTS_FALL_ORACLE_H

#include <math.h>

#define ORACLE_BALLS 8
#define ORACLE_PLANES 8

struct oracle_ball {
    double place[3], velocity[3], radius, mass, restitution;
};

struct oracle_falling {
    struct oracle_ball balls[ORACLE_BALLS];
    double planes[ORACLE_PLANES][4]; /* n.x = d, n a unit vector towards the balls */
    double gravity[3];
    int ball_count, plane_count;
};

static inline double oracle_dot(const double a[3], const double b[3])
{
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

/* Returns the first t >= 0 at which a t^2 + b t + c, positive before, falls to 0; infinity if it never does. */
static inline double oracle_root(double a, double b, double c)
{
    double disc = b * b - 4 * a * c;

    if (fabs(a) < 1e-12)
        return b < 0 ? fmax(0, -c / b) : INFINITY;
    if (disc <= 0)
        return INFINITY;
    double t = (-b - sqrt(disc)) / (2 * a), u = (-b + sqrt(disc)) / (2 * a);
    if (t > u) {
        double swap = t;
        t = u;
        u = swap;
    }
    if (t >= 0 && 2 * a * t + b < 0)
        return t;
    if (u >= 0 && 2 * a * u + b < 0)
        return u;
    return INFINITY;
}

static inline double oracle_plane_time(const struct oracle_falling *o, int i, int p)
{
    const struct oracle_ball *s = &o->balls[i];
    const double *n = o->planes[p];

    return oracle_root(oracle_dot(o->gravity, n) / 2, oracle_dot(s->velocity, n),
                       oracle_dot(s->place, n) - n[3] - s->radius);
}

static inline void oracle_between(const struct oracle_ball *s, const struct oracle_ball *t, double x[3], double v[3])
{
    for (int k = 0; k < 3; k++) {
        x[k] = s->place[k] - t->place[k];
        v[k] = s->velocity[k] - t->velocity[k];
    }
}

static inline double oracle_ball_time(const struct oracle_falling *o, int i, int j)
{
    double x[3], v[3], r = o->balls[i].radius + o->balls[j].radius;

    oracle_between(&o->balls[i], &o->balls[j], x, v);
    return oracle_root(oracle_dot(v, v), 2 * oracle_dot(x, v), oracle_dot(x, x) - r * r);
}

static inline void oracle_advance(struct oracle_falling *o, double t)
{
    for (int i = 0; i < o->ball_count; i++)
        for (int k = 0; k < 3; k++) {
            o->balls[i].place[k] += o->balls[i].velocity[k] * t + o->gravity[k] * t * t / 2;
            o->balls[i].velocity[k] += o->gravity[k] * t;
        }
}

static inline void oracle_bounce(struct oracle_falling *o, int i, int other)
{
    struct oracle_ball *s = &o->balls[i];

    if (other >= o->ball_count) {
        const double *n = o->planes[other - o->ball_count];
        double speed = oracle_dot(s->velocity, n);
        for (int k = 0; k < 3; k++)
            s->velocity[k] -= (1 + s->restitution) * speed * n[k];
        return;
    }
    struct oracle_ball *t = &o->balls[other];
    double x[3], v[3], e = fmin(s->restitution, t->restitution), sum = s->mass + t->mass;
    oracle_between(s, t, x, v);
    double factor = (1 + e) * oracle_dot(x, v) / oracle_dot(x, x);
    for (int k = 0; k < 3; k++) {
        s->velocity[k] -= factor * t->mass / sum * x[k];
        t->velocity[k] += factor * s->mass / sum * x[k];
    }
}

/* Simulates `time` seconds; returns the number of contacts. */
static inline int oracle_fall(struct oracle_falling *o, double time)
{
    for (int contacts = 0;; contacts++) {
        double first = INFINITY;
        int ball = 0, other = 0;
        for (int i = 0; i < o->ball_count; i++)
            for (int j = i + 1; j < o->ball_count + o->plane_count; j++) {
                double t = j < o->ball_count ? oracle_ball_time(o, i, j) : oracle_plane_time(o, i, j - o->ball_count);
                if (t < first) {
                    first = t;
                    ball = i;
                    other = j;
                }
            }
        oracle_advance(o, first < time ? first : time);
        if (first >= time)
            return contacts;
        time -= first;
        oracle_bounce(o, ball, other);
    }
}

#endif
