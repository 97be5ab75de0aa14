/* tone.c - converts sums of samples to levels of a display. */
#include <tia/integrator.h>
#include <tia/tone.h>

#include "math/power.h"
#include "math/wide.h"
#include "thresholds.h"

enum tia_tone tia_tone_of(const struct tia_integration *how)
{
    if (!how)
        return TIA_TONE_LINEAR;
    if (how->tone != TIA_TONE_DEFAULT)
        return how->tone;
    return how->integrator == TIA_PATHS ? TIA_TONE_SRGB : TIA_TONE_LINEAR;
}

/* Derivation: 2^exposure = 2^-(1 - fraction) 2^(floor + 1). */
struct tia_exposure tia_exposure_of(tia_q16 exposure)
{
    exposure = exposure > TIA_EXPOSURE_MAX ? TIA_EXPOSURE_MAX : exposure;
    exposure = exposure < -TIA_EXPOSURE_MAX ? -TIA_EXPOSURE_MAX : exposure;
    int floor = (int)(exposure >> 16);
    int64_t fraction = exposure & 0xffff;

    if (!fraction)
        return (struct tia_exposure){INT64_C(1) << 62, floor};
    return (struct tia_exposure){tia_exp2(INT64_C(1) << 62, (65536 - fraction) << 40), floor + 1};
}

#define MEAN_MOST (INT64_C(1) << 38) /* largest mean, 2^14, in units of 2^-24 */

/* Returns the mean in units of 2^-32, rounded down. So that nothing overflows, the mean of a sum of 2^55 or more is
 * limited to about 2^46 of these units. */
static int64_t mean_of(int64_t sum, uint32_t count)
{
    int64_t whole = sum / count;

    if (!(sum >> 55))
        return sum * 256 / count;
    return (whole < MEAN_MOST ? whole : MEAN_MOST) * 256 + sum % count * 256 / count;
}

/* Exposures by whole stops up to 0 need no product. A result of more than 32 bits is above white. */
uint32_t tia_exposed(const struct tia_exposure *exposure, int64_t sum, uint32_t count)
{
    if (!exposure || !count || sum <= 0)
        return 0;
    int64_t mean = mean_of(sum, count);
    int shift = 62 - exposure->shift;

    if (exposure->mantissa == INT64_C(1) << 62 && exposure->shift <= 0)
        return mean >> -exposure->shift > UINT32_MAX ? UINT32_MAX : (uint32_t)(mean >> -exposure->shift);
    wide product = wide_product(mean, exposure->mantissa);
    if (wide_bits(product) - shift > 32)
        return UINT32_MAX;
    return (uint32_t)wide_down(product, (unsigned)shift);
}

/* Returns the number of thresholds that are at most the value; the array has 2^bits - 1, in rising order. */
static unsigned reached(const uint32_t *thresholds, unsigned bits, uint32_t value)
{
    unsigned level = 0;

    for (unsigned step = 1u << (bits - 1); step; step >>= 1)
        if (value >= thresholds[level + step - 1])
            level += step;
    return level;
}

/* Returns the same as reached() for 8 bits, in one or two steps except near black. */
static unsigned reached8(uint32_t value)
{
    unsigned level = tia_srgb8_from[value >> 24], end = tia_srgb8_from[(value >> 24) + 1];

    while (level < end && value >= tia_srgb8[level])
        level++;
    return level;
}

unsigned tia_tone_level(enum tia_tone tone, uint32_t value, unsigned bits)
{
    if (!bits || bits > 16)
        return 0;
    if (tone != TIA_TONE_SRGB)
        return (unsigned)(((uint64_t)value * ((1u << bits) - 1) + (UINT64_C(1) << 31)) >> 32);
    if (bits != 5 && bits != 6 && bits != 8)
        return 0;
    return bits == 8 ? reached8(value) : reached(bits == 5 ? tia_srgb5 : tia_srgb6, bits, value);
}
