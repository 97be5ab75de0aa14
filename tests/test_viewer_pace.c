/* tia_viewer_run: frames of a moving picture at a target rate. Time passes here only while pixels are lit, 10 us for
 * each: passes of 12, 36, 144, 576 and 2304 pixels take 0.12, 0.36, 1.44, 5.76 and 23.04 ms, a frame 30.72 ms. */
#include <tia/motion.h>

#include "viewer_world.h"

enum { PIXEL_US = 10, SHOWN = 400 };

static struct {
    struct world *world;
    struct tia_core core;
    struct tia_drawing drawing;
    struct tia_frame told[SHOWN];
    uint64_t at_us[SHOWN];
    unsigned count;
    tia_rgb565 pixels[WORLD_WIDTH * WORLD_HEIGHT], full[WORLD_WIDTH * WORLD_HEIGHT];
} now;

static int slow_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    now.world->now_us += (uint64_t)PIXEL_US * tile.width * tile.height;
    return tia_drawing.light(view, hits, tile, surface, options);
}

static int slow_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    int status = tia_drawing.trace(view, hits, tile);

    return status ? status : slow_light(view, hits, tile, surface, options);
}

static void keep(struct world *w, const tia_rgb565 *want)
{
    memcpy(now.pixels, w->pixels, sizeof now.pixels);
    memcpy(now.full, want, sizeof now.full);
}

static int done(void *ctx, const struct tia_frame *frame)
{
    now.at_us[now.count % SHOWN] = now.world->now_us - START;
    now.told[now.count++ % SHOWN] = *frame;
    return frame->block > 1 && !frame->moving ? TIA_OK : world_frame_done(ctx, frame);
}

/* Returns a world with the thesis scene and four rays a pixel, which the span renderer does not draw; with `plays`, its
 * light moves for 10 s. */
static struct world *paced_world(uint32_t pace, bool plays)
{
    static const struct tia_keyframe keys[] = {{0, {-20 * ONE, 20 * ONE, -20 * ONE}},
                                               {10 * ONE, {20 * ONE, 20 * ONE, -20 * ONE}}};
    static const struct tia_track track = {.target = TIA_MOVES_LIGHT, .keys = keys, .key_count = 2};
    static struct tia_scene scene;
    struct world *w = world_new();

    scene = tia_thesis_scene;
    scene.camera.samples = 4;
    scene.lights = &tia_thesis_scene.bindings[0].state;
    scene.light_count = 1;
    scene.tracks = plays ? &track : NULL;
    scene.track_count = plays;
    memset(&now, 0, sizeof now);
    now.world = w;
    now.core = tia_core_q16;
    now.core.drawing = &now.drawing;
    now.drawing = tia_drawing;
    now.drawing.light = slow_light;
    now.drawing.render = slow_render;
    w->viewer.core = &now.core;
    w->viewer.scene = &scene;
    w->viewer.pacing.pace[0] = pace;
    w->viewer.pacing.pace[1] = 1;
    w->viewer.hooks.frame_done = done;
    w->compare = keep;
    return w;
}

/* Frames keep the rate, with the finest blocks that leave an eighth of their pass as a reserve. */
TEST(a_scene_that_plays)
{
    static const struct {
        uint32_t pace;
        uint16_t block;
    } rows[] = {{1000, 8}, {400, 4}, {120, 4}, {110, 2}, {60, 2}, {30, 2}, {29, 1}, {20, 1}};

    for (unsigned r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        struct world *w = paced_world(rows[r].pace, true);
        uint64_t period = (1000000 + rows[r].pace - 1) / rows[r].pace;
        unsigned frames = 0;
        quit_at(w, START + 300000);
        CHECK_EQ(world_play(w), TIA_OK);
        for (unsigned i = 0; i < now.count && i < SHOWN; i++) {
            CHECK_MSG(now.told[i].moving && now.told[i].block == rows[r].block, "pace %u, frame %u: blocks of %u",
                      (unsigned)rows[r].pace, i, now.told[i].block);
            CHECK_MSG(i < 2 || now.at_us[i] - now.at_us[i - 1] <= period + 1000, "pace %u, frame %u: %u us",
                      (unsigned)rows[r].pace, i, (unsigned)(now.at_us[i] - now.at_us[i - 1]));
            frames++;
        }
        CHECK_MSG(frames >= rows[r].pace * 29 / 100 && frames <= rows[r].pace * 3 / 10 + 1, "pace %u: %u frames",
                  (unsigned)rows[r].pace, frames);
    }
}

/* Frames are coarse while a key is held. After its release they are refined to the full picture. */
TEST(a_held_key_and_then_the_rest)
{
    struct world *w = paced_world(60, false);

    world_event(w, START + 100000, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
    world_event(w, START + 1100000, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    unsigned moving = 0;
    for (unsigned i = 0; i < now.count; i++) {
        moving += now.told[i].moving;
        CHECK(!now.told[i].moving || now.told[i].block == 2);
        CHECK(!now.told[i].moving || (now.at_us[i] >= 100000 && now.at_us[i] < 1150000));
    }
    CHECK_MSG(moving >= 22 && moving <= 25, "%u frames", moving); /* 30 steps a second from 0.35 s on */
    CHECK_EQ(now.told[now.count - 1].block, 1);
    CHECK(now.at_us[now.count - 1] < 1100000 + 34000 + 2 * 31000);
    CHECK(memcmp(now.pixels, now.full, sizeof now.full) == 0);
}

/* After a tap, the first picture is as fine as the period allows, and is then refined. */
TEST(a_key_that_is_tapped)
{
    struct world *w = paced_world(60, false);

    world_event(w, START + 100000, TIA_EVENT_TAP, TIA_KEY_RIGHT);
    quit_at(w, START + 3000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(now.count == 4);
    CHECK(now.told[2].block == 2 && !now.told[2].moving && now.at_us[2] == 100000 + 7680);
    CHECK(now.told[3].block == 1 && now.at_us[3] == 100000 + 30720);
}

/* Without a target rate, frames are refined as usual. */
TEST(no_pace)
{
    struct world *w = paced_world(0, true);

    quit_at(w, START + 300000);
    CHECK_EQ(world_play(w), TIA_OK);
    for (unsigned i = 0; i < now.count; i++)
        CHECK(!now.told[i].moving && now.told[i].block == 1);
    w = paced_world(60, true);
    w->viewer.pacing.pace[1] = 0;
    CHECK_EQ(world_play(w), TIA_ERR_ARGUMENT);
}

int main(void)
{
    RUN_LONG(a_scene_that_plays);
    RUN(a_held_key_and_then_the_rest);
    RUN(a_key_that_is_tapped);
    RUN(no_pace);
    return check_status();
}
