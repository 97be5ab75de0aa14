/* hierarchy.h - scenes of spheres and meshes, their hierarchies, and the boxes from which these are built. */
#ifndef TESTS_HIERARCHY_H
#define TESTS_HIERARCHY_H

#include <stdlib.h>
#include <tia/bvh.h>

#include "check.h"
#include "random.h"

#define ONE 65536
#define MOST 20000

static struct tia_sphere spheres[MOST];
static struct tia_shape shapes[40];
static struct tia_vec3 vertices[MOST];
static struct tia_face faces[MOST];
static struct tia_mesh meshes[3];
static struct tia_transform transform;
static struct tia_scene scene;

/* Returns a random number in -most..most. */
static tia_q16 number(int32_t most)
{
    return (tia_q16)((int64_t)(random_u32() % (2 * (uint32_t)most)) - most);
}

static struct tia_vec3 point(int32_t most)
{
    tia_q16 x = number(most), y = number(most);
    return (struct tia_vec3){x, y, number(most)};
}

static inline void set_spheres(uint32_t count)
{
    scene = (struct tia_scene){.spheres = spheres, .sphere_count = count};
    for (uint32_t i = 0; i < count; i++)
        spheres[i] = (struct tia_sphere){point(100 * ONE), 64 + (tia_q16)(random_u32() % (3 * ONE)), 0};
}

/* Places spheres in every direction, many at each distance; distances are powers of two. */
static inline void set_exponential_spheres(void)
{
    set_spheres(MOST);
    for (uint32_t i = 0; i < MOST; i++) {
        tia_q16 far = (tia_q16)(UINT32_C(1) << (i % 30));
        spheres[i].centre = (struct tia_vec3){i & 64 ? far : 0, i & 128 ? -far : 0, i & 256 ? far : 0};
        spheres[i].radius = i & 512 ? 64 : far / 2 + 64;
    }
}

static const struct tia_bvh *bvh; /* the hierarchy of the last build() */
static void *memory;              /* its memory */
static size_t used;               /* number of bytes that the hierarchy needs */

static inline void build(void)
{
    size_t size = tia_bvh_size(&scene);

    free(memory);
    memory = malloc(size);
    memset(memory, 0xa5, size);
    CHECK_EQ(tia_bvh_build(&bvh, memory, size, &used, &scene, NULL), TIA_OK);
    CHECK(used <= size);
}

/* Returns the box of an item; `mesh` is NULL for objects. */
static inline struct tia_bounds box_of(const struct tia_mesh *mesh, uint32_t item)
{
    if (!mesh)
        return tia_object_bounds(&scene, item);
    struct tia_bounds b = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};
    for (int i = 0; i < 3; i++) {
        struct tia_vec3 p = mesh->vertices[mesh->faces[item].corner[i].vertex];
        b = (struct tia_bounds){
            {p.x < b.min.x ? p.x : b.min.x, p.y < b.min.y ? p.y : b.min.y, p.z < b.min.z ? p.z : b.min.z},
            {p.x > b.max.x ? p.x : b.max.x, p.y > b.max.y ? p.y : b.max.y, p.z > b.max.z ? p.z : b.max.z}};
    }
    return b;
}

static inline void set_mesh(struct tia_mesh *mesh, uint32_t first, uint32_t count)
{
    *mesh = (struct tia_mesh){
        .vertices = vertices + first, .faces = faces + first, .vertex_count = count, .face_count = count};
    for (uint32_t i = 0; i < count; i++) {
        vertices[first + i] = point(20 * ONE);
        for (int k = 0; k < 3; k++)
            faces[first + i].corner[k] = (struct tia_corner){random_u32() % count, TIA_NO_INDEX, TIA_NO_INDEX};
    }
}

static inline void set_everything(void)
{
    set_spheres(100);
    set_mesh(&meshes[0], 0, 3000);
    meshes[1] = (struct tia_mesh){.face_count = 0};
    set_mesh(&meshes[2], 3000, 1);
    transform = (struct tia_transform){{ONE, 0, 0}, {20 * ONE, 30 * ONE, 0}, {ONE, 2 * ONE, ONE}};
    for (uint32_t i = 0; i < 40; i++) {
        shapes[i] = (struct tia_shape){.kind = TIA_MESH, .transform = i % 3 == 2, .mesh = i / 2 % 3};
        if (i % 5 == 0)
            shapes[i] = (struct tia_shape){.kind = TIA_PLANE, .plane = {{0, 0, 0}, {0, TIA_Q30_ONE, 0}}};
        if (i % 7 == 0)
            shapes[i] = (struct tia_shape){.kind = TIA_BOX, .box = {{-(tia_q16)i * ONE, 0, 0}, {ONE, ONE, ONE}}};
        if (i == 38)
            shapes[i] = (struct tia_shape){.kind = TIA_SPHERE, .sphere = {{INT32_MAX, 0, 0}, ONE}};
    }
    scene.shapes = shapes;
    scene.shape_count = 40;
    scene.meshes = meshes;
    scene.mesh_count = 3;
    scene.transforms = &transform;
    scene.transform_count = 1;
}

/* A `stop` callback that returns true from its *ctx-th call on. */
static inline bool count_down(void *ctx)
{
    unsigned *left = ctx;
    return *left == 0 || --*left == 0;
}

#endif
