/* gather.h - whole samples of pixels in double precision: ambient occlusion and light along paths.
 *
 * The rules of sure.h for pixels hold for samples here. A sample's radiance is finally rounded to 2^-24; where that, a
 * hit, a shadow, a lobe or a chance of roulette is not the same all over the bounds, the sample is undecided and drawn
 * by the fixed-point path from its camera ray on. */
#ifndef TIA_SIMD_RAYS_GATHER_H
#define TIA_SIMD_RAYS_GATHER_H

#include "sure.h"

/* An emitter's constants for paths. */
struct sure_shine {
    double radiance[3];
    double area; /* area of a plane, times the constant of the distribution, see emitters_tmpl.h */
    bool known;  /* false: its light is undecided */
};

/* A material's lobes, see scatter_tmpl.h: chances cut as in the fixed-point code. */
struct sure_lobes {
    uint32_t below[3];
    double chance[4]; /* of mirror, glass, glossy and diffuse lobe */
    double glow;      /* factor of the material's emission */
    bool known;       /* the lobes are the same all over the surface */
    bool black, rough;
};

struct sure_emitter {
    const struct sure_shine *shine;
    uint32_t light, sphere; /* one of the two is TIA_NO_OBJECT */
};

struct sure_paths {
    struct sure_shine *lights;     /* all lights of the view */
    struct sure_emitter *emitters; /* the emitters that are sampled */
    struct sure_shine *spheres;    /* emitters that are spheres of the scene, in the emitters' order */
    struct sure_lobes *lobes;      /* all materials */
    uint32_t emitter_count, bounces;
    double one_of, reach; /* one_of: 1/number of emitters; reach: the largest distance at which objects count for
                             occlusion */
};

#define SURE_GATHERED 192 /* number of samples, 40 KB with their rays */

/* Samples of a block's pixels. */
struct sure_gather {
    const struct sure_scene *scene;
    struct cancel cancel;
    int count;
    int x[SURE_GATHERED], y[SURE_GATHERED];
    uint32_t index[SURE_GATHERED];
    double colour[SURE_GATHERED][3], error[SURE_GATHERED];
    bool unsure[SURE_GATHERED];
};

/* Returns the bytes for a scene and the data of paths. */
size_t tia_gather_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Sets the scene and the data of paths, without lights. */
void tia_gather_prepare(struct tia_view *view);

/* Sets the lights, whenever they change. */
void tia_gather_set_lights(struct tia_view *view);

#endif
