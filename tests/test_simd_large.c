/* A mesh of more than BVH_LARGE_MESH faces, of which vector units store no normals, and one of as many: every
 * instruction set against plain C, byte by byte, and the memory that both meshes take. */
#include <math.h>
#include <stdlib.h>
#include <tia/bvh.h>

#include "scene/bvh/tree.h"
#include "simd_frames_all.h"

#define SIDE 1025 /* quadrilaterals along each side of the hills: 2 * 1025^2 faces, a little more than 2^21 */
#define POINTS (SIDE + 1)

static struct tia_vec3 *vertices;
static struct tia_dir3 *normals;
static struct tia_uv *uvs;
static struct tia_face *faces;
static uint32_t *groups;

static tia_q16 q16(double x)
{
    return (tia_q16)lrint(x * 65536);
}

static tia_q30 q30(double x)
{
    return (tia_q30)lrint(x * (1 << 30));
}

/* The point (x, y, z) of the hills, z = sin(3 x) cos(2 y)/4, with the normal of this surface. */
static void set_point(uint32_t i)
{
    double x = (double)(i % POINTS) / SIDE * 8 - 4, y = (double)i / POINTS / SIDE * 8 - 4;
    double dx = 0.75 * cos(3 * x) * cos(2 * y), dy = -0.5 * sin(3 * x) * sin(2 * y);
    double size = sqrt(1 + dx * dx + dy * dy);

    vertices[i] = (struct tia_vec3){q16(x), q16(y), q16(sin(3 * x) * cos(2 * y) / 4)};
    normals[i] = (struct tia_dir3){q30(-dx / size), q30(-dy / size), q30(1 / size)};
    uvs[i] = (struct tia_uv){q16(x), q16(y)};
}

/* The faces are smooth in every third strip, where their corners have coordinates of a texture, too. */
static void set_face(uint32_t face)
{
    uint32_t row = face / 2 / SIDE, column = face / 2 % SIDE, at = row * POINTS + column;
    const uint32_t corners[2][3] = {{at, at + 1, at + POINTS + 1}, {at, at + POINTS + 1, at + POINTS}};
    bool smooth = row / 34 % 3 == 0;

    for (int i = 0; i < 3; i++) {
        uint32_t corner = corners[face % 2][i];
        faces[face].corner[i] =
            (struct tia_corner){corner, smooth ? corner : TIA_NO_INDEX, smooth ? corner : TIA_NO_INDEX};
    }
    groups[face] = face / 2 % 7;
}

static void make_hills(void)
{
    vertices = calloc(POINTS * POINTS, sizeof *vertices);
    normals = calloc(POINTS * POINTS, sizeof *normals);
    uvs = calloc(POINTS * POINTS, sizeof *uvs);
    faces = calloc(2 * SIDE * SIDE, sizeof *faces);
    groups = calloc(2 * SIDE * SIDE, sizeof *groups);
    for (uint32_t i = 0; i < POINTS * POINTS; i++)
        set_point(i);
    for (uint32_t i = 0; i < 2 * SIDE * SIDE; i++)
        set_face(i);
}

/* Calls then() with a scene of the hills' first `count` faces, of which the mesh has the groups if `grouped`. */
static void with_hills(uint32_t count, bool grouped, void (*then)(const struct tia_scene *))
{
    static const struct tia_texture checks = {.kind = TIA_CHECKER,
                                              .repeat = {TIA_Q16(4), TIA_Q16(4)},
                                              .cells = {{TIA_Q30(1), TIA_Q30(1), TIA_Q30(1)}, {TIA_Q30(0.25), 0, 0}}};
    const struct tia_mesh mesh = {vertices,        normals,         uvs,
                                  faces,           POINTS * POINTS, POINTS * POINTS,
                                  POINTS * POINTS, count,           grouped ? groups : NULL};
    const struct tia_material material = {.colour = {TIA_Q30(0.5), TIA_Q30(0.75), TIA_Q30(0.5)},
                                          .mirror = {TIA_Q30(0.25), TIA_Q30(0.25), TIA_Q30(0.25)},
                                          .transmission = grouped ? (struct tia_rgb){TIA_Q30(0.5), 0, TIA_Q30(0.25)}
                                                                  : (struct tia_rgb){0, 0, 0},
                                          .texture = 1};
    const struct tia_shape shape = {.kind = TIA_MESH};
    const struct tia_light light = {.centre = {TIA_Q16(-3), TIA_Q16(-6), TIA_Q16(4)},
                                    .emission = {TIA_Q30(0.9), TIA_Q30(0.8), TIA_Q30(0.7)}};
    struct tia_scene scene = {
        .shapes = &shape,
        .shape_count = 1,
        .meshes = &mesh,
        .mesh_count = 1,
        .materials = &material,
        .material_count = 1,
        .textures = &checks,
        .texture_count = 1,
        .lights = &light,
        .light_count = 1,
        .background = {TIA_Q30(0.2), TIA_Q30(0.4), TIA_Q30(0.8)},
        .depth = 3,
        .camera = {.eye = {TIA_Q16(1), TIA_Q16(-3), TIA_Q16(1.5)}, .fov = TIA_Q16(60), .up = {0, 0, TIA_Q16(1)}}};
    size_t size = tia_bvh_size(&scene);
    void *memory = malloc(size);

    CHECK_EQ(tia_bvh_build(&scene.bvh, memory, size, NULL, &scene, NULL), TIA_OK);
    then(&scene);
    free(memory);
}

static void compare(const struct tia_scene *scene)
{
    simd_frames_check_all(scene, 40, 30, 0);
}

TEST(large)
{
    with_hills(2 * SIDE * SIDE, false, compare);
}

TEST(large_with_groups)
{
    with_hills(2 * SIDE * SIDE, true, compare);
}

static size_t last_size;
static uint32_t small_pairs; /* nodes with two leaves of at most four faces in all */

static void measure(const struct tia_scene *scene)
{
    const struct tia_bvh_tree *tree = &scene->bvh->meshes[0];

    last_size = tia_simd_size(tia_simd_at(0), scene, 1, 1);
    small_pairs = 0;
    for (uint32_t i = 0; i < tree->node_count; i++) {
        const struct tia_bvh_node *node = &tree->nodes[i];
        uint32_t first = node->count ? 0 : node[1].count, second = node->count ? 0 : tree->nodes[node->index].count;
        small_pairs += first && second && first + second <= 4;
    }
}

/* A mesh of one face more takes 40 bytes less for each face, and no node is divided that has up to four. */
TEST(memory)
{
    with_hills(BVH_LARGE_MESH, false, measure);
    size_t size = last_size;
    CHECK(small_pairs > 0);
    with_hills(BVH_LARGE_MESH + 1, false, measure);
    CHECK_EQ(small_pairs, 0);
    CHECK_MSG(last_size + (size_t)40 * BVH_LARGE_MESH <= size, "%zu and %zu bytes", size, last_size);
}

int main(void)
{
    make_hills();
    RUN(large);
    RUN(large_with_groups);
    RUN(memory);
    free(vertices);
    free(normals);
    free(uvs);
    free(faces);
    free(groups);
    return check_status();
}
