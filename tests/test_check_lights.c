/* tia_scene_check on lights and tracks: each rule at its limit and one step beyond. */
#include "refusals.h"

#define ONE 65536
#define LENGTH "its length must be in 0.5..1.5"

static struct tia_light light;
static struct tia_binding binding;
static struct tia_transform transform;
static struct tia_keyframe keys[2];
static struct tia_track track;

static void set_up(void)
{
    light = (struct tia_light){.radius = ONE,
                               .emission = TIA_RGB(1, 1, 1),
                               .direction = {0, 0, TIA_Q30_ONE},
                               .inner = 10 * ONE,
                               .outer = 20 * ONE,
                               .side = {{ONE, 0, 0}, {0, ONE, 0}}};
    binding = (struct tia_binding){'a', 0, light};
    transform = (struct tia_transform){TIA_VEC3(0, 0, 0), TIA_VEC3(0, 0, 0), TIA_VEC3(1, 1, 1)};
    keys[0] = (struct tia_keyframe){0, TIA_VEC3(1, 1, 1)};
    keys[1] = (struct tia_keyframe){ONE, TIA_VEC3(1, 1, 1)};
    track = (struct tia_track){TIA_MOVES_EYE, 0, false, keys, 2};
    scene = (struct tia_scene){.camera = {.fov = 25 * ONE},
                               .lights = &light,
                               .light_count = 1,
                               .bindings = &binding,
                               .binding_count = 1,
                               .transforms = &transform,
                               .transform_count = 1};
}

/* Checks a light, and one that a key sets. */
static void check_lights(const char *field, const char *rule)
{
    struct tia_light good = binding.state;

    check_refused("light", 0, field, rule);
    binding.state = light;
    light = good;
    check_refused("key", 0, field, rule);
    light = binding.state;
    binding.state = good;
}

static void set_light(enum tia_light_kind kind)
{
    set_up();
    light.kind = kind;
    check_accepted();
}

TEST(kinds_of_lights)
{
    set_up();
    light.kind = (enum tia_light_kind)7;
    check_lights("kind", "must be a kind of light");
    light.kind = (enum tia_light_kind) - 1;
    check_lights("kind", "must be a kind of light");
}

/* Kinds without a radius, position or attenuation ignore those fields, which may have any value. */
TEST(what_each_kind_of_light_has)
{
    for (int kind = 0; kind < 7; kind++) {
        bool ambient = kind == TIA_AMBIENT_LIGHT;
        bool radius = kind == TIA_POINT_LIGHT || ambient || kind == TIA_DISC_LIGHT || kind == TIA_SPHERE_LIGHT;
        bool place = kind != TIA_DIRECTIONAL_LIGHT && kind != TIA_AMBIENT_LIGHT;
        bool direction = kind == TIA_DIRECTIONAL_LIGHT || kind == TIA_SPOT_LIGHT || kind == TIA_DISC_LIGHT;

        set_light((enum tia_light_kind)kind);
        light.radius = 63;
        radius ? check_lights("radius", "must be 0 or at least 2^-10") : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.centre.z = INT32_MAX;
        place ? check_lights("centre", FAR) : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.linear = -1;
        place ? check_lights("attenuation", "each term must be in 0..32767") : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.direction = (struct tia_dir3){0, 0, 0};
        direction ? check_lights("direction", LENGTH) : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.samples = 256;
        check_accepted();
        light.samples = 257;
        kind >= TIA_RECTANGLE_LIGHT || ambient ? check_lights("samples", "must be in 1..256") : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.emission_bits = TIA_EMISSION_BITS_MAX;
        check_accepted();
        light.emission_bits++;
        check_lights("emission_bits", "must be in 0..13");
        set_light((enum tia_light_kind)kind);
        light.outer = 0;
        kind == TIA_SPOT_LIGHT ? check_lights("outer", "must be in 1..90 degrees") : check_accepted();
        set_light((enum tia_light_kind)kind);
        light.side[1] = light.side[0];
        kind == TIA_RECTANGLE_LIGHT ? check_lights("side", "the sides must not be on one line, unless both are 0")
                                    : check_accepted();
    }
}

TEST(attenuation)
{
    const char *rule = "each term must be in 0..32767";

    set_up();
    check_range(&light.constant, 0, 32767 * ONE, "light", 0, "attenuation", rule);
    check_range(&light.linear, 0, 32767 * ONE, "light", 0, "attenuation", rule);
    check_range(&light.quadratic, 0, 32767 * ONE, "light", 0, "attenuation", rule);
}

TEST(cones_of_light)
{
    set_light(TIA_SPOT_LIGHT);
    check_range(&light.inner, 0, 20 * ONE, "light", 0, "inner", "must be in 0..outer degrees");
    light.inner = 0;
    check_range(&light.outer, ONE, 90 * ONE, "light", 0, "outer", "must be in 1..90 degrees");
}

/* Directions have lengths of exactly 1/2 and 3/2, and 2^-30 beyond, along each axis. */
TEST(directions)
{
    set_light(TIA_DIRECTIONAL_LIGHT);
    for (int i = 0; i < 6; i++) {
        tia_q30 *along = i % 3 == 0 ? &light.direction.x : i % 3 == 1 ? &light.direction.y : &light.direction.z;
        int sign = i < 3 ? 1 : -1;
        light.direction = (struct tia_dir3){0, 0, 0};
        *along = sign * (TIA_Q30_ONE / 2);
        check_accepted();
        *along = sign * (TIA_Q30_ONE / 2 - 1);
        check_lights("direction", LENGTH);
        *along = sign * (TIA_Q30_ONE / 2 * 3);
        check_accepted();
        *along = sign * (TIA_Q30_ONE / 2 * 3 + 1);
        check_lights("direction", LENGTH);
    }
    light.direction = (struct tia_dir3){INT32_MIN, INT32_MIN, INT32_MIN};
    check_lights("direction", LENGTH);
}

/* Returns coordinates x, y, z, rotated `times` times. */
static struct tia_vec3 turned(int times, tia_q16 x, tia_q16 y, tia_q16 z)
{
    return times == 0   ? (struct tia_vec3){x, y, z}
           : times == 1 ? (struct tia_vec3){z, x, y}
                        : (struct tia_vec3){y, z, x};
}

/* The corner at 2, 3, 6 times m is 7 m away: 2^31 - 2. */
TEST(corners_of_rectangles)
{
    const tia_q16 m = INT32_MAX / 7;

    for (int i = 0; i < 24; i++) {
        tia_q16 a = i & 1 ? 1 : -1, b = i & 2 ? 1 : -1, c = i & 4 ? 1 : -1;
        set_light(TIA_RECTANGLE_LIGHT);
        light.side[0] = turned(i / 8, 0, a * 3 * m, 0);
        light.side[1] = turned(i / 8, 0, 0, b * 6 * m);
        light.centre = turned(i / 8, c * 2 * m, 0, 0);
        check_accepted();
        light.centre = turned(i / 8, c * (2 * m + 8), 0, 0);
        check_lights("centre", FAR);
    }
    light.centre = light.side[0] = light.side[1] = (struct tia_vec3){INT32_MIN, INT32_MIN, INT32_MIN};
    check_lights("centre", FAR);
}

TEST(sides_of_rectangles)
{
    const char *rule = "the sides must not be on one line, unless both are 0";
    const tia_q16 large = INT32_MAX / 4;

    set_light(TIA_RECTANGLE_LIGHT);
    light.side[0] = light.side[1] = (struct tia_vec3){0, 0, 0};
    check_accepted();
    light.side[0].x = 1;
    check_lights("side", rule);
    light.side[1].y = 1;
    check_accepted();
    light.side[0] = (struct tia_vec3){large, -large, large};
    light.side[1] = (struct tia_vec3){-large, large, -large};
    check_lights("side", rule);
    for (int i = 0; i < 3; i++) {
        light.side[1] = (struct tia_vec3){-large + (i == 0), large + (i == 1), -large + (i == 2)};
        check_accepted();
    }
    light.side[0] = (struct tia_vec3){0, 5, 0};
    light.side[1] = (struct tia_vec3){0, 3, 0};
    check_lights("side", rule);
}

static void set_track(enum tia_target target)
{
    set_up();
    scene.tracks = &track;
    scene.track_count = 1;
    track.target = target;
}

TEST(tracks)
{
    const char *rule = "must be 0 or more, and rise";

    for (int target = 0; target < 7; target++) {
        set_track((enum tia_target)target);
        check_accepted();
        track.index = 1;
        target < 2 ? check_accepted()
                   : check_refused("track", 0, "index", "must be the index of a light, transform, shape or material");
        track.index = 0;
        track.key_count = 0;
        check_refused("track", 0, "keys", "must be one or more");
        track.key_count = 2;
        track.keys = NULL;
        check_refused("track", 0, "keys", "must be one or more");
        track.keys = keys;
        keys[0].time = -1;
        check_refused("track", 0, "time", rule);
        keys[0].time = ONE - 1;
        check_accepted();
        keys[0].time = ONE;
        check_refused("track", 0, "time", rule);
    }
    track.target = TIA_TARGETS;
    check_refused("track", 0, "target", "must be a target of animation");
}

TEST(values_of_tracks)
{
    const tia_q16 most = INT32_MAX - 1;

    set_track(TIA_MOVES_LIGHT);
    light.radius = 0;
    keys[1].value = (struct tia_vec3){0, most, 0};
    check_accepted();
    light.radius = 64;
    check_refused("track", 0, "value", FAR);
    light.kind = TIA_AMBIENT_LIGHT;
    check_accepted();
    set_track(TIA_MOVES_TRANSFORM);
    keys[1].value = (struct tia_vec3){0, 0, most};
    check_accepted();
    keys[1].value.z++;
    check_refused("track", 0, "value", FAR);
    track.target = TIA_MOVES_REFERENCE;
    check_refused("track", 0, "value", FAR);
    track.target = TIA_ROTATES_TRANSFORM;
    check_accepted();
    set_track(TIA_ROTATES_LIGHT);
    keys[0].value = (struct tia_vec3){0, 0, 0};
    check_refused("track", 0, "value", "must not be 0");
    keys[0].value.y = 1;
    check_accepted();
    set_track(TIA_SCALES_TRANSFORM);
    check_range(&keys[1].value.x, 64, 1024 * ONE, "track", 0, "value", "must be in 2^-10..1024");
    check_range(&keys[0].value.y, 64, 1024 * ONE, "track", 0, "value", "must be in 2^-10..1024");
    check_range(&keys[1].value.z, 64, 1024 * ONE, "track", 0, "value", "must be in 2^-10..1024");
}

/* Every position of the eye counts, and so does the camera's own. */
TEST(an_eye_that_moves)
{
    set_track(TIA_MOVES_EYE);
    keys[0].value = keys[1].value = (struct tia_vec3){0, 0, 0};
    light.radius = 0;
    light.centre.x = INT32_MAX - 1;
    check_accepted();
    keys[1].value.x = -1;
    check_refused("light", 0, "centre", FAR);
    track.target = TIA_MOVES_REFERENCE;
    check_accepted();
    keys[1].value.x = 2;
    track.target = TIA_MOVES_EYE;
    scene.camera.eye.x = 1;
    check_accepted();
    light.centre.x = -INT32_MAX + 3;
    check_accepted();
    keys[0].value.x = 3;
    check_refused("light", 0, "centre", FAR);
}

int main(void)
{
    RUN(kinds_of_lights);
    RUN(what_each_kind_of_light_has);
    RUN(attenuation);
    RUN(cones_of_light);
    RUN(directions);
    RUN(corners_of_rectangles);
    RUN(sides_of_rectangles);
    RUN(tracks);
    RUN(values_of_tracks);
    RUN(an_eye_that_moves);
    return check_status();
}
