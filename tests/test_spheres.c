/* The cores for spheres alone: the pinned pixels of the built-in scene, and the scenes that the cores refuse. */
#include <tia/debug.h>
#include <tia/tia.h>

#include "check.h"

enum { W = 320, H = 240, LIGHTS = 4 };

static const struct tia_core *const cores[] = {&tia_core_spheres, &tia_core_spheres_small};
static const struct tia_tile frame = {0, 0, W, H};
static uint64_t view_memory[1000], hits_memory[W * H * 2];
static tia_rgb565 pixels[W * H];

static int init(const struct tia_core *core, struct tia_view **view, const struct tia_scene *scene)
{
    CHECK(core->view_size(core, scene, LIGHTS) <= sizeof view_memory);
    return core->view_init(core, view, view_memory, sizeof view_memory, scene, LIGHTS, W, H, NULL);
}

/* The CRC of the picture with the light of key a is that in tests/golden/frames.crc. */
TEST(the_pinned_picture)
{
    const struct tia_surface surface = {pixels, 2, 2 * W};
    struct tia_view *view;
    struct tia_hits *hits;

    for (unsigned i = 0; i < 2; i++) {
        CHECK_EQ(init(cores[i], &view, &tia_thesis_scene), TIA_OK);
        CHECK_EQ(tia_view_set_lights(view, &tia_thesis_scene.bindings[0].state, 1), TIA_OK);
        CHECK(cores[i]->hits_size(cores[i], &tia_thesis_scene, frame) <= sizeof hits_memory);
        CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, frame), TIA_OK);
        CHECK_EQ(tia_view_draw(view, hits, frame, &surface, NULL), TIA_OK);
        CHECK_EQ(tia_crc32(0, pixels, W * H), 0x11f70b45);
    }
}

static const struct tia_shape disc = {.kind = TIA_DISC, .disc = {TIA_VEC3(0, 0, -9), {0, 0, TIA_Q30_ONE}, TIA_Q16_ONE}};
static const struct tia_keyframe keys[] = {{0, TIA_VEC3(0, 0, 0)}, {TIA_Q16_ONE, TIA_VEC3(1, 0, 0)}};
static const struct tia_track track = {.target = TIA_MOVES_EYE, .keys = keys, .key_count = 2};
static const struct tia_texture texture = {.kind = TIA_CHECKER, .repeat = {TIA_Q16_ONE, TIA_Q16_ONE}};
static const struct tia_transform transform = {.scale = TIA_VEC3(1, 1, 1)};

/* Scenes with parts other than spheres are refused; tia_core_q16 draws them. */
TEST(scenes_of_more_than_spheres)
{
    struct tia_scene scenes[5];
    struct tia_view *view = NULL;

    for (unsigned i = 0; i < 5; i++)
        scenes[i] = tia_thesis_scene;
    scenes[0].shapes = &disc, scenes[0].shape_count = 1;
    scenes[1].tracks = &track, scenes[1].track_count = 1;
    scenes[2].textures = &texture, scenes[2].texture_count = 1;
    scenes[3].transforms = &transform, scenes[3].transform_count = 1;
    scenes[4].shadows = TIA_SHADOWS_ZPASS;
    for (unsigned i = 0; i < 5; i++) {
        CHECK_MSG(tia_scene_check(&scenes[i], NULL) == TIA_OK || i == 4, "scene %u", i);
        CHECK_EQ(init(cores[0], &view, &scenes[i]), TIA_ERR_RANGE);
        CHECK_EQ(init(cores[1], &view, &scenes[i]), TIA_ERR_RANGE);
    }
    CHECK(!view);
}

TEST(spheres_that_need_rays)
{
    struct tia_material mirrors[8];
    struct tia_scene scenes[4];
    struct tia_view *view = NULL;

    for (unsigned i = 0; i < 4; i++)
        scenes[i] = tia_thesis_scene;
    for (uint32_t i = 0; i < tia_thesis_scene.material_count && i < 8; i++)
        mirrors[i] = tia_thesis_scene.materials[i];
    mirrors[0].mirror = (struct tia_rgb)TIA_RGB(.5, .5, .5);
    scenes[0].materials = mirrors;
    scenes[1].camera.samples = 4;
    scenes[2].integration.integrator = TIA_PATHS;
    scenes[3].integration.integrator = TIA_OCCLUSION;
    for (unsigned i = 0; i < 4; i++) {
        CHECK_EQ(tia_scene_check(&scenes[i], NULL), TIA_OK);
        CHECK_EQ(init(cores[0], &view, &scenes[i]), TIA_ERR_UNSUPPORTED);
        CHECK_EQ(init(cores[1], &view, &scenes[i]), TIA_ERR_UNSUPPORTED);
        CHECK(!cores[0]->draws_by_pixel(cores[0], &scenes[i]));
        CHECK_EQ(cores[0]->simd_size(cores[0], NULL, &scenes[i], 1, 1), 0);
    }
    CHECK(!view);
}

/* Views refuse new lights that need rays. */
TEST(lights_that_need_rays)
{
    const struct tia_light own = tia_thesis_scene.bindings[0].state;
    struct tia_light light[3] = {own, own, own};
    struct tia_view *view;

    light[0].kind = TIA_AMBIENT_LIGHT;
    light[1].kind = TIA_SPOT_LIGHT;
    light[1].direction = (struct tia_dir3)TIA_DIR3(0, -1, 0);
    light[1].inner = TIA_Q16(20);
    light[1].outer = TIA_Q16(30);
    light[2].kind = TIA_DIRECTIONAL_LIGHT;
    light[2].direction = light[1].direction;
    CHECK_EQ(init(cores[0], &view, &tia_thesis_scene), TIA_OK);
    for (int i = 0; i < 3; i++)
        CHECK_EQ(tia_view_set_lights(view, &light[i], 1), TIA_ERR_RANGE);
}

int main(void)
{
    RUN(the_pinned_picture);
    RUN(scenes_of_more_than_spheres);
    RUN(spheres_that_need_rays);
    RUN(lights_that_need_rays);
    return check_status();
}
