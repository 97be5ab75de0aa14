/* tia_scene_check: every field just inside and just outside its range, and the fault. */
#include "random.h"
#include "refusals.h"

#define BALLS 3

/* A scene with many features, which is accepted; each case changes one part of it. */
static struct tia_material materials[BALLS];
static struct tia_sphere spheres[BALLS];
static struct tia_light lights[BALLS];
static struct tia_binding bindings[BALLS];

static void set_up(void)
{
    const struct tia_light light = {TIA_VEC3(1, 2, 3), TIA_Q16(0.5), TIA_RGB(1, 1.5, 0)};

    for (uint32_t i = 0; i < BALLS; i++) {
        materials[i] = (struct tia_material){TIA_RGB(1, 0.5, 0), TIA_RGB(0, 0, 0), TIA_RGB(0, 0, 0)};
        spheres[i] = (struct tia_sphere){TIA_VEC3(0, 0, -10), TIA_Q16(2), i};
        lights[i] = light;
        bindings[i] = (struct tia_binding){'a', 0, light};
    }
    scene = (struct tia_scene){
        .camera = {TIA_VEC3(0, 0, 0), TIA_Q16(25)},
        .background = TIA_RGB(0.8, 0.8, 0.8),
        .materials = materials,
        .spheres = spheres,
        .lights = lights,
        .bindings = bindings,
        .material_count = BALLS,
        .sphere_count = BALLS,
        .light_count = BALLS,
        .binding_count = BALLS,
    };
}

TEST(accepted)
{
    struct tia_scene nothing = {.camera = {TIA_VEC3(0, 0, 0), TIA_Q16(25)}};
    struct tia_fault fault = {"untouched", 7, "", ""};

    set_up();
    CHECK_EQ(tia_scene_check(&scene, &fault), TIA_OK);
    CHECK_EQ(tia_scene_check(&nothing, &fault), TIA_OK);
    CHECK_EQ(tia_scene_check(&tia_thesis_scene, &fault), TIA_OK);
    CHECK(!fault.thing);
}

TEST(camera)
{
    set_up();
    check_range(&scene.camera.fov, 65536, 170 * 65536, "camera", 0, "fov", "must be in 1..170 degrees");
}

TEST(colours)
{
    const char *rule = "each channel must be in 0..1";

    set_up();
    check_colour(&scene.background, TIA_Q30_ONE, "scene", 0, "background", rule);
    for (uint32_t i = 0; i < BALLS; i++) {
        check_colour(&materials[i].colour, TIA_Q30_ONE, "material", i, "colour", rule);
        check_colour(&materials[i].transmission, TIA_Q30_ONE, "material", i, "transmission", rule);
        check_colour(&materials[i].emission, TIA_Q30_ONE, "material", i, "emission", rule);
    }
}

/* Q2.30 ends at 2: only negative channels are out of range. */
TEST(emission_of_lights)
{
    const char *rule = "each channel must be in 0..2";

    set_up();
    for (uint32_t i = 0; i < BALLS; i++) {
        check_colour(&lights[i].emission, INT32_MAX, "light", i, "emission", rule);
        check_colour(&bindings[i].state.emission, INT32_MAX, "key", i, "emission", rule);
    }
}

TEST(material_of_a_sphere)
{
    set_up();
    for (uint32_t i = 0; i < BALLS; i++) {
        const uint32_t bad[] = {BALLS, BALLS + 1, INT32_MAX, UINT32_C(1) << 31, UINT32_MAX};
        for (int k = 0; k < 5; k++) {
            spheres[i].material = bad[k];
            check_refused("sphere", i, "material", "must be the index of a material");
        }
        spheres[i].material = BALLS - 1;
        check_accepted();
    }
    scene.material_count = 0;
    scene.materials = NULL;
    check_refused("sphere", 0, "material", "must be the index of a material");
}

TEST(radii)
{
    set_up();
    for (uint32_t i = 0; i < BALLS; i++) {
        const int32_t bad[] = {-1, -64, INT32_MIN, 63, 1};
        for (int k = 0; k < 5; k++) {
            spheres[i].radius = lights[i].radius = bindings[i].state.radius = bad[k];
            check_refused("sphere", i, "radius", "must be at least 2^-10");
            spheres[i].radius = 64;
            check_refused("light", i, "radius", "must be 0 or at least 2^-10");
            lights[i].radius = 64;
            check_refused("key", i, "radius", "must be 0 or at least 2^-10");
            bindings[i].state.radius = 64;
            check_accepted();
        }
        lights[i].radius = bindings[i].state.radius = 0;
        check_accepted();
        spheres[i].radius = 0;
        check_refused("sphere", i, "radius", "must be at least 2^-10");
        spheres[i].radius = 64;
    }
}

/* The farthest point of a ball around the eye itself is one radius away. */
TEST(the_largest_radius)
{
    set_up();
    spheres[1].centre = lights[1].centre = scene.camera.eye;
    spheres[1].radius = lights[1].radius = INT32_MAX;
    check_accepted();
    spheres[1].centre.z = 1;
    check_refused("sphere", 1, "centre", FAR);
    spheres[1].radius--;
    check_accepted();
}

/* Checks a sphere, a light and the light of a key at `offset` from the eye. */
static void check_place(struct tia_vec3 offset, int32_t radius, bool accepted)
{
    const struct tia_vec3 *eye = &scene.camera.eye;
    struct tia_vec3 centre = {eye->x + offset.x, eye->y + offset.y, eye->z + offset.z};

    for (uint32_t i = 0; i < BALLS; i++) {
        set_up();
        spheres[i].centre = centre;
        spheres[i].radius = radius;
        accepted ? check_accepted() : check_refused("sphere", i, "centre", FAR);
        set_up();
        lights[i].centre = centre;
        lights[i].radius = radius;
        accepted ? check_accepted() : check_refused("light", i, "centre", FAR);
        set_up();
        bindings[i].state.centre = centre;
        bindings[i].state.radius = radius;
        accepted ? check_accepted() : check_refused("key", i, "centre", FAR);
    }
}

/* 5 K = 2^31 - 68 and 7 M = 2^31 - 65; 2^31 is 32768 in Q16.16. */
#define K ((int32_t)((UINT32_C(1) << 31) - 68) / 5)
#define M ((int32_t)((UINT32_C(1) << 31) - 65) / 7)

TEST(distances)
{
    set_up();
    check_place((struct tia_vec3){INT32_MAX - 64, 0, 0}, 64, true);
    check_place((struct tia_vec3){0, INT32_MAX - 63, 0}, 64, false);
    check_place((struct tia_vec3){0, 0, -INT32_MAX + 64}, 64, true);
    check_place((struct tia_vec3){0, 0, -INT32_MAX + 63}, 64, false);
    check_place((struct tia_vec3){3 * K, -4 * K, 0}, 67, true); /* 3^2 + 4^2 = 5^2 */
    check_place((struct tia_vec3){3 * K, -4 * K, 1}, 67, true);
    check_place((struct tia_vec3){-4 * K, 0, 3 * K}, 68, false);
    check_place((struct tia_vec3){-4 * K - 1, 0, 3 * K}, 68, false);
    check_place((struct tia_vec3){-4 * K + 1, 0, 3 * K}, 68, true);
    check_place((struct tia_vec3){2 * M, 3 * M, -6 * M}, 64, true); /* 2^2 + 3^2 + 6^2 = 7^2 */
    check_place((struct tia_vec3){-2 * M, 3 * M, 6 * M}, 65, false);
    check_place((struct tia_vec3){-2 * M, 3 * M, 6 * M - 1}, 65, true);
    check_place((struct tia_vec3){INT32_MAX, INT32_MAX, INT32_MAX}, INT32_MAX, false);
    check_place((struct tia_vec3){INT32_MIN, INT32_MIN, INT32_MIN}, INT32_MAX, false);
    check_place((struct tia_vec3){INT32_MIN, 0, 0}, 64, false);
}

/* The eye is at one end of the range of Q16.16 and an object at the other: offsets of up to 2^32 - 1. */
TEST(an_eye_at_the_end_of_the_numbers)
{
    const int32_t ends[] = {INT32_MIN, INT32_MAX};

    for (int i = 0; i < 16; i++) {
        set_up();
        scene.sphere_count = scene.binding_count = 0;
        scene.light_count = 1;
        scene.camera.eye = (struct tia_vec3){ends[i & 1], ends[i >> 1 & 1], ends[i >> 2 & 1]};
        lights[0].centre = (struct tia_vec3){~scene.camera.eye.x, scene.camera.eye.y, scene.camera.eye.z};
        check_refused("light", 0, "centre", FAR);
        lights[0].centre.x = ~lights[0].centre.x;
        check_accepted();
        lights[0].centre.y = i & 8 ? 0 : ~lights[0].centre.y;
        check_refused("light", 0, "centre", FAR);
    }
}

#ifdef __SIZEOF_INT128__
__extension__ typedef unsigned __int128 wide128;

static uint64_t square(int64_t a)
{
    return (uint64_t)(a * a);
}

/* The rule |centre - eye| + radius < 2^31, squared and in integers of 128 bits, which cannot overflow. */
TEST(random_distances)
{
    int inside = 0;

    set_up();
    scene.sphere_count = scene.binding_count = 0;
    scene.light_count = 1;
    for (int i = 0; i < 200000; i++) {
        int32_t v[7];
        for (int k = 0; k < 7; k++)
            v[k] = (int32_t)(random_u32() >> 1) - (1 << 30);
        scene.camera.eye = (struct tia_vec3){v[0], v[1], v[2]};
        lights[0].centre = (struct tia_vec3){v[3], v[4], v[5]};
        lights[0].radius = v[6] < 0 ? -v[6] | 64 : v[6] | 64;
        wide128 d2 =
            (wide128)square((int64_t)v[3] - v[0]) + square((int64_t)v[4] - v[1]) + square((int64_t)v[5] - v[2]);
        bool near = d2 < (wide128)square((INT64_C(1) << 31) - lights[0].radius);
        CHECK_EQ(tia_scene_check(&scene, NULL), near ? TIA_OK : TIA_ERR_RANGE);
        inside += near;
    }
    CHECK(inside > 20000 && inside < 180000);
}
#else
TEST(random_distances)
{
    SKIP("the compiler has no 128-bit integers");
}
#endif

TEST(arrays)
{
    const char *rule = "an array with a count must not be NULL";

    set_up();
    scene.materials = NULL;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.spheres = NULL;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.lights = NULL;
    check_refused("scene", 0, "arrays", rule);
    set_up();
    scene.bindings = NULL;
    check_refused("scene", 0, "arrays", rule);
}

TEST(counts)
{
    const char *rule = "spheres and lights must be fewer than 2^31";

    set_up();
    scene.sphere_count = INT32_MAX;
    scene.light_count = 1;
    check_refused("scene", 0, "counts", rule);
    scene.sphere_count = 1;
    scene.light_count = INT32_MAX;
    check_refused("scene", 0, "counts", rule);
    scene.sphere_count = scene.light_count = UINT32_MAX;
    check_refused("scene", 0, "counts", rule);
    scene.sphere_count = scene.light_count = UINT32_C(1) << 31;
    check_refused("scene", 0, "counts", rule);
}

int main(void)
{
    RUN(accepted);
    RUN(camera);
    RUN(colours);
    RUN(emission_of_lights);
    RUN(material_of_a_sphere);
    RUN(radii);
    RUN(the_largest_radius);
    RUN(distances);
    RUN(an_eye_at_the_end_of_the_numbers);
    RUN(random_distances);
    RUN(arrays);
    RUN(counts);
    return check_status();
}
