/* Faces without gloss, whose colours are computed with fewer bits and a bound, against the same pixels ray by ray: with
 * tia_debug.lit all of them are drawn by rays. No byte differs. */
#include <stdlib.h>
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"
#include "random.h"

#define WIDTH 160
#define HEIGHT 120
#define SHAPES 9
#define LIGHTS 5

static struct tia_material materials[5];
static struct tia_shape shapes[SHAPES];
static struct tia_light lights[LIGHTS];

/* Returns a random number in from..to, in units of 1/`one`. */
static int32_t between(double from, double to, double one)
{
    return (int32_t)((from + (to - from) * (double)(random_bits() % 65537) / 65536) * one);
}

static struct tia_vec3 place(double from, double to, double size)
{
    return (struct tia_vec3){between(from, to, size * 65536), between(from, to, size * 65536),
                             between(from, to, size * 65536)};
}

static struct tia_rgb colour(double most)
{
    double one = 1 << 30;

    return (struct tia_rgb){between(0, most, one), between(0, most, one), between(0, most, one)};
}

static void make_materials(void)
{
    for (int i = 0; i < 5; i++)
        materials[i] = (struct tia_material){.colour = colour(1), .emission = colour(i % 2 ? .2 : 0)};
    materials[4].specular = colour(.5);
    materials[4].exponent = TIA_Q16(20);
}

static void make_shapes(double size)
{
    shapes[0] = (struct tia_shape){TIA_PLANE, .plane = {.normal = {between(-.1, .1, 1 << 30), 1 << 30, 0}}};
    for (uint32_t i = 1; i < SHAPES; i++) {
        struct tia_vec3 low = place(-4, 3, size);
        shapes[i] = (struct tia_shape){TIA_TRIANGLE, .material = i % 5};
        for (int k = 0; k < 3; k++)
            shapes[i].triangle.corner[k] = place(-4, 4, size);
        if (i % 2 == 0)
            continue;
        shapes[i].kind = TIA_BOX;
        shapes[i].box = (struct tia_box){
            low, {low.x + (int32_t)(size * 50000), low.y + (int32_t)(size * 90000), low.z + (int32_t)(size * 70000)}};
    }
}

static uint32_t make_lights(double size)
{
    uint32_t count = 1 + (uint32_t)(random_bits() % LIGHTS);

    for (uint32_t i = 0; i < count; i++) {
        lights[i] = (struct tia_light){.centre = place(-6, 8, size), .emission = colour(i ? .6 : 1.3)};
        if (i == 2)
            lights[i].kind = TIA_AMBIENT_LIGHT;
        if (i == 3) {
            lights[i].kind = TIA_DIRECTIONAL_LIGHT;
            lights[i].direction = (struct tia_dir3){between(-.5, .5, 1 << 30), -(1 << 29) - (1 << 28), 1 << 28};
        }
        if (i == 4) {
            lights[i].kind = TIA_SPOT_LIGHT;
            lights[i].direction = (struct tia_dir3){between(-.5, .5, 1 << 30), -(1 << 29) - (1 << 28), 1 << 28};
            lights[i].outer = between(20, 90, 65536);
            lights[i].inner = between(1, 20, 65536);
        }
    }
    return count;
}

static struct tia_scene make_scene(void)
{
    static const double sizes[] = {1, 1, .05, 40}, fovs[] = {20, 45, 110};
    static const enum tia_shadows techniques[] = {TIA_SHADOWS_RAYS, TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL,
                                                  TIA_SHADOWS_MAP, TIA_SHADOWS_MAP_EXACT};
    double size = sizes[random_bits() % 4], fov = fovs[random_bits() % 3];

    make_materials();
    make_shapes(size);
    return (struct tia_scene){.camera = {.eye = place(1, 7, size),
                                         .reference = place(-1, 1, size),
                                         .up = {0, TIA_Q16(1), 0},
                                         .fov = (tia_q16)(fov * 65536)},
                              .background = colour(1),
                              .materials = materials,
                              .material_count = 5,
                              .shapes = shapes,
                              .shape_count = SHAPES,
                              .lights = lights,
                              .light_count = make_lights(size),
                              .shadows = techniques[random_bits() % 5],
                              .shadow_map = {.size = 64}};
}

static void *allocated(size_t size)
{
    void *p = malloc(size);

    if (!p)
        abort();
    return p;
}

static size_t differing(const struct tia_scene *scene, bool dither)
{
    static tia_rgb565 pixels[2][WIDTH * HEIGHT];
    static uint64_t lit[WIDTH * HEIGHT];
    struct tia_tile all = {0, 0, WIDTH, HEIGHT};
    size_t sizes[2] = {tia_view_size(scene, scene->light_count), tia_hits_size(scene, all)}, wrong = 0;
    void *memory[2] = {allocated(sizes[0]), allocated(sizes[1])};
    struct tia_view *view;
    struct tia_hits *hits;

    CHECK_EQ(tia_view_init(&view, memory[0], sizes[0], scene, scene->light_count, WIDTH, HEIGHT, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, memory[1], sizes[1], view, all), TIA_OK);
    CHECK_EQ(tia_view_trace(view, hits, all), TIA_OK);
    for (int i = 0; i < 2; i++) {
        struct tia_surface surface = {
            .pixels = pixels[i], .step = sizeof(tia_rgb565), .pitch = WIDTH * sizeof(tia_rgb565)};
        struct tia_options options = {.dither = dither, .debug = &(struct tia_debug){.lit = i ? lit : NULL}};
        CHECK_EQ(tia_view_light(view, hits, all, &surface, &options), TIA_OK);
    }
    for (size_t i = 0; i < WIDTH * HEIGHT; i++)
        wrong += pixels[0][i] != pixels[1][i];
    free(memory[0]);
    free(memory[1]);
    return wrong;
}

TEST(diffuse_faces_have_the_colours_of_rays)
{
    for (int round = 0; round < (int)check_count(150); round++) {
        struct tia_scene scene = make_scene();
        size_t wrong = differing(&scene, round % 2);
        CHECK_MSG(wrong == 0, "scene %d: %zu pixels differ", round, wrong);
    }
}

int main(void)
{
    RUN(diffuse_faces_have_the_colours_of_rays);
    return check_status();
}
