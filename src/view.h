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

/* Whether `tile` is not empty and lies in the image and in `area`, a hit buffer's. */
bool view_has_tile(const struct tia_view *view, struct tia_tile area, struct tia_tile tile);

/* Keeps those of `count` distances to body `n` that are nearer than the best so far; a tie stays. */
void view_keep_nearer(const struct tia_view *view, uint32_t n, const num_u *t, int count, num_u *best,
                      uint32_t *object);

#endif
