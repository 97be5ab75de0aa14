/* ray_light.h - a light's effect on a point, sample by sample, and its visible surface; see tia/light.h. */
#ifndef TIA_RENDER_TRACE_RAY_LIGHT_H
#define TIA_RENDER_TRACE_RAY_LIGHT_H

#include "render/geometry/shape.h"

struct ray_light {
    enum tia_light_kind kind;
    unsigned samples; /* 1 for lights without area */
    num_unit part;    /* 1/(32 samples) */
    num_length emission[3];
    struct num_point centre;
    struct num_dir direction; /* of length 1 */
    num_length radius;        /* 0: invisible */
    num_unit inner, outer;    /* cosines of a spot light's angles */
    struct num_dir axes[2];   /* axes of a disc */
    struct num_point side[2]; /* half sides of a rectangle */
    struct num_dir across[2]; /* vectors in the plane of `side`, each perpendicular to the other side */
    num_length constant, linear, quadratic;
    num_unit unit; /* the scene's unit of length, in units of the attenuation */
    bool fades;    /* the light has an attenuation; false for lights without a position */
};

/* True if the samples lie on a disc that is turned to each lit point. */
static inline bool ray_light_turns(const struct ray_light *light)
{
    return tia_light_has(light->kind, TIA_LIGHT_AREA) && tia_light_has(light->kind, TIA_LIGHT_BALL);
}

/* The effect of one sample of a light on a point. */
struct ray_sample {
    struct num_point source; /* not set for a directional light */
    struct num_dir to;       /* L */
    num_length factor;       /* attenuation times the spot's falloff; 0: no light */
};

void ray_light_prepare(struct ray_light *light, const struct tia_light *given, int scale_bits);

/* A light aimed at a point, in a pixel of class `class`, 0..15. */
struct ray_aim {
    const struct ray_light *light;
    struct num_point point;
    struct num_dir normal;  /* normal at the point; light from behind does not count */
    struct num_dir axes[2]; /* axes of the disc on which the samples lie */
    unsigned class;
};

void ray_light_aim(struct ray_aim *aim, const struct ray_light *light, struct num_point point, struct num_dir normal,
                   unsigned class);

/* Computes sample i, below light->samples, of a light that is not ambient. Returns false if the sample gives no light.
 * May also return false if the light comes from behind the surface. */
bool ray_light_sample(const struct ray_aim *aim, unsigned i, struct ray_sample *sample);

/* Computes the shadow ray from a point to the sample, and its length: NUM_LENGTH_MAX for a directional light. Returns
 * false if the point and the sample coincide. */
bool ray_light_shadow(const struct ray_light *light, const struct ray_sample *sample, struct num_point from,
                      struct ray *shadow, num_length *distance);

/* Returns the point of a rectangle that is s and t times its half sides from the centre. */
struct num_point ray_light_rectangle_point(const struct ray_light *light, num_unit s, num_unit t);

/* True if the light has a surface that rays can meet. */
bool ray_light_is_seen(const struct ray_light *light);

/* Intersects a ray with the light's surface. Returns false if they do not meet at 0 <= t < limit. */
bool ray_light_intersect(const struct ray_light *light, const struct ray *ray, num_length limit, num_length *t);

/* Returns the class of pixel (x, y), 0..15, which shifts the pattern of samples. */
unsigned ray_pixel_class(int x, int y);

#endif
