/* simd_exact.h - compares pictures that SIMD kernels draw with exact pixels, of which some are computed. */
#ifndef TESTS_SIMD_EXACT_H
#define TESTS_SIMD_EXACT_H

#include "exact/pixel.h"
#include "render/core/dither.h"
#include "simd_frames.h"

/* Draws with the kernels, tracing again if `trace`, into f->got. Returns the number of changed bytes in guards. */
static inline size_t simd_exact_draw(struct simd_frames *f, bool trace, bool dither)
{
    const struct tia_options options = {.dither = dither};
    const struct tia_surface got = simd_frames_surface(f->got, f->pitch);
    size_t changed = 0;

    memset(f->got, GUARDED, f->bytes);
    if ((trace && tia_view_trace(f->simd, f->hits[1], f->area)) ||
        tia_view_light(f->simd, f->hits[1], f->area, &got, &options))
        return SIZE_MAX;
    for (size_t i = 0; i < f->bytes; i++)
        if (i < GUARD || (i - GUARD) % (size_t)f->pitch >= f->area.width * sizeof(tia_rgb565))
            changed += f->got[i] != GUARDED;
    return changed;
}

static inline tia_rgb565 simd_exact_got(const struct simd_frames *f, unsigned x, unsigned y)
{
    tia_rgb565 pixel;

    memcpy(&pixel, f->got + GUARD + (size_t)f->pitch * y + x * sizeof pixel, sizeof pixel);
    return pixel;
}

/* Returns the number of pixels of f->got that differ from the exact ones, of every `step`th from `first` on. *where is
 * the place of the last. */
static inline unsigned simd_exact_differ(const struct simd_frames *f, bool dither, unsigned first, unsigned step,
                                         unsigned where[2])
{
    struct exact_picture picture = {.scene = f->scene,
                                    .lights = f->simd->lights,
                                    .light_count = f->simd->light_count,
                                    .width = (int)f->area.width,
                                    .height = (int)f->area.height};
    unsigned differ = 0, width = f->area.width;

    tia_exact_depth(&picture.depth, f->area.height, f->scene->camera.fov);
    for (unsigned i = first % step; i < width * f->area.height; i += step) {
        unsigned x = i % width, y = i / width;
        num_u threshold[8];
        dither_thresholds(dither, (int)y, threshold);
        tia_rgb565 exact = tia_exact_pixel(&picture, (int)x, (int)y, (tia_q30)threshold[x & 7], NULL);
        if (exact == simd_exact_got(f, x, y))
            continue;
        differ++;
        where[0] = x;
        where[1] = y;
    }
    return differ;
}

#endif
