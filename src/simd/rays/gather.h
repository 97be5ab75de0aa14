/* gather.h - samples of pixels in double precision: ambient occlusion, and light along paths.
 *
 * The rules of sure.h apply to each sample. A sample's radiance is rounded to 2^-24 in the end. If this result, or a
 * hit, a shadow, a lobe or a decision of roulette, is not the same everywhere within the bounds, the sample is
 * undecided. The fixed-point path then computes it; for a path it gets the hits that are certain. */
#ifndef TIA_SIMD_RAYS_GATHER_H
#define TIA_SIMD_RAYS_GATHER_H

#include "render/estimate/estimate.h"
#include "sure.h"

/* The constants of an emitter for paths. */
struct sure_shine {
    double radiance[3];
    double area; /* area of a rectangle or disc, else 1 */
    bool known;  /* false: lanes that receive its light are undecided */
};

/* The lobes of a material, see scatter_tmpl.h, with chances cut to 32 bits as in the fixed-point code, where below[i]
 * is between `below` and `upto`. */
struct sure_lobes {
    uint32_t below[3], upto[3];
    double chance[4]; /* chances of the mirror, glass, glossy and diffuse lobe, each within `spread` */
    double spread;
    double glow; /* factor of the material's emission */
    bool known;  /* the chances are the same everywhere on the surface */
    bool black, rough;
};

struct sure_emitter {
    const struct sure_shine *shine;
    uint32_t light, sphere; /* one of the two is TIA_NO_OBJECT */
};

struct sure_paths {
    struct sure_shine *lights;     /* one for each light of the view */
    struct sure_emitter *emitters; /* emitters that are sampled */
    struct sure_shine *spheres; /* one for each emitter that is a sphere of the scene, in the order of the emitters */
    struct sure_lobes *lobes;   /* one for each material */
    uint32_t emitter_count, bounces;
    double one_of, reach; /* one_of: 1/emitter_count; reach: largest distance of occluding objects */
};

#define SURE_GATHERED 192 /* largest number of samples; they and their rays take 70 KB */

/* The samples of a block's pixels. */
struct sure_gather {
    const struct sure_scene *scene;
    struct cancel cancel;
    int count;
    int x[SURE_GATHERED], y[SURE_GATHERED];
    uint32_t index[SURE_GATHERED];
    double colour[SURE_GATHERED][3], error[SURE_GATHERED];
    bool unsure[SURE_GATHERED];
    struct estimate_known known[SURE_GATHERED]; /* what is certain of paths, even of undecided ones */
};

/* Returns the size in bytes of the scene in doubles and the data of paths. */
size_t tia_gather_size(const struct tia_scene *scene, uint32_t light_capacity);

/* Sets the scene and the data of paths, except lights. */
void tia_gather_prepare(struct tia_view *view);

/* Sets the lights; called whenever they change. */
void tia_gather_set_lights(struct tia_view *view);

#endif
