/* num_ray_real.h - num_ray.h's operations in floating point. */
#ifndef TIA_NUM_NUM_RAY_REAL_H
#define TIA_NUM_NUM_RAY_REAL_H

typedef num_real num_length;
typedef num_real num_unit;

#define NUM_LENGTH_ONE ((num_real)1)
#define NUM_LENGTH_BIAS ((num_real)1 / 8192)
#define NUM_LENGTH_FAR ((num_real)65536)
#define NUM_LENGTH_MAX ((num_real)131072)
#define NUM_LENGTH_LEAST ((num_real)1e-30)
#define NUM_UNIT_ONE ((num_real)1)
#define NUM_UNIT_LEAST ((num_real)1 / ((int64_t)1 << 42))

static inline num_length num_length_of(tia_q16 q)
{
    return (num_real)q / 65536;
}

static inline num_length num_length_of_q45(int64_t n)
{
    return (num_real)n / (num_real)((int64_t)1 << 45);
}

static inline num_length num_fine(int16_t digits)
{
    return (num_real)digits / (num_real)4294967296;
}

/* Returns the offset of rays from a surface. In float, which is too coarse for a smaller offset, it is 2^-13 of the
 * scene's or of the file's unit, the larger. */
static inline num_length num_scene_bias(bool fine, int scale_bits)
{
#ifdef TIA_NUM_F32
    (void)fine;
    return NUM_LENGTH_BIAS * (num_real)((int32_t)1 << (scale_bits > 0 ? scale_bits : 0));
#else
    int down = fine || scale_bits < -13 ? 13 : scale_bits < 0 ? -scale_bits : 0;

    return NUM_LENGTH_BIAS / (num_real)((int32_t)1 << down);
#endif
}

static inline num_unit num_unit_of(tia_q30 q)
{
    return (num_real)q / 1073741824;
}

static inline num_unit num_unit_of_q62(int64_t n)
{
    return (num_real)n / (num_real)((int64_t)1 << 62);
}

static inline num_length num_length_of_unit(num_unit d)
{
    return d;
}

static inline num_length num_integer(int32_t n)
{
    return (num_real)n;
}

/* Returns x rounded down; x is below 2^31 in size. */
static inline int32_t num_floor(num_length x)
{
    int32_t n = (int32_t)x;
    return n - ((num_real)n > x);
}

static inline num_length num_times(num_length a, num_unit d)
{
    return a * d;
}

static inline num_length num_product(num_length a, num_length b)
{
    return a * b;
}

static inline num_length num_product_within(num_length a, num_length b)
{
    return a * b < NUM_LENGTH_MAX ? a * b : NUM_LENGTH_MAX;
}

/* Returns 2^bits, bits in -31..31. */
static inline num_real num_two_to(int bits)
{
    return bits < 0 ? 1 / (num_real)((int64_t)1 << -bits) : (num_real)((int64_t)1 << bits);
}

static inline num_length num_repeat(num_length x, int bits, const struct num_pattern *p, int32_t *cell)
{
    num_real offset = (num_real)p->offset * num_two_to(-16 - p->offset_bits);
    num_real y = (x * num_two_to(bits) - offset) * ((num_real)p->repeat * num_two_to(-16 - p->repeat_bits));

    if (y >= 1073741824 || y <= -1073741824) /* the remainder is exact, as it has no more digits than y */
        y -= (num_real)num_floor(y / 2147483648) * 2147483648;
    int32_t floor = num_floor(y);
    *cell = floor & INT32_MAX;
    return y - (num_real)floor;
}

static inline num_length num_repeats(num_length x, int bits, const struct num_pattern *p)
{
    num_real y = x * num_two_to(bits) * ((num_real)p->repeat * num_two_to(-16 - p->repeat_bits));

    return y > 4096 ? 4096 : y < -4096 ? -4096 : y;
}

static inline num_real num_dot3(num_real ax, num_real ay, num_real az, num_unit bx, num_unit by, num_unit bz)
{
    return ax * bx + ay * by + az * bz;
}

static inline num_length num_norm3(num_length x, num_length y, num_length z)
{
    return num_root(x * x + y * y + z * z);
}

static inline bool num_normalise3(num_length x, num_length y, num_length z, num_unit *dx, num_unit *dy, num_unit *dz)
{
    num_real length = num_norm3(x, y, z);
    num_real scale = length > 0 ? 1 / length : 0;

    *dx = x * scale;
    *dy = y * scale;
    *dz = z * scale;
    return length > 0;
}

static inline num_length num_half_chord4(num_length r, num_length x, num_length y, num_length z)
{
    num_real rest = r * r - (x * x + y * y + z * z);
    return rest < 0 ? -1 : num_root(rest);
}

static inline bool num_within4(num_length r, num_length x, num_length y, num_length z)
{
    return r >= 0 && x * x + y * y + z * z <= r * r;
}

static inline num_unit num_unit_sqrt(num_unit d)
{
    return num_root(d);
}

static inline num_unit num_root_up(num_unit d)
{
    return num_root(d) + (num_real)1 / ((int32_t)1 << 28);
}

static inline num_real num_bounded(num_real x, num_real most)
{
    return x > most ? most : x < -most ? -most : x;
}

static inline num_length num_div(num_length x, num_unit d)
{
    if (d == 0)
        return x < 0 ? -NUM_LENGTH_MAX : x > 0 ? NUM_LENGTH_MAX : 0;
    return num_bounded(x / d, NUM_LENGTH_MAX);
}

static inline num_length num_point_power5(num_length x, num_length y, num_length z, num_length r, num_length k)
{
    return num_div(x * x + y * y + z * z - r * r, k);
}

static inline num_length num_ratio(num_length x, num_length y)
{
    return num_div(x, y);
}

static inline num_unit num_fraction(num_length x, num_length y)
{
    return num_bounded(num_div(x, y), 1);
}

typedef num_real num_divisor;

static inline num_divisor num_divisor_of(num_real d)
{
    return d;
}

static inline num_length num_div_by(num_length x, num_divisor d)
{
    return num_div(x, d);
}

static inline num_unit num_fraction_by(num_length x, num_divisor y)
{
    return num_fraction(x, y);
}

typedef num_real num_area;

/* Returns the area. It is computed in two statements, so that no compiler fuses a product and the difference into a
 * multiply-add. With both products rounded alike, the sign is right or 0. */
static inline num_area num_cross2(num_length ax, num_length ay, num_length bx, num_length by)
{
    num_real left = ax * by, right = ay * bx;
    return left - right;
}

static inline int num_area_sign(num_area a)
{
    return (a > 0) - (a < 0);
}

static inline void num_barycentric(const num_area areas[3], num_unit parts[3])
{
    num_real sum = areas[0] + areas[1] + areas[2], a[3];

    for (int i = 0; i < 3; i++)
        a[i] = (areas[i] < 0) == (sum < 0) ? areas[i] : 0;
    sum = a[0] + a[1] + a[2];
    parts[1] = sum == 0 ? 0 : a[1] / sum;
    parts[2] = sum == 0 ? 0 : a[2] / sum;
    parts[0] = 1 - parts[1] - parts[2];
}

static inline num_unit num_power(num_unit d, tia_q16 e)
{
    num_real power = 1, base = d;

    for (tia_q16 n = e >> 16; n; n >>= 1) {
        if (n & 1)
            power *= base;
        base *= base;
    }
    base = d;
    for (tia_q16 n = e & 0xffff; n; n = (n << 1) & 0xffff) {
        base = num_root(base);
        if (n & 0x8000)
            power *= base;
    }
    return power;
}

static inline num_unit num_power_near(num_unit d, tia_q16 e, num_unit *off)
{
    *off = 0;
    return num_power(d, e);
}

static inline num_length num_power_length(num_unit d, tia_q16 e)
{
    return num_power(d, e);
}

#define NUM_EXP_TERMS 34 /* 1/34! < 2^-113 */

/* Returns e^x, 0 <= x <= 1, by its power series. */
static inline num_real num_grow(num_real x)
{
    num_real sum = 1;

    for (int k = NUM_EXP_TERMS; k > 0; k--)
        sum = 1 + sum * x / (num_real)k;
    return sum;
}

static inline num_unit num_fade(num_length x)
{
    int whole = x < 44 ? (int)x : 44;
    num_real sum = x < 44 ? num_grow(x - (num_real)whole) : 1, e = num_grow(1);

    for (int i = 0; i < whole; i++)
        sum *= e;
    return x < 44 ? 1 / sum : 0;
}

#define NUM_UNIT_PARALLEL ((num_real)1 / 1048576)

static inline num_length num_reciprocal(num_unit d)
{
    return 1 / (d < 0                   ? (d > -NUM_UNIT_PARALLEL ? -NUM_UNIT_PARALLEL : d)
                : d < NUM_UNIT_PARALLEL ? NUM_UNIT_PARALLEL
                                        : d);
}

static inline num_length num_slab(num_length x, num_length reciprocal)
{
    return x * reciprocal;
}

/* Largest error of the difference of two distances: 2^-22 for double; 2^-4 for float, whose values near 2^16 differ by
 * 2^-8. */
#define NUM_SLAB_ERROR ((num_real)1 / (sizeof(num_real) == sizeof(float) ? 16 : 4194304))

static inline num_length num_slab_of(num_length t)
{
    return t;
}

static inline num_length num_slab_start(num_length slab)
{
    return slab <= NUM_SLAB_ERROR ? 0 : slab - NUM_SLAB_ERROR;
}

typedef num_real num_walk;

struct num_slope {
    num_real origin, inverse;
    bool backward, parallel;
};

static inline struct num_slope num_slope(num_length origin, num_unit d)
{
    bool parallel = d < NUM_UNIT_PARALLEL && d > -NUM_UNIT_PARALLEL;

    return (struct num_slope){origin, num_reciprocal(d), d < 0, parallel};
}

static inline num_walk num_walk_to(const struct num_slope *s, tia_q16 plane)
{
    return (num_length_of(plane) - s->origin) * s->inverse;
}

static inline num_walk num_walk_limit(num_length t)
{
    return t + NUM_SLAB_ERROR;
}

static inline num_walk num_walk_slack(num_walk far)
{
    return far + NUM_SLAB_ERROR;
}

struct num_scale {
    num_real mantissa;
};

static inline struct num_scale num_divide3(const num_unit v[3], const num_length s[3], num_unit d[3])
{
    const num_real x = v[0] / s[0], y = v[1] / s[1], z = v[2] / s[2];

    (void)num_normalise3(x, y, z, &d[0], &d[1], &d[2]);
    return (struct num_scale){num_norm3(x, y, z)};
}

static inline num_length num_scaled(num_length t, struct num_scale k)
{
    return num_bounded(t * k.mantissa, NUM_LENGTH_MAX);
}

static inline num_length num_unscaled(num_length t, struct num_scale k)
{
    return num_div(t, k.mantissa);
}

static inline num_unit num_atan2(num_unit y, num_unit x)
{
    return num_angle(y, x) / NUM_TWO_PI;
}

static inline unsigned num_levels(num_length c, unsigned levels, num_u threshold)
{
    return num_quantise(c, levels, threshold);
}

#endif
