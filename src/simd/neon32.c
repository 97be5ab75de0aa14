/* neon32.c - 4 floats: NEON of ARMv7. */
#include "isa/neon32.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(neon, &raster_runs);
