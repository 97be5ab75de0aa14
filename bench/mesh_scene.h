/* mesh_scene.h - the scene of the rasteriser's benchmarks: a ball, a box and a ring on a ground. */
#ifndef BENCH_MESH_SCENE_H
#define BENCH_MESH_SCENE_H

#include <stdint.h>

struct point {
    double x, y, z;
};

#define MESH_SIZES 6
#define MESH_FACES_MAX 100000
#define MESH_SOLIDS 3

/* The mesh: two faces of the ground, then the solids; solid i has the faces first[i]..first[i + 1] - 1. Corners are in
 * counterclockwise order. */
struct mesh {
    struct point (*corner)[3];
    uint32_t count, first[MESH_SOLIDS + 1];
};

/* Fills the mesh with 98, 350, 1358, 5390, 21518 or 86030 faces, for depths 0 to 5. It must have memory for
 * MESH_FACES_MAX faces. */
void bench_mesh(struct mesh *m, int depth);

#endif
