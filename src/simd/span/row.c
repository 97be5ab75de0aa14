#include "row.h"

#include <math.h>

#include "bound_table.h"

void tia_simd_row(const struct span_view *spans, int y, struct simd_row *row)
{
    const struct primary_rays *primary = &spans->primary;
    const struct exact_depth *k = &spans->depth;
    uint64_t whole = (uint64_t)k->m[1] << 32 | k->m[0];
    int more = -(k->e + primary->exponent); /* bits of K below the last bit of K0, 32 to 63 */
    double k0 = (double)primary->depth;

    simd_row_to(primary, y, row);
    row->lacks = (double)(int64_t)(whole - ((uint64_t)primary->depth << more)) * simd_power(-more);
    row->lacks2 = row->lacks * (2 * k0 + row->lacks);
    row->depth = k0 + row->lacks;
    row->turn = BOUND_OF(SPAN_AXIS, BOUND(SPAN_AXIS_K) + BOUND(SPAN_AXIS_ADDED) * fabs(row->lacks) / k0);
    row->per_depth = 1 / row->depth;
    row->per_depth2 = row->per_depth * row->per_depth;
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
    num_wide x = simd_across(primary, place->middle);
    place->v0 = ((double)(x * x + row->square) + row->lacks2) * row->per_depth2;
    place->v1 = (double)(2 * x * step) * row->per_depth2;
    place->v2 = (double)(step * step) * row->per_depth2;
    place->square_most = larger(quadratic(place->v0, place->v1, place->v2, place->low),
                                quadratic(place->v0, place->v1, place->v2, place->high)) *
                         ABOVE;
    place->square_least = ((double)row->square + row->lacks2) * row->per_depth2 * BELOW;
    place->v_most = sqrt(place->square_most) * ABOVE;
    place->v_step = (double)step * row->per_depth * ABOVE;
}

void tia_simd_form(const struct primary_rays *primary, const struct simd_row *row, const struct simd_place *place,
                   struct num_vec a, double c[2])
{
    num_wide x = simd_across(primary, place->middle), step = num_pixel_coordinate(2, primary->exponent);
    double scale = row->per_depth * 0x1p-16;

    c[0] = ((double)simd_product(primary, row, a, x) - (double)a.z * row->lacks) * scale;
    c[1] = (double)(a.x * step) * scale;
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
    num_wide x = simd_across(primary, place->middle), step = num_pixel_coordinate(2, primary->exponent);
    struct num_vec l = sphere->centre;
    num_wide b = simd_product(primary, row, l, x), b_step = l.x * step, c = sphere->c;
    double scale = row->per_depth2 * 0x1p-32, z_lacks = (double)l.z * row->lacks;

    if (c <= 0)
        return false;
    seen->c = (double)c * 0x1p-32;
    seen->b[0] = ((double)b - z_lacks) * row->per_depth * 0x1p-16;
    seen->b[1] = (double)b_step * row->per_depth * 0x1p-16;
    seen->d[0] = simd_discriminant(primary, row, sphere, b, x) * scale;
    seen->d[1] = 2 * (simd_difference(b, b_step, c, x * step) - z_lacks * (double)b_step) * scale;
    seen->d[2] = simd_difference(b_step, b_step, c, step * step) * scale;
    seen->size = fabs(seen->d[0]) + (fabs(seen->d[1]) + fabs(seen->d[2]) * place->reach) * place->reach;
    seen->least = least_of(seen->d, place) - seen->size * BOUND(SPAN_RANGE);
    double left = seen->b[0] + place->low * seen->b[1], right = seen->b[0] + place->high * seen->b[1];
    seen->b_most = larger(left, right) * ABOVE;
    seen->b_least = (left < right ? left : right) - seen->b_most * BOUND(SPAN_RANGE);
    return seen->b_least > 0 && seen->size > 0;
}

/* ---- bounds ---- */

/* Bounds of the errors of b and D that the error of K causes: at depth 1, v's component along the axis is off by
 * `turn`. */
struct turned {
    double b, d;
};

static struct turned turned_by(const struct simd_row *row, const struct span_sphere *sphere,
                               const struct simd_seen *seen)
{
    double z = fabs((double)sphere->centre.z) * 0x1p-16, turn = row->turn;

    return (struct turned){BOUND_OF(SPAN_AXIS_B, z * turn),
                           BOUND_OF(SPAN_AXIS_D, 2 * turn * (seen->b_most * z + seen->c))};
}

/* Bounds the relative errors of S = b + sqrt(D), in an arithmetic with the rounding unit `unit`, and of P by the error
 * of K. */
static void bound_depth(const struct simd_row *row, const struct turned *off, const struct simd_seen *seen, double unit,
                        struct simd_depth *depth)
{
    double b = seen->b_most, b_off = BOUND(SPAN_LINEAR) * b;
    double rounded = b_off + BOUND_OF(SPAN_ROOT, BOUND(SPAN_QUADRATIC) * seen->size / (2 * depth->floor));

    depth->es = BOUND_OF(SPAN_KERNELS_T, unit * (rounded / depth->sum_least + BOUND(SPAN_SUM)));
    depth->et = BOUND_OF(SPAN_AXIS_P, ((off->b + off->d / depth->floor) / depth->sum_least + row->turn) *
                                          (1 + BOUND(SPAN_AXIS_SECOND)));
}

/* Finds a range of t = c/(b + sqrt(D)). The root is at least 0 and at most that of D's size, so the range holds for any
 * D. */
void tia_simd_between(const struct simd_row *row, const struct span_sphere *sphere, const struct simd_seen *seen,
                      double t[2])
{
    struct turned off = turned_by(row, sphere, seen);
    double least = seen->b_least - off.b, most = seen->b_most + off.b + sqrt(seen->size + off.d) * ABOVE;

    t[0] = seen->c / most * BELOW;
    t[1] = least > 0 ? seen->c / least * ABOVE : SIMD_NEVER;
}

void tia_simd_depth(const struct simd_row *row, const struct simd_place *place, const struct span_sphere *sphere,
                    const struct simd_seen *seen, double unit, double cut, struct simd_depth *depth)
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
    struct turned off = turned_by(row, sphere, seen);
    bound_depth(row, &off, seen, unit, depth);
}
