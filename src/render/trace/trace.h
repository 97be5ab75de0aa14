/* trace.h - a scene prepared for general rays: the data at view->prepared. */
#ifndef TIA_RENDER_TRACE_TRACE_H
#define TIA_RENDER_TRACE_TRACE_H

#include "ray_camera.h"
#include "ray_light.h"
#include "render/geometry/instance.h"
#include "render/renderer.h"
#include "rgb.h"

#ifndef TIA_FOOTPRINTS
#define TIA_FOOTPRINTS 1 /* 0: textures are looked up at points even if they have `footprint` */
#endif

struct ray_view {
    const struct tia_view *view; /* the view that these data belong to */
    const struct tia_scene *scene;
    struct ray_camera camera;
    struct shape *shapes;       /* the scene's shapes, prepared; behind them the members of its solids */
    struct instance *instances; /* one for each shape and each member of a solid that has a transform */
    struct ray_light *lights;
    uint32_t light_count, depth;
    num_length bias; /* offset of rays from surfaces */
    bool layered;    /* some material has an opacity texture */
    bool filtered;   /* some texture is filtered over footprints */
    bool lit;        /* some light has a visible surface */
};

/* Implements `prepared_size` of struct renderer, for a struct ray_view. */
size_t ray_prepared_size(const struct tia_scene *scene, uint32_t light_capacity);
/* Implements `prepare` of struct renderer: prepares a struct ray_view. */
int ray_prepare(struct tia_view *view);
/* Implements `set_lights` of struct renderer. */
int ray_set_lights(struct tia_view *view);

/* Implements `trace` of struct renderer: finds the hit of each pixel's first sample. */
void ray_trace_tile(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);

/* A ray's first hit. */
struct hit {
    num_length t;
    uint32_t object;  /* index of the object; TIA_NO_OBJECT: a light or nothing */
    uint32_t element; /* part of a shape, see shape.h */
    uint32_t light;   /* index of the light met instead of an object, or TIA_NO_OBJECT */
};

/* Finds the nearest object; of several at the same distance, the one with the lowest index. */
void ray_intersect(const struct ray_view *view, const struct ray *ray, struct hit *hit);

/* Computes the hit on `object`, which is known to be the nearest. TIA_NO_OBJECT means no hit. */
void ray_intersect_object(const struct ray_view *view, const struct ray *ray, uint32_t object, struct hit *hit);

/* Replaces the hit by the nearest light with a surface, if the light is nearer than the hit. */
void ray_intersect_lights(const struct ray_view *view, const struct ray *ray, struct hit *hit);

/* Replaces the hit as ray_intersect_lights does, but only by lights whose kind is a bit of `kinds`. */
void ray_intersect_lights_of(const struct ray_view *view, const struct ray *ray, unsigned kinds, struct hit *hit);

/* Returns the centre of one of the scene's spheres. */
struct num_point ray_sphere_centre(const struct tia_scene *scene, uint32_t sphere);
/* Returns the radius of one of the scene's spheres. */
num_length ray_sphere_radius(const struct tia_scene *scene, uint32_t sphere);

/* Computes the part of the light that the objects between the ray's origin and t = limit transmit. Returns false if
 * they transmit nothing. *blocker is the object to test first, or TIA_NO_OBJECT. An object that transmits nothing is
 * stored in *blocker, since it often blocks the next shadow ray to the same light, too. */
bool ray_transmittance(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker,
                       num_length through[3]);

/* Computes the transmitted part as ray_transmittance does, but light passes objects only where an opacity texture lets
 * it. */
bool ray_visibility(const struct ray_view *view, const struct ray *ray, num_length limit, uint32_t *blocker,
                    num_length *through);

/* Converts a direction relative to the z axis to the corresponding direction relative to `axis`. */
struct num_dir ray_around(struct num_dir axis, struct num_dir local);

/* The start of rays on a surface, with the geometric and the shading normal. */
struct ray_place {
    struct num_point outside;
    struct num_dir geometric, normal;
};

/* Returns the result of one ray of ambient occlusion, see tia/integrator.h: the part of its light that objects within
 * `distance` let pass, 0 or 1 without opacity textures. `u` are two random numbers; `blocker` is as in
 * ray_transmittance. */
num_length ray_openness(const struct ray_view *view, const struct ray_place *place, const uint32_t u[2],
                        num_length distance, uint32_t *blocker);

/* True if the ray meets object `object` at 0 <= t <= limit. Unless `element` is NULL, sets *element to the nearest
 * element. */
bool ray_occluded_by(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit,
                     uint32_t *element);

/* For a mesh with groups of faces, returns the number of groups that the ray meets at 0 <= t <= limit; for any other
 * object, 1. */
uint32_t ray_groups_met(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit);

/* True if the object or, for a grid, any of its cells may have an opacity texture. */
bool ray_is_layered(const struct ray_view *view, uint32_t object);

/* Computes the hit on the object. Returns false if there is none at 0 <= t <= limit. */
bool ray_meets(const struct ray_view *view, const struct ray *ray, uint32_t object, num_length limit, struct hit *hit);

/* Returns the part of an object that a refracted ray may enter. */
enum inside ray_inside(const struct ray_view *view, uint32_t object);

/* Computes the surface at the hit, in the world's axes. */
void ray_surface(const struct ray_view *view, const struct hit *hit, struct num_point point, struct surface *surface);
/* Converts a world point on the hit's object to the object's axes, relative to the centre if it is a sphere. */
struct num_point ray_own_point(const struct ray_view *view, const struct hit *hit, struct num_point point);
/* Computes the hit's surface coordinates, times 2^-bits; returns bits. */
int ray_uv(const struct ray_view *view, const struct hit *hit, struct num_point point, num_length uv[2]);
/* Returns the kind of the shape that is hit, or of the member of a solid, and its own element. */
const struct shape_kind *ray_kind(const struct ray_view *view, const struct hit *hit, uint32_t *element);
/* Returns the material of an object's element. */
uint32_t ray_material(const struct ray_view *view, uint32_t object, uint32_t element);

#endif
