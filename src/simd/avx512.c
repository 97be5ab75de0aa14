/* avx512.c - 16 floats: AVX-512 F, BW, DQ and VL. */
#include "isa/avx512.h"
#include "isa/stream_x86.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(avx512, &raster_runs);
