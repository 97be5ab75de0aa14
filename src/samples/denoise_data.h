/* denoise_data.h - the denoiser's data of a picture. */
#ifndef TIA_SAMPLES_DENOISE_DATA_H
#define TIA_SAMPLES_DENOISE_DATA_H

#include <tia/denoise.h>

#include "math/tile.h"

/* Data of a pixel that each pass changes. */
struct light {
    uint32_t rgb[3]; /* radiance divided by the albedo, Q16.16 */
    uint32_t error;  /* standard error of the luminance of rgb, Q16.16 */
};

/* Data of a pixel that guides the passes. */
struct feature {
    uint32_t albedo[3]; /* Q16.16, the divisor of the light; never 0 */
    uint32_t depth;     /* Q16.16 */
    int16_t normal[4];  /* Q2.14 */
};

struct colour {
    uint32_t rgb[3];
};

/* Number of passes that stop at edges of the light. Later passes average the light that these passes have removed from
 * each pixel. Removed light may be negative, and is stored with NONE_TAKEN added. */
#define EDGE_PASSES 3
#define NONE_TAKEN (UINT32_C(1) << 31)

struct tia_denoiser {
    unsigned width, height;
    struct light *light[2];  /* light before and after a pass, alternately */
    struct colour *filtered; /* the light before the passes; after pass EDGE_PASSES - 1, the filtered light */
    struct feature *features;
};

/* Returns (red + 2 green + blue)/4, rounded down. */
static inline uint32_t luminance(const uint32_t rgb[3])
{
    return (uint32_t)(((uint64_t)rgb[0] + 2 * (uint64_t)rgb[1] + rgb[2]) >> 2);
}

/* True if a tile is inside the picture. */
bool tia_denoise_has(const struct tia_denoiser *denoiser, struct tia_tile tile);

#endif
