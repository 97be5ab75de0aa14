/* view.h - a scene prepared for one image size: all that tracing and lighting share.
 *
 * Everything is relative to the eye. A point seen by a pixel is P = t v.
 */
#ifndef TIA_VIEW_H
#define TIA_VIEW_H

#include "shape/sphere.h"

struct tia_view {
    const struct tia_scene *scene;
    struct tia_light *lights; /* our copy */
    struct body *bodies;      /* the spheres, then the lights */
    uint32_t light_count, light_capacity;
    struct lattice lattice;
    bool tinted;       /* some material lets shadow rays through */
    bool grey_shadows; /* what they keep on their way is grey */
    bool grey;         /* and all lights are */
};

/* Whether `tile` is not empty and lies in an area that starts at (x, y). */
bool view_tile_inside(struct tia_tile tile, unsigned x, unsigned y, unsigned width, unsigned height);

#endif
