/* The conversion of sums of samples to levels: against IEC 61966-2-1 in long double, and exact fractions. */
#include <tia/integrator.h>
#include <tia/tone.h>

#include <math.h>

#include "check.h"
#include "random.h"

/* Returns the transfer function of sRGB. */
static long double encoded(long double linear)
{
    return linear <= 0.0031308L ? 12.92L * linear : 1.055L * powl(linear, 1 / 2.4L) - 0.055L;
}

static unsigned nearest(uint32_t value, unsigned bits)
{
    return (unsigned)floorl(encoded((long double)value / 4294967296.0L) * (long double)((1u << bits) - 1) + 0.5L);
}

/* Returns the least value whose level is `level` or higher. */
static uint32_t first_of(unsigned level, unsigned bits)
{
    uint64_t low = 0, high = UINT32_MAX;

    while (low < high) {
        uint64_t middle = (low + high) / 2;
        if (tia_tone_level(TIA_TONE_SRGB, (uint32_t)middle, bits) >= level)
            high = middle;
        else
            low = middle + 1;
    }
    return (uint32_t)low;
}

/* Each threshold of sRGB and the value just below it have the exact levels, and so do random values. */
TEST(srgb_is_exact)
{
    static const unsigned widths[] = {5, 6, 8};

    for (int w = 0; w < 3; w++) {
        for (unsigned level = 1; level < 1u << widths[w]; level++) {
            uint32_t first = first_of(level, widths[w]);
            CHECK_EQ(tia_tone_level(TIA_TONE_SRGB, first, widths[w]), level);
            CHECK_EQ(nearest(first, widths[w]), level);
            CHECK_EQ(nearest(first - 1, widths[w]), level - 1);
        }
        for (int i = 0; i < 100000; i++) {
            uint32_t value = random_u32() >> (random_u32() & 15);
            CHECK_EQ(tia_tone_level(TIA_TONE_SRGB, value, widths[w]), nearest(value, widths[w]));
        }
        CHECK_EQ(tia_tone_level(TIA_TONE_SRGB, 0, widths[w]), 0);
        CHECK_EQ(tia_tone_level(TIA_TONE_SRGB, UINT32_MAX, widths[w]), (1u << widths[w]) - 1);
    }
}

TEST(linear_is_nearest)
{
    for (unsigned bits = 5; bits <= 16; bits++)
        for (int i = 0; i < 10000; i++) {
            uint32_t value = random_u32();
            long double levels = (long double)((1u << bits) - 1);
            CHECK_EQ(tia_tone_level(TIA_TONE_LINEAR, value, bits),
                     (unsigned)floorl((long double)value / 4294967296.0L * levels + 0.5L));
        }
}

/* Without exposure a mean is floor(2^8 sum/count), computed here by long division. */
TEST(means_are_exact)
{
    const struct tia_exposure none = tia_exposure_of(0);

    for (int i = 0; i < 100000; i++) {
        uint32_t count = (uint32_t)random_short(24) + 1;
        uint64_t mean = random_bits() >> 31; /* a mean in units of 2^-33 */
        int64_t sum = (int64_t)((mean >> 9) * count + random_u32() % count);
        uint64_t want = 0, rest = (uint64_t)sum;
        for (int bit = 0; bit < 9; bit++) { /* long division, a bit at a time */
            want = 2 * want + (rest / count);
            rest = rest % count * 2;
        }
        CHECK_EQ(tia_exposed(&none, sum, count), want < UINT32_MAX ? want : UINT32_MAX);
    }
    CHECK_EQ(tia_exposed(&none, 0, 1), 0);
    CHECK_EQ(tia_exposed(&none, -5, 1), 0);
    CHECK_EQ(tia_exposed(&none, (INT64_C(1) << 62), UINT32_C(1) << 24), UINT32_MAX);
}

TEST(exposures)
{
    for (tia_q16 stops = -TIA_EXPOSURE_MAX; stops <= TIA_EXPOSURE_MAX; stops += 12345) {
        const struct tia_exposure exposure = tia_exposure_of(stops);
        long double want = exp2l((long double)stops / 65536) * 0.25L * 4294967296.0L;
        long double got = (long double)tia_exposed(&exposure, INT64_C(3) << 22, 3);
        want = want < 4294967295.0L ? want : 4294967295.0L;
        CHECK_MSG(fabsl(got - want) <= 1, "%d: %Lf, not %Lf", (int)stops, got, want);
    }
}

/* Whole stops multiply by powers of two: floor(2^(8 + stops) sum/count), computed here by shifts of 64-bit numbers. */
TEST(whole_stops)
{
    for (int stop = -24; stop <= 24; stop++) {
        const struct tia_exposure exposure = tia_exposure_of(stop * 65536);
        for (int i = 0; i < 10000; i++) {
            uint32_t count = (uint32_t)random_short(24) + 1;
            int64_t sum = (int64_t)((random_bits() >> random_u32() % 40) % ((uint64_t)count << 38));
            uint64_t mean = (uint64_t)sum / count << 8 | ((uint64_t)sum % count << 8) / count;
            uint64_t want = stop < 0 ? mean >> -stop : mean >> (32 - stop % 32) ? UINT32_MAX : mean << stop;
            CHECK_EQ(tia_exposed(&exposure, sum, count), sum <= 0 ? 0 : want < UINT32_MAX ? want : UINT32_MAX);
        }
    }
}

int main(void)
{
    RUN(srgb_is_exact);
    RUN(linear_is_nearest);
    RUN(means_are_exact);
    RUN(exposures);
    RUN(whole_stops);
    return check_status();
}
