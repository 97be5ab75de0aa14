/* tia_scene_at against the Hermite formula in double. */
#include <math.h>
#include <tia/motion.h>

#include "check.h"
#include "random.h"

#define ONE 65536
#define KEYS 6

static struct tia_keyframe keys[KEYS];
static struct tia_track track;
static struct tia_scene scene;

static void set_up(enum tia_target target, bool smooth)
{
    track = (struct tia_track){target, 0, smooth, keys, KEYS};
    scene = (struct tia_scene){.tracks = &track, .track_count = 1};
}

static struct tia_vec3 eye_at(tia_q16 time)
{
    struct tia_scene out;

    CHECK_EQ(tia_scene_at(&out, NULL, 0, &scene, time, NULL), TIA_OK);
    return out.camera.eye;
}

/* Returns h00 p0 + h10 m0 + h01 p1 + h11 m1 for one coordinate, in units of 2^-16. */
static double formula(const double *t, const double *p, int count, bool smooth, double time)
{
    int i = 0;

    if (time <= t[0])
        return p[0];
    if (time >= t[count - 1])
        return p[count - 1];
    while (time >= t[i + 1])
        i++;
    double length = t[i + 1] - t[i], u = (time - t[i]) / length;
    if (!smooth)
        return p[i] + u * (p[i + 1] - p[i]);
    double m0 = i > 0 ? (p[i + 1] - p[i - 1]) / (t[i + 1] - t[i - 1]) * length : 0;
    double m1 = i + 2 < count ? (p[i + 2] - p[i]) / (t[i + 2] - t[i]) * length : 0;
    return (2 * u * u * u - 3 * u * u + 1) * p[i] + (u * u * u - 2 * u * u + u) * m0 +
           (-2 * u * u * u + 3 * u * u) * p[i + 1] + (u * u * u - u * u) * m1;
}

static double at_most_all(double x)
{
    return x < INT32_MIN ? INT32_MIN : x > INT32_MAX ? INT32_MAX : x;
}

static void check_near(tia_q16 got, double want)
{
    CHECK_MSG(fabs(got - at_most_all(want)) < 0.501, "%d, not %f", (int)got, want);
}

static void check_time(tia_q16 time)
{
    double t[KEYS], x[KEYS], y[KEYS], z[KEYS];

    for (int i = 0; i < KEYS; i++) {
        t[i] = keys[i].time;
        x[i] = keys[i].value.x;
        y[i] = keys[i].value.y;
        z[i] = keys[i].value.z;
    }
    struct tia_vec3 eye = eye_at(time);
    check_near(eye.x, formula(t, x, (int)track.key_count, track.smooth, time));
    check_near(eye.y, formula(t, y, (int)track.key_count, track.smooth, time));
    check_near(eye.z, formula(t, z, (int)track.key_count, track.smooth, time));
}

/* Tracks have all lengths, short and long intervals, small and largest values. */
TEST(random_tracks)
{
    for (int n = 0; n < 4000; n++) {
        set_up(TIA_MOVES_EYE, n & 1);
        track.key_count = 1 + random_u32() % KEYS;
        tia_q16 time = (tia_q16)(random_u32() % ONE), most = (tia_q16)(1u << (8 + random_u32() % 20));
        unsigned fine = random_u32() % 24;
        for (uint32_t i = 0; i < track.key_count; i++) {
            keys[i].time = time;
            time += 1 + (tia_q16)(random_u32() % (uint32_t)most);
            keys[i].value = (struct tia_vec3){(tia_q16)random_u32() >> fine, (tia_q16)random_u32() >> fine,
                                              (tia_q16)random_u32() >> fine};
        }
        for (int i = 0; i < 20; i++)
            check_time((tia_q16)(random_u32() % (uint32_t)time));
        for (uint32_t i = 0; i < track.key_count; i++)
            check_time(keys[i].time);
        check_time(INT32_MIN);
        check_time(INT32_MAX);
        CHECK_EQ(tia_scene_duration(&scene), keys[track.key_count - 1].time);
    }
}

TEST(by_hand)
{
    const int32_t times[4] = {0, 1, 2, 3}, values[4] = {0, 0, 16, 16};

    set_up(TIA_MOVES_EYE, true);
    track.key_count = 4;
    for (int i = 0; i < 4; i++)
        keys[i] = (struct tia_keyframe){times[i] * ONE, {values[i] * ONE, 0, -values[i] * ONE}};
    /* between 1 and 2, with tangents of 8: 8/8 + 16/2 - 8/8 = 8; before, from 0 to 0 with the tangents 0 and 8: -1 */
    CHECK_EQ(eye_at(3 * ONE / 2).x, 8 * ONE);
    CHECK_EQ(eye_at(3 * ONE / 2).z, -8 * ONE);
    CHECK_EQ(eye_at(ONE / 2).x, -ONE);
    CHECK_EQ(eye_at(5 * ONE / 2).x, 17 * ONE);
    track.smooth = false;
    CHECK_EQ(eye_at(ONE / 2).x, 0);
    CHECK_EQ(eye_at(5 * ONE / 4).x, 4 * ONE);
    CHECK_EQ(eye_at(-5).x, 0);
    CHECK_EQ(eye_at(4 * ONE).x, 16 * ONE);
}

/* A curve that leaves Q16.16 between its keyframes is clamped. */
TEST(cut_off)
{
    set_up(TIA_MOVES_EYE, true);
    track.key_count = 4;
    for (int i = 0; i < 4; i++) {
        tia_q16 v = i < 2 ? INT32_MIN : INT32_MAX;
        keys[i] = (struct tia_keyframe){i * ONE, {v, ~v, 0}};
    }
    struct tia_vec3 eye = eye_at(ONE / 2);
    CHECK(eye.x == INT32_MIN && eye.y == INT32_MAX);
    eye = eye_at(5 * ONE / 2);
    CHECK(eye.x == INT32_MAX && eye.y == INT32_MIN);
}

static struct tia_light lights[3];
static struct tia_transform transforms[2];
static uint64_t memory[100];

static struct tia_track tracks[7];
static struct tia_keyframe moment;

static void set_everything(void)
{
    moment = (struct tia_keyframe){2 * ONE, {3 * ONE, 0, -4 * ONE}};
    for (int i = 0; i < 7; i++)
        tracks[i] = (struct tia_track){(enum tia_target)i, i >= 4 ? 1 : 2, false, &moment, 1};
    for (int i = 0; i < 3; i++)
        lights[i] = (struct tia_light){.centre = TIA_VEC3(1, 1, 1), .direction = {7, 8, 9}, .radius = i};
    for (int i = 0; i < 2; i++)
        transforms[i] = (struct tia_transform){TIA_VEC3(1, 1, 1), TIA_VEC3(1, 1, 1), TIA_VEC3(1, 1, 1)};
    scene = (struct tia_scene){.lights = lights,
                               .light_count = 3,
                               .transforms = transforms,
                               .transform_count = 2,
                               .tracks = tracks,
                               .track_count = 7};
}

static bool is_moment(struct tia_vec3 v)
{
    return v.x == 3 * ONE && v.y == 0 && v.z == -4 * ONE;
}

TEST(every_target)
{
    const struct tia_bvh *bvh = (const struct tia_bvh *)(const void *)memory;
    struct tia_scene out;
    struct tia_vec3 one = TIA_VEC3(1, 1, 1);
    size_t size;

    set_everything();
    scene.bvh = bvh;
    size = tia_scene_at_size(&scene);
    CHECK(size >= 3 * sizeof *lights + 2 * sizeof *transforms && size <= sizeof memory);
    CHECK_EQ(tia_scene_at(&out, memory, size - 1, &scene, 0, NULL), TIA_ERR_MEMORY);
    CHECK_EQ(tia_scene_at(&out, memory, size, &scene, 0, NULL), TIA_OK);
    CHECK(is_moment(out.camera.eye) && is_moment(out.camera.reference));
    CHECK(is_moment(out.lights[2].centre) && !memcmp(&out.lights[1], &lights[1], sizeof lights[1]));
    CHECK(out.lights[2].radius == 2);
    CHECK(fabs(out.lights[2].direction.x - 0.6 * TIA_Q30_ONE) <= 2 && out.lights[2].direction.y == 0);
    CHECK(fabs(out.lights[2].direction.z + 0.8 * TIA_Q30_ONE) <= 2);
    CHECK(is_moment(out.transforms[1].position) && is_moment(out.transforms[1].rotation));
    CHECK(is_moment(out.transforms[1].scale) && !memcmp(&out.transforms[0], &transforms[0], sizeof transforms[0]));
    CHECK(!out.tracks && !out.track_count && !out.bvh);
    CHECK(!memcmp(&lights[2].centre, &one, sizeof one) && !memcmp(&transforms[1].scale, &one, sizeof one));
    CHECK_EQ(tia_scene_duration(&scene), 2 * ONE);
}

/* Elements that do not move are shared, others are copied. */
TEST(what_stays_is_shared)
{
    struct tia_scene out;

    set_everything();
    scene.track_count = 2; /* only the camera's tracks */
    CHECK_EQ(tia_scene_at_size(&scene), 0);
    CHECK_EQ(tia_scene_at(&out, NULL, 0, &scene, 0, NULL), TIA_OK);
    CHECK(out.lights == lights && out.transforms == transforms);
    scene.track_count = 4;
    CHECK(tia_scene_at_size(&scene) < 4 * sizeof *lights);
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &scene, 0, NULL), TIA_OK);
    CHECK(out.lights != lights && out.transforms == transforms);
    scene.tracks = tracks + 4;
    scene.track_count = 3;
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &scene, 0, NULL), TIA_OK);
    CHECK(out.lights == lights && out.transforms != transforms && is_moment(out.transforms[1].scale));
    scene.track_count = 0;
    CHECK_EQ(tia_scene_duration(&scene), 0);
    CHECK_EQ(tia_scene_at_size(&scene), 0);
    CHECK_EQ(tia_scene_at(&scene, NULL, 0, &scene, 0, NULL), TIA_OK);
}

TEST(into_itself)
{
    struct tia_scene out;

    set_everything();
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &scene, 0, NULL), TIA_OK);
    set_everything();
    CHECK_EQ(tia_scene_at(&scene, memory, sizeof memory, &scene, 0, NULL), TIA_OK);
    CHECK(!memcmp(&out.camera, &scene.camera, sizeof out.camera) && !scene.tracks);
    CHECK(is_moment(scene.lights[2].centre) && is_moment(scene.transforms[1].position));
}

/* The mean of opposite directions is 0: the light then keeps its direction. */
TEST(a_direction_through_nothing)
{
    struct tia_keyframe turning[2] = {{0, {ONE, 0, 0}}, {2 * ONE, {-ONE, 0, 0}}};
    struct tia_track turns = {TIA_ROTATES_LIGHT, 0, false, turning, 2};
    struct tia_scene out;

    set_everything();
    scene.tracks = &turns;
    scene.track_count = 1;
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &scene, ONE, NULL), TIA_OK);
    CHECK(out.lights[0].direction.x == 7 && out.lights[0].direction.z == 9);
    CHECK_EQ(tia_scene_at(&out, memory, sizeof memory, &scene, ONE + 1, NULL), TIA_OK);
    CHECK(out.lights[0].direction.x <= -TIA_Q30_ONE + 2);
}

int main(void)
{
    RUN(random_tracks);
    RUN(by_hand);
    RUN(cut_off);
    RUN(every_target);
    RUN(what_stays_is_shared);
    RUN(into_itself);
    RUN(a_direction_through_nothing);
    return check_status();
}
