/* walk.h - traversal of a bounding volume hierarchy, without recursion: the leaves that a ray may meet, nearer ones
 * first.
 *
 * A box is skipped only when the ray certainly misses it: boxes are a unit of 2^-16 larger than their contents, and
 * distances are compared with a margin for their error, see num_slope. Pixels do not depend on which leaves are tested,
 * so the test need not be exact. A box that the ray misses by less than 2^-20 of its distance may count as entered. A
 * ray whose direction has a component below 2^-8 enters more boxes than it meets. */
#ifndef TIA_RENDER_GEOMETRY_WALK_H
#define TIA_RENDER_GEOMETRY_WALK_H

#include "shape.h"

struct walk {
    const struct tia_bvh_tree *tree;
    const struct ray *ray;
    struct num_slope slopes[3];
    num_walk near[TIA_BVH_DEPTH_MAX + 2]; /* t of entry of the nodes on the stack */
    uint32_t stack[TIA_BVH_DEPTH_MAX + 2];
    int depth;
};

void walk_start(struct walk *walk, const struct tia_bvh_tree *tree, const struct ray *ray);

/* Returns the next leaf that the ray enters at 0 <= t <= limit, or NULL. */
const struct tia_bvh_node *walk_leaf(struct walk *walk, num_length limit);

/* The objects of a scene that a ray may meet: first those without bounds, then those of each leaf that it enters.
 * Without a hierarchy, all objects. */
struct candidates {
    const struct tia_scene *scene;
    const struct ray *ray;
    const uint32_t *items; /* NULL: the candidates are the numbers next..end - 1 themselves */
    uint32_t next, end;
    bool walking;
    struct walk walk;
};

void candidates_start(struct candidates *candidates, const struct tia_scene *scene, const struct ray *ray);

/* Returns the next candidate, or TIA_NO_OBJECT. The hierarchy excludes objects that cannot be met at 0 <= t <=
 * limit. */
uint32_t candidates_next(struct candidates *candidates, num_length limit);

#endif
