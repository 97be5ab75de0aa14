/* tile.h - checks of a caller's tile and surface; a surface's byte order. */
#ifndef TIA_MATH_TILE_H
#define TIA_MATH_TILE_H

#include <tia/render.h>

#include "noinline.h"

/* True if a tile has pixels, and all of them are in an area. The sums have 32 bits, since the area may end beyond
 * 65535, the largest unsigned int on 16-bit machines. */
static inline bool tile_is_inside(struct tia_tile tile, struct tia_tile area)
{
    return tile.width && tile.height && tile.x >= area.x && tile.y >= area.y &&
           (uint32_t)tile.x + tile.width <= (uint32_t)area.x + area.width &&
           (uint32_t)tile.y + tile.height <= (uint32_t)area.y + area.height;
}

/* A struct in which `pixel` has the alignment of a pixel as its offset: 1 on an AVR, 2 elsewhere. */
struct surface_probe {
    char before;
    tia_rgb565 pixel;
};

static inline bool surface_is_usable(const struct tia_surface *surface)
{
    const uintptr_t odd = offsetof(struct surface_probe, pixel) - 1;

    return surface && surface->pixels &&
           !(((uintptr_t)surface->pixels | (uintptr_t)surface->step | (uintptr_t)surface->pitch) & odd);
}

/* True if the surface's pixels have the other byte order. */
static INLINED bool surface_swaps(const struct tia_surface *surface)
{
#if TIA_SWAP
    return surface->swap;
#else
    (void)surface;
    return false;
#endif
}

static INLINED void surface_set_swap(struct tia_surface *surface, bool swap)
{
#if TIA_SWAP
    surface->swap = swap;
#else
    (void)surface, (void)swap;
#endif
}

static INLINED tia_rgb565 pixel_order(tia_rgb565 pixel, bool swap)
{
    if (swap)
        pixel = (tia_rgb565)(pixel << 8 | pixel >> 8);
    return pixel;
}

/* Returns a pixel in the surface's byte order. */
static INLINED tia_rgb565 surface_order(const struct tia_surface *surface, tia_rgb565 pixel)
{
    return pixel_order(pixel, surface_swaps(surface));
}

#endif
