/* embree_world.h - a scene in Embree, and its data for shading. */
#ifndef BENCH_EMBREE_EMBREE_WORLD_H
#define BENCH_EMBREE_EMBREE_WORLD_H

#include "embree.h"
#include "embree_scene.h"
#include "float_world.h"

#define EMBREE_DEPTH 64 /* largest depth */

enum embree_geometry { EMBREE_SPHERES, EMBREE_FACES, EMBREE_CONES, EMBREE_GEOMETRIES };

struct embree_material {
    float colour[3], specular[3], mirror[3], refraction[3], transmission[3], exponent, index;
    bool shines, reflects, refracts, passes; /* terms of the material that are not black */
};

struct embree_light {
    struct vec place;
    float emission[3];
};

struct embree_face {
    struct vec geometric, normal[3];
    bool smooth;
};

struct embree {
    const struct tia_scene *given;
    struct embree_scene made;
    struct embree_material *materials;
    struct embree_light *lights;
    struct embree_face *faces;
    const float (*spheres)[4];                /* centre and radius, in Embree's own buffer */
    uint32_t *material_of[EMBREE_GEOMETRIES]; /* indices of materials, by the primitive's number */
    float background[3];
    unsigned depth;
};

/* Returns a length in the units of the scene's file, in which the bias is given. tia scales small scenes up for
 * precision; floats have the same relative precision at any scale. */
static inline float embree_length(const struct tia_scene *scene, tia_q16 length)
{
    return ldexpf((float)length, -16 - (int)scene->scale_bits);
}

static inline struct vec embree_place(const struct tia_scene *scene, struct tia_vec3 v)
{
    return (struct vec){embree_length(scene, v.x), embree_length(scene, v.y), embree_length(scene, v.z)};
}

/* The context of rays. */
struct embree_context {
    struct RTCIntersectContext context; /* must be the first member */
    float (*through)[3];                /* of shadow rays, by their numbers: the fraction of the light that passes */
};

#endif
