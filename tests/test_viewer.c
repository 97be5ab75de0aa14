/* tia_viewer_run: keys, time and frames, in a simulated world where time passes only by the script. */
#include "viewer_world.h"

static void tia_check_light(const struct world *w, int x, int y, int z)
{
    const struct tia_vec3 *c = &w->lights[0].centre;

    CHECK_MSG(c->x == x * ONE && c->y == y * ONE && c->z == z * ONE, "the light is at (%d, %d, %d) / 65536", c->x, c->y,
              c->z);
}

TEST(keys_before_the_first_frame)
{
    static const uint16_t keys[] = {TIA_KEY_LEFT, 'd', TIA_KEY_LEFT, TIA_KEY_UP, TIA_KEY_UP, TIA_KEY_PAGE_DOWN};
    struct world *w = world_new();

    w->viewer.keys = keys;
    w->viewer.key_count = 6;
    quit_at(w, START + 1);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    tia_check_light(w, 19, 19, -22);
    CHECK_EQ(w->lights[1].radius, 0);
}

TEST(the_scene_brings_its_lights)
{
    static const struct tia_light lights[] = {{TIA_VEC3(9, 8, 7), TIA_Q16(2), TIA_RGB(1, 0, 1)},
                                              {TIA_VEC3(-9, 8, 7), TIA_Q16(1), TIA_RGB(0, 1, 0)}};
    struct tia_scene scene = tia_thesis_scene;
    struct world *w = world_new();

    scene.lights = lights;
    scene.light_count = 2;
    w->viewer.scene = &scene;
    quit_at(w, START + 1);
    CHECK_EQ(world_play(w), TIA_OK);
    tia_check_light(w, 9, 8, 7);
    CHECK(!memcmp(&w->lights[1], &lights[1], sizeof lights[1]));
    w = world_new();
    w->viewer.scene = &scene;
    w->viewer.lights.capacity = 1;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
}

/* One frame follows 60 waiting taps, and its latency is that of the oldest tap. */
TEST(all_waiting_keys_before_a_frame)
{
    struct world *w = lit_world();

    w->present_us = 5000;
    for (unsigned i = 0; i < 60; i++)
        world_event(w, START - 600 + i, TIA_EVENT_TAP, i % 3 ? TIA_KEY_RIGHT : TIA_KEY_DOWN);
    quit_at(w, START + 50000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    tia_check_light(w, 20, 20, 0);
    CHECK_EQ(w->frames[0].told.key_us, 5600);
}

/* No frame is drawn for a key that changes nothing, nor after one that quits. */
TEST(frames_only_for_changes)
{
    struct world *w = world_new();

    world_event(w, START + 1000, TIA_EVENT_TAP, TIA_KEY_LEFT); /* without effect: the scene has no light yet */
    world_event(w, START + 2000, TIA_EVENT_TAP, 's');
    world_event(w, START + 3000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 3000);
    world_event(w, START + 3000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
    CHECK_EQ(w->next_event, 4);
    tia_check_light(w, -1, 20, -8);
    CHECK_EQ(w->frames[1].light.x, 0);
}

TEST(a_tap_moves_once)
{
    struct world *w = lit_world();

    world_event(w, START + 1000, TIA_EVENT_TAP, TIA_KEY_PAGE_UP);
    quit_at(w, START + 5000000);
    CHECK_EQ(world_play(w), TIA_OK);
    tia_check_light(w, -20, 21, -20);
    CHECK_EQ(w->frame_count, 2);
}

/* Returns the number of moves of the light by a key that has been held for `held` microseconds. */
static int steps(uint64_t held)
{
    return held < TIA_HOLD_DELAY_US ? 1 : 2 + (int)((held - TIA_HOLD_DELAY_US) / TIA_HOLD_STEP_US);
}

/* Checks that each frame while a key is held shows the light moved for the time since the viewer received the key,
 * which is after the frame drawn at that time; and that no frame moves the light after the release. */
static const struct world *check_held(uint64_t tile_us, uint64_t present_us)
{
    const uint64_t frame_us = 3 * tile_us + present_us;
    const uint64_t pressed = START + (frame_us > 10000 ? frame_us : 10000), released = pressed + 1234567;
    struct world *w = lit_world();

    w->tile_us = tile_us;
    w->present_us = present_us;
    world_event(w, START + 10000, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
    world_event(w, released, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
    quit_at(w, released + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    for (unsigned i = 1; i < w->frame_count; i++) {
        uint64_t drawn = w->frames[i].drawn_us;
        if (drawn < released)
            CHECK_EQ(w->frames[i].light.x, (steps(drawn - pressed) - 20) * ONE);
    }
    CHECK_EQ(w->frames[w->frame_count - 1].light.x, w->lights[0].centre.x);
    CHECK(w->lights[0].centre.x <= (steps(released - pressed) - 20) * ONE);
    CHECK(w->frames[w->frame_count - 1].drawn_us <= released + frame_us);
    return w;
}

/* If drawing takes no time, each step is a frame, late by less than 1 ms, the unit of waits. */
TEST(a_held_key_moves_by_the_clock)
{
    const struct world *w = check_held(0, 0);

    for (unsigned i = 1; i < w->frame_count; i++) {
        uint64_t due = START + 10000 + (i > 1 ? TIA_HOLD_DELAY_US + (i - 2) * TIA_HOLD_STEP_US : 0);
        CHECK(w->frames[i].drawn_us >= due && w->frames[i].drawn_us < due + 1000);
    }
    CHECK_EQ(w->frame_count, 1 + steps(1234567));
    tia_check_light(w, steps(1234567) - 20, 20, -20);
}

TEST(slow_frames_do_not_slow_the_light)
{
    (void)check_held(1000, 20000);
    (void)check_held(20000, 30000);
}

/* In frames of 170 ms and of a second a held key moves five and thirty steps, but each frame shows only three more, and
 * none follows the frame that is being drawn at the release. */
TEST(slower_frames_are_no_jumps)
{
    for (uint64_t present = 50000; present < 1000000; present += 830000) {
        const uint64_t frame_us = 3 * 40000 + present, released = START + 7 * frame_us + 1;
        struct world *w = lit_world();
        w->tile_us = 40000;
        w->present_us = present;
        world_event(w, START + 10000, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
        world_event(w, released, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
        quit_at(w, released + 9000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(w->frame_count >= 6);
        for (unsigned i = 3; i < w->frame_count; i++)
            CHECK_EQ(w->frames[i].light.x - w->frames[i - 1].light.x, 3 * ONE);
        CHECK(w->frames[w->frame_count - 1].drawn_us <= released + frame_us);
        CHECK_EQ(w->frames[w->frame_count - 1].light.x, w->lights[0].centre.x);
    }
}

TEST(a_long_pause_is_no_jump)
{
    struct world *w = lit_world();

    w->present_us = 3000000;
    world_event(w, START, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
    world_event(w, START + 3000001, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->lights[0].centre.x <= (-19 + TIA_HOLD_STEPS) * ONE);
}

TEST(released_at_once)
{
    struct world *w = lit_world();

    world_event(w, START + 1, TIA_EVENT_PRESS, TIA_KEY_UP);
    world_event(w, START + TIA_HOLD_DELAY_US, TIA_EVENT_RELEASE, TIA_KEY_UP);
    quit_at(w, START + 2000000);
    CHECK_EQ(world_play(w), TIA_OK);
    tia_check_light(w, -20, 20, -21);
}

TEST(two_keys_held)
{
    const uint64_t right = START + 7000, up = right + 400000, end = START + 1500000;
    struct world *w = lit_world();

    world_event(w, right, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
    world_event(w, up, TIA_EVENT_PRESS, TIA_KEY_UP);
    world_event(w, up + 500000, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
    quit_at(w, end);
    CHECK_EQ(world_play(w), TIA_OK);
    tia_check_light(w, steps(up + 500000 - right) - 20, 20, -20 - steps(end - up));
}

TEST(without_a_clock_nothing_repeats)
{
    struct world *w = lit_world();

    w->viewer.ports.clock = NULL;
    world_event(w, START + 1, TIA_EVENT_PRESS, TIA_KEY_UP);
    quit_at(w, START + 5000000);
    CHECK_EQ(world_play(w), TIA_OK);
    tia_check_light(w, -20, 20, -21);
    CHECK_EQ(w->frames[1].told.key_us, 0);
}

TEST(keys_that_quit)
{
    static const uint16_t keys[] = {TIA_KEY_INTERRUPT, TIA_KEY_ESCAPE, TIA_KEY_OTHER, 'q', 'A', ' ', '1'};

    for (size_t i = 0; i < 2 * sizeof keys / sizeof *keys; i++) {
        struct world *w = world_new();
        world_event(w, START + 1, TIA_EVENT_RELEASE, keys[i / 2]); /* pressed before the loop began */
        world_event(w, START + 500, i % 2 ? TIA_EVENT_PRESS : TIA_EVENT_TAP, keys[i / 2]);
        world_event(w, START + 900, TIA_EVENT_TAP, 'a');
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(w->next_event == 2 && w->now_us == START + 500 && w->frame_count == 1);
        w = world_new();
        w->viewer.keys = &keys[i / 2];
        w->viewer.key_count = 1;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 0);
    }
}

/* Frames follow one another, each with its time: 3 tiles of 16 rows and a wait for the display. */
TEST(as_many_frames_as_asked_for)
{
    for (int with_input = 0; with_input < 2; with_input++) {
        struct world *w = world_new();
        w->viewer.ports.input = with_input ? &world_input : NULL;
        w->viewer.pacing.frame_limit = 5;
        w->tile_us = 300;
        w->present_us = 7000;
        if (with_input)
            world_event(w, START - 40, TIA_EVENT_TAP, 'w');
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 5);
        for (unsigned i = 0; i < 5; i++) {
            CHECK_EQ(w->frames[i].told.relit, i > 0);
            CHECK_EQ(w->frames[i].told.draw_us, 900);
            CHECK_EQ(w->frames[i].told.key_us, with_input && i == 0 ? 7940 : 0);
        }
    }
}

TEST(frame_done_may_end_it)
{
    struct world *w = world_new();

    w->done_status = 77;
    CHECK_EQ(world_play(w), 77);
    CHECK_EQ(w->frame_count, 1);
    w = world_new();
    w->viewer.hooks.frame_done = NULL;
    quit_at(w, START + 1);
    CHECK_EQ(world_play(w), TIA_OK);
}

TEST(the_stop_flag)
{
    struct world *w = world_new();

    w->stop_after = 3;
    w->viewer.pacing.frame_limit = 100;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 3);
    w = world_new();
    w->stop = 1;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 0);
}

/* Keys can move lights while the screen is hidden. When the screen is visible again, the frame is drawn, moved or not.
 */
TEST(hidden)
{
    for (int moved = 0; moved < 2; moved++) {
        struct world *w = lit_world();
        w->hidden_from_us = START + 100000;
        w->hidden_until_us = START + 900000;
        if (moved)
            world_event(w, START + 300000, TIA_EVENT_TAP, TIA_KEY_LEFT);
        quit_at(w, START + 1000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 2);
        CHECK_EQ(w->frames[1].drawn_us, START + 900000);
        CHECK_EQ(w->frames[1].light.x, (-20 - moved) * ONE);
    }
}

TEST(hidden_from_the_start)
{
    struct world *w = world_new();

    w->hidden_from_us = 0;
    w->hidden_until_us = START + 500;
    quit_at(w, START + 1000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count == 1 && w->frames[0].drawn_us == START + 500);
    w = world_new();
    w->hidden_until_us = UINT64_MAX;
    w->viewer.ports.input = NULL; /* without an input, the screen's return cannot be noticed */
    w->viewer.pacing.frame_limit = 1;
    CHECK_EQ(world_play(w), TIA_HIDDEN);
    CHECK_EQ(w->frame_count, 0);
}

int main(void)
{
    RUN(keys_before_the_first_frame);
    RUN(the_scene_brings_its_lights);
    RUN(all_waiting_keys_before_a_frame);
    RUN(frames_only_for_changes);
    RUN(a_tap_moves_once);
    RUN(a_held_key_moves_by_the_clock);
    RUN(slow_frames_do_not_slow_the_light);
    RUN(slower_frames_are_no_jumps);
    RUN(a_long_pause_is_no_jump);
    RUN(released_at_once);
    RUN(two_keys_held);
    RUN(without_a_clock_nothing_repeats);
    RUN(keys_that_quit);
    RUN(as_many_frames_as_asked_for);
    RUN(frame_done_may_end_it);
    RUN(the_stop_flag);
    RUN(hidden);
    RUN(hidden_from_the_start);
    return check_status();
}
