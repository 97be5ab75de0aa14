/* whitted.h - the light along a ray, after Whitted, "An improved illumination model for shaded display" (1980); the
 * formulas are in tia/material.h. */
#ifndef TIA_RENDER_WHITTED_WHITTED_H
#define TIA_RENDER_WHITTED_WHITTED_H

#include "ray_tree.h"
#include "render/trace/media.h"

/* A ray: its throughput, the numbers of bounces and of undeflected passages before it, and its media. */
struct bounce {
    struct ray ray;
    num_length throughput[3];
    uint32_t depth, layers;
    struct media media;
    enum tia_ray kind;
#if TIA_FOOTPRINTS
    struct cone cone; /* set in views that are filtered, except for rays from the eye */
#endif
};

#define PATH_STEPS 8 /* most hits of a route */
#define PATH_REFRACTED UINT32_C(0x80000000)

/* A way through the tree of rays: the objects that the rays meet one after another, each with PATH_REFRACTED if the way
 * goes on by the refracted ray, else by the reflected one. */
struct path_route {
    uint32_t step[PATH_STEPS], count;
};

/* Computes the colour along `ray`, not clamped; `hit` is the ray's hit, perhaps of a light. */
void path_colour(struct path *path, const struct ray *ray, const struct hit *hit, num_length colour[3]);

/* Computes the part of the colour along the ray *b that comes by the ray at the end of a route, without searching for
 * the hits of the route. *b is used up. Returns the number of rays from that one on. */
uint32_t path_resume(struct path *path, struct bounce *b, const struct path_route *route, num_length colour[3]);

/* Implements tia_view_light for a scene prepared by ray_prepare; `first` may be NULL. */
void whitted_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                        const struct tia_surface *surface, const struct tia_options *options,
                        const struct first_hits *first);

#endif
