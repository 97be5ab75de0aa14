/* wasm.c - 4 floats: fixed-width SIMD of WebAssembly. */
#include "wasm.h"

#include "kernel.h"
#include "simd.h"

SIMD(wasm, NULL);
