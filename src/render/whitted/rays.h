/* rays.h - a scene drawn by general rays, a pixel at a time: what render.c and view.c call.
 *
 * A program whose scenes need no rays may link no_rays.c in place of src/ray and src/shape. */
#ifndef TIA_RAY_VIEW_H
#define TIA_RAY_VIEW_H

#include "render/hits.h"
#include "render/view.h"

/* Bytes for what rays need of a scene. */
size_t ray_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Prepares view->rays in `memory`. TIA_ERR_UNSUPPORTED when the program is linked without rays. */
int ray_prepare(struct tia_view *view, void *memory);

/* The view's lights have changed. */
void ray_set_lights(struct tia_view *view);

/* What the first sample of each pixel sees; the hits' t stays as it is. */
void ray_trace(const struct tia_view *view, struct tia_hits *hits, struct tia_tile tile);
void ray_light(const struct tia_view *view, const struct tia_hits *hits, struct tia_tile tile,
               const struct tia_surface *surface, const struct tia_options *options);

#endif
