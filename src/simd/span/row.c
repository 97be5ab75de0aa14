#include "row.h"

#include <math.h>

#include "bound_table.h"

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

#define ABOVE (1 + BOUND(SPAN_RANGE))
#define BELOW (1 - BOUND(SPAN_RANGE))

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
    int64_t low = (int64_t)r; /* signed: so each half is converted by an instruction, not a call */

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
    seen->least = least_of(seen->d, place) - seen->size * BOUND(SPAN_RANGE);
    double left = seen->b[0] + place->low * seen->b[1], right = seen->b[0] + place->high * seen->b[1];
    seen->b_most = larger(left, right) * ABOVE;
    seen->b_least = (left < right ? left : right) - seen->b_most * BOUND(SPAN_RANGE);
    return seen->b_least > 0 && seen->size > 0;
}

/* The last bits of b and t in the integer code (render/span/span_sphere.c, kernels.c), and the bound of its error of D.
 * b and v.v are upper halves of accumulators. The last bits of b, v.v and c are ub, uv and uc. */
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
                              BOUND(SPAN_D_UNITS) *
                                  (2 * b * ub + ub * ub + seen->c * uv + place->square_most * uc + uv * uc)};
}

/* Bounds the relative errors of S = b + sqrt(D), in an arithmetic with the rounding unit `unit`, and of t in the
 * integer code. */
static void bound_depth(const struct last_bits *u, const struct simd_seen *seen, double unit, struct simd_depth *depth)
{
    double b = seen->b_most, b_off = BOUND(SPAN_LINEAR) * b;
    double off = b_off + BOUND_OF(SPAN_ROOT, BOUND(SPAN_QUADRATIC) * seen->size / (2 * depth->floor));

    depth->es = BOUND_OF(SPAN_KERNELS_T, unit * (off / depth->sum_least + BOUND(SPAN_SUM)));
    depth->et = BOUND_OF(SPAN_INTEGER_T, (BOUND(SPAN_SUM_UNITS) * u->ub + u->dd / depth->floor) / depth->sum_least +
                                             BOUND(SPAN_QUOTIENT) + BOUND(SPAN_T_UNIT) * u->ut / depth->t_least);
    depth->mantissa_most = depth->t_most / u->ut + 1;
}

/* Finds a range of t = c/(b + sqrt(D)). The integer code's root is at least 0 and, being rounded down, at most the root
 * of D's size and error: so the range holds for any D. */
void tia_simd_between(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                      const struct span_sphere *sphere, const struct simd_seen *seen, double t[2])
{
    struct last_bits u = last_bits_of(primary, row, place, sphere, seen);
    double ub = BOUND_OF(SPAN_BETWEEN_B, u.ub), ut = BOUND_OF(SPAN_BETWEEN_UNIT, u.ut);
    double least = seen->b_least - ub, most = seen->b_most + ub + sqrt(seen->size + u.dd) * ABOVE;

    t[0] = seen->c / most * (1 - BOUND(SPAN_BETWEEN_QUOTIENT)) - ut;
    t[1] = least > 0 ? seen->c / least * (1 + BOUND(SPAN_BETWEEN_QUOTIENT)) + ut : SIMD_NEVER;
}

void tia_simd_depth(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                    const struct span_sphere *sphere, const struct simd_seen *seen, double unit, double cut,
                    struct simd_depth *depth)
{
    bool all = seen->least > seen->size * cut * (1 + BOUND(SPAN_CUT_CLEAR));

    depth->cut = all ? 0 : seen->size * cut;
    depth->floor = sqrt((all ? seen->least : depth->cut) * (1 - BOUND(SPAN_FLOOR)));
    depth->sum_least = seen->b_least + depth->floor;
    depth->t_most = seen->c / depth->sum_least * ABOVE;
    depth->t_least = seen->c / (seen->b_most + sqrt(seen->size)) * BELOW;
    double tangent = sqrt(seen->c) * ABOVE, far = place->v_most * depth->t_most; /* |P| <= sqrt(c) */
    depth->p_most = far < tangent ? far : tangent;
    depth->p_least = sqrt(place->square_least) * depth->t_least * BELOW;
    struct last_bits bits = last_bits_of(primary, row, place, sphere, seen);
    bound_depth(&bits, seen, unit, depth);
}
