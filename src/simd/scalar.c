/* scalar.c - no vector instructions: plain C draws spans; rays are traced in double precision, one at a time. */
#include "isa/one.h"
#include "simd.h"

#include "raster_tmpl.h"

extern const struct tia_simd tia_simd_scalar;
extern const struct sure_kernels tia_sure_scalar;
const struct tia_simd tia_simd_scalar = {
    "scalar", &tia_simd_entries, &span_kernels_plain, {NULL, &tia_simd_rays, &tia_simd_samples, &tia_simd_seen},
    NULL,     &tia_sure_scalar,  &raster_runs};
