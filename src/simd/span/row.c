#include "row.h"

#include <math.h>

#include "proved.h"

void tia_simd_row(const struct primary_rays *primary, int y, struct simd_row *row)
{
    row->y = y;
    row->y_coordinate = primary_y(primary, y);
    row->square = row->y_coordinate * row->y_coordinate + primary->depth * primary->depth;
    row->per_depth = 1 / (double)primary->depth;
    row->per_depth2 = row->per_depth * row->per_depth;
}

static num_wide coordinate(const struct primary_rays *primary, int x)
{
    return num_pixel_coordinate(2 * x + 1 - primary->width, primary->exponent);
}

static double larger(double a, double b)
{
    return a > b ? a : b;
}

/* Returns a + b x + c x^2. */
static double quadratic(double a, double b, double c, double x)
{
    return a + x * (b + x * c);
}

/* Coefficients have a few roundings of double, some 2^-51: the factors 1 +- 2^-40 cover them. */
#define ABOVE (1 + 0x1p-40)
#define BELOW (1 - 0x1p-40)

void tia_simd_place(const struct primary_rays *primary, const struct simd_row *row, int first, int end,
                    struct simd_place *place)
{
    num_wide step = num_pixel_coordinate(2, primary->exponent);

    place->middle = first + (end - first) / 2;
    place->low = first - place->middle;
    place->high = end - 1 - place->middle;
    place->reach = larger(-place->low, place->high);
    num_wide x = coordinate(primary, place->middle);
    place->v0 = (double)(x * x + row->square) * row->per_depth2;
    place->v1 = (double)(2 * x * step) * row->per_depth2;
    place->v2 = (double)(step * step) * row->per_depth2;
    place->square_most = larger(quadratic(place->v0, place->v1, place->v2, place->low),
                                quadratic(place->v0, place->v1, place->v2, place->high)) *
                         ABOVE;
    place->square_least = (double)row->square * row->per_depth2 * BELOW;
    place->v_most = sqrt(place->square_most) * ABOVE;
    place->v_step = (double)step * row->per_depth * ABOVE;
}

void tia_simd_form(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                   struct num_vec a, double c[2])
{
    num_wide x = coordinate(primary, place->middle), step = num_pixel_coordinate(2, primary->exponent);

    c[0] = (double)(a.x * x + a.y * row->y_coordinate - a.z * primary->depth) * row->per_depth * 0x1p-16;
    c[1] = (double)(a.x * step) * row->per_depth * 0x1p-16;
}

/* Returns a b - c d, rounded two or three times: all cancellation happens in integers. */
static double difference(num_wide a, num_wide b, num_wide c, num_wide d)
{
#if TIA_INT128
    __extension__ typedef __int128 wide;
    wide r = (wide)a * b - (wide)c * d;
    int64_t low = (int64_t)r; /* with a sign: then the halves cost an instruction each, not a call */

    return (double)((int64_t)(r >> 64) + (low < 0)) * 0x1p64 + (double)low;
#else
    struct tia_wide p = tia_wide_product((uint64_t)num_abs(a), (uint64_t)num_abs(b));
    struct tia_wide q = tia_wide_product((uint64_t)num_abs(c), (uint64_t)num_abs(d));
    struct tia_wide r;

    if ((a < 0) != (b < 0))
        p = (struct tia_wide){~p.high + !p.low, 0 - p.low};
    if ((c < 0) == (d < 0))
        q = (struct tia_wide){~q.high + !q.low, 0 - q.low};
    r.low = p.low + q.low;
    r.high = p.high + q.high + (r.low < p.low);
    if ((int64_t)r.high < 0)
        return -((double)(~r.high + !r.low) * 0x1p64 + (double)(0 - r.low));
    return (double)r.high * 0x1p64 + (double)r.low;
#endif
}

static double least_of(const double d[3], const struct simd_place *at)
{
    double left = quadratic(d[0], d[1], d[2], at->low), right = quadratic(d[0], d[1], d[2], at->high);
    double least = left < right ? left : right, bottom = d[2] > 0 ? -d[1] / (2 * d[2]) : SIMD_NEVER;

    return bottom > at->low && bottom < at->high ? d[0] - d[1] * d[1] / (4 * d[2]) : least;
}

bool tia_simd_see(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                  const struct span_sphere *sphere, struct simd_seen *seen)
{
    num_wide x = coordinate(primary, place->middle), step = num_pixel_coordinate(2, primary->exponent);
    struct num_vec l = sphere->centre;
    num_wide b = l.x * x + l.y * row->y_coordinate - l.z * primary->depth, b_step = l.x * step, c = sphere->c;
    double scale = row->per_depth2 * 0x1p-32;

    if (c <= 0)
        return false;
    seen->c = (double)c * 0x1p-32;
    seen->b[0] = (double)b * row->per_depth * 0x1p-16;
    seen->b[1] = (double)b_step * row->per_depth * 0x1p-16;
    seen->d[0] = difference(b, b, c, x * x + row->square) * scale;
    seen->d[1] = 2 * difference(b, b_step, c, x * step) * scale;
    seen->d[2] = difference(b_step, b_step, c, step * step) * scale;
    seen->size = fabs(seen->d[0]) + (fabs(seen->d[1]) + fabs(seen->d[2]) * place->reach) * place->reach;
    seen->least = least_of(seen->d, place) - seen->size * 0x1p-40;
    double left = seen->b[0] + place->low * seen->b[1], right = seen->b[0] + place->high * seen->b[1];
    seen->b_most = larger(left, right) * ABOVE;
    seen->b_least = (left < right ? left : right) - seen->b_most * 0x1p-40;
    return seen->b_least > 0 && seen->size > 0;
}

/* The integer code, see span/span_sphere.c and kernels.c: b and v.v are accumulators whose upper halves have the last
 * bits ub and uv, rounded to nearest but for the error of 64 steps, .51 of a bit; so has c with uc. Then D is off by
 *
 *     dd = .51 (2 b ub + ub^2 + c uv + v.v uc + uv uc).
 *
 * ut is the last bit of t. */
struct last_bits {
    double ub, ut, dd;
};

static struct last_bits last_bits_of(const struct primary_rays *primary, const struct simd_row *row,
                                     const struct simd_place *place, const struct span_sphere *sphere,
                                     const struct simd_seen *seen)
{
    int f = primary->exponent;
    double pixel = row->per_depth * simd_power(f); /* a pixel coordinate's unit, at depth 1 */
    double ub = pixel * simd_power(16 - f - sphere->b_shift);
    double uv = pixel * pixel * simd_power(32 - 2 * f - primary->square_shift);
    double uc = simd_power(primary->square_shift - 2 * sphere->b_shift), b = seen->b_most;

    return (struct last_bits){ub, simd_power(-sphere->t_exponent) / pixel,
                              .51 * (2 * b * ub + ub * ub + seen->c * uv + place->square_most * uc + uv * uc)};
}

/* Bounds S = b + sqrt(D) in an arithmetic whose roundings are at most `unit`, relative. b is off by SIMD_LINEAR units
 * of its largest value, D by SIMD_QUADRATIC of its size, and so sqrt(D) by that over 2 floor; the root and the sum
 * themselves by SIMD_SUM units of the whole.
 *
 * In the integer code the root of D is off by dd/floor and one ub for rounding down, t by 2^-29 for the reciprocal and
 * the quotient's constants, and .51 of its last bit. */
static void bound_depth(const struct last_bits *u, const struct simd_seen *seen, double unit, struct simd_depth *depth)
{
    double b = seen->b_most, off = SIMD_LINEAR * b + SIMD_QUADRATIC * seen->size / (2 * depth->floor);

    depth->es = unit * (off / depth->sum_least + SIMD_SUM);
    depth->et = (1.51 * u->ub + u->dd / depth->floor) / depth->sum_least + 0x1p-29 + .51 * u->ut / depth->t_least;
    depth->mantissa_most = depth->t_most / u->ut + 1;
}

/* Finds the range of distances: t = c/(b + sqrt(D)), where the root is at least 0 and at most that of D's size, rounded
 * down: so no D is too small. */
void tia_simd_between(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                      const struct span_sphere *sphere, const struct simd_seen *seen, double t[2])
{
    struct last_bits u = last_bits_of(primary, row, place, sphere, seen);
    double least = seen->b_least - u.ub, most = seen->b_most + u.ub + sqrt(seen->size + u.dd) * ABOVE;

    t[0] = seen->c / most * (1 - 0x1p-28) - u.ut;
    t[1] = least > 0 ? seen->c / least * (1 + 0x1p-28) + u.ut : SIMD_NEVER;
}

void tia_simd_depth(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                    const struct span_sphere *sphere, const struct simd_seen *seen, double unit, double cut,
                    struct simd_depth *depth)
{
    bool all = seen->least > seen->size * cut * 1.1;

    depth->cut = all ? 0 : seen->size * cut;
    depth->floor = sqrt((all ? seen->least : depth->cut) * .98); /* as computed D may be below its cut */
    depth->sum_least = seen->b_least + depth->floor;
    depth->t_most = seen->c / depth->sum_least * ABOVE;
    depth->t_least = seen->c / (seen->b_most + sqrt(seen->size)) * BELOW;
    double tangent = sqrt(seen->c) * ABOVE, far = place->v_most * depth->t_most; /* |P| <= sqrt(c) */
    depth->p_most = far < tangent ? far : tangent;
    depth->p_least = sqrt(place->square_least) * depth->t_least * BELOW;
    struct last_bits bits = last_bits_of(primary, row, place, sphere, seen);
    bound_depth(&bits, seen, unit, depth);
}
