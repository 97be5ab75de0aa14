/* shadow_scene.h - the meshes of mesh_scene.h above a plane, as a scene with shadows. */
#ifndef BENCH_SHADOW_SCENE_H
#define BENCH_SHADOW_SCENE_H

#include <tia/raster.h>

#include "mesh_scene.h"
#include "shadow/volume.h"

#define SHADOW_LAMPS 4

/* A scene with SHADOW_LAMPS lights. scene.light_count is 1 at first, and may be set up to SHADOW_LAMPS. */
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
/* Makes the scene with the mesh of a level below MESH_LEVELS. */
void shadow_scene_make(struct shadow_scene *s, int level);
void shadow_scene_free(struct shadow_scene *s);

/* The passes that draw the scene into an image, strip by strip: one for the depths, and two that count the shadow
 * volumes of the scene's light. */
struct shadow_passes {
    struct tia_flat_scene flat;
    tia_flat_light light;
    struct tia_raster_target target;
    unsigned rows;  /* of a strip */
    uint8_t *roles; /* see tia_shadow_keep_roles() */
    void *memory[2];
};

enum shadow_pass { SHADOW_DEPTH, SHADOW_ZFAIL, SHADOW_ZPASS, SHADOW_PASSES };

/* Strips have `rows`. */
void shadow_passes_init(struct shadow_passes *p, const struct shadow_scene *s, struct tia_tile image, unsigned rows);
/* Adds the milliseconds of a pass over a strip at row y. Counts need the depths of the same strip. */
void shadow_passes_draw(struct shadow_passes *p, enum shadow_pass pass, unsigned y, double *ms);
void shadow_passes_free(struct shadow_passes *p);

#endif
