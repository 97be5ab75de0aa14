/* tia_viewer_run: pictures of samples are shown before all samples are drawn, and rasterised ones in rows. Time passes
 * only while samples or pixels are drawn, 1 ms for each, so that their number gives the pictures and times: in the five
 * passes over three tiles of 64 x 16 pixels, 12, 36, 144, 576 and 2304 pixels are drawn with one sample; then all 3072
 * get their second sample, and then two more each. */
#include <tia/shadow.h>

#include "viewer_world.h"

enum { TILES = 3, SHOWN = 64, SPP = 4, PIXELS = WORLD_WIDTH * WORLD_HEIGHT, US = 1000 };

/* An expected picture: its time, the size of blocks and the number of samples in each tile, and the length of the
 * progress line; told_*: the values that the frame reports. */
struct picture {
    uint64_t at_us;
    uint8_t block[TILES], samples[TILES];
    int line;
    uint16_t told_block;
    uint8_t told_samples;
};

static struct {
    struct world *world;
    struct tia_core core;
    struct tia_drawing drawing;
    struct tia_estimator estimator;
    struct tia_scene scene;
    tia_rgb565 pictures[SPP + 1][PIXELS]; /* pictures by the number of their samples */
    tia_rgb565 last[PIXELS];              /* the picture that was shown last */
    uint32_t samples[PIXELS];
    unsigned lit[PIXELS];
    bool rows; /* pictures are refined in rows: blocks are as wide as the picture */
    const struct picture *expected;
    unsigned count, shown, told;
    uint64_t at_us[SHOWN], key_us[SHOWN], left_us[SHOWN];
    unsigned alone,
        weights[TILES]; /* 0, or for black pictures the cost of a pixel drawn alone, and of pixels of each tile */
} now;

/* ---- drawing ---- */

/* Returns the time for a sample. */
static unsigned cost_of(struct tia_tile tile)
{
    return now.alone ? 10 * now.weights[tile.y / 16] * (tile.width == 1 ? now.alone : 1) : US;
}

static int slow_sample(const struct tia_view *view, struct tia_tile tile, uint32_t first, uint32_t end,
                       struct tia_sum *sums, size_t pitch)
{
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++)
        for (unsigned x = tile.x; x < (unsigned)tile.x + tile.width; x++) {
            uint32_t *samples = &now.samples[y * WORLD_WIDTH + x];
            CHECK_MSG(first == 0 || *samples == first, "pixel %u, %u: sample %u after %u", x, y, (unsigned)first,
                      (unsigned)*samples);
            *samples = end;
        }
    now.world->now_us += (uint64_t)cost_of(tile) * (end - first) * tile.width * tile.height;
    return now.alone ? TIA_OK : tia_estimator_q16.sample(view, tile, first, end, sums, pitch);
}

static int slow_render(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile,
                       const struct tia_surface *surface, const struct tia_options *options)
{
    now.world->now_us += (uint64_t)US * tile.width * tile.height;
    for (unsigned y = tile.y; y < (unsigned)tile.y + tile.height; y++)
        for (unsigned x = tile.x; x < (unsigned)tile.x + tile.width; x++)
            now.lit[y * WORLD_WIDTH + x]++;
    return tia_drawing.render(view, hits, tile, surface, options);
}

/* Draws the scene at once, with `spp` samples. */
static void draw_whole(uint32_t spp, tia_rgb565 *pixels)
{
    static uint64_t view_memory[32768], hits_memory[32768];
    struct tia_tile all = {0, 0, WORLD_WIDTH, WORLD_HEIGHT};
    struct tia_surface surface = {.pixels = pixels, .step = 2, .pitch = 2 * WORLD_WIDTH};
    struct tia_scene scene = now.scene;
    struct tia_view *view;
    struct tia_hits *hits;

    scene.integration.spp = spp;
    CHECK_EQ(
        tia_view_init(&view, view_memory, sizeof view_memory, &scene, WORLD_LIGHTS, WORLD_WIDTH, WORLD_HEIGHT, NULL),
        0);
    CHECK_EQ(tia_hits_init(&hits, hits_memory, sizeof hits_memory, view, all), TIA_OK);
    CHECK_EQ(tia_view_draw(view, hits, all, &surface, NULL), TIA_OK);
}

/* ---- the pictures ---- */

static tia_rgb565 shown_at(const struct picture *p, unsigned x, unsigned y)
{
    unsigned tile = y / 16, block = p->block[tile];

    if (p->line >= 0 && y == WORLD_HEIGHT - 1)
        return x < (unsigned)p->line ? 0xffff : 0;
    return now.pictures[p->samples[tile]][y / block * block * WORLD_WIDTH + (now.rows ? x : x / block * block)];
}

static void compare(struct world *w, const tia_rgb565 *full)
{
    const struct picture *p = now.expected && now.shown < now.count ? &now.expected[now.shown] : NULL;

    (void)full;
    memcpy(now.last, w->pixels, sizeof now.last);
    now.at_us[now.shown % SHOWN] = w->now_us - START;
    CHECK(!p || now.at_us[now.shown] == p->at_us);
    for (unsigned i = 0; p && i < PIXELS; i++)
        CHECK_MSG(w->pixels[i] == shown_at(p, i % WORLD_WIDTH, i / WORLD_WIDTH), "picture %u, pixel %u, %u", now.shown,
                  i % WORLD_WIDTH, i / WORLD_WIDTH);
    now.shown++;
}

static int done(void *ctx, const struct tia_frame *frame)
{
    const struct picture *p = now.expected && now.told < now.count ? &now.expected[now.told] : NULL;

    now.key_us[now.told % SHOWN] = frame->key_us;
    now.left_us[now.told % SHOWN] = frame->left_us;
    CHECK(!p || (frame->block == p->told_block && frame->samples == p->told_samples));
    if (p && frame->block > 1) { /* before there are pixels in rows, these are taken to cost 4/5 of others */
        uint64_t end = now.expected[now.count - 1].at_us, told = frame->left_us + p->at_us;
        if (!now.rows && now.told < 4)
            end = end / (2 * SPP) + end * (2 * SPP - 1) / (2 * SPP) * 4 / 5;
        CHECK_MSG(told <= end + 1 && told >= end - end / 100, "picture %u: %u ms", now.told, (unsigned)(told / 1000));
    }
    now.told++;
    return frame->block > 1 ? TIA_OK : world_frame_done(ctx, frame);
}

static struct world *slow_world(const struct picture *expected, unsigned count)
{
    struct world *w = world_new();

    memset(&now, 0, sizeof now);
    now.world = w;
    now.scene = tia_thesis_scene;
    now.expected = expected;
    now.count = count;
    now.core = tia_core_q16;
    now.core.drawing = &now.drawing;
    now.drawing = tia_drawing;
    now.drawing.render = slow_render;
    now.estimator = tia_estimator_q16;
    now.estimator.sample = slow_sample;
    w->viewer.scene = &now.scene;
    w->viewer.core = &now.core;
    w->viewer.estimator = &now.estimator;
    w->viewer.hooks.frame_done = done;
    w->compare = compare;
    return w;
}

/* Returns a world with ambient occlusion in the thesis scene, SPP samples a pixel. */
static struct world *open_world(const struct picture *expected, unsigned count)
{
    struct world *w = slow_world(expected, count);

    now.scene.integration = (struct tia_integration){.integrator = TIA_OCCLUSION, .spp = SPP};
    for (uint32_t spp = 1; spp <= SPP; spp++)
        draw_whole(spp, now.pictures[spp]);
    return w;
}

/* ---- samples ---- */

/* Each pixel of the progress line stands for 192 samples. */
static const struct picture samples[] = {
    {48000, {8, 8, 8}, {1, 1, 1}, 0, 8, 1},     {192000, {4, 4, 4}, {1, 1, 1}, 1, 4, 1},
    {576000, {2, 2, 4}, {1, 1, 1}, 3, 4, 1},    {768000, {2, 2, 2}, {1, 1, 1}, 4, 2, 1},
    {1536000, {1, 2, 2}, {1, 1, 1}, 8, 2, 1},   {2304000, {1, 1, 2}, {1, 1, 1}, 12, 2, 1},
    {3072000, {1, 1, 1}, {1, 1, 1}, 16, 2, 1},  {4096000, {1, 1, 1}, {2, 1, 1}, 21, 2, 1},
    {5120000, {1, 1, 1}, {2, 2, 1}, 26, 2, 1},  {6144000, {1, 1, 1}, {2, 2, 2}, 32, 2, 2},
    {8192000, {1, 1, 1}, {4, 2, 2}, 42, 2, 2},  {10240000, {1, 1, 1}, {4, 4, 2}, 53, 2, 2},
    {12288000, {1, 1, 1}, {4, 4, 4}, -1, 1, 0},
};
enum { PICTURES = sizeof samples / sizeof samples[0] };

TEST(samples_as_they_come)
{
    struct world *w = open_world(samples, PICTURES);

    CHECK(memcmp(now.pictures[1], now.pictures[2], sizeof now.pictures[1]));
    CHECK(memcmp(now.pictures[2], now.pictures[4], sizeof now.pictures[2]));
    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(now.shown, PICTURES);
    for (unsigned i = 0; i < PIXELS; i++)
        CHECK(now.samples[i] == SPP && !now.lit[i]);
}

/* Three samples are drawn in passes of one each: the last pass adds the rest. */
TEST(a_number_that_is_no_power_of_two)
{
    struct world *w = open_world(NULL, 0);

    now.scene.integration.spp = 3;
    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(now.at_us[now.shown - 1], 3 * 3072000);
    for (unsigned i = 0; i < PIXELS; i++)
        CHECK_EQ(now.samples[i], 3);
}

/* A key while all pixels get their second sample is noticed at most 20 ms later, and the first picture of the new frame
 * follows 48 ms after that. */
TEST(a_key_begins_the_frame_anew)
{
    struct world *w = open_world(NULL, 0);

    now.scene.bindings = tia_thesis_scene.bindings;
    world_event(w, START + 3500000, TIA_EVENT_TAP, 'a');
    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(now.at_us[6], 3072000);
    CHECK(now.at_us[7] >= 3548000 && now.at_us[7] <= 3548000 + 21000 + 64 * US);
    CHECK_EQ(now.key_us[7], now.at_us[7] - 3500000);
    for (unsigned i = 0; i < PIXELS; i++)
        CHECK_EQ(now.samples[i], SPP);
}

/* Blocks of 8 suffice beyond the fovea, 8 pixels around the gaze. The pixels that are drawn have all samples, and are
 * shown. */
TEST(only_where_the_eye_looks)
{
    struct world *w = open_world(NULL, 0);
    unsigned drawn = 0;

    w->viewer.gaze = (struct tia_gaze){.x = 32, .y = 24, .view_angle = TIA_Q16(20), .m = 1 << 24};
    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    for (unsigned i = 0; i < PIXELS; i++) {
        CHECK(now.samples[i] == 0 || now.samples[i] == SPP);
        CHECK(now.samples[i] == 0 || now.last[i] == now.pictures[SPP][i]);
        drawn += now.samples[i] != 0;
    }
    CHECK(now.samples[24 * WORLD_WIDTH + 32] == SPP && now.samples[24 * WORLD_WIDTH + 39] == SPP);
    CHECK(!now.samples[23 * WORLD_WIDTH + 51] && drawn > 170 && drawn < 400);
    CHECK_EQ(now.at_us[now.shown - 1], (uint64_t)SPP * US * drawn);
}

/* All samples are drawn at once: pixel by pixel without an estimator or with too little memory for the sums, and the
 * whole picture at once without memory for a canvas. */
TEST(all_samples_at_once)
{
    struct world *w = open_world(NULL, 0);
    size_t enough;

    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    enough = w->memory_size;
    for (int i = 0; i < 3; i++) {
        w = open_world(NULL, 0);
        if (i == 0)
            w->viewer.estimator = NULL;
        w->memory_limit = i == 0 ? SIZE_MAX : i == 1 ? enough - 1 : enough - PIXELS * sizeof(struct tia_sum) - 8;
        quit_at(w, START + 20000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK_EQ(now.shown, i < 2 ? 7 : 1);
        for (unsigned p = 0; p < PIXELS; p++)
            CHECK(now.lit[p] == 1 && !now.samples[p]);
    }
}

/* The pictures are black: none is compared, so that a reference need not be sampled. */
static const struct tia_scene *quick_scene(const struct world *w)
{
    (void)w;
    return &tia_thesis_scene;
}

/* A tile costs up to thirty times as much as another, and a pixel that is drawn alone several times as much as one
 * of a run, as in a view of vector units. From a tenth of the time on, the time left is right within a fifth. */
TEST(time_left)
{
    static const unsigned alone[] = {1, 5, 8}, weights[][TILES] = {{1, 10, 30}, {30, 1, 10}, {1, 1, 1}};

    for (unsigned i = 0; i < 9; i++) {
        struct world *w = open_world(NULL, 0);
        uint64_t end;

        w->scene_now = quick_scene;
        now.scene.integration.spp = 64;
        now.alone = alone[i / 3];
        memcpy(now.weights, weights[i % 3], sizeof now.weights);
        quit_at(w, START + 40000000);
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(now.told == now.shown && now.shown > 8 && now.shown <= SHOWN);
        end = now.at_us[now.shown - 1];
        for (unsigned k = 0; k + 1 < now.shown; k++) {
            uint64_t told = now.at_us[k] + now.left_us[k];
            CHECK_MSG(now.at_us[k] < end / 10 || (told > end - end / 5 && told < end + end / 5),
                      "case %u: %u of %u s: %u in all", i, (unsigned)(now.at_us[k] / 1000000),
                      (unsigned)(end / 1000000), (unsigned)(told / 1000000));
        }
    }
}

/* ---- rows ---- */

/* Returns a world with two boxes and their shadows. The first rows of the three tiles take 192 ms, and the other rows
 * of each tile 960 ms. */
static struct world *shadows_world(const struct picture *expected, unsigned count)
{
    static const struct tia_material grey = {.colour = TIA_RGB(0.5, 0.6, 0.7)};
    static const struct tia_shape boxes[] = {{.kind = TIA_BOX, .box = {TIA_VEC3(-9, -1, -9), TIA_VEC3(9, 0, 3)}},
                                             {.kind = TIA_BOX, .box = {TIA_VEC3(-1, 0, -1), TIA_VEC3(1, 2, 1)}}};
    static const struct tia_light lamp = {.centre = TIA_VEC3(2, 5, 2), .radius = ONE, .emission = TIA_RGB(1, 1, 1)};
    struct world *w = slow_world(expected, count);

    now.rows = true;
    now.scene = (struct tia_scene){.camera = {.eye = TIA_VEC3(0, 3, 9), .fov = TIA_Q16(45)},
                                   .materials = &grey,
                                   .shapes = boxes,
                                   .lights = &lamp,
                                   .material_count = 1,
                                   .shape_count = 2,
                                   .light_count = 1,
                                   .shadows = TIA_SHADOWS_ZFAIL};
    draw_whole(0, now.pictures[1]);
    return w;
}

static const struct picture rows[] = {
    {192000, {16, 16, 16}, {1, 1, 1}, 4, 16, 0},
    {1152000, {1, 16, 16}, {1, 1, 1}, 24, 16, 0},
    {2112000, {1, 1, 16}, {1, 1, 1}, 44, 16, 0},
    {3072000, {1, 1, 1}, {1, 1, 1}, -1, 1, 0},
};

TEST(rows_first)
{
    struct world *w = shadows_world(rows, 4);

    quit_at(w, START + 20000000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 1);
    CHECK_EQ(now.shown, 4);
    for (unsigned i = 0; i < PIXELS; i++)
        CHECK_EQ(now.lit[i], 1);
}

int main(void)
{
    RUN(samples_as_they_come);
    RUN(a_number_that_is_no_power_of_two);
    RUN(a_key_begins_the_frame_anew);
    RUN(only_where_the_eye_looks);
    RUN(all_samples_at_once);
    RUN(time_left);
    RUN(rows_first);
    return check_status();
}
