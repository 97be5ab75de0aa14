/* Frames of plain C against the exact pixels of docs/definition.md: the built-in scene, scenes of the corpus and of any
 * magnitude, hard ones, ties, and the eye in a ball.
 *
 *     test_span_exact [N]    N scenes of any magnitude, by default 1500, and N/200 of the corpus */
#include <tia/debug.h>

#include "check.h"
#include "common/corpus/corpus.h"
#include "exact/pixel.h"
#include "random.h"
#include "render/core/dither.h"
#include "span_regimes.h"

static unsigned scenes = 1500;
static unsigned long compared, differing;

struct frame {
    const char *what;
    unsigned number, width, height;
    bool dither;
    unsigned step; /* one of so many pixels is compared */
};

/* Compares the pixels of a frame with exact ones. */
static void compare_pixels(const struct tia_scene *scene, const struct frame *f, const tia_rgb565 *got)
{
    struct exact_picture picture = {.scene = scene,
                                    .lights = scene->lights,
                                    .light_count = scene->light_count,
                                    .width = (int)f->width,
                                    .height = (int)f->height};

    tia_exact_depth(&picture.depth, f->height, scene->camera.fov);
    for (unsigned i = f->number % f->step; i < f->width * f->height; i += f->step) {
        int x = (int)(i % f->width), y = (int)(i / f->width);
        num_u threshold[8];
        dither_thresholds(f->dither, y, threshold);
        tia_rgb565 want = tia_exact_pixel(&picture, x, y, (tia_q30)threshold[x & 7], NULL);
        compared++;
        differing += got[i] != want;
        CHECK_MSG(got[i] == want, "%s %u, %ux%u%s (%d, %d): %04x, not %04x", f->what, f->number, f->width, f->height,
                  f->dither ? " dithered" : "", x, y, got[i], want);
    }
}

static void try_frame(const struct tia_scene *scene, const struct frame *f)
{
    const struct tia_tile tile = {0, 0, (uint16_t)f->width, (uint16_t)f->height};
    const struct tia_options options = {.dither = f->dither};
    size_t size = tia_view_size(scene, scene->light_count), hits_size = tia_hits_size(scene, tile);
    void *memory = malloc(size), *hits_memory = malloc(hits_size);
    tia_rgb565 *pixels = malloc(f->width * f->height * sizeof *pixels);
    const struct tia_surface surface = {pixels, sizeof *pixels, (ptrdiff_t)(f->width * sizeof *pixels)};
    struct tia_view *view;
    struct tia_hits *hits;

    if (!tia_view_init(&view, memory, size, scene, scene->light_count, f->width, f->height, NULL)) {
        CHECK_EQ(tia_hits_init(&hits, hits_memory, hits_size, view, tile), TIA_OK);
        CHECK_EQ(tia_view_draw(view, hits, tile, &surface, &options), TIA_OK);
        compare_pixels(scene, f, pixels);
    }
    free(memory);
    free(hits_memory);
    free(pixels);
}

/* Tries a picture. Of a large one about `most` pixels are compared, a quarter of them in make check-quick. */
static void try(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                bool dither, unsigned most)
{
    struct frame f = {what, number, width, height, dither, 1 + width * height / check_count(most)};

    try_frame(scene, &f);
}

TEST(the_built_in_scene)
{
    static const char *const keys[] = {"", "a", "d", "s", "w"};
    static const uint16_t sizes[][2] = {{640, 480}, {321, 243}, {17, 100}, {8192, 5}, {1, 1}, {1920, 1080}};
    struct corpus_scene s;

    for (unsigned k = 0; k < 5; k++)
        for (unsigned i = 0; i < 6; i++) {
            CHECK_EQ(corpus_thesis(&s, keys[k], sizes[i][0], sizes[i][1]), TIA_OK);
            try("thesis", k, &s.scene, sizes[i][0], sizes[i][1], false, 4000);
            try("thesis", k, &s.scene, sizes[i][0], sizes[i][1], true, 2000);
        }
}

TEST(random_corpus)
{
    static struct corpus_scene s;
    unsigned count = scenes / 200;

    for (unsigned i = 0; i < count; i++) {
        corpus_random(&s, 7, i);
        try("random", i, &s.scene, s.width, s.height, i % 3 == 2, 4000);
    }
}

static void try_some(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                     bool dither)
{
    try(what, number, scene, width, height, dither, 120);
}

TEST(scenes_of_any_magnitude)
{
    regimes_each(check_count(scenes), try_some);
}

/* ---- scenes made by hand ---- */

static struct tia_material materials[4];
static struct tia_sphere spheres[8];
static struct tia_light lights[12];
static struct tia_scene scene;

static void start(double fov)
{
    materials[0] = (struct tia_material){.colour = TIA_RGB(1, 1, 1)};
    materials[1] = (struct tia_material){.colour = TIA_RGB(1, 1, 1), .transmission = TIA_RGB(.5, .25, 1)};
    materials[2] = (struct tia_material){.colour = TIA_RGB(.5, .5, .5), .emission = TIA_RGB(.5, 0, .25)};
    materials[3] = (struct tia_material){.colour = TIA_RGB(.7, .2, 1)};
    scene = (struct tia_scene){.materials = materials,
                               .spheres = spheres,
                               .lights = lights,
                               .material_count = 4,
                               .background = TIA_RGB(.25, .25, .25),
                               .camera = {.fov = TIA_Q16(fov)}};
}

static void ball(int32_t x, int32_t y, int32_t z, int32_t radius, uint32_t material)
{
    spheres[scene.sphere_count++] = (struct tia_sphere){{x, y, z}, radius, material};
}

static void light(int32_t x, int32_t y, int32_t z, int32_t radius)
{
    lights[scene.light_count++] = (struct tia_light){{x, y, z}, radius, TIA_RGB(1, .9, .8)};
}

static void try_made(const char *what, unsigned number)
{
    CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
    try(what, number, &scene, 320, 240, false, 4000);
    try(what, number, &scene, 161, 121, true, 2000);
    try(what, number, &scene, 41, 31, false, 5100);
}

#define U(x) ((int32_t)lround(65536 * (x)))

/* A half-transparent ball of any small size around or beside its light, above a ground: much of the ground is next to
 * the edge of the shadow. */
TEST(lamps)
{
    static const int32_t radii[] = {64, 66, 655, 1311, 65536};

    for (unsigned i = 0; i < 5; i++)
        for (unsigned place = 0; place < 3; place++) {
            start(40);
            ball(0, U(-1002), U(-30), U(1000), 0);
            ball(19661, 78643, -1356595, radii[i], 1);
            light(19661, 78643 + (place == 0 ? 0 : radii[i] - (place == 1 ? 4 : -1)), -1356595, 0);
            try_made("lamp", 3 * i + place);
        }
}

/* Grey lights above balls of every material: each below, at and above 1, and their sum below, at and above 3, up to
 * which the light is summed before it gets the material's colour, and far above what a word holds. */
TEST(grey_lights)
{
    static const double emissions[] = {.25, .9, 1, 1.4, 1.9};
    static const int counts[] = {2, 3, 4, 12};

    for (unsigned i = 0; i < 20; i++) {
        tia_q30 e = (tia_q30)lround(emissions[i / 4] * TIA_Q30_ONE);
        start(50);
        materials[1].transmission = (struct tia_rgb)TIA_RGB(0, 0, 0);
        ball(0, U(-1002), U(-20), U(1000), i % 2 ? 3 : 0);
        for (int j = 0; j < 6; j++)
            ball(U(-5 + 2 * j), U(-1 + j % 2), U(-12 - j % 3), U(.9), (uint32_t)(j % 4));
        for (int l = 0; l < counts[i % 4]; l++) {
            light(U(-9 + 1.5 * l), U(11 + l % 3), U(-10 + l % 5), 0);
            lights[l].emission = (struct tia_rgb){e, e, e};
        }
        try_made("grey", i);
    }
}

/* A coloured light of more than 1 right before a white ball, and a dim one: the sum of both is cut to 1 before and
 * after the second. */
TEST(a_bright_light_and_a_dim_one)
{
    start(40);
    materials[0].colour = (struct tia_rgb)TIA_RGB(1, 1, 1);
    ball(0, 0, U(-12), U(4), 0);
    light(0, 0, U(-4), 0);
    light(U(1), U(1), U(-4), 0);
    lights[0].emission = (struct tia_rgb)TIA_RGB(1.5, 1.25, 1);
    lights[1].emission = (struct tia_rgb)TIA_RGB(.5, .25, .125);
    try_made("bright", 0);
}

/* Three grey lights whose sum is 3 or less, right before a white ball that shines itself: as large as sums become. */
TEST(the_largest_sum_of_grey_lights)
{
    start(24.342);
    materials[0].emission = (struct tia_rgb)TIA_RGB(1, 1, 1);
    ball(0, 0, -8086367, 505074, 0);
    for (int l = 0; l < 3; l++) {
        light(0, 0, -7449005, 0);
        lights[l].emission = (struct tia_rgb){TIA_Q30_ONE, TIA_Q30_ONE, TIA_Q30_ONE};
    }
    for (tia_q30 less = 1; less < 1 << 24; less *= 4) {
        lights[2].emission = (struct tia_rgb){TIA_Q30_ONE - less, TIA_Q30_ONE - less, TIA_Q30_ONE - less};
        CHECK_EQ(tia_scene_check(&scene, NULL), TIA_OK);
        try("sum", (unsigned)less, &scene, 125, 125, false, 15625);
    }
}

/* Far and tiny balls, and a light near one's surface. */
TEST(far_and_tiny_balls)
{
    for (unsigned i = 0; i < 6; i++) {
        double away = i < 3 ? 2000 : 15000, fov = i % 3 == 0 ? 1 : i % 3 == 1 ? 2 : 90;
        start(fov);
        for (int k = 0; k < 6; k++)
            ball(U(away * .003 * (k - 2.5)), U(away * .002 * (k % 3 - 1)), U(-away * (1 - .02 * k)),
                 k & 1 ? 64 + 100 * k : U(away * .003), (uint32_t)k % 4);
        light(U(away * .1), U(away * .2), U(-away * .5), 0);
        light(spheres[2].centre.x, spheres[2].centre.y + spheres[2].radius + 1, spheres[2].centre.z, 0);
        try_made("far", i);
    }
}

/* Balls at the same distance, lights on surfaces, and rays and shadow rays that touch balls, in the middle column or
 * row. */
TEST(ties)
{
    for (unsigned i = 0; i < 3; i++) {
        double fov = i == 0 ? 90 : i == 1 ? 33.5 : 61.5;
        start(fov);
        ball(0, 0, U(-30.5), U(14.5), 2);
        ball(0, 0, U(-22.25), U(6.25), 3);
        ball(U(3), 0, U(-14), U(3), 0);
        light(0, 0, U(-16), 0);
        try_made("poles", i);
        start(fov);
        ball(0, 0, U(-13), U(4), 0);
        ball(0, U(30), U(63) + 8, U(78), 0);
        light(U(18), U(-20), U(21), 0);
        try_made("tangent", i);
        start(fov);
        ball(0, 0, U(-7), U(2), 0);
        ball(U(-20), U(-48), U(5) + 8, U(10), 0);
        light(U(-24), U(-96), U(27), 0);
        try_made("h0", i);
        start(fov);
        ball(0, 0, U(-10), U(4), 0);
        ball(U(2), U(-48), U(58) + 8, U(2), 0);
        light(0, U(-48), U(58), 0);
        try_made("beside the light", i);
        start(fov);
        ball(U(-4), 0, U(-20), U(3), 3); /* halves of a level, lit and not */
        ball(U(4), 0, U(-20), U(3), 2);
        light(0, 0, 0, 0);
        try_made("halves", i);
    }
}

TEST(the_eye_in_balls)
{
    for (unsigned i = 0; i < 8; i++) {
        start(i & 1 ? 90 : 61.5);
        ball(U(1), U(2), i & 2 ? U(2) : U(-2), U(9), i & 4 ? 1 : 0);
        ball(0, 0, U(-4), U(1), 0);
        ball(0, U(-1), U(-100), U(50), 3);
        light(U(1), U(2), U(-3), i & 1 ? U(.5) : 0);
        light(U(1), U(20), U(-3), U(.5));
        if (i > 5)
            ball(0, U(.5), 0, U(9), 3);
        try_made("in a ball", i);
        start(i & 1 ? 90 : 61.5);
        ball(0, 0, U(-4), U(1), 0);
        light(0, U(1), 0, U(20));
        light(U(3), U(3), U(-2), 0);
        try_made("in a light", i);
        spheres[1] = (struct tia_sphere){{0, 0, U(i & 2 ? -5 : 5)}, U(5), 3}; /* on a ball */
        scene.sphere_count = 2;
        try_made("on a ball", i);
    }
}

/* Pixels that the integers leave open have the path hash and the 16-bit colours of the exact pixel. */
TEST(paths_and_colours)
{
    static tia_rgb565 pixels[160 * 120];
    static uint32_t paths[160 * 120];
    static uint16_t colours[3 * 160 * 120];
    const struct tia_tile tile = {0, 0, 160, 120};
    const struct tia_surface surface = {pixels, 2, 320};
    const struct tia_options options = {.colours = colours, .debug = &(struct tia_debug){.path_hash = paths}};
    static uint64_t memory[2000], hits_memory[160 * 120 * 2];
    struct tia_view *view;
    struct tia_hits *hits;

    start(40);
    ball(0, U(-1002), U(-30), U(1000), 0);
    ball(19661, 78643, -1356595, 655, 1);
    light(19661, 78643 + 655, -1356595, 0);
    light(U(3), U(8), U(-10), 0);
    struct exact_picture picture = {
        .scene = &scene, .lights = lights, .light_count = scene.light_count, .width = 160, .height = 120};
    tia_exact_depth(&picture.depth, 120, scene.camera.fov);
    CHECK_EQ(tia_view_init(&view, memory, sizeof memory, &scene, 2, 160, 120, NULL), TIA_OK);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, tile), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, tile, &surface, &options), TIA_OK);
    for (int i = 0; i < 160 * 120; i++) {
        uint32_t object = tia_hits_object(hits, (unsigned)i % 160, (unsigned)i / 160), path = 0;
        uint16_t exact[3];
        if (object == TIA_NO_OBJECT)
            continue;
        tia_exact_shade(&picture, i % 160, i / 160, object, TIA_Q30_ONE / 2, exact, &path);
        CHECK_MSG(paths[i] == path, "(%d, %d): path %" PRIx32 ", not %" PRIx32, i % 160, i / 160, paths[i], path);
        for (int c = 0; c < 3; c++)
            CHECK_MSG(abs(colours[3 * i + c] - exact[c]) <= 1, "(%d, %d): %d, not %d", i % 160, i / 160,
                      colours[3 * i + c], exact[c]);
    }
}

int main(int argc, char **argv)
{
    scenes = (unsigned)check_number(argc, argv, 1, scenes);
    RUN(the_built_in_scene);
    RUN(random_corpus);
    RUN(scenes_of_any_magnitude);
    RUN(lamps);
    RUN(grey_lights);
    RUN(a_bright_light_and_a_dim_one);
    RUN(the_largest_sum_of_grey_lights);
    RUN(far_and_tiny_balls);
    RUN(ties);
    RUN(the_eye_in_balls);
    RUN(paths_and_colours);
    printf("# %lu pixels compared, %lu differ\n", compared, differing);
    return check_status();
}
