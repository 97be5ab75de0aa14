/* tia_viewer_run: memory, modes, workers and errors, in the same world as test_viewer.c. */
#include "viewer_world.h"

static void tap(struct world *w, uint64_t after_us, uint16_t key)
{
    world_event(w, START + after_us, TIA_EVENT_TAP, key);
}

/* Returns a world of three frames; the last two are relit if memory suffices for the hits of a whole frame. */
static struct world *moving_world(void)
{
    struct world *w = world_new();

    tap(w, 1000, 'd');
    tap(w, 2000, TIA_KEY_LEFT);
    tap(w, 3000, 'q');
    return w;
}

static void check_three_frames(const struct world *w, bool relit)
{
    CHECK_EQ(w->frame_count, 3);
    for (unsigned i = 0; i < 3; i++)
        CHECK_EQ(w->frames[i].told.relit, relit && i > 0);
}

TEST(frames_are_relit)
{
    struct world *w = moving_world();

    CHECK_EQ(world_play(w), TIA_OK);
    check_three_frames(w, true);
    CHECK_EQ(w->memory_calls, 1);
}

TEST(other_cores_and_options)
{
    struct world *w = moving_world();

    w->viewer.core = &tia_core_q16;
    w->viewer.dither = true;
    CHECK_EQ(world_play(w), TIA_OK);
    check_three_frames(w, true);
}

TEST(tiles_as_the_display_takes_them)
{
    static const struct tia_mode modes[] = {
        {WORLD_WIDTH, WORLD_HEIGHT, 7, 5, false, ""},  {WORLD_WIDTH, WORLD_HEIGHT, 1, 1, false, ""},
        {WORLD_WIDTH, WORLD_HEIGHT, 0, 1, false, ""},  {WORLD_WIDTH, WORLD_HEIGHT, 1, 0, false, ""},
        {WORLD_WIDTH, WORLD_HEIGHT, 99, 99, true, ""}, {WORLD_WIDTH - 1, 1, 8, 8, false, ""},
        {1, WORLD_HEIGHT - 1, 0, 40, false, ""},       {1, 1, 0, 0, false, ""},
    };

    for (size_t i = 0; i < sizeof modes / sizeof *modes; i++) {
        struct world *w = moving_world();
        w->mode = modes[i];
        CHECK_EQ(world_play(w), TIA_OK);
        check_three_frames(w, true);
    }
}

/* With growing memory: an error, then hits of a tile, then hits of a whole frame; never different pixels. */
TEST(every_amount_of_memory)
{
    int refused = 0, tiles = 0, whole = 0;

    for (size_t limit = 0; limit < 30000; limit += 52) {
        struct world *w = moving_world();
        w->memory_limit = limit;
        int status = world_play(w);
        CHECK_MSG(w->memory_size <= limit, "%zu bytes taken of %zu", w->memory_size, limit);
        if (status == TIA_ERR_MEMORY) {
            CHECK(w->frame_count == 0 && !tiles && !whole);
            refused++;
            continue;
        }
        CHECK_EQ(status, TIA_OK);
        check_three_frames(w, w->frames[1].told.relit);
        CHECK(w->frames[1].told.relit || !whole);
        *(w->frames[1].told.relit ? &whole : &tiles) += 1;
    }
    CHECK(refused > 0 && tiles > 0 && whole > 0);
}

TEST(no_memory_at_all)
{
    struct world *w = moving_world();

    w->memory_limit = 0;
    CHECK_EQ(world_play(w), TIA_ERR_MEMORY);
    CHECK(w->frame_count == 0 && w->acquired == 0);
}

/* A smaller or larger window, or other tiles, cause new tracing, in newly requested memory. */
TEST(the_mode_changes)
{
    const struct tia_mode all = {WORLD_WIDTH, WORLD_HEIGHT, 0, 0, false, ""}, small = {33, 20, 0, 0, false, ""},
                          tiled = {WORLD_WIDTH, WORLD_HEIGHT, 9, 9, false, ""};
    const struct tia_mode pairs[][2] = {{all, small}, {small, all}, {all, tiled}};

    for (size_t i = 0; i < 3; i++) {
        struct world *w = world_new();
        w->mode = pairs[i][0];
        w->later_mode = pairs[i][1];
        w->change_after = 2;
        w->viewer.pacing.frame_limit = 4;
        tap(w, 0, 'a');
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 4);
        CHECK(w->frames[1].told.relit && !w->frames[2].told.relit && w->frames[3].told.relit);
        CHECK_EQ(w->memory_calls, 2);
    }
}

/* A new mode causes a frame even when nothing else changes; the same mode does not. */
TEST(a_new_mode_is_drawn)
{
    struct world *w = world_new();

    w->later_mode = w->mode;
    w->later_mode.width = 10;
    w->change_after = 1;
    tap(w, 1000, 'n');
    w->events[0].event.kind = TIA_EVENT_RELEASE; /* wakes the loop, but has no effect */
    tap(w, 2000, 'n');
    w->events[1].event.kind = TIA_EVENT_RELEASE;
    tap(w, 3000, 'q');
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
}

TEST(workers_draw_where_the_display_lets_them)
{
    struct world *w = moving_world();

    w->viewer.job.workers = &w->workers;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->runs, 0); /* tiles are drawn one at a time */
    w = moving_world();
    w->viewer.job.workers = &w->workers;
    w->mode.concurrent = true;
    CHECK_EQ(world_play(w), TIA_OK);
    check_three_frames(w, true);
    CHECK_EQ(w->runs, 3);
    w = moving_world();
    w->viewer.job.workers = &w->workers;
    w->mode.concurrent = true;
    w->memory_limit = 20000; /* enough for the hits of one tile, and so for one thread */
    CHECK_EQ(world_play(w), TIA_OK);
    check_three_frames(w, false);
    CHECK_EQ(w->runs, 0);
}

/* A port's error ends the loop and is passed on; a frame that failed is not shown. */
TEST(errors_of_ports)
{
    for (int concurrent = 0; concurrent < 2; concurrent++)
        for (int call = CALL_MODE; call <= CALL_WAIT; call++)
            for (unsigned after = 0; after < 3; after++) {
                struct world *w = moving_world();
                w->viewer.job.workers = concurrent ? &w->workers : NULL;
                w->mode.concurrent = concurrent;
                w->fail = (enum world_call)call;
                w->fail_after = after;
                CHECK_EQ(world_play(w), TIA_ERR_DEVICE);
                CHECK_EQ(w->frame_count, after + (call == CALL_WAIT && after == 0));
            }
}

TEST(errors_of_the_caller)
{
    struct tia_scene scene = tia_thesis_scene;
    struct world *w = world_new();

    w->viewer.ports.input = NULL;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
    w = world_new();
    scene.camera.fov = 0;
    w->viewer.scene = &scene;
    CHECK_EQ(world_play(w), TIA_ERR_RANGE);
    CHECK_EQ(w->frame_count, 0);
}

/* ---- displays that take long to show a frame ---- */

TEST(what_takes_long_is_shown_to_its_end)
{
    struct world *w = moving_world();

    w->slices = 5;
    w->events[2].at_us = START + 5000000; /* q */
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->slices_left, 0);
    CHECK(w->frame_count >= 2 && w->slices_done == 5 * w->frame_count);
}

TEST(without_an_input_too)
{
    struct world *w = world_new();

    w->slices = 3;
    w->viewer.ports.input = NULL;
    w->viewer.pacing.frame_limit = 4;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 4);
    CHECK_EQ(w->slices_done, 12);
}

/* Keys are polled every 20 ms while a frame is shown. */
TEST(a_key_quits_while_a_frame_is_shown)
{
    struct world *w = world_new();

    w->slices = 1000;
    tap(w, 100000, 'q');
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->now_us <= START + 100000 + 2 * 20000);
}

/* A key that quits counts, too, when more keys wait than the queue has room for. */
TEST(a_key_quits_after_others_that_wait)
{
    struct world *w = world_new();

    w->slices = 1000;
    tap(w, 100000, 'd');
    for (unsigned i = 0; i < 40; i++)
        tap(w, 200000, i % 2 ? TIA_KEY_LEFT : TIA_KEY_RIGHT);
    tap(w, 3000000, 'q');
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count >= 1 && w->now_us <= START + 3000000 + 3 * 20000);
}

TEST(a_failed_input_ends_it_while_a_frame_is_shown)
{
    struct world *w = world_new();

    w->slices = 1000;
    w->fail = CALL_POLL;
    w->fail_from_us = START + 100000;
    CHECK_EQ(world_play(w), TIA_ERR_DEVICE);
    CHECK(w->now_us <= START + 100000 + 2 * 20000);
}

/* The last frame is shown again after another program's picture was on the screen, as after a stop. */
TEST(the_last_frame_is_shown_again)
{
    struct world *w = world_new();

    w->slices = 7;
    w->again_us = START + 1000000;
    world_event(w, START + 1500000, TIA_EVENT_RELEASE, 'x'); /* wakes the loop */
    tap(w, 3000000, 'q');
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(w->slices_done, 14);
}

int main(void)
{
    RUN(what_takes_long_is_shown_to_its_end);
    RUN(without_an_input_too);
    RUN(a_key_quits_while_a_frame_is_shown);
    RUN(a_key_quits_after_others_that_wait);
    RUN(a_failed_input_ends_it_while_a_frame_is_shown);
    RUN(the_last_frame_is_shown_again);
    RUN(frames_are_relit);
    RUN(other_cores_and_options);
    RUN(tiles_as_the_display_takes_them);
    RUN(every_amount_of_memory);
    RUN(no_memory_at_all);
    RUN(the_mode_changes);
    RUN(a_new_mode_is_drawn);
    RUN(workers_draw_where_the_display_lets_them);
    RUN(errors_of_ports);
    RUN(errors_of_the_caller);
    return check_status();
}
