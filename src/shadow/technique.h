/* technique.h - the interface of techniques for shadows: a technique decides which rasterised pixels a light
 * reaches. */
#ifndef TIA_SHADOW_TECHNIQUE_H
#define TIA_SHADOW_TECHNIQUE_H

#include "scene/cancel.h"
#include "volume.h"

/* A scene's projected faces, and the samples of its lights. */
struct tia_shadow_view {
    const struct tia_scene *scene;
    struct tia_flat_scene flat;
    unsigned sample_count;
    tia_flat_light samples[TIA_SHADOW_SAMPLES_MAX];
    const struct tia_light *lights[TIA_SHADOW_SAMPLES_MAX]; /* light of each sample; valid only during set_lights */
    const struct tia_raster_runs *runs;                     /* for set_lights; NULL: plain C */
    void *own;                                              /* the technique's data, aligned for uint64_t */
    uint64_t own_size;                                      /* bytes of `own` */
};

/* The data of each pixel of a tile. */
struct tia_shadow_tile {
    struct tia_raster_target target;
    uint64_t *lit; /* for each pixel, a bit for each light sample; rows are target.pitch pixels apart */
    void *more;    /* each pixel's scratch memory or shares */
};

/* A share: the part of a sample's light that arrives, in units of 1/TIA_SHARE_ALL. */
typedef uint16_t tia_share;
#define TIA_SHARE_BITS 15
#define TIA_SHARE_ALL (1u << TIA_SHARE_BITS)

struct tia_shadow_technique {
    /* returns the number of bytes of view->own */
    uint64_t (*own_size)(const struct tia_scene *scene);
    /* fills view->own after view->flat is complete; TIA_STOPPED when cancelled */
    int (*prepare)(struct tia_shadow_view *view, struct cancel *cancel);
    /* updates view->own whenever the view's samples have changed; TIA_STOPPED when cancelled */
    int (*set_lights)(struct tia_shadow_view *view, struct cancel *cancel);

    /* Sets the bit of a sample in each pixel where its light arrives. Before the call, faces and depths must be drawn,
     * and the bit must be clear in all pixels. With shares, stores each pixel's share of the sample as well. Once
     * cancelled, the bits are undefined. */
    void (*light)(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel);

    /* Returns the number of shares of a pixel, at least one for each sample; 0 where bits suffice. NULL: the technique
     * has no shares. */
    unsigned (*shares)(const struct tia_scene *scene);
    /* True if an area light has only one sample, at its centre, which represents the whole light. NULL: never. */
    bool (*is_whole)(const struct tia_scene *scene);

    /* True if own_size bytes also suffice for these lights in place of the scene's. NULL: always. */
    bool (*has_room)(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count);
    unsigned scratch; /* bytes of scratch memory for each pixel, a multiple of 4; only without shares */
};

/* Returns a technique's functions; NULL for TIA_SHADOWS_TRACED. */
const struct tia_shadow_technique *tia_shadow_technique(enum tia_shadows technique);

/* Returns the number of a light's samples that a technique uses. */
unsigned tia_shadow_samples(const struct tia_scene *scene, const struct tia_light *light);

/* The technique TIA_SHADOWS_RAYS. */
extern const struct tia_shadow_technique tia_shadow_rays;
/* The techniques TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL and TIA_SHADOWS_ZPASS_PLAIN. */
extern const struct tia_shadow_technique tia_shadow_volumes;
/* The technique TIA_SHADOWS_MAP. */
extern const struct tia_shadow_technique tia_shadow_maps;
/* The technique TIA_SHADOWS_MAP_EXACT. */
extern const struct tia_shadow_technique tia_shadow_exact_maps;

#endif
