/* test_gaze.c - the gaze: blocks by the acuity model, against its formulas in double precision; and the viewer's
 * pictures with them. */
#include <math.h>

#include "viewer/acuity.h"
#include "viewer_world.h"

#define DEGREE (acos(-1) / 180)

/* ---- the model ---- */

/* Returns the degrees between the gaze and the middle of a pixel, for an eye before the middle of the picture. */
static double eccentricity(const struct tia_gaze *g, unsigned width, unsigned height, double x, double y)
{
    double z = width / 2.0 / tan(g->view_angle / 65536.0 / 2 * DEGREE);
    double a[3] = {g->x + 0.5 - width / 2.0, g->y + 0.5 - height / 2.0, z};
    double b[3] = {x + 0.5 - width / 2.0, y + 0.5 - height / 2.0, z};
    double c[3] = {a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]};

    return atan2(sqrt(c[0] * c[0] + c[1] * c[1] + c[2] * c[2]), a[0] * b[0] + a[1] * b[1] + a[2] * b[2]) / DEGREE;
}

static double pixel_degrees(const struct tia_gaze *g, unsigned width)
{
    return tan(g->view_angle / 65536.0 / 2 * DEGREE) * 2 / width / DEGREE;
}

/* Returns the block that w0 + m e allows, 1..16; 1 within 2.5 degrees. */
static unsigned block_for(const struct tia_gaze *g, double pixel, double e)
{
    unsigned block = 1;
    double angle = g->w0 / 16777216.0 + g->m / 16777216.0 * fmin(e, 90);

    while (e >= 2.5 && block < 16 && 2 * block * pixel <= angle)
        block *= 2;
    return block;
}

/* Checks the block of a pixel; near a limit, both sizes are accepted. */
static void check_block(const struct tia_gaze *g, const struct tia_acuity *a, unsigned x, unsigned y)
{
    double e = eccentricity(g, a->width, a->height, x, y), pixel = pixel_degrees(g, a->width);
    double part = 1.0 / a->distance + 1e-4, slack = 0.005 + e * part; /* the distance is a whole number of half
                                                                         pixels */
    unsigned got = tia_acuity_block(a, x, y);

    CHECK_MSG(got >= block_for(g, pixel * (1 + part), e - slack) && got <= block_for(g, pixel * (1 - part), e + slack),
              "%ux%u, %g degrees: at %u, %u, %g degrees off, a block of %u", a->width, a->height,
              g->view_angle / 65536.0, x, y, e, got);
}

TEST(blocks_are_those_of_the_model)
{
    static const struct {
        uint16_t width, height, x, y;
        double angle, w0, m;
    } rows[] = {
        {1920, 1080, 960, 540, 50, 1.0 / 48, 0.0275},
        {3840, 2160, 960, 2159, 90, 1.0 / 48, 0.0275},
        {640, 480, 0, 0, 30, 1.0 / 48, 0.0275},
        {8192, 8192, 8191, 8191, 170, 1.0 / 48, 0.0275},
        {8192, 4096, 4096, 2048, 1, 0, 1},
        {320, 200, 10, 190, 120, 0, 2},
        {800, 600, 400, 300, 60, 100, 0},
        {100, 100, 20, 99, 100, 5, 0.5},
    };

    for (unsigned r = 0; r < sizeof rows / sizeof rows[0]; r++) {
        struct tia_gaze g = {rows[r].x,
                             rows[r].y,
                             (tia_q16)(rows[r].angle * 65536),
                             (uint32_t)(rows[r].w0 * 16777216),
                             (uint32_t)(rows[r].m * 16777216),
                             false};
        struct tia_acuity a;
        if (!tia_acuity_init(&a, &g, rows[r].width, rows[r].height)) {
            CHECK_EQ(block_for(&g, pixel_degrees(&g, rows[r].width), 90), 1);
            continue;
        }
        for (unsigned y = 0; y < rows[r].height; y += rows[r].height / 50)
            for (unsigned x = 0; x < rows[r].width; x += rows[r].width / 50)
                check_block(&g, &a, x, y);
        CHECK_EQ(tia_acuity_block(&a, g.x, g.y), 1);
    }
}

TEST(when_every_pixel_is_drawn)
{
    struct tia_acuity a;
    struct tia_gaze g = {5, 5, TIA_Q16(50), TIA_GAZE_W0, TIA_GAZE_M, false};

    CHECK(tia_acuity_init(&a, &g, 1000, 1000));
    CHECK(!tia_acuity_init(&a, &g, 5, 1000)); /* the gaze is outside the picture */
    CHECK(!tia_acuity_init(&a, &g, 1000, 5));
    CHECK(!tia_acuity_init(&a, &g, 6, 6)); /* a pixel spans eight degrees */
    g.m = 0;
    CHECK(!tia_acuity_init(&a, &g, 1000, 1000));
    g.view_angle = 0;
    g.m = TIA_GAZE_M;
    CHECK(!tia_acuity_init(&a, &g, 1000, 1000));
}

/* ---- the viewer's pictures ---- */

/* The last picture shown, and the full render. */
static tia_rgb565 shown[WORLD_WIDTH * WORLD_HEIGHT], full[WORLD_WIDTH * WORLD_HEIGHT];

static void keep(struct world *w, const tia_rgb565 *want)
{
    memcpy(shown, w->pixels, sizeof shown);
    memcpy(full, want, sizeof full);
}

/* Returns a scene that is drawn by rays, in blocks even in so small a picture. */
static struct world *gazing_world(uint16_t x, uint16_t y, bool smooth)
{
    static struct tia_scene scene;
    struct world *w = lit_world();

    scene = tia_thesis_scene;
    scene.camera.up = (struct tia_vec3){0, ONE, 0};
    scene.camera.reference = scene.camera.eye;
    scene.camera.reference.z -= ONE;
    w->viewer.scene = &scene;
    w->viewer.gaze = (struct tia_gaze){x, y, TIA_Q16(50), 0, 33554432, smooth}; /* m = 2 */
    w->viewer.pacing.frame_limit = 1;
    w->compare = keep;
    return w;
}

static bool same_around(unsigned x, unsigned y, const tia_rgb565 *a, const tia_rgb565 *b)
{
    return a[y * WORLD_WIDTH + x] == b[y * WORLD_WIDTH + x];
}

/* True if a pixel is drawn: in the grid of each tile of 64 x 16, those for which the largest block of the grid
 * with this corner is too large, and those of the largest grid. */
static bool is_drawn(const struct tia_acuity *a, unsigned x, unsigned y)
{
    unsigned level = 1;

    while (level < 16 && x % (2 * level) == 0 && y % 16 % (2 * level) == 0)
        level *= 2;
    return level == 16 || tia_acuity_block(a, x, y) <= level;
}

TEST(where_it_looks_the_picture_is_the_full_one)
{
    static const uint16_t places[][2] = {{0, 0}, {63, 47}, {32, 24}, {20, 40}, {45, 17}};

    for (unsigned i = 0; i < 10; i++) {
        struct world *w = gazing_world(places[i / 2][0], places[i / 2][1], i & 1);
        struct tia_acuity a;
        unsigned drawn = 0, fovea = 0;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(tia_acuity_init(&a, &w->viewer.gaze, WORLD_WIDTH, WORLD_HEIGHT));
        for (unsigned y = 0; y < WORLD_HEIGHT; y++)
            for (unsigned x = 0; x < WORLD_WIDTH; x++) {
                bool in = eccentricity(&w->viewer.gaze, WORLD_WIDTH, WORLD_HEIGHT, x, y) < 2.49;
                drawn += is_drawn(&a, x, y);
                fovea += in;
                CHECK_MSG((!in && !is_drawn(&a, x, y)) || same_around(x, y, shown, full), "gaze %u, pixel %u, %u", i, x,
                          y);
            }
        CHECK_MSG(w->frames[0].told.pixels == drawn, "%u pixels, not %u", (unsigned)w->frames[0].told.pixels, drawn);
        CHECK(fovea >= 3 && drawn < WORLD_WIDTH * WORLD_HEIGHT / 2);
    }
}

/* True for a cell of 16 x 16 that is one block, as are those around it. */
static bool is_one_block(const struct tia_acuity *a, unsigned left, unsigned top)
{
    for (unsigned y = top; y <= top + 16; y++)
        for (unsigned x = left; x <= left + 16; x++)
            if (tia_acuity_block(a, x, y) < 16)
                return false;
    return left + 16 < WORLD_WIDTH && top + 16 < WORLD_HEIGHT;
}

static unsigned channel(unsigned x, unsigned y, unsigned shift, unsigned mask)
{
    return (unsigned)full[y * WORLD_WIDTH + x] >> shift & mask;
}

/* Returns the nearest of the four corners, or their mean weighted by the distances in x and y. */
static tia_rgb565 between(unsigned left, unsigned top, unsigned x, unsigned y, bool smooth)
{
    static const unsigned shift[3] = {11, 5, 0}, mask[3] = {31, 63, 31};
    double u = (x - left) / 16.0, v = (y - top) / 16.0;
    tia_rgb565 colour = 0;

    if (!smooth)
        return full[(top + (v > 0.5 ? 16 : 0)) * WORLD_WIDTH + left + (u > 0.5 ? 16 : 0)];
    for (int c = 0; c < 3; c++) {
        double upper = channel(left, top, shift[c], mask[c]) * (1 - u) + channel(left + 16, top, shift[c], mask[c]) * u;
        double lower =
            channel(left, top + 16, shift[c], mask[c]) * (1 - u) + channel(left + 16, top + 16, shift[c], mask[c]) * u;
        colour |= (tia_rgb565)((unsigned)floor(upper * (1 - v) + lower * v + 0.5) << shift[c]);
    }
    return colour;
}

TEST(blocks_between_their_corners)
{
    for (int smooth = 0; smooth < 2; smooth++) {
        struct world *w = gazing_world(32, 24, smooth);
        struct tia_acuity a;
        unsigned blocks = 0;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(tia_acuity_init(&a, &w->viewer.gaze, WORLD_WIDTH, WORLD_HEIGHT));
        for (unsigned i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
            unsigned x = i % WORLD_WIDTH, y = i / WORLD_WIDTH, left = x / 16 * 16, top = y / 16 * 16;
            if (!is_one_block(&a, left, top))
                continue;
            blocks += x == left && y == top;
            CHECK_MSG(shown[i] == between(left, top, x, y, smooth), "smooth %d: pixel %u, %u", smooth, x, y);
        }
        CHECK_MSG(blocks >= 2, "%u blocks", blocks);
    }
}

/* All pixels that are not drawn show a mean of the colours of drawn ones or, without `smooth`, one of these colours. */
TEST(what_is_between)
{
    for (int smooth = 0; smooth < 2; smooth++) {
        struct world *w = gazing_world(32, 24, smooth);
        unsigned others = 0;
        CHECK_EQ(world_play(w), TIA_OK);
        for (unsigned i = 0; i < WORLD_WIDTH * WORLD_HEIGHT; i++) {
            bool found = false;
            for (unsigned j = 0; j < WORLD_WIDTH * WORLD_HEIGHT && !found; j++)
                found = full[j] == shown[i];
            others += !found;
        }
        CHECK(smooth ? others > 0 : others == 0);
        CHECK(memcmp(shown, full, sizeof full) != 0);
    }
}

/* Threads draw tiles in any order. */
TEST(several_threads)
{
    for (int smooth = 0; smooth < 2; smooth++) {
        tia_rgb565 one[WORLD_WIDTH * WORLD_HEIGHT];
        struct world *w = gazing_world(20, 30, smooth);
        CHECK_EQ(world_play(w), TIA_OK);
        memcpy(one, shown, sizeof one);
        w = gazing_world(20, 30, smooth);
        w->mode.concurrent = true;
        w->viewer.job.workers = &w->workers;
        CHECK_EQ(world_play(w), TIA_OK);
        CHECK(memcmp(one, shown, sizeof one) == 0);
    }
}

/* The gaze follows the pointer; a picture whose gaze is outside is a full one. */
TEST(the_gaze_follows_a_pointer)
{
    struct world *w = gazing_world(10, 10, false);
    tia_rgb565 want[WORLD_WIDTH * WORLD_HEIGHT];

    CHECK_EQ(world_play(w), TIA_OK);
    memcpy(want, shown, sizeof want);
    w = gazing_world(60, 40, false);
    w->viewer.pacing.frame_limit = 0;
    w->events[w->event_count++] =
        (struct world_event){START + 50000, {.kind = TIA_EVENT_POINT, .x = 65535, .y = 65535}};
    w->events[w->event_count++] = (struct world_event){START + 60000, {.kind = TIA_EVENT_MOVE, .x = -53, .y = -90}};
    w->events[w->event_count++] = (struct world_event){START + 70000, {.kind = TIA_EVENT_MOVE, .x = 0, .y = 10}};
    quit_at(w, START + 100000);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK_EQ(w->frame_count, 4);
    CHECK(memcmp(want, shown, sizeof want) == 0);
    for (unsigned i = 0; i < 4; i++)
        CHECK(!w->frames[i].told.relit); /* other pixels are drawn each time */
    w = gazing_world(64, 0, false);
    CHECK_EQ(world_play(w), TIA_OK);
    CHECK(memcmp(full, shown, sizeof full) == 0);
    CHECK_EQ(w->frames[0].told.pixels, WORLD_WIDTH * WORLD_HEIGHT);
}

int main(void)
{
    RUN(blocks_are_those_of_the_model);
    RUN(when_every_pixel_is_drawn);
    RUN(where_it_looks_the_picture_is_the_full_one);
    RUN(blocks_between_their_corners);
    RUN(what_is_between);
    RUN(several_threads);
    RUN(the_gaze_follows_a_pointer);
    return check_status();
}
