/* The merging of equal points, and the joining of edges: the library sorts, the tests compare each pair. */
#include <math.h>
#include <stdlib.h>

#include <tia/debug.h>
#include <tia/scene.h>

#include "check.h"
#include "flat/edges.h"
#include "math/sort.h"
#include "random.h"

#define MANY 400

static struct cancel never;

static uint32_t below(uint32_t n)
{
    return (uint32_t)(random_bits() % n);
}

TEST(ids_are_sorted_and_equal_keys_keep_their_order)
{
    static uint32_t ids[MANY], room[MANY], keys[MANY];

    for (unsigned round = 0; round < 200; round++) {
        uint32_t count = below(MANY), mask = 3u << round % 31;
        for (uint32_t i = 0; i < count; i++) {
            ids[i] = count - 1 - i;
            keys[i] = random_u32() & (round & 1 ? mask : UINT32_MAX);
        }
        tia_sort_ids(ids, room, count, keys);
        for (uint32_t i = 1; i < count; i++)
            CHECK(keys[ids[i - 1]] < keys[ids[i]] || (keys[ids[i - 1]] == keys[ids[i]] && ids[i - 1] > ids[i]));
    }
}

static tia_q16 few_values(void)
{
    static const tia_q16 values[] = {INT32_MIN, INT32_MIN + 1, -65537, -1, 0, 1, 256, INT32_MAX};

    return values[below(8)];
}

TEST(points_of_one_place_become_one)
{
    static struct tia_vec3 points[MANY];
    static uint32_t first[MANY];
    void *room = malloc(tia_weld_room(MANY));

    for (unsigned round = 0; round < 20; round++) {
        uint32_t count = below(MANY);
        for (uint32_t i = 0; i < count; i++)
            points[i] = (struct tia_vec3){few_values(), few_values(), few_values()};
        tia_weld(first, points, count, room);
        for (uint32_t i = 0; i < count; i++) {
            uint32_t same = 0;
            while (memcmp(&points[same], &points[i], sizeof *points) != 0)
                same++;
            CHECK_EQ(first[i], same);
        }
    }
    free(room);
}

/* ---- edges ---- */

struct ends {
    uint32_t from, to;
};

static struct ends ends_of(const struct tia_flat_face *faces, uint32_t e)
{
    const struct tia_flat_face *f = &faces[e / TIA_SIDES];
    return (struct ends){f->corner[e % TIA_SIDES], f->corner[(e % TIA_SIDES + 1) % tia_face_sides(f)]};
}

/* Returns the number of edges that run from a to b. */
static uint32_t count_edges(const struct tia_flat_face *faces, uint32_t count, struct ends ends)
{
    uint32_t n = 0;

    for (uint32_t e = 0; e < TIA_SIDES * count; e++) {
        if (e % TIA_SIDES >= tia_face_sides(&faces[e / TIA_SIDES]))
            continue;
        struct ends other = ends_of(faces, e);
        n += other.from == ends.from && other.to == ends.to;
    }
    return n;
}

/* Checks tia_edges_join: an edge is joined to one that runs back, as long as there is one left, and that one to it.
 * Returns the result of tia_edges_join. */
static bool check_joined(const struct tia_flat_face *faces, uint32_t count)
{
    uint32_t *across = malloc(TIA_SIDES * count * sizeof *across + 1);
    void *room = malloc(tia_edges_room(count) + 1);
    bool closed = tia_edges_join(across, faces, count, room, &never), balanced = true;
    uint32_t single = 0;
    double unpaired = 0;

    for (uint32_t e = 0; e < TIA_SIDES * count; e++) {
        if (e % TIA_SIDES >= tia_face_sides(&faces[e / TIA_SIDES]))
            continue;
        struct ends ends = ends_of(faces, e);
        uint32_t there = count_edges(faces, count, ends);
        uint32_t back = count_edges(faces, count, (struct ends){ends.to, ends.from});
        single += across[e] == TIA_NO_EDGE;
        balanced = balanced && there == back;
        unpaired += there > back ? (double)(there - back) / there : 0; /* share of the equal edges without a partner */
        if (across[e] != TIA_NO_EDGE) {
            struct ends other = ends_of(faces, across[e]);
            CHECK(other.from == ends.to && other.to == ends.from && across[across[e]] == e);
        }
    }
    CHECK_EQ(closed, balanced);
    CHECK_EQ(single, lround(unpaired));
    free(across);
    free(room);
    return closed;
}

#define NONE TIA_NO_CORNER

TEST(solids_close)
{
    static const struct tia_flat_face cube[] = {{{0, 2, 3, 1}}, {{4, 5, 7, 6}}, {{0, 1, 5, 4}},
                                                {{2, 6, 7, 3}}, {{0, 4, 6, 2}}, {{1, 3, 7, 5}}};
    static const struct tia_flat_face tetrahedron[] = {
        {{0, 1, 2, NONE}}, {{0, 3, 1, NONE}}, {{1, 3, 2, NONE}}, {{0, 2, 3, NONE}}};
    static const struct tia_flat_face pyramid[] = {
        {{0, 1, 2, 3}}, {{0, 4, 1, NONE}}, {{1, 4, 2, NONE}}, {{2, 4, 3, NONE}}, {{3, 4, 0, NONE}}};
    static const struct tia_flat_face needle[] = {{{0, 1, 0, NONE}}, {{5, 5, 5, NONE}}, {{2, 2, 3, NONE}}};

    CHECK(check_joined(cube, 6) && !check_joined(cube, 5) && !check_joined(cube + 1, 4));
    CHECK(check_joined(tetrahedron, 4) && !check_joined(tetrahedron, 3));
    CHECK(check_joined(pyramid, 5) && !check_joined(pyramid + 1, 4));
    CHECK(check_joined(needle, 3) && check_joined(needle, 0));
}

/* Random faces over few points, so that an edge has many faces; in half of the rounds each face also has a copy turned
 * round. */
TEST(many_faces_at_an_edge)
{
    static struct tia_flat_face faces[60];
    unsigned closed = 0;

    for (unsigned round = 0; round < 2000; round++) {
        uint32_t count = 1 + below(round % 2 ? 4 : 60);
        for (uint32_t f = 0; f < count; f++)
            for (unsigned k = 0; k < TIA_SIDES; k++)
                faces[f].corner[k] = k == 3 && below(2) ? NONE : below(4);
        for (uint32_t f = 0; round % 4 >= 2 && f + 1 < count; f += 2) /* turned copies close them */
            for (unsigned k = 0, sides = tia_face_sides(&faces[f]); k < TIA_SIDES; k++)
                faces[f + 1].corner[k] = k < sides ? faces[f].corner[sides - 1 - k] : NONE;
        closed += check_joined(faces, count);
    }
    CHECK(closed > 200 && closed < 1500);
}

/* The faces of a tetrahedron have vertices of their own, at equal positions. */
TEST(meshes_close_by_place)
{
    static const struct tia_vec3 vertices[12] = {
        {0, 0, 0}, {9, 0, 0}, {0, 9, 0}, {0, 0, 0}, {0, 0, 9}, {9, 0, 0},
        {9, 0, 0}, {0, 0, 9}, {0, 9, 0}, {0, 0, 0}, {0, 9, 0}, {0, 0, 9},
    };
    static struct tia_face faces[4];
    struct tia_mesh mesh = {.vertices = vertices, .faces = faces, .vertex_count = 12, .face_count = 4};

    for (uint32_t i = 0; i < 12; i++)
        faces[i / 3].corner[i % 3] = (struct tia_corner){i, TIA_NO_INDEX, TIA_NO_INDEX};
    void *room = malloc(tia_shadow_mesh_room(&mesh));
    CHECK(tia_shadow_mesh_closes(&mesh, room));
    mesh.face_count = 3;
    CHECK(!tia_shadow_mesh_closes(&mesh, room));
    mesh.face_count = 4;
    faces[2].corner[0].vertex = 7; /* turned round */
    faces[2].corner[1].vertex = 6;
    CHECK(!tia_shadow_mesh_closes(&mesh, room));
    free(room);
}

int main(void)
{
    RUN(ids_are_sorted_and_equal_keys_keep_their_order);
    RUN(points_of_one_place_become_one);
    RUN(solids_close);
    RUN(many_faces_at_an_edge);
    RUN(meshes_close_by_place);
    return check_status();
}
