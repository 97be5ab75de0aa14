/* shape.h - shapes and instancing.
 *
 * Surface coordinates: seen from the side that the normal points to, u grows to the right and v grows upwards, so that
 * an image appears upright; seen from behind, it is mirrored. On a flat surface with the normal N, right and up are the
 * tangents
 *
 *     U = normalise(y x N), V = N x U; for N = y: U = x, V = -z; for N = -y: U = x, V = z.
 *
 *     shape      u, v, before the transform                                    u = 0         v = 0
 *     sphere     (1/2 - atan2(z, x)/(2 pi), 1 - acos(y/r)/pi), the point       at -x; +z is  at the bottom,
 *                relative to the centre                                        at u = 1/4    -y
 *     plane      (P.U, P.V) of P relative to `point`, in the file's units      along V       along U
 *     disc       (1/2 + P.U/(2r), 1/2 + P.V/(2r)), P relative to the centre:   at the left   at the bottom
 *                0..1 on the square around it
 *     cylinder,  u = 1/2 - atan2(-P.V, P.U)/(2 pi) around the axis, with the   at -U         at the base
 *     cone       tangents of the direction N from base to top; v from 0 at
 *                the base to 1 at the top; a cap is a disc, its normal outwards
 *     box        on each face, 0..1 along its U and V:                         at the left   at the bottom
 *                -z, y at +x   z, y at -x   x, -z at +y   x, z at -y   x, y at +z   -x, y at -z
 *     triangle   the barycentric coordinates of corners 1 and 2                edge 0-2      edge 0-1
 *     mesh       the coordinates of its corners, interpolated; without any, those of a triangle
 *     grid       those of a box, on each cell
 *     solid      those of the member whose surface it is
 *     torus      u around the axis as on a cylinder; v = 1/2 + a/(2 pi), a     at -U         on the inner
 *                being the angle around the tube: 0 on the outer equator,                    equator
 *                where v grows along the axis; within the hole an image is upside down
 *     rounded    those of the box without rounding, on the face that the      as on a box   as on a box
 *     box        normal is nearest to; at equal angles the first of x, y, z
 *
 * A ray hits a shape at the smallest distance that is not negative; a ray from inside hits where it leaves. There is no
 * hit at points with a coordinate of magnitude 65536 or more. At equal distances the lower index wins, and an object
 * wins over a light. A grid has surfaces where its content changes: a ray that enters a filled cell from outside, from
 * an empty cell or from one of another material hits that cell's front; a ray that leaves a filled cell for an empty
 * one or for the outside hits the back of the cell.
 *
 * A torus with the unit axis N, of radii R and r, is where (rho - R)^2 + z^2 <= r^2: z = P.N is a point's height above
 * the centre and rho = |P - z N| its distance from the axis. A rounded box of radius r is all points within r of the
 * box from min + r to max - r.
 *
 * A solid has surfaces where a ray enters or leaves it; each is that of a member, with the member's material. Crossings
 * of the line of a ray that are within 2^-16 of each other, in the solid's axes, are at one place: so surfaces that
 * coincide leave no parts in between. The surface there is that of the first member that enters or leaves the solid by
 * itself; if there is none, of the first member that crosses.
 *
 * Normals of solids point outwards; on the surface of a member that is subtracted they are turned round. Normals of
 * spheres, boxes, cylinders, cones and tori point outwards, those of planes and discs as given, those of
 * triangles along (B - A) x (C - A). For refraction, the back side of a surface is its inside. A ray that hits
 * the back sees the same material, with the normal negated.
 */
#ifndef TIA_SHAPE_H
#define TIA_SHAPE_H

#include <tia/vec.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_RADIUS_MIN 64       /* the smallest radius, and edge of a grid's cell: 2^-10 as Q16.16 */
#define TIA_NO_INDEX UINT32_MAX /* a corner without a normal or uv */
#define TIA_SCALE_MIN TIA_RADIUS_MIN
#define TIA_SCALE_MAX TIA_Q16(1024)
#define TIA_GRID_MAX 1024 /* cells along an axis */
#define TIA_GRID_CELLS_MAX (UINT32_C(1) << 28)
#define TIA_SOLID_MEMBERS 32                        /* in one solid */
#define TIA_SOLID_STEPS (2 * TIA_SOLID_MEMBERS - 1) /* of one solid */
#define TIA_SOLID_DEPTH 16                          /* operands that wait for an operation */

struct tia_sphere {
    struct tia_vec3 centre;
    tia_q16 radius;    /* TIA_RADIUS_MIN or more */
    uint32_t material; /* an index into the scene's materials */
};

/* Every kind of shape, and its field in struct tia_shape. All tables of kinds are generated from this list. A new shape
 * is appended to it, see docs/architecture.md. */
#define TIA_SHAPES(SHAPE)                                                                                              \
    SHAPE(TIA_SPHERE, sphere)                                                                                          \
    SHAPE(TIA_PLANE, plane) /* infinite */                                                                             \
    SHAPE(TIA_DISC, disc)                                                                                              \
    SHAPE(TIA_CYLINDER, cylinder)                                                                                      \
    SHAPE(TIA_CONE, cone)                                                                                              \
    SHAPE(TIA_BOX, box)                                                                                                \
    SHAPE(TIA_TRIANGLE, triangle)                                                                                      \
    SHAPE(TIA_MESH, mesh)                                                                                              \
    SHAPE(TIA_GRID, grid)                                                                                              \
    SHAPE(TIA_SOLID, solid)                                                                                            \
    SHAPE(TIA_TORUS, torus)                                                                                            \
    SHAPE(TIA_ROUNDED, rounded) /* a box with rounded edges and corners */

#define TIA_SHAPE_KIND(KIND, name) KIND,
enum tia_shape_kind { TIA_SHAPES(TIA_SHAPE_KIND) };
#undef TIA_SHAPE_KIND

struct tia_plane {
    struct tia_vec3 point;
    struct tia_dir3 normal; /* length 0.5..1.5; it is normalised */
};

struct tia_disc {
    struct tia_vec3 centre;
    struct tia_dir3 normal; /* length 0.5..1.5; it is normalised */
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
    struct tia_vec3 min, max; /* min < max in each coordinate; a transform can rotate the box */
};

struct tia_triangle {
    struct tia_vec3 corner[3]; /* not collinear */
};

/* A ring around the axis through the centre. The hole's radius, major - minor, is TIA_RADIUS_MIN or more. */
struct tia_torus {
    struct tia_vec3 centre;
    struct tia_dir3 axis; /* length 0.5..1.5; it is normalised */
    tia_q16 major;        /* radius of the circle in the middle of the tube */
    tia_q16 minor;        /* radius of the tube, TIA_RADIUS_MIN or more */
};

struct tia_rounded {
    struct tia_vec3 min, max; /* of the whole; max - min is at least twice the radius in each coordinate */
    tia_q16 radius;           /* of the edges and corners, TIA_RADIUS_MIN or more */
};

struct tia_shape {
    enum tia_shape_kind kind;
    uint32_t material;  /* an index into the scene's materials */
    uint32_t transform; /* 0: none; n: the scene's transform n - 1 */
    union {
        struct { /* TIA_SPHERE: like struct tia_sphere; a transform can scale it to an ellipsoid */
            struct tia_vec3 centre;
            tia_q16 radius;
        } sphere;
        struct tia_plane plane;
        struct tia_disc disc;
        struct tia_cylinder cylinder;
        struct tia_cone cone;
        struct tia_box box;
        struct tia_triangle triangle;
        uint32_t mesh;  /* an index into the scene's meshes */
        uint32_t grid;  /* an index into the scene's grids */
        uint32_t solid; /* an index into the scene's solids */
        struct tia_torus torus;
        struct tia_rounded rounded;
    };
};

/* The type of a shape's field. */
enum tia_shape_value {
    TIA_SHAPE_Q16,  /* tia_q16, a length */
    TIA_SHAPE_VEC3, /* struct tia_vec3, a position */
    TIA_SHAPE_DIR3, /* struct tia_dir3 */
    TIA_SHAPE_FLAG  /* bool */
};

/* Description of a field of a shape kind's struct, for code that reads or writes shapes of all kinds. */
struct tia_shape_field {
    const char *word;   /* name in scene files; NULL: its values follow those of the previous field */
    const char *member; /* name in C; NULL ends the list */
    uint16_t offset;    /* byte offset in struct tia_shape */
    uint8_t value;      /* enum tia_shape_value */
    bool needed;        /* required in scene files; otherwise the default is 0 */
};

/* Returns the fields of a kind; NULL for a number that is not a kind. The list is empty for meshes and
 * grids: such a shape is only an index. */
const struct tia_shape_field *tia_shape_fields(enum tia_shape_kind kind);

/* A transform scales a shape along its own axes, then rotates it, then translates it. Planes must not have a transform.
 * An instance must not be too flat for its size: half the diagonal of its bounding box, divided by the smallest
 * component of scale, is below 32768. */
struct tia_transform {
    struct tia_vec3 position; /* within 32768 of the eye, like the instances themselves */
    struct tia_vec3 rotation; /* degrees, right-handed: about x, then y, then z */
    struct tia_vec3 scale;    /* each TIA_SCALE_MIN..TIA_SCALE_MAX */
};

struct tia_uv {
    tia_q16 u, v;
};

struct tia_corner {
    uint32_t vertex, normal, uv; /* indices; normal and uv may be TIA_NO_INDEX, then in all three corners */
};

struct tia_face {
    struct tia_corner corner[3]; /* collinear corners are allowed; such a face is never hit */
};

/* Triangles over shared vertices. */
struct tia_mesh {
    const struct tia_vec3 *vertices;
    const struct tia_dir3 *normals; /* each of length 0.5..1.5; they are normalised, interpolated by the
                                       barycentric coordinates, then transformed */
    const struct tia_uv *uvs;
    const struct tia_face *faces;
    uint32_t vertex_count, normal_count, uv_count, face_count;
    const uint32_t *groups; /* NULL, or a group number for each face: the faces of a group filter a shadow ray only
                               once, see material.h */
};

/* Voxels: cell (x, y, z) is cells[(z * size[1] + y) * size[0] + x]. */
struct tia_grid {
    struct tia_vec3 corner; /* the minimum corner; all coordinates of the maximum corner are below 32768 */
    tia_q16 cell;           /* edge of a cell, TIA_RADIUS_MIN or more */
    uint16_t size[3];       /* cells along x, y, z: each 1..TIA_GRID_MAX, at most TIA_GRID_CELLS_MAX in all */
    const uint8_t *cells;   /* 0: empty; n: material number shape.material + n - 1 */
};

/* A step in the expression of a solid, in postfix order. A member pushes the next member on a stack; an operation
 * replaces the two topmost operands by its result, the difference the lower by what is outside of the upper one. */
enum tia_solid_step { TIA_SOLID_MEMBER, TIA_SOLID_UNION, TIA_SOLID_INTERSECTION, TIA_SOLID_DIFFERENCE };

/* Constructive solid geometry. Members are spheres, boxes, rounded boxes, tori, capped cylinders and cones, and
 * planes, which are the half-spaces behind them; their transforms lead to the solid's own axes. They must not reach
 * beyond 32768 there, and the solid must be bounded, as seen from the boxes of its members: the result of each
 * operation is bounded by the box around both boxes for a union, by what the boxes share for an intersection, and by
 * the first box for a difference. The material of the solid's own struct tia_shape is not used, but must exist. */
struct tia_solid {
    const struct tia_shape *members;
    const uint8_t *steps;              /* enum tia_solid_step */
    uint32_t member_count, step_count; /* 1..TIA_SOLID_MEMBERS; 2 member_count - 1 */
};

#ifdef __cplusplus
}
#endif

#endif
