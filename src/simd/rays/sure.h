/* sure.h - certified rays in double precision: a result is used only where its error bound proves it equal to the
 * fixed-point result.
 *
 * A pixel is first traced in doubles. Every quantity x carries a bound e on its distance from the fixed-point quantity,
 * whose roundings are included: |x_double - x_fixed| <= e. Each decision - hit or miss, the nearer of two, lit or not,
 * this level of a colour or the next - is taken only when it is the same all over x +- e. A sample with an undecided
 * decision is traced by the fixed-point code from its camera ray on. So the fixed-point path decides wherever doubles
 * might differ; a bound that is too small is the only way to a wrong bit, one that is too large only takes time.
 *
 * The result does not depend on lanes, their order, or fused products and sums: the bounds hold for any of them.
 * Instruction sets need not agree on which samples are certain.
 *
 * Here: the scene in doubles. Its constants are computed by the fixed-point functions and then converted, so each is
 * within 2^-53 of its size. */
#ifndef TIA_SIMD_RAYS_SURE_H
#define TIA_SIMD_RAYS_SURE_H

#include "render/trace/trace.h"

#define SURE_INNER UINT32_MAX

/* A node: two children side by side. A child's box is that of the hierarchy, in floats rounded outward. If `count` is
 * SURE_INNER the child is node `index`, else a leaf: items[index] .. items[index + count - 1]; of a mesh, pairs from
 * pairs[index] on. A root that is a leaf is the only child of a node, whose other child has no items and a box at
 * SURE_NOWHERE. */
struct sure_node {
    float box[6][2]; /* minimum x, y, z, maximum x, y, z */
    uint32_t index[2], count[2];
};

#define SURE_NOWHERE 1e9f

struct sure_face {
    double at[3][3], normal[3], smooth[3][3];
    double extent; /* of all edges: the largest |x| + |y| + |z| */
    double bend;   /* the largest distance between the smooth normals */
    bool any, smoothed;
};

/* The edges of a face, each from A to B as seen from a centre: A x B and B - A. */
struct sure_edges {
    double edge[3][2][3];
};

/* Two faces side by side, in floats: of their first two edges as above, and the sum of all three A x B. `size` is c of
 * pairs_tmpl.h. If a leaf has an odd number of faces, the last one is in both places of its pair, the second time with
 * SURE_NONE. */
struct sure_pair {
    float edge[2][2][3][2], whole[3][2], size[2];
    uint32_t face[2];
};

#define SURE_NONE -1e30f /* a value for which a line is always outside */
#define SURE_LEAF 16     /* number of faces that are tested at once; a mesh of no more has no hierarchy */
#define SURE_FEW 8       /* most items of a mesh below a node that becomes a leaf: pairs take less time than nodes */

struct sure_tree {
    const struct sure_node *nodes;
    const uint32_t *items;
    const struct sure_face *faces; /* a mesh's faces */
    const struct sure_pair *pairs; /* pairs of the faces, the items of a mesh's leaves */
    const uint32_t *groups;        /* groups of the faces, or NULL */
    uint32_t node_count;
    double centre[3], extent; /* box of a mesh: its centre, and the sum of its half axes */
};

/* Kinds of shapes; SURE_UNKNOWN: may be hit anywhere in its box. */
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
    double position[3], axes[3][3], scale[3], inverse[3], least, most; /* least, most: of the scales */
    double size;                                                       /* extent of the box in the world */
    double centre[3], extent;                                          /* centre and extent of the shape in its own
                                                                          axes */
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
    bool grouped;                                      /* the object filters light once for each group of faces */
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
    double constant, linear, quadratic, unit; /* attenuation of a light that has it */
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
    double brightest[TIA_DEPTH_MAX + 1]; /* largest colour of a ray, by its number of bounces */
    double generations;       /* largest number of rays, each with no more light than the one before; 0: unlimited */
    double centre[3], extent; /* box of all bounded objects and lights: its centre, and the sum of its half axes */
    double background[3], bias;
    const struct sure_paths *paths; /* NULL unless the view has samples */
    struct sure_camera camera;
};

#define SURE_SIDE 16 /* width and height of a block, in pixels of one sample each */
#define SURE_SLOTS (SURE_SIDE * SURE_SIDE)
#define SURE_ENDS (SURE_SLOTS + 8) /* number of elements, since whole packets may extend beyond the last slot */

/* The work of a packet in items of cancel.h, besides its hits: so that 32 packets with few hits come between two calls
 * of `stop`. */
#define SURE_PACKET (CANCEL_INTERVAL / 32)

/* A block of pixels from (x, y) on; slot i is sample i % n of pixel i / n, where the pixels of a row are
 * consecutive. */
struct sure_block {
    const struct sure_scene *scene;
    struct cancel cancel;
    int x, y, width, height, samples;
    double colour[3][SURE_ENDS], error[SURE_ENDS];
    bool unsure[SURE_SLOTS];
    double threshold[SURE_SIDE][16]; /* thresholds of each row's pixels by x mod 8, stored twice */
    tia_rgb565 pixels[SURE_ENDS];    /* pixels of undecided samples are not set */
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

/* Units of Q16.16 and similar formats, and of 32 random bits: products with them are exact. */
#define SURE_Q16 P2M(16)
#define SURE_Q30 P2M(30)
#define SURE_Q32 P2M(32)
#define SURE_Q62 P2M(62)

static inline double sure_length(num_length x)
{
    return (double)x * SURE_UNIT;
}

/* Returns 2^bits, -28..31. */
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

/* Returns a face's edges. Corners are integers in units of 2^-16 and a centre halves of them, so that only the products
 * of A x B are rounded. */
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

/* Returns the bytes for a scene. */
size_t tia_sure_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Returns the view's scene, in the view's memory. */
struct sure_scene *tia_sure_scene(const struct tia_view *view);

/* Sets the scene, without its lights. */
void tia_sure_prepare(struct tia_view *view);

/* Sets the scene's lights, whenever they change. */
void tia_sure_set_lights(struct tia_view *view);

/* Arrays for the objects' data, with an element for each shape. */
struct sure_places {
    struct sure_object *objects;
    struct sure_round *rounds;
    struct sure_face *faces;
    struct sure_grid *grids;
    struct sure_instance *instances;
};

/* Number of nodes for a hierarchy of `count` nodes with boxes of their own. */
#define SURE_NODES(count) (((count) + 1) / 2)

/* Makes the nodes, with leaves of at most `few` items; returns their number. */
uint32_t tia_sure_set_nodes(struct sure_node *to, const struct tia_bvh_tree *from, uint32_t few);

/* Largest number of pairs of a mesh: of its nodes one more than half are leaves, each with half a pair empty at most.
 */
#define SURE_PAIRS(items, nodes) (((items) + ((nodes) + 1) / 2) / 2)

/* Makes the pairs, and makes them the items of the leaves; returns their number. */
uint32_t tia_sure_set_pairs(struct sure_pair *to, struct sure_node *nodes, const struct sure_tree *tree);

void tia_sure_set_objects(struct sure_scene *scene, const struct sure_places *places);
void tia_sure_set_face(struct sure_face *to, const struct tia_vec3 corner[3]);

/* Gives the place of sample i of an area light along its axes, in a pixel of class `class`: see trace/ray_light.c. */
void tia_sure_place(const struct sure_light *light, unsigned i, unsigned class, double at[2]);

/* Gives the colour of sample i of a pixel by the fixed-point path, not clamped. */
void tia_sure_sample(const struct ray_view *view, int x, int y, int i, num_length colour[3]);

#endif
