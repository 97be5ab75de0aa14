#include "crowds.h"

#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <tia/bvh.h>
#include <tia/simd.h>
#include <tia/tia.h>

#include "checked.h"
#include "milliseconds.h"
#include "simd_rays.h"

enum { WIDTH = 640, HEIGHT = 480, SPHERES = 254, LIGHTS = 255, MATERIALS = 6, ROUNDS = 9 };

static struct tia_material materials[MATERIALS];
static struct tia_sphere spheres[SPHERES];
static struct tia_light lights[LIGHTS];
static uint32_t state;

/* Returns a number from least to most, the next one of a sequence. */
static tia_q16 between(double least, double most)
{
    state = state * UINT32_C(1664525) + UINT32_C(1013904223);
    return (tia_q16)((least + (most - least) * (state >> 8) * 0x1p-24) * 65536);
}

static struct tia_sphere ball(struct tia_vec3 centre, tia_q16 radius, uint32_t i)
{
    return (struct tia_sphere){centre, radius, i % MATERIALS};
}

/* A ground, and balls on and above it. */
static struct tia_sphere above_ground(uint32_t i, uint32_t count)
{
    double most = count <= 32 ? .9 : count <= 128 ? .6 : .4;
    tia_q16 radius = between(most / 4, most);

    if (i == 0)
        return ball((struct tia_vec3){0, TIA_Q16(-10002), TIA_Q16(-20)}, TIA_Q16(10000), i);
    return ball((struct tia_vec3){between(-8, 8), between(-1.6, 4), between(-30, -12)}, radius, i);
}

static struct tia_sphere in_cloud(uint32_t i, uint32_t count)
{
    (void)count;
    return ball((struct tia_vec3){between(-6, 6), between(-3, 7), between(-30, -12)}, between(.2, .8), i);
}

/* Balls that overlap each other in depth. */
static struct tia_sphere in_heap(uint32_t i, uint32_t count)
{
    (void)count;
    return ball((struct tia_vec3){between(-4, 4), between(-2, 6), between(-30, -8)}, between(.5, 1.5), i);
}

static struct tia_sphere in_wall(uint32_t i, uint32_t count)
{
    (void)count;
    return ball((struct tia_vec3){(tia_q16)(i % 16) * 65536 - TIA_Q16(7.5), (tia_q16)(i / 16) * 65536 - TIA_Q16(5.5),
                                  TIA_Q16(-22)},
                TIA_Q16(.45), i);
}

struct crowd {
    const char *name;
    struct tia_sphere (*place)(uint32_t i, uint32_t count);
    uint32_t spheres, lights;
};

static void make(const struct crowd *crowd, struct tia_scene *scene)
{
    state = 1;
    for (int i = 0; i < MATERIALS; i++)
        materials[i].colour = (struct tia_rgb){between(0, 1) << 14, between(0, 1) << 14, TIA_Q30(.6)};
    for (uint32_t i = 0; i < crowd->spheres; i++)
        spheres[i] = crowd->place(i, crowd->spheres);
    for (uint32_t l = 0; l < crowd->lights; l++) {
        lights[l] = (struct tia_light){.centre = {between(-25, 25), between(10, 25), between(-30, 5)}};
        lights[l].emission.r = lights[l].emission.g = lights[l].emission.b = TIA_Q30(1.2) / (tia_q30)crowd->lights;
    }
    *scene = (struct tia_scene){.camera = {.eye = {0, TIA_Q16(2), 0}, .fov = TIA_Q16(40)},
                                .background = {TIA_Q30(.6), TIA_Q30(.7), TIA_Q30(.8)},
                                .materials = materials,
                                .material_count = MATERIALS,
                                .spheres = spheres,
                                .sphere_count = crowd->spheres,
                                .lights = lights,
                                .light_count = crowd->lights};
}

struct stage {
    struct tia_view *view;
    struct tia_hits *hits;
    void *part[3];
};

static void set(struct stage *s, const struct tia_scene *scene)
{
    const struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    const struct tia_simd *simd = tia_simd_best();
    size_t view = tia_view_size(scene, scene->light_count), hits = tia_hits_size(scene, all);
    size_t more = tia_simd_size(simd, scene, scene->light_count, 1);

    s->part[0] = checked(malloc(view));
    s->part[1] = checked(malloc(more + 1));
    s->part[2] = checked(malloc(hits + 1));
    if (tia_view_init(&s->view, s->part[0], view, scene, scene->light_count, WIDTH, HEIGHT, NULL) ||
        tia_view_set_simd(s->view, simd, s->part[1], more) || tia_hits_init(&s->hits, s->part[2], hits, s->view, all))
        exit(1);
}

/* Returns the milliseconds that a frame takes. */
static double draw(const struct stage *s, tia_rgb565 *pixels)
{
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * WIDTH};
    double start = cpu_milliseconds();

    if (tia_view_draw(s->view, s->hits, (struct tia_tile){0, 0, WIDTH, HEIGHT}, &surface, NULL))
        exit(1);
    return cpu_milliseconds() - start;
}

/* Rays draw what has a direction that is up, even the usual one. */
static void compare(const struct crowd *crowd, tia_rgb565 *pixels)
{
    double by_spans[ROUNDS], by_rays[ROUNDS], ratio[ROUNDS];
    struct tia_scene scene, raised;
    struct stage spans, rays;

    make(crowd, &scene);
    raised = scene;
    raised.camera.up = (struct tia_vec3){0, TIA_Q16(1), 0};
    raised.camera.reference = (struct tia_vec3){0, TIA_Q16(2), TIA_Q16(-1)};
    size_t size = tia_bvh_size(&raised);
    void *boxes = checked(malloc(size));
    if (tia_bvh_build(&raised.bvh, boxes, size, NULL, &raised, NULL))
        exit(1);
    set(&spans, &scene);
    set(&rays, &raised);
    for (int i = 0; i < ROUNDS; i++) {
        by_spans[i] = draw(&spans, pixels);
        by_rays[i] = draw(&rays, pixels);
        ratio[i] = by_spans[i] / by_rays[i];
    }
    printf("| %s | %u | %u | %.1f | %.1f | %.2f |\n", crowd->name, crowd->spheres, crowd->lights,
           median(by_spans, ROUNDS), median(by_rays, ROUNDS), median(ratio, ROUNDS));
    free(boxes);
    for (int i = 0; i < 3; i++) {
        free(spans.part[i]);
        free(rays.part[i]);
    }
}

void bench_crowds(void)
{
    static const struct crowd crowds[] = {{"above a ground", above_ground, 16, 4},
                                          {"above a ground", above_ground, 16, 32},
                                          {"above a ground", above_ground, 16, 64},
                                          {"above a ground", above_ground, 64, 4},
                                          {"above a ground", above_ground, 64, 32},
                                          {"above a ground", above_ground, 64, 64},
                                          {"above a ground", above_ground, 254, 1},
                                          {"above a ground", above_ground, 254, 4},
                                          {"above a ground", above_ground, 254, 16},
                                          {"above a ground", above_ground, 254, 32},
                                          {"above a ground", above_ground, 254, 64},
                                          {"above a ground", above_ground, 254, 255},
                                          {"a cloud", in_cloud, 16, 32},
                                          {"a cloud", in_cloud, 64, 32},
                                          {"a cloud", in_cloud, 254, 4},
                                          {"a cloud", in_cloud, 254, 16},
                                          {"a cloud", in_cloud, 254, 32},
                                          {"a cloud", in_cloud, 254, 64},
                                          {"a heap", in_heap, 16, 32},
                                          {"a heap", in_heap, 64, 32},
                                          {"a heap", in_heap, 254, 1},
                                          {"a heap", in_heap, 254, 4},
                                          {"a heap", in_heap, 254, 16},
                                          {"a heap", in_heap, 254, 32},
                                          {"a heap", in_heap, 254, 64},
                                          {"a wall", in_wall, 64, 32},
                                          {"a wall", in_wall, 192, 4},
                                          {"a wall", in_wall, 192, 16},
                                          {"a wall", in_wall, 192, 32},
                                          {"a wall", in_wall, 192, 64}};
    tia_rgb565 *pixels = checked(malloc((size_t)WIDTH * HEIGHT * sizeof *pixels));

    printf("| crowd | spheres | lights | spans, ms | rays, ms | spans/rays |\n|---|--:|--:|--:|--:|--:|\n");
    for (size_t i = 0; i < sizeof crowds / sizeof *crowds; i++)
        if (!bench_scene || strstr(crowds[i].name, bench_scene))
            compare(&crowds[i], pixels);
    free(pixels);
}
