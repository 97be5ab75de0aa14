#include "simd.h"

const struct tia_raster_runs *tia_simd_raster(const struct tia_simd *simd)
{
    return simd ? simd->raster : NULL;
}
