/* sure.h - certified rays in double precision: a result is used only where its error bound proves it equal to the
 * fixed-point result.
 *
 * A pixel is first traced in doubles. Every quantity x carries a bound e on its distance from the fixed-point quantity,
 * whose roundings are included: |x_double - x_fixed| <= e. Each decision - hit or miss, the nearer of two, lit or not,
 * this level of a colour or the next - is made only where it is the same for all of x +- e. A sample with an undecided
 * decision is traced by the fixed-point code from its camera ray on. So the fixed-point code decides wherever doubles
 * might differ from it. A bound that is too small is the only way to a wrong bit, one that is too large only takes
 * time.
 *
 * The result does not depend on lanes, their order, or fused products and sums: the bounds hold for any of them.
 * Instruction sets need not agree on which samples are certain.
 *
 * This file has the scene in doubles. Its constants are computed by the fixed-point functions and then converted, so
 * each is off by 2^-53 of itself at most. */
#ifndef TIA_SIMD_RAYS_SURE_H
#define TIA_SIMD_RAYS_SURE_H

#include "render/trace/trace.h"

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

struct sure_face {
    double at[3][3], normal[3], smooth[3][3];
    double extent; /* of the two edges at the first corner: the larger |x| + |y| + |z| */
    double bend;   /* |x| + |y| + |z| of the other smooth normals' differences from the first, added */
    bool any, smoothed;
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
    const struct sure_face *faces; /* a mesh's faces */
    const struct sure_pair *pairs; /* pairs of the faces, the items of a mesh's leaves */
    const uint32_t *groups;        /* groups of the faces, or NULL */
    uint32_t node_count;
    double centre[3], extent; /* of the box around all items: its centre, and the sum of its half axes */
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
    bool fixed_only; /* a light's kind lacks TIA_LIGHT_SIMD: the fixed-point path draws the whole scene */
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

/* A block of pixels, the first of which is (x, y). With n samples per pixel, slot i is sample i % n of pixel i / n;
 * pixels are numbered row by row. */
struct sure_block {
    const struct sure_scene *scene;
    struct cancel cancel;
    int x, y, width, height, samples;
    double colour[3][SURE_ENDS], error[SURE_ENDS];
    bool unsure[SURE_SLOTS];
    double threshold[SURE_SIDE][16]; /* thresholds of each row's pixels by x mod 8, stored twice */
    tia_rgb565 pixels[SURE_ENDS];    /* undefined where `open` is set */
    bool open[SURE_ENDS];
};

struct sure_gather;

struct sure_kernels {
    void (*trace)(struct sure_block *block, void *memory);
    void (*set_pixels)(struct sure_block *block);
    void (*occlude)(struct sure_gather *gather, void *memory);
    void (*walk)(struct sure_gather *gather, void *memory);
    size_t block_memory, gather_memory; /* block_memory: bytes for the first kernel; gather_memory: for the last two;
                                           both aligned to 64 */
};

#define P2M(n) (1.0 / (double)(UINT64_C(1) << (n))) /* 2^-n, n < 64 */
#define SURE_UNIT P2M(45)                           /* unit of fixed-point coordinates */
#define SURE_EPS P2M(53)                            /* half a unit in the last place of 1.0 */

/* Units of Q16.16 and similar formats, and of 32 random bits. Products of integers with these are exact. */
#define SURE_Q16 P2M(16)
#define SURE_Q30 P2M(30)
#define SURE_Q32 P2M(32)
#define SURE_Q62 P2M(62)

static inline double sure_length(num_length x)
{
    return (double)x * SURE_UNIT;
}

/* Returns 2^bits for bits in -28..31. */
static inline double sure_two_to(int bits)
{
    return bits < 0 ? 1 / (double)(INT64_C(1) << -bits) : (double)(INT64_C(1) << bits);
}

static inline double sure_cosine(num_unit d)
{
    return (double)d * SURE_Q62;
}

static inline void sure_point(double to[3], struct num_point p)
{
    to[0] = sure_length(p.x);
    to[1] = sure_length(p.y);
    to[2] = sure_length(p.z);
}

static inline void sure_dir(double to[3], struct num_dir d)
{
    to[0] = sure_cosine(d.x);
    to[1] = sure_cosine(d.y);
    to[2] = sure_cosine(d.z);
}

static inline void sure_rgb(double to[3], const struct tia_rgb *c)
{
    to[0] = (double)c->r * SURE_Q30;
    to[1] = (double)c->g * SURE_Q30;
    to[2] = (double)c->b * SURE_Q30;
}

static inline double sure_most3(const double c[3])
{
    double most = c[0] > c[1] ? c[0] : c[1];

    return most > c[2] ? most : c[2];
}

/* Returns a face's edges. Corners are multiples of 2^-16 and the centre is a multiple of 2^-17, so that only A x B is
 * rounded. */
static inline struct sure_edges sure_edges_of(const struct sure_face *f, const double centre[3])
{
    struct sure_edges e;

    for (int i = 0; i < 3; i++) {
        const double *from = f->at[i], *to = f->at[i < 2 ? i + 1 : 0];
        const double a[3] = {from[0] - centre[0], from[1] - centre[1], from[2] - centre[2]};
        const double b[3] = {to[0] - centre[0], to[1] - centre[1], to[2] - centre[2]};
        for (int k = 0; k < 3; k++) {
            int x = k < 2 ? k + 1 : 0, y = k > 0 ? k - 1 : 2;
            e.edge[i][0][k] = a[x] * b[y] - a[y] * b[x];
            e.edge[i][1][k] = to[k] - from[k];
        }
    }
    return e;
}

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
    struct sure_face *faces;
    struct sure_grid *grids;
    struct sure_instance *instances;
};

/* Largest number of nodes made from a given hierarchy of `count` nodes. */
#define SURE_NODES(count) (((count) + 1) / 2)

/* Makes the nodes; returns their number. A given node with at most `few` items below it becomes a leaf. */
uint32_t tia_sure_set_nodes(struct sure_node *to, const struct tia_bvh_tree *from, uint32_t few);

/* Largest number of pairs of a mesh: (nodes + 1)/2 nodes are leaves, each of which leaves half a pair empty at most. */
#define SURE_PAIRS(items, nodes) (((items) + ((nodes) + 1) / 2) / 2)

/* Makes the pairs, and replaces the items of the leaves by them; returns their number. */
uint32_t tia_sure_set_pairs(struct sure_pair *to, struct sure_node *nodes, const struct sure_tree *tree);

void tia_sure_set_objects(struct sure_scene *scene, const struct sure_places *places);
void tia_sure_set_face(struct sure_face *to, const struct tia_vec3 corner[3]);

/* Gives the coordinates of sample i of an area light along the light's axes, for pixels of class `class`, see
 * trace/ray_light.c. */
void tia_sure_place(const struct sure_light *light, unsigned i, unsigned class, double at[2]);

/* Computes the colour of sample i of a pixel by the fixed-point path; it is not clamped. */
void tia_sure_sample(const struct ray_view *view, int x, int y, int i, num_length colour[3]);

#endif
