/* sure.h - certified rays in double precision: a result is used only where its error bound proves it equal to the
 * fixed-point result.
 *
 * A pixel is first traced in doubles. Every quantity x carries a bound e on its distance from the fixed-point quantity,
 * whose roundings are included: |x_double - x_fixed| <= e. Each decision - hit or miss, the nearer of two, lit or not,
 * this level of a colour or the next - is made only where it is the same for all of x +- e. A ray with an undecided
 * decision is followed by the fixed-point code, which gets the hits of the rays before it; or its sample is traced from
 * the camera ray on. So the fixed-point code decides wherever doubles might differ from it. A bound that is too small
 * is the only way to a wrong bit, one that is too large only takes time.
 *
 * The result does not depend on lanes, their order, or fused products and sums: the bounds hold for any of them.
 * Instruction sets need not agree on which samples are certain.
 *
 * This file has the scene in doubles. Its constants are computed by the fixed-point functions and then converted, so
 * each is off by 2^-53 of itself at most. */
#ifndef TIA_SIMD_RAYS_SURE_H
#define TIA_SIMD_RAYS_SURE_H

#include "render/whitted/whitted.h"
#include "sure_numbers.h"

struct tia_raster_grid;
struct tia_raster_plane;

#define SURE_INNER UINT32_MAX

/* A node: its two children side by side. A child's box is that of the given hierarchy, in floats rounded outward. If
 * `count` is SURE_INNER, the child is node `index`. Otherwise it is a leaf: items[index] .. items[index + count - 1]
 * or, in a mesh, as many pairs from pairs[index] on. If the root is a leaf, it is the first child of the only node; the
 * second child then has no items, and its box is at SURE_NOWHERE. */
struct sure_node {
    float box[6][2]; /* minimum x, y, z, maximum x, y, z */
    uint32_t index[2], count[2];
};

#define SURE_NOWHERE 1e9f

#define SURE_WIDE 8 /* children of a wide node, and most spheres of a leaf that is made of a subtree */
#define SURE_LEAF_AT 0x80000000u
#define SURE_NO_WIDE UINT32_MAX

/* A wide node has its children side by side; the boxes of missing ones are empty. A child is the index of a wide node,
 * or SURE_LEAF_AT and the place of a leaf in the doubles `leaves` of the tree. A leaf starts with its number of spheres
 * n, followed by n numbers each for their x, y, z, radii and indices of objects. */
struct sure_wide {
    float box[6][SURE_WIDE];
    uint32_t child[SURE_WIDE], unused[SURE_WIDE]; /* so that a node takes whole lines of a cache */
};

/* Largest number of children that wait in a walk. */
#define SURE_WIDE_WAITS ((SURE_WIDE - 1) * (TIA_BVH_DEPTH_MAX + 1) + 1)

/* Least and largest number of spheres for wide nodes. With 820 spheres packets take as long, with 7381 longer. Places
 * of leaves have 31 bits. */
#define SURE_SCATTERED 2048
#define SURE_MOST_SPHERES (SURE_LEAF_AT / 6 - 2)

struct sure_face {
    double at[3][3], normal[3];
    double extent; /* of the two edges at the first corner: the larger |x| + |y| + |z| */
    bool any;      /* it has a normal */
};

/* What is stored for a face of a mesh: its normal, its first corner in Q16.16, and `extent` as in struct sure_face,
 * rounded up, but not above 0 if the face has no normal. The rest is read from the mesh, see sure_face_of(). Of a large
 * mesh nothing is stored, since a ray meets two faces of three million: see sure_flat_of(). */
struct sure_flat {
    double normal[3];
    struct tia_vec3 corner;
    float extent;
};

/* The edges of a face, relative to a centre: A x B and B - A for an edge from A to B. */
struct sure_edges {
    double edge[3][2][3];
};

/* Two faces side by side, in floats: their first two edges as in struct sure_edges, and the sum of all three A x B.
 * `size` is c of pairs_tmpl.h. If a leaf has an odd number of faces, its last face takes both places of the last pair,
 * and the second place has the `size` SURE_NONE. */
struct sure_pair {
    float edge[2][2][3][2], whole[3][2], size[2];
    uint32_t face[2];
};

#define SURE_NONE -1e30f /* size of a face that no line meets */
#define SURE_LEAF 16     /* number of faces that are tested at once; a mesh of no more has no hierarchy */
#define SURE_FEW 8       /* most items below a mesh's node that is made a leaf: pairs take less time than nodes */

struct sure_tree {
    const struct sure_node *nodes;
    const uint32_t *items;
    const struct sure_flat *faces; /* a mesh's faces; NULL if it has more than BVH_LARGE_MESH */
    const struct tia_mesh *mesh;   /* the mesh */
    const double (*normals)[3];    /* the mesh's normals */
    const struct sure_pair *pairs; /* pairs of the faces, the items of a mesh's leaves */
    const uint32_t *groups;        /* groups of the faces, or NULL */
    const struct sure_wide *wide;  /* wide nodes of the subtrees that have only spheres, or NULL */
    const double *leaves;          /* leaves of the wide nodes */
    const uint32_t *wide_of;       /* for each node its wide node, or SURE_NO_WIDE */
    uint32_t node_count;
    double centre[3], extent; /* of the box around all items: its centre, and the sum of its half axes */
    bool level;               /* all vertices of the mesh have the same coordinate `height` along `axis` */
    int axis;
    double height;
};

/* Kinds of shapes. A shape of kind SURE_UNKNOWN may be hit anywhere in its box. */
enum sure_kind {
    SURE_UNKNOWN,
    SURE_SPHERE,
    SURE_MESH,
    SURE_TRIANGLE,
    SURE_PLANE,
    SURE_DISC,
    SURE_ROUND,
    SURE_BOX,
    SURE_GRID
};

/* A cylinder or cone, see struct prepared_cone. */
struct sure_round {
    double axis[3], across[2][3], base[3], anchor[3];
    double anchored, reach, length, base_radius, top_radius, cosine, sine;
    bool capped;
};

struct sure_instance {
    double position[3], axes[3][3], scale[3], inverse[3], least, most; /* least, most: of `scale` */
    double size;                                                       /* |min| + |max| of the box, summed over axes */
    double centre[3], extent;                                          /* of the box in the shape's own axes */
};

struct sure_grid {
    const struct tia_grid *from;
    const uint8_t *empty; /* for each octant and each cell, the edge of an empty cube; NULL: not known */
    double corner[3], edge;
};

struct sure_object {
    enum sure_kind kind;
    uint32_t material;
    bool opaque;                                       /* the object transmits no light */
    bool unclear;                                      /* its transmission is undecided */
    bool layered;                                      /* the object has an opacity */
    bool grouped;                                      /* shadow rays are filtered once for each group of faces */
    double at[3], radius, normal[3], axes[2][3], unit; /* a box has its corners in `at` and `normal` */
    const struct tia_mesh *faces;                      /* a mesh's faces */
    double transmission[3];
    const struct sure_tree *mesh;
    const struct sure_face *face;
    const struct sure_round *round;
    const struct sure_grid *grid;
    const struct sure_instance *placed; /* NULL: the world's axes */
};

/* The first column of each colour of a material. */
enum {
    SURE_COLOUR,
    SURE_SPECULAR = 3,
    SURE_MIRROR = 6,
    SURE_REFRACTION = 9,
    SURE_EMISSION = 12,
    SURE_FACING = 15,
    SURE_EXPONENT = 18,
    SURE_COLUMNS
};

struct sure_material {
    double column[SURE_COLUMNS];
    uint32_t groups; /* bit i is clear if columns 3 i, 3 i + 1 and 3 i + 2 are all 0 and may be left out */
    bool known, is_specular, refracts, fresnel;
    const struct tia_texture *texture; /* texture of the colour, or NULL */
    double cells[2][3], repeat[2], offset[2];
};

#define SURE_PLACES 64 /* largest number of samples of a light whose places are stored */
#define SURE_AREAS 16  /* largest number of lights whose places are stored */

struct sure_light {
    const struct ray_light *from;
    double at[3], emission[3], radius;
    double axes[2][3]; /* axes of a disc; sides of a rectangle */
    double normal[3], across[2][3], reach[2];
    double brightest;
    double inner, outer;                      /* cosines of a spot light */
    double constant, linear, quadratic, unit; /* attenuation, if the light has it */
    bool seen;
    double (*place)[2][SURE_PLACES]; /* places of samples along the axes, for each class of pixel; NULL: there are too
                                        many */
};

struct sure_camera {
    double eye[3], u[3], v[3], n[3], left, top, across, upward, away;
    int width, height, side;
    bool orthographic;
};

struct sure_scene {
    const struct ray_view *view;
    struct sure_tree objects;
    const struct sure_tree *meshes;
    const struct sure_object *object;
    struct sure_material *materials;
    struct sure_light *lights;
    double (*places)[16][2][SURE_PLACES]; /* places of the first SURE_AREAS lights */
    const uint32_t *unbounded;
    uint32_t unbounded_count, light_count, depth;
    bool fixed_only; /* fog, a lens, or a light's kind without TIA_LIGHT_SIMD: the fixed-point path draws the whole
                        scene */
    bool areas;      /* a light is an area */
    bool occluded;   /* objects occlude an ambient light: the fixed-point path draws the whole scene */
    double brightest[TIA_DEPTH_MAX + 1]; /* largest colour component of a ray, by its number of bounces */
    double generations; /* limit of the generations of rays, each with no more light than the one before; 0: none */
    double centre[3], extent; /* box of all bounded objects: its centre, and the sum of its half axes */
    double background[3], bias;
    const struct sure_paths *paths; /* NULL unless the view has samples */
    struct sure_camera camera;
};

#define SURE_SIDE 16 /* width and height of a block whose pixels have one sample each */
#define SURE_SLOTS (SURE_SIDE * SURE_SIDE)
#define SURE_ENDS (SURE_SLOTS + 8) /* elements of arrays of slots: whole packets may extend beyond the last slot */

/* The work of a packet besides its hits, in items of cancel.h. So `stop` is polled at least once in 32 packets. */
#define SURE_PACKET (CANCEL_INTERVAL / 32)

/* A face as pixels see it: at pixel (x, y) the inverse of its distance from the eye, along the line of sight, is
 * inverse[0] x + inverse[1] y + inverse[2]; in orthographic views the distance itself. `object` is TIA_NO_OBJECT where
 * the fixed-point path must find the hit. `plain` faces spawn no rays; `normal` and `material` are theirs. */
struct sure_seen_face {
    double inverse[3], normal[3];
    uint32_t object, element, material;
    bool plain;
};

#define SURE_SHARE_BITS 15 /* as TIA_SHARE_BITS */

/* What the rasteriser and a shadow technique have found for a block: for each slot the face, NULL for the background,
 * and the arrivals of ray_tree.h. */
struct sure_seen {
    const struct sure_seen_face *face[SURE_ENDS];
    uint64_t lit[SURE_ENDS];
    const uint16_t *shares[SURE_ENDS]; /* unused unless `shared` */
    const uint8_t *first_bit;
    bool whole, shared;
};

#define SURE_RESTS 64 /* most rays of a block that the fixed-point path follows from where they start */

/* An undecided ray of the sample in this slot. */
struct sure_rest {
    uint32_t slot;
    struct path_route route;
};

/* A block of pixels, the first of which is (x, y). With n samples per pixel, slot i is sample i % n of pixel i / n.
 * Pixels are numbered row by row in cells of `across` x `rows` pixels, one cell after the other, and these row by row.
 * The kernels set `across` and `rows`. */
struct sure_block {
    const struct sure_scene *scene;
    struct cancel cancel;
    int x, y, width, height, samples, across, rows;
    double colour[3][SURE_ENDS], error[SURE_ENDS];
    bool unsure[SURE_SLOTS];
    struct sure_rest rest[SURE_RESTS]; /* their light is missing from `colour` */
    int rest_count;
    double threshold[SURE_ENDS];
    tia_rgb565 pixels[SURE_ENDS]; /* undefined where `open` is set */
    bool open[SURE_ENDS];
    const struct sure_seen *seen; /* used by `shade` alone */
};

/* A pixel's place in the block. */
struct sure_place {
    int x, y;
};

static inline struct sure_place sure_place_of(const struct sure_block *b, int pixel)
{
    int band = b->rows * b->width, cell = b->rows * b->across, in = pixel % band;

    return (struct sure_place){in / cell * b->across + in % b->across, pixel / band * b->rows + in % cell / b->across};
}

struct sure_gather;

struct sure_kernels {
    void (*trace)(struct sure_block *block, void *memory);
    /* As `trace`, for the faces and lights of block->seen, in place of those that camera and shadow rays meet. */
    void (*shade)(struct sure_block *block, void *memory);
    void (*set_pixels)(struct sure_block *block);
    void (*occlude)(struct sure_gather *gather, void *memory);
    void (*walk)(struct sure_gather *gather, void *memory);
    size_t block_memory, gather_memory; /* block_memory: bytes for the first two kernels; gather_memory: for the last
                                           two; both aligned to 64 */
};

/* Returns the size of a scene in bytes. */
size_t tia_sure_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Returns the view's scene, in the view's memory. */
struct sure_scene *tia_sure_scene(const struct tia_view *view);

/* Sets the scene, without its lights. */
void tia_sure_prepare(struct tia_view *view);

/* Sets the scene's lights; called whenever they change. */
void tia_sure_set_lights(struct tia_view *view);

/* Arrays for the objects' data, with an element for each shape; in `objects` the spheres come first. */
struct sure_places {
    struct sure_object *objects;
    struct sure_round *rounds;
    struct sure_face *faces; /* one for each shape */
    struct sure_grid *grids;
    uint8_t *empty; /* cubes of all grids that have them, one grid after the other */
    struct sure_instance *instances;
};

/* Largest number of nodes made from a given hierarchy of `count` nodes. */
#define SURE_NODES(count) (((count) + 1) / 2)

/* Makes the nodes; returns their number. A given node with at most `few` items below it becomes a leaf. */
uint32_t tia_sure_set_nodes(struct sure_node *to, const struct tia_bvh_tree *from, uint32_t few);

/* Largest numbers of wide nodes, and of doubles in their leaves, behind which a vector may be loaded. A wide node with
 * an inner child has eight children and takes the place of seven nodes; any other has more than eight spheres. */
#define SURE_WIDES(spheres) ((spheres) / (SURE_WIDE - 1) + (spheres) / (SURE_WIDE + 1) + 1)
#define SURE_LEAVES(spheres) (6 * (spheres) + SURE_WIDE)

/* Makes wide nodes of the subtrees that have only spheres: objects with indices below `spheres`. */
void tia_sure_widen(struct sure_tree *tree, const struct sure_object *objects, uint32_t spheres,
                    struct sure_wide *nodes, double *leaves, uint32_t *wide_of);

/* Largest number of pairs of a mesh: (nodes + 1)/2 nodes are leaves, each of which leaves half a pair empty at most. */
#define SURE_PAIRS(items, nodes) (((items) + ((nodes) + 1) / 2) / 2)

/* Makes the pairs, and replaces the items of the leaves by them; returns their number. */
uint32_t tia_sure_set_pairs(struct sure_pair *to, struct sure_node *nodes, const struct sure_tree *tree);

void tia_sure_set_objects(struct sure_scene *scene, const struct sure_places *places);

/* Gives the coordinates of sample i of an area light along the light's axes, for pixels of class `class`, see
 * trace/ray_light.c. */
void tia_sure_place(const struct sure_light *light, unsigned i, unsigned class, double at[2]);

/* Sets to->inverse; without a visible plane, to->object becomes TIA_NO_OBJECT. */
void tia_sure_set_plane(struct sure_seen_face *to, const struct tia_raster_plane *plane,
                        const struct tia_raster_grid *grid);

/* Returns a number of 128 bits as a double, see raster/halves.h. */
double tia_sure_double(const uint64_t halves[2]);

/* Computes the colour of sample i of a pixel by the fixed-point path; it is not clamped. */
void tia_sure_sample(const struct ray_view *view, int x, int y, int i, num_length colour[3]);

/* Adds the light of the block's undecided rays to their samples, and clears their list. */
void tia_sure_add_rests(struct sure_block *block);

#endif
