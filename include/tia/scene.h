/* scene.h - the scene: const arrays that belong to the caller; tia never copies or changes them.
 *
 * Each field's range stands beside it. In addition, every point of the scene, lights included, must lie within 32768 of
 * every eye position; shapes count by their bounding boxes (tia_object_bounds without its margin). When tia_scene_check
 * accepts a scene, no computation in tia overflows.
 *
 * An object's index counts the spheres first, then the shapes.
 *
 * The scene alone decides which renderer draws it. The span renderer is the fast one, for scenes of at most
 * TIA_SPAN_SPHERES spheres and no other shapes or meshes, whose materials have only colour, transmission and emission,
 * with point lights without attenuation and a camera that looks along -z with one sample per pixel. Its pixels are the
 * correctly rounded values of the formulas in docs/definition.md. The ray renderer draws all other scenes that have
 * neither another integrator, see integrator.h, nor another technique for shadows, see shadow.h.
 *
 * A scene's unit of length may be smaller than that of the file it was read from, so that small lengths are stored
 * precisely, or larger, so that large ones fit: a length of 1 in the file is 2^scale_bits here. Three quantities stay
 * in the file's units, and the renderer converts them: the attenuation of lights, the surface coordinates of planes and
 * the bias of shadow maps.
 */
#ifndef TIA_SCENE_H
#define TIA_SCENE_H

#include <tia/camera.h>
#include <tia/integrator.h>
#include <tia/light.h>
#include <tia/lightfield.h>
#include <tia/material.h>
#include <tia/shadow.h>
#include <tia/shape.h>

#ifdef __cplusplus
extern "C" {
#endif

#define TIA_SPAN_SPHERES 256
#define TIA_DEPTH_DEFAULT 5 /* reflections and refractions along a path */
#define TIA_DEPTH_MAX 16
#define TIA_SCALE_BITS_MAX 16
#define TIA_FALLS_MAX 256
#define TIA_FALL_END_MAX (INT32_C(1024) * TIA_Q16_ONE)
#define TIA_OBJECTS_MAX (UINT32_C(1) << 24) /* spheres and shapes; also a mesh's faces */

/* A key that sets a light: pressing it sets light number `light` to `state`, or appends a light when the scene has
 * fewer. */
struct tia_binding {
    uint16_t key; /* enum tia_key or ASCII, see port.h */
    uint16_t light;
    struct tia_light state;
};

/* The remainders of lengths, in units of 2^-32, which are added to the scene's fields of the same names. With every
 * reflection, curved mirrors magnify the error of a coordinate, some a hundredfold; flat mirrors do not. So spheres,
 * cylinders, cones and the eye can be more precise than Q16.16. The span renderer ignores these. */
struct tia_fine_sphere {
    struct tia_fine_place centre;
    int16_t radius;
};

struct tia_fine_ends {
    struct tia_fine_place base, top;
    int16_t base_radius, top_radius;
};

struct tia_fine {
    struct tia_fine_place eye, reference;  /* remainders of the camera's eye and reference */
    const struct tia_fine_sphere *spheres; /* one for each of the scene's spheres */
    /* One for each of the scene's shapes; used for cylinders (the base's radius for both ends) and cones without a
     * transform. */
    const struct tia_fine_ends *shapes;
};

/* Fog between the eye and what it sees, in mirrors and through glass as well, but not inside of what refracts. Light on
 * its way to a surface is not dimmed. Of the light at the end of a ray of length t, the share T = exp(-m t / distance)
 * arrives, and the rest is fog: C = T L + (1 - T) colour. m is the mean density along the ray. The density is 1 or, if
 * `height` is not 0, 1 up to y = level and 1/(1 + ((y - level)/height)^2) above, as in POV-Ray's ground fog. A ray that
 * meets nothing has no end: behind fog without a height is only fog. For traced rays: the integrators whitted and path,
 * without a shadow technique. */
struct tia_fog {
    struct tia_rgb colour; /* each channel in [0, 1] */
    tia_q16 distance;      /* at least 2^-10 */
    tia_q16 height;        /* 0, or at least 2^-10 */
    tia_q16 level;         /* with a height only */
};

struct tia_scene {
    struct tia_camera camera;
    struct tia_rgb background; /* each channel in [0, 1] */
    const struct tia_material *materials;
    const struct tia_sphere *spheres;
    const struct tia_light *lights;
    const struct tia_binding *bindings;
    uint32_t material_count, sphere_count, light_count, binding_count;

    /* Members that the span renderer does not support. */
    const struct tia_shape *shapes;
    const struct tia_transform *transforms;
    const struct tia_texture *textures;
    const struct tia_mesh *meshes;
    const struct tia_grid *grids;
    const struct tia_solid *solids;
    uint32_t shape_count, transform_count, texture_count, mesh_count, grid_count, solid_count;
    uint32_t depth; /* maximum reflections and refractions along a path, see material.h; 0 means TIA_DEPTH_DEFAULT */
    struct tia_integration integration; /* another integrator than Whitted's */
    enum tia_shadows shadows;           /* another technique than traced rays, see shadow.h */
    struct tia_shadow_map shadow_map;   /* for TIA_SHADOWS_MAP; all zero: the defaults */
    /* Largest distance, 2^-16 or more, of a flat face from the curved surface that it replaces, for all techniques but
     * traced rays; at most TIA_OBJECTS_MAX faces. 0: rays draw curved shapes. */
    tia_q16 tessellated;
    int scale_bits; /* a unit of the file is 2^scale_bits units here: -TIA_SCALE_BITS_MAX..TIA_SCALE_BITS_MAX */
    const struct tia_fine *fine;         /* NULL, or remainders of lengths: rays then start 2^-26 off a surface */
    const struct tia_light_field *field; /* NULL, or a picture for many eyes; needs a camera with an observer line, and
                                            traced rays for shadows */
    const struct tia_fog *fog;           /* NULL: none */
    const struct tia_lens *lens;         /* NULL: a pinhole; else as for fog, traced rays for shadows */
    const struct tia_bvh *bvh; /* NULL, or the scene's hierarchies, see bvh.h: the same picture in less time */

    /* Keyframes and balls that fall, see motion.h. Rendering ignores them; tia_scene_at applies them. */
    const struct tia_track *tracks;
    uint32_t track_count;
    const struct tia_falling *falling; /* NULL: none */
};

/* Channel values up to this one are black in pictures of 8 bits per channel, sRGB included: 2^-13, Q2.30. A colour
 * written by mistake as a length, in Q16.16, is always darker. */
#define TIA_DARK (TIA_Q30_ONE >> 13)

/* A violated rule, to be printed as "sphere 3: radius: must be at least 2^-10". */
struct tia_fault {
    const char *thing; /* "sphere", "shape", "light", "material", "camera", "scene", ...; NULL: no fault */
    uint32_t index;    /* the thing's index, from 0; for "camera" and "scene" 0 */
    const char *field;
    const char *rule; /* the rule that the field violates */
};

/* Checks all ranges. Each array must have at least as many elements as its count. Returns TIA_OK, or TIA_ERR_RANGE with
 * *fault filled in (`fault` may be NULL). With TIA_OK, a fault->thing that is not NULL is a warning: the scene can be
 * drawn, but all its lights, or all its materials, are darker than TIA_DARK without being black. Takes one pass over
 * the scene, and one over its shapes for every 16 meshes or grids. */
int tia_scene_check(const struct tia_scene *scene, struct tia_fault *fault);

/* The default scene, scenes/thesis.tia: a ball on a ground sphere, without lights; the keys a, d, s and w add a light
 * above left, above right, near the eye, and far from the eye. */
extern const struct tia_scene tia_thesis_scene;

#ifdef __cplusplus
}
#endif

#endif
