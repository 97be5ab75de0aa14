/* tia_viewer_run: frames that take long are shown coarse to fine. Time passes here only while pixels are lit, equally
 * for each, so that the number of pixels gives the pictures and their times: 12, 36, 144, 576 and 2304 in the five
 * passes over three tiles of 64 x 16. */
#include "viewer_world.h"

enum { TILES = 3, SHOWN = 64 };

/* An expected picture: its time, the size of the blocks in each tile, and the length of the progress line. */
struct picture {
    uint64_t at_us;
    uint8_t block[TILES];
    uint8_t line;
};

static struct {
    struct world *world;
    struct tia_core core;
    struct tia_drawing drawing;
    uint64_t pixel_us;
    unsigned traced[WORLD_HEIGHT][WORLD_WIDTH], lit[WORLD_HEIGHT][WORLD_WIDTH];

    const struct picture *expected; /* NULL: the times may be any */
    unsigned expected_count, shown;
    uint64_t at_us[SHOWN];
    struct tia_frame told[SHOWN];
    unsigned told_count;
} now;

/* ---- a slow renderer ---- */

static void count(unsigned pixels[WORLD_HEIGHT][WORLD_WIDTH], struct tia_tile tile)
{
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++)
        for (unsigned x = tile.x; x < (unsigned)tile.x + tile.width; x++)
            pixels[y][x]++;
}

static int slow_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile)
{
    count(now.traced, tile);
    return tia_drawing.trace(view, hits, tile);
}

static int slow_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                      const struct tia_surface *surface, const struct tia_options *options)
{
    now.world->now_us += now.pixel_us * tile.width * tile.height;
    count(now.lit, tile);
    return tia_drawing.light(view, hits, tile, surface, options);
}

static int slow_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    int status = slow_trace(view, hits, tile);

    return status ? status : slow_light(view, hits, tile, surface, options);
}

/* Checks that each pixel of the frame was lit once, and traced `traced` times; then resets the numbers. */
static void check_counts(unsigned traced)
{
    for (unsigned y = 0; y < WORLD_HEIGHT; y++)
        for (unsigned x = 0; x < WORLD_WIDTH; x++)
            CHECK_MSG(now.lit[y][x] == 1 && now.traced[y][x] == traced, "pixel %u, %u: lit %u times, traced %u", x, y,
                      now.lit[y][x], now.traced[y][x]);
    memset(now.lit, 0, sizeof now.lit);
    memset(now.traced, 0, sizeof now.traced);
}

/* ---- the pictures ---- */

/* Returns the pixel shown by the block around (x, y): its upper left one. */
static tia_rgb565 mosaic(const tia_rgb565 *full, unsigned x, unsigned y, unsigned block)
{
    return full[y / block * block * WORLD_WIDTH + x / block * block];
}

static void compare(struct world *w, const tia_rgb565 *full)
{
    const struct picture *p = now.expected ? &now.expected[now.shown] : NULL;

    now.at_us[now.shown % SHOWN] = w->now_us - START;
    CHECK(!p || now.shown < now.expected_count);
    for (unsigned y = 0; p && now.shown < now.expected_count && y < WORLD_HEIGHT; y++)
        for (unsigned x = 0; x < WORLD_WIDTH; x++) {
            tia_rgb565 want = mosaic(full, x, y, p->block[y / 16]);
            if (p->line && y == WORLD_HEIGHT - 1)
                want = x < p->line ? 0xffff : 0;
            CHECK_MSG(w->pixels[y * WORLD_WIDTH + x] == want, "picture %u, pixel %u, %u", now.shown, x, y);
        }
    CHECK(!p || now.shown >= now.expected_count || now.at_us[now.shown] == p->at_us);
    now.shown++;
}

static int done(void *ctx, const struct tia_frame *frame)
{
    now.told[now.told_count++ % SHOWN] = *frame;
    return frame->block > 1 ? TIA_OK : world_frame_done(ctx, frame);
}

/* Returns a world with the thesis scene and four rays a pixel, which the span renderer does not draw. */
static struct world *slow_world(uint64_t pixel_us, const struct picture *expected, unsigned expected_count)
{
    static struct tia_scene scene;
    struct world *w = lit_world();

    scene = tia_thesis_scene;
    scene.camera.samples = 4;
    w->viewer.scene = &scene;
    memset(&now, 0, sizeof now);
    now.world = w;
    now.core = tia_core_q16;
    now.core.drawing = &now.drawing;
    now.drawing = tia_drawing;
    now.drawing.trace = slow_trace;
    now.drawing.light = slow_light;
    now.drawing.render = slow_render;
    now.pixel_us = pixel_us;
    now.expected = expected;
    now.expected_count = expected_count;
    w->viewer.core = &now.core;
    w->viewer.hooks.frame_done = done;
    w->compare = compare;
    return w;
}

/* The pictures of a frame of 3.072 s. Passes end after 12, 48, 192, 768 and 3072 ms. The first ends within a period of
 * the display; passes that take longer than 250 ms are also shown after the tile at which that time is over. The length
 * of the line is the share of finished pixels: one column for 48 pixels. */
static const struct picture slow[] = {
    {48000, {8, 8, 8}, 1},    {192000, {4, 4, 4}, 4},   {576000, {2, 2, 4}, 12}, {768000, {2, 2, 2}, 16},
    {1536000, {1, 2, 2}, 32}, {2304000, {1, 1, 2}, 48}, {3072000, {1, 1, 1}, 0},
};

TEST(coarse_to_fine)
{
    struct world *w = slow_world(1000, slow, 7);

    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(now.shown, 7);
    check_counts(1);
    for (unsigned i = 0; i < 7; i++) {
        static const uint16_t done[] = {1024, 4096, 12288, 16384, 32768, 49152};
        static const uint16_t blocks[] = {8, 4, 4, 2, 2, 2, 1};
        const struct tia_frame *t = &now.told[i];
        CHECK_EQ(t->number, 0);
        CHECK_EQ(t->draw_us, slow[i].at_us);
        CHECK_EQ(t->block, blocks[i]);
        if (i < 6)
            CHECK_EQ(t->done, done[i]);
        if (i < 4) /* the other half of the pixels, in rows, is taken to cost 4/5 of these */
            CHECK_EQ(t->left_us, 3072000 / 2 + 3072000 / 2 * 4 / 5 - slow[i].at_us);
        else if (i < 6)
            CHECK(t->left_us <= 3072000 - slow[i].at_us && t->left_us >= 3072000 / 100 * 99 - slow[i].at_us);
    }
}

/* A relit frame traces no pixel, and is also shown coarse to fine. */
TEST(coarse_to_fine_from_old_hits)
{
    struct world *w = slow_world(1000, NULL, 0);

    world_event(w, START + 4000000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 9000000);
    w->done_status = 0;
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 2);
    CHECK(w->frames[1].told.relit);
    for (unsigned i = 0; i < WORLD_WIDTH; i++)
        CHECK(now.lit[5][i] == 2 && now.traced[5][i] == 1);
    CHECK_EQ(now.shown, 14);
    CHECK_EQ(now.told[7].key_us, 48000);
    CHECK(now.told[8].key_us == 0 && now.told[12].key_us == 0);
    CHECK_EQ(now.told[13].key_us, 3072000);
}

/* A frame of 15.36 ms, less than a period at 60 Hz, is shown whole. */
TEST(a_quick_frame_is_shown_whole)
{
    static const struct picture whole[] = {{15360, {1, 1, 1}, 0}, {115360, {1, 1, 1}, 0}};
    struct world *w = slow_world(5, whole, 2);

    world_event(w, START + 100000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(now.shown, 2);
}

/* A frame of less than a second has no progress line. */
TEST(no_line_for_a_short_time)
{
    static const struct picture short_time[] = {
        {57600, {4, 4, 4}, 0}, {230400, {2, 2, 2}, 0}, {691200, {1, 1, 2}, 0}, {921600, {1, 1, 1}, 0}};
    struct world *w = slow_world(300, short_time, 4);

    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(now.shown, 4);
}

/* A key at 100 ms is noticed at the next poll, at most 20 ms later, and the first picture of the new frame is shown 48
 * ms after that. A key before the first picture is noticed after that picture. */
TEST(a_key_begins_the_frame_anew)
{
    for (int early = 0; early < 2; early++) {
        struct world *w = slow_world(1000, NULL, 0);
        world_event(w, START + (early ? 5000 : 100000), TIA_EVENT_TAP, TIA_KEY_LEFT);
        quit_at(w, START + 9000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(w->frame_count, 1);
        CHECK_EQ(w->frames[0].light.x, -21 * ONE);
        CHECK_EQ(now.shown, 8);
        CHECK_EQ(now.at_us[0], 48000);
        CHECK(now.at_us[1] >= (early ? 96000u : 148000u) && now.at_us[1] <= (early ? 96000u : 148000u) + 21000);
        CHECK_EQ(now.told[1].key_us, now.at_us[1] - (early ? 5000 : 100000));
        CHECK_EQ(now.at_us[7] - now.at_us[1], 3072000 - 48000);
    }
}

static int slow_prepare(const struct tia_core *core, struct tia_view **view, void *memory, size_t size,
                        const struct tia_scene *scene, uint32_t light_capacity, unsigned width, unsigned height,
                        const struct tia_job *job)
{
    now.world->now_us += 100000;
    return job->stop(job->ctx)
               ? TIA_STOPPED
               : tia_core_q16.view_init(core, view, memory, size, scene, light_capacity, width, height, job);
}

/* A key during the preparation of the first frame is noticed after the preparation; the first picture of that frame is
 * shown, and then the frame begins anew. */
TEST(a_key_while_the_view_is_prepared)
{
    struct world *w = slow_world(1000, NULL, 0);

    now.core.view_init = slow_prepare;
    world_event(w, START + 50000, TIA_EVENT_TAP, TIA_KEY_LEFT);
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(now.at_us[0], 148000);
    CHECK(now.at_us[1] >= 196000 && now.at_us[1] <= 196000 + 21000);
}

/* While a key is held, pictures follow one another; the last is complete and shows the light's position at the release.
 */
TEST(a_held_key)
{
    struct world *w = slow_world(1000, NULL, 0);

    world_event(w, START + 100000, TIA_EVENT_PRESS, TIA_KEY_RIGHT);
    world_event(w, START + 1100000, TIA_EVENT_RELEASE, TIA_KEY_RIGHT);
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK(w->frames[0].light.x >= (-20 + 20) * ONE && w->frames[0].light.x <= (-20 + 24) * ONE);
    for (unsigned i = 1; i < now.shown && now.at_us[i] < 1200000; i++)
        CHECK_MSG(now.at_us[i] - now.at_us[i - 1] <= 400000, "picture %u", i);
    CHECK(now.shown >= 15);
}

TEST(a_key_that_quits)
{
    struct world *w = slow_world(1000, NULL, 0);

    quit_at(w, START + 400000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(w->now_us <= START + 421000);
    CHECK(w->frame_count == 0 && now.shown == 2);
}

/* With several threads tiles are drawn in any order; only the order in which tiles become finer differs. */
TEST(several_threads)
{
    static const struct picture backwards[] = {
        {48000, {8, 8, 8}, 1},    {192000, {4, 4, 4}, 4},   {576000, {4, 2, 2}, 12}, {768000, {2, 2, 2}, 16},
        {1536000, {2, 2, 1}, 32}, {2304000, {2, 1, 1}, 48}, {3072000, {1, 1, 1}, 0},
    };
    struct world *w = slow_world(1000, backwards, 7);

    w->mode.concurrent = true;
    w->viewer.job.workers = &w->workers;
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(now.shown, 7);
    check_counts(1);
}

/* Another program's screen is shown from 300 ms on: the frame is drawn again when the viewer's screen is back. */
TEST(another_program_takes_the_screen)
{
    struct world *w = slow_world(1000, NULL, 0);

    w->hidden_from_us = START + 300000;
    w->hidden_until_us = START + 2000000;
    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK(now.at_us[1] == 192000 && now.at_us[2] == 2048000);
}

/* Frames are drawn at once, not coarse to fine, with too little memory, without a clock, in films, and with a limit of
 * frames. */
TEST(frames_at_once)
{
    struct world *w = slow_world(1000, NULL, 0);
    size_t enough;

    quit_at(w, START + 9000000);
    CHECK_EQ(world_play(w), TIA_OK);
    enough = w->memory_size;
    for (int i = 0; i < 3; i++) {
        w = slow_world(1000, slow + 6, 1);
        if (i == 0)
            w->memory_limit = enough - 1;
        if (i == 1)
            w->viewer.ports.clock = NULL;
        if (i == 2)
            w->viewer.pacing.frame_limit = 1;
        quit_at(w, START + 9000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(now.shown, 1);
        check_counts(1);
    }
}

int main(void)
{
    RUN(coarse_to_fine);
    RUN(coarse_to_fine_from_old_hits);
    RUN(a_quick_frame_is_shown_whole);
    RUN(no_line_for_a_short_time);
    RUN(a_key_begins_the_frame_anew);
    RUN(a_key_while_the_view_is_prepared);
    RUN(a_held_key);
    RUN(a_key_that_quits);
    RUN(several_threads);
    RUN(another_program_takes_the_screen);
    RUN(frames_at_once);
    return check_status();
}
