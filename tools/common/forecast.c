#include "forecast.h"

static unsigned common_divisor(unsigned a, unsigned b)
{
    while (b) {
        unsigned rest = a % b;
        a = b;
        b = rest;
    }
    return a;
}

/* Returns the step of the golden section of `count`, 40503/65536, or the nearest one without a common divisor, which
 * comes to each part. */
static unsigned golden_step(unsigned count)
{
    unsigned step = (unsigned)(((uint64_t)count * 40503 + 32768) >> 16), off = 0;

    while (step > off && common_divisor(step - off, count) != 1 && common_divisor(step + off, count) != 1)
        off++;
    if (step <= off)
        return 1;
    return common_divisor(step + off, count) == 1 ? step + off : step - off;
}

/* By steps of the golden section, each part lies in one of the largest gaps that the earlier ones left. The first is in
 * the middle. */
unsigned forecast_part(unsigned index, unsigned count)
{
    return (unsigned)(((uint64_t)index * golden_step(count) + count / 2) % count);
}

unsigned forecast_probes(unsigned parts)
{
    return (parts + FORECAST_STEP / 2 - 1) / FORECAST_STEP;
}

unsigned forecast_probe(unsigned probe)
{
    return probe * FORECAST_STEP + FORECAST_STEP / 2;
}

uint64_t forecast_weight(uint64_t ns, uint64_t pixels)
{
    return pixels ? (ns << 8) / pixels + 1 : 1;
}
