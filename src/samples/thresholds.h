/* thresholds.h - the least value, in units of 2^-32, of each level of sRGB but the first. */
#ifndef TIA_SAMPLES_THRESHOLDS_H
#define TIA_SAMPLES_THRESHOLDS_H

#include <stdint.h>

extern const uint32_t tia_srgb5[31], tia_srgb6[63], tia_srgb8[255];

/* 8-bit levels of the values i 2^24. */
extern const uint8_t tia_srgb8_from[257];

#endif
