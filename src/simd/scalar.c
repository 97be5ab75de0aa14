/* scalar.c - no vector instructions: plain C draws spans; rays are traced in double precision, one at a time. */
#include "simd.h"

extern const struct tia_simd tia_simd_scalar;
extern const struct sure_kernels tia_sure_scalar;
const struct tia_simd tia_simd_scalar = {
    "scalar", &tia_simd_entries, &span_kernels_plain, {NULL, &tia_simd_rays, &tia_simd_samples}, NULL, &tia_sure_scalar,
    NULL};
