/* float_world.h - a scene as spheres and triangles of floats, in a hierarchy of boxes. */
#ifndef BENCH_FLOAT_WORLD_H
#define BENCH_FLOAT_WORLD_H

#include <stdbool.h>
#include <tia/scene.h>

#include "float_vec.h"

/* A triangle; or, if the radius is not 0, a sphere around `corner`. */
struct float_item {
    struct vec corner, side[2];
    float radius;
    uint32_t material;
};

struct float_node {
    struct vec low, high;
    /* A leaf has `count` items, from number `first` on. An inner node has the count 0 and two children, the nodes
     * `first` and first + 1, whose items are divided along `axis`. */
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

/* Builds the hierarchy. Returns false if the scene has anything but spheres and meshes, or if memory is short. */
bool float_world_build(struct float_world *world, const struct tia_scene *scene);
void float_world_free(struct float_world *world);

/* Finds the nearest item closer than hit->t; with `any`, the first such item that it meets. */
void float_world_meet(const struct float_world *world, const struct float_ray *ray, bool any, struct float_hit *hit);

static inline struct vec float_place(struct tia_vec3 v)
{
    return (struct vec){(float)v.x / 65536, (float)v.y / 65536, (float)v.z / 65536};
}

#endif
