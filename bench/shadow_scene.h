/* shadow_scene.h - the meshes of mesh_scene.h above a plane, as a scene with shadows. */
#ifndef BENCH_SHADOW_SCENE_H
#define BENCH_SHADOW_SCENE_H

#include <tia/raster.h>

#include "mesh_scene.h"
#include "shadow/volume.h"

#define SHADOW_LAMPS 4

/* A scene with one light, the first of SHADOW_LAMPS; scene.light_count may be set up to that number. */
struct shadow_scene {
    struct mesh mesh;
    struct tia_vec3 *points;
    struct tia_face *faces;
    struct tia_mesh solids[MESH_SOLIDS];
    struct tia_shape shapes[MESH_SOLIDS + 1];
    struct tia_scene scene;
};

/* Ends the program if `fine` is false. */
void shadow_must(bool fine);

/* Allocates memory for meshes of every level. */
void shadow_scene_init(struct shadow_scene *s);
/* Makes the scene with a mesh of one of MESH_LEVELS levels. */
void shadow_scene_make(struct shadow_scene *s, int level);
void shadow_scene_free(struct shadow_scene *s);

/* The passes that draw the scene in one image: depths alone, and counts of shadow volumes for the scene's light. */
struct shadow_passes {
    struct tia_flat_scene flat;
    tia_flat_light light;
    struct tia_raster_target target;
    void *memory[2];
};

enum shadow_pass { SHADOW_DEPTH, SHADOW_ZFAIL, SHADOW_ZPASS, SHADOW_PASSES };

void shadow_passes_init(struct shadow_passes *p, const struct shadow_scene *s, uint16_t width, uint16_t height);
void shadow_passes_draw(struct shadow_passes *p, enum shadow_pass pass);
void shadow_passes_free(struct shadow_passes *p);

#endif
