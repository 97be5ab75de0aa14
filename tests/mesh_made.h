/* mesh_made.h - meshes made for tests, and trees over their faces that are split at random. */
#ifndef TESTS_MESH_MADE_H
#define TESTS_MESH_MADE_H

#include <stdlib.h>

#include "ray_cases.h"

#define MADE_VERTICES 2000
#define MADE_FACES 1400

struct made {
    struct tia_vec3 vertices[MADE_VERTICES];
    struct tia_dir3 normals[MADE_VERTICES];
    struct tia_uv uvs[MADE_VERTICES];
    struct tia_face faces[MADE_FACES];
    struct tia_mesh mesh;
    struct tia_bvh_node nodes[2 * MADE_FACES];
    uint32_t items[MADE_FACES];
    struct tia_bvh_tree tree; /* has no nodes before made_tree */
};

static inline struct made *made_new(void)
{
    struct made *m = calloc(1, sizeof *m);

    if (!m)
        abort();
    m->mesh = (struct tia_mesh){.vertices = m->vertices, .normals = m->normals, .uvs = m->uvs, .faces = m->faces};
    m->tree = (struct tia_bvh_tree){.nodes = m->nodes, .items = m->items};
    return m;
}

static inline void made_free(struct made *m)
{
    free(m);
}

static inline uint32_t made_vertex(struct made *m, struct tia_vec3 v)
{
    m->vertices[m->mesh.vertex_count] = v;
    return m->mesh.vertex_count++;
}

static inline void made_face(struct made *m, uint32_t a, uint32_t b, uint32_t c)
{
    m->faces[m->mesh.face_count++] = (struct tia_face){
        {{a, TIA_NO_INDEX, TIA_NO_INDEX}, {b, TIA_NO_INDEX, TIA_NO_INDEX}, {c, TIA_NO_INDEX, TIA_NO_INDEX}}};
}

/* Returns the vertex halfway between two, moved out to the sphere. If that vertex exists already, it is reused. */
static inline uint32_t made_middle(struct made *m, uint32_t a, uint32_t b, struct tia_vec3 centre, long double radius)
{
    real3 c = real3_vec(centre),
          p = minus(plus(real3_vec(m->vertices[a]), real3_vec(m->vertices[b]), 1), plus(c, c, 1));

    p = plus(c, p, radius / length(p));
    struct tia_vec3 v = {(tia_q16)lrintl(p.x * 65536), (tia_q16)lrintl(p.y * 65536), (tia_q16)lrintl(p.z * 65536)};
    for (uint32_t i = 0; i < m->mesh.vertex_count; i++)
        if (!memcmp(&m->vertices[i], &v, sizeof v))
            return i;
    return made_vertex(m, v);
}

/* Makes an octahedron whose faces are divided into four, `times` times. The faces turn outwards. */
static inline struct made *made_sphere(struct tia_vec3 centre, long double radius, int times)
{
    struct made *m = made_new();
    const tia_q16 r = (tia_q16)(radius * 65536);

    for (int i = 0; i < 6; i++) {
        const tia_q16 s = i % 2 ? -r : r;
        made_vertex(m, (struct tia_vec3){centre.x + (i / 2 == 0) * s, centre.y + (i / 2 == 1) * s,
                                         centre.z + (i / 2 == 2) * s});
    }
    for (uint32_t i = 0; i < 8; i++) { /* an odd number of negative axes reverses the face's orientation */
        uint32_t x = i & 1, y = 2 + (i >> 1 & 1), z = 4 + (i >> 2 & 1);
        bool odd = (x + y + z) % 2;
        made_face(m, x, odd ? z : y, odd ? y : z);
    }
    while (times-- > 0) {
        uint32_t count = m->mesh.face_count;
        for (uint32_t f = 0; f < count; f++) {
            struct tia_corner *k = m->faces[f].corner;
            uint32_t a = k[0].vertex, b = k[1].vertex, c = k[2].vertex;
            uint32_t ab = made_middle(m, a, b, centre, radius), bc = made_middle(m, b, c, centre, radius);
            uint32_t ca = made_middle(m, c, a, centre, radius);
            k[1].vertex = ab;
            k[2].vertex = ca;
            made_face(m, ab, b, bc);
            made_face(m, bc, c, ca);
            made_face(m, ab, bc, ca);
        }
    }
    return m;
}

static inline struct made *made_cube(struct tia_vec3 min, tia_q16 edge)
{
    static const uint8_t faces[12][3] = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                                         {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    struct made *m = made_new();

    for (int i = 0; i < 8; i++)
        made_vertex(
            m, (struct tia_vec3){min.x + (i & 1 ? edge : 0), min.y + (i & 2 ? edge : 0), min.z + (i & 4 ? edge : 0)});
    for (int i = 0; i < 12; i++)
        made_face(m, faces[i][0], faces[i][1], faces[i][2]);
    return m;
}

/* Makes a random tetrahedron that is not very thin. */
static inline struct made *made_tetrahedron(long double size)
{
    struct made *m = made_new();
    real3 a, b, c;

    do {
        m->mesh.vertex_count = 0;
        for (int i = 0; i < 4; i++)
            made_vertex(m, random_vec(size));
        a = minus(real3_vec(m->vertices[1]), real3_vec(m->vertices[0]));
        b = minus(real3_vec(m->vertices[2]), real3_vec(m->vertices[0]));
        c = minus(real3_vec(m->vertices[3]), real3_vec(m->vertices[0]));
    } while (fabsl(dot(a, cross(b, c))) < size * size * size * 0.05L);
    made_face(m, 0, 1, 2);
    made_face(m, 1, 3, 2);
    made_face(m, 3, 1, 0);
    made_face(m, 2, 3, 0);
    return m;
}

/* Makes random faces over random vertices. */
static inline struct made *made_disorder(long double size, uint32_t count)
{
    struct made *m = made_new();

    for (uint32_t i = 0; i < count + 2; i++)
        made_vertex(m, random_vec(size));
    for (uint32_t f = 0; f < count; f++) {
        uint32_t a = (uint32_t)(random_bits() % (count + 2)), b = (a + 1 + (uint32_t)(random_bits() % 2)) % (count + 2);
        made_face(m, a, b, (b + 1) % (count + 2));
    }
    return m;
}

/* Adds normals and uvs for all corners. */
static inline void made_dress(struct made *m)
{
    m->mesh.normal_count = m->mesh.uv_count = m->mesh.vertex_count;
    for (uint32_t i = 0; i < m->mesh.vertex_count; i++) {
        real3 n = random_real3(1);
        n = plus((real3){0, 0, 0}, n, (1 + random_real() / 2) / length(n) * 1073741824);
        m->normals[i] = (struct tia_dir3){(tia_q30)n.x, (tia_q30)n.y, (tia_q30)n.z};
        m->uvs[i] = (struct tia_uv){random_q16(20), random_q16(20)};
    }
    for (uint32_t f = 0; f < m->mesh.face_count; f++)
        for (int k = 0; k < 3; k++) {
            struct tia_corner *c = &m->faces[f].corner[k];
            c->normal = (uint32_t)(random_bits() % m->mesh.normal_count);
            c->uv = (uint32_t)(random_bits() % m->mesh.uv_count);
        }
}

static inline void made_include(struct tia_bounds *b, struct tia_vec3 v)
{
    b->min.x = v.x - 1 < b->min.x ? v.x - 1 : b->min.x;
    b->min.y = v.y - 1 < b->min.y ? v.y - 1 : b->min.y;
    b->min.z = v.z - 1 < b->min.z ? v.z - 1 : b->min.z;
    b->max.x = v.x + 1 > b->max.x ? v.x + 1 : b->max.x;
    b->max.y = v.y + 1 > b->max.y ? v.y + 1 : b->max.y;
    b->max.z = v.z + 1 > b->max.z ? v.z + 1 : b->max.z;
}

/* Moves to the front those faces whose first corner has a smaller coordinate along an axis than that of a random face.
 * Returns their number. */
static inline uint32_t made_part(struct made *m, uint32_t first, uint32_t count, unsigned axis)
{
    uint32_t low = first;
    struct tia_vec3 pivot = m->vertices[m->faces[m->items[first + random_bits() % count]].corner[0].vertex];

    for (uint32_t i = first; i < first + count; i++) {
        struct tia_vec3 v = m->vertices[m->faces[m->items[i]].corner[0].vertex];
        if (axis == 0 ? v.x < pivot.x : axis == 1 ? v.y < pivot.y : v.z < pivot.z) {
            uint32_t item = m->items[i];
            m->items[i] = m->items[low];
            m->items[low++] = item;
        }
    }
    return low - first;
}

static inline void made_node(struct made *m, uint32_t first, uint32_t count, int depth)
{
    uint32_t node = m->tree.node_count++, low;
    struct tia_bounds b = {{INT32_MAX, INT32_MAX, INT32_MAX}, {INT32_MIN, INT32_MIN, INT32_MIN}};

    for (uint32_t i = first; i < first + count; i++)
        for (int k = 0; k < 3; k++)
            made_include(&b, m->vertices[m->faces[m->items[i]].corner[k].vertex]);
    m->nodes[node] = (struct tia_bvh_node){b, first, count};
    if (count < 2 + random_bits() % 3 || depth == TIA_BVH_DEPTH_MAX)
        return;
    low = made_part(m, first, count, (unsigned)(random_bits() % 3));
    low = low == 0 || low == count ? 1 + (uint32_t)(random_bits() % (count - 1)) : low;
    made_node(m, first, low, depth + 1);
    m->nodes[node].index = m->tree.node_count;
    m->nodes[node].count = 0;
    made_node(m, first + low, count - low, depth + 1);
}

static inline void made_tree(struct made *m)
{
    for (uint32_t f = 0; f < m->mesh.face_count; f++)
        m->items[f] = f;
    m->tree.node_count = 0;
    m->tree.item_count = m->mesh.face_count;
    made_node(m, 0, m->mesh.face_count, 0);
}

#endif
