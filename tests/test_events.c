/* Events of a playing scene: objects that appear and vanish, colours, and lost balls. */
#include "fall_world.h"

/* Balls pass through a wall that has vanished or has not appeared yet; a ball begins to fall when it appears. */
TEST(only_what_is_there)
{
    open_world(
        "box min 0 -5 -5 max 1 5 5 material m vanishes 1.5\nplane point -3 0 0 normal 1 0 0 material m appears 3.5\n"
        "sphere name a centre 2.5 0 0 radius 0.5 material m\nfall a velocity -1 0 0\n"
        "sphere name b centre 2.5 3 0 radius 0.5 material m appears 1.5\nfall b velocity -1 0 0\n");
    check_place(0, 1, 1.5, 0, 0, 1e-5);
    check_place(0, 8, 1.5 + 7, 0, 0, 1e-5);
    check_place(1, 1.5, 2.5, 3, 0, 0);
    check_place(1, 2.5, 1.5, 3, 0, 1e-5);
    check_place(1, 4.5, -0.5, 3, 0, 1e-5);
    check_place(1, 6.5, -2.5, 3, 0, 1e-5);
    check_place(1, 8.5, -0.5, 3, 0, 1e-5);
    read_end(&world);
}

/* A ball is lost at a distance of 2^14. A hidden shape is a mesh without faces, and keeps its number. */
TEST(lost_balls_vanish)
{
    struct tia_scene out;

    open_world("sphere name a centre 0 0 0 radius 0.5 material m\nfall a velocity 1000 0 0\ngravity 0 0 0 until 100\n");
    for (int t = 16; t <= 20; t += 4) {
        CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &world.scene, t * TIA_Q16_ONE, NULL), TIA_OK);
        CHECK_EQ(out.shape_count, 1);
        CHECK_EQ(out.shapes[0].kind, t == 16 ? TIA_SPHERE : TIA_MESH);
        CHECK_EQ(tia_scene_check(&out, NULL), TIA_OK);
        CHECK(!out.falling && !out.meshes[out.mesh_count - 1].face_count);
    }
    read_end(&world);
}

static bool stop(void *ctx)
{
    return ++*(int *)ctx > 2;
}

TEST(stops_when_asked)
{
    struct tia_scene out;
    int asked = 0;

    open_world(FLOOR "sphere name a centre 0 2.5 0 radius 0.5 material m\ngravity 0 -10 0 until 1000\nfall a\n");
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &world.scene, INT32_MAX,
                          &(struct tia_job){.stop = stop, .ctx = &asked}),
             TIA_STOPPED);
    CHECK_EQ(asked, 3);
    read_end(&world);
}

/* ---- appearing and vanishing ---- */

static struct tia_scene at(double time)
{
    struct tia_scene out;

    CHECK(tia_scene_at_size(&world.scene) <= sizeof memory);
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &world.scene, (tia_q16)(time * 65536), NULL), TIA_OK);
    CHECK_EQ(tia_scene_check(&out, NULL), TIA_OK);
    CHECK(!out.track_count && !out.falling && !out.bvh);
    return out;
}

static void check_shown(uint32_t shape, double from, double to)
{
    const double times[] = {0,
                            from > 0 ? from - 1. / 65536 : 0,
                            from,
                            from + 0.5,
                            isinf(to) ? 100 : to - 1. / 65536,
                            isinf(to) ? 200 : to,
                            isinf(to) ? 300 : to + 100};

    for (unsigned i = 0; i < sizeof times / sizeof *times; i++) {
        struct tia_scene out = at(times[i]);
        bool there = times[i] >= from && times[i] < to;
        CHECK_MSG((out.shapes[shape].kind != TIA_MESH) == there, "shape %u at %f", (unsigned)shape, times[i]);
        CHECK(out.shape_count == world.scene.shape_count && out.mesh_count == world.scene.mesh_count);
        if (!there)
            CHECK(out.shapes[shape].mesh == out.mesh_count - 1 && !out.meshes[out.mesh_count - 1].face_count);
    }
}

TEST(shapes_appear_and_vanish)
{
    open_world("sphere radius 1 material m\nsphere radius 1 appears 1 vanishes 2 material m\n"
               "box min 0 0 0 max 1 1 1 material m appears 0.5\nplane point 0 -1 0 normal 0 1 0 vanishes 3 material m\n"
               "group at 1 0 0\nsphere radius 1 appears 2 vanishes 4 material m\nend\n");
    CHECK_EQ(world.scene.sphere_count, 1);
    CHECK_EQ(world.scene.shape_count, 4);
    check_shown(0, 1, 2);
    check_shown(1, 0.5, INFINITY);
    check_shown(2, 0, 3);
    check_shown(3, 2, 4);
    CHECK_EQ(tia_scene_duration(&world.scene), 4 * TIA_Q16_ONE);
    CHECK(world.scene.shapes == at(0).shapes || at(0).shapes[1].kind == TIA_MESH);
    read_end(&world);
}

/* A hidden light keeps its number: keys and tracks still refer to the same lights. */
TEST(lights_appear_and_vanish)
{
    open_world("light sphere at 0 5 0 radius 1 emission 1 appears 1 vanishes 2\nlight at 1 5 0 emission 0.5\n");
    for (int n = 0; n < 4; n++) {
        struct tia_scene out = at(n * 0.75);
        bool there = n * 0.75 >= 1 && n * 0.75 < 2;
        CHECK_EQ(out.light_count, 2);
        CHECK_EQ(out.lights[0].kind, TIA_SPHERE_LIGHT);
        CHECK_EQ(out.lights[0].emission.g, there ? TIA_Q30_ONE : 0);
        CHECK_EQ(out.lights[0].radius, there ? TIA_Q16_ONE : 0);
        CHECK_EQ(out.lights[1].emission.g, TIA_Q30_ONE / 2);
    }
    CHECK_EQ(world.scene.mesh_count, 0);
    read_end(&world);
}

static void check_colour(struct tia_rgb got, double r, double g, double b)
{
    const double off =
        fmax(fabs(got.r - r * TIA_Q30_ONE), fmax(fabs(got.g - g * TIA_Q30_ONE), fabs(got.b - b * TIA_Q30_ONE)));
    CHECK_MSG(off < 3, "%d %d %d", (int)got.r, (int)got.g, (int)got.b);
}

TEST(colours_have_keyframes)
{
    open_world("material n colour 0.5 emission 1 specular 0 exponent 20 refraction 0 index 1.25\n"
               "animate n colour 1: 0.25 0.5 0  3: 0.75 0.5 1\nanimate n transmission 0: 0  4: 1\n"
               "animate n emission 0: 1  4: 0\nanimate n specular 0: 0 0.5 1  4: 1 0.5 0\n"
               "animate n mirror 0: 0.25  4: 0.5\nanimate n refraction 0: 0.5\nanimate m facing 0: 0  4: 0.5\n");
    struct tia_scene out = at(2);
    check_colour(out.materials[1].colour, 0.5, 0.5, 0.5);
    check_colour(out.materials[1].transmission, 0.5, 0.5, 0.5);
    check_colour(out.materials[1].emission, 0.5, 0.5, 0.5);
    check_colour(out.materials[1].specular, 0.5, 0.5, 0.5);
    check_colour(out.materials[1].mirror, 0.375, 0.375, 0.375);
    check_colour(out.materials[1].refraction, 0.5, 0.5, 0.5);
    check_colour(out.materials[0].facing, 0.25, 0.25, 0.25);
    check_colour(out.materials[0].colour, 1, 1, 1);
    check_colour(at(0).materials[1].colour, 0.25, 0.5, 0);
    check_colour(at(9).materials[1].colour, 0.75, 0.5, 1);
    check_colour(at(1).materials[1].emission, 0.75, 0.75, 0.75);
    CHECK(world.scene.materials[1].colour.r == TIA_Q30_ONE / 2);
    read_end(&world);
}

/* A smooth curve goes beyond its keyframes, but a colour is clamped. */
TEST(colours_are_cut_off)
{
    open_world("animate m colour smooth 0: 0 1 0  1: 1 0 0.5  2: 1 0 0.5  3: 0 1 0\n");
    struct tia_rgb middle = at(1.5).materials[0].colour;
    CHECK(middle.r == TIA_Q30_ONE && middle.g == 0 && middle.b > TIA_Q30_ONE / 2);
    read_end(&world);
}

/* ---- refusals ---- */

static void check_error(const char *text, const char *want)
{
    char whole[1000];

    (void)snprintf(whole, sizeof whole, "material m colour 1\n%s", text);
    read_string(&world, TIA_FORMAT_TIA, whole);
    check_read_error(&world, want);
}

#define BALL "sphere name a radius 1 material m\n"

TEST(mistakes)
{
    check_error("sphere radius 1 material m appears -1",
                "2:1: 'sphere' appears too early, expected a time of 0 or more");
    check_error("sphere radius 1 material m appears 2 vanishes 2",
                "2:1: 'sphere' vanishes before it appears, expected a later time");
    check_error("light at 0 1 0 vanishes 0", "2:1: 'light' vanishes before it appears, expected a later time");
    check_error("key a light 1 at 0 0 0 appears 1",
                "2:24: 'appears' is not a field of a point light, expected emission, "
                "at, attenuation or radius");
    check_error("animate x colour 0: 1", "2:9: 'x' is not defined, expected the name of a material");
    check_error("animate m colour 0: 2", "2:21: '2' is out of range, expected a number from 0 to 1");
    check_error("animate m specular 0: 1", "2:1: animate: must be of a material with an exponent in 1..10000");
    check_error("animate m emission 0: 1", "2:1: animate: must be of a material that emits, at most 1");
    check_error("material n emission 1.5\nanimate n emission 0: 1",
                "3:1: animate: must be of a material that emits, at most 1");
    check_error("fall a", "2:6: 'a' is not defined, expected the name of a sphere");
    check_error("light name a at 0 1 0\nfall a", "3:6: 'a' is a light, expected the name of a sphere");
    check_error("gravity 0 -1", "2:13: the line ends here, expected a number from -32768 to below 32768");
    check_error("gravity 0 0 0\ngravity 0 0 0", "3:1: 'gravity' is given twice, expected once");
    check_error(BALL "fall a speed 1",
                "3:8: 'speed' is not a field of a ball that falls, expected velocity, restitution "
                "or mass");
    check_error("group at 0 1 0\n" BALL "end\nfall a", "3:13: 'a' moves, expected it outside of groups");
}

static void check_fault(const char *text, const char *rule)
{
    char whole[1000];

    (void)snprintf(whole, sizeof whole, "material m colour 1\n" BALL "%s", text);
    read_string(&world, TIA_FORMAT_TIA, whole);
    CHECK_MSG(world.status == TIA_ERR_RANGE && strstr(world.reader.error.text, rule) && world.reader.error.line == 3,
              "%d, %u: '%s', not '%s'", world.status, (unsigned)world.reader.error.line, world.reader.error.text, rule);
    read_end(&world);
}

TEST(ranges)
{
    check_fault("fall a restitution 1.00002", "must be in 0..1");
    check_fault("fall a restitution -0.00002", "must be in 0..1");
    check_fault("fall a mass 0.0009", "must be in 2^-10..1024");
    check_fault("fall a mass 1024.00002", "must be in 2^-10..1024");
    check_fault("fall a velocity 0 0 1024.00002", "each component must be within 1024");
    check_fault("fall a velocity 0 -1024.00002 0", "each component must be within 1024");
    check_fault("gravity -1024.00002 0 0\nfall a", "each component must be within 1024");
    check_fault("gravity 0 0 0 until 1024.1\nfall a", "must end within 1024 seconds");
    check_fault("fall a\nanimate a at 0: 0 0 0", "must have a transform of its own that no track moves");
    check_fault("fall b\nbox name b min 0 0 0 max 1 1 1 material m", "must be a sphere");
    check_fault("fall b\nsphere name b radius 1 scale 1 2 1 material m", "must be scaled evenly");
}

int main(void)
{
    RUN(only_what_is_there);
    RUN(lost_balls_vanish);
    RUN(stops_when_asked);
    RUN(shapes_appear_and_vanish);
    RUN(lights_appear_and_vanish);
    RUN(colours_have_keyframes);
    RUN(colours_are_cut_off);
    RUN(mistakes);
    RUN(ranges);
    return check_status();
}
