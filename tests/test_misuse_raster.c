/* Misuse of the rasteriser: grids, targets, planes, polygons, buffers and interpolation. */
#include <limits.h>

#include <tia/raster.h>

#include "misuse.h"
#include "raster/distance.h"
#include "raster/target.h"

#define TILE(x, y, w, h) ((struct tia_tile){x, y, w, h})
#define ALL_BUFFERS (TIA_BUFFER_DEPTH | TIA_BUFFER_STENCIL | TIA_BUFFER_COLOUR | TIA_BUFFER_SUM | TIA_BUFFER_COUNT)

enum { SIZE = 8, FACES = 4 };

static const struct tia_tile frame = {0, 0, SIZE, SIZE};
static const struct tia_raster_vertex triangle[9] = {
    {-(1 << 20), -(1 << 20), 1 << 20, 1}, {1 << 20, -(1 << 20), 1 << 20, 1}, {0, 1 << 20, 1 << 20, 1}};
static const struct tia_raster_state nearest = {.depth = TIA_COMPARE_LESS, .depth_write = true};
static const uint16_t white[3] = {1, 2, 3};

static uint64_t memory[1000];
static struct tia_raster_grid grid;
static struct tia_raster_target target, bare;
static struct tia_raster_plane plane;

static void prepare(void)
{
    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, SIZE, 1, 0, 5), TIA_OK);
    CHECK_EQ(tia_raster_init(&target, memory, sizeof memory, &grid, frame, ALL_BUFFERS, FACES), TIA_OK);
    CHECK_EQ(tia_raster_init(&bare, NULL, 0, &grid, frame, 0, 0), TIA_OK);
    CHECK_EQ(tia_raster_plane_init(&plane, &grid, triangle, 3), TIA_OK);
}

TEST(misuse_of_lattices)
{
    REFUSES(tia_raster_grid_init(NULL, TIA_PERSPECTIVE, SIZE, SIZE, 1, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, (enum tia_projection)9, SIZE, SIZE, 1, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, (enum tia_projection) - 1, SIZE, SIZE, 1, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 0, SIZE, 1, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, TIA_SIZE_MAX + 1, 1, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, SIZE, 3, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, SIZE, 0, 0, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, SIZE, 4, 4, 5));
    REFUSES(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, SIZE, SIZE, 1, 0, 25));
    misuse_end();
}

TEST(misuse_of_targets)
{
    struct tia_raster_target made;
    size_t need = tia_raster_size(frame, ALL_BUFFERS, FACES), size = sizeof memory;

    prepare();
    REFUSES(tia_raster_init(NULL, memory, size, &grid, frame, ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, NULL, size, &grid, frame, ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, MISALIGNED(memory), size - 8, &grid, frame, ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, memory, size, NULL, frame, ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, TILE(4, 4, 8, 8), ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, TILE(65535, 0, 2, 2), ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, TILE(0, 0, 0, 2), ALL_BUFFERS, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, frame, TIA_BUFFER_SUM, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, frame, 32, FACES));
    REFUSES(tia_raster_init(&made, memory, size, &grid, frame, UINT_MAX, FACES));
    GIVES(TIA_ERR_MEMORY, tia_raster_init(&made, memory, need - 1, &grid, frame, ALL_BUFFERS, FACES));
    GIVES(TIA_ERR_MEMORY, tia_raster_init(&made, memory, size, &grid, frame, ALL_BUFFERS, UINT32_MAX));
    GIVES(1, tia_raster_size(TILE(0, 0, 65535, 65535), ALL_BUFFERS, UINT32_MAX) > UINT32_MAX);
    REFUSES(tia_raster_part(NULL, &target, frame));
    REFUSES(tia_raster_part(&made, NULL, frame));
    REFUSES(tia_raster_part(&made, &target, TILE(5, 5, 5, 5)));
    REFUSES(tia_raster_part(&made, &target, TILE(65535, 65535, 9, 9)));
    REFUSES(tia_raster_part(&made, &target, TILE(0, 0, 0, 0)));
    misuse_end();
}

TEST(misuse_of_planes)
{
    struct tia_raster_vertex far[3] = {triangle[0], triangle[1], triangle[2]};

    prepare();
    far[1].x = INT64_MIN;
    REFUSES(tia_raster_plane_init(NULL, &grid, triangle, 3));
    REFUSES(tia_raster_plane_init(&plane, NULL, triangle, 3));
    REFUSES(tia_raster_plane_init(&plane, &grid, NULL, 3));
    REFUSES(tia_raster_plane_init(&plane, &grid, triangle, 2));
    REFUSES(tia_raster_plane_init(&plane, &grid, triangle, 9));
    REFUSES(tia_raster_plane_init(&plane, &grid, triangle, UINT_MAX));
    GIVES(TIA_ERR_RANGE, tia_raster_plane_init(&plane, &grid, far, 3));
    GIVES(0, tia_raster_distance(NULL, &grid, 1, 1));
    GIVES(0, tia_raster_distance(&plane, NULL, 1, 1));
    GIVES(0, tia_raster_distance(&plane, &grid, INT_MAX, INT_MIN));
    GIVES(0, tia_raster_distance(&plane, &grid, INT_MIN, INT_MAX));
    GIVES(0, tia_raster_distance(&plane, &grid, SIZE, 0));
    GIVES(0, tia_raster_distance(&plane, &grid, 0, -1));
    GIVES(1, tia_raster_distance(&plane, &grid, 4, 4) > 0);
    misuse_end();
}

static int draw(struct tia_raster_state state)
{
    return tia_raster_draw(&target, &state, triangle, 3, 0);
}

#define STATE(...) ((struct tia_raster_state){.depth_write = true, __VA_ARGS__})

TEST(misuse_of_polygons)
{
    struct tia_raster_vertex far[3] = {triangle[0], triangle[1], triangle[2]}, high[3];

    prepare();
    memcpy(high, far, sizeof high);
    far[0].x = INT64_MAX;
    high[0].h = 99;
    REFUSES(tia_raster_draw(NULL, &nearest, triangle, 3, 0));
    REFUSES(tia_raster_draw(&target, NULL, triangle, 3, 0));
    REFUSES(tia_raster_draw(&target, &nearest, NULL, 3, 0));
    REFUSES(tia_raster_draw(&target, &nearest, triangle, 0, 0));
    REFUSES(tia_raster_draw(&target, &nearest, triangle, 2, 0));
    REFUSES(tia_raster_draw(&target, &nearest, triangle, 9, 0));
    REFUSES(tia_raster_draw(&target, &nearest, triangle, 3, FACES));
    REFUSES(tia_raster_draw(&target, &nearest, triangle, 3, TIA_NO_FACE));
    REFUSES(draw(STATE(.depth = (enum tia_compare)99)));
    REFUSES(draw(STATE(.depth = (enum tia_compare) - 1)));
    REFUSES(draw(STATE(.front.test = (enum tia_compare)8)));
    REFUSES(draw(STATE(.front.fail = (enum tia_stencil_op)8)));
    REFUSES(draw(STATE(.front.zfail = (enum tia_stencil_op)99)));
    REFUSES(draw(STATE(.front.zpass = (enum tia_stencil_op)99)));
    REFUSES(draw(STATE(.back.test = (enum tia_compare)99)));
    REFUSES(draw(STATE(.back.fail = (enum tia_stencil_op)99)));
    REFUSES(draw(STATE(.back.zfail = (enum tia_stencil_op)99)));
    REFUSES(draw(STATE(.back.zpass = (enum tia_stencil_op) - 1)));
    GIVES(TIA_ERR_RANGE, tia_raster_draw(&target, &nearest, far, 3, 0));
    GIVES(TIA_ERR_RANGE, tia_raster_draw(&target, &nearest, high, 3, 0));
    GIVES(TIA_OK, tia_raster_draw(&bare, &nearest, triangle, 3, TIA_NO_FACE)); /* the target has no depth to write */
    GIVES(TIA_OK, draw(nearest));
    misuse_end();
}

TEST(misuse_of_buffers)
{
    prepare();
    REFUSES(tia_raster_clear_depth(NULL));
    REFUSES(tia_raster_clear_stencil(NULL, 0, 255));
    REFUSES(tia_raster_clear_count(NULL, 0));
    REFUSES(tia_raster_clear_colour(NULL, white));
    REFUSES(tia_raster_clear_colour(&target, NULL));
    REFUSES(tia_raster_clear_sum(NULL));
    REFUSES(tia_raster_sum_add(NULL, 1));
    REFUSES(tia_raster_sum_add(&target, 65537));
    REFUSES(tia_raster_sum_add(&target, UINT32_MAX));
    REFUSES(tia_raster_sum_return(NULL, 1));
    REFUSES(tia_raster_sum_return(&target, 0));
    REFUSES(tia_raster_sum_return(&target, 65537));
    GIVES(TIA_OK, tia_raster_sum_return(&target, 65536));
    GIVES(TIA_OK, tia_raster_clear_depth(&bare) | tia_raster_clear_stencil(&bare, 1, 1) |
                      tia_raster_clear_count(&bare, 1) | tia_raster_clear_colour(&bare, white) |
                      tia_raster_clear_sum(&bare) | tia_raster_sum_add(&bare, 1) | tia_raster_sum_return(&bare, 1));
    misuse_end();
}

TEST(misuse_of_interpolation)
{
    const tia_q16 values[3] = {INT32_MAX, INT32_MIN, 0}, ones[3] = {7, 7, 7};
    struct tia_raster_vertex far[3] = {triangle[0], triangle[1], triangle[2]};
    struct tia_raster_corners corners, made;

    prepare();
    far[2].y = INT64_MIN;
    CHECK(tia_raster_corners_init(&corners, &grid, triangle));
    GIVES(0, tia_raster_corners_init(NULL, &grid, triangle));
    GIVES(0, tia_raster_corners_init(&made, NULL, triangle));
    GIVES(0, tia_raster_corners_init(&made, &grid, NULL));
    GIVES(0, tia_raster_corners_init(&made, &grid, far));
    GIVES(0, tia_raster_corners_blend(NULL, 1, 1, ones));
    GIVES(0, tia_raster_corners_blend(&corners, 1, 1, NULL));
    GIVES(0, tia_raster_corners_blend(&corners, INT_MAX, INT_MIN, values));
    GIVES(0, tia_raster_corners_blend(&corners, INT_MAX, INT_MAX, ones));
    GIVES(0, tia_raster_corners_blend(&corners, -1, 0, ones));
    GIVES(0, tia_raster_corners_blend(&corners, 0, TIA_SIZE_MAX, ones));
    GIVES(7, tia_raster_corners_blend(&corners, 4, 4, ones));
    misuse_end();
}

int main(void)
{
    RUN(misuse_of_lattices);
    RUN(misuse_of_targets);
    RUN(misuse_of_planes);
    RUN(misuse_of_polygons);
    RUN(misuse_of_buffers);
    RUN(misuse_of_interpolation);
    return check_status();
}
