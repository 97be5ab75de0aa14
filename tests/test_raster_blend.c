/* Interpolation against the oracle's exact quotients. */
#include "raster_random.h"

/* Makes large or small values; means of small ones are sometimes halves. */
static void random_values(tia_q16 a[3])
{
    for (int i = 0; i < 3; i++)
        a[i] = (tia_q16)(random_below(3) ? random_size(9) : (int64_t)(int32_t)random_u32());
}

static int wrong, tried;

static void try_values(const struct oracle_image *image, const struct tia_raster_corners *corners,
                       const struct tia_raster_vertex v[3], int x, int y, const tia_q16 a[3])
{
    wrong += tia_raster_corners_blend(corners, x, y, a) != oracle_blend(image, v, x, y, a);
    tried++;
}

static void try_pixel(const struct oracle_image *image, const struct tia_raster_corners *corners,
                      const struct tia_raster_vertex v[3], int x, int y)
{
    tia_q16 a[3];

    random_values(a);
    try_values(image, corners, v, x, y, a);
}

/* Tests pixels with the plane in front of the eye, in the triangle or far outside it, where the weights cancel. */
static void try_polygons(enum tia_projection projection, unsigned range)
{
    struct oracle_image image = {projection, 40, 30, 16, (int)random_below(16)};
    const struct tia_tile all = {0, 0, 40, 30};
    struct tia_raster_grid grid;
    struct random_polygon p = {.count = 0};
    struct tia_raster_corners corners;

    CHECK_EQ(tia_raster_grid_init(&grid, projection, 40, 30, 16, (uint32_t)image.sample, range), TIA_OK);
    int64_t most = ((INT64_C(1) << (grid.fraction + (int)range)) - 1) / 40 * 40;
    random_polygon(&p, &grid, all, most);
    if (!tia_raster_corners_init(&corners, &grid, p.v))
        return;
    for (int i = 0; i < 40; i++) {
        int x = (int)random_below(40), y = (int)random_below(30);
        bool seen = projection == TIA_ORTHOGRAPHIC ? oracle_covers(&image, p.v, (int)p.count, x, y)
                                                   : oracle_nearness(&image, p.v, x, y, 1) > 0;
        if (seen)
            try_pixel(&image, &corners, p.v, x, y);
    }
}

TEST(values_are_rounded_to_nearest)
{
    for (int i = 0; i < 6000; i++)
        if (i % 3)
            try_polygons(TIA_PERSPECTIVE, (unsigned)random_below(TIA_RANGE_MAX + 1));
        else
            try_polygons(TIA_ORTHOGRAPHIC, (unsigned)random_below(TIA_RANGE_FLAT + 1));
    CHECK_MSG(wrong == 0 && tried > 5000, "%d of %d are wrong", wrong, tried);
}

/* Pixels far beside small triangles that are seen almost edge-on: values are far out of range, at either end. */
TEST(values_beyond_the_range_are_clamped_at_the_right_end)
{
    const struct oracle_image image = {TIA_PERSPECTIVE, 640, 480, 1, 0};
    struct tia_raster_grid grid;
    struct tia_raster_corners corners;

    wrong = tried = 0;
    CHECK_EQ(tia_raster_grid_init(&grid, image.projection, 640, 480, 1, 0, 3), TIA_OK);
    for (int n = 0; n < 20000; n++) {
        struct tia_raster_vertex v[3];
        int64_t far = 1000 + random_below(1000);
        for (int i = 0; i < 3; i++)
            v[i] = (struct tia_raster_vertex){random_size(100), random_size(2), far + random_below(200), 1};
        int x = (int)random_below(640), y = 200 + (int)random_below(80);
        if (tia_raster_corners_init(&corners, &grid, v) && oracle_nearness(&image, v, x, y, 1) > 0)
            try_pixel(&image, &corners, v, x, y);
    }
    CHECK_MSG(wrong == 0 && tried > 5000, "%d of %d are wrong", wrong, tried);
}

/* The side between two corners is almost in the pixel's direction, so the weights are large and their sum is small: the
 * bits cut off would change values that differ by little by more than half. */
TEST(thin_sums_are_exact)
{
    const struct oracle_image image = {TIA_PERSPECTIVE, 640, 480, 1, 0};
    const int64_t most = INT64_C(1) << 37;
    struct tia_raster_grid l;
    struct tia_raster_corners corners;

    wrong = tried = 0;
    CHECK_EQ(tia_raster_grid_init(&l, image.projection, 640, 480, 1, 0, 20), TIA_OK);
    for (int n = 0; n < 4000; n++) {
        int x = (int)random_below(640), y = (int)random_below(480);
        int64_t k = random_size(1 << 25), off = INT64_C(1) << random_below(24);
        tia_q16 base = (tia_q16)random_size(1 << 30), a[3];
        struct tia_raster_vertex v[3];
        for (int i = 0; i < 3; i++) {
            v[i] = (struct tia_raster_vertex){random_size(most), random_size(most), random_size(most), 1};
            a[i] = base + (tia_q16)random_size(9);
        }
        v[1].x = v[0].x + k * (l.x + x * (int64_t)l.right) + random_size(off);
        v[1].y = v[0].y + k * (l.y - y * (int64_t)l.down) + random_size(off);
        v[1].w = v[0].w + k * l.w + random_size(off);
        if (tia_raster_corners_init(&corners, &l, v) && oracle_nearness(&image, v, x, y, 1) > 0)
            try_values(&image, &corners, v, x, y, a);
    }
    CHECK_MSG(wrong == 0 && tried > 1500, "%d of %d are wrong", wrong, tried);
}

/* The middle of the image shows the point at a quarter of the way from one corner to another. */
TEST(means_are_those_of_space_not_of_the_image)
{
    const struct tia_raster_vertex v[3] = {{-400, 0, 400, 1}, {1200, 0, 1200, 1}, {0, 4000, 0, 1}};
    const tia_q16 a[3] = {0, 4000, 0};
    struct tia_raster_grid grid;
    struct tia_raster_corners corners;

    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 1, 1, 1, 0, 0), TIA_OK);
    CHECK(tia_raster_corners_init(&corners, &grid, v));
    CHECK_EQ(tia_raster_corners_blend(&corners, 0, 0, a), 1000);
}

TEST(halves_are_rounded_up)
{
    const struct tia_raster_vertex v[3] = {{-400, 0, 400, 1}, {400, 0, 400, 1}, {0, 4000, 0, 1}};
    const tia_q16 a[4][3] = {{3, 4, 0}, {-3, -4, 0}, {INT32_MAX, INT32_MAX - 1, 0}, {INT32_MIN, INT32_MIN + 1, 0}};
    const tia_q16 wanted[4] = {4, -3, INT32_MAX, INT32_MIN + 1};
    struct tia_raster_grid grid;
    struct tia_raster_corners corners;

    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 1, 1, 1, 0, 0), TIA_OK);
    CHECK(tia_raster_corners_init(&corners, &grid, v));
    for (int i = 0; i < 4; i++)
        CHECK_EQ(tia_raster_corners_blend(&corners, 0, 0, a[i]), wanted[i]);
}

/* The middle of the image is 2.5 10^-7 of the edge away from the edge's middle. */
TEST(almost_halves_are_not_taken_for_halves)
{
    const struct tia_raster_vertex v[3] = {{-1000000, 0, 4, 1}, {1000001, 0, 4, 1}, {0, 4000, 0, 1}};
    const tia_q16 a[3] = {7, 8, 0}, b[3] = {8, 7, 0};
    struct tia_raster_grid grid;
    struct tia_raster_corners corners;

    CHECK_EQ(tia_raster_grid_init(&grid, TIA_PERSPECTIVE, 1, 1, 1, 0, 0), TIA_OK);
    CHECK(tia_raster_corners_init(&corners, &grid, v));
    CHECK_EQ(tia_raster_corners_blend(&corners, 0, 0, a), 7);
    CHECK_EQ(tia_raster_corners_blend(&corners, 0, 0, b), 8);
}

int main(void)
{
    RUN(values_are_rounded_to_nearest);
    RUN(values_beyond_the_range_are_clamped_at_the_right_end);
    RUN(thin_sums_are_exact);
    RUN(halves_are_rounded_up);
    RUN(almost_halves_are_not_taken_for_halves);
    RUN(means_are_those_of_space_not_of_the_image);
    return check_status();
}
