/* tia_viewer_press: the effect of each key on the lights, by the table of the thesis scene and at the limits. */
#include <math.h>

#include <tia/viewer.h>

#include "check.h"

#define ONE TIA_Q16_ONE
#define EDGE (INT32_MAX - INT32_MAX % ONE) /* the integer 32767 */

static struct tia_light lights[4];
static uint32_t count;

static int press(uint32_t capacity, uint16_t key)
{
    return tia_viewer_press(&tia_thesis_scene, lights, &count, capacity, key);
}

static struct tia_light light_at(tia_q16 x, tia_q16 y, tia_q16 z, tia_q16 radius)
{
    return (struct tia_light){{x, y, z}, radius, {1, 2, 3}};
}

static bool is_at(const struct tia_light *light, tia_q16 x, tia_q16 y, tia_q16 z)
{
    return light->centre.x == x && light->centre.y == y && light->centre.z == z;
}

static void check_put(uint16_t key, int x, int y, int z)
{
    const struct tia_light *l = &lights[0];

    for (count = 0; count < 2; count++) { /* once as the first light, once in place of an existing one */
        lights[0] = light_at(7, 7, 7, 7777);
        CHECK_EQ(press(1, key), 1);
        CHECK_MSG(count == 1 && is_at(l, x * ONE, y * ONE, z * ONE), "%c", key);
        CHECK_EQ(l->radius, 3 * ONE);
        CHECK(l->emission.r == TIA_Q30_ONE && l->emission.g == TIA_Q30_ONE && l->emission.b == TIA_Q30_ONE);
    }
}

TEST(keys_that_put_the_light)
{
    check_put('a', -20, 20, -20);
    check_put('d', 20, 20, -20);
    check_put('s', 0, 20, -8);
    check_put('w', 0, 20, -32);
}

static const struct {
    uint16_t key;
    int x, y, z;
} moves[] = {
    {TIA_KEY_LEFT, -1, 0, 0}, {TIA_KEY_RIGHT, 1, 0, 0},   {TIA_KEY_UP, 0, 0, -1},
    {TIA_KEY_DOWN, 0, 0, 1},  {TIA_KEY_PAGE_UP, 0, 1, 0}, {TIA_KEY_PAGE_DOWN, 0, -1, 0},
};
#define MOVES (sizeof moves / sizeof *moves)

TEST(keys_that_move_the_light)
{
    for (size_t i = 0; i < MOVES; i++) {
        lights[0] = lights[1] = light_at(100, -200, 300, 3 * ONE);
        count = 2;
        CHECK_EQ(press(2, moves[i].key), 1);
        CHECK_MSG(is_at(&lights[0], 100 + moves[i].x * ONE, -200 + moves[i].y * ONE, 300 + moves[i].z * ONE), "key %zu",
                  i);
        CHECK_EQ(lights[0].radius, 3 * ONE);
        CHECK_EQ(lights[0].emission.b, 3);
        CHECK(is_at(&lights[1], 100, -200, 300));
        CHECK_EQ(count, 2);
    }
}

TEST(without_a_light_there_is_nothing_to_move)
{
    for (size_t i = 0; i < MOVES; i++) {
        lights[0] = light_at(1, 2, 3, 0);
        count = 0;
        CHECK_EQ(press(4, moves[i].key), 0);
        CHECK(count == 0 && is_at(&lights[0], 1, 2, 3));
    }
}

TEST(every_other_key_quits)
{
    for (unsigned key = 0; key <= UINT16_MAX; key++) {
        bool known = key == 'a' || key == 'd' || key == 's' || key == 'w';
        for (size_t i = 0; i < MOVES; i++)
            known = known || key == moves[i].key;
        count = 0;
        CHECK_MSG((press(1, (uint16_t)key) == TIA_ERR_ARGUMENT) == !known, "key %u", key);
    }
}

TEST(no_room_for_a_light)
{
    lights[0] = light_at(1, 2, 3, 0);
    count = 0;
    CHECK_EQ(press(0, 'a'), 0);
    CHECK_EQ(press(0, TIA_KEY_LEFT), 0);
    CHECK_EQ(press(0, 'q'), TIA_ERR_ARGUMENT);
    CHECK(count == 0 && is_at(&lights[0], 1, 2, 3));
}

/* Checks that `last` is the last integer coordinate that a light of this radius can reach: its farthest point stays
 * nearer than 32768. Without a radius that is 32767; with radius 3, where the limit is 32764.99..., 32764. */
static void check_limit(tia_q16 radius, tia_q16 last)
{
    for (size_t i = 0; i < MOVES; i++) {
        tia_q16 x = moves[i].x * last, y = moves[i].y * last, z = moves[i].z * last;
        lights[0] = light_at(x - moves[i].x * ONE, y - moves[i].y * ONE, z - moves[i].z * ONE, radius);
        count = 1;
        CHECK_EQ(press(1, moves[i].key), 1);
        CHECK(is_at(&lights[0], x, y, z));
        CHECK_EQ(press(1, moves[i].key), 0);
        CHECK(is_at(&lights[0], x, y, z));
    }
}

TEST(no_move_beyond_the_range)
{
    check_limit(0, EDGE);
    check_limit(3 * ONE, EDGE - 3 * ONE);
}

/* Q16.16 ends at 32768, where it would wrap to -32768; seen from an eye at -1/2 both 32767 + 1/5 and
 * what that wraps to after one step lie in the range. The same on the left. */
TEST(no_move_beyond_the_numbers)
{
    struct tia_scene scene = {.camera = {{-ONE / 2, 0, 0}, TIA_Q16(25)}};
    tia_q16 most = EDGE + ONE / 5;

    lights[0] = light_at(most, 0, 0, 0);
    count = 1;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_RIGHT), 0);
    CHECK_EQ(lights[0].centre.x, most);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_LEFT), 1);
    CHECK_EQ(lights[0].centre.x, most - ONE);
    scene.camera.eye.x = ONE / 2;
    lights[0].centre.x = -most;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_LEFT), 0);
    CHECK_EQ(lights[0].centre.x, -most);
}

/* A step is one unit of the scene's file. */
TEST(steps_in_the_units_of_the_file)
{
    struct tia_scene scene = {.camera = {{0, 0, 0}, TIA_Q16(25)}, .scale_bits = 3};

    lights[0] = light_at(ONE, 2 * ONE, 3 * ONE, 0);
    count = 1;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_RIGHT), 1);
    CHECK(is_at(&lights[0], 9 * ONE, 2 * ONE, 3 * ONE));
    scene.scale_bits = 15;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_RIGHT), 0);
    CHECK(is_at(&lights[0], 9 * ONE, 2 * ONE, 3 * ONE));
}

static const struct tia_binding bindings[] = {
    {'0', 0, {{10, 0, 0}, 0, {0, 0, 0}}},
    {'2', 2, {{12, 0, 0}, 0, {0, 0, 0}}},
    {'3', 3, {{13, 0, 0}, 0, {0, 0, 0}}},
    {TIA_KEY_LEFT, 1, {{11, 0, 0}, 0, {0, 0, 0}}},
};

/* A light with a number beyond those in use is added at the end; where all are in use nothing changes. */
TEST(several_lights)
{
    struct tia_scene scene = {.bindings = bindings, .binding_count = 4, .camera = {{0, 0, 0}, TIA_Q16(25)}};

    count = 0;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, '2'), 1);
    CHECK(count == 1 && lights[0].centre.x == 12);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, '0'), 1);
    CHECK(count == 1 && lights[0].centre.x == 10);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, TIA_KEY_LEFT), 1); /* a binding takes precedence over a move */
    CHECK(count == 2 && lights[0].centre.x == 10 && lights[1].centre.x == 11);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, '3'), 1);
    CHECK(count == 3 && lights[2].centre.x == 13);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, '2'), 1);
    CHECK(count == 3 && lights[2].centre.x == 12);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 3, '3'), 0);
    CHECK(count == 3 && lights[2].centre.x == 12);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 4, TIA_KEY_RIGHT), 1);
    CHECK(lights[0].centre.x == 10 + ONE && lights[1].centre.x == 11);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 4, 'a'), TIA_ERR_ARGUMENT);
}

/* Ambient lights, which have no position, are skipped. */
TEST(the_first_light_that_has_a_place)
{
    struct tia_scene scene = {.camera = {{0, 0, 0}, TIA_Q16(25)}};

    for (uint32_t ambient = 0; ambient < 4; ambient++) {
        for (uint32_t i = 0; i < 4; i++) {
            lights[i] = light_at(ONE, 2 * ONE, 3 * ONE, 0);
            lights[i].kind = i < ambient ? TIA_AMBIENT_LIGHT : i % 2 ? TIA_SPOT_LIGHT : TIA_RECTANGLE_LIGHT;
            lights[i].outer = TIA_Q16(30);
            lights[i].side[0].x = lights[i].side[1].z = ONE;
            lights[i].direction.y = -TIA_Q30_ONE;
        }
        count = 4;
        CHECK_EQ(tia_viewer_key_light(&scene, lights, count, TIA_KEY_UP), ambient);
        CHECK_EQ(tia_viewer_press(&scene, lights, &count, 4, TIA_KEY_UP), 1);
        for (uint32_t i = 0; i < 4; i++)
            CHECK(is_at(&lights[i], ONE, 2 * ONE, (i == ambient ? 2 : 3) * ONE));
        count = ambient; /* all lights are ambient */
        CHECK_EQ(tia_viewer_key_light(&scene, lights, count, TIA_KEY_UP), TIA_NO_LIGHT);
        CHECK_EQ(tia_viewer_press(&scene, lights, &count, 4, TIA_KEY_UP), 0);
    }
}

TEST(which_light_a_key_puts)
{
    struct tia_scene scene = {.bindings = bindings, .binding_count = 4, .camera = {{0, 0, 0}, TIA_Q16(25)}};

    CHECK_EQ(tia_viewer_key_light(&scene, lights, 0, '2'), 0);
    CHECK_EQ(tia_viewer_key_light(&scene, lights, 2, '2'), 2);
    CHECK_EQ(tia_viewer_key_light(&scene, lights, 4, '2'), 2);
    CHECK_EQ(tia_viewer_key_light(&scene, lights, 4, TIA_KEY_LEFT), 1);
    CHECK_EQ(tia_viewer_key_light(&scene, lights, 4, 'q'), TIA_NO_LIGHT);
}

/* Checks a turn. The light comes from -direction: the point there, at the distance 1, moves by 1/16. */
static void check_turn(const double from[3], size_t move)
{
    struct tia_scene scene = {.camera = {{0, 0, 0}, TIA_Q16(25)}};
    double to[3] = {from[0] - moves[move].x / 16.0, from[1] - moves[move].y / 16.0, from[2] - moves[move].z / 16.0};
    double length = sqrt(to[0] * to[0] + to[1] * to[1] + to[2] * to[2]), got[3];

    lights[0] = light_at(5, 6, 7, 0);
    lights[0].kind = TIA_DIRECTIONAL_LIGHT;
    lights[0].direction = (struct tia_dir3){TIA_Q30(from[0]), TIA_Q30(from[1]), TIA_Q30(from[2])};
    count = 1;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, moves[move].key), 1);
    got[0] = lights[0].direction.x / (double)TIA_Q30_ONE;
    got[1] = lights[0].direction.y / (double)TIA_Q30_ONE;
    got[2] = lights[0].direction.z / (double)TIA_Q30_ONE;
    for (int i = 0; i < 3; i++)
        CHECK_MSG(fabs(got[i] - to[i] / length) < 1e-8, "key %zu: %.9f, not %.9f", move, got[i], to[i] / length);
    CHECK(is_at(&lights[0], 5, 6, 7));
}

TEST(a_directional_light_turns)
{
    static const double from[][3] = {
        {0, -1, 0.01}, {0.6, -0.8, 0.001}, {-0.48, 0.64, 0.6}, {0.57735, 0.57735, -0.57735}};

    for (size_t i = 0; i < sizeof from / sizeof *from; i++) {
        double length = sqrt(from[i][0] * from[i][0] + from[i][1] * from[i][1] + from[i][2] * from[i][2]);
        double unit[3] = {from[i][0] / length, from[i][1] / length, from[i][2] / length};
        for (size_t move = 0; move < MOVES; move++)
            check_turn(unit, move);
    }
}

/* A light from straight above cannot move further up, and returns there from elsewhere. */
TEST(a_directional_light_at_its_end)
{
    struct tia_scene scene = {.camera = {{0, 0, 0}, TIA_Q16(25)}};

    lights[0] = (struct tia_light){.kind = TIA_DIRECTIONAL_LIGHT, .direction = {0, -TIA_Q30_ONE, 0}};
    count = 1;
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_PAGE_UP), 0);
    CHECK_EQ(lights[0].direction.y, -TIA_Q30_ONE);
    CHECK_EQ(tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_LEFT), 1);
    CHECK(lights[0].direction.x > 0); /* the light comes from the left */
    for (unsigned i = 0; i < 1000; i++)
        (void)tia_viewer_press(&scene, lights, &count, 1, TIA_KEY_PAGE_UP);
    CHECK(lights[0].direction.x >= 0 && lights[0].direction.x < 1000);
}

int main(void)
{
    RUN(keys_that_put_the_light);
    RUN(keys_that_move_the_light);
    RUN(without_a_light_there_is_nothing_to_move);
    RUN(every_other_key_quits);
    RUN(no_room_for_a_light);
    RUN(no_move_beyond_the_range);
    RUN(no_move_beyond_the_numbers);
    RUN(steps_in_the_units_of_the_file);
    RUN(several_lights);
    RUN(the_first_light_that_has_a_place);
    RUN(which_light_a_key_puts);
    RUN(a_directional_light_turns);
    RUN(a_directional_light_at_its_end);
    return check_status();
}
