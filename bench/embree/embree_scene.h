/* embree_scene.h - a scene of Embree 3 with a device of its own, for one thread. */
#ifndef BENCH_EMBREE_EMBREE_SCENE_H
#define BENCH_EMBREE_EMBREE_SCENE_H

#include <embree3/rtcore.h>
#include <stdbool.h>
#include <stdint.h>

#include "float_vec.h"

struct embree_scene {
    RTCDevice device; /* NULL: none */
    RTCScene scene;   /* NULL: none */
};

/* Begins an empty scene. Returns false if there is none; embree_scene_end is called in any case. */
bool embree_scene_begin(struct embree_scene *scene);
void embree_scene_end(struct embree_scene *scene);

/* Returns the corners of `count` triangles of a new geometry, which the caller sets. */
struct vec (*embree_triangles(RTCGeometry geometry, uint32_t count))[3];

/* Returns `count` points of a new geometry, each with its radius, which the caller sets. */
float (*embree_rounds(RTCGeometry geometry, uint32_t count))[4];

/* Adds a geometry whose buffers are set. */
void embree_attach(struct embree_scene *scene, RTCGeometry geometry, unsigned number);

#endif
