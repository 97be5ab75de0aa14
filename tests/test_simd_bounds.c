/* The bounds of the kernels of src/simd/span against 113 bits: no error exceeds them, and the worst of some thousand
 * runs has more than a tenth of its bound. So a bound of a tenth of the right size is detected here. */
#include "float_modes.h"
#include "simd_runs.h"
#include "simd_truth.h"
#include "simd_used.h"
#include "vector_floats.h"

#include "simd/span/kernel_tmpl.h"

enum { FLOAT_T, SQUARE, LAMBERT, TOWARD, POWER, NEAR, FAR, BOUNDS };
static struct used bounds[BOUNDS] = {{"1/t", 0, 0}, {"|w|^2", 0, 0},      {"the cosine", 0, 0}, {"A'.w", 0, 0},
                                     {"k", 0, 0},   {"t at least", 0, 0}, {"t at most", 0, 0}};

/* A pixel of a run, in floats and exactly. */
struct tried {
    const struct simd_fine *fine;
    const struct simd_run *run;
    struct truth truth;
    struct value value;
    quad t; /* at depth 1 */
    float x;
};

static void try_caster(const struct tried *p, const struct truth_way *way, int l, int j)
{
    const struct tia_scene *scene = p->fine->view->scene;
    const struct simd_caster *from = &p->fine->light[l].lamp->cast[j];
    const struct simd_cast_bounds *b = &p->fine->cast[p->fine->light[l].first + j].bounds;
    const struct tia_sphere *sphere = &scene->spheres[from->sphere];
    struct toward got = toward_caster(&p->run->light[l].cast[j], f_set(p->x), &p->value);
    struct truth_caster exact;
    quad centre[3], square = p->t * p->t;

    truth_place(scene, sphere->centre, centre);
    truth_approach(&p->truth, way, centre, (quad)sphere->radius / 65536, &exact);
    use(&bounds[TOWARD], (real)(got.a[0] * square - exact.a), b->a);
    use(&bounds[POWER], (real)(got.k[0] * square - exact.h / (1 + (quad)p->fine->light[l].lamp->swell)), b->k);
}

/* Returns the place of a lamp's light. */
static struct tia_vec3 light_of(const struct tia_view *view, const struct simd_lamp *lamp)
{
    const struct tia_vec3 *eye = &view->scene->camera.eye;

    return (struct tia_vec3){(tia_q16)(lamp->light.x + eye->x), (tia_q16)(lamp->light.y + eye->y),
                             (tia_q16)(lamp->light.z + eye->z)};
}

static void try_lights(const struct tried *p)
{
    const struct tia_view *view = p->fine->view;

    for (int l = 0; l < p->fine->lights; l++) {
        const struct simd_lamp *lamp = p->fine->light[l].lamp;
        const struct simd_light *light = &p->run->light[l];
        const struct simd_bounds *b = &p->fine->light[l].bounds;
        F square = square_of(light, f_set(p->x), &p->value);
        F cosine = lambert_of(light, f_set(p->x), &p->value, square);
        struct truth_way way;
        quad q[3];
        truth_place(view->scene, light_of(view, lamp), q);
        truth_look(&p->truth, q, &way);
        use(&bounds[SQUARE], (real)(square[0] * p->t * p->t / way.square - 1), b->square);
        use(&bounds[LAMBERT], (real)(cosine[0] - way.cosine), b->lambert);
        for (int j = 0; j < p->run->light[l].casts; j++)
            try_caster(p, &way, l, j);
    }
}

static void try_pixel(const struct simd_fine *f, const struct simd_run *run, quad depth, int i)
{
    const struct tia_sphere *sphere = &f->view->scene->spheres[f->sphere];
    const struct body body = body_of(run);
    const int size[2] = {(int)f->view->width, (int)f->view->height};
    struct tried p = {.fine = f, .run = run, .x = (float)(f->place.low + i)};
    double between[2];

    truth_meet(f->view->scene, size, depth, f->first + i, f->row->y, sphere->centre, sphere->radius, &p.truth);
    p.t = p.truth.t * depth;
    tia_simd_between(f->row, simd_sphere_of(f), &f->seen, between);
    if (p.truth.d < 0)
        return;
    use(&bounds[NEAR], p.t < between[0] ? 2 : between[0], (real)p.t);
    if (between[1] < SIMD_NEVER)
        use(&bounds[FAR], p.t > between[1] ? 2 * between[1] : (real)p.t, between[1]);
    p.value = value_at(&body, f_set(p.x));
    if (!(m_bits(p.value.good) & 1))
        return;
    use(&bounds[FLOAT_T], (real)(p.value.s[0] / (quad)f->seen.c * p.t - 1), f->depth.es + f->depth.et);
    try_lights(&p);
}

static void try_run(const struct simd_fine *run)
{
    static struct simd_fine fine;
    static struct simd_run floats;
    quad depth = truth_depth((unsigned)run->view->height, run->view->scene->camera.fov);
    struct simd_dither dither;
    int count = run->end - run->first;

    fine = *run;
    if (!tia_simd_fine_bounds(&fine, NULL))
        return;
    tia_simd_dither(false, fine.row->y, &dither);
    tia_simd_run(&fine, &dither, &floats);
    for (int i = 0; i < count; i += 1 + count / 12)
        try_pixel(&fine, &floats, depth, i);
    try_pixel(&fine, &floats, depth, count - 1); /* at the outline */
}

TEST(bounds_hold_and_are_not_ten_times_too_wide)
{
    simd_runs(1500, 12, try_run);
    check_tight(bounds, BOUNDS);
}

int main(void)
{
    float_mode_of_simd();
#if FLT_EVAL_METHOD == 0
    RUN(bounds_hold_and_are_not_ten_times_too_wide);
#endif
    return check_status();
}
