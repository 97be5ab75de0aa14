/* Samples by every instruction set against plain C: ambient occlusion and light along paths, random scenes and scene
 * files. Sums must be equal to the last bit. The error bound of each sample must be at least the distance of the
 * radiance in double precision from the fixed-point radiance before rounding.
 *
 *     test_simd_samples            as many scenes as seconds allow
 *     test_simd_samples N          N random scenes: make check runs 200 (tests/slow/simd)
 *     test_simd_samples N I        extreme ones from number I on */
#include <math.h>
#include <stdlib.h>
#include <tia/simd.h>

#include "common/corpus/corpus_rays.h"
#include "common/scene/scene_load.h"
#include "extreme_scenes.h"
#include "one_lane.h"
#include "simd/rays/walk_paths_tmpl.h"
#include "simd_frames.h"
#include "simd_lights.h"
#include "with_hierarchy.h"

static const struct tia_simd *simd;
static unsigned random_scenes = 80;

/* The instruction set's kernels. Counters wrap them to detect kernels that leave all samples to the fixed-point code.
 */
static const struct sure_kernels *kernels;
static unsigned long samples, unsure, clear;

static void count(const struct sure_gather *g)
{
    for (int i = 0; i < g->count; i++) {
        samples++;
        unsure += g->unsure[i];
        clear += !g->unsure[i] && g->error[i] < 1e-9;
    }
}

static void count_occluded(struct sure_gather *g, void *memory)
{
    kernels->occlude(g, memory);
    count(g);
}

static void count_walked(struct sure_gather *g, void *memory)
{
    kernels->walk(g, memory);
    count(g);
}

/* ---- sums ---- */

enum { W = 18, H = 13, EACH = 3 };

struct gathered {
    struct tia_sum sums[W * H];
    uint64_t squares[W * H];
    struct tia_guide guides[W * H];
};

/* Gathers EACH samples a pixel in tiles of 7 x 5, samples 1 and 2 before sample 0. */
static void gather(const struct tia_view *view, bool guides, struct gathered *to)
{
    memset(to, 0, sizeof *to);
    for (unsigned y = 0; y < H; y += 5)
        for (unsigned x = 0; x < W; x += 7) {
            struct tia_tile tile = {(uint16_t)x, (uint16_t)y, (uint16_t)(W - x < 7 ? W - x : 7),
                                    (uint16_t)(H - y < 5 ? H - y : 5)};
            struct tia_gathered at = {&to->sums[y * W + x], guides ? &to->guides[y * W + x] : NULL,
                                      &to->squares[y * W + x], W};
            CHECK_EQ(tia_estimator_q16.gather(view, tile, 1, EACH, &at), TIA_OK);
            CHECK_EQ(tia_estimator_q16.gather(view, tile, 0, 1, &at), TIA_OK);
        }
}

static void compare(const char *what, unsigned number, const struct tia_scene *scene, bool guides)
{
    static struct gathered want, got;
    struct simd_frames f;

    CHECK_MSG(simd_frames_open(&f, simd, scene, W, H), "%s %u is refused", what, number);
    CHECK_MSG(strcmp(tia_view_simd(f.simd), simd->name) == 0, "%s %u is left to plain C", what, number);
    gather(f.plain, guides, &want);
    gather(f.simd, guides, &got);
    for (unsigned i = 0; i < W * H; i++)
        CHECK_MSG(memcmp(&want.sums[i], &got.sums[i], sizeof *want.sums) == 0 && want.squares[i] == got.squares[i] &&
                      memcmp(&want.guides[i], &got.guides[i], sizeof *want.guides) == 0,
                  "%s: %s %u: pixel %u,%u differs", simd->name, what, number, i % W, i / W);
    simd_frames_close(&f);
}

/* ---- sums, by one lane ---- */

static double most_used;
static unsigned long compared;

static void compare_sample(const struct sure_gather *g, int i)
{
    const struct ray_view *view = g->scene->view;
    struct estimate e = {.view = view, .bias = num_ray_bias(view->bias), .blocker = TIA_NO_OBJECT};
    num_length rgb[3];
    struct ray ray;
    uint32_t u[2];

    if (g->unsure[i])
        return;
    e.sampler = sampler_of(view->scene->integration.seed, g->x[i], g->y[i], g->index[i]);
    sampler_pair(&e.sampler, ESTIMATE_FIRST_QUAD, 0, u);
    const struct light_pixel pixel = ray_pixel_at(g->x[i], g->y[i]);
    ray_camera_ray_within(&view->camera, &pixel, g->index[i], u, &ray);
    path_radiance(&e, &ray, rgb);
    for (int c = 0; c < 3; c++) {
        double want = (double)rgb[c] * P2M(45), gap = fabs(want - g->colour[i][c]);
        double bound = g->error[i] + g->colour[i][c] * P2M(41);
        if (want >= 16384 || gap == 0)
            continue;
        CHECK_MSG(gap <= bound, "pixel %d,%d, sample %u: off by %g, bound %g", g->x[i], g->y[i], g->index[i], gap,
                  bound);
        most_used = fmax(most_used, gap / bound);
    }
    compared++;
}

static void check_bounds(const struct tia_scene *scene)
{
    static struct sure_gather g;
    static struct path_state flight;
    struct environment caller;
    struct simd_frames f;

    if (scene->integration.integrator != TIA_PATHS)
        return;
    CHECK(simd_frames_open(&f, simd, scene, W, H));
    g.scene = tia_sure_scene(f.simd);
    g.count = SURE_GATHERED;
    for (int i = 0; i < g.count; i++) {
        g.x[i] = i % W;
        g.y[i] = i / W * 2 % H;
        g.index[i] = (uint32_t)(7 + i % 3);
    }
    CHECK(environment_take(&caller));
    walk_paths(&g, &flight);
    for (int i = 0; i < g.count; i++)
        compare_sample(&g, i);
    environment_leave(&caller);
    simd_frames_close(&f);
}

/* ---- scenes ---- */

static void compare_random(const struct tia_scene *scene, unsigned number)
{
    compare("random scene", number, scene, number % 4 == 3);
}

static void bound_random(const struct tia_scene *scene, unsigned number)
{
    (void)number;
    check_bounds(scene);
}

/* Makes a scene of samples from one of rays: every third material emits, one scene in three has ambient occlusion and
 * the others paths, and point lights are so large that rays meet them. */
static void make_samples(struct corpus_rays *c, unsigned i)
{
    struct tia_material *m = (struct tia_material *)(uintptr_t)c->scene.materials;
    struct tia_light *lights = (struct tia_light *)(uintptr_t)c->scene.lights;

    c->scene.integration = (struct tia_integration){
        .integrator = i % 3 ? TIA_PATHS : TIA_OCCLUSION, .seed = i, .distance = i % 2 ? TIA_Q16(3) : 0};
    for (uint32_t k = 0; k < c->scene.light_count; k++)
        if (lights[k].kind == TIA_POINT_LIGHT)
            lights[k].radius = TIA_Q16(1);
    for (uint32_t k = i % 3; k < c->scene.material_count; k += 3) {
        m[k].emission = (struct tia_rgb){TIA_Q30(0.5), TIA_Q30(0.25), TIA_Q30(0.75)};
        m[k].emission_bits = (uint8_t)(k % 5);
    }
}

static void each_random(void (*then)(const struct tia_scene *, unsigned))
{
    static struct corpus_rays c;

    for (unsigned i = 0; i < check_count(random_scenes); i++) {
        corpus_random_rays(&c, 23, i);
        make_samples(&c, i);
        with_hierarchy(&c.scene, then, i);
        if (i % 4)
            continue;
        corpus_add_opacity(&c, i);
        with_hierarchy(&c.scene, then, i);
    }
}

TEST(random_scenes_are_the_same)
{
    samples = unsure = 0;
    each_random(compare_random);
    printf("# %lu of %lu samples were left to the integers\n", unsure, samples);
}

TEST(bounds_hold)
{
    compared = 0;
    most_used = 0;
    each_random(bound_random);
    printf("# %lu samples compared, %.2f of a bound used at most\n", compared, most_used);
    CHECK(compared > 100 && most_used > 0);
}

static unsigned first_extreme;

TEST(extreme_scenes_are_the_same)
{
    static struct corpus_rays c;
    unsigned drawn = 0, all = check_count(random_scenes);

    samples = unsure = 0;
    for (unsigned i = 0; i < all; i++) {
        corpus_random_rays(&c, 29, first_extreme + i);
        make_extreme(&c, first_extreme + i);
        if (tia_scene_check(&c.scene, NULL) != TIA_OK)
            continue;
        with_hierarchy(&c.scene, compare_random, first_extreme + i);
        drawn++;
    }
    printf("# %u scenes; %lu of %lu samples were left to the integers\n", drawn, unsure, samples);
    CHECK(drawn * 2 > all && unsure * 4 < samples * 3);
}

static void compare_bound(const struct tia_scene *scene, unsigned number)
{
    compare(bound_scenes[number].name, number, scene, false);
}

TEST(scenes_for_one_bound_are_the_same)
{
    for (unsigned i = 0; i < sizeof bound_scenes / sizeof *bound_scenes; i++) {
        samples = unsure = 0;
        bound_scenes[i].make();
        with_hierarchy(&world, compare_bound, i);
        printf("# %s: %lu of %lu samples were left to the integers\n", bound_scenes[i].name, unsure, samples);
        CHECK(unsure * 2 < samples);
    }
}

static void compare_light(const struct tia_scene *scene, unsigned number)
{
    struct tia_scene sampled = *scene;

    sampled.integration.integrator = TIA_PATHS;
    samples = unsure = 0;
    compare(light_lines[number], number, &sampled, false);
    CHECK_MSG(samples && unsure * 4 < samples, "%s: %lu of %lu samples are unsure", light_lines[number], unsure,
              samples);
}

/* Checks a scene that is marked as one with a light that the kernels do not support: they compute no sample. */
static void gather_other(const struct tia_scene *scene, unsigned number)
{
    static struct gathered want, got;
    struct tia_scene sampled = *scene;
    struct simd_frames f;

    sampled.integration.integrator = TIA_PATHS;
    samples = 0;
    CHECK(simd_frames_open(&f, simd, &sampled, W, H));
    tia_sure_scene(f.simd)->fixed_only = true;
    gather(f.plain, false, &want);
    gather(f.simd, false, &got);
    CHECK_MSG(memcmp(want.sums, got.sums, sizeof want.sums) == 0, "%s %u", simd->name, number);
    CHECK_EQ(samples, 0);
    simd_frames_close(&f);
}

TEST(kinds_of_lights)
{
    for (unsigned i = 0; i < LIGHT_LINES; i++)
        with_light(i, compare_light);
    with_light(0, gather_other);
}

/* Scene files, and the largest share of their samples, in hundredths, that may be undecided. */
static const struct {
    const char *path;
    enum tia_integrator integrator;
    unsigned unsure;
} files[] = {{"scenes/cornell.tia", TIA_PATHS, 1},         {"scenes/cornell.tia", TIA_OCCLUSION, 1},
             {"scenes/caustic.tia", TIA_PATHS, 4},         {"scenes/window.tia", TIA_PATHS, 10},
             {"scenes/nff/balls_2.nff", TIA_PATHS, 20},    {"scenes/nff/rings_3.nff", TIA_OCCLUSION, 2},
             {"scenes/nff/teapot_3.nff", TIA_OCCLUSION, 4}};

TEST(scene_files)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct scene_file file;
        CHECK_EQ(scene_open(&file, files[i].path, scene_format_of(files[i].path), false), TIA_OK);
        file.scene.integration = (struct tia_integration){.integrator = files[i].integrator, .distance = TIA_Q16(9)};
        samples = unsure = clear = 0;
        compare(files[i].path, 0, &file.scene, false);
        CHECK_MSG(unsure * 100 <= samples * files[i].unsure && clear * 2 >= samples,
                  "%s: %s: %lu of %lu samples are unsure, %lu have small bounds", simd->name, files[i].path, unsure,
                  samples, clear);
        scene_close(&file);
    }
}

/* Pixels with the scene's own number of samples, dithered or not and with moved lights, and path hashes. */
TEST(pixels_hashes_and_moved_lights)
{
    static uint32_t hashes[2][W * H];
    struct tia_light lights[8];
    struct scene_file file;
    struct simd_frames f;

    CHECK_EQ(scene_open(&file, "scenes/cornell.tia", scene_format_of("x.tia"), false), TIA_OK);
    file.scene.integration.spp = 3;
    CHECK(simd_frames_open(&f, simd, &file.scene, W, H));
    CHECK_EQ(simd_frames_differ(&f, true, true), 0);
    memcpy(lights, file.scene.lights, file.scene.light_count * sizeof *lights);
    lights[0].centre.x /= 2;
    CHECK_EQ(tia_view_set_lights(f.plain, lights, file.scene.light_count), TIA_OK);
    CHECK_EQ(tia_view_set_lights(f.simd, lights, file.scene.light_count), TIA_OK);
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    for (int i = 0; i < 2; i++) {
        struct tia_options options = {.debug = &(struct tia_debug){.path_hash = hashes[i]}};
        struct tia_surface surface = simd_frames_surface(i ? f.got : f.want, f.pitch);
        CHECK_EQ(tia_view_draw(i ? f.simd : f.plain, f.hits[i], f.area, &surface, &options), TIA_OK);
    }
    CHECK(memcmp(hashes[0], hashes[1], sizeof hashes[0]) == 0);
    simd_frames_close(&f);
    scene_close(&file);
}

static void run_all(const struct tia_simd *tested)
{
    const struct sure_kernels counting = {
        .occlude = count_occluded, .walk = count_walked, .gather_memory = tested->sure->gather_memory};
    struct tia_simd mine = *tested;
    char title[80];

    kernels = tested->sure;
    mine.sure = &counting;
    simd = &mine;
#define RUN_SIMD(test) ((void)snprintf(title, sizeof title, "%s: %s", tested->name, #test), check_run(title, test))
    RUN_SIMD(random_scenes_are_the_same);
    RUN_SIMD(extreme_scenes_are_the_same);
    RUN_SIMD(scenes_for_one_bound_are_the_same);
    RUN_SIMD(scene_files);
    RUN_SIMD(kinds_of_lights);
    RUN_SIMD(pixels_hashes_and_moved_lights);
    if (tested == tia_simd_at(0))
        RUN_SIMD(bounds_hold);
}

int main(int argc, char **argv)
{
    static const struct sure_kernels here = {.trace = trace, .occlude = occlude, .walk = walk_paths};

    (void)here;
    random_scenes = (unsigned)check_number(argc, argv, 1, random_scenes);
    first_extreme = (unsigned)check_number(argc, argv, 2, first_extreme);
    for (unsigned i = 0; tia_simd_at(i); i++)
        run_all(tia_simd_at(i));
    return check_status();
}
