/* footprint.h - textures filtered over the area that a camera ray stands for, see struct tia_texture.
 *
 * A sample of a pixel stands for a parallelogram of the image, as wide and high as the distance of samples. Its
 * projection on the tangent plane at the hit is the footprint. It is found by ray differentials (Igehy, "Tracing ray
 * differentials", 1999): one vector for the change to the right, one downwards. Ray cones (Akenine-Moeller et al. 2019)
 * need only a width, but their footprint is a circle across the ray. A plane that runs to the horizon needs the longest
 * and the shortest extent at once: a circle as wide as the longest blurs rows of cells that are still resolved across,
 * and one as wide as the shortest leaves the noise that filtering is to remove. */
#ifndef TIA_RENDER_WHITTED_FOOTPRINT_H
#define TIA_RENDER_WHITTED_FOOTPRINT_H

#include "render/trace/shading.h"

/* Replaces the colour of a hit of the camera ray `ray`, sample number `sample` of the pixel, by one filtered over the
 * ray's footprint, if its texture is filtered. */
void footprint_filter(const struct ray_view *view, const struct light_pixel *pixel, int sample, const struct ray *ray,
                      const struct hit *hit, struct shading *s);

#endif
