/* The rasteriser without 128-bit integers, as on 32-bit machines, against the library's: the same bits. */
#define TIA_NO_INT128
#define tia_polygon_init halves_polygon_init
#define tia_polygon_init_enlarged halves_polygon_init_enlarged
#define tia_polygon_has_range halves_polygon_has_range
#define tia_polygon_box halves_polygon_box
#define tia_polygon_rows halves_polygon_rows
#define tia_depth_scale_init halves_depth_scale_init
#define tia_depth_run halves_depth_run
#define tia_depth_part halves_depth_part
#define tia_depth_at halves_depth_at
#define tia_depth_plane halves_depth_plane
#define tia_depth_order halves_depth_order
#define tia_raster_draw halves_raster_draw
#define tia_raster_corners_init halves_raster_corners_init
#define tia_raster_corners_blend halves_raster_corners_blend
#define tia_polygon_cut_ahead halves_polygon_cut_ahead
#define tia_raster_plane_init halves_raster_plane_init
#include "raster/depth.c"
#include "raster/polygon.c"
#include "raster/polygon_box.c"
#include "raster/polygon_rows.c"
#include "raster/raster_draw.c"
#undef UNSURE
#include "raster/blend.c"
#undef tia_raster_draw
#undef tia_raster_corners_init
#undef tia_raster_corners_blend
int tia_raster_draw(struct tia_raster_target *, const struct tia_raster_state *, const struct tia_raster_vertex *,
                    unsigned, uint32_t);
bool tia_raster_corners_init(struct tia_raster_corners *, const struct tia_raster_grid *,
                             const struct tia_raster_vertex[3]);
tia_q16 tia_raster_corners_blend(const struct tia_raster_corners *, int, int, const tia_q16[3]);

#include "raster_random.h"

_Static_assert(!TIA_INT128, "128-bit integers are used all the same");

#define FACES 40
#define ALL (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR)

static void compare(enum tia_projection projection, unsigned range)
{
    const struct tia_tile area = {13, 200, 90, 70};
    struct tia_raster_grid grid;
    struct random_polygon p = {.count = 0};
    void *memory[2];

    CHECK_EQ(tia_raster_grid_init(&grid, projection, 640, 480, 4, (uint32_t)random_below(4), range), TIA_OK);
    int64_t most = ((INT64_C(1) << (grid.fraction + (int)range)) - 1) / 40 * 40;
    struct tia_raster_target a = target_of(&grid, area, ALL, FACES, &memory[0]), b = a;
    size_t size = tia_raster_size(area, ALL, FACES);
    memory[1] = allocated(size);
    CHECK_EQ(tia_raster_init(&b, memory[1], size, &grid, area, ALL, FACES), TIA_OK);
    for (uint32_t id = 0; id < FACES; id++) {
        struct tia_raster_state s = random_state_of_all();
        random_polygon(&p, &grid, area, most);
        CHECK_EQ(tia_raster_draw(&a, &s, p.v, p.count, id), halves_raster_draw(&b, &s, p.v, p.count, id));
    }
    CHECK(memcmp(memory[0], memory[1], size) == 0);
    CHECK_EQ(a.exact, b.exact);
    free(memory[0]);
    free(memory[1]);
}

TEST(buffers_are_the_same)
{
    for (int i = 0; i < 300; i++)
        if (i % 4)
            compare(TIA_PERSPECTIVE, (unsigned)random_below(TIA_RANGE_MAX + 1));
        else
            compare(TIA_ORTHOGRAPHIC, (unsigned)random_below(TIA_RANGE_FLAT + 1));
}

TEST(values_are_the_same)
{
    for (int i = 0; i < 3000; i++) {
        const struct tia_tile area = {0, 0, 640, 480};
        struct tia_raster_grid grid;
        struct random_polygon p = {.count = 0};
        struct tia_raster_corners corners[2];
        const tia_q16 a[3] = {(tia_q16)random_bits(), (tia_q16)random_size(9), (tia_q16)random_bits()};
        int x = (int)random_below(640), y = (int)random_below(480);
        CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 640, 480, 1, 0, 0), TIA_OK);
        random_polygon(&p, &grid, area, (INT64_C(1) << 25) / 40 * 40);
        bool seen = tia_raster_corners_init(&corners[0], &grid, p.v);
        CHECK_EQ(halves_raster_corners_init(&corners[1], &grid, p.v), seen);
        CHECK(memcmp(&corners[0], &corners[1], sizeof corners[0]) == 0);
        CHECK_EQ(halves_raster_corners_blend(&corners[1], x, y, a), tia_raster_corners_blend(&corners[0], x, y, a));
    }
}

int main(void)
{
    RUN(buffers_are_the_same);
    RUN(values_are_the_same);
    return check_status();
}
