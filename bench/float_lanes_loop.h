/* float_lanes_loop.h - the loop, written with the operations that src/simd/isa/isa.h lists. Each instruction set has a
 * file that defines DRAW, the name of the loop, and includes this one. */
#ifndef BENCH_FLOAT_LANES_LOOP_H
#define BENCH_FLOAT_LANES_LOOP_H

#include <string.h>

#include "float_lanes.h"

#define INLINE static inline __attribute__((always_inline))
#define ALL_LANES ((unsigned)((1ull << N) - 1))

typedef struct {
    F x, y, z;
} V;

INLINE V v_set(const float a[3])
{
    return (V){f_set(a[0]), f_set(a[1]), f_set(a[2])};
}

INLINE F v_dot(V a, V b)
{
    return f_fma(a.x, b.x, f_fma(a.y, b.y, f_mul(a.z, b.z)));
}

INLINE V v_sub(V a, V b)
{
    return (V){f_sub(a.x, b.x), f_sub(a.y, b.y), f_sub(a.z, b.z)};
}

INLINE V v_scaled(V a, F s)
{
    return (V){f_mul(a.x, s), f_mul(a.y, s), f_mul(a.z, s)};
}

INLINE V v_along(V a, V d, F s)
{
    return (V){f_fma(d.x, s, a.x), f_fma(d.y, s, a.y), f_fma(d.z, s, a.z)};
}

INLINE V v_sel(M m, V a, V b)
{
    return (V){f_sel(m, a.x, b.x), f_sel(m, a.y, b.y), f_sel(m, a.z, b.z)};
}

/* The nearest hits of rays. The lanes of `any` have a hit, at the distances `t`: with the light in the lanes of
 * `light`, with sphere 1 in those of `second`, otherwise with sphere 0. */
struct seen {
    F t;
    M any, second, light;
};

INLINE struct seen look(const struct lanes_world *w, V d)
{
    const F zero = f_set(0);
    const M none = f_gt(zero, zero);
    struct seen s = {f_set(1e30f), none, none, none};

    for (int i = 0; i < 3; i++) {
        F b = v_dot(d, v_set(w->centre[i])), disc = f_fma(b, b, f_set(-w->c[i]));
        M hit = m_and(f_ge(disc, zero), f_gt(b, zero));
        if (!m_any(hit))
            continue;
        F t = f_fnma(disc, f_rsqrt(f_max(f_set(1e-20f), disc)), b);
        hit = m_and(hit, f_gt(s.t, t));
        s.t = f_sel(hit, t, s.t);
        s.any = m_or(s.any, hit);
        s.second = m_and(s.second, m_not(hit));
        s.light = m_and(s.light, m_not(hit));
        if (i == 1)
            s.second = m_or(s.second, hit);
        if (i == 2)
            s.light = hit;
    }
    return s;
}

/* Returns the lanes of `lit` in which no sphere stands between the point and the light. */
INLINE M unhidden(const struct lanes_world *w, V p, V to, M lit)
{
    for (int i = 1; i >= 0; i--) {
        V a = v_sub(v_set(w->centre[i]), p);
        F along = v_dot(a, to), square = f_fnma(along, along, v_dot(a, a));
        lit = m_and(lit, m_not(m_and(f_ge(along, f_set(0)), f_ge(f_set(w->radius2[i]), square))));
    }
    return lit;
}

/* The sphere that is hit in each lane. */
struct sphere {
    V centre, colour;
    F per_radius;
};

INLINE struct sphere sphere_of(const struct lanes_world *w, const struct seen *s)
{
    struct sphere o = {v_set(w->centre[0]), v_set(w->colour[0]), f_set(w->per_radius[0])};

    if (m_any(s->second)) {
        o.centre = v_sel(s->second, v_set(w->centre[1]), o.centre);
        o.colour = v_sel(s->second, v_set(w->colour[1]), o.colour);
        o.per_radius = f_sel(s->second, f_set(w->per_radius[1]), o.per_radius);
    }
    return o;
}

INLINE F lambert_at(const struct lanes_world *w, V d, const struct seen *s, const struct sphere *o)
{
    const F zero = f_set(0);
    V p = v_scaled(d, s->t), n = v_scaled(v_sub(p, o->centre), o->per_radius), to = v_sub(v_set(w->centre[2]), p);
    to = v_scaled(to, f_rsqrt(v_dot(to, to)));
    F lambert = v_dot(n, to);
    M lit = m_and(s->any, f_gt(lambert, zero));

    if (!m_any(lit))
        return zero;
    return f_sel(unhidden(w, v_along(p, n, f_set(1e-4f)), to, lit), lambert, zero);
}

INLINE void lanes_of(const struct lanes_world *w, V d, uint16_t *out)
{
    struct seen s = look(w, d);

    if (!m_any(s.any)) {
        memcpy(out, w->sky, N * sizeof *out);
        return;
    }
    struct sphere o = sphere_of(w, &s);
    V rgb = v_scaled(o.colour, lambert_at(w, d, &s, &o)); /* in levels of RGB565 */
    rgb = (V){f_min(f_set(31), rgb.x), f_min(f_set(63), rgb.y), f_min(f_set(31), rgb.z)};
    if (m_bits(m_and(s.any, m_not(s.light))) != ALL_LANES)
        rgb = v_sel(s.light, v_set(w->glow), v_sel(s.any, rgb, v_set(w->background)));
    i_pack(f_round(rgb.x), f_round(rgb.y), f_round(rgb.z), out);
}

INLINE V ray(const struct lanes_world *w, int x, float vy)
{
    F vx = f_fma(f_add(f_iota(), f_set((float)x)), f_set(w->step), f_set(w->start));
    F per = f_rsqrt(f_fma(vx, vx, f_set(vy * vy + 1)));

    return (V){f_mul(vx, per), f_mul(f_set(vy), per), f_sub(f_set(0), per)};
}

void DRAW(const struct lanes_world *world, int width, int height, tia_rgb565 *pixels)
{
    const struct lanes_world w = *world; /* a copy, which pixels cannot alias */
    uint16_t last[N];

    for (int y = 0; y < height; y++, pixels += width) {
        float vy = w.up - (float)y * w.step;
        int x = 0;
        for (; x + N <= width; x += N)
            lanes_of(&w, ray(&w, x, vy), pixels + x);
        if (x < width) {
            lanes_of(&w, ray(&w, x, vy), last);
            memcpy(pixels + x, last, (size_t)(width - x) * sizeof *last);
        }
    }
}

#endif
