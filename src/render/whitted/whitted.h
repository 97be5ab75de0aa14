/* whitted.h - the light along a ray, after Whitted, "An improved illumination model for shaded display" (1980); the
 * formulas are in tia/material.h. */
#ifndef TIA_RENDER_WHITTED_WHITTED_H
#define TIA_RENDER_WHITTED_WHITTED_H

#include "ray_tree.h"

/* Computes the colour along `ray`, not clamped; `hit` is the ray's hit, perhaps of a light. */
void path_colour(struct path *path, const struct ray *ray, const struct hit *hit, num_length colour[3]);

/* Implements tia_view_light for a scene prepared by ray_prepare; `first` may be NULL. */
void whitted_light_tile(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
                        const struct tia_surface *surface, const struct tia_options *options,
                        const struct first_hits *first);

#endif
