/* gather.h - samples of pixels in double precision, whole: ambient occlusion and light along paths.
 *
 * What sure.h says of pixels holds of samples here. A sample's radiance is rounded to 2^-24 in the end; where that, a
 * hit, a shadow, a lobe or a chance of roulette is not the same all over the bounds, the sample is unsure, and drawn by
 * the integers from its camera ray on. */
#ifndef TIA_SIMD_RAYS_GATHER_H
#define TIA_SIMD_RAYS_GATHER_H

#include "sure.h"

/* What shines, as paths see it. */
struct sure_shine {
    double radiance[3];
    double area; /* times its distribution's constant, see emitters_tmpl.h; of planes */
    bool known;  /* doubles can look for it */
};

/* What of a path's numbers goes where at a material, see scatter_tmpl.h: chances as the integers cut them. */
struct sure_lobes {
    uint32_t below[3];
    double chance[4]; /* of a mirror, of glass, of the glossy lobe and of the diffuse one */
    double glow;      /* what its emission is multiplied by */
    bool known;       /* the same all over it */
    bool black, rough;
};

struct sure_emitter {
    const struct sure_shine *shine;
    uint32_t light, sphere; /* one of them is TIA_NO_OBJECT */
};

struct sure_paths {
    struct sure_shine *lights;     /* of all lights of the view */
    struct sure_emitter *emitters; /* what is looked for */
    struct sure_shine *spheres;    /* of the emitters that are spheres of the scene, in the emitters' order */
    struct sure_lobes *lobes;      /* of all materials */
    uint32_t emitter_count, bounces;
    double one_of, reach; /* of occlusion: up to where objects count */
};

#define SURE_GATHERED 192 /* 40 KB with their rays */

/* Some samples of some pixels. */
struct sure_gather {
    const struct sure_scene *scene;
    struct cancel cancel;
    int count;
    int x[SURE_GATHERED], y[SURE_GATHERED];
    uint32_t index[SURE_GATHERED];
    double colour[SURE_GATHERED][3], error[SURE_GATHERED];
    bool unsure[SURE_GATHERED];
};

/* As tia_sure_size and what follows it. */
size_t tia_gather_size(const struct tia_scene *scene, uint32_t light_capacity);
void tia_gather_prepare(struct tia_view *view);
void tia_gather_set_lights(struct tia_view *view);

#endif
