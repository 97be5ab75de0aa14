/* num_ray.h - the numbers of the ray renderer, in the arithmetic that this build is compiled for.
 *
 *   num_length   a coordinate, a length or a colour: |x| < 2^18; Q18.45 in q16
 *   num_unit     a component of a direction, a cosine or a fraction: |d| < 2; Q1.62 in q16
 *
 * The formats are fixed, unlike num.h's, since no exponent chosen per frame suits a path that bounces. Add, subtract,
 * compare and multiply by small integers with the operators of C. For all else, call:
 *
 *   num_length_of(q), num_unit_of(q)   from Q16.16, from Q2.30; num_unit_of_q62(n): from Q1.62
 *   num_fine(n)                  n 2^-32, see struct tia_fine
 *   num_scene_bias(fine, bits)   rays' offset from a surface in a scene with these scale_bits: 2^-13, if bits >= 0;
 *                                else 2^-13 of the file's unit, but at least 2^-26; 2^-26 in a scene with `fine`
 *   num_length_of_unit(d)        a fraction as a num_length
 *   num_times(a, d)              a d, where a is a num_length or a num_unit, rounded to nearest
 *   num_product(x, y)            x y, must be below 2^17; num_product_within(x, y): clamped to 2^17, x, y >= 0
 *   num_sum_within(x, y)         x + y clamped to 2^17; both in 0..2^17
 *   num_point_dot(a, d), num_dir_dot   dot products, rounded once
 *   num_normalise(v, d)          sets d to v/|v|; false, and d = 0, when v is 0
 *   num_half_chord(r, p)         sqrt(r^2 - |p|^2), -1 if |p| > r
 *   num_within(r, p)             true if |p| <= r, exactly
 *   num_point_power(p, r, k)     (|p|^2 - r^2)/k, clamped to +-NUM_LENGTH_MAX; |p| and r below 2^18
 *   num_norm(p), num_unit_sqrt(d), num_root_up(d)   |p|, sqrt(d), and an approximation of sqrt(d) from above
 *   num_div(x, d), num_ratio(x, y)   x/d, x/y as num_length, clamped to +-NUM_LENGTH_MAX
 *   num_fraction(x, y)           x/y as num_unit, between -1 and 1
 *   num_div_by(x, d), num_fraction_by(x, d)   the same for many x, with d = num_divisor_of(y)
 *   num_cross2(ax, ay, bx, by)   ax by - ay bx; its sign is exact or 0; see num_area_sign, num_barycentric
 *   num_power(d, e)              d^e, 0 <= d <= 1, e in Q16.16; num_power_length(d, e): as num_length, faster
 *   num_power_near(d, e, &off)   a number within off of num_power(d, e), faster
 *   num_fade(x)                  exp(-x) as num_unit, x >= 0; 0 for x >= 44
 *   num_atan2(y, x)              atan2(y, x)/(2 pi), in -1/2..1/2, as num_unit
 *   num_repeat(x, bits, p, &cell)   y - floor(y), and floor(y) modulo 2^31 in cell, for y = n (2^bits x - o) by the
 *                                pattern p; bits in -16..16
 *   num_repeats(x, bits, p)      n 2^bits x, clamped to +-2^12; bits in -16..32
 *   num_floor(x), num_integer(n)     the integer part, rounded down; an integer as num_length
 *   num_reciprocal(d)            1/d clamped to +-2^20, for num_slab(x, reciprocal), the distance x/d in a coarse
 *                                format that only box tests use
 *   num_slab_start(s)            a distance of num_slab as num_length, reduced by its error
 *   num_slope(o, d)              a ray, for intersection with planes perpendicular to an axis, such as the sides of a
 *                                hierarchy's boxes: num_walk_to(slope, plane) is the distance, in another coarse format
 *   num_divide(v, s, d)          the direction d and the length of (v.x/s[0], v.y/s[1], v.z/s[2]); num_scaled and
 *                                num_unscaled multiply and divide by the length, clamped to NUM_LENGTH_MAX
 *   num_levels(x, n, threshold)  floor(n x + threshold) of a colour in 0..1, see num_quantise
 */
#ifndef TIA_NUM_NUM_RAY_H
#define TIA_NUM_NUM_RAY_H

#include "num.h"

/* The numbers n and o of a texture along an axis, in Q16.16 times 2^-bits, see struct tia_texture. */
struct num_pattern {
    tia_q16 repeat, offset;
    int repeat_bits, offset_bits;
};

#if defined TIA_NUM_F64 || defined TIA_NUM_F32 || defined TIA_NUM_F128
#include "num_ray_real.h"
#else
#include "num_ray_q16.h"
#endif

struct num_point {
    num_length x, y, z;
};

struct num_dir {
    num_unit x, y, z;
};

static inline struct num_point num_point_of(struct tia_vec3 v)
{
    return (struct num_point){num_length_of(v.x), num_length_of(v.y), num_length_of(v.z)};
}

static inline struct num_point num_point_fine(struct tia_fine_place v)
{
    return (struct num_point){num_fine(v.x), num_fine(v.y), num_fine(v.z)};
}

static inline struct num_point num_point_add(struct num_point a, struct num_point b)
{
    return (struct num_point){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline struct num_point num_point_sub(struct num_point a, struct num_point b)
{
    return (struct num_point){a.x - b.x, a.y - b.y, a.z - b.z};
}

/* Returns 2^-bits, bits in 0..30: the unit of a scene with these scale_bits, in units of its file. */
static inline num_unit num_scene_unit(int bits)
{
    return num_unit_of_q62((int64_t)(UINT64_C(1) << (62 - bits)));
}

/* Returns t d. */
static inline struct num_point num_point_along(struct num_dir d, num_length t)
{
    return (struct num_point){num_times(t, d.x), num_times(t, d.y), num_times(t, d.z)};
}

/* Returns a + t d. */
static inline struct num_point num_point_at(struct num_point a, struct num_dir d, num_length t)
{
    return num_point_add(a, num_point_along(d, t));
}

static inline struct num_dir num_dir_negated(struct num_dir d)
{
    return (struct num_dir){-d.x, -d.y, -d.z};
}

static inline struct num_dir num_dir_of_q62(const int64_t d[3])
{
    return (struct num_dir){num_unit_of_q62(d[0]), num_unit_of_q62(d[1]), num_unit_of_q62(d[2])};
}

static inline struct num_dir num_dir_scaled(struct num_dir d, num_unit s)
{
    return (struct num_dir){num_times(d.x, s), num_times(d.y, s), num_times(d.z, s)};
}

static inline struct num_dir num_dir_add(struct num_dir a, struct num_dir b)
{
    return (struct num_dir){a.x + b.x, a.y + b.y, a.z + b.z};
}

static inline num_length num_point_dot(struct num_point a, struct num_dir d)
{
    return num_dot3(a.x, a.y, a.z, d.x, d.y, d.z);
}

static inline num_unit num_dir_dot(struct num_dir a, struct num_dir d)
{
    return num_dot3(a.x, a.y, a.z, d.x, d.y, d.z);
}

/* Returns a x d, each component rounded once. */
static inline struct num_dir num_dir_cross(struct num_dir a, struct num_dir d)
{
    return (struct num_dir){num_dot3(a.y, -a.z, 0, d.z, d.y, 0), num_dot3(a.z, -a.x, 0, d.x, d.z, 0),
                            num_dot3(a.x, -a.y, 0, d.y, d.x, 0)};
}

static inline bool num_normalise(struct num_point v, struct num_dir *d)
{
    return num_normalise3(v.x, v.y, v.z, &d->x, &d->y, &d->z);
}

/* Returns v, of any length but 0, normalised. Its components are halved first, since num_normalise3 takes lengths,
 * whose range is smaller. */
static inline struct num_dir num_dir_normalised(struct num_dir v)
{
    struct num_dir d;

    (void)num_normalise3(v.x / 2, v.y / 2, v.z / 2, &d.x, &d.y, &d.z);
    return d;
}

static inline struct num_dir num_dir_of(struct tia_dir3 v)
{
    return num_dir_normalised((struct num_dir){num_unit_of(v.x), num_unit_of(v.y), num_unit_of(v.z)});
}

static inline num_length num_half_chord(num_length r, struct num_point p)
{
    return num_half_chord4(r, p.x, p.y, p.z);
}

static inline bool num_within(num_length r, struct num_point p)
{
    return num_within4(r, p.x, p.y, p.z);
}

static inline num_length num_point_power(struct num_point p, num_length r, num_length k)
{
    return num_point_power5(p.x, p.y, p.z, r, k);
}

static inline num_length num_norm(struct num_point p)
{
    return num_norm3(p.x, p.y, p.z);
}

static inline num_length num_length_clamp(num_length x, num_length least, num_length most)
{
    return x < least ? least : x > most ? most : x;
}

/* Returns a + b, at most NUM_LENGTH_MAX; a and b in 0..NUM_LENGTH_MAX. */
static inline num_length num_sum_within(num_length a, num_length b)
{
    return a < NUM_LENGTH_MAX - b ? a + b : NUM_LENGTH_MAX;
}

/* Divides a vector component by component, see num_divide3. */
static inline struct num_scale num_divide(struct num_dir v, const num_length s[3], struct num_dir *d)
{
    const num_unit from[3] = {v.x, v.y, v.z};
    num_unit to[3];
    struct num_scale k = num_divide3(from, s, to);

    *d = (struct num_dir){to[0], to[1], to[2]};
    return k;
}

#ifdef TIA_NUM_CHK
#include "num_ray_chk.h"
#endif

#endif
