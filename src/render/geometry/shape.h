/* shape.h - the common interface of all shapes, for intersecting rays.
 *
 * A shape is prepared once for a view: `struct shape` has its constants, in the shape's own axes, and the table of its
 * kind's functions. The functions do not depend on transforms: for a shape with a transform the ray is first converted
 * to the shape's axes (instance.h).
 */
#ifndef TIA_RENDER_GEOMETRY_SHAPE_H
#define TIA_RENDER_GEOMETRY_SHAPE_H

#include <tia/bvh.h>

#include "num/num_ray.h"
#include "scene/cancel.h"

struct ray {
    struct num_point origin;
    struct num_dir direction; /* of length 1 */
#ifdef TIA_WATCHED
    uint32_t *tests; /* NULL, or counts the ray's tests, see struct tia_observer */
#endif
};

/* Sets the ray's counter of tests; NULL: none. Without observers this function and the two below are empty. */
static inline void ray_watch(struct ray *ray, uint32_t *tests)
{
#ifdef TIA_WATCHED
    ray->tests = tests;
#else
    (void)ray;
    (void)tests;
#endif
}

/* Sets the ray's counter of tests to that of a second ray. */
static inline void ray_watch_as(struct ray *ray, const struct ray *other)
{
#ifdef TIA_WATCHED
    ray->tests = other->tests;
#else
    (void)ray;
    (void)other;
#endif
}

/* Adds to the ray's counter of tests. */
static inline void ray_tested(const struct ray *ray, uint32_t count)
{
#ifdef TIA_WATCHED
    if (ray->tests)
        *ray->tests += count;
#else
    (void)ray;
    (void)count;
#endif
}

/* An intersection. `element` is a part of the shape: a face, a cap, a cell; see each shape. */
struct intersection {
    num_length t;
    uint32_t element;
};

/* A part of the line of a ray that is inside a shape. enter.t is negative if the ray starts inside; its element is then
 * undefined. */
struct chord {
    struct intersection enter, leave;
};

/* The surface at an intersection, for shading. */
struct surface {
    struct num_dir normal; /* geometric normal of length 1, outward as in tia/shape.h */
    struct num_dir smooth; /* shading normal: interpolated on a smooth mesh, elsewhere equal to `normal` */
};

struct shape;

/* The functions of a kind. `ray` and `point` are in the shape's axes. Only intersections with 0 <= t <= limit count;
 * `limit` is at most NUM_LENGTH_MAX. */
struct shape_kind {
    /* Sets the shape's constants. `given` is from a scene that tia_scene_check accepts. */
    void (*prepare)(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given);
    /* Finds the nearest intersection; of several at the same t, the one with the lowest element. False: none. */
    bool (*intersect)(const struct shape *shape, const struct ray *ray, num_length limit,
                      struct intersection *intersection);
    /* True if there is any intersection; must not be slower than `intersect`. Without a faster test, this is
     * shape_occludes. */
    bool (*occluded)(const struct shape *shape, const struct ray *ray, num_length limit);
    /* Gives the normals at a point. */
    void (*surface)(const struct shape *shape, struct num_point point, uint32_t element, struct surface *surface);
    /* Gives the surface coordinates of a point, see tia/shape.h. */
    void (*uv)(const struct shape *shape, struct num_point point, uint32_t element, num_length uv[2]);
    /* NULL for shapes that cannot be members of solids. Else finds the first chord of the ray's line with leave.t above
     * `after`, which is at least -NUM_LENGTH_LEAST. */
    bool (*chord)(const struct shape *shape, const struct ray *ray, num_length after, struct chord *chord);
};

/* A plane or disc. */
struct prepared_plane {
    struct num_point point; /* disc: its centre */
    struct num_dir normal, tangents[2];
    num_length radius; /* disc: its radius */
};

/* A cylinder or cone in its own axes: the axis runs along `axis` from the base to base + length axis. */
struct prepared_cone {
    struct num_point base;
    struct num_dir axis, across[2]; /* of length 1, at right angles; `across` are the tangents U and -V of `axis` */
    num_length length, base_radius, top_radius;
    struct num_point anchor;           /* the thinner end of the axis */
    num_length anchored;               /* height of the anchor above the base */
    num_length reach;                  /* largest distance of a point of the shape from the anchor */
    num_length thickness;              /* largest distance of a point of the shape from the axis */
    num_unit slope_cosine, slope_sine; /* slope of the side against the axis: 1 and 0 for a cylinder; see round.c */
    bool capped;
};

struct prepared_box {
    struct num_point min, max;
};

struct prepared_sphere {
    struct num_point centre;
    num_length radius;
};

struct prepared_mesh {
    const struct tia_mesh *mesh;
    const struct tia_bvh_tree *tree; /* NULL: all faces are tested */
};

struct prepared_grid {
    const struct tia_grid *grid;
    struct num_point corner;
    num_length cell;
};

/* A solid; its members are in its own axes. */
struct prepared_solid {
    const struct tia_solid *solid;
    const struct shape *members;
};

struct prepared_torus {
    struct num_point centre;
    struct num_dir axis, across[2]; /* of length 1, at right angles, as those of a cone */
    num_length major, minor;
    num_length reach;    /* radius of a ball around the centre that has the torus inside */
    num_divisor per;     /* of reach, the unit of the numbers below */
    num_unit ring, bulk; /* R^2 and R^2 - r^2 */
};

struct prepared_rounded {
    struct prepared_box box;
    num_length radius;
};

/* Parts that a refracted ray may enter: none, the shape, or one of its cells. */
enum inside { INSIDE_NONE, INSIDE_WHOLE, INSIDE_CELLS };

struct shape {
    const struct shape_kind *kind;
    const struct instance *instance; /* NULL: the world's axes */
    uint32_t material;
    enum inside inside; /* the parts that a refracted ray may enter */
    bool layered;       /* the shape has an opacity texture */
    int8_t uv_bits;     /* the shape's coordinates u, v times 2^uv_bits are those of its textures */
    union {
        struct prepared_sphere sphere;
        struct prepared_plane plane; /* also used for discs */
        struct prepared_cone cone;   /* also used for cylinders */
        struct prepared_box box;
        struct tia_triangle triangle;
        struct prepared_mesh mesh;
        struct prepared_grid grid;
        struct prepared_solid solid;
        struct prepared_torus torus;
        struct prepared_rounded rounded;
    };
};

/* The kinds, one in each file: SHAPE_KIND(box) in box.c. */
#define SHAPE_KIND(name) NAMES(name##_kind)
#define DECLARE(KIND, name) extern const struct shape_kind SHAPE_KIND(name);
TIA_SHAPES(DECLARE)
#undef DECLARE

/* Sets shape->kind and the constants. */
void shape_prepare(struct shape *shape, const struct tia_scene *scene, const struct tia_shape *given);

/* True if a mesh's faces enclose a volume, see tia/material.h. Undefined once cancelled. */
bool mesh_is_closed(const struct tia_mesh *mesh, struct cancel *cancel);

/* Returns the number of a mesh's groups of faces that a ray meets at 0 <= t <= limit; the mesh must have groups. */
uint32_t mesh_groups_met(const struct shape *shape, const struct ray *ray, num_length limit);

/* Implements `occluded` for shapes without a faster test: calls intersect. */
bool shape_occludes(const struct shape *shape, const struct ray *ray, num_length limit);

/* Returns the material of an element: a grid's cells and a solid's members have their own. */
uint32_t shape_material(const struct shape *shape, uint32_t element);

/* Returns the member of a solid that an element belongs to; for other shapes, the shape itself. *element becomes the
 * member's own. */
const struct shape *shape_part(const struct shape *shape, uint32_t *element);

/* Gives the axes A, B of tia/light.h for a normal. */
void shape_axes(struct num_dir normal, struct num_dir axes[2]);

/* Gives the tangents U, V of tia/shape.h for a normal. */
void shape_tangents(struct num_dir normal, struct num_dir tangents[2]);

/* True for the normals y and -y, whose tangents are defined separately. */
static inline bool shape_is_upright(struct num_dir normal)
{
    return normal.x == 0 && normal.z == 0;
}

/* Intersects a ray with one of the scene's spheres, which are not prepared. False if no intersection has 0 <= t <=
 * limit. */
bool sphere_intersect(struct num_point centre, num_length radius, const struct ray *ray, num_length limit,
                      num_length *t);
/* Gives the normals at a point of a sphere. */
void sphere_surface(struct num_point centre, struct num_point point, struct surface *surface);
/* Gives the surface coordinates of a point of a sphere. */
void sphere_uv(struct num_point centre, struct num_point point, num_length uv[2]);

#endif
