/* float_world.h - a scene as spheres and triangles of floats, in a hierarchy of boxes. */
#ifndef BENCH_FLOAT_WORLD_H
#define BENCH_FLOAT_WORLD_H

#include <stdbool.h>
#include <tia/scene.h>

#include "float_vec.h"

/* A triangle, or with a radius a sphere around its first corner. */
struct float_item {
    struct vec corner, side[2];
    float radius;
    uint32_t material;
};

struct float_node {
    struct vec low, high;
    /* Leaf: the range of its items. Inner node: count is 0, and `first` is the first of two nodes, which differ along
     * `axis`. */
    uint32_t first, count;
    int axis;
};

struct float_ray {
    struct vec origin, direction;
};

struct float_hit {
    float t;
    const struct float_item *item; /* NULL: none */
};

struct float_world {
    struct float_item *items;
    struct float_node *nodes;
    uint32_t count, node_count;
};

/* Builds the hierarchy; false when the scene has anything but spheres and meshes, or memory is short. */
bool float_world_build(struct float_world *world, const struct tia_scene *scene);
void float_world_free(struct float_world *world);

/* Finds the nearest item closer than hit->t; with `any`, any item closer than that. */
void float_world_meet(const struct float_world *world, const struct float_ray *ray, bool any, struct float_hit *hit);

static inline struct vec float_place(struct tia_vec3 v)
{
    return (struct vec){(float)v.x / 65536, (float)v.y / 65536, (float)v.z / 65536};
}

#endif
