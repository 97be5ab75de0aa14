/* wasm.c - 4 floats: fixed-width SIMD of WebAssembly. */
#include "isa/wasm.h"
#include "simd.h"
#include "span/kernel_tmpl.h"

#include "raster_tmpl.h"

SIMD(wasm, &raster_runs);
