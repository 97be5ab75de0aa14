/* Cores: the same functions draw the views of every core, each in the arithmetic of its own core. */
#include <tia/simd.h>
#include <tia/tia.h>

#include "check.h"

enum { W = 160, H = 120, LIGHTS = 1 };

static const struct tia_tile frame = {0, 0, W, H}, corner = {0, 0, 1, 1};

struct drawn {
    struct tia_view *view;
    struct tia_hits *hits;
    uint64_t view_memory[1000], hits_memory[W * H * 2];
    tia_rgb565 pixels[W * H];
};

/* Draws a scene, lit by one light. The core is used only to make the view. */
static void draw_lit(struct drawn *d, const struct tia_core *core, const struct tia_scene *scene,
                     const struct tia_light *state)
{
    const struct tia_surface surface = {d->pixels, 2, 2 * W};

    CHECK(core->view_size(core, scene, LIGHTS) <= sizeof d->view_memory);
    CHECK(core->hits_size(core, scene, frame) <= sizeof d->hits_memory);
    CHECK_EQ(core->view_init(core, &d->view, d->view_memory, sizeof d->view_memory, scene, LIGHTS, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_view_set_lights(d->view, state, 1), TIA_OK);
    CHECK_EQ(tia_hits_init(&d->hits, d->hits_memory, sizeof d->hits_memory, d->view, frame), TIA_OK);
    CHECK_EQ(tia_view_draw(d->view, d->hits, frame, &surface, NULL), TIA_OK);
}

/* Draws the thesis scene, lit as by key w. */
static void draw(struct drawn *d, const struct tia_core *core)
{
    const struct tia_binding *key = tia_thesis_scene.bindings;

    while (key->key != 'w')
        key++;
    draw_lit(d, core, &tia_thesis_scene, &key->state);
}

#ifdef TIA_HAVE_F64
/* A ball of the smallest radius far above a ground, with a light on its side: the shadow rays from the ground touch the
 * ball, so that its shadow is noise in double precision. */
static const struct tia_material lamp_materials[] = {{.colour = TIA_RGB(1, 1, 1)}};
static const struct tia_sphere lamp_spheres[] = {{TIA_VEC3(0, -1002, -30), TIA_Q16(1000), 0},
                                                 {{64, TIA_Q16(12000), TIA_Q16(-21)}, 64, 0}};
static const struct tia_light lamp_light = {{0, TIA_Q16(12000), TIA_Q16(-21)}, 0, TIA_RGB(1, 1, 1)};
static const struct tia_scene lamp = {.camera = {.fov = TIA_Q16(40)},
                                      .materials = lamp_materials,
                                      .spheres = lamp_spheres,
                                      .lights = &lamp_light,
                                      .material_count = 1,
                                      .sphere_count = 2,
                                      .light_count = 1};

static struct drawn q16, f64;

TEST(a_view_is_drawn_in_its_arithmetic)
{
    unsigned other = 0;

    draw_lit(&q16, &tia_core_q16, &lamp, &lamp_light);
    draw_lit(&f64, &tia_core_f64, &lamp, &lamp_light);
    for (unsigned i = 0; i < W * H; i++)
        other += q16.pixels[i] != f64.pixels[i];
    CHECK_MSG(other > 100, "%u pixels differ", other);
}

TEST(hits_are_of_one_view)
{
    const struct tia_surface surface = {q16.pixels, 2, 2 * W};

    draw(&q16, &tia_core_q16);
    draw(&f64, &tia_core_f64);
    CHECK_EQ(tia_view_trace(f64.view, q16.hits, frame), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_draw(q16.view, f64.hits, frame, &surface, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_light(f64.view, q16.hits, frame, &surface, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_hits_init(&q16.hits, q16.hits_memory, tia_hits_size(&tia_thesis_scene, frame), f64.view, frame),
             TIA_ERR_MEMORY);
}

/* Vector units draw the bits of tia_core_q16. */
TEST(levels_draw_integers)
{
    const struct tia_simd *simd = tia_simd_best();

    draw(&f64, &tia_core_f64);
    CHECK_EQ(tia_core_f64.simd_size(&tia_core_f64, simd, &tia_thesis_scene, LIGHTS, 1), 0);
    CHECK_EQ(tia_view_set_simd(f64.view, simd, NULL, 0), TIA_OK);
    CHECK(strcmp(tia_view_simd(f64.view), "plain") == 0);
}

TEST(estimators_take_their_arithmetics_views)
{
    static struct tia_sum sums[1];
    static uint64_t memory[2][4000];
    tia_rgb565 pixel;
    const struct tia_surface surface = {&pixel, 2, 2};
    struct tia_scene scene = tia_thesis_scene;
    struct tia_view *integers, *doubles;

    scene.integration.integrator = TIA_PATHS;
    CHECK_EQ(tia_view_init(&integers, memory[0], sizeof memory[0], &scene, LIGHTS, W, H, NULL), TIA_OK);
    CHECK_EQ(tia_core_f64.view_init(&tia_core_f64, &doubles, memory[1], sizeof memory[1], &scene, LIGHTS, W, H, NULL),
             TIA_OK);
    CHECK_EQ(tia_estimator_q16.sample(integers, corner, 0, 1, sums, 1), TIA_OK);
    CHECK_EQ(tia_estimator_f64.sample(doubles, corner, 0, 1, sums, 1), TIA_OK);
    CHECK_EQ(tia_estimator_q16.sample(doubles, corner, 0, 1, sums, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_estimator_f64.sample(integers, corner, 0, 1, sums, 1), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_estimator_q16.show(doubles, corner, sums, 1, &surface, false), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_estimator_f64.show(integers, corner, sums, 1, &surface, false), TIA_ERR_ARGUMENT);
}
#endif

/* ---- drawing functions of the program's own ---- */

enum called { SET_LIGHTS, HITS_INIT, HITS_OBJECT, TRACE, LIGHT, RENDER, CALLED };

static unsigned calls[CALLED];

static int set_lights(struct tia_view *view, const struct tia_light *lights, uint32_t count)
{
    calls[SET_LIGHTS]++;
    return tia_drawing.set_lights(view, lights, count);
}

static int hits_init(struct tia_hits **hits, void *memory, size_t size, const struct tia_view *view,
                     struct tia_tile area)
{
    calls[HITS_INIT]++;
    return tia_drawing.hits_init(hits, memory, size, view, area);
}

static uint32_t hits_object(const struct tia_hits *hits, unsigned x, unsigned y)
{
    calls[HITS_OBJECT]++;
    return tia_drawing.hits_object(hits, x, y);
}

static int trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    calls[TRACE]++;
    return tia_drawing.trace(view, hits, tile);
}

static int light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                 const struct tia_surface *surface, const struct tia_options *options)
{
    calls[LIGHT]++;
    return tia_drawing.light(view, hits, tile, surface, options);
}

static int render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                  const struct tia_surface *surface, const struct tia_options *options)
{
    calls[RENDER]++;
    return tia_drawing.render(view, hits, tile, surface, options);
}

static const struct tia_drawing counting = {set_lights, hits_init, hits_object, trace, light, render};

TEST(functions_call_the_views_core)
{
    static struct drawn d;
    const struct tia_surface surface = {d.pixels, 2, 2 * W};
    struct tia_core core = tia_core_q16;

    core.drawing = &counting;
    draw(&d, &core);
    CHECK_EQ(tia_view_trace(d.view, d.hits, corner), TIA_OK);
    CHECK_EQ(tia_view_light(d.view, d.hits, corner, &surface, NULL), TIA_OK);
    CHECK_EQ(tia_hits_object(d.hits, 0, 0), TIA_NO_OBJECT);
    for (unsigned i = 0; i < CALLED; i++)
        CHECK_EQ(calls[i], 1);
}

TEST(no_view)
{
    const struct tia_surface surface = {NULL, 2, 2};
    struct tia_hits *hits = NULL;

    CHECK_EQ(tia_view_set_lights(NULL, NULL, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_hits_init(&hits, NULL, 0, NULL, corner), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_hits_object(NULL, 0, 0), TIA_NO_OBJECT);
    CHECK_EQ(tia_view_trace(NULL, NULL, corner), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_light(NULL, NULL, corner, &surface, NULL), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_view_draw(NULL, NULL, corner, &surface, NULL), TIA_ERR_ARGUMENT);
}

int main(void)
{
#ifdef TIA_HAVE_F64
    RUN(a_view_is_drawn_in_its_arithmetic);
    RUN(hits_are_of_one_view);
    RUN(levels_draw_integers);
    RUN(estimators_take_their_arithmetics_views);
#endif
    RUN(functions_call_the_views_core);
    RUN(no_view);
    return check_status();
}
