/* Extreme general scenes, by q16 and by the checking build, with and without a hierarchy: no number leaves its range,
 * and all of them draw the same picture. Sums that overflow end the program: the compiler checks them. */
#include "arch/frames.h"
#include "check.h"
#include "light_scene.h"
#include "reports.h"

#define MOST INT32_MAX
#define ONE TIA_Q16_ONE

static void draw_all(const struct tia_scene *scene, unsigned width, unsigned height)
{
    static uint64_t memory[1 << 13];
    struct tia_scene with = *scene;
    uint32_t crc = frames_checksum(&tia_core_q16, scene, width, height, false);

    reports = 0;
    CHECK_EQ(frames_checksum(&tia_core_chk, scene, width, height, false), crc);
    CHECK_EQ(tia_bvh_build(&with.bvh, memory, sizeof memory, NULL, scene, NULL), TIA_OK);
    CHECK_EQ(frames_checksum(&tia_core_chk, &with, width, height, false), crc);
    CHECK_MSG(reports == 0, "%u reports, the first %s", reports, first_report);
}

static struct tia_material materials[2];
static struct tia_shape shapes[2];
static struct tia_light lights[3];
static struct tia_transform transform;
static struct tia_scene scene;

static void set_up(uint32_t shape_count, uint32_t light_count)
{
    const struct tia_material white = {.colour = TIA_RGB(1, 1, 1), .mirror = TIA_RGB(1, 1, 1)};

    for (int i = 0; i < 2; i++) {
        materials[i] = white;
        shapes[i] = (struct tia_shape){.material = (uint32_t)i};
    }
    memset(lights, 0, sizeof lights);
    transform = (struct tia_transform){{0, 0, 0}, {0, 0, 0}, {ONE, ONE, ONE}};
    scene = (struct tia_scene){.camera = {.fov = TIA_Q16(40)},
                               .materials = materials,
                               .material_count = 2,
                               .shapes = shapes,
                               .shape_count = shape_count,
                               .lights = lights,
                               .light_count = light_count,
                               .transforms = &transform,
                               .transform_count = 1};
}

TEST(random_scenes_by_their_hierarchies)
{
    static struct corpus_rays random;

    for (unsigned i = 0; i < check_count(30); i++) {
        corpus_random_rays(&random, 29, i);
        draw_all(&random.scene, 20, 15);
        random.scene.bvh = NULL;
        corpus_add_opacity(&random, i);
        draw_all(&random.scene, 20, 15);
    }
}

/* Scenes found by fuzzing, each of which was once beyond some range, or had a different picture with a hierarchy. */

/* Checkers with footprints, of the smallest and the largest cells, in pictures of few pixels, at the largest distances,
 * along the plane and in an instance of the smallest and the largest scale. */
TEST(footprints)
{
    static const uint16_t sizes[][2] = {{1, 1}, {2, 1}, {24, 18}};
    static struct tia_texture texture;

    for (int i = 0; i < 96; i++) {
        set_up(2, 1);
        texture = (struct tia_texture){.repeat = {i & 1 ? MOST : ONE / 1024, i & 1 ? MOST : ONE / 1024},
                                       .repeat_bits = i & 1 ? TIA_TEXTURE_BITS_MIN : TIA_TEXTURE_BITS_MAX,
                                       .cells = {TIA_RGB(1, 1, 1)},
                                       .footprint = true};
        scene.textures = &texture;
        scene.texture_count = materials[0].texture = materials[1].texture = 1;
        materials[1].mirror.r = materials[1].mirror.g = materials[1].mirror.b = 0;
        lights[0] = (struct tia_light){.kind = TIA_AMBIENT_LIGHT, .emission = TIA_RGB(1, 1, 1)};
        scene.camera.fov = i & 2 ? TIA_FOV_MAX : TIA_FOV_MIN;
        scene.camera.eye = (struct tia_vec3){i & 4 ? 18000 * ONE : 0, i & 4 ? 18000 * ONE : 1, 0};
        scene.scale_bits = i & 8 ? TIA_SCALE_BITS_MAX : -TIA_SCALE_BITS_MAX;
        shapes[0].kind = TIA_PLANE;
        shapes[0].plane.normal = (struct tia_dir3){0, TIA_Q30_ONE, i & 4 ? 1 << 29 : 0};
        shapes[1] = (struct tia_shape){.kind = TIA_BOX, .material = 1, .transform = 1};
        shapes[1].box = (struct tia_box){{-ONE, -ONE, -ONE}, {ONE, ONE, ONE}};
        transform.scale.x = transform.scale.y = transform.scale.z = i & 1 ? TIA_SCALE_MIN : TIA_SCALE_MAX;
        transform.position.z = -4000 * ONE;
        draw_all(&scene, sizes[i / 32][0], sizes[i / 32][1]);
    }
}

TEST(windows_as_high_as_may_be_in_wide_images)
{
    static const uint16_t sizes[][2] = {{8192, 1}, {1, 8192}, {40, 30}};

    for (int kind = TIA_FRUSTUM; kind <= TIA_ORTHOGRAPHIC; kind++) {
        for (int i = 0; i < 3; i++) {
            set_up(1, 0);
            shapes[0].plane = (struct tia_plane){{0, -ONE, 0}, {0, TIA_Q30_ONE, 0}};
            shapes[0].kind = TIA_PLANE;
            scene.camera.projection = (enum tia_projection)kind;
            scene.camera.window = (struct tia_window){0, 0, -MOST, MOST, 1};
            draw_all(&scene, sizes[i][0], sizes[i][1]);
        }
    }
}

/* Lamps have an attenuation of nearly 0 at the lit surface: they are 2^17 bright. */
TEST(light_without_end)
{
    set_up(1, 3);
    shapes[0].kind = TIA_BOX;
    shapes[0].box = (struct tia_box){{-ONE, -ONE, -3 * ONE}, {ONE, ONE, -2 * ONE}};
    materials[0].specular = materials[0].colour;
    materials[0].exponent = ONE;
    for (int i = 0; i < 3; i++) {
        lights[i] = (struct tia_light){{0, 0, -2 * ONE + ONE / 4}, 0, {MOST, MOST, MOST}, .linear = 1, .samples = 256};
        lights[i].kind = i == 0 ? TIA_POINT_LIGHT : TIA_SPHERE_LIGHT;
    }
    draw_all(&scene, 6, 6);
}

/* Mirrors reflect all light, and as much again because refraction is total: after 16 of them it is 2^16 times as
 * much. */
TEST(a_hall_of_mirrors)
{
    set_up(2, 3);
    scene.depth = TIA_DEPTH_MAX;
    for (int i = 0; i < 3; i++)
        lights[i] = (struct tia_light){{0, 0, 0}, 0, {MOST, MOST, MOST}, .kind = TIA_AMBIENT_LIGHT};
    for (int i = 0; i < 2; i++) {
        materials[i].refraction = materials[i].mirror;
        materials[i].index = TIA_INDEX_MIN; /* nearly all directions from outside are reflected */
        shapes[i].kind = TIA_PLANE;
        shapes[i].plane.point.z = i ? 2 * ONE : -2 * ONE;
        shapes[i].plane.normal.z = i ? -TIA_Q30_ONE : TIA_Q30_ONE;
    }
    scene.camera.up.y = ONE;
    scene.camera.reference = (struct tia_vec3){ONE, ONE, -ONE};
    draw_all(&scene, 6, 6);
}

/* A grid of 1024 cells of 48 exceeds 32768, but from -32768 on it ends within the range. */
TEST(grids_larger_than_their_numbers)
{
    static uint8_t cells[TIA_GRID_MAX];
    static const struct tia_grid grid = {{-MOST, 0, -ONE}, 48 * ONE, {TIA_GRID_MAX, 1, 1}, cells};

    for (int i = 0; i < TIA_GRID_MAX; i++)
        cells[i] = i % 3 == 0;
    set_up(1, 0);
    shapes[0] = (struct tia_shape){.kind = TIA_GRID, .transform = 1};
    scene.grids = &grid;
    scene.grid_count = 1;
    transform.scale = (struct tia_vec3){ONE / 4, ONE / 4, ONE / 4};
    draw_all(&scene, 40, 30);
}

/* Two objects have a face at the same position, and rays must hit the first object's, although the limit of the search
 * is converted from the second object's axes and back. The second is tested first, because another face of it ends
 * beyond Q16.16. */
TEST(placed_twice)
{
    static const struct tia_vec3 vertices[] = {
        {-1000 * ONE, -900 * ONE, 0}, {1100 * ONE, -1000 * ONE, 0}, {50 * ONE, 1000 * ONE, 0}, {20000 * ONE, 0, 0}};
#define CORNER(n)                                                                                                      \
    {                                                                                                                  \
        n, TIA_NO_INDEX, TIA_NO_INDEX                                                                                  \
    }
    static const struct tia_face faces[] = {{{CORNER(0), CORNER(1), CORNER(2)}}, {{CORNER(1), CORNER(3), CORNER(2)}}};
    static const struct tia_mesh meshes[] = {{vertices, NULL, NULL, faces, 4, 0, 0, 1},
                                             {vertices, NULL, NULL, faces, 4, 0, 0, 2}};

    set_up(2, 1);
    materials[1].colour.r = 0;
    lights[0].kind = TIA_AMBIENT_LIGHT;
    lights[0].emission = (struct tia_rgb)TIA_RGB(1, 1, 1);
    scene.meshes = meshes;
    scene.mesh_count = 2;
    scene.camera.eye.x = 32760 * ONE;
    for (uint32_t i = 0; i < 2; i++)
        shapes[i] = (struct tia_shape){.kind = TIA_MESH, .material = i, .transform = 1, .mesh = i};
    for (int turn = 0; turn < 20; turn++) {
        transform.position = (struct tia_vec3){32760 * ONE, 0, -5 * ONE};
        transform.rotation = (struct tia_vec3){turn * 77777, turn * 99999, 0};
        transform.scale = (struct tia_vec3){118, 115 + turn, 105};
        CHECK_EQ(tia_object_bounds(&scene, 1).max.x, MOST);
        draw_all(&scene, 24, 18);
        shapes[1].mesh = 0;
        uint32_t both = frames_checksum(&tia_core_q16, &scene, 24, 18, false);
        scene.shape_count = 1;
        CHECK_EQ(frames_checksum(&tia_core_q16, &scene, 24, 18, false), both);
        scene.shape_count = 2;
        shapes[1].mesh = 1;
    }
}

/* 20 filters, more than a search stores at a time, leave 0.9^20 = 0.1216 of the light: 4 of 31 levels, 8 of 63. */
TEST(many_veils)
{
    struct tia_shape filters[21] = {{.kind = TIA_PLANE, .plane = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}}}};
    tia_rgb565 expected[4];

    set_up(21, 1);
    scene.shapes = filters;
    materials[0].mirror = (struct tia_rgb){0, 0, 0};
    materials[1].transmission = (struct tia_rgb)TIA_RGB(0.9, 0.9, 0.9);
    for (int i = 1; i < 21; i++)
        filters[i] = (struct tia_shape){
            .kind = TIA_DISC, .material = 1, .disc = {{0, i * ONE, 0}, {0, TIA_Q30_ONE, 0}, 9 * ONE}};
    lights[0].kind = TIA_DIRECTIONAL_LIGHT;
    lights[0].direction.y = -TIA_Q30_ONE;
    lights[0].emission = (struct tia_rgb)TIA_RGB(1, 1, 1);
    scene.camera = (struct tia_camera){.eye = {0, ONE / 2, 0}, .fov = 40 * ONE, .up = {ONE, 0, 0}};
    for (int i = 0; i < 4; i++)
        expected[i] = 4 << 11 | 8 << 5 | 4;
    CHECK_EQ(frames_checksum(&tia_core_q16, &scene, 2, 2, false), tia_crc32(0, expected, 4));
    draw_all(&scene, 2, 2);
}

/* Samples are in range, also with a lamp of the largest brightness. */
TEST(light_that_bounces)
{
    enum { SIDE = 24 };
    static struct tia_sum sums[SIDE * SIDE];

    reports = 0;
    for (int i = 0; i < 4; i++) {
        world_room();
        world.integration.integrator = i & 1 ? TIA_OCCLUSION : TIA_PATHS;
        world_lights[0].emission_bits = i & 2 ? TIA_EMISSION_BITS_MAX : 0;
        struct world_view v = world_open(&tia_core_chk, &tia_estimator_chk, SIDE, SIDE);
        CHECK_EQ(v.estimator->sample(v.view, (struct tia_tile){0, 0, SIDE, SIDE}, 0, 8, sums, SIDE), TIA_OK);
        world_close(&v);
    }
    CHECK_MSG(!reports, "%u reports, the first: %s", reports, first_report);
}

int main(void)
{
    RUN(random_scenes_by_their_hierarchies);
    RUN(footprints);
    RUN(windows_as_high_as_may_be_in_wide_images);
    RUN(light_without_end);
    RUN(a_hall_of_mirrors);
    RUN(grids_larger_than_their_numbers);
    RUN(placed_twice);
    RUN(many_veils);
    RUN(light_that_bounces);
    return check_status();
}
