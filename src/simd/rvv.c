/* rvv.c - 8 floats: V of RISC-V. */
#include "isa/rvv.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(rvv, &raster_runs);
