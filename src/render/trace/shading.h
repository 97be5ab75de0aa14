/* shading.h - a point on a surface, prepared for whatever integrator sums up the light there. */
#ifndef TIA_RENDER_TRACE_SHADING_H
#define TIA_RENDER_TRACE_SHADING_H

#include "media.h"

struct shading {
    const struct tia_material *material;
    uint32_t object;
    struct num_point point;
    struct num_point outside;         /* P + b G: where reflected and shadow rays start */
    struct num_dir geometric, normal; /* G and N, turned to the viewer */
    struct num_dir viewer;            /* V */
    num_unit facing;                  /* N.V */
    bool back;                        /* the ray meets the surface's back: it leaves the object */
    num_length colour[3];             /* the diffuse one, with the texture */
    num_length opacity;
    uint32_t texels[2]; /* which value of the colour's and of the opacity's texture, see ray_texture, */
    bool textured[2];   /* if it belongs into a path's hash */
};

/* What one ray meets; other rays start `bias` off the surface. */
void shading_prepare(const struct ray_view *view, num_length bias, const struct ray *ray, const struct hit *hit,
                     struct shading *s);

/* The direction of the mirrored ray. */
struct num_dir shading_mirrored(const struct shading *s);

/* The direction of the refracted ray. Returns what of it Fresnel's equations say is reflected: 1 where nothing is
 * refracted, and then there is no direction. */
num_unit shading_refract(const struct shading *s, struct boundary between, struct num_dir *refracted);

#endif
