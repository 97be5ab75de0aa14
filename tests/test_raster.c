/* The rasteriser against the oracle: every pixel of random polygons, depths and states. */
#include <math.h>

#include "raster_random.h"

#define PIXELS (64 * 64)
#define ALL (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR)

static uint32_t face[PIXELS];
static uint8_t stencil[PIXELS];
static uint16_t colour[3 * PIXELS];
static struct oracle_raster oracle;

struct trial {
    struct tia_raster_grid grid;
    struct tia_raster_target target;
    void *memory;
    struct tia_tile area;
    int64_t most;
    bool flat;
};

/* Begins a random tile of at most 32 x 32 pixels. */
static void begin_image(struct trial *t, unsigned buffers, unsigned range, const uint16_t size[2], uint32_t samples)
{
    struct oracle_image image = {t->flat ? TIA_ORTHOGRAPHIC : TIA_PERSPECTIVE, size[0], size[1], (int)samples,
                                 (int)random_below(samples)};

    CHECK_EQ(tia_raster_grid_init(&t->grid, image.projection, size[0], size[1], samples, (uint32_t)image.sample, range),
             TIA_OK);
    t->area.width = (uint16_t)(1 + random_below(size[0] < 32 ? size[0] : 32));
    t->area.height = (uint16_t)(1 + random_below(size[1] < 32 ? size[1] : 32));
    t->area.x = (uint16_t)random_below(size[0] - t->area.width + UINT64_C(1));
    t->area.y = (uint16_t)random_below(size[1] - t->area.height + UINT64_C(1));
    t->target = target_of(&t->grid, t->area, buffers, ORACLE_FACES, &t->memory);
    memset(face, 255, sizeof face);
    memset(stencil, 0, sizeof stencil);
    memset(colour, 0, sizeof colour);
    oracle.image = image;
    oracle.area = t->area;
    oracle.face = face;
    oracle.stencil = stencil;
    oracle.colour = colour;
}

/* Begins a random image, sample and tile. */
static void begin(struct trial *t, unsigned buffers, unsigned range)
{
    static const uint32_t counts[3] = {1, 4, 16};
    static const uint16_t sizes[][2] = {{32, 24}, {31, 17}, {8192, 8191}, {640, 480}, {16, 16}, {1, 1}, {7, 8192}};

    begin_image(t, buffers, range, sizes[random_below(7)], counts[random_below(3)]);
}

static void compare(const struct trial *t, const char *what)
{
    size_t n = (size_t)t->area.width * t->area.height, wrong[3] = {0};

    for (size_t i = 0; i < n; i++) {
        wrong[0] += t->target.face[i] != face[i];
        wrong[1] += t->target.stencil && t->target.stencil[i] != stencil[i];
        wrong[2] += t->target.colour && memcmp(&t->target.colour[3 * i], &colour[3 * i], 6);
    }
    CHECK_MSG(wrong[0] + wrong[1] + wrong[2] == 0, "%s, image %ux%u: %zu faces, %zu stencils, %zu colours of %zu", what,
              t->grid.width, t->grid.height, wrong[0], wrong[1], wrong[2], n);
    free(t->memory);
}

static void draw(struct trial *t, const struct tia_raster_state *s, const struct random_polygon *p, uint32_t id)
{
    CHECK_EQ(tia_raster_draw(&t->target, s, p->v, p->count, id), TIA_OK);
    oracle_draw(&oracle, s, p->v, (int)p->count, id);
}

static int64_t most_of(const struct tia_raster_grid *l, unsigned range)
{
    return ((INT64_C(1) << (l->fraction + (int)range)) - 1) / 40 * 40;
}

/* Puts an orthographic polygon at one of three depths, so that it is often in the plane of another. */
static void make_level(struct random_polygon *p, int64_t most)
{
    int64_t h = random_size(1) * (most / 4);

    for (unsigned i = 0; i < p->count; i++)
        p->v[i].h = p->v[i].w ? h : 0;
}

/* Tests the nearest faces of random polygons in all formats and sizes. */
static void nearest(bool flat, unsigned ranges, int trials)
{
    const struct tia_stencil always = {.test = TIA_COMPARE_ALWAYS};
    const struct tia_raster_state state = {TIA_COMPARE_LESS, .depth_write = true, .front = always, .back = always};
    uint64_t exact = 0;

    for (int i = 0; i < trials; i++) {
        struct trial t = {.flat = flat};
        unsigned range = (unsigned)random_below(ranges);
        begin(&t, TIA_BUFFER_DEPTH, range);
        t.most = most_of(&t.grid, range);
        struct random_polygon p = {.count = 0};
        for (uint32_t id = 0; id < 30; id++) {
            random_polygon(&p, &t.grid, t.area, t.most);
            if (flat && random_below(4) == 0)
                make_level(&p, t.most);
            draw(&t, &state, &p, id);
        }
        exact += t.target.exact;
        compare(&t, flat ? "orthographic" : "perspective");
    }
    CHECK_MSG(exact > 500, "only %ju comparisons were exact", (uintmax_t)exact);
}

TEST(the_nearest_face_in_perspective_is_the_oracles)
{
    nearest(false, TIA_RANGE_MAX + 1, 1500);
}

TEST(the_nearest_face_orthographic_is_the_oracles)
{
    nearest(true, TIA_RANGE_FLAT + 1, 200);
}

TEST(all_states_are_as_opengl_says)
{
    for (int i = 0; i < 600; i++) {
        struct trial t = {.flat = i % 8 == 0};
        unsigned range = (unsigned)random_below(t.flat ? TIA_RANGE_FLAT + 1 : TIA_RANGE_MAX + 1);
        begin(&t, ALL, range);
        t.most = most_of(&t.grid, range);
        struct random_polygon p[20] = {{.count = 0}};
        for (uint32_t id = 0; id < 40; id++) {
            struct tia_raster_state s = random_state_of_all();
            if (id < 20)
                random_polygon(&p[id], &t.grid, t.area, t.most);
            draw(&t, &s, &p[id % 20], id % 20); /* the second time, the polygon is as deep as itself */
        }
        compare(&t, "states");
    }
}

/* Checks the bound that src/raster/depth.h derives, for a run as long as the area is wide, and an allowance of 4 for
 * the oracle's rounding. */
static void check_nearness(const struct trial *t)
{
    for (int y = 0; y < t->area.height; y++)
        for (int x = 0; x < t->area.width; x++) {
            size_t at = (size_t)y * t->area.width + (size_t)x;
            if (t->target.face[at] == TIA_NO_FACE)
                continue;
            long double exact =
                oracle_nearness(&oracle.image, oracle.planes[face[at]], t->area.x + x, t->area.y + y, t->grid.w);
            exact = ldexpl(exact, t->grid.scale) + (t->flat ? 0x1p61L : 0);
            exact = exact < 0 ? 0 : exact > 0x1p62L ? 0x1p62L : exact;
            long double error = fabsl((long double)t->target.nearness[at] - exact);
            CHECK_MSG(error < 2 * t->area.width + 12 + 4, "pixel %d, %d of %ux%u: off by %Lg", x, y, t->grid.width,
                      t->grid.height, error);
        }
}

/* Checks small and steep polygons, from -2^range to 2^range and, `beyond`, to twice that, where nearness is clamped. */
static void check_steep(struct trial *t, unsigned range, unsigned beyond)
{
    const struct tia_stencil always = {.test = TIA_COMPARE_ALWAYS};
    const struct tia_raster_state state = {TIA_COMPARE_LESS, .depth_write = true, .front = always, .back = always};

    begin(t, TIA_BUFFER_DEPTH, range);
    for (uint32_t id = 0; id < 4; id++) {
        struct random_polygon p = {.count = 3};
        int64_t one = INT64_C(1) << t->grid.fraction, most = one << (random_below(2) ? 0 : random_below(range + 1));
        for (int i = 0; i < 3; i++)
            p.v[i] = (struct tia_raster_vertex){random_size(most - 1), random_size(most - 1), one,
                                                random_size(one << (range + beyond))};
        draw(t, &state, &p, id);
    }
    check_nearness(t);
    compare(t, "steep");
}

TEST(orthographic_nearness_errs_by_no_more_where_h_changes_its_sign)
{
    for (unsigned i = 0; i < 600; i++) {
        struct trial t = {.flat = true};
        unsigned range = 1 + (unsigned)random_below(10);
        check_steep(&t, range, range > 2 && i % 2 ? 1 : 0);
    }
}

/* From one pixel to the next h changes almost from -2^range to 2^range, the largest step possible. */
TEST(orthographic_nearness_steps_over_both_signs_at_once)
{
    const struct tia_stencil always = {.test = TIA_COMPARE_ALWAYS};
    const struct tia_raster_state state = {TIA_COMPARE_LESS, .depth_write = true, .front = always, .back = always};

    for (unsigned i = 0; i < 100; i++) {
        struct trial t = {.flat = true};
        begin_image(&t, TIA_BUFFER_DEPTH, 1 + i % 10, (const uint16_t[2]){30, 30}, 1);
        int64_t one = INT64_C(1) << t.grid.fraction, side = one / 30 + one / 999;
        int64_t h = (i & 1 ? one : -one) * (INT64_C(1) << (1 + i % 10));
        const struct random_polygon p = {.v = {{-side, -one + 1, one, -h},
                                               {side, -one + 1, one, h},
                                               {side, one - 1, one, h},
                                               {-side, one - 1, one, -h}},
                                         .count = 4};
        draw(&t, &state, &p, 0);
        check_nearness(&t);
        compare(&t, "a step");
    }
}

/* Two planes are far apart, one before the window and one behind it: the nearer one needs no exact order anywhere. */
TEST(the_filter_tells_orthographic_depths_of_both_signs_apart)
{
    static const int8_t depths[4][2] = {{-8, -7}, {7, 8}, {-8, 8}, {-1, 1}};
    const struct tia_stencil always = {.test = TIA_COMPARE_ALWAYS};
    const struct tia_raster_state state = {TIA_COMPARE_LESS, .depth_write = true, .front = always, .back = always};

    for (unsigned i = 0; i < 8; i++) {
        struct trial t = {.flat = true};
        begin(&t, TIA_BUFFER_DEPTH, 4);
        int64_t one = INT64_C(1) << t.grid.fraction;
        for (uint32_t id = 0; id < 2; id++) {
            int64_t h = depths[i / 2][(id + i) % 2] * one;
            const struct random_polygon p = {
                .v = {{-8 * one, -8 * one, one, h}, {8 * one, -8 * one, one, h}, {0, 8 * one, one, h}}, .count = 3};
            draw(&t, &state, &p, id);
        }
        CHECK_EQ(t.target.exact, 0);
        compare(&t, "far apart");
    }
}

TEST(nearness_errs_by_no_more_than_derived)
{
    const struct tia_stencil always = {.test = TIA_COMPARE_ALWAYS};
    const struct tia_raster_state state = {TIA_COMPARE_LESS, .depth_write = true, .front = always, .back = always};

    for (int i = 0; i < 1000; i++) {
        struct trial t = {.flat = i % 4 == 0};
        unsigned range = (unsigned)random_below(t.flat ? TIA_RANGE_FLAT + 1 : TIA_RANGE_MAX + 1);
        struct random_polygon p = {.count = 0};
        begin(&t, TIA_BUFFER_DEPTH, range);
        t.most = most_of(&t.grid, range);
        for (uint32_t id = 0; id < 8; id++) {
            random_polygon(&p, &t.grid, t.area, t.most);
            draw(&t, &state, &p, id);
        }
        check_nearness(&t);
        compare(&t, "nearness");
    }
}

int main(void)
{
    RUN_LONG(the_nearest_face_in_perspective_is_the_oracles);
    RUN(the_nearest_face_orthographic_is_the_oracles);
    RUN(nearness_errs_by_no_more_than_derived);
    RUN(orthographic_nearness_errs_by_no_more_where_h_changes_its_sign);
    RUN(orthographic_nearness_steps_over_both_signs_at_once);
    RUN(the_filter_tells_orthographic_depths_of_both_signs_apart);
    RUN(all_states_are_as_opengl_says);
    return check_status();
}
