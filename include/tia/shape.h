/* shape.h - the shapes besides the scene's spheres, and where they are put.
 *
 *     shape      surface coordinates u, v
 *     sphere     (atan2(z, x)/(2 pi) + 1/2, acos(y/r)/pi) of the point relative to the centre
 *     plane      the coordinates along A and B of light.h's axes for its normal, in units
 *     disc       the same, over its radius, from -1 to 1
 *     cylinder,  u around the axis like a sphere's around y, in the axes B, A of the direction from base
 *     cone       to top; v along the axis from 0 at the base to 1 at the top; both caps like a disc whose
 *                normal is that direction
 *     box        of the face: (z, y) where x is its normal, (x, z) where y is, (x, y) where z is, each
 *                from 0 at the box's minimum to 1 at its maximum
 *     triangle   the barycentric coordinates of corners 1 and 2
 *     mesh       its own, interpolated; or a triangle's
 *     grid       a cell's, as a box
 *
 * They are those of the shape as it is before its transform.
 *
 * A ray meets a shape at the smallest distance that is not below 0: from inside, where it leaves. A point
 * that has a coordinate of 65536 or more, either way, is not met. Of objects equally near the lower index
 * is met, and an object before a light. A grid is met where it changes: a ray that goes from an empty cell,
 * from outside, or from a cell of another material into a filled cell meets that cell's front, one that
 * goes from a filled cell into an empty one or out meets the back of the cell that it leaves.
 *
 * The normal of a sphere, box, cylinder or cone points outwards, of a plane or disc as it says, of a
 * triangle along (B - A) x (C - A): where a closed shape's inside begins for refraction. A ray that meets
 * the back of a surface sees the same material, its normal turned.
 */
#ifndef TIA_SHAPE_H
#define TIA_SHAPE_H

#include <tia/vec.h>

#define TIA_RADIUS_MIN 64       /* the smallest radius and cell: 2^-10 as Q16.16 */
#define TIA_NO_INDEX UINT32_MAX /* of a mesh's normals and uvs: none */
#define TIA_SCALE_MIN TIA_RADIUS_MIN
#define TIA_SCALE_MAX TIA_Q16(1024)
#define TIA_GRID_MAX 1024 /* cells along an axis */
#define TIA_GRID_CELLS_MAX (UINT32_C(1) << 28)

struct tia_sphere {
    struct tia_vec3 centre;
    tia_q16 radius;    /* TIA_RADIUS_MIN or more */
    uint32_t material; /* an index into the scene's materials */
};

/* Every kind of shape, and its field in struct tia_shape. The tables of kinds, here and elsewhere, are made of
 * this list: a new shape goes to its end, see docs/architecture.md. */
#define TIA_SHAPES(SHAPE)                                                                                              \
    SHAPE(TIA_SPHERE, sphere)                                                                                          \
    SHAPE(TIA_PLANE, plane) /* infinite */                                                                             \
    SHAPE(TIA_DISC, disc)                                                                                              \
    SHAPE(TIA_CYLINDER, cylinder)                                                                                      \
    SHAPE(TIA_CONE, cone)                                                                                              \
    SHAPE(TIA_BOX, box)                                                                                                \
    SHAPE(TIA_TRIANGLE, triangle)                                                                                      \
    SHAPE(TIA_MESH, mesh)                                                                                              \
    SHAPE(TIA_GRID, grid)

#define TIA_SHAPE_KIND(KIND, name) KIND,
enum tia_shape_kind { TIA_SHAPES(TIA_SHAPE_KIND) };
#undef TIA_SHAPE_KIND

struct tia_plane {
    struct tia_vec3 point;
    struct tia_dir3 normal; /* its length in 0.5..1.5: it is normalised */
};

struct tia_disc {
    struct tia_vec3 centre;
    struct tia_dir3 normal;
    tia_q16 radius;
};

struct tia_cylinder {
    struct tia_vec3 base, top; /* the ends of the axis, at least 2^-10 apart */
    tia_q16 radius;
    bool capped;
};

struct tia_cone {
    struct tia_vec3 base, top;
    tia_q16 base_radius, top_radius; /* not equal; each 0, or TIA_RADIUS_MIN or more */
    bool capped;
};

struct tia_box {
    struct tia_vec3 min, max; /* min < max in each coordinate; a transform orients it */
};

struct tia_triangle {
    struct tia_vec3 corner[3]; /* not on one line */
};

struct tia_shape {
    enum tia_shape_kind kind;
    uint32_t material;  /* an index into the scene's materials */
    uint32_t transform; /* 0: none; n: the scene's transform n - 1 */
    union {
        struct { /* TIA_SPHERE: as tia_sphere, with a transform an ellipsoid */
            struct tia_vec3 centre;
            tia_q16 radius;
        } sphere;
        struct tia_plane plane;
        struct tia_disc disc;
        struct tia_cylinder cylinder;
        struct tia_cone cone;
        struct tia_box box;
        struct tia_triangle triangle;
        uint32_t mesh; /* an index into the scene's meshes */
        uint32_t grid; /* an index into the scene's grids */
    };
};

/* What a field of a shape holds. */
enum tia_shape_value {
    TIA_SHAPE_Q16,  /* tia_q16 */
    TIA_SHAPE_VEC3, /* struct tia_vec3 */
    TIA_SHAPE_DIR3, /* struct tia_dir3 */
    TIA_SHAPE_FLAG  /* bool */
};

/* A field of a kind's struct, for what reads and writes shapes of all kinds. */
struct tia_shape_field {
    const char *word;   /* in scene files; NULL: the values that follow those of the field before */
    const char *member; /* in C; NULL ends the list */
    uint16_t offset;    /* in struct tia_shape */
    uint8_t value;      /* enum tia_shape_value */
    bool needed;        /* by scene files; else 0 when it is not there */
};

/* The fields of a kind. Meshes and grids, which are indices, have none. */
const struct tia_shape_field *tia_shape_fields(enum tia_shape_kind kind);

/* An instance: scaled along the shape's axes, rotated, moved. Not for planes. Not too flat for its size: half
 * the diagonal of the box around what is placed, over the smallest component of scale, is below 32768. */
struct tia_transform {
    struct tia_vec3 position; /* nearer to the eye than 32768, wherever the shapes are */
    struct tia_vec3 rotation; /* degrees, right-handed: about x, then y, then z */
    struct tia_vec3 scale;    /* each TIA_SCALE_MIN..TIA_SCALE_MAX */
};

struct tia_uv {
    tia_q16 u, v;
};

struct tia_corner {
    uint32_t vertex, normal, uv; /* indices; normal and uv may be TIA_NO_INDEX, in all three corners alike */
};

struct tia_face {
    struct tia_corner corner[3]; /* three that are on one line are never hit */
};

/* Faces over shared vertices. */
struct tia_mesh {
    const struct tia_vec3 *vertices;
    const struct tia_dir3 *normals; /* each of a length in 0.5..1.5: they are normalised, weighted by the
                                       barycentric coordinates, then transformed */
    const struct tia_uv *uvs;
    const struct tia_face *faces;
    uint32_t vertex_count, normal_count, uv_count, face_count;
};

/* Cubes in rows: cell (x, y, z) is at cells[(z * size[1] + y) * size[0] + x]. */
struct tia_grid {
    struct tia_vec3 corner; /* the smallest coordinates; the largest are below 32768 */
    tia_q16 cell;           /* a cube's edge, TIA_RADIUS_MIN or more */
    uint16_t size[3];       /* 1..TIA_GRID_MAX; at most TIA_GRID_CELLS_MAX in all */
    const uint8_t *cells;   /* 0: empty; n: of the material n - 1 after the shape's own */
};

#endif
