/* Paths of radio waves: rooms whose paths are known, edges, walls. */
#include <math.h>

#include "radio_world.h"

static struct world w;

static int compare_doubles(const void *left, const void *right)
{
    double a = *(const double *)left, b = *(const double *)right;

    return (a > b) - (a < b);
}

enum { LENGTHS = 512 };

/* ---- a shoebox: Allen and Berkley, "Image method for efficiently simulating small-room acoustics", 1979 ---- */

/* Returns the image in cell m of an axis of length l: 2 l ceil(m/2) + x or - x. */
static double image(double x, double l, int m)
{
    return m % 2 == 0 ? m * l + x : (m + 1) * l - x;
}

static unsigned cell_lengths(const double room[3], const double from[3], const double to[3], int order, double *out)
{
    unsigned count = 0;

    for (int a = -order; a <= order; a++)
        for (int b = -order; b <= order; b++)
            for (int c = -order; c <= order; c++) {
                if (abs(a) + abs(b) + abs(c) > order)
                    continue;
                double x = image(to[0], room[0], a) - from[0], y = image(to[1], room[1], b) - from[1],
                       z = image(to[2], room[2], c) - from[2];
                out[count++] = sqrt(x * x + y * y + z * z);
            }
    return count;
}

static void check_lengths(double *want, unsigned count, double within)
{
    double got[LENGTHS];

    for (unsigned i = 0; i < count && count <= LENGTHS; i++)
        got[i] = world_length(&w.paths[i]);
    qsort(want, count, sizeof *want, compare_doubles);
    qsort(got, count, sizeof *got, compare_doubles);
    for (unsigned i = 0; i < count; i++)
        CHECK_MSG(fabs(got[i] - want[i]) < within, "length %u: %.15g, not %.15g", i, got[i], want[i]);
}

TEST(shoebox_room_has_the_paths_of_the_mirror_formula)
{
    const double room[3] = {5, 3.5, 4.25}, from[3] = {1.25, 1.5, 3}, to[3] = {4.125, 1.0625, 0.75};
    const unsigned counts[] = {1, 6, 18, 38, 66, 102};
    double want[LENGTHS];

    world_begin(&w);
    world_shoebox(&w, room[0], room[1], room[2]);
    CHECK(world_build(&w));
    unsigned count = world_images(&w, world_at(1.25, 1.5, 3), world_at(4.125, 1.0625, 0.75), 5, 0);
    unsigned of[6] = {0};
    CHECK_EQ(count, cell_lengths(room, from, to, 5, want));
    for (unsigned i = 0; i < count; i++)
        of[w.paths[i].order]++;
    for (unsigned order = 0; order <= 5; order++)
        CHECK_EQ(of[order], counts[order]);
    check_lengths(want, count, 1e-11);
    world_end(&w);
}

/* The rotated room, whose planes have normals of many digits, has as many paths, equally long but for rounding. */
TEST(turned_room_has_as_many_paths)
{
    static const double unit[3][3] = {{0.36, 0.48, -0.8}, {-0.8, 0.6, 0}, {0.48, 0.64, 0.6}};
    const double room[3] = {5, 3.5, 4.25}, from[3] = {1.25, 1.5, 3}, to[3] = {4.125, 1.0625, 0.75};
    struct tia_vec3 ends[2];
    double want[LENGTHS];

    world_begin(&w);
    for (int k = 0; k < 3; k++)
        for (int side = 0; side < 2; side++) {
            double r = side ? room[k] : 0, s = side ? -1 : 1;
            world_plane(&w, world_at(r * unit[k][0], r * unit[k][1], r * unit[k][2]), s * unit[k][0], s * unit[k][1],
                        s * unit[k][2]);
        }
    for (int e = 0; e < 2; e++) {
        const double *p = e ? to : from;
        double at[3];
        for (int k = 0; k < 3; k++)
            at[k] = p[0] * unit[0][k] + p[1] * unit[1][k] + p[2] * unit[2][k];
        ends[e] = world_at(at[0], at[1], at[2]);
    }
    CHECK(world_build(&w));
    unsigned count = world_images(&w, ends[0], ends[1], 4, 0);
    CHECK_EQ(count, cell_lengths(room, from, to, 4, want));
    check_lengths(want, count, 3e-4);
    world_end(&w);
}

TEST(parallel_plates)
{
    world_begin(&w);
    world_plane(&w, world_at(0, 0, 0), 0, 1, 0);
    world_plane(&w, world_at(0, 3, 0), 0, -1, 0);
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, world_at(0, 1, 0), world_at(8, 1, 0), TIA_RADIO_ORDER_MAX, 0), 17);
    for (unsigned i = 0; i < w.count; i++) {
        /* two paths of order k, one that begins below and one above: images at heights 2 * 3 m +- 1 */
        const struct tia_radio_path *path = &w.paths[i];
        int k = (int)path->order;
        bool below = k > 0 && path->point[0].y == 0;
        double height = k % 2 == 0 ? 1 + 3.0 * k * (below ? -1 : 1) : below ? -1 - 3.0 * (k - 1) : 3.0 * (k + 1) - 1;
        CHECK_MSG(fabs(world_length(path) - hypot(8, height - 1)) < 1e-11, "order %d: %.15g", k, world_length(path));
        for (int j = 0; j < k; j++)
            CHECK_EQ(path->point[j].y, (j % 2 == 0) == below ? 0 : TIA_Q16(3));
    }
    world_end(&w);
}

/* ---- corners ---- */

static void add_corner(double size)
{
    world_triangle(&w, world_at(0, 0, 0), world_at(size, 0, 0), world_at(0, size, 0));
    world_triangle(&w, world_at(0, 0, 0), world_at(0, size, 0), world_at(0, 0, size));
    world_triangle(&w, world_at(0, 0, 0), world_at(0, 0, size), world_at(size, 0, 0));
}

/* A corner of three faces returns a wave to its origin: the image is the point behind the corner. */
TEST(corner_reflector)
{
    struct tia_vec3 at = world_at(3, 4, 5), beside = world_at(3, 4.25, 5);
    unsigned threes = 0;

    world_begin(&w);
    add_corner(16);
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, at, beside, 3, 0), 1 + 3 + 3 + 1);
    for (unsigned i = 0; i < w.count; i++)
        if (w.paths[i].order == 3) {
            threes++;
            CHECK(fabs(world_length(&w.paths[i]) - sqrt(36 + 8.25 * 8.25 + 100)) < 1e-11);
            for (int k = 0; k < 3; k++) /* the wave leaves in the opposite direction */
                CHECK(w.paths[i].direction[0][k] == -w.paths[i].direction[3][k]);
        }
    CHECK_EQ(threes, 1);
    world_end(&w);
}

/* A path through the line where two walls meet at a right angle is found once; at an outer edge not at all. */
TEST(paths_through_an_edge_of_two_walls)
{
    world_begin(&w);
    world_plane(&w, world_at(0, 0, 0), 1, 0, 0);
    world_plane(&w, world_at(0, 0, 0), 0, 1, 0);
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, world_at(2, 1, 0), world_at(4, 2, 1), 2, 0), 1 + 2 + 1);
    CHECK_EQ(w.paths[3].order, 2);
    CHECK(w.paths[3].point[0].x == 0 && w.paths[3].point[0].y == 0 && w.paths[3].point[1].x == 0);
    CHECK(w.paths[3].face[0] == 0 && w.paths[3].face[1] == 1);
    CHECK_EQ(world_images(&w, world_at(2, 1, 0), world_at(4, 2.5, 1), 2, 0), 1 + 2 + 1);
    CHECK_EQ(world_images(&w, world_at(2, 1, 0), world_at(4, 1.5, 1), 2, 0), 1 + 2 + 1);
    world_end(&w);

    world_begin(&w);
    world_box(&w, world_at(-4, -4, -4), world_at(0, 0, 4));
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, world_at(2, 1, 0), world_at(4, 2, 1), 2, 0), 1);
    world_end(&w);
}

/* Two small mirrors are at the points where the planes are met in the wrong order: (0, -2) at 3/4 of the way, then (-2,
 * 0) at 1/4. */
TEST(reflections_are_in_order)
{
    world_begin(&w);
    world_triangle(&w, world_at(0, -1, -2), world_at(0, -1, 2), world_at(0, -4, 0));
    world_triangle(&w, world_at(-1, 0, -2), world_at(-1, 0, 2), world_at(-4, 0, 0));
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, world_at(3, 1, 0), world_at(1, 3, 0), 2, 0), 1);
    CHECK_EQ(w.paths[0].order, 0);
    world_end(&w);
}

TEST(points_are_rounded_to_nearest)
{
    world_begin(&w);
    world_plane(&w, world_at(0, 0, 0), 0, 1, 0);
    CHECK(world_build(&w));
    for (int side = -1; side <= 1; side += 2) {
        CHECK_EQ(world_images(&w, world_at(0, 1, 0), world_at(10 * side, 2, 5 * side), 1, 0), 2);
        CHECK_EQ(w.paths[1].point[0].x, side * 218453); /* 10/3 is 218453.33 */
        CHECK_EQ(w.paths[1].point[0].z, side * 109227); /* 5/3 is 109226.67 */
    }
    struct tia_vec3 to = {1, 65536, -1};
    CHECK_EQ(world_images(&w, world_at(0, 1, 0), to, 1, 0), 2); /* the point is at 1/2, -1/2: ties go up */
    CHECK(w.paths[1].point[0].x == 1 && w.paths[1].point[0].z == 0);
    world_end(&w);
}

/* A wall of two triangles, or of three that overlap, is one wall, also along its diagonal. */
TEST(paths_through_a_diagonal)
{
    for (int overlap = 0; overlap < 2; overlap++) {
        world_begin(&w);
        world_triangle(&w, world_at(0, 0, 0), world_at(4, 0, 0), world_at(4, 4, 0));
        world_triangle(&w, world_at(0, 0, 0), world_at(0, 4, 0), world_at(4, 4, 0));
        if (overlap)
            world_triangle(&w, world_at(-1, 0, 0), world_at(6, 0, 0), world_at(6, 5, 0));
        CHECK(world_build(&w));
        CHECK_EQ(tia_radio_count(w.radio).planes, 1);
        CHECK_EQ(world_images(&w, world_at(1, 1, 1), world_at(3, 3, 1), 1, 0), 2);
        CHECK_EQ(w.paths[1].face[0], 0);
        CHECK(w.paths[1].point[0].x == TIA_Q16(2) && w.paths[1].point[0].y == TIA_Q16(2));
        CHECK_EQ(world_images(&w, world_at(1, 1, 1), world_at(3, 3, -1), 1, 0), 0);
        CHECK_EQ(world_images(&w, world_at(1, 1, 1), world_at(3, 3, -1), 1, 1), 1);
        CHECK_EQ(w.paths[0].wall_count, 1);
        world_end(&w);
    }
}

/* ---- edges of one face: a unit of 2^-16 decides ---- */

TEST(face_has_its_edge_and_nothing_beyond)
{
    for (int beyond = -1; beyond <= 1; beyond++) {
        struct tia_vec3 from = world_at(1, 1, 1), to = world_at(3, 3, 1);
        world_begin(&w);
        world_triangle(&w, world_at(2, 0, 0), world_at(2, 4, 0), world_at(0, 2, 0));
        CHECK(world_build(&w));
        to.x += 2 * beyond; /* the point moves by one unit */
        CHECK_EQ(world_images(&w, from, to, 1, 0), beyond > 0 ? 1 : 2);
        to.z = -to.z;
        CHECK_EQ(world_images(&w, from, to, 1, 0), beyond > 0 ? 1 : 0);
        world_end(&w);
    }
    for (int beyond = -1; beyond <= 1; beyond++) {
        struct tia_vec3 from = world_at(0, 1, 0), to = world_at(10, 1, 0);
        world_begin(&w);
        world_add(&w,
                  (struct tia_shape){.kind = TIA_DISC, .disc = {world_at(2, 0, 4), {0, TIA_Q30_ONE, 0}, TIA_Q16(5)}});
        CHECK(world_build(&w));
        to.x += 2 * beyond; /* (5, 0, 0) is 5 from (2, 0, 4) */
        CHECK_EQ(world_images(&w, from, to, 1, 0), beyond > 0 ? 1 : 2);
        world_end(&w);
    }
}

/* ---- walls ---- */

TEST(boxes_are_one_wall_and_reflect_outside)
{
    world_begin(&w);
    world_box(&w, world_at(2, -5, -5), world_at(2.25, 5, 5));
    world_box(&w, world_at(4, -5, -5), world_at(4.5, 5, 5));
    CHECK(world_build(&w));
    CHECK_EQ(world_images(&w, world_at(0, 0, 0), world_at(6, 1, 0), 2, 0), 0);
    CHECK_EQ(world_images(&w, world_at(0, 0, 0), world_at(6, 1, 0), 0, 1), 0);
    CHECK_EQ(world_images(&w, world_at(0, 0, 0), world_at(6, 1, 0), 0, 2), 1);
    CHECK_EQ(w.paths[0].wall_count, 2);
    for (unsigned i = 0; i < 2; i++) {
        struct tia_radio_face face = tia_radio_face(w.radio, w.paths[0].wall[i].face);
        CHECK(face.solid && face.normal[0] == -(INT64_C(1) << 62));
        CHECK_EQ(face.thickness, face.object == 0 ? TIA_Q16(0.25) : TIA_Q16(0.5));
    }
    /* between the two boxes, back and forth: inside neither */
    CHECK_EQ(world_images(&w, world_at(0, 0, 0), world_at(6, 1, 0), 2, 2), 2);
    CHECK_EQ(w.paths[1].point[0].x, TIA_Q16(4));
    CHECK_EQ(w.paths[1].point[1].x, TIA_Q16(2.25));
    CHECK_EQ(tia_radio_inside(w.radio, world_at(2.125, 0, 0)), 0);
    CHECK_EQ(tia_radio_inside(w.radio, world_at(4.5, 5, 5)), 1);
    CHECK_EQ(tia_radio_inside(w.radio, world_at(3, 0, 0)), TIA_RADIO_NO_OBJECT);
    world_end(&w);
}

TEST(points_of_other_faces)
{
    world_begin(&w);
    world_plane(&w, world_at(0, 0, 0), 0, 1, 0);
    world_triangle(&w, world_at(0, 1, 0), world_at(4, 1, 0), world_at(0, 1, 4));
    world_add(&w, (struct tia_shape){.kind = TIA_SPHERE, .sphere = {world_at(9, 9, 9), TIA_Q16(1)}});
    CHECK(world_build(&w));
    CHECK_EQ(tia_radio_count(w.radio).left_out, 1);
    CHECK_EQ(tia_radio_inside(w.radio, world_at(-7, 0, 3)), 0);
    CHECK_EQ(tia_radio_inside(w.radio, world_at(2, 1, 2)), 1);
    CHECK_EQ(tia_radio_inside(w.radio, world_at(2.001, 1, 2)), TIA_RADIO_NO_OBJECT);
    world_end(&w);
}

TEST(sequences_are_counted)
{
    world_begin(&w);
    world_shoebox(&w, 5, 3, 4);
    CHECK(world_build(&w));
    CHECK_EQ(tia_radio_sequences(w.radio, 0), 1);
    CHECK_EQ(tia_radio_sequences(w.radio, 3), 1 + 6 + 30 + 150);
    world_end(&w);
}

/* Counts the paths, which are reported one by one, and ends the search after enough of them. */
static bool enough(void *ctx, const struct tia_radio_path *path)
{
    (void)path;
    return ++*(unsigned *)ctx < 3;
}

TEST(search_stops_when_told_to)
{
    unsigned count = 0;

    world_begin(&w);
    world_shoebox(&w, 5, 3, 4);
    CHECK(world_build(&w));
    struct tia_radio_link link = {world_at(1, 1, 1), world_at(2, 2, 3), 3, 0, enough, &count};
    CHECK_EQ(tia_radio_images(w.radio, w.room, &link), TIA_STOPPED);
    CHECK_EQ(count, 3);
    world_end(&w);
}

int main(void)
{
    RUN(shoebox_room_has_the_paths_of_the_mirror_formula);
    RUN(turned_room_has_as_many_paths);
    RUN(parallel_plates);
    RUN(corner_reflector);
    RUN(paths_through_an_edge_of_two_walls);
    RUN(reflections_are_in_order);
    RUN(points_are_rounded_to_nearest);
    RUN(paths_through_a_diagonal);
    RUN(face_has_its_edge_and_nothing_beyond);
    RUN(boxes_are_one_wall_and_reflect_outside);
    RUN(points_of_other_faces);
    RUN(sequences_are_counted);
    RUN(search_stops_when_told_to);
    return check_status();
}
