/* technique.h - the interface of a technique for shadows: which of the pixels that the rasteriser has drawn does light
 * reach? */
#ifndef TIA_SHADOW_TECHNIQUE_H
#define TIA_SHADOW_TECHNIQUE_H

#include "scene/cancel.h"
#include "volume.h"

/* A scene's faces as they are seen, and the samples of its lights. */
struct tia_shadow_view {
    const struct tia_scene *scene;
    struct tia_flat_scene flat;
    unsigned sample_count;
    tia_flat_light samples[TIA_SHADOW_SAMPLES];
    const struct tia_light *lights[TIA_SHADOW_SAMPLES]; /* whose samples these are, while lights are set */
    void *own;                                          /* the technique's, aligned for uint64_t */
};

/* The data kept for each pixel of a tile. */
struct tia_shadow_tile {
    struct tia_raster_target target;
    uint64_t *lit; /* a bit for each sample; target.pitch pixels from one row to the next */
    void *more;    /* the technique's own bytes of each pixel, as they are, or its shares */
};

/* A share is the part of a sample's light that arrives, TIA_SHARE_ALL being all of it. */
typedef uint16_t tia_share;
#define TIA_SHARE_BITS 15
#define TIA_SHARE_ALL (1u << TIA_SHARE_BITS)

struct tia_shadow_technique {
    /* Bytes behind view->own; then fills them in when the scene's faces are there, and whenever its samples have
     * changed. TIA_STOPPED when the cancel has stopped it. */
    uint64_t (*own_size)(const struct tia_scene *scene);
    int (*prepare)(struct tia_shadow_view *view, struct cancel *cancel);
    int (*set_lights)(struct tia_shadow_view *view, struct cancel *cancel);

    /* Sets the bit of a sample where its light arrives; faces and depths are drawn, the bit is nowhere set. With
     * shares, the pixel's share of the sample there as well. Once the cancel has stopped it, bits mean nothing. */
    void (*light)(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct cancel *cancel);

    /* Few techniques have these. The number of shares of a pixel, at least one per sample: 0 where bits are enough; and
     * whether an area light has only one sample then, in its centre, whose share counts for all of its own. */
    unsigned (*shares)(const struct tia_scene *scene);
    bool (*is_whole)(const struct tia_scene *scene);

    /* NULL, or whether own_size bytes are enough for these lights in place of the scene's. */
    bool (*has_room)(const struct tia_scene *scene, const struct tia_light *lights, uint32_t count);
    unsigned scratch; /* bytes of each pixel, a multiple of 4, if there are no shares */
};

/* NULL for TIA_SHADOWS_TRACED. */
const struct tia_shadow_technique *tia_shadow_technique(enum tia_shadows technique);

/* The number of a light's samples that a technique uses. */
unsigned tia_shadow_samples(const struct tia_scene *scene, const struct tia_light *light);

/* TIA_SHADOWS_RAYS. */
extern const struct tia_shadow_technique tia_shadow_rays;
/* TIA_SHADOWS_ZPASS, TIA_SHADOWS_ZFAIL and TIA_SHADOWS_ZPASS_PLAIN. */
extern const struct tia_shadow_technique tia_shadow_volumes;
/* TIA_SHADOWS_MAP. */
extern const struct tia_shadow_technique tia_shadow_maps;
/* TIA_SHADOWS_MAP_EXACT. */
extern const struct tia_shadow_technique tia_shadow_exact_maps;

#endif
