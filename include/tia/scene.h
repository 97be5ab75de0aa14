/* scene.h - what is drawn: the caller's const arrays, never copied, never changed.
 *
 * A scene is accepted by tia_scene_check when every point of it, lights included, stays nearer to every
 * place that the eye takes than 32768, of shapes the boxes around them (tia_object_bounds, without its
 * margin); then no computation in tia overflows. All ranges are where the fields are.
 *
 * An object's index, where a function asks or tells one, counts the spheres and then the shapes.
 *
 * Scenes of at most TIA_SPAN_SPHERES spheres and no other shapes, of colour, transmission and emission,
 * lit by point lights without attenuation and seen by a camera that looks along -z with one sample a
 * pixel, are drawn by spans (src/span); all others by general rays (src/ray). The scene alone decides.
 */
#ifndef TIA_SCENE_H
#define TIA_SCENE_H

#include <tia/camera.h>
#include <tia/light.h>
#include <tia/material.h>
#include <tia/shape.h>

#define TIA_SPAN_SPHERES 256
#define TIA_DEPTH 5 /* of a scene that names no other */
#define TIA_DEPTH_MAX 16
#define TIA_OBJECTS_MAX (UINT32_C(1) << 24) /* spheres and shapes; also a mesh's faces */

/* A key that puts a light somewhere: on its press, light number `light` becomes `state`; with
 * fewer lights than that, it is added at the end. */
struct tia_binding {
    uint16_t key; /* enum tia_key, see port.h */
    uint16_t light;
    struct tia_light state; /* the light as the key leaves it */
};

struct tia_scene {
    struct tia_camera camera;
    struct tia_rgb background; /* each channel in [0, 1] */
    const struct tia_material *materials;
    const struct tia_sphere *spheres;
    const struct tia_light *lights;
    const struct tia_binding *bindings;
    uint32_t material_count, sphere_count, light_count, binding_count;

    /* What asks for general rays. */
    const struct tia_shape *shapes;
    const struct tia_transform *transforms;
    const struct tia_texture *textures;
    const struct tia_mesh *meshes;
    const struct tia_grid *grids;
    uint32_t shape_count, transform_count, texture_count, mesh_count, grid_count;
    uint32_t depth;            /* how often a ray may be reflected or refracted; 0: TIA_DEPTH */
    const struct tia_bvh *bvh; /* NULL, or of this scene, see bvh.h: found sooner, the same picture */

    /* What moves, see motion.h; pictures are of the scene as it is without. */
    const struct tia_track *tracks;
    uint32_t track_count;
};

/* What tia_scene_check found: "sphere 3: radius: must be at least 0.001". */
struct tia_fault {
    const char *thing; /* "sphere", "shape", "mesh", "light", "material", "key", "camera", "scene", ... */
    uint32_t index;    /* which one, from 0; for "camera" and "scene" 0 */
    const char *field;
    const char *rule; /* the range that the field must keep */
};

/* TIA_OK, or TIA_ERR_RANGE with *fault filled in (fault may be NULL). Time: one pass, and another
 * over the shapes for each 16 meshes or grids. */
int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault);

/* The scene shown when no other is named, scenes/thesis.tia: a ball on a ground sphere, no light; keys
 * a, d, s, w put one above left, above right, near the eye and far from it. */
extern const struct tia_scene tia_thesis_scene;

#endif
