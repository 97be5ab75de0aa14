/* denoise.h - a picture as the denoiser keeps it. */
#ifndef TIA_SAMPLES_DENOISE_H
#define TIA_SAMPLES_DENOISE_H

#include <tia/denoise.h>

#include "math/tile.h"

/* Data that each pass changes. */
struct light {
    uint32_t rgb[3]; /* over the albedo, Q16.16 */
    uint32_t error;  /* the standard error of its luminance, Q16.16 */
};

/* Data that stays. */
struct feature {
    uint32_t albedo[3]; /* Q16.16, what light was divided by: never 0 */
    uint32_t depth;     /* Q16.16 */
    int16_t normal[4];  /* Q2.14 */
};

struct colour {
    uint32_t rgb[3];
};

/* Passes 0 to EDGE_PASSES - 1 stop at edges of the light. The others average what these have taken from each pixel,
 * which has a sign: with NONE_TAKEN added. */
#define EDGE_PASSES 3
#define NONE_TAKEN (UINT32_C(1) << 31)

struct tia_denoiser {
    unsigned width, height;
    struct light *light[2];  /* a pass reads one and writes the other */
    struct colour *filtered; /* the light that was put in; after pass EDGE_PASSES - 1, what has become of it */
    struct feature *features;
};

/* (red + 2 green + blue)/4, rounded down. */
static inline uint32_t luminance(const uint32_t rgb[3])
{
    return (uint32_t)(((uint64_t)rgb[0] + 2 * (uint64_t)rgb[1] + rgb[2]) >> 2);
}

/* Whether a tile is inside the picture. */
bool tia_denoise_has(const struct tia_denoiser *denoiser, struct tia_tile tile);

#endif
