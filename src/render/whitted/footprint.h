/* footprint.h - textures filtered over the area that a ray stands for, see struct tia_texture.
 *
 * A sample of a pixel stands for a parallelogram of the image, as wide and high as the distance of samples. Its
 * projection on the tangent plane at the hit is the footprint. For rays from the eye it is found by ray differentials
 * (Igehy, "Tracing ray differentials", 1999): the two neighbouring samples' rays are made once more, which takes no
 * memory. A plane that runs to the horizon needs the longest and the shortest extent at once: a circle as wide as the
 * longest blurs rows of cells that are still resolved across, and one as wide as the shortest leaves the noise that
 * filtering is to remove.
 *
 * Reflected and refracted rays are cones (Akenine-Moeller et al., "Improved shader and texture level of detail using
 * ray cones", 2021), a width and its change, which need 16 bytes for each pending ray; differentials would need 96, and
 * the stack of a small processor has to hold 33 of them. A cone's footprint is its section by the tangent plane, so a
 * floor seen in a mirror keeps its two extents. Curved surfaces change the cone by the mean of their curvatures. */
#ifndef TIA_RENDER_WHITTED_FOOTPRINT_H
#define TIA_RENDER_WHITTED_FOOTPRINT_H

#include "ray_tree.h"
#include "render/trace/shading.h"

#define FOOTPRINT_REACH (NUM_LENGTH_FAR / 2) /* 2^15 */

/* Returns p with coordinates within +-2^15. */
static inline struct num_point footprint_cut(struct num_point p)
{
    return (struct num_point){num_length_clamp(p.x, -FOOTPRINT_REACH, FOOTPRINT_REACH),
                              num_length_clamp(p.y, -FOOTPRINT_REACH, FOOTPRINT_REACH),
                              num_length_clamp(p.z, -FOOTPRINT_REACH, FOOTPRINT_REACH)};
}

/* Returns the cone at the distance t. Behind its narrowest place, it spreads again. */
static inline struct cone footprint_cone_at(const struct cone *cone, num_length t)
{
    num_length width = cone->width + num_product(cone->spread, num_length_clamp(t, 0, NUM_LENGTH_FAR));
    bool crossed = width < 0;

    return (struct cone){num_length_clamp(crossed ? -width : width, 0, FOOTPRINT_REACH),
                         crossed ? -cone->spread : cone->spread};
}

/* Replaces the colour and the opacity of a hit of `ray` by their means over the ray's footprint, if their textures are
 * filtered. */
void footprint_filter(const struct path *path, const struct ray *ray, const struct hit *hit, struct shading *s);

#endif
