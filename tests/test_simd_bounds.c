/* The error bounds of src/simd: no error exceeds them, and the worst of some thousand runs has more than a tenth of its
 * bound. So a bound of a tenth of the right size is detected here. */
#include "float_modes.h"
#include "simd/span/proved.h"
#include "simd_integers.h"
#include "simd_runs.h"
#include "simd_used.h"

enum { FLOAT_T, INTEGER_T, LAMBERT, SQUARE, BOUNDS };
static struct used bounds[BOUNDS] = {
    {"float's 1/t", 0, 0}, {"the integer t", 0, 0}, {"the integer cosine", 0, 0}, {"the integer |w|^2", 0, 0}};

/* Returns 1/t of a pixel, accurate to about 60 bits for the given coefficients, which are accurate to 50 bits relative
 * to the size of D. */
static long double per_t(const struct simd_fine *f, long double x)
{
    const double *b = f->seen.b, *d = f->seen.d;
    long double depth = d[0] + x * (d[1] + x * (long double)d[2]);

    return ((long double)b[0] + b[1] * x + sqrtl(depth)) / f->seen.c;
}

static void try_float(const struct simd_fine *f, int i)
{
    const double *b = f->seen.b, *d = f->seen.d;
    float x = (float)(f->place.low + i), depth = (float)d[0] + x * ((float)d[1] + x * (float)d[2]);
    float root = sqrtf(depth), s = (float)b[0] + (float)b[1] * x + root;
    long double exact = per_t(f, x) * f->seen.c;

    if (depth >= (float)f->depth.cut)
        use(&bounds[FLOAT_T], (s - exact) / exact, f->depth.es);
}

/* Compares the fixed-point t, |w|^2 and cosine of the first light with exact ones; the bounds are for kernels without
 * roundings. */
static void try_integers(const struct simd_fine *f, int i)
{
    const struct span_view *spans = span_view_of(f->view);
    const struct span_sphere *sphere = &spans->spheres[f->sphere];
    const struct simd_fine_light *light = &f->light[0];
    const struct simd_lamp *lamp = light->lamp;
    struct simd_integers o = simd_integers_at(f, f->first + i);
    long double at = f->place.low + i, exact = per_t(f, at);
    double unit = f->row->per_depth * simd_power(spans->primary.exponent);
    long double scaled = (long double)o.t * simd_power(-sphere->t_exponent) / unit;
    use(&bounds[INTEGER_T], scaled * exact - 1, f->depth.et);
    if (!o.lit)
        return;
    long double vv = f->place.v0 + at * (f->place.v1 + at * (long double)f->place.v2);
    long double w = (lamp->qq * exact + light->q[0] + light->q[1] * at) * exact + vv;
    long double facing = lamp->k * exact + light->g[0] + light->g[1] * at;
    use(&bounds[SQUARE], o.light.square[0] * (long double)lamp->ud * exact * exact / w - 1, light->bounds.square);
    use(&bounds[LAMBERT], o.cosine * 0x1p-30L - facing * lamp->per_r / sqrtl(w), light->bounds.lambert);
}

static void try_run(const struct simd_fine *run)
{
    static struct simd_fine fine;
    int count = run->end - run->first;

    fine = *run;
    if (tia_simd_fine_bounds(&fine, SIMD_FLOAT, SIMD_FLOAT_CUT, NULL))
        for (int i = 0; i < count; i += 3)
            try_float(&fine, i);
    if (!tia_simd_fine_bounds(&fine, 0, SIMD_DOUBLE_CUT, NULL))
        return;
    for (int i = 0; i < count; i += 5) {
        double x = fine.place.low + i, *d = fine.seen.d;
        if (d[0] + x * (d[1] + x * d[2]) >= fine.depth.cut)
            try_integers(&fine, i);
    }
}

TEST(bounds_hold_and_are_not_ten_times_too_wide)
{
    simd_runs(1500, 12, try_run);
    check_tight(bounds, BOUNDS);
}

int main(void)
{
    float_mode_of_simd();
    RUN(bounds_hold_and_are_not_ten_times_too_wide);
    return check_status();
}
