/* picture.h - a picture whose pixels docs/definition.md defines. */
#ifndef TIA_EXACT_PICTURE_H
#define TIA_EXACT_PICTURE_H

#include <tia/render.h>

#include "ball.h"

/* K = height cot(fov/2) in 64 bits, the first precision: a ball of two words. */
struct exact_depth {
    uint32_t m[2];
    int e;
    struct ball_radius radius;
};

/* A picture of a scene. `lights` takes the place of the scene's own lights; sizes are in pixels. */
struct exact_picture {
    const struct tia_scene *scene;
    const struct tia_light *lights;
    uint32_t light_count;
    int width, height;
    struct exact_depth depth;
    /* Returns the first sphere from number `from` on that may block the light at the pixel whose sphere is shaded; the
     * number of spheres if there is none. NULL: all are tried. */
    uint32_t (*next_caster)(const void *lit, uint32_t light, uint32_t from);
    const void *lit; /* its first argument */
};

/* Sets K for a picture's height in pixels and a vertical field of view in degrees. */
void tia_exact_depth(struct exact_depth *depth, uint32_t height, tia_q16 fov);

#endif
