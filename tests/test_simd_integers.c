/* Steps of the integer code of render/span at random arguments, and its forms at its own t: no error exceeds what the
 * rows of src/simd/span/bounds allow for it. So a row that is too small for its step is detected here, even where the
 * other rows of a run's bounds have a reserve. */
#include "simd_integers.h"

#include "float_modes.h"
#include "simd_runs.h"
#include "simd_used.h"

/* ---- steps of the integer code ---- */

enum { SUMS, QUOTIENTS, COLOURS, COVERS, STEPS_THERE };
static struct used there[STEPS_THERE] = {
    {"S there", 0, 0}, {"c/S there", 0, 0}, {"colours there", 0, 0}, {"num_covers", 0, 0}};

/* Tries S = b + sqrt(D) of a sphere near the eye, whose D is nearly b^2: there the bound of D has the least reserve. */
static void try_sum_there(const struct primary_rays *primary)
{
    int64_t away = 1 + (int64_t)random_short(24), over = 1 + (int64_t)random_short(20);
    struct span_sphere sphere;
    struct sphere_line line;
    struct simd_row row;
    struct simd_place place;
    struct simd_seen seen;
    int x = 40 + (int)(random_u32() % 240), y = 40 + (int)(random_u32() % 160);

    span_sphere_prepare(primary, &sphere, (struct num_vec){0, 0, -(away + over)}, (tia_q16)away);
    tia_simd_row(primary, y, &row);
    tia_simd_place(primary, &row, x, x + 1, &place);
    if (!tia_simd_see(primary, &row, &place, &sphere, &seen) || seen.least < seen.b[0] * seen.b[0] * 0x1p-4)
        return;
    span_sphere_line(primary, &sphere, y, x, &line);
    num_u top = num_top_u(line.b), square = num_top_u(line.square.start);
    num_u root = num_sqrt(num_excess(num_mul_u(top, top), num_mul_u(line.c_disc, square)));
    struct simd_depth depth = {0};
    tia_simd_depth(primary, &row, &place, &sphere, &seen, 0, 0x1p-16, &depth);
    real pixel = row.per_depth * simd_power(primary->exponent);
    real ub = pixel * simd_power(16 - primary->exponent - sphere.b_shift), exact = seen.b[0] + sqrtl(seen.d[0]);
    real ut = simd_power(-sphere.t_exponent) / pixel;
    real rest = BOUND(SPAN_QUOTIENT) + BOUND(SPAN_T_UNIT) * ut / depth.t_least;
    use(&there[SUMS], ((real)top + root) * ub / exact - 1, depth.et - rest);
}

static void try_quotient_there(void)
{
    num_u sum = random_u32() | 1u << 31, whole = random_u32() | 1u << 31;
    real c = whole + random_real() / 2, exact = ldexpl(c / sum, 30);

    use(&there[QUOTIENTS], num_quotient(whole, sum, 33) - exact, exact * BOUND(SPAN_QUOTIENT) + BOUND(SPAN_T_UNIT));
}

static void try_colour_there(void)
{
    num_u lambert = random_u32() >> 2, colour = random_u32() >> 2, light = random_u32() >> 2;
    num_u product = num_colour_product(lambert, num_colour_product(colour, light));
    real exact = (real)lambert * colour * light * 0x1p-90L;

    use(&there[COLOURS], product * 0x1p-30L - exact, BOUND(SPAN_COLOUR_UNITS));
}

/* Tries a^2 >= d k (1 + B) near equality: where the two sides differ by more than the bound, num_covers gives the exact
 * result. */
static void try_covers_there(void)
{
    num_wide d = (num_wide)(random_bits() >> 3 | 1u << 20), k = (num_wide)(random_bits() >> 3 | 1u << 20);
    num_u swell = random_u32() >> 4;
    struct num_normal n = num_normal(d);
    real right = (real)d * (real)k * (1 + swell * 0x1p-32L), off = ldexpl(random_real(), -26);
    num_wide a = (num_wide)sqrtl(right * (1 + off));
    real left = (real)a * (real)a;
    if (a <= 0)
        return;
    bool covers = num_covers(a, num_normal_top(n), n.half, k, swell, 0);
    real bound = BOUND_OF(SPAN_COVERED, BOUND(SPAN_COVERED_CUT)); /* e_w and the kernels' roundings are 0 */
    use(&there[COVERS], covers == (left >= right) ? 0 : left / right - 1, bound);
}

TEST(steps_of_the_integer_code)
{
    unsigned count = check_count(2000000);
    struct primary_rays primary;

    primary_prepare(&primary, 320, 240, TIA_Q16(25));
    for (unsigned i = 0; i < count; i++) {
        if (i % 4 == 0)
            try_sum_there(&primary);
        try_quotient_there();
        try_colour_there();
        try_covers_there();
    }
    check_used(there, STEPS_THERE);
}

/* ---- the integer code at its own t ---- */

enum { T_LEAST, T_MOST, SQUARE, COSINE, TOWARD, POWER, INTEGERS };
static struct used integers[INTEGERS] = {{"1/t at least", 0, 0}, {"1/t at most", 0, 0}, {"|w|^2 there", 0, 0},
                                         {"cosine there", 0, 0}, {"A'.w there", 0, 0},  {"k there", 0, 0}};

/* Tries the casters of a pixel whose first light has been computed. */
static void try_casters(const struct simd_fine *f, const struct simd_depth *depth, const struct simd_bounds *light,
                        const struct simd_integers *o, real t)
{
    const struct span_view *spans = span_view_of(f->view);
    const struct simd_lamp *lamp = f->light[0].lamp;
    struct light_source source = {.sphere = &spans->spheres[f->sphere], .light = lamp->light};
    struct light_line line;

    light_line_prepare(&spans->primary, &source, f->first, f->row->y, &line);
    for (int j = 0; j < lamp->casts; j++) {
        const struct simd_caster *from = &lamp->cast[j];
        const struct simd_fine_cast *cast = &f->light[0].cast[j];
        struct simd_cast_bounds bounds;
        struct shadow_line shadow;
        shadow_line_prepare(&spans->primary, &source, &spans->spheres[from->sphere], f->first, f->row->y, &shadow);
        num signed_t = num_signed(o->t);
        num_wide a = shadow_toward(&shadow, num_mul(signed_t, num_top(shadow.a)), o->light.reach[0]);
        a -= shadow_bias(&shadow, o->light.facing[0], o->light.half[0]);
        num_wide k = shadow_power(&shadow, num_mul(signed_t, num_top(shadow.c)), o->light.reach[0]);
        tia_simd_bound_cast(&spans->primary, lamp, from, &f->place, depth, light, 0, 0, 0, &bounds);
        real vv = f->place.v0;
        use(&integers[TOWARD], a * (real)from->ua - (cast->a[0] + (cast->a[1] + vv * t) * t), bounds.a);
        use(&integers[POWER], k * (real)from->uk - (cast->k[0] + (cast->k[1] + vv * t) * t), bounds.k);
    }
}

/* Tries a pixel as a run of its own, whose forms are constants. Its t is known exactly, so that the error of t adds
 * nothing to the bounds. */
static void try_pixel(const struct simd_fine *f)
{
    const struct span_view *spans = span_view_of(f->view);
    const struct simd_lamp *lamp = f->light[0].lamp;
    struct simd_depth depth;
    struct simd_bounds bounds;
    double between[2];

    if (f->seen.least < f->seen.size * 0x1p-16)
        return;
    struct simd_integers o = simd_integers_at(f, f->first);
    double unit = f->row->per_depth * simd_power(spans->primary.exponent);
    real t = (real)o.t * simd_power(-simd_sphere_of(f)->t_exponent) / unit, vv = f->place.v0;
    tia_simd_between(&spans->primary, f->row, &f->place, simd_sphere_of(f), &f->seen, between);
    real exact = f->seen.c / (f->seen.b[0] + sqrtl(f->seen.d[0]));
    use(&integers[T_LEAST], fmaxl(exact - t, 0), exact - between[0]);
    tia_simd_depth(&spans->primary, f->row, &f->place, simd_sphere_of(f), &f->seen, 0, 0x1p-16, &depth);
    depth.es = depth.et = 0;
    tia_simd_bound_light(&spans->primary, lamp, &f->place, &depth, 0, 0, 0, &bounds);
    if (!o.lit || bounds.lambert > .01)
        return;
    real w = lamp->qq + (f->light[0].q[0] + vv * t) * t, facing = lamp->k + f->light[0].g[0] * t;
    use(&integers[SQUARE], o.light.square[0] * (real)lamp->ud / w - 1, bounds.square);
    use(&integers[COSINE], o.cosine * 0x1p-30L - fminl(facing * lamp->per_r / sqrtl(w), 1), bounds.lambert);
    try_casters(f, &depth, &bounds, &o, t);
}

/* Tries a pixel where the D of a sphere is almost 0: there the fixed-point t is largest. */
static void try_outline(const struct simd_fine *f)
{
    const struct span_view *spans = span_view_of(f->view);
    double between[2], unit = f->row->per_depth * simd_power(spans->primary.exponent);
    num_u t;

    tia_simd_between(&spans->primary, f->row, &f->place, simd_sphere_of(f), &f->seen, between);
    span_distances(spans, f->sphere, f->row->y, f->first, 1, &t);
    real scaled = (real)t * simd_power(-simd_sphere_of(f)->t_exponent) / unit;
    if (between[1] < SIMD_NEVER)
        use(&integers[T_MOST], scaled > between[1] ? 2 : 0, 1);
}

static void try_run(const struct simd_fine *run)
{
    static struct simd_fine one;

    for (int i = 0; i < run->end - run->first; i += 7)
        if (tia_simd_fine(run->view, run->row, run->sphere, run->first + i, run->first + i + 1, &one))
            try_pixel(&one);
    for (int i = 0; i < 2; i++) {
        int x = i ? run->end - 1 : run->first;
        if (tia_simd_fine(run->view, run->row, run->sphere, x, x + 1, &one))
            try_outline(&one);
    }
}

TEST(integers_at_their_own_t)
{
    simd_runs(1500, 12, try_run);
    check_used(integers, INTEGERS);
}

int main(void)
{
    float_mode_of_simd();
    RUN(steps_of_the_integer_code);
    RUN(integers_at_their_own_t);
    return check_status();
}
