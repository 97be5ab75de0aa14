/* General rays by every instruction set against plain C, byte by byte: random scenes, scene files, tiles of any size,
 * threads. Instruction sets that the processor lacks are named.
 *
 *     test_simd_rays            as many scenes as seconds allow
 *     test_simd_rays N          N random scenes: make check runs 200 (tests/slow/simd) */
#include <stdlib.h>
#include <tia/simd.h>

#include "common/corpus/corpus_rays.h"
#include "common/scene/scene_load.h"
#include "common/thread_pool.h"
#include "reading.h"
#include "sample_count.h"
#include "simd_frames.h"
#include "simd_lights.h"
#include "with_hierarchy.h"

static const struct tia_simd *simd;
static unsigned random_scenes = 6;

static const struct sure_kernels *kernels; /* of the instruction set; `count` wraps them */

static void count(struct sure_block *block, void *memory)
{
    kernels->trace(block, memory);
    count_samples(block);
}

static void compare(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                    bool dither)
{
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, scene, width, height));
    CHECK_MSG(strcmp(tia_view_simd(f.simd), simd->name) == 0, "%s %u is left to plain C", what, number);
    CHECK_MSG(simd_frames_differ(&f, true, dither) == 0, "%s: %s %u, %ux%u: %s", simd->name, what, number, width,
              height, simd_frames_where(&f));
    simd_frames_close(&f);
}

static void compare_random(const struct tia_scene *scene, unsigned number)
{
    bool fine = scene->camera.samples <= 1;

    compare("random scene", number, scene, fine ? 32 : 12, fine ? 25 : 9, number % 5 == 4);
}

TEST(random_corpus)
{
    static struct corpus_rays c;

    samples = unsure = 0;
    for (unsigned i = 0; i < check_count(random_scenes); i++) {
        corpus_random_rays(&c, 11, i);
        with_hierarchy(&c.scene, compare_random, i);
        if (i % 3)
            continue;
        corpus_add_opacity(&c, i);
        with_hierarchy(&c.scene, compare_random, i);
    }
    printf("# %lu of %lu samples were left to the integers\n", unsure, samples);
}

/* Scene files, and the largest share of their samples, in thousandths, that may be undecided. */
static const struct {
    const char *path;
    unsigned unsure;
} files[] = {
    {"scenes/nff/balls_3.nff", 2}, {"scenes/nff/gears_1.nff", 5},   {"scenes/nff/jacks_3.nff", 10},
    {"scenes/nff/mount_3.nff", 5}, {"scenes/nff/rings_3.nff", 20},  {"scenes/nff/shells_2.nff", 5},
    {"scenes/nff/tetra_4.nff", 2}, {"scenes/nff/teapot_3.nff", 30}, {"scenes/nff/lattice_3.nff", 5},
    {"scenes/nff/tree_4.nff", 2},  {"scenes/nff/balls_4.nff", 2},
};

TEST(scene_files)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct scene_file file;
        CHECK_EQ(scene_open(&file, files[i].path, scene_format_of(files[i].path), false), TIA_OK);
        samples = unsure = 0;
        compare(files[i].path, 0, &file.scene, 48, 37, false);
        CHECK_MSG(unsure * 1000 <= samples * files[i].unsure, "%s: %s: %lu of %lu samples are unsure", simd->name,
                  files[i].path, unsure, samples);
        scene_close(&file);
    }
}

static void draw_tiles(const struct tia_scene *scene, unsigned size)
{
    static tia_rgb565 want[150 * 113], got[150 * 113];
    enum { W = 150, H = 113 };
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, scene, W, H));
    for (unsigned y = 0; y < H; y += size)
        for (unsigned x = 0; x < W; x += 2 * size) {
            unsigned width = W - x < 2 * size ? W - x : 2 * size, height = H - y < size ? H - y : size;
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)width, (uint16_t)height};
            struct tia_surface a = {.pixels = want + x * H + y, .step = 2 * H, .pitch = 2},
                               b = {.pixels = got + x * H + y, .step = 2 * H, .pitch = 2};
            CHECK_EQ(tia_view_draw(f.plain, f.hits[0], tile, &a, NULL), TIA_OK);
            CHECK_EQ(tia_view_draw(f.simd, f.hits[1], tile, &b, NULL), TIA_OK);
        }
    CHECK(memcmp(want, got, sizeof want) == 0);
    simd_frames_close(&f);
}

static struct scene_file balls;

TEST(tiles_and_turned_surfaces)
{
    static const unsigned sizes[] = {1, 3, 8, 37, 113};

    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++)
        draw_tiles(&balls.scene, sizes[i]);
}

static void compare_far(const struct tia_scene *scene, unsigned number)
{
    compare("spheres far out", number, scene, 160, 120, false);
}

/* The scenes are far from the origin, where the unit of a float, 2^-10 at 9000, is not small beside small objects:
 * boxes need a margin for the rounding of floats. Errors show where rays graze the face of a box, so the eye looks
 * along an axis; mirrors reflect rays in all directions. */
TEST(far_out)
{
    static const double ways[][3] = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {-1, 0, 0}, {0, -1, 0}, {0, 0, -1}};
    static struct reading reading;
    char text[2048];

    for (unsigned i = 0; i < 6; i++) {
        const double *w = ways[i], c[3] = {9000.1337, i % 2 ? 8000.3719 : -8000.3719, -9500.7123};
        int length = snprintf(text, sizeof text,
                              "camera eye %.4f %.4f %.4f look %.4f %.4f %.4f up %.0f %.0f %.0f fov 1\n"
                              "light point at %.2f %.2f %.2f emission 1 1 1\n"
                              "material glass colour 0.4 0.5 0.6 mirror 0.5\n",
                              c[0] - 2 * w[0], c[1] - 2 * w[1], c[2] - 2 * w[2], c[0], c[1], c[2], w[1], w[2], w[0],
                              c[0] + 2, c[1] + 5, c[2] + 3);
        for (int k = 0; k < 18; k++)
            length += snprintf(text + length, sizeof text - (size_t)length,
                               "sphere centre %.4f %.4f %.4f radius %.4f material glass\n", c[0] + .0101 * (k % 3 - 1),
                               c[1] + .0103 * (k / 3 % 3 - 1), c[2] + .0107 * (k / 9), .003 + .0001 * k);
        read_string(&reading, TIA_FORMAT_TIA, text);
        CHECK_MSG(reading.status == TIA_OK, "%s", reading.reader.error.text);
        with_hierarchy(&reading.scene, compare_far, i);
        read_end(&reading);
    }
}

static void compare_hindered(const struct tia_scene *scene, unsigned number)
{
    compare("ambient light that objects hinder", number, scene, 40, 30, false);
}

/* Ambient light with occlusion gives the fixed-point result, at any index among the lights. */
TEST(ambient_light_is_hindered)
{
    static const char text[] = "camera eye 0 1 5 look 0 0 0 fov 40\nmaterial plain colour 0.7 0.6 0.5 mirror 0.2\n"
                               "light point at 1 3 2 emission 0.4\nlight ambient emission 0.6 occlusion 1 samples 4\n"
                               "plane point 0 -0.5 0 normal 0 1 0 material plain\n"
                               "sphere centre 0 0 0 radius 0.5 material plain\n";
    static struct reading reading;

    read_string(&reading, TIA_FORMAT_TIA, text);
    CHECK_MSG(reading.status == TIA_OK, "%s", reading.reader.error.text);
    with_hierarchy(&reading.scene, compare_hindered, 0);
    read_end(&reading);
}

static void compare_light(const struct tia_scene *scene, unsigned number)
{
    samples = unsure = 0;
    compare(light_lines[number], number, scene, 40, 30, false);
    CHECK_MSG(samples && unsure * 4 < samples, "%s: %lu of %lu samples are unsure", light_lines[number], unsure,
              samples);
}

/* Compares a scene that is marked as one with a light that the kernels do not support. */
static void compare_other(const struct tia_scene *scene, unsigned number)
{
    struct simd_frames f;

    samples = 0;
    CHECK(simd_frames_open(&f, simd, scene, 40, 30));
    tia_sure_scene(f.simd)->fixed_only = true;
    CHECK_MSG(simd_frames_differ(&f, true, false) == 0, "%s %u", simd->name, number);
    CHECK_EQ(samples, 0);
    simd_frames_close(&f);
}

TEST(kinds_of_lights)
{
    for (unsigned i = 0; i < LIGHT_LINES; i++)
        with_light(i, compare_light);
    with_light(0, compare_other);
}

/* Objects, path hashes and the sets of light samples that arrive are the same, too. */
TEST(objects_hashes_and_lights)
{
    enum { W = 60, H = 45 };
    static uint32_t hashes[2][W * H];
    static uint64_t lit[2][W * H];
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, &balls.scene, W, H));
    for (int i = 0; i < 2; i++) {
        struct tia_options options = {.debug = &(struct tia_debug){.path_hash = hashes[i], .lit = lit[i]}};
        struct tia_surface surface = simd_frames_surface(i ? f.got : f.want, f.pitch);
        CHECK_EQ(tia_view_draw(i ? f.simd : f.plain, f.hits[i], f.area, &surface, &options), TIA_OK);
    }
    CHECK(memcmp(hashes[0], hashes[1], sizeof hashes[0]) == 0 && memcmp(lit[0], lit[1], sizeof lit[0]) == 0);
    for (unsigned i = 0; i < W * H; i += 7)
        CHECK_EQ(tia_hits_object(f.hits[1], i % W, i / W), tia_hits_object(f.hits[0], i % W, i / W));
    simd_frames_close(&f);
}

static void draw_row(void *arg, unsigned index)
{
    struct simd_frames *f = arg;
    struct tia_tile tile = {0, (uint16_t)(5 * index), f->area.width, 5};
    struct tia_surface surface = simd_frames_surface(f->got + (size_t)f->pitch * tile.y, f->pitch);

    CHECK_EQ(tia_view_draw(f->simd, f->hits[1], tile, &surface, NULL), TIA_OK);
}

/* With memory for one thread only, the other threads draw by plain C. */
TEST(more_threads_than_rooms)
{
    size_t size = tia_simd_size(simd, &balls.scene, balls.scene.light_count, 1);
    struct threads *pool = threads_create(4);
    struct simd_frames f;

    CHECK(size < tia_simd_size(simd, &balls.scene, balls.scene.light_count, 2));
    CHECK(simd_frames_open(&f, simd, &balls.scene, 120, 90));
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    CHECK_EQ(tia_view_set_simd(f.simd, simd, f.memory[2], size), TIA_OK);
    memset(f.got, GUARDED, f.bytes);
    threads_run(pool, draw_row, &f, 18);
    CHECK(memcmp(f.want, f.got, f.bytes) == 0);
    simd_frames_close(&f);
    threads_destroy(pool);
}

/* The memory for a scene that moves does not depend on the hierarchy of the moment, which may get more nodes. */
TEST(room_for_any_hierarchy)
{
    static const struct tia_keyframe key = {.time = 0};
    static const struct tia_track track = {.target = TIA_MOVES_EYE, .keys = &key, .key_count = 1};
    struct tia_scene scene = balls.scene;
    struct tia_bvh small = *scene.bvh;
    size_t still = tia_simd_size(simd, &scene, scene.light_count, 1);

    small.objects.node_count = 1;
    scene.bvh = &small;
    CHECK(tia_simd_size(simd, &scene, scene.light_count, 1) < still);
    scene.tracks = &track;
    scene.track_count = 1;
    size_t least = tia_simd_size(simd, &scene, scene.light_count, 1);
    scene.bvh = balls.scene.bvh;
    CHECK_EQ(tia_simd_size(simd, &scene, scene.light_count, 1), least);
    CHECK(least >= still);
}

/* Frames that `stop` draws within a call, while this call uses the memory of the only thread. */
static struct simd_frames *nested;
static unsigned nested_calls;

static bool draw_inside(void *ctx)
{
    static tia_rgb565 pixels[120 * 90];
    const struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * 120};

    (void)ctx;
    if (nested_calls++)
        return false;
    CHECK_EQ(tia_view_draw(nested->simd, nested->hits[1], nested->area, &surface, NULL), TIA_OK);
    for (int y = 0; y < 90; y++)
        CHECK(!memcmp(&pixels[120 * y], nested->want + GUARD + y * nested->pitch, 2 * 120));
    return false;
}

TEST(a_call_within_a_call)
{
    size_t size = tia_simd_size(simd, &balls.scene, balls.scene.light_count, 1);
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, &balls.scene, 120, 90));
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    CHECK_EQ(tia_view_set_simd(f.simd, simd, f.memory[2], size), TIA_OK);
    nested = &f;
    nested_calls = 0;
    f.simd->stop = draw_inside;
    CHECK_EQ(simd_frames_differ(&f, false, false), 0);
    CHECK(nested_calls > 1);
    simd_frames_close(&f);
}

TEST(threads)
{
    struct threads *pool = threads_create(4);
    struct simd_frames f;

    CHECK(simd_frames_open(&f, simd, &balls.scene, 120, 90));
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    memset(f.got, GUARDED, f.bytes);
    threads_run(pool, draw_row, &f, 18);
    CHECK(memcmp(f.want, f.got, f.bytes) == 0);
    simd_frames_close(&f);
    threads_destroy(pool);
}

/* New lights need no new scene. One byte less memory is an error, and leaves plain C. */
TEST(lights_move)
{
    struct tia_light lights[8];
    struct simd_frames f;

    CHECK(balls.scene.light_count > 0 && balls.scene.light_count <= 8);
    CHECK(simd_frames_open(&f, simd, &balls.scene, 60, 45));
    memcpy(lights, balls.scene.lights, balls.scene.light_count * sizeof *lights);
    lights[0].centre.x /= 2;
    CHECK_EQ(tia_view_set_lights(f.plain, lights, balls.scene.light_count), TIA_OK);
    CHECK_EQ(tia_view_set_lights(f.simd, lights, balls.scene.light_count), TIA_OK);
    CHECK_EQ(simd_frames_differ(&f, true, true), 0);
    size_t size = tia_simd_size(simd, &balls.scene, balls.scene.light_count, 1);
    CHECK_EQ(tia_view_set_simd(f.simd, simd, f.memory[2], size - 1), TIA_ERR_MEMORY);
    CHECK(strcmp(tia_view_simd(f.simd), "plain") == 0);
    simd_frames_close(&f);
}

static void run_all(const struct tia_simd *tested)
{
    const struct sure_kernels counting = {
        .trace = count, .set_pixels = tested->sure->set_pixels, .block_memory = tested->sure->block_memory};
    struct tia_simd mine = *tested;
    char title[80];

    kernels = tested->sure;
    mine.sure = &counting;
    simd = &mine;
#define RUN_SIMD(test) ((void)snprintf(title, sizeof title, "%s: %s", tested->name, #test), check_run(title, test))
    RUN_SIMD(random_corpus);
    RUN_SIMD(scene_files);
    RUN_SIMD(far_out);
    RUN_SIMD(tiles_and_turned_surfaces);
    RUN_SIMD(ambient_light_is_hindered);
    RUN_SIMD(kinds_of_lights);
    RUN_SIMD(objects_hashes_and_lights);
    RUN_SIMD(lights_move);
    simd = tested; /* without counters, which are not for several threads */
    RUN_SIMD(threads);
    RUN_SIMD(more_threads_than_rooms);
    RUN_SIMD(room_for_any_hierarchy);
    RUN_SIMD(a_call_within_a_call);
}

int main(int argc, char **argv)
{
    const char *path = "scenes/nff/balls_2.nff";

    random_scenes = (unsigned)check_number(argc, argv, 1, random_scenes);
    if (scene_open(&balls, path, scene_format_of(path), false))
        return EXIT_FAILURE;
    for (unsigned i = 0; tia_simd_at(i); i++)
        run_all(tia_simd_at(i));
    scene_close(&balls);
    return check_status();
}
