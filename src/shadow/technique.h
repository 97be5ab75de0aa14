/* technique.h - a technique for shadows: it tells which pixels light reaches, of what the rasteriser has drawn. */
#ifndef TIA_SHADOW_TECHNIQUE_H
#define TIA_SHADOW_TECHNIQUE_H

#include "scene/asker.h"
#include "volume.h"

/* A scene's faces as they are seen, and the samples of its lights. */
struct tia_shadow_view {
    const struct tia_scene *scene;
    struct tia_flat_scene flat;
    unsigned sample_count;
    tia_flat_light samples[TIA_SHADOW_SAMPLES];
    void *own; /* the technique's, aligned for uint64_t */
};

/* What is kept of each pixel of a tile. */
struct tia_shadow_tile {
    struct tia_raster_target target;
    uint64_t *lit; /* a bit for each sample; target.pitch pixels from one row to the next */
};

struct tia_shadow_technique {
    /* Bytes behind view->own; then fills them in when the scene's faces are there, and whenever its samples have
     * changed. TIA_STOPPED when the asker has stopped it. */
    uint64_t (*own_size)(const struct tia_scene *scene);
    int (*prepare)(struct tia_shadow_view *view, struct asker *asker);
    int (*set_lights)(struct tia_shadow_view *view, struct asker *asker);

    /* Sets the bit of a sample where its light arrives; faces and depths are drawn, the bit is nowhere set. Once the
     * asker has stopped it, bits mean nothing. */
    void (*light)(const struct tia_shadow_view *view, struct tia_shadow_tile *tile, unsigned sample,
                  struct asker *asker);
};

/* NULL for TIA_SHADOWS_TRACED. */
const struct tia_shadow_technique *tia_shadow_technique(enum tia_shadows technique);

/* TIA_SHADOWS_RAYS. */
extern const struct tia_shadow_technique tia_shadow_rays;

/* TIA_SHADOWS_ZPASS and TIA_SHADOWS_ZFAIL. */
extern const struct tia_shadow_technique tia_shadow_volumes;

#endif
