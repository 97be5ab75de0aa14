/* sse41.c - 4 floats: SSE4.1. */
#include "isa/sse41.h"
#include "isa/stream_x86.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(sse41, &raster_runs);
