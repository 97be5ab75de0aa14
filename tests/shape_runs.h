/* shape_runs.h - the cases of test_shapes.c and test_shapes_f64.c. */
#include "shape_box_cases.h"
#include "shape_cases.h"
#include "shape_exact_cases.h"
#include "shape_ring_cases.h"

static void start(void)
{
    hits = misses = undecided = 0;
}

/* Checks that both hits and misses occurred, and that the formulas decided most cases. */
static void check_counts(void)
{
    CHECK_MSG(hits > (int)check_count(1000) && misses > (int)check_count(300), "%d hits and %d misses", hits, misses);
    CHECK_MSG(undecided < hits / 3, "%d of %d hits were left open", undecided, hits);
}

TEST(planes)
{
    start();
    for (int i = 0; i < (int)check_count(40); i++)
        check_flat(0, i < 10 ? 0 : any_length(1, 30000));
    check_counts();
}

TEST(discs)
{
    start();
    for (int i = 0; i < (int)check_count(80); i++)
        check_flat(any_length(0x1p-10, 30000), any_length(1, 30000));
    check_flat(0x1p-10, 30000);
    check_flat(30000, 2000);
    check_counts();
}

TEST(boxes)
{
    start();
    for (int i = 0; i < (int)check_count(40); i++)
        check_box(any_length(1, 10000), 0x1p-10, 10000);
    check_box(30000, 0x1p-10, 0x1p-9);
    check_box(100, 30000, 30001);
    check_counts();
}

TEST(cylinders)
{
    start();
    for (int i = 0; i < (int)check_count(40); i++) {
        double radius = any_length(0x1p-10, 10000);
        check_cone(any_cone(any_length(1, 10000), any_length(0x1p-10, 10000), radius, radius));
    }
    check_cone(any_cone(30000, 0x1p-9, 0x1p-10, 0x1p-10));
    check_cone(any_cone(1000, 28000, 30000, 30000));
    check_cone(any_cone(1000, 28000, 0x1p-10, 0x1p-10));
    check_cone(any_cone(1000, 0x1p-9, 30000, 30000));
    check_counts();
}

TEST(cones)
{
    start();
    for (int i = 0; i < 40; i++) {
        double radius = any_length(0x1p-10, 10000);
        check_cone(any_cone(any_length(1, 10000), any_length(0x1p-10, 10000), radius, i & 1 ? 0 : radius / 3));
        check_cone(any_cone(any_length(1, 10000), any_length(0x1p-10, 10000), i & 1 ? 0 : radius * 0.99, radius));
    }
    for (int i = 0; i < (int)check_count(10); i++) {
        check_apex(any_cone(1000, any_length(0.1, 1000), any_length(0.1, 1000), 0));
        check_apex(any_cone(1000, any_length(0.1, 1000), 0, any_length(0.1, 1000)));
    }
    check_cone(any_cone(30000, 0x1p-9, 0x1p-10, 0));
    check_cone(any_cone(1000, 28000, 30000, 0));
    check_cone(any_cone(1000, 28000, 0x1p-10, 0));
    check_cone(any_cone(1000, 0x1p-9, 30000, 0));
    check_cone(any_cone(1000, 0x1p-9, 0, 30000));
    check_counts();
}

TEST(grids)
{
    start();
    for (unsigned i = 0; i < check_count(24); i++)
        tia_check_grid((const unsigned[]){1 + i % 5, 1 + i % 4, 1 + i % 3}, any_length(1, 10000),
                       any_length(0x1p-10, 4000), 0.2 + 0.6 * (i % 2), 6);
    tia_check_grid((const unsigned[]){2, 3, 2}, 30000, 0x1p-10, 0.5, 6);
    tia_check_grid((const unsigned[]){2, 3, 2}, 10, 10000, 0.5, 6);
    tia_check_grid((const unsigned[]){1, 1024, 2}, 10, 30, 0.01, 2);
    tia_check_grid((const unsigned[]){1024, 1, 1}, 30000, 0x1p-10, 0.02, 2);
    check_counts();
}

TEST(blocks_of_cells_are_boxes)
{
    start();
    check_block((const unsigned[]){4, 4, 4}, 100, 1);
    check_block((const unsigned[]){7, 1, 5}, 30000, 0x1p-10);
    check_block((const unsigned[]){16, 16, 16}, 100, 100);
    check_counts();
}

TEST(tori)
{
    start();
    for (int i = 0; i < (int)check_count(60); i++) {
        double major = any_length(0x1p-8, 8000);
        check_ring(any_length(1, 10000), major,
                   any_length(major / 2000 > 0x1p-10 ? major / 2000 : 0x1p-10, major * 0.7));
    }
    check_ring(10, 1, 0.99);
    check_ring(30000, 0x1p-9, 0x1p-10);
    check_ring(1000, 20000, 0x1p-10);
    check_ring(1000, 15000, 15000 - 0x1p-10);
    check_ring(1000, 20000, 1);
    check_counts();
}

TEST(rounded_boxes)
{
    start();
    for (int i = 0; i < (int)check_count(40); i++)
        check_cushion(any_length(1, 10000), 0x1p-8, 10000, i % 4 ? between(0, 1) : 1);
    check_cushion(30000, 0x1p-9, 0x1p-8, 0.5);
    check_cushion(100, 20000, 20001, 1);
    check_cushion(100, 20000, 20001, 0);
    check_counts();
}

int main(void)
{
    RUN(planes);
    RUN(discs);
    RUN(boxes);
    RUN(cylinders);
    RUN(cones);
    RUN(grids);
    RUN(blocks_of_cells_are_boxes);
    RUN(tori);
    RUN(rounded_boxes);
    RUN(cylinders_along_the_axes);
    RUN(cones_along_the_axes);
    RUN(surface_coordinates);
    RUN(boxes_along_the_axes);
    RUN(grids_along_the_axes);
    return check_status();
}
