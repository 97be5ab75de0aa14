/* neon.c - 4 floats: NEON of AArch64. */
#include "isa/neon.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(neon, &raster_runs);
