/* plain_tiles.c - tiles that plain C draws in place of SIMD kernels: if hashes of paths or the lights that arrive are
 * requested (struct tia_debug), or if a call gets no scratch memory or no floating-point environment. */
#include "simd.h"

#define PIECE 128 /* number of a row's pixels that are traced at once */

static void light_piece(const struct tia_view *view, struct tia_tile piece, const struct tia_surface *surface,
                        const struct tia_options *options)
{
    uint32_t object[PIECE];
    num_u distance[PIECE];
    struct tia_hits hits = {.view = view, .area = piece, .object = object, .buffer = distance};

    view->renderer->trace(view, &hits, piece);
    view->renderer->light(view, &hits, piece, surface, options);
}

void tia_simd_light_plain(const struct tia_view *view, struct tia_tile tile, const struct tia_surface *surface,
                          const struct tia_options *options)
{
    const struct tia_debug debug = options_debug(options);

    for (unsigned y = 0; y < tile.height && !view_stops(view); y++)
        for (unsigned x = 0; x < tile.width; x += PIECE) {
            unsigned width = tile.width - x < PIECE ? tile.width - x : PIECE;
            size_t before = (size_t)y * tile.width + x;
            struct tia_tile piece = {(uint16_t)(tile.x + x), (uint16_t)(tile.y + y), (uint16_t)width, 1};
            char *out = (char *)surface->pixels + (ptrdiff_t)y * surface->pitch + (ptrdiff_t)x * surface->step;
            struct tia_surface part = *surface;
            part.pixels = (tia_rgb565 *)(void *)out;
            struct tia_debug here = {.path_hash = debug.path_hash ? debug.path_hash + before : NULL,
                                     .lit = debug.lit ? debug.lit + before : NULL};
            light_piece(view, piece, &part, &(struct tia_options){.dither = options->dither, .debug = &here});
        }
}
