/* Single pixels in doubles, src/simd/span/exact.c, against 113 bits: no error exceeds its bound. Doubles do not decide
 * which of two equal distances is nearer, nor a level next to a boundary wrongly. */
#include "float_modes.h"
#include "simd_runs.h"
#include "simd_truth.h"
#include "simd_used.h"

#include "simd/span/point.c"

#undef U
#include "simd/span/exact.c"
#include "simd/span/seen.c"

#define STEP 65536 /* the units of exact.c in a length */

enum { DISTANCE, POINT, START, SQUARE, COSINE, TOWARD, POWER, DELTA, CHANNEL, BOUNDS };
static struct used bounds[BOUNDS] = {
    {"t", 0, 0},   {"P", 0, 0},           {"the start", 0, 0},         {"|w|^2", 0, 0},    {"cosine", 0, 0},
    {"A.w", 0, 0}, {"|A|^2 - R^2", 0, 0}, {"(A.w)^2 - h |w|^2", 0, 0}, {"a channel", 0, 0}};

static quad distance(const double got[3], const quad exact[3])
{
    quad d[3];

    for (int i = 0; i < 3; i++)
        d[i] = got[i] - exact[i] * STEP;
    return quad_root(quad_dot(d, d));
}

static void try_caster(const struct simd_seat *seat, const struct simd_point *o, const struct way *way,
                       const struct truth *truth, const struct truth_way *truth_way, uint32_t j)
{
    const struct tia_scene *scene = seat->view->scene;
    const struct span_sphere *caster = &span_view_of(seat->view)->spheres[j];
    struct meeting m = meet(o, way, caster);
    struct truth_caster exact;
    quad centre[3];

    truth_place(scene, scene->spheres[j].centre, centre);
    truth_approach(truth, truth_way, centre, (quad)scene->spheres[j].radius / STEP, &exact);
    quad unit = (quad)STEP * STEP, delta = exact.a * exact.a - exact.h * truth_way->square;
    use(&bounds[TOWARD], (real)(m.a - exact.a * unit), m.e_a);
    use(&bounds[POWER], (real)(m.h - exact.h * unit), m.e_h);
    use(&bounds[DELTA], (real)(m.delta - delta * unit * unit), m.e_delta);
}

/* Tries the lights of a pixel, and its red channel without shadows. */
static void try_lights(const struct matter *m, uint32_t sphere, const struct simd_point *o, const struct truth *truth)
{
    const struct simd_seat *seat = &m->seat;
    const struct tia_view *view = seat->view;
    const struct tia_scene *scene = view->scene;
    const struct tia_material *material = &scene->materials[scene->spheres[sphere].material];
    quad channel = (quad)material->emission.r * 0x1p-30;
    struct sum sum = {.channel = {(double)channel, 0, 0}};

    for (uint32_t l = 0; l < view->light_count; l++) {
        struct simd_lamp lamp = *simd_lamp_of(view, sphere, l);
        struct truth_way exact;
        struct way way;
        double cosine;
        quad q[3];
        truth_place(scene, view->lights[l].centre, q);
        truth_look(truth, q, &exact);
        if (!aim(seat, o, lamp.light, &way, &cosine))
            return;
        use(&bounds[SQUARE], (real)(way.square / (exact.square * STEP * STEP) - 1), way.e_w);
        use(&bounds[COSINE], (real)(cosine - exact.cosine), way.e_c);
        for (uint32_t j = 0; j < scene->sphere_count; j++)
            if (j != sphere)
                try_caster(seat, o, &way, truth, &exact, j);
        lamp.shades = 0;
        lamp.colour[0] = (double)material->colour.r * 0x1p-30 * ((double)view->lights[l].emission.r * 0x1p-30);
        if (!add_light(m, &lamp, &(struct simd_blockers){0}, o, &sum))
            return;
        quad colour = (quad)material->colour.r * view->lights[l].emission.r * 0x1p-60;
        channel += exact.cosine > 0 ? exact.cosine * colour : 0;
    }
    use(&bounds[CHANNEL], (real)(sum.channel[0] - (channel > 1 ? 1 : channel)), sum.off[0]);
}

static void try_pixel(const struct matter *m, uint32_t number, quad depth, int x)
{
    const struct simd_seat *seat = &m->seat;
    const struct simd_row *row = seat->row;
    const struct tia_view *view = seat->view;
    const struct tia_sphere *sphere = &view->scene->spheres[number];
    const int size[2] = {(int)view->width, (int)view->height};
    struct simd_distance at;
    struct truth truth;
    struct simd_point o;

    if (!simd_distance_at(seat->primary, row, x, seat->sphere, &at) || !tia_simd_point(seat, x, &o))
        return;
    truth_meet(view->scene, size, depth, x, row->y, sphere->centre, sphere->radius, &truth);
    quad t = truth.t * STEP / ((quad)1 * ((num_wide)1 << seat->primary->exponent));
    use(&bounds[DISTANCE], (real)(at.t / t - 1), at.off);
    use(&bounds[POINT], (real)distance(o.p, truth.p), o.moved);
    use(&bounds[START], (real)distance(o.start, truth.start), o.started);
    try_lights(m, number, &o, &truth);
}

static void try_run(const struct simd_fine *run)
{
    static const num_u threshold[THRESHOLDS];
    const struct simd_pixels pixels = {run->view, run->row, run->sphere, NULL, run->first, threshold, NULL};
    quad depth = truth_depth((unsigned)run->view->height, run->view->scene->camera.fov);
    struct matter m;

    take_matter(&pixels, &m);
    for (int x = run->first; x < run->end; x += 1 + (run->end - run->first) / 6)
        try_pixel(&m, run->sphere, depth, x);
    if (run->end > run->first)
        try_pixel(&m, run->sphere, depth, run->end - 1); /* at the outline */
}

TEST(pixels_in_doubles)
{
    simd_runs(1500, 12, try_run);
    check_used(bounds, BOUNDS);
}

/* ---- levels ---- */

/* A channel next to the boundary between two levels. A level that is decided is the exact one. */
TEST(levels_in_doubles)
{
    unsigned count = check_count(2000000), sure = 0;

    for (unsigned i = 0; i < count; i++) {
        num_u threshold = random_u32() >> 2;
        double y = random_u32() % 62 + 1 + ldexp(random_double(), -43);
        struct sum sum = {.channel = {(y - threshold * 0x1p-30) / 63}, .lit = {true}};
        quad exact = (quad)sum.channel[0] * 63 + threshold * (quad)0x1p-30;
        unsigned level;
        if (exact < 0 || !quantise(&sum, 0, 0, 63, threshold, &level))
            continue;
        sure++;
        CHECK_MSG(level <= exact && exact < level + 1, "%.17g of a level is %u", y, level);
    }
    CHECK(sure > count / 8);
}

/* A channel without light is exact: a tie is rounded up. */
TEST(ties_of_emissions)
{
    for (unsigned level = 0; level < 63; level++) {
        const tia_q30 emission = TIA_Q30_ONE / 2;
        struct sum sum = {.channel = {.5}};
        unsigned got = 0;
        CHECK(quantise(&sum, 0, emission, 2 * level + 1, NUM_ROUND, &got));
        CHECK_EQ(got, level + 1);
    }
}

/* ---- the nearer of two ---- */

static struct tia_sphere pair[2];

/* Two spheres at the same distance in the middle of a picture: in either order the first stays. */
static void try_tie(unsigned width, unsigned height)
{
    struct tia_material material = {.colour = {1, 1, 1}};
    struct tia_scene scene = {.spheres = pair, .sphere_count = 2, .materials = &material, .material_count = 1};
    static long long memory[1 << 14];
    struct tia_view *view;
    struct simd_row row;

    scene.camera.fov = TIA_Q16(20) + (tia_q16)random_short(20);
    CHECK_EQ(tia_view_init(&view, memory, sizeof memory, &scene, 0, width, height, NULL), TIA_OK);
    tia_simd_row(span_view_of(view), (int)height / 2, &row);
    for (uint32_t n = 0; n < 2; n++) {
        struct contest c = {.view = view, .row = &row, .n = n, .m = 1 - n};
        CHECK(!wins(&c, (int)width / 2));
    }
}

TEST(equal_distances)
{
    unsigned count = check_count(20000);

    for (unsigned i = 0; i < count; i++) {
        int32_t near = TIA_Q16(1) + (int32_t)random_short(22);
        for (int n = 0; n < 2; n++) {
            pair[n].radius = TIA_Q16(1) + (int32_t)random_short(24);
            pair[n].centre = (struct tia_vec3){0, 0, -near - pair[n].radius};
        }
        try_tie(63, 41);
    }
}

int main(void)
{
    float_mode_of_simd();
#if TRUTH_KNOWN
    RUN(pixels_in_doubles);
    RUN(levels_in_doubles);
#endif
    RUN(ties_of_emissions);
    RUN(equal_distances);
    return check_status();
}
