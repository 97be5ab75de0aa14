/* tia_viewer_run: events while a slow frame is drawn. */
#include "viewer_world.h"

static bool always(void *ctx)
{
    ((struct world *)ctx)->stop++;
    return ((struct world *)ctx)->tiles > 0;
}

/* A slow frame of three tiles is not finished after a key that quits, nor after `stop`, in one thread or several. */
TEST(a_frame_that_is_not_wanted)
{
    for (int concurrent = 0; concurrent < 2; concurrent++) {
        struct world *w = lit_world();
        w->mode.concurrent = concurrent;
        w->viewer.job.workers = concurrent ? &w->workers : NULL;
        w->tile_us = 60000;
        quit_at(w, START + 50000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(w->frame_count == 0 && w->tiles == 1);
        CHECK_EQ(w->entered, 0);
        w = lit_world();
        w->tile_us = 60000;
        w->viewer.job.stop = always;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(w->frame_count == 0 && w->tiles == 1);
    }
}

/* The release of a key that was down before the start, for example Return, does not quit. */
TEST(a_key_that_is_let_go)
{
    struct world *w = lit_world();

    w->tile_us = 60000;
    world_event(w, START + 50000, TIA_EVENT_RELEASE, 'q');
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
}

/* Only one thread polls at a time, and the others do not wait for it. */
TEST(one_looks_at_a_time)
{
    struct world *w = lit_world();

    w->viewer.job.workers = &w->workers;
    w->entered = 1;
    w->tile_us = 60000;
    quit_at(w, START + 50000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
}

/* A slow frame that is out of date is not finished. The next frame is, although more keys arrive, and so is a quick
 * frame. */
TEST(a_frame_that_is_out_of_date)
{
    struct world *w = lit_world();

    w->tile_us = 150000;
    for (int i = 0; i < 12; i++)
        world_event(w, START + 40000 + (uint64_t)i * 60000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frames[0].drawn_us, START);
    CHECK_EQ(w->frames[0].light.x, (-20 - 5) * ONE); /* the keys until 300 ms */
    CHECK_EQ(w->frames[w->frame_count - 1].light.x, (-20 - 12) * ONE);
    CHECK(w->frame_count >= 2 && w->frame_count <= 4);
    w = lit_world();
    w->tile_us = 70000;
    world_event(w, START + 40000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->frame_count == 2 && w->frames[0].light.x == -20 * ONE && w->frames[1].light.x == -21 * ONE);
}

/* More keys than the queue holds end the frame, and all of them count, also the release of a held key. */
TEST(many_keys_in_one_frame)
{
    struct world *w = lit_world();

    w->tile_us = 100000;
    for (int i = 0; i < 150; i++)
        world_event(w, START + 1000, TIA_EVENT_TAP, 'a');
    quit_at(w, START + 1000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 0);
    w = lit_world();
    w->tile_us = 70000;
    world_event(w, START + 1000, TIA_EVENT_PRESS, TIA_KEY_LEFT);
    for (int i = 0; i < 150; i++)
        world_event(w, START + 1000, TIA_EVENT_TAP, 'a');
    world_event(w, START + 1000, TIA_EVENT_RELEASE, TIA_KEY_LEFT);
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
}

TEST(an_input_that_fails_while_a_frame_is_drawn)
{
    struct world *w = lit_world();

    w->tile_us = 60000;
    w->fail = CALL_POLL;
    w->fail_from_us = START + 50000;
    CHECK_EQ(world_play(w), TIA_ERR_DEVICE);
    CHECK(w->frame_count == 0 && w->tiles == 1);
}

int main(void)
{
    RUN(a_frame_that_is_not_wanted);
    RUN(a_key_that_is_let_go);
    RUN(one_looks_at_a_time);
    RUN(a_frame_that_is_out_of_date);
    RUN(many_keys_in_one_frame);
    RUN(an_input_that_fails_while_a_frame_is_drawn);
    return check_status();
}
