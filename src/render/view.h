/* view.h - a scene prepared for one image size: all that tracing and lighting share. */
#ifndef TIA_VIEW_H
#define TIA_VIEW_H

#include "render/span/sphere.h"

struct ray_view; /* of general rays, see ray/ */

/* What spans need. Everything is relative to the eye: a point seen by a pixel is P = t v. */
struct span_view {
    struct span_sphere *spheres; /* the spheres, then the lights */
    struct primary_rays primary;
    bool tinted;       /* some material lets shadow rays through */
    bool grey_shadows; /* what they keep on their way is grey */
    bool grey;         /* and all lights are */
};

struct tia_view {
    const struct tia_scene *scene;
    struct tia_light *lights; /* our copy */
    uint32_t light_count, light_capacity;
    int width, height;
    struct ray_view *rays; /* NULL: drawn by spans */
    struct span_view span;
};

#endif
