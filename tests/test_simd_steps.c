/* Float sums of the kernels of src/simd/span at random arguments: no error exceeds what the row of src/simd/span/bounds
 * allows. So a row that is too small for its step is detected here, even where the other rows of a run's bounds have a
 * reserve. */
#include <float.h>

#include "float_modes.h"
#include "simd_used.h"
#include "vector_floats.h"

#include "simd/span/bounds.h"
#include "simd/span/kernel_tmpl.h"

#define U 0x1p-24L

/* Returns a number in -1..1 times a power of two of up to `bits` either way. */
static double any(int bits)
{
    return ldexp(random_double(), (int)(random_u32() % (2 * (unsigned)bits + 1)) - bits);
}

static F f_of(double a)
{
    return f_set((float)a);
}

/* ---- the kernels' sums ---- */

enum { LINEAR, SLOPE, QUADRATIC, SUM, ROOT, TERM, FACING, LAMBERT, COLOUR, LINE, DELTA, STEPS };
static struct used steps[STEPS] = {{"linear", 0, 0}, {"slope", 0, 0}, {"quadratic", 0, 0}, {"sum", 0, 0},
                                   {"root", 0, 0},   {"term", 0, 0},  {"facing", 0, 0},    {"lambert", 0, 0},
                                   {"colour", 0, 0}, {"line", 0, 0},  {"delta", 0, 0}};

static void try_linear(double x)
{
    double a = any(4), b = any(8);
    float sum = form1(f_of(x), (float)a, (float)b)[0];

    use(&steps[LINEAR], sum - (a + b * (real)x), BOUND(SPAN_LINEAR) * U * (fabs(a) + fabs(b * x)));
}

/* Tries D'/2 as take_samples() computes it. */
static void try_slope(double x)
{
    double d1 = any(6), d2 = any(8);
    F slope = f_fma(f_add(f_of(x), f_of(x)), f_of(d2), f_of(d1));

    use(&steps[SLOPE], slope[0] * .5L - (d1 + 2 * x * (real)d2) / 2,
        BOUND(SPAN_CELL_SLOPE) * U * (fabs(d1) + 2 * fabs(d2 * x)));
}

/* Tries D near its cut, S and sqrt(D). */
static void try_sum(double x)
{
    double d2 = any(6), d1 = any(6), size, least = BOUND_SPAN_FLOAT_CUT, b = fabs(any(3)) + 1;
    double d0 = -(d1 * x + d2 * x * x);
    size = fabs(d0) + fabs(d1 * x) + fabs(d2 * x * x);
    d0 += size * least * (1 + fabs(random_double()));
    size = fabs(d0) + fabs(d1 * x) + fabs(d2 * x * x);
    b = sqrt(size) * (1 + fabs(random_double()));
    struct body k = {.b0 = f_of(b), .d0 = f_of(d0), .d1 = f_of(d1), .d2 = f_of(d2)};
    struct value o = value_at(&k, f_of(x));
    real exact = d0 + x * (d1 + x * (real)d2), cut = (real)size * BOUND_SPAN_FLOAT_CUT;

    use(&steps[QUADRATIC], o.d[0] - exact, BOUND(SPAN_QUADRATIC) * U * size);
    real root = sqrtl(o.d[0]), sum = (float)b + root;
    use(&steps[SUM], o.s[0] - sum, BOUND(SPAN_SUM) * U * sum);
    if (o.d[0] >= (float)cut) {
        real floor = sqrtl(cut * (1 - BOUND(SPAN_FLOOR)));
        use(&steps[ROOT], root - sqrtl(exact), BOUND_OF(SPAN_ROOT, fabsl(o.d[0] - exact) / (2 * floor)));
    }
}

/* Tries the forms of a light: |w|^2, and the numerator k S + g of the cosine. */
static void try_forms(double x)
{
    double qq = any(4), q0 = any(4), q1 = any(8), v0 = fabs(any(2)), v1 = any(6), v2 = any(10), k = any(4), g0 = any(4),
           g1 = any(8);
    float s = (float)fabs(any(4));
    struct value o = {.s = f_set(s), .vv = f_fma(f_of(x), f_fma(f_of(x), f_of(v2), f_of(v1)), f_of(v0))};
    struct simd_light q = {
        .qq = (float)qq, .q0 = (float)q0, .q1 = (float)q1, .k = (float)k, .g0 = (float)g0, .g1 = (float)g1, .per_r = 1};
    real vv = v0 + x * (v1 + x * (real)v2), vs = fabs(v0) + fabs(v1 * x) + fabs(v2 * x * x);
    real w = s * (real)s * qq + s * (q0 + q1 * (real)x) + vv, facing = s * (real)k + g0 + g1 * (real)x;

    use(&steps[TERM], square_of(&q, f_of(x), &o)[0] - w,
        BOUND(SPAN_TERM) * U * (fabs(qq) * s * s + s * (fabs(q0) + fabs(q1 * x)) + vs));
    use(&steps[FACING], lambert_of(&q, f_of(x), &o, f_set(1))[0] - facing,
        BOUND(SPAN_FACING) * U * fabs(k) * s + BOUND(SPAN_TURN) * U * (fabs(g0) + fabs(g1 * x)));
}

/* Tries the cosine from S, |w|^2 and 1/r; then the colour for the kernel's cosine. */
static void try_colour(double x)
{
    double per_r = fabs(any(4)), square = fabs(any(4)) + .001, own = fabs(random_double()),
           colour = fabs(random_double());
    struct value o = {.s = f_set((float)fabs(any(4))), .vv = f_of(square)};
    struct simd_light q = {.k = 1, .per_r = (float)per_r};
    real exact = o.s[0] * per_r / sqrtl((float)square);
    F lambert = lambert_of(&q, f_of(x), &o, f_of(square));

    use(&steps[LAMBERT], lambert[0] - exact, BOUND(SPAN_LAMBERT) * U * exact);
    double cosine = fabs(random_double());
    q = (struct simd_light){.k = 1, .per_r = 1, .qq = 0, .colour = {(float)colour}};
    o = (struct value){.s = f_of(cosine), .vv = f_set(1)}; /* |w|^2 is 1 */
    F sum[3] = {f_of(own), f_of(own), f_of(own)};
    (void)add_light(&q, f_of(x), &o, sum, 1, 0);
    real whole = fminl(1, (float)own + (real)(float)cosine * colour);
    use(&steps[COLOUR], sum[0][0] - whole,
        BOUND(SPAN_COLOUR) * U * (real)cosine * colour + BOUND(SPAN_COLOUR_SUM) * U * whole);
}

static void try_line(void)
{
    static struct lines lines;
    const float colour[3] = {1, 1, 1};
    double start = random_double(), end = random_double(), middle = random_double();
    F tint[3] = {f_set(1), f_set(1), f_set(1)};

    lines.lambert[0] = (float)start;
    lines.lambert[1] = (float)end;
    store_lines(&lines, 0, f_of(middle), tint, colour, 1);
    real s = (float)start, e = (float)end, m = (float)middle;
    for (int i = -HALF_CELL; i < HALF_CELL; i++) {
        F at = f_set((float)i);
        F line = f_fma(at, f_set(lines.turn_of[0]), f_set(lines.middle[0]));
        F got = f_fma(f_abs(at), f_set(lines.bend_of[0]), line);
        real t = (real)i / HALF_CELL, exact = m + t * (e - s) / 2 + fabsl(t) * ((s - m) + (e - m)) / 2;
        use(&steps[LINE], got[0] - exact, BOUND(SPAN_LINE) * U);
    }
}

static void try_delta(void)
{
    float a = (float)any(4), w = (float)fabs(any(4)), k = (float)fabs(any(4));
    double swell = 1 + fabs(any(4));
    float delta = f_fnma(f_mul(f_set(w), f_set(k)), f_of(swell), f_mul(f_set(a), f_set(a)))[0];
    real left = (real)a * a, right = (real)w * k * swell;

    use(&steps[DELTA], delta - (left - right), BOUND(SPAN_DELTA) * U * (left + right));
}

TEST(sums_of_the_kernels)
{
    unsigned count = check_count(400000);

    for (unsigned i = 0; i < count; i++) {
        double x = (double)(int)(random_u32() % 2048) - 1024;
        try_linear(x);
        try_slope(x);
        try_sum(x);
        try_forms(x);
        try_colour(x);
        try_line();
        try_delta();
    }
    check_used(steps, STEPS);
}

/* ---- levels, and the nearer of two ---- */

/* A channel near the boundary between two levels: a level that the kernel reports as sure is the exact one. */
TEST(levels_of_the_kernels)
{
    unsigned count = check_count(4000000), sure = 0;
    double near = tia_simd_bound_level(63, 0, 0x1p-24);

    for (unsigned i = 0; i < count; i++) {
        double half = random_double() / 2, y = random_u32() % 62 + 1 + .5 + ldexp(random_double(), -14);
        double channel = (y - half) / 63;
        F sum[3] = {f_of(channel), f_of(channel), f_of(channel)};
        struct levels found = levels_of(sum, f_of(half), f_of(near), f_of(near), true);
        bool known = m_bits(found.sure) & 1;
        sure += known;
        CHECK_MSG(!known || found.green[0] == floor(y + .5), "%.9f of a level is %g", y, (double)found.green[0]);
    }
    CHECK(sure > count / 4);
}

/* A shadow ray that nearly touches a sphere: if the kernel decides whether it is blocked, the decision is exact. The
 * forms have no errors but the kernel's own roundings. */
TEST(verdicts_of_the_kernels)
{
    unsigned count = check_count(2000000), sure = 0;
    double ew = BOUND_OF(SPAN_COVERED, BOUND(SPAN_DELTA) * (double)U); /* e_w is 0 */

    for (unsigned i = 0; i < count; i++) {
        float a = (float)ldexp(1 + fabs(random_double()), -2), w = 1 + (float)fabs(random_double());
        struct simd_cast cast = {.swell = 1 + (float)fabs(random_double()) / 8, .ends = 1};
        float k = a * a / (w * cast.swell) * (float)(1 + ldexp(random_double(), -20));
        cast.ew = (float)(ew * (1 + BOUND(SPAN_VERDICT_W)));
        struct toward t = {f_set(a), f_set(k), f_set(1)};
        struct verdict v = judge(&cast, &t, f_set(w), f_set(0), f_set(0));
        real left = (real)a * a, right = (real)w * k * cast.swell;
        bool lit = m_bits(v.lit) & 1, dark = m_bits(v.dark) & 1;
        sure += lit || dark;
        CHECK_MSG(!(lit && left > right) && !(dark && left < right), "%g, %g, %g", (double)a, (double)w, (double)k);
    }
    CHECK(sure > count / 4);
}

/* Two spheres at nearly the same distance: if the kernel decides which is nearer, the decision is exact. Their 1/t have
 * no errors but the kernel's own roundings. */
TEST(distances_of_the_kernels)
{
    unsigned count = check_count(2000000), sure = 0;
    float bound = (float)BOUND_OF(SPAN_NEARER, BOUND(SPAN_NEARER_ROUNDING)); /* e_s and e_t are 0 */

    for (unsigned i = 0; i < count; i++) {
        float s = 1 + (float)fabs(random_double()), t = 1 + (float)fabs(random_double());
        double c = 1 + fabs(random_double()), d = c / (double)s * t * (1 + ldexp(random_double(), -19));
        struct simd_pair pair = {.count = 1,
                                 .body = {{.b0 = s, .per_c = (float)(1 / c)}, {.b0 = t, .per_c = (float)(1 / d)}},
                                 .bound = {bound, bound}};
        uint64_t win, open;
        nearer(&pair, &win, &open);
        sure += !open;
        bool first = (real)s / c > (real)t / d;
        CHECK_MSG(open || (win & 1) == first, "%g/%g and %g/%g", (double)s, c, (double)t, d);
    }
    CHECK(sure > count / 4);
}

int main(void)
{
    float_mode_of_simd();
#if FLT_EVAL_METHOD == 0
    RUN(sums_of_the_kernels);
    RUN(levels_of_the_kernels);
    RUN(verdicts_of_the_kernels);
    RUN(distances_of_the_kernels);
#endif
    return check_status();
}
