/* Cancelled pictures by each instruction set: drawing ends soon, however slow the rays are, and does not call `stop`
 * for every packet. */
#include <stdlib.h>
#include <time.h>

#include <tia/bvh.h>
#include <tia/integrator.h>
#include <tia/simd.h>

#include "check.h"
#include "render/renderer.h"

enum { W = 64, H = 48, MANY = 1000, PLANES = 5000 };
#define SOON 0.2 /* seconds of processor time, which other programs do not add to */

/* ---- the callback ---- */

static struct {
    unsigned asked, until; /* asked: calls so far; until: number of the first call that returns true */
    double last, longest;  /* time of the last call, and the longest time between two calls */
} caller;

static double cpu_seconds(void)
{
    struct timespec t;

    (void)clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &t);
    return (double)t.tv_sec + (double)t.tv_nsec * 1e-9;
}

static void note_time(void)
{
    double now = cpu_seconds();

    if (now - caller.last > caller.longest)
        caller.longest = now - caller.last;
    caller.last = now;
}

static bool ask(void *ctx)
{
    (void)ctx;
    note_time();
    return ++caller.asked >= caller.until;
}

/* ---- scenes ---- */

static struct tia_sphere ball;
static struct tia_shape planes[PLANES];
static struct tia_light lights[MANY];
static struct tia_material material;

/* Returns a scene with a ball, and with planes one behind the other, which have no bounding box. */
static struct tia_scene scene_of(uint32_t light_count, uint32_t plane_count)
{
    struct tia_scene scene = tia_thesis_scene;

    ball = (struct tia_sphere){.centre = TIA_VEC3(0, 0, -20), .radius = TIA_Q16(6)};
    material = (struct tia_material){.colour = TIA_RGB(0.5, 0.5, 0.5)};
    for (int i = 0; i < MANY; i++)
        lights[i] = (struct tia_light){TIA_VEC3(i % 10 - 5, 20 + i / 10, -10), TIA_Q16(0.5), TIA_RGB(1, 1, 1)};
    for (int i = 0; i < PLANES; i++)
        planes[i] = (struct tia_shape){.kind = TIA_PLANE, .plane = {TIA_VEC3(0, 0, -30 - i), {0, 0, TIA_Q30_ONE}}};
    scene.bindings = NULL;
    scene.binding_count = 0;
    scene.materials = &material;
    scene.material_count = 1;
    scene.spheres = &ball;
    scene.sphere_count = 1;
    scene.shapes = planes;
    scene.shape_count = plane_count;
    scene.lights = lights;
    scene.light_count = light_count;
    return scene;
}

/* Returns a scene that takes days for one pixel: each ray that meets the ball spawns two, to the depth 16, and each of
 * these needs 256 shadow rays to each of a thousand lights. */
static struct tia_scene endless_scene(void)
{
    struct tia_scene scene = scene_of(MANY, 0);

    material.mirror = material.refraction = (struct tia_rgb)TIA_RGB(1, 1, 1);
    material.index = TIA_Q16(1.5);
    for (int i = 0; i < MANY; i++) {
        lights[i].kind = TIA_SPHERE_LIGHT;
        lights[i].samples = 256;
    }
    scene.depth = 16;
    return scene;
}

/* ---- drawing ---- */

struct picture {
    void *memory[4];
    struct tia_view *view;
    struct tia_hits *hits;
};

static const struct tia_tile frame = {0, 0, W, H};
static const struct tia_simd *simd;

static void open_picture(struct picture *p, struct tia_scene *scene)
{
    size_t size = tia_bvh_size(scene);

    p->memory[0] = malloc(size);
    CHECK_EQ(tia_bvh_build(&scene->bvh, p->memory[0], size, NULL, scene, NULL), TIA_OK);
    size = tia_view_size(scene, scene->light_count);
    p->memory[1] = malloc(size);
    caller.until = UINT32_MAX;
    CHECK_EQ(
        tia_view_init(&p->view, p->memory[1], size, scene, scene->light_count, W, H, &(struct tia_job){.stop = ask}),
        TIA_OK);
    size = tia_simd_size(simd, scene, scene->light_count, 1);
    p->memory[2] = malloc(size);
    CHECK_EQ(tia_view_set_simd(p->view, simd, p->memory[2], size), TIA_OK);
    CHECK(strcmp(tia_view_simd(p->view), simd->name) == 0);
    size = tia_hits_size(scene, frame);
    p->memory[3] = malloc(size);
    CHECK_EQ(tia_hits_init(&p->hits, p->memory[3], size, p->view, frame), TIA_OK);
}

static void close_picture(struct picture *p)
{
    for (int i = 0; i < 4; i++)
        free(p->memory[i]);
}

static int draw(const struct picture *p)
{
    static tia_rgb565 pixels[W * H];
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * W};

    return tia_view_draw(p->view, p->hits, frame, &surface, NULL);
}

static int gather(const struct picture *p)
{
    static struct tia_sum sums[W * H];

    return tia_estimator_q16.sample(p->view, frame, 0, 4, sums, W);
}

/* Cancels the work at call `until`: at most two calls follow, and no two calls are SOON apart. */
static void stop(int (*work)(const struct picture *p), const struct picture *p, unsigned until)
{
    caller.asked = 0;
    caller.until = until;
    caller.longest = 0;
    caller.last = cpu_seconds();
    CHECK_EQ(work(p), TIA_STOPPED);
    note_time();
    CHECK_MSG(caller.asked <= until + 2, "%s: asked %u times after the answer", simd->name, caller.asked - until);
    CHECK_MSG(caller.longest < SOON, "%s: it was not asked for %.3f s", simd->name, caller.longest);
}

/* ---- cases ---- */

TEST(soon)
{
    struct tia_scene scene = endless_scene();
    struct picture p;

    open_picture(&p, &scene);
    for (unsigned until = 1; until < 300; until = 2 * until + 3)
        stop(draw, &p, until);
    close_picture(&p);
}

TEST(soon_along_paths)
{
    for (unsigned integrator = TIA_OCCLUSION; integrator <= TIA_PATHS; integrator++) {
        struct tia_scene scene = scene_of(MANY, PLANES);
        struct picture p;
        scene.integration.integrator = (enum tia_integrator)integrator;
        open_picture(&p, &scene);
        for (unsigned until = 1; until < 60; until = 2 * until + 3)
            stop(gather, &p, until);
        close_picture(&p);
    }
}

/* Calls are rare, since `stop` may read a clock: in a simple picture at most one for ten pixels. */
TEST(seldom)
{
    struct tia_scene scene = scene_of(1, 1);
    struct picture p;

    open_picture(&p, &scene);
    caller.asked = 0;
    CHECK_EQ(draw(&p), TIA_OK);
    CHECK_MSG(caller.asked < W * H / 10, "%s: asked %u times", simd->name, caller.asked);
    close_picture(&p);
}

/* Packets with many tests count as more work: PLANES planes are enough for a call for each packet. */
TEST(often_where_rays_are_slow)
{
    struct tia_scene scene = scene_of(0, PLANES);
    struct picture p;

    open_picture(&p, &scene);
    caller.asked = 0;
    CHECK_EQ(draw(&p), TIA_OK);
    CHECK_MSG(caller.asked >= W * H / 8, "%s: asked %u times", simd->name, caller.asked);
    close_picture(&p);
}

int main(void)
{
    for (unsigned i = 0; (simd = tia_simd_at(i)); i++) {
        RUN(soon);
        RUN(soon_along_paths);
        RUN(seldom);
        RUN(often_where_rays_are_slow);
    }
    return check_status();
}
