/* sure_tile.h - a tile that is drawn block by block. */
#ifndef TIA_SIMD_RAYS_SURE_TILE_H
#define TIA_SIMD_RAYS_SURE_TILE_H

#include "sure.h"

#define SURE_STRIP                                                                                                     \
    16384 /* number of pixels of a strip: as many whole rows as fit are written to the surface at once                 \
           */

struct sure_drawing {
    const struct sure_kernels *kernels;
    /* Computes the samples of the block; those of open pixels may stay undefined. */
    void (*trace)(struct sure_drawing *d, void *kernels_room);
    /* Computes a pixel of the block that is open. */
    tia_rgb565 (*exact_pixel)(struct sure_drawing *d, int x, int y, num_u threshold);
    bool dither;
    uint32_t layout; /* the layout of block.threshold, see layout_of(); 0: none yet */
    struct sure_block block;
    tia_rgb565 pixels[SURE_STRIP];
};

/* Draws a tile. `trace`, `exact_pixel` and block.seen are set. */
void tia_sure_draw(struct sure_drawing *d, const struct tia_view *view, struct tia_tile tile,
                   const struct tia_surface *surface, const struct tia_options *options, void *kernels_room);

#endif
