/* thresholds.h - the least value, in units of 2^-32, of each level of sRGB except level 0. */
#ifndef TIA_SAMPLES_THRESHOLDS_H
#define TIA_SAMPLES_THRESHOLDS_H

#include <stdint.h>

extern const uint32_t tia_srgb5[31], tia_srgb6[63], tia_srgb8[255];

/* 8-bit level of each value i 2^24; the last one is 255. */
extern const uint8_t tia_srgb8_from[257];

#endif
