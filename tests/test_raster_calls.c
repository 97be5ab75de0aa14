/* The rasteriser's interface: formats, tiles, extremes, refusals, clearing and sums. */
#include "raster_random.h"

#define ALL (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR)
#define COUNT 30

static const struct tia_stencil untested = {.test = TIA_COMPARE_ALWAYS, .mask = 255, .write = 255};

struct script {
    struct random_polygon polygon[COUNT];
    struct tia_raster_state state[COUNT];
};

static void write_script(struct script *s, const struct tia_raster_grid *l, struct tia_tile area, int64_t most)
{
    struct random_polygon p = {.count = 0};

    for (int i = 0; i < COUNT; i++) {
        random_polygon(&p, l, area, most);
        s->polygon[i] = p;
        s->state[i] = random_state_of_all();
    }
}

static void play(struct tia_raster_target *t, const struct script *s)
{
    for (uint32_t i = 0; i < COUNT; i++)
        CHECK_EQ(tia_raster_draw(t, &s->state[i], s->polygon[i].v, s->polygon[i].count, i), TIA_OK);
}

/* Returns the number of pixels of `part` that differ from those of `whole`. */
static size_t differing(const struct tia_raster_target *part, const struct tia_raster_target *whole)
{
    size_t wrong = 0;

    for (int y = 0; y < part->area.height; y++)
        for (int x = 0; x < part->area.width; x++) {
            size_t a = (size_t)y * part->area.width + (size_t)x;
            size_t b = (size_t)(y + part->area.y - whole->area.y) * whole->area.width +
                       (size_t)(x + part->area.x - whole->area.x);
            int64_t depth = (int64_t)(part->nearness[a] - whole->nearness[b]);
            wrong += part->face[a] != whole->face[b] || part->stencil[a] != whole->stencil[b] ||
                     memcmp(&part->colour[3 * a], &whole->colour[3 * b], 6) != 0 || llabs(depth) > 1 << 16;
        }
    return wrong;
}

/* At 640x480 with range 2 to 5 vertices have 25 bits: most polygons need only 64-bit numbers. */
TEST(both_formats_draw_the_same)
{
    const struct tia_tile area = {300, 200, 100, 80};
    static struct script script;
    void *memory[2];

    for (int i = 0; i < 200; i++) {
        struct tia_raster_grid narrow, wide;
        unsigned range = 2 + (unsigned)random_below(4);
        CHECK_EQ(tia_raster_grid_init(&narrow, TIA_PERSPECTIVE, 640, 480, 1, 0, range), TIA_OK);
        CHECK(narrow.fraction + (int)range == 25 && narrow.narrow > 1 << 24);
        wide = narrow;
        wide.narrow = 0;
        write_script(&script, &narrow, area, narrow.narrow / 2 / 40 * 40);
        struct tia_raster_target a = target_of(&narrow, area, ALL, COUNT, &memory[0]);
        struct tia_raster_target b = target_of(&wide, area, ALL, COUNT, &memory[1]);
        play(&a, &script);
        play(&b, &script);
        CHECK_EQ(differing(&a, &b), 0);
        free(memory[0]);
        free(memory[1]);
    }
}

TEST(tiles_are_parts_of_the_whole)
{
    const struct tia_tile whole = {0, 0, 150, 110};
    static struct script script;
    void *memory[2];

    for (int i = 0; i < 60; i++) {
        struct tia_raster_grid grid;
        CHECK_EQ(tia_raster_grid_init(&grid, i % 5 ? TIA_PERSPECTIVE : TIA_ORTHOGRAPHIC, 150, 110, 1, 0, 5), TIA_OK);
        write_script(&script, &grid, whole, ((INT64_C(1) << (grid.fraction + 5)) - 1) / 40 * 40);
        struct tia_raster_target a = target_of(&grid, whole, ALL, COUNT, &memory[0]);
        play(&a, &script);
        for (uint16_t y = 0; y < 110; y = (uint16_t)(y + 37))
            for (uint16_t x = 0; x < 150; x = (uint16_t)(x + 64)) {
                struct tia_tile area = {x, y, x + 64 < 150 ? 64 : (uint16_t)(150 - x),
                                        y + 37 < 110 ? 37 : (uint16_t)(110 - y)};
                struct tia_raster_target b = target_of(&grid, area, ALL, COUNT, &memory[1]);
                play(&b, &script);
                CHECK_EQ(differing(&b, &a), 0);
                free(memory[1]);
            }
        free(memory[0]);
    }
}

/* The result of ties_by_face does not depend on the order of drawing. */
TEST(ties_by_face_do_not_depend_on_order)
{
    const struct tia_tile area = {0, 0, 60, 40};
    const struct tia_raster_state state = {
        .depth = TIA_COMPARE_LESS, .depth_write = true, .ties_by_face = true, .front = untested, .back = untested};
    static struct script script;
    void *memory[2];
    size_t ties = 0;

    for (int i = 0; i < 100; i++) {
        struct tia_raster_grid grid;
        CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 60, 40, 1, 0, 5), TIA_OK);
        struct tia_raster_target a = target_of(&grid, area, ALL, COUNT, &memory[0]);
        struct tia_raster_target b = target_of(&grid, area, ALL, COUNT, &memory[1]);
        write_script(&script, &grid, area, (INT64_C(1) << 22) / 40 * 40);
        for (uint32_t k = 0; k < COUNT; k++) {
            if (k % 2) /* in the plane of the one before */
                script.polygon[k] = script.polygon[k - 1];
            script.state[k] = state;
        }
        play(&a, &script);
        for (uint32_t k = COUNT; k-- > 0;)
            CHECK_EQ(tia_raster_draw(&b, &state, script.polygon[k].v, script.polygon[k].count, k), TIA_OK);
        CHECK_EQ(differing(&a, &b), 0);
        for (size_t k = 0; k < 2400; k++)
            ties += a.face[k] != TIA_NO_FACE && a.face[k] % 2;
        free(memory[0]);
        free(memory[1]);
    }
    CHECK_EQ(ties, 0);
}

static struct tia_raster_vertex centre(const struct tia_raster_grid *l, int i, int j, int times)
{
    return (struct tia_raster_vertex){(l->x + i * l->right) * times, (l->y - j * l->down) * times, l->w * times, 1};
}

/* Draws two triangles with a common edge through centres of pixels, where they are equally far: the one that is nearer
 * beside the edge, below or to the right of it, is visible there too. */
static void draw_hinge(bool level, bool far_first)
{
    const struct tia_tile area = {0, 0, 8, 8};
    const struct tia_raster_state state = {
        .depth = TIA_COMPARE_LESS, .depth_write = true, .front = untested, .back = untested};
    struct tia_raster_grid l;
    void *memory;

    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8, 1, 0, 5), TIA_OK);
    struct tia_raster_target t = target_of(&l, area, TIA_BUFFER_DEPTH, 2, &memory);
    for (uint32_t k = 0; k < 2; k++) {
        bool far = (k == 0) == far_first;
        struct tia_raster_vertex tip = centre(&l, level ? 3 : 7, level ? 7 : 3, far ? 8 : 2);
        struct tia_raster_vertex v[3] = {centre(&l, level ? 1 : 2, level ? 2 : 1, 4),
                                         centre(&l, level ? 6 : 2, level ? 2 : 6, 4), tip};
        CHECK_EQ(tia_raster_draw(&t, &state, v, 3, far ? 0 : 1), TIA_OK);
    }
    for (int k = 2; k < 6; k++)
        CHECK_EQ(t.face[level ? 2 * 8 + k : k * 8 + 2], 1);
    free(memory);
}

TEST(hinges_are_seen_as_beside_the_edge)
{
    for (int i = 0; i < 4; i++)
        draw_hinge(i & 1, i & 2);
}

/* Draws every vertex at its bounds, everywhere in the largest image: with -fsanitize=undefined no operation may
 * overflow. */
static void draw_extremes(enum tia_projection projection, const uint16_t size[2])
{
    const struct tia_tile area = {(uint16_t)(size[0] - 5), (uint16_t)(size[1] - 3), 5, 3};
    struct tia_raster_state state = {
        .depth = TIA_COMPARE_LESS, .depth_write = true, .front = untested, .back = untested};
    struct oracle_image image = {projection, size[0], size[1], 16, 15};
    struct tia_raster_grid grid;
    void *memory;
    size_t wrong = 0;

    CHECK_EQ(tia_raster_grid_init(&grid, projection, size[0], size[1], 16, 15, 3), TIA_OK);
    struct tia_raster_target t = target_of(&grid, area, TIA_BUFFER_DEPTH, 8, &memory);
    for (int i = 0; i < 3000; i++) {
        bool flat = projection == TIA_ORTHOGRAPHIC;
        int64_t limit = (INT64_C(1) << (flat ? 29 : 40)) - 1;
        struct tia_raster_vertex v[3];
        for (int k = 0; k < 3; k++) {
            bool direction = random_below(3) == 0;
            int64_t own = direction ? 2 * limit + 1 : limit;
            if (random_below(3) == 0 && !flat && !direction)
                own = grid.narrow;
            v[k] = (struct tia_raster_vertex){random_size(1) * own, random_size(1) * own, random_size(1) * own,
                                              !direction};
            if (flat)
                v[k].w = direction ? 0 : limit;
            if (flat)
                v[k].h = random_size(1) * (limit + 1) * 2;
        }
        tia_raster_clear_depth(&t);
        CHECK_EQ(tia_raster_draw(&t, &state, v, 3, (uint32_t)i % 8), TIA_OK);
        for (int y = 0; y < 3; y++)
            for (int x = 0; x < 5; x++)
                wrong += oracle_covers(&image, v, 3, area.x + x, area.y + y) != (t.face[5 * y + x] != TIA_NO_FACE);
    }
    CHECK_EQ(wrong, 0);
    free(memory);
}

TEST(extremes_fit)
{
    static const uint16_t sizes[3][2] = {{8192, 8191}, {8192, 5}, {5, 8192}};

    for (int i = 0; i < 3; i++) {
        draw_extremes(TIA_PERSPECTIVE, sizes[i]);
        draw_extremes(TIA_ORTHOGRAPHIC, sizes[i]);
    }
}

TEST(what_is_out_of_range_is_refused)
{
    const struct tia_tile area = {0, 0, 8, 8}, beyond = {1, 0, 8, 8}, empty = {0, 0, 0, 8};
    const struct tia_raster_vertex good[3] = {{-9, -9, 9, 1}, {9, -9, 9, 1}, {0, 9, 9, 1}};
    struct tia_raster_state state = {.depth = TIA_COMPARE_LESS, .depth_write = true};
    struct tia_raster_grid l;
    struct tia_raster_target t;
    uint64_t memory[600];

    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 0, 8, 1, 0, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8193, 1, 0, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8, 2, 0, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8, 4, 4, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_ORTHOGRAPHIC, 8, 8, 1, 0, 21), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_ORTHOGRAPHIC, 8, 8, 1, 0, 20), TIA_OK);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8, 1, 0, 25), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 8, 8, 1, 0, 24), TIA_OK);
    CHECK_EQ(tia_raster_init(&t, memory, sizeof memory, &l, beyond, ALL, 8), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_init(&t, memory, sizeof memory, &l, empty, ALL, 8), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_init(&t, memory, sizeof memory, &l, area, TIA_BUFFER_SUM, 8), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_init(&t, memory, tia_raster_size(area, ALL, 8) - 1, &l, area, ALL, 8), TIA_ERR_MEMORY);
    CHECK_EQ(tia_raster_init(&t, memory, tia_raster_size(area, ALL, 8), &l, area, ALL, 8), TIA_OK);
    CHECK_EQ(tia_raster_draw(&t, &state, good, 2, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_draw(&t, &state, good, 9, 0), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_draw(&t, &state, good, 3, 8), TIA_ERR_ARGUMENT);
    CHECK_EQ(tia_raster_draw(&t, &state, good, 3, 7), TIA_OK);
    for (int i = 0; i < 8; i++) {
        struct tia_raster_vertex v[3] = {good[0], good[1], good[2]};
        int64_t *number[4] = {&v[1].x, &v[1].y, &v[1].w, &v[1].h}, limit = INT64_C(1) << 40;
        *number[i % 4] = (i % 4 == 3 ? 2 : limit) * (i < 4 ? 1 : -1);
        CHECK_EQ(tia_raster_draw(&t, &state, v, 3, 0), TIA_ERR_RANGE);
        *number[i % 4] = i % 4 == 3 ? 1 : (limit - 1) * (i < 4 ? 1 : -1);
        CHECK_EQ(tia_raster_draw(&t, &state, v, 3, 0), TIA_OK);
    }
}

/* A triangle fills the image, and is added with three weights. */
TEST(sums_are_means_of_what_was_drawn)
{
    const struct tia_tile area = {0, 0, 3, 2};
    const struct tia_raster_vertex v[3] = {{-90, -90, 9, 1}, {90, -90, 9, 1}, {0, 90, 9, 1}};
    struct tia_raster_state state = {.depth = TIA_COMPARE_ALWAYS, .colour_write = {true, true, false}};
    static const uint16_t colour[3][3] = {{65535, 7, 9}, {1, 8, 9}, {0, 9, 9}}, grey[3] = {5, 5, 5};
    static const uint32_t weight[3] = {65534, 1, 1};
    struct tia_raster_grid l;
    void *memory;

    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 3, 2, 1, 0, 5), TIA_OK);
    struct tia_raster_target t = target_of(&l, area, TIA_BUFFER_COLOUR | TIA_BUFFER_SUM, 0, &memory);
    tia_raster_clear_colour(&t, grey);
    for (int i = 0; i < 3; i++) {
        memcpy(state.colour, colour[i], sizeof state.colour);
        CHECK_EQ(tia_raster_draw(&t, &state, v, 3, TIA_NO_FACE), TIA_OK);
        tia_raster_sum_add(&t, weight[i]);
    }
    tia_raster_sum_return(&t, 65536);
    for (size_t i = 0; i < 6; i++) { /* 65534 * 65535 + 1 of 65536 is 65533.00005, 65534 * 7 + 17 is 7.00005 */
        CHECK_EQ(t.colour[3 * i], 65533);
        CHECK_EQ(t.colour[3 * i + 1], 7);
        CHECK_EQ(t.colour[3 * i + 2], 5);
    }
    tia_raster_clear_sum(&t);
    tia_raster_sum_add(&t, 3); /* 3 * 5 of 2 is 7.5 */
    tia_raster_sum_return(&t, 2);
    CHECK_EQ(t.colour[2], 8);
    free(memory);
}

TEST(clearing_a_stencil_keeps_masked_bits)
{
    const struct tia_tile area = {0, 0, 3, 2};
    struct tia_raster_grid l;
    void *memory;

    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 3, 2, 1, 0, 5), TIA_OK);
    struct tia_raster_target t = target_of(&l, area, TIA_BUFFER_STENCIL, 0, &memory);
    tia_raster_clear_stencil(&t, 0xa5, 0xff);
    tia_raster_clear_stencil(&t, 0x3c, 0x0f);
    for (size_t i = 0; i < 6; i++)
        CHECK_EQ(t.stencil[i], 0xac);
    free(memory);
}

/* Polygons that cover everything count 300 times up, once down: by the general code and by that for counting alone. */
TEST(counts_do_not_wrap_as_the_stencil_does)
{
    static const struct tia_raster_vertex all[3] = {{-400, -400, 100, 1}, {400, -400, 100, 1}, {0, 800, 100, 1}};
    const struct tia_tile area = {0, 0, 3, 2};
    struct tia_raster_state up = {.depth = TIA_COMPARE_LESS, .front = untested, .back = untested}, down = up;
    struct tia_raster_grid l;

    up.front.zpass = up.back.zpass = TIA_STENCIL_INCR_WRAP;
    down.front.zpass = down.back.zpass = TIA_STENCIL_DECR_WRAP;
    CHECK_EQ(tia_raster_grid_init(&l, TIA_PERSPECTIVE, 3, 2, 1, 0, 5), TIA_OK);
    for (unsigned also = 0; also <= TIA_BUFFER_STENCIL; also += TIA_BUFFER_STENCIL) {
        void *memory;
        struct tia_raster_target t = target_of(&l, area, TIA_BUFFER_DEPTH | TIA_BUFFER_COUNT | also, 1, &memory);
        tia_raster_clear_count(&t, 1000000);
        for (int n = 0; n < 301; n++)
            CHECK_EQ(tia_raster_draw(&t, n < 300 ? &up : &down, all, 3, TIA_NO_FACE), TIA_OK);
        for (size_t i = 0; i < 6; i++) {
            CHECK_EQ(t.count[i], 1000299);
            CHECK(!also || t.stencil[i] == 299 - 256);
        }
        free(memory);
    }
}

/* With the edge for the part ahead of the window, eight corners make nine edges; those between equal corners have no
 * effect. */
TEST(the_most_corners_and_an_edge_ahead)
{
    const struct tia_tile areas[2] = {{0, 0, 65, 65}, {0, 0, 7, 7}};
    const struct tia_raster_state state = {.depth = TIA_COMPARE_LESS, .depth_write = true, .ahead = true};
    struct tia_raster_grid l;

    CHECK_EQ(tia_raster_grid_init(&l, TIA_ORTHOGRAPHIC, 65, 65, 1, 0, 1), TIA_OK);
    int64_t one = INT64_C(1) << l.fraction;
    const struct tia_raster_vertex a = {-one / 2, -500, one, -5}, b = {one / 2, -500, one, -5}, c = {0, 1000, one, -5};
    const struct tia_raster_vertex corners[8] = {a, b, c, c, c, c, c, c};
    for (int i = 0; i < 2; i++) {
        void *memory[2];
        struct tia_raster_target few = target_of(&l, areas[i], TIA_BUFFER_DEPTH, 1, &memory[0]);
        struct tia_raster_target many = target_of(&l, areas[i], TIA_BUFFER_DEPTH, 1, &memory[1]);
        CHECK_EQ(tia_raster_draw(&few, &state, corners, 3, 0), TIA_OK);
        CHECK_EQ(tia_raster_draw(&many, &state, corners, 8, 0), TIA_OK);
        CHECK(!memcmp(few.face, many.face, areas[i].width * areas[i].height * sizeof *few.face));
        free(memory[0]);
        free(memory[1]);
    }
}

int main(void)
{
    RUN(both_formats_draw_the_same);
    RUN(tiles_are_parts_of_the_whole);
    RUN(ties_by_face_do_not_depend_on_order);
    RUN(hinges_are_seen_as_beside_the_edge);
    RUN(extremes_fit);
    RUN(what_is_out_of_range_is_refused);
    RUN(sums_are_means_of_what_was_drawn);
    RUN(clearing_a_stencil_keeps_masked_bits);
    RUN(counts_do_not_wrap_as_the_stencil_does);
    RUN(the_most_corners_and_an_edge_ahead);
    return check_status();
}
