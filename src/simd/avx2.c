/* avx2.c - 8 floats: AVX2 and FMA. */
#include "isa/avx2.h"
#include "isa/stream_x86.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(avx2, &raster_runs);
