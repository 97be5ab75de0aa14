/* tia_viewer_run on scenes that move, by the clock and frame by frame, in the world of viewer_world.h: each frame is
 * compared with the scene at the frame's time. */
#include <math.h>

#include <tia/motion.h>

#include "viewer_world.h"

#define DURATION 2 /* s */

static const struct tia_keyframe eye_keys[] = {{0, {0, 0, 0}}, {DURATION * ONE, {ONE, 0, 0}}};
static const struct tia_keyframe light_keys[] = {
    {0, TIA_VEC3(-20, 20, -20)}, {ONE, TIA_VEC3(20, 20, -20)}, {DURATION * ONE, TIA_VEC3(20, 20, 0)}};
static const struct tia_track tracks[] = {{TIA_MOVES_LIGHT, 1, true, light_keys, 3},
                                          {TIA_MOVES_LIGHT, 0, false, light_keys, 3},
                                          {TIA_MOVES_EYE, 0, false, eye_keys, 2}};
static const struct tia_light two_lights[] = {{{0, 0, 0}, TIA_Q16(3), TIA_RGB(1, 1, 1)},
                                              {{0, 0, 0}, TIA_Q16(2), TIA_RGB(0, 0.5, 0)}};

/* Returns the thesis scene with two moving lights and, with `all`, a moving eye. */
static const struct tia_scene *film(bool all)
{
    static struct tia_scene scene;

    scene = tia_thesis_scene;
    scene.lights = two_lights;
    scene.light_count = 2;
    scene.tracks = tracks;
    scene.track_count = all ? 3 : 2;
    return &scene;
}

static const struct tia_scene *scene_at(const struct world *w, tia_q16 time)
{
    static struct tia_scene scene;
    static uint64_t memory[512];

    CHECK(tia_scene_at_size(w->viewer.scene) <= sizeof memory);
    CHECK_EQ(tia_scene_at(&scene, memory, sizeof memory, w->viewer.scene, time, NULL), TIA_OK);
    return &scene;
}

/* Returns the scene's time at a frame by the clock; the clock starts with the first tile of the first frame. */
static tia_q16 time_by_clock(const struct world *w, unsigned frame)
{
    double begin = w->viewer.pacing.time / (double)ONE;
    double elapsed = (double)(w->frames[frame].drawn_us - w->frames[0].drawn_us) / 1e6;

    return w->viewer.pacing.time + (tia_q16)floor(fmod(elapsed, DURATION - begin) * ONE);
}

/* Returns the scene at a frame's time. The viewer's lights are checked separately: here they are its own. */
static const struct tia_scene *scene_by_clock(const struct world *w)
{
    return scene_at(w, time_by_clock(w, w->frame_count));
}

static tia_q16 time_by_rate(const struct world *w, unsigned frame)
{
    return (tia_q16)floor(w->viewer.pacing.time +
                          (double)frame * ONE * w->viewer.pacing.rate[1] / w->viewer.pacing.rate[0] + 0.5);
}

static const struct tia_scene *scene_by_rate(const struct world *w)
{
    return scene_at(w, time_by_rate(w, w->frame_count));
}

static struct world *film_world(bool all)
{
    struct world *w = world_new();

    w->viewer.scene = film(all);
    w->scene_now = scene_by_clock;
    return w;
}

static bool same_place(struct tia_vec3 a, struct tia_vec3 b)
{
    return a.x == b.x && a.y == b.y && a.z == b.z;
}

static void check_lights_by_clock(const struct world *w)
{
    for (unsigned i = 0; i < w->frame_count && i < WORLD_FRAMES; i++)
        CHECK_MSG(same_place(w->frames[i].light, scene_at(w, time_by_clock(w, i))->lights[0].centre), "frame %u", i);
}

/* If drawing takes no time, a frame is due every 16.7 ms, and late by less than 1 ms, the unit of waits. */
TEST(it_plays_by_the_clock_and_again)
{
    struct world *w = film_world(true);

    quit_at(w, START + 5000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count >= 5000000 / 17666 && w->frame_count <= 5000000 / TIA_PLAY_STEP_US + 1);
    for (unsigned i = 1; i < w->frame_count; i++)
        CHECK(w->frames[i].drawn_us - w->frames[i - 1].drawn_us >= TIA_PLAY_STEP_US && !w->frames[i].told.relit);
    check_lights_by_clock(w);
}

/* Slow frames are fewer, but each shows the scene at the time of its drawing. */
TEST(slow_frames_show_their_time)
{
    struct world *w = film_world(true);

    w->tile_us = 20000; /* 3 tiles a frame */
    w->present_us = 40000;
    w->viewer.pacing.time = ONE / 2;
    quit_at(w, START + 4000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 40);
    check_lights_by_clock(w);
}

TEST(where_only_lights_move_hits_stay)
{
    struct world *w = film_world(false);

    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count > 100);
    for (unsigned i = 1; i < w->frame_count; i++)
        CHECK(w->frames[i].told.relit);
    check_lights_by_clock(w);
    CHECK_EQ(w->memory_calls, 2);
}

/* If only the eye moves, the scene at a time needs no memory for moving elements. */
TEST(where_only_the_eye_moves)
{
    struct world *w = film_world(true);
    struct tia_scene scene = *w->viewer.scene;

    scene.tracks = &tracks[2];
    scene.track_count = 1;
    w->viewer.scene = &scene;
    quit_at(w, START + 1000000);
    CHECK_EQ(tia_scene_at_size(&scene), 0);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count > 40);
}

/* Films are drawn frame by frame, independently of the clock, and also without a clock. */
TEST(films_are_stepped)
{
    static const uint32_t rates[][2] = {{4, 1}, {30000, 1001}, {1, 1}, {1000000, 1}, {1, 1000000}};

    for (size_t i = 0; i < 2 * sizeof rates / sizeof *rates; i++) {
        struct world *w = film_world(i % 3);
        memcpy(w->viewer.pacing.rate, rates[i / 2], sizeof w->viewer.pacing.rate);
        w->viewer.pacing.time = i % 2 ? ONE / 3 : 0;
        w->viewer.pacing.frame_limit = i / 2 == 4 ? 1 : 12;
        w->present_us = 77777;
        w->viewer.ports.input = i % 2 ? NULL : &world_input;
        w->viewer.ports.clock = i % 2 ? NULL : &world_clock;
        w->scene_now = scene_by_rate;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, w->viewer.pacing.frame_limit);
        for (unsigned n = 0; n < w->frame_count; n++) {
            bool stays = n > 0 && (i % 3 == 0 || time_by_rate(w, n) == time_by_rate(w, n - 1));
            CHECK(same_place(w->frames[n].light, scene_at(w, time_by_rate(w, n))->lights[0].centre));
            CHECK_EQ(w->frames[n].told.relit, stays);
        }
    }
}

/* Without a clock and without a rate the time does not change. */
TEST(without_a_clock_nothing_moves)
{
    struct world *w = film_world(true);

    w->viewer.ports.clock = NULL;
    w->viewer.pacing.time = ONE;
    w->scene_now = NULL;
    w->viewer.pacing.rate[0] = 0;
    quit_at(w, START + 1000000);
    w->scene_now = scene_by_clock;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK(same_place(w->lights[0].centre, light_keys[1].value));
}

/* After its end a scene does not change, so it is drawn once. */
TEST(after_the_end)
{
    struct world *w = film_world(true);

    w->viewer.pacing.time = DURATION * ONE;
    w->scene_now = NULL;
    w->viewer.scene = film(false);
    quit_at(w, START + 5000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK(same_place(w->lights[0].centre, light_keys[2].value));
}

/* A key stops its light: from the next frame on, the light stays at its place at the time of the key, moved by the key.
 * The other light moves on. */
TEST(a_key_holds_its_light)
{
    struct world *w = film_world(true);
    struct tia_vec3 place;
    unsigned i = 0;

    world_event(w, START + 700000, TIA_EVENT_TAP, TIA_KEY_PAGE_UP);
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    while (w->frames[i].drawn_us < START + 700000)
        i++;
    place = w->frames[i - 1].light;
    place.y += ONE;
    for (; i < w->frame_count; i++)
        CHECK_MSG(same_place(w->frames[i].light, place), "frame %u", i);
    CHECK(same_place(w->lights[1].centre, scene_at(w, time_by_clock(w, w->frame_count - 1))->lights[1].centre));
    CHECK(w->detached[0] && !w->detached[1]);
}

/* Keys to press before the first frame act at the time of that frame. */
TEST(keys_at_the_first_time)
{
    static const uint16_t keys[] = {TIA_KEY_RIGHT};
    struct world *w = film_world(true);

    w->viewer.keys = keys;
    w->viewer.key_count = 1;
    w->viewer.pacing.time = ONE;
    quit_at(w, START + 500000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count > 20);
    CHECK_EQ(w->frames[0].light.x, 21 * ONE);
    CHECK_EQ(w->frames[w->frame_count - 1].light.x, 21 * ONE);
    CHECK_EQ(w->frames[w->frame_count - 1].light.z, -20 * ONE);
}

/* A scene without motion needs no flags for detached lights. */
TEST(a_still_scene_needs_no_flags)
{
    struct world *w = world_new();

    w->viewer.lights.detached = NULL;
    w->viewer.pacing.time = ONE;
    quit_at(w, START + 1000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
}

/* While the screen is hidden the time continues. */
TEST(hidden_while_it_plays)
{
    struct world *w = film_world(true);

    w->hidden_from_us = START + 300000;
    w->hidden_until_us = START + 1300000;
    quit_at(w, START + 1500000);
    CHECK_EQ(world_play(w), TIA_OK);
    check_lights_by_clock(w);
    for (unsigned i = 0; i < w->frame_count; i++)
        CHECK(w->frames[i].drawn_us < START + 300000 || w->frames[i].drawn_us >= START + 1300000);
    CHECK(w->frames[w->frame_count - 1].drawn_us > START + 1400000);
}

/* A new mode replaces the memory of the scene at its time. */
TEST(the_mode_changes_while_it_plays)
{
    for (int all = 0; all < 2; all++) {
        struct world *w = film_world(all);
        w->later_mode = (struct tia_mode){33, 20, 8, 8, false, ""};
        w->change_after = 20;
        quit_at(w, START + 1000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(w->frame_count > 50);
        check_lights_by_clock(w);
    }
}

/* With growing memory: an error, then the frames, always the same. */
TEST(every_amount_of_memory)
{
    int refused = 0, drawn = 0;

    for (size_t limit = 0; limit < 32000; limit += 300) {
        struct world *w = film_world(limit % 600);
        w->memory_limit = limit;
        w->viewer.pacing.frame_limit = 3;
        w->viewer.pacing.rate[0] = w->viewer.pacing.rate[1] = 1;
        w->scene_now = scene_by_rate;
        int status = world_play(w);
        CHECK_MSG(status == (drawn ? TIA_OK : status) && (!status || status == TIA_ERR_MEMORY), "%zu", limit);
        CHECK_EQ(w->frame_count, status ? 0 : 3);
        *(status ? &refused : &drawn) += 1;
    }
    CHECK(refused > 0 && drawn > 0);
}

TEST(what_the_caller_must_keep)
{
    struct world *w = film_world(true);

    w->viewer.lights.detached = NULL;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
    w = film_world(true);
    w->viewer.pacing.time = -1;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
    w = film_world(true);
    w->viewer.pacing.rate[0] = w->viewer.pacing.rate[1] = 1; /* and no frame limit */
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
    w->viewer.pacing.rate[1] = 0;
    w->viewer.pacing.frame_limit = 1;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
    CHECK_EQ(w->frame_count, 0);
}

TEST(frame_times)
{
    static const uint32_t rates[][2] = {{25, 1}, {30000, 1001}, {7, 3}, {1000000, 999999}, {1, 1000000}, {1000000, 1}};

    for (size_t i = 0; i < sizeof rates / sizeof *rates; i++)
        for (unsigned frame = 0; frame < 200; frame++) {
            long double time = 12345 + (long double)frame * ONE * rates[i][1] / rates[i][0];
            CHECK_EQ(tia_viewer_frame_time(12345, frame, rates[i]),
                     time + 0.5L < INT32_MAX ? (intmax_t)floorl(time + 0.5L) : INT32_MAX);
        }
    CHECK_EQ(tia_viewer_frame_time(0, UINT32_MAX, rates[4]), INT32_MAX);
    CHECK_EQ(tia_viewer_frame_time(INT32_MAX, UINT32_MAX, rates[0]), INT32_MAX);
    CHECK_EQ(tia_viewer_frame_time(0, 32767 * 25, rates[0]), 32767 * ONE);
    CHECK_EQ(tia_viewer_frame_time(0, 32768 * 25, rates[0]), INT32_MAX);
}

int main(void)
{
    RUN(it_plays_by_the_clock_and_again);
    RUN(slow_frames_show_their_time);
    RUN(where_only_lights_move_hits_stay);
    RUN(where_only_the_eye_moves);
    RUN(films_are_stepped);
    RUN(without_a_clock_nothing_moves);
    RUN(after_the_end);
    RUN(a_key_holds_its_light);
    RUN(keys_at_the_first_time);
    RUN(a_still_scene_needs_no_flags);
    RUN(hidden_while_it_plays);
    RUN(the_mode_changes_while_it_plays);
    RUN(every_amount_of_memory);
    RUN(what_the_caller_must_keep);
    RUN(frame_times);
    return check_status();
}
