/* scene.h - what is drawn: the caller's const arrays, never copied, never changed.
 *
 * A scene is accepted by tia_scene_check when every point of it, lights included, stays nearer
 * to the eye than 32768; then no computation in tia overflows. All ranges are below.
 */
#ifndef TIA_SCENE_H
#define TIA_SCENE_H

#include <tia/camera.h>
#include <tia/vec.h>

#define TIA_RADIUS_MIN 64 /* the smallest radius of a sphere: 2^-10 as Q16.16 */

/* How a surface answers light. Every channel lies in [0, 1]. */
struct tia_material {
    struct tia_rgb colour;       /* diffuse reflectance (albedo) */
    struct tia_rgb transmission; /* what a shadow ray keeps on its way through: black is opaque */
    struct tia_rgb emission;     /* added to what the surface reflects; lights nothing else */
};

struct tia_sphere {
    struct tia_vec3 centre;
    tia_q16 radius;    /* TIA_RADIUS_MIN or more */
    uint32_t material; /* an index into the scene's materials */
};

/* A light: lights from its centre, casts no shadow, is seen as a sphere of its emission. */
struct tia_light {
    struct tia_vec3 centre;
    tia_q16 radius;          /* 0 (not seen), or TIA_RADIUS_MIN or more */
    struct tia_rgb emission; /* each channel in [0, 2) */
};

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
};

/* What tia_scene_check found: "sphere 3: radius: must be at least 0.001". */
struct tia_fault {
    const char *thing; /* "sphere", "light", "material", "key", "camera", "scene" */
    uint32_t index;    /* which one, from 0; for "camera" and "scene" 0 */
    const char *field;
    const char *rule; /* the range that the field must keep */
};

/* TIA_OK, or TIA_ERR_RANGE with *fault filled in (fault may be NULL). Time: one pass. */
int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault);

/* The scene shown when no other is named: a ball on a ground sphere, no light; keys a, d, s, w
 * put one above left, above right, near the eye and far from it. */
extern const struct tia_scene tia_thesis_scene;

#endif
