/* tone.h - conversion of sums of samples to pixel values, for programs that write sampled pictures in formats of their
 * own. For RGB565, see struct tia_estimator.
 */
#ifndef TIA_TONE_H
#define TIA_TONE_H

#include <tia/integrator.h>

#ifdef __cplusplus
extern "C" {
#endif

/* 2^exposure, prepared for tia_exposed. */
struct tia_exposure {
    int64_t mantissa;
    int shift;
};

/* Returns the integration's tone; for TIA_TONE_DEFAULT, the tone that it stands for. */
enum tia_tone tia_tone_of(const struct tia_integration *integration);

/* Returns 2^exposure; the exposure is clamped to -TIA_EXPOSURE_MAX..TIA_EXPOSURE_MAX. */
struct tia_exposure tia_exposure_of(tia_q16 exposure);

/* Returns the value that a pixel shows, from the sum of `count` samples of one channel: 2^exposure times their mean, in
 * units of 2^-32, at most 2^32 - 1. Rounded down; exact for an exposure of 0. The mean is clamped to 0..2^14; a count
 * of 0 gives 0. */
uint32_t tia_exposed(const struct tia_exposure *exposure, int64_t sum, uint32_t count);

/* Returns the level, of 2^bits levels, that is nearest to `value`, which is in units of 2^-32; ties up, exact. `bits`
 * is 1..16, for TIA_TONE_SRGB 5, 6 or 8; the result for other numbers of bits is 0. Other tones are as
 * TIA_TONE_LINEAR. */
unsigned tia_tone_level(enum tia_tone tone, uint32_t value, unsigned bits);

#ifdef __cplusplus
}
#endif

#endif
