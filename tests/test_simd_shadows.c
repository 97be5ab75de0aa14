/* Pixels behind the rasteriser, whose faces and lights are known, by every instruction set against plain C, byte by
 * byte: the scenes of scenes/shadows and the two programs with lights that arrive and shares of lights, and random
 * scenes with every technique for shadows.
 *
 *     test_simd_shadows         as many scenes as seconds allow
 *     test_simd_shadows N       N random scenes by each instruction set */
#include <stdlib.h>
#include <tia/simd.h>

#include "common/scene/scene_load.h"
#include "flat_scene.h"
#include "sample_count.h"
#include "simd_frames.h"
#include "with_hierarchy.h"

static const struct tia_simd *simd;
static unsigned random_scenes = 60;

static const struct sure_kernels *kernels; /* of the instruction set; `count` wraps them */

static void count(struct sure_block *block, void *memory)
{
    kernels->shade(block, memory);
    count_samples(block);
}

/* Lets the instruction set draw what the lights need, such as their maps, which plain C has drawn before: first for
 * other lights, so that nothing remains. */
static void set_lights(struct tia_view *view, const struct tia_scene *scene)
{
    struct tia_light other[16];

    CHECK(scene->light_count <= 16);
    for (uint32_t i = 0; i < scene->light_count; i++) {
        other[i] = scene->lights[i];
        other[i].centre.x = -other[i].centre.x - TIA_Q16_ONE;
        other[i].direction.x = -other[i].direction.x;
    }
    CHECK_EQ(tia_view_set_lights(view, other, scene->light_count), TIA_OK);
    CHECK_EQ(tia_view_set_lights(view, scene->lights, scene->light_count), TIA_OK);
}

static void compare(const char *what, unsigned number, const struct tia_scene *scene, unsigned width, unsigned height,
                    bool dither)
{
    struct simd_frames f;

    CHECK_MSG(simd_frames_open(&f, simd, scene, width, height), "%s %u", what, number);
    CHECK_MSG(strcmp(tia_view_simd(f.simd), simd->name) == 0, "%s %u is left to plain C", what, number);
    set_lights(f.simd, scene);
    CHECK_MSG(simd_frames_differ(&f, true, dither) == 0, "%s: %s %u, technique %d, %ux%u: %s", simd->name, what, number,
              (int)scene->shadows, width, height, simd_frames_where(&f));
    simd_frames_close(&f);
}

static const enum tia_shadows techniques[] = {TIA_SHADOWS_ZFAIL, TIA_SHADOWS_RAYS, TIA_SHADOWS_MAP};

static const char *const files[] = {
    "scenes/shadow-volume.tia",  "scenes/shadow-mapping.tia",   "scenes/shadows/open.tia", "scenes/shadows/place.tia",
    "scenes/shadows/caster.tia", "scenes/shadows/receiver.tia", "scenes/shadows/soft.tia"};

/* A few samples in a hundred are undecided at most. */
TEST(scene_files)
{
    for (size_t i = 0; i < sizeof files / sizeof *files; i++) {
        struct scene_file file;
        CHECK_EQ(scene_open(&file, files[i], scene_format_of(files[i]), false), TIA_OK);
        samples = unsure = 0;
        for (size_t k = 0; k < 3 - (file.scene.lights[0].samples > 9); k++) { /* 49 maps would take long */
            file.scene.shadows = techniques[k];
            file.scene.shadow_map = (struct tia_shadow_map){.size = 256};
            compare(files[i], 0, &file.scene, 61, 35, k % 2);
        }
        CHECK_MSG(samples && unsure * 100 <= samples * 3, "%s: %s: %lu of %lu samples are unsure", simd->name, files[i],
                  unsure, samples);
        scene_close(&file);
    }
}

/* Blocks of pixels that show one face: at lower resolutions most show several. */
TEST(faces_larger_than_blocks)
{
    struct scene_file file;

    CHECK_EQ(scene_open(&file, files[1], TIA_FORMAT_TIA, false), TIA_OK);
    file.scene.shadows = TIA_SHADOWS_RAYS;
    compare(files[1], 0, &file.scene, 640, 480, false);
    scene_close(&file);
}

/* Without a bias, texels are as far away as the points that look them up, so that bounds often decide nothing. The last
 * file's 49 maps would take long. */
TEST(no_bias)
{
    for (size_t i = 0; i + 1 < sizeof files / sizeof *files; i++) {
        struct scene_file file;
        CHECK_EQ(scene_open(&file, files[i], scene_format_of(files[i]), false), TIA_OK);
        file.scene.shadows = TIA_SHADOWS_MAP;
        file.scene.shadow_map = (struct tia_shadow_map){.size = 256, .bias = TIA_BIAS_NONE, .filter = TIA_FILTER_3X3};
        compare(files[i], 0, &file.scene, 61, 35, false);
        scene_close(&file);
    }
}

/* Makes a point light a disc or a rectangle, which some points may be close to. */
static void widen(struct tia_light *light, unsigned i)
{
    light->kind = i % 2 ? TIA_RECTANGLE_LIGHT : TIA_DISC_LIGHT;
    light->samples = (uint16_t)(1 + i % 13);
    light->radius = flat_between(.1, 3, 65536);
    light->direction = (struct tia_dir3){flat_between(-.5, .5, 1 << 30), -(1 << 29) - (1 << 28), 1 << 28};
    light->side[0] = (struct tia_vec3){flat_between(.1, 3, 65536), 0, flat_between(-2, 2, 65536)};
    light->side[1] = (struct tia_vec3){0, flat_between(.1, 3, 65536), flat_between(-.5, .5, 65536)};
}

/* Makes some of the scene's materials mirrors or checkers, and its camera parallel, shifted, or of several samples. */
static void vary(struct tia_scene *scene, unsigned i)
{
    static struct tia_texture texture;

    texture = (struct tia_texture){.kind = TIA_CHECKER,
                                   .repeat = {flat_between(.1, 2, 65536), flat_between(.1, 2, 65536)},
                                   .offset = {flat_between(-1, 1, 65536), 0},
                                   .cells = {flat_colour(1), flat_colour(1)}};
    scene->textures = &texture;
    scene->texture_count = 1;
    flat_materials[0].texture = i % 2;
    flat_materials[1].texture = i % 3 == 0;
    flat_materials[2].mirror = i % 4 ? (struct tia_rgb){0, 0, 0} : flat_colour(.5);
    flat_materials[3].facing = flat_colour(i % 3 ? 0 : .4);
    flat_lights[0].quadratic = i % 5 ? 0 : 3000;
    flat_lights[0].radius = i % 7 ? 0 : TIA_Q16(1);
    for (unsigned n = 0; n < 2 && n < scene->light_count; n++)
        if ((i + n) % 3 == 0)
            widen(&flat_lights[n], i / 2);
    scene->depth = 3;
    scene->camera.samples = i % 6 == 5 ? 4 : 1;
    if (i % 5 == 1) {
        scene->camera.projection = TIA_ORTHOGRAPHIC;
        scene->camera.window = (struct tia_window){.bottom = TIA_Q16(-3), .top = TIA_Q16(4)};
    } else if (i % 5 == 2) {
        scene->camera.projection = TIA_FRUSTUM;
        scene->camera.window = (struct tia_window){TIA_Q16(-1), TIA_Q16(2), TIA_Q16(-1), TIA_Q16(1), TIA_Q16(2)};
    }
    scene->shadow_map.filter = (enum tia_filter)(i % (TIA_FILTER_PCSS + 1));
    scene->shadow_map.bias = (enum tia_bias)(i / 3 % (TIA_BIAS_PLANE + 1));
    scene->shadow_map.amount = scene->shadow_map.bias == TIA_BIAS_DEFAULT ? 0 : flat_between(0, 3, 65536);
}

static void compare_random(const struct tia_scene *scene, unsigned number)
{
    compare("random scene", number, scene, 41, 37, number % 3 == 1);
}

TEST(random_scenes_of_faces)
{
    for (unsigned i = 0; i < check_count(random_scenes); i++) {
        struct tia_scene scene = flat_scene();
        vary(&scene, i);
        with_hierarchy(&scene, compare_random, i);
    }
}

/* Faces of tessellated shapes, and a scene with curved shapes, are left to plain C. */
TEST(curved_shapes)
{
    struct scene_file file;
    struct simd_frames f;

    CHECK_EQ(scene_open(&file, "scenes/nff/balls_1.nff", TIA_FORMAT_NFF, false), TIA_OK);
    file.scene.shadows = TIA_SHADOWS_ZFAIL;
    CHECK(simd_frames_open(&f, simd, &file.scene, 40, 30));
    CHECK(strcmp(tia_view_simd(f.simd), "plain") == 0);
    CHECK_EQ(simd_frames_differ(&f, true, false), 0);
    simd_frames_close(&f);
    file.scene.tessellated = TIA_Q16(1) / 2;
    compare("tessellated balls", 0, &file.scene, 40, 30, false);
    scene_close(&file);
}

/* A light that moves so far away that the vertices lose digits changes the faces' planes. */
TEST(lights_move)
{
    struct scene_file file;
    struct simd_frames f;

    CHECK_EQ(scene_open(&file, files[0], TIA_FORMAT_TIA, false), TIA_OK);
    CHECK(simd_frames_open(&f, simd, &file.scene, 61, 35));
    for (int step = 0; step < 3; step++) {
        struct tia_light lights[2] = {file.scene.lights[0], file.scene.lights[1]};
        lights[0].centre.y = step == 1 ? TIA_Q16(2000) : TIA_Q16(7);
        CHECK_EQ(tia_view_set_lights(f.plain, lights, 2), TIA_OK);
        CHECK_EQ(tia_view_set_lights(f.simd, lights, 2), TIA_OK);
        CHECK_EQ(simd_frames_differ(&f, step == 0, false), 0);
    }
    simd_frames_close(&f);
    scene_close(&file);
}

static void run_all(const struct tia_simd *tested)
{
    struct sure_kernels counting = *tested->sure;
    struct tia_simd mine = *tested;
    char title[80];

    counting.shade = count;
    kernels = tested->sure;
    mine.sure = &counting;
    simd = &mine;
    random_state = 1;
#define RUN_SIMD(test) ((void)snprintf(title, sizeof title, "%s: %s", tested->name, #test), check_run(title, test))
    RUN_SIMD(scene_files);
    RUN_SIMD(faces_larger_than_blocks);
    RUN_SIMD(no_bias);
    RUN_SIMD(random_scenes_of_faces);
    RUN_SIMD(curved_shapes);
    RUN_SIMD(lights_move);
}

int main(int argc, char **argv)
{
    random_scenes = (unsigned)check_number(argc, argv, 1, random_scenes);
    for (unsigned i = 0; tia_simd_at(i); i++)
        run_all(tia_simd_at(i));
    return check_status();
}
